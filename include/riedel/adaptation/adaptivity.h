// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/adaptation/fixed_regions.h>
#include <riedel/adaptation/marking.h>
#include <riedel/adaptation/parameters.h>
#include <riedel/grid/space.h>
#include <riedel/material/parameters.h>
#include <riedel/points/material_points.h>
#include <riedel/points/parameters.h>
#include <riedel/points/supports.h>

#include <deal.II/distributed/tria.h>

#include <vector>

namespace Riedel::Adaptation
{
  /**
   * Decides when and where the grid of a run changes. How the points and the
   * solution come to the new grid: grid_change.h.
   */
  template <int dim>
  class Adaptivity
  {
  public:
    Adaptivity(
      const Parameters<dim>                                   &parameters,
      const Material::Parameters<dim>                         &materials,
      const Points::InitialStateParameters<dim>               &initial,
      const dealii::parallel::distributed::Triangulation<dim> &triangulation);

    bool
    is_on() const
    {
      return parameters.is_on();
    }

    /// Is it time for a look at the criteria after this many steps?
    bool
    is_due(const unsigned int n_steps) const
    {
      return is_on() && n_steps > 0 && n_steps % parameters.every_steps == 0;
    }

    /// May the grid become coarser after this many steps?
    bool
    may_coarsen(const unsigned int n_steps) const
    {
      return n_steps % parameters.coarsen_every < parameters.every_steps;
    }

    /// Most changes in a row: each refines by one level.
    unsigned int
    n_rounds() const
    {
      return parameters.levels;
    }

    /// Before there are points: refines what is to be fine from the beginning.
    /// Returns whether the grid has changed. Collective.
    bool
    refine_initially(
      dealii::parallel::distributed::Triangulation<dim> &triangulation) const;

    /// Flags cells by the criteria; @p increment of the last step: relevant
    /// dofs by local number. Returns whether the grid is to be changed. It may
    /// become coarser only now and then. Collective.
    bool
    mark(const bool                                         may_coarsen,
         dealii::parallel::distributed::Triangulation<dim> &triangulation,
         const Grid::Space<dim>                            &space,
         const Points::MaterialPoints<dim>                 &points,
         const Points::Supports<dim>                       &supports,
         const std::vector<double>                         &increment) const;

  private:
    const Parameters<dim>   parameters;
    const FixedRegions<dim> regions;
    Limits                  limits;
  };
} // namespace Riedel::Adaptation
