// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/adaptation/activity.h>
#include <riedel/points/strain_operator.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/error_estimator.h>

#include <cmath>
#include <limits>

namespace Riedel::Adaptation
{
  namespace
  {
    /// A cell has the largest value of its points.
    void
    raise(double &activity, const double value, const double threshold)
    {
      activity = std::max(activity, value / threshold);
    }



    /// Shear and rotation of every point over the last step.
    struct PointRates
    {
      std::vector<double> shear, rotation;
      double              nominal = 0.0; ///< mean shear of the body
    };



    template <int dim>
    PointRates
    rates(const Grid::Space<dim>            &space,
          const Points::MaterialPoints<dim> &points,
          const Points::Supports<dim>       &supports,
          const std::vector<double>         &increment)
    {
      using Order = Continuum::Generalised<dim>;
      PointRates result;
      result.shear.resize(points.n_points());
      result.rotation.resize(points.n_points());
      std::vector<double> values, sums(2, 0.0), all(2);
      for (const auto &patch : supports.patches)
        {
          values.resize(patch.n_dofs);
          for (unsigned int i = 0; i < patch.n_dofs; ++i)
            values[i] = increment[supports.dofs[patch.first_dof + i]];
          for (unsigned int q = 0; q < patch.n_points; ++q)
            {
              const unsigned int p = patch.first_point + q;
              double             strains[Order::n_micropolar] = {};
              Points::StrainOperator<dim>(supports, patch, q)
                .increments(values.data(), strains);
              result.shear[p] = shear_of<dim>(strains);
              if (patch.n_rotation_nodes > 0)
                {
                  double square = 0.0;
                  for (unsigned int k = 0; k < Order::n_spin; ++k)
                    square += std::pow(strains[Order::spin(k)], 2);
                  // twice: simple shear turns by half of its angle
                  result.rotation[p] = 2.0 * std::sqrt(square);
                }
              sums[0] += supports.volume[p] * result.shear[p];
              sums[1] += supports.volume[p];
            }
        }
      dealii::Utilities::MPI::sum(sums, space.communicator(), all);
      result.nominal = all[0] / all[1];
      return result;
    }



    /// Kelly's indicator of the rotation over the last step, by active cell
    /// index [rad].
    template <int dim>
    dealii::Vector<float>
    rotation_jumps(const Grid::Space<dim>    &space,
                   const std::vector<double> &increment)
    {
      LinearAlgebra::Vector owned = space.owned_vector();
      for (const auto dof : space.owned())
        owned(dof) = increment[space.local(dof)];
      owned.compress(dealii::VectorOperation::insert);
      LinearAlgebra::Vector ghosted(space.owned(),
                                    space.relevant(),
                                    space.communicator());
      ghosted = owned;

      dealii::ComponentMask rotations(space.n_components(), true);
      for (unsigned int d = 0; d < dim; ++d)
        rotations.set(d, false);
      const auto &triangulation = space.dof_handler().get_triangulation();
      dealii::Vector<float> result(triangulation.n_active_cells());
      dealii::KellyErrorEstimator<dim>::estimate(
        dealii::MappingQ1<dim>(),
        space.dof_handler(),
        dealii::QGauss<dim - 1>(space.element().degree + 1),
        {},
        ghosted,
        result,
        rotations,
        nullptr,
        1,
        triangulation.locally_owned_subdomain());
      return result;
    }
  } // namespace



  template <int dim>
  double
  shear_of(const double *H)
  {
    using Order  = Continuum::Generalised<dim>;
    double trace = 0.0, square = 0.0;
    for (unsigned int i = 0; i < dim; ++i)
      {
        trace += H[Order::gradient(i, i)];
        for (unsigned int j = 0; j < dim; ++j)
          square += std::pow(0.5 * (H[Order::gradient(i, j)] +
                                    H[Order::gradient(j, i)]),
                             2);
      }
    return std::sqrt(2.0 * std::max(square - trace * trace / 3.0, 0.0));
  }



  template <int dim>
  std::vector<double>
  activity(const Parameters<dim>             &parameters,
           const FixedRegions<dim>           &regions,
           const Grid::Space<dim>            &space,
           const Points::MaterialPoints<dim> &points,
           const Points::Supports<dim>       &supports,
           const std::vector<double>         &increment)
  {
    const auto         &triangulation = space.dof_handler().get_triangulation();
    const auto         &thresholds    = parameters.thresholds;
    std::vector<double> result(triangulation.n_active_cells(), 0.0);

    const auto   rate    = rates(space, points, supports, increment);
    const double nominal = rate.nominal;
    const bool   moves   = nominal > std::numeric_limits<double>::min();
    for (unsigned int p = 0; moves && p < points.n_points(); ++p)
      {
        double &here = result[points.cell(p)];
        if (parameters.has(Criterion::rotation_rate))
          raise(here, rate.rotation[p] / nominal, thresholds.rotation_rate);
        if (parameters.has(Criterion::shear_rate))
          raise(here, rate.shear[p] / nominal, thresholds.shear_rate);
      }
    if (moves && parameters.has(Criterion::gradient_jump))
      {
        const auto jumps = rotation_jumps(space, increment);
        for (unsigned int c = 0; c < result.size(); ++c)
          raise(result[c], 2.0 * jumps[c] / nominal, thresholds.gradient_jump);
      }

    const unsigned int void_ratio = points.layout().find("void_ratio");
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          double &here = result[cell->active_cell_index()];
          if (regions.meet(cell))
            here = std::numeric_limits<double>::infinity();

          // The grains keep their volume: e - e_0 = (1 + e)(1 - V_0/V).
          double       V = 0.0, V_0 = 0.0, void_space = 0.0;
          unsigned int n_points = 0;
          for (const auto &particle :
               points.particles().particles_in_cell(cell))
            {
              const auto row = particle.get_properties();
              V += row[points.place.volume];
              V_0 += row[points.place.initial_volume];
              if (void_ratio != Material::StateLayout::absent)
                void_space += row[points.place.volume] * row[void_ratio];
              ++n_points;
            }
          if (parameters.has(Criterion::void_ratio_change) && V > 0.0)
            raise(here,
                  std::abs((1.0 + void_space / V) * (1.0 - V_0 / V)),
                  thresholds.void_ratio_change);
          // a criterion holds from 1 on: with one point more than the most
          if (parameters.has(Criterion::points_per_cell))
            raise(here, n_points, thresholds.points_per_cell + 1.0);
        }
    return result;
  }



  template std::vector<double>
  activity(const Parameters<2> &,
           const FixedRegions<2> &,
           const Grid::Space<2> &,
           const Points::MaterialPoints<2> &,
           const Points::Supports<2> &,
           const std::vector<double> &);
  template double
  shear_of<2>(const double *);
  template std::vector<double>
  activity(const Parameters<3> &,
           const FixedRegions<3> &,
           const Grid::Space<3> &,
           const Points::MaterialPoints<3> &,
           const Points::Supports<3> &,
           const std::vector<double> &);
  template double
  shear_of<3>(const double *);
} // namespace Riedel::Adaptation
