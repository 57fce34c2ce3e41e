// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/adaptation/activity.h>
#include <riedel/adaptation/adaptivity.h>
#include <riedel/adaptation/grain_size.h>

#include <limits>

namespace Riedel::Adaptation
{
  template <int dim>
  Adaptivity<dim>::Adaptivity(
    const Parameters<dim>                                   &parameters,
    const Material::Parameters<dim>                         &materials,
    const Points::InitialStateParameters<dim>               &initial,
    const dealii::parallel::distributed::Triangulation<dim> &triangulation)
    : parameters(parameters)
    , regions(parameters, initial)
  {
    limits.coarsest_level = triangulation.n_global_levels() - 1;
    limits.finest_level   = limits.coarsest_level + parameters.levels;
    limits.cell_size = parameters.cell_size * smallest_grain_size(materials);
    limits.buffer_layers = parameters.buffer_layers;
    limits.coarsen_below = parameters.coarsen_below;
  }



  template <int dim>
  bool
  Adaptivity<dim>::refine_initially(
    dealii::parallel::distributed::Triangulation<dim> &triangulation) const
  {
    bool changed = false;
    for (unsigned int round = 0; is_on() && round < n_rounds(); ++round)
      {
        std::vector<double> activity(triangulation.n_active_cells(), 0.0);
        for (const auto &cell : triangulation.active_cell_iterators())
          if (cell->is_locally_owned() && regions.meet(cell))
            activity[cell->active_cell_index()] =
              std::numeric_limits<double>::infinity();
        if (!Adaptation::mark(triangulation, activity, limits))
          break;
        triangulation.execute_coarsening_and_refinement();
        changed = true;
      }
    return changed;
  }



  template <int dim>
  bool
  Adaptivity<dim>::mark(
    const bool                                         may_coarsen,
    dealii::parallel::distributed::Triangulation<dim> &triangulation,
    const Grid::Space<dim>                            &space,
    const Points::MaterialPoints<dim>                 &points,
    const Points::Supports<dim>                       &supports,
    const std::vector<double>                         &increment) const
  {
    Limits now = limits;
    if (!may_coarsen)
      now.coarsen_below = 0.0;
    return Adaptation::mark(
      triangulation,
      activity(parameters, regions, space, points, supports, increment),
      now);
  }



  template class Adaptivity<2>;
  template class Adaptivity<3>;
} // namespace Riedel::Adaptation
