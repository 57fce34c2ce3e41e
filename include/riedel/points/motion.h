// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/grid/space.h>
#include <riedel/points/material_points.h>
#include <riedel/points/supports.h>

#include <vector>

namespace Riedel::Points
{
  /**
   * How far points can move on the grid in a step, in smallest cells of the
   * grid: the largest move of a node that they see, along one axis. Points are
   * means of these. @p du: increments at the relevant dofs, @p next: where the
   * grid will be put back to, @p unseen_dofs: as in Supports. Collective.
   */
  template <int dim>
  double
  largest_move(const Grid::Space<dim>          &space,
               const Grid::Frame<dim>          &next,
               const std::vector<double>       &du,
               const std::vector<unsigned int> &unseen_dofs);

  /// Points that a step would bring into cells that their rank does not know:
  /// neither its own nor neighbours of these; on all ranks. Arguments as above.
  template <int dim>
  std::uint64_t
  n_out_of_reach(const Grid::Space<dim>    &space,
                 const Grid::Frame<dim>    &next,
                 const std::vector<double> &du,
                 const MaterialPoints<dim> &points,
                 const Supports<dim>       &supports);
} // namespace Riedel::Points
