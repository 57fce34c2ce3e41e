// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/distributed/tria.h>

#include <vector>

namespace Riedel::Adaptation
{
  /// How far the grid may be refined, and how carefully.
  struct Limits
  {
    unsigned int coarsest_level = 0; ///< of the grid without adaptation
    unsigned int finest_level   = 0;
    double       cell_size      = 0.0; ///< no cell needs to be smaller [m]
    unsigned int buffer_layers  = 1;
    double       coarsen_below  = 0.0; ///< 0: never
  };

  /**
   * Sets the triangulation's flags from how active its cells are (by active
   * cell index; 1 and more: refine). If an active cell is too large, all that
   * are nearly as active and their buffer are refined by one level; a buffer
   * alone gives no reason for a change. Cells are made coarse with a
   * refinement, or when they are many. Returns whether the grid is to be
   * changed; if not, no flag is set. Collective.
   */
  template <int dim>
  bool
  mark(dealii::parallel::distributed::Triangulation<dim> &triangulation,
       const std::vector<double>                         &activity,
       const Limits                                      &limits);

  /// Edge of a cell [m]: of a square with the same area.
  template <int dim>
  double
  cell_size(const typename dealii::Triangulation<dim>::cell_iterator &cell);
} // namespace Riedel::Adaptation
