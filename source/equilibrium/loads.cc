// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/equilibrium/loads.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>

#include <array>

namespace Riedel::Equilibrium
{
  namespace
  {
    /// Where the coordinates of a face lie: the first and, in space, the second
    /// runs along these directions of the cell.
    template <int dim>
    std::array<unsigned int, dim - 1>
    face_axes(const unsigned int face)
    {
      const unsigned int normal = face / 2;
      if constexpr (dim == 2)
        return {{1 - normal}};
      else
        return {{(normal + 1) % 3, (normal + 2) % 3}};
    }



    /// +1 if the cross product of the tangents along face_axes() points
    /// outwards, in the plane (t_2, -t_1).
    template <int dim>
    double
    outward_sign(const unsigned int face)
    {
      if (dim == 3)
        return face % 2 == 0 ? -1.0 : 1.0;
      // left: t = e_y -> (1, 0) points inwards; right: outwards;
      // bottom: t = e_x -> (0, -1) points outwards; top: inwards
      return (face == 0 || face == 3) ? -1.0 : 1.0;
    }



    template <int dim>
    dealii::Tensor<1, dim>
    normal(const std::array<dealii::Tensor<1, dim>, dim - 1> &tangent)
    {
      if constexpr (dim == 2)
        return cross_product_2d(tangent[0]);
      else
        return cross_product_3d(tangent[0], tangent[1]);
    }



    /// d normal_d / d tangent_ke as [k][d][e]
    template <int dim>
    std::array<dealii::Tensor<2, dim>, dim - 1>
    normal_derivatives(
      const std::array<dealii::Tensor<1, dim>, dim - 1> &tangent)
    {
      std::array<dealii::Tensor<2, dim>, dim - 1> result;
      if constexpr (dim == 2)
        {
          (void)tangent;
          result[0][0][1] = 1.0;
          result[0][1][0] = -1.0;
        }
      else
        for (unsigned int d = 0; d < 3; ++d)
          {
            const unsigned int e = (d + 1) % 3, m = (d + 2) % 3;
            result[0][d][e] = tangent[1][m];
            result[0][d][m] = -tangent[1][e];
            result[1][d][m] = tangent[0][e];
            result[1][d][e] = -tangent[0][m];
          }
      return result;
    }
  } // namespace



  template <int dim>
  Loads<dim>::Loads(const BoundaryConditionParameters<dim> &boundaries,
                    const LoadingParameters<dim>           &loading,
                    const Grid::Body<dim>                  &body,
                    const Grid::Space<dim>                 &space,
                    const bool                              body_fills_grid)
    : parameters(&boundaries)
    , loading(&loading)
    , body(&body)
    , space(&space)
    , surface(boundaries.boundaries.size())
  {
    const auto                                  &fe = space.element();
    const dealii::FE_Q<dim>                      geometry(1);
    const dealii::QGauss<dim - 1>                rule(fe.degree + 1);
    std::vector<dealii::types::global_dof_index> cell_dofs(
      fe.n_dofs_per_cell());

    for (unsigned int b = 0; b < boundaries.boundaries.size(); ++b)
      {
        const auto &boundary = boundaries.boundaries[b];
        bool        loaded   = boundary.pressure.given();
        for (const auto &formula : boundary.traction)
          loaded = loaded || formula.given();
        for (const auto &formula : boundary.couple_traction)
          loaded = loaded || formula.given();
        if (!loaded || !body_fills_grid)
          continue;

        const auto id = body.boundary(boundary.name);
        for (const auto &cell : space.dof_handler().active_cell_iterators())
          if (cell->is_locally_owned())
            for (const unsigned int f : cell->face_indices())
              if (cell->face(f)->at_boundary() &&
                  cell->face(f)->boundary_id() == id)
                {
                  const std::size_t first_dof = dofs.size();
                  cell->get_dof_indices(cell_dofs);
                  for (const unsigned int i : space.order_by_component())
                    dofs.push_back(space.local(cell_dofs[i]));

                  const auto   axes = face_axes<dim>(f);
                  const double sign = outward_sign<dim>(f);
                  for (unsigned int q = 0; q < rule.size(); ++q)
                    {
                      dealii::Point<dim> place;
                      place[f / 2] = f % 2;
                      for (unsigned int k = 0; k < dim - 1; ++k)
                        place[axes[k]] = rule.point(q)[k];

                      FacePoint point;
                      point.boundary  = b;
                      point.first_dof = first_dof;
                      point.weight    = rule.weight(q);
                      for (const unsigned int v : cell->vertex_indices())
                        {
                          point.position +=
                            geometry.shape_value(v, place) * cell->vertex(v);
                          for (unsigned int k = 0; k < dim - 1; ++k)
                            point.tangent[k] +=
                              geometry.shape_grad(v, place)[axes[k]] *
                              cell->vertex(v);
                        }
                      // one sign turns the cross product
                      point.tangent[0] *= sign;
                      const auto &u = fe.base_element(0);
                      for (unsigned int a = 0; a < u.n_dofs_per_cell(); ++a)
                        {
                          point.shape.push_back(u.shape_value(a, place));
                          for (unsigned int k = 0; k < dim - 1; ++k)
                            point.slope[k].push_back(
                              (k == 0 ? sign : 1.0) *
                              u.shape_grad(a, place)[axes[k]]);
                        }
                      if (space.is_micropolar())
                        {
                          const auto &w = fe.base_element(1);
                          for (unsigned int a = 0; a < w.n_dofs_per_cell(); ++a)
                            point.rotation_shape.push_back(
                              w.shape_value(a, place));
                        }
                      face_points.push_back(point);
                    }
                }
      }
  }



  template <int dim>
  void
  Loads<dim>::add_body_forces(const Points::Supports<dim>       &supports,
                              const Points::MaterialPoints<dim> &points,
                              const double                       s,
                              std::vector<double>               &forces) const
  {
    constexpr unsigned int up = dim - 1;
    // mass and volume are those per metre of the initial thickness
    const double per_thickness = std::exp(-loading->strain_33_at(s));
    for (const auto &patch : supports.patches)
      for (unsigned int q = 0; q < patch.n_points; ++q)
        {
          const unsigned int p   = patch.first_point + q;
          const double      *row = points.row(p);
          const double       V0  = row[points.place.initial_volume];
          const auto        &X   = points.initial_position(p);

          dealii::Tensor<1, dim> force;
          force[up] = -row[points.place.mass] * Points::gravity;
          for (unsigned int d = 0; d < dim; ++d)
            if (loading->body_force[d].given())
              force[d] += V0 * loading->body_force[d](X, s);
          force *= per_thickness;

          const double *weight =
            supports.weight.data() + patch.first_weight + q * patch.n_nodes;
          const unsigned int *dof = supports.dofs.data() + patch.first_dof;
          for (unsigned int d = 0; d < dim; ++d)
            for (unsigned int a = 0; a < patch.n_nodes; ++a)
              forces[dof[d * patch.n_nodes + a]] += force[d] * weight[a];

          if (patch.n_rotation_nodes > 0)
            for (unsigned int k = 0; k < n_spin; ++k)
              if (loading->body_couple[k].given())
                {
                  const double couple =
                    per_thickness * V0 * loading->body_couple[k](X, s);
                  const double *spin = supports.spin_weight.data() +
                                       patch.first_rotation_weight +
                                       q * patch.n_rotation_nodes;
                  for (unsigned int a = 0; a < patch.n_rotation_nodes; ++a)
                    forces[dof[dim * patch.n_nodes +
                               k * patch.n_rotation_nodes + a]] +=
                      couple * spin[a];
                }
        }
  }



  template <int dim>
  void
  Loads<dim>::set_extent(const dealii::BoundingBox<dim> &initial,
                         const dealii::BoundingBox<dim> &present)
  {
    has_extent     = true;
    initial_extent = initial;
    present_extent = present;
  }



  template <int dim>
  void
  Loads<dim>::add_sides_of_extent(const double s) const
  {
    for (unsigned int b = 0; b < surface.size(); ++b)
      {
        const auto &boundary = parameters->boundaries[b];
        if (!boundary.pressure.given() ||
            dealii::Utilities::MPI::this_mpi_process(space->communicator()) > 0)
          continue; // the sides are summed over the ranks
        const unsigned int id      = body->boundary(boundary.name);
        const unsigned int normal  = id / 2;
        const double       sign    = id % 2 == 0 ? -1.0 : 1.0;
        const auto         area_of = [&](const auto &extent) {
          double area = 1.0;
          for (unsigned int d = 0; d < dim; ++d)
            if (d != normal)
              area *= extent.side_length(d);
          return area;
        };
        const auto middle = [&](const auto &extent) {
          dealii::Point<dim> x = extent.center();
          x[normal]            = id % 2 == 0 ? extent.lower_bound(normal) :
                                               extent.upper_bound(normal);
          return x;
        };
        auto &side                       = surface[b];
        side.normal_area[normal]         = sign * area_of(present_extent);
        side.initial_normal_area[normal] = sign * area_of(initial_extent);
        const auto &area                 = boundary.area == LoadArea::initial ?
                                             side.initial_normal_area :
                                             side.normal_area;
        side.force  = -boundary.pressure(middle(initial_extent), s) * area;
        side.moment = Continuum::moment_of(middle(present_extent), side.force);
      }
  }



  template <int dim>
  void
  Loads<dim>::add_surface_loads(const std::vector<double> &u,
                                const double               s,
                                std::vector<double>       &forces,
                                const AddMatrix           &add_matrix) const
  {
    surface.assign(surface.size(), Surface());
    if (has_extent)
      add_sides_of_extent(s);
    std::vector<dealii::types::global_dof_index> global;
    std::vector<double>                          matrix;

    for (const FacePoint &point : face_points)
      {
        const auto         &boundary = parameters->boundaries[point.boundary];
        const unsigned int  n        = point.shape.size();
        const unsigned int  nw       = point.rotation_shape.size();
        const unsigned int *dof      = dofs.data() + point.first_dof;
        const bool          follows  = boundary.area == LoadArea::current;

        auto               present = point.tangent;
        dealii::Point<dim> place   = point.position;
        for (unsigned int d = 0; d < dim; ++d)
          for (unsigned int a = 0; a < n; ++a)
            {
              for (unsigned int k = 0; k < dim - 1; ++k)
                present[k][d] += u[dof[d * n + a]] * point.slope[k][a];
              place[d] += u[dof[d * n + a]] * point.shape[a];
            }
        const auto   tangent       = (follows ? present : point.tangent);
        const auto   normal_area   = normal<dim>(tangent);
        const auto   normal_change = normal_derivatives<dim>(tangent);
        const double area          = normal_area.norm();

        // Force and couple per d(xi), and their derivatives with respect to the
        // tangents; of a virtual stress only the force counts here.
        dealii::Tensor<1, dim>                      force, total;
        std::array<dealii::Tensor<2, dim>, dim - 1> derivative;
        Continuum::Moment<dim>                      couple;
        // of the area
        std::array<dealii::Tensor<1, dim>, dim - 1> area_change;
        for (unsigned int k = 0; k < dim - 1; ++k)
          area_change[k] = normal_area / area * normal_change[k];
        if (boundary.pressure.given())
          {
            const double p = boundary.pressure(point.position, s);
            total -= p * normal_area;
            if (boundary.form == LoadForm::surface_integral)
              {
                force -= p * normal_area;
                for (unsigned int k = 0; k < dim - 1; ++k)
                  derivative[k] -= p * normal_change[k];
              }
          }
        for (unsigned int d = 0; d < dim; ++d)
          if (boundary.traction[d].given())
            {
              const double t = boundary.traction[d](point.position, s);
              force[d] += t * area;
              total[d] += t * area;
              for (unsigned int k = 0; k < dim - 1; ++k)
                derivative[k][d] += t * area_change[k];
            }
        Continuum::Moment<dim> couple_per_area;
        if (nw > 0)
          for (unsigned int r = 0; r < n_spin; ++r)
            if (boundary.couple_traction[r].given())
              couple_per_area[r] =
                boundary.couple_traction[r](point.position, s);
        couple = area * couple_per_area;

        auto &sum = surface[point.boundary];
        sum.normal_area += point.weight * normal<dim>(present);
        sum.initial_normal_area += point.weight * normal<dim>(point.tangent);
        sum.force += point.weight * total;
        sum.moment +=
          point.weight * (Continuum::moment_of(place, total) + couple);

        for (unsigned int d = 0; d < dim; ++d)
          for (unsigned int a = 0; a < n; ++a)
            forces[dof[d * n + a]] += point.weight * force[d] * point.shape[a];
        for (unsigned int r = 0; r < (nw > 0 ? n_spin : 0); ++r)
          for (unsigned int a = 0; a < nw; ++a)
            forces[dof[dim * n + r * nw + a]] +=
              point.weight * couple[r] * point.rotation_shape[a];

        if (add_matrix && follows)
          {
            const unsigned int n_dofs = dim * n + n_spin * nw;
            global.resize(n_dofs);
            matrix.assign(n_dofs * n_dofs, 0.0);
            for (unsigned int i = 0; i < n_dofs; ++i)
              global[i] = space->relevant().nth_index_in_set(dof[i]);
            for (unsigned int k = 0; k < dim - 1; ++k)
              for (unsigned int e = 0; e < dim; ++e)
                for (unsigned int b = 0; b < n; ++b)
                  {
                    const double       slope = point.weight * point.slope[k][b];
                    const unsigned int column = e * n + b;
                    for (unsigned int d = 0; d < dim; ++d)
                      for (unsigned int a = 0; a < n; ++a)
                        matrix[(d * n + a) * n_dofs + column] -=
                          slope * point.shape[a] * derivative[k][d][e];
                    for (unsigned int r = 0; r < n_spin; ++r)
                      for (unsigned int a = 0; a < nw; ++a)
                        matrix[(dim * n + r * nw + a) * n_dofs + column] -=
                          slope * point.rotation_shape[a] * couple_per_area[r] *
                          area_change[k][e];
                  }
            add_matrix(global, matrix);
          }
      }
  }



  template class Loads<2>;
  template class Loads<3>;
} // namespace Riedel::Equilibrium
