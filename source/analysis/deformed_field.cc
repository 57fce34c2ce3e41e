// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/analysis/deformed_field.h>
#include <riedel/continuum/mobilised_friction.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q1.h>

#include <cmath>
#include <limits>
#include <optional>
#include <unordered_map>

namespace Riedel::Analysis
{
  namespace
  {
    using DofIndex = dealii::types::global_dof_index;



    /// Of a place that no neighbour has.
    constexpr DofIndex no_dof = dealii::numbers::invalid_dof_index;



    /// The deformed position of a place in a cell, and its micro-rotation.
    /// Neighbours have the same dof there.
    struct Node
    {
      DofIndex dof;
      double   x, y, rotation;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &dof &x &y &rotation;
      }
    };



    /// What a material point gives to the field.
    struct Sample
    {
      double x, y, volume, void_ratio, void_ratio_change, volume_strain,
        shear_strain, spin, friction;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &x &y &volume &void_ratio &void_ratio_change &volume_strain;
        archive &shear_strain &spin                          &friction;
      }
    };



    /// Deformation gradients of the grid's displacements at the points of a
    /// rank: between the Gauss points of as many per axis as the element's
    /// degree, where the gradients are most exact, they are interpolated.
    std::vector<std::array<double, 4>>
    gradients_of_grid(const Grid::Space<2>            &space,
                      const std::vector<double>       &solution,
                      const Points::MaterialPoints<2> &points)
    {
      std::vector<std::vector<unsigned int>> points_in_cell(
        space.dof_handler().get_triangulation().n_active_cells());
      for (unsigned int p = 0; p < points.n_points(); ++p)
        points_in_cell[points.cell(p)].push_back(p);

      const auto                &fe = space.element();
      const dealii::MappingQ1<2> mapping;
      const dealii::QGauss<1>    gauss(fe.degree);
      const dealii::QGauss<2>    places(fe.degree);
      dealii::FEValues<2> shapes(mapping, fe, places, dealii::update_gradients);
      std::vector<dealii::Point<1>> abscissas = gauss.get_points();
      const auto                    lagrange =
        dealii::Polynomials::generate_complete_Lagrange_basis(abscissas);
      std::vector<DofIndex>              dofs(fe.n_dofs_per_cell());
      std::vector<std::array<double, 4>> result(points.n_points());
      for (const auto &cell : space.dof_handler().active_cell_iterators())
        {
          if (points_in_cell[cell->active_cell_index()].empty())
            continue;
          shapes.reinit(cell);
          cell->get_dof_indices(dofs);
          std::vector<std::array<double, 4>> at_place(places.size(),
                                                      {{1., 0., 0., 1.}});
          for (unsigned int k = 0; k < dofs.size(); ++k)
            {
              const auto c = fe.system_to_component_index(k).first;
              if (c < 2)
                for (unsigned int q = 0; q < places.size(); ++q)
                  for (unsigned int d = 0; d < 2; ++d)
                    at_place[q][2 * c + d] += solution[space.local(dofs[k])] *
                                              shapes.shape_grad(k, q)[d];
            }
          for (const unsigned int p : points_in_cell[cell->active_cell_index()])
            {
              const auto unit =
                mapping.transform_real_to_unit_cell(cell,
                                                    points.initial_position(p));
              result[p] = {};
              for (unsigned int q = 0; q < places.size(); ++q)
                {
                  const double weight = lagrange[q % fe.degree].value(unit[0]) *
                                        lagrange[q / fe.degree].value(unit[1]);
                  for (unsigned int i = 0; i < 4; ++i)
                    result[p][i] += weight * at_place[q][i];
                }
            }
        }
      return result;
    }



    std::vector<Sample>
    samples_of_rank(const Grid::Space<2>            &space,
                    const std::vector<double>       &solution,
                    const Points::MaterialPoints<2> &points)
    {
      constexpr double nan    = std::numeric_limits<double>::quiet_NaN();
      const auto       absent = Material::StateLayout::absent;
      const auto      &place  = points.place;
      const auto       stress = points.layout().find("stress");

      std::vector<std::array<double, 4>> F;
      if (!points.are_moving())
        F = gradients_of_grid(space, solution, points);

      std::vector<Sample> result;
      for (unsigned int p = 0; p < points.n_points(); ++p)
        {
          const double *row = points.row(p);
          if (points.are_moving() && place.deformation_gradient != absent)
            {
              const double *entries = row + place.deformation_gradient;
              F.push_back({{entries[0], entries[1], entries[2], entries[3]}});
            }

          Sample sample;
          sample.x             = points.position(p)[0];
          sample.y             = points.position(p)[1];
          sample.volume        = row[place.volume];
          const double J       = row[place.volume] / row[place.initial_volume];
          sample.volume_strain = std::log(J);
          sample.void_ratio    = nan;
          sample.void_ratio_change = nan;
          if (place.void_ratio != absent)
            {
              // the volume of the grains, V/(1 + e), stays
              sample.void_ratio = row[place.void_ratio];
              sample.void_ratio_change =
                (1. + sample.void_ratio) * (1. - 1. / J);
            }
          sample.shear_strain = F.empty() ? nan : shear_strain(F[p]);
          sample.spin         = F.empty() ? nan : polar_rotation(F[p]);
          sample.friction     = stress == absent ?
                                  nan :
                                  Continuum::mobilised_friction(row + stress);
          result.push_back(sample);
        }
      return result;
    }



    /// A list of the samples of all ranks; empty if the scene has no such
    /// thing.
    std::vector<double>
    list(const std::vector<std::vector<Sample>> &parts, double Sample::*member)
    {
      std::vector<double> result;
      for (const auto &part : parts)
        for (const Sample &sample : part)
          {
            if (std::isnan(sample.*member))
              return {};
            result.push_back(sample.*member);
          }
      return result;
    }
  } // namespace



  DeformedField
  collect_deformed_field(const Grid::Space<2>            &space,
                         const std::vector<double>       &solution,
                         const Points::MaterialPoints<2> &points)
  {
    const auto           &fe = space.element();
    const unsigned int    n  = fe.degree;
    const dealii::FE_Q<2> geometry(1);

    // Shape functions at the nodes of the triangles, the same in every cell:
    // the nodes of the element, and of finite elements the middles of the
    // squares between them.
    struct Place
    {
      std::vector<double> vertices, shapes;
      /// of a component with nodes there
      std::optional<unsigned int> dof;
    };
    std::vector<Place> places;
    const auto         add_place = [&](const dealii::Point<2> &at) {
      places.emplace_back();
      for (const unsigned int v : dealii::GeometryInfo<2>::vertex_indices())
        places.back().vertices.push_back(geometry.shape_value(v, at));
      for (unsigned int k = 0; k < fe.n_dofs_per_cell(); ++k)
        {
          places.back().shapes.push_back(fe.shape_value(k, at));
          if (fe.unit_support_point(k).distance(at) < 1e-6)
            places.back().dof = k;
        }
    };
    for (unsigned int j = 0; j <= n; ++j)
      for (unsigned int i = 0; i <= n; ++i)
        add_place({double(i) / n, double(j) / n});
    // values of moving points are means already: in the middle of a square the
    // mean of four of them would widen bands
    const bool has_middles = !points.are_moving();
    if (has_middles)
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < n; ++i)
          add_place({(i + 0.5) / n, (j + 0.5) / n});

    std::vector<DofIndex> dofs(fe.n_dofs_per_cell());
    std::vector<Node>     nodes;
    for (const auto &cell : space.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned() &&
          points.particles().n_particles_in_cell(cell) > 0)
        {
          cell->get_dof_indices(dofs);
          for (const Place &place : places)
            {
              double value[3] = {0.0, 0.0, 0.0};
              for (const unsigned int v : cell->vertex_indices())
                {
                  const auto x = space.frame().to_space(cell->vertex(v));
                  for (unsigned int d = 0; d < 2; ++d)
                    value[d] += place.vertices[v] * x[d];
                }
              for (unsigned int k = 0; k < dofs.size(); ++k)
                {
                  const auto c = fe.system_to_component_index(k).first;
                  if (c == 2 || !points.are_moving())
                    value[c] +=
                      place.shapes[k] * solution[space.local(dofs[k])];
                }
              nodes.push_back({place.dof ? dofs[*place.dof] : no_dof,
                               value[0],
                               value[1],
                               value[2]});
            }
        }

    const MPI_Comm communicator = space.communicator();
    const auto     all_nodes =
      dealii::Utilities::MPI::gather(communicator, nodes, 0);
    const auto all_samples =
      dealii::Utilities::MPI::gather(communicator,
                                     samples_of_rank(space, solution, points),
                                     0);

    DeformedField                              field;
    std::unordered_map<DofIndex, unsigned int> number_of_dof;
    std::vector<unsigned int>                  numbers;
    for (const auto &part : all_nodes)
      for (const Node &node : part)
        {
          unsigned int number = field.nodes.size();
          if (node.dof != no_dof)
            number = number_of_dof.emplace(node.dof, number).first->second;
          numbers.push_back(number);
          if (number < field.nodes.size())
            continue;
          field.nodes.push_back({{node.x, node.y}});
          if (space.is_micropolar())
            field.rotation.push_back(node.rotation);
        }
    const unsigned int n_corners = (n + 1) * (n + 1);
    for (std::size_t first = 0; first < numbers.size(); first += places.size())
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < n; ++i)
          {
            const std::size_t  corner = first + j * (n + 1) + i;
            const unsigned int a = numbers[corner], b = numbers[corner + 1],
                               c = numbers[corner + n + 2],
                               d = numbers[corner + n + 1];
            if (has_middles)
              {
                // four triangles: no diagonal is preferred
                const unsigned int middle =
                  numbers[first + n_corners + j * n + i];
                field.triangles.push_back({{a, b, middle}});
                field.triangles.push_back({{b, c, middle}});
                field.triangles.push_back({{c, d, middle}});
                field.triangles.push_back({{d, a, middle}});
              }
            else
              {
                field.triangles.push_back({{a, b, c}});
                field.triangles.push_back({{a, c, d}});
              }
          }
    for (const auto &part : all_samples)
      for (const Sample &sample : part)
        field.points.push_back({{sample.x, sample.y}});
    field.volume            = list(all_samples, &Sample::volume);
    field.void_ratio        = list(all_samples, &Sample::void_ratio);
    field.void_ratio_change = list(all_samples, &Sample::void_ratio_change);
    field.volume_strain     = list(all_samples, &Sample::volume_strain);
    field.shear_strain      = list(all_samples, &Sample::shear_strain);
    field.spin              = list(all_samples, &Sample::spin);
    field.friction          = list(all_samples, &Sample::friction);
    return field;
  }
} // namespace Riedel::Analysis
