// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/adaptation/point_transfer.h>
#include <riedel/grid/space.h>
#include <riedel/linear_algebra.h>

#include <deal.II/distributed/tria.h>

#include <vector>

namespace Riedel::Adaptation
{
  /**
   * Refines and coarsens the flagged cells, balances the ranks by points,
   * renumbers the dofs and takes the points and the nodal @p vectors (owned
   * dofs) to the new grid: by interpolation, exact where the grid becomes
   * finer, and continuous at hanging nodes.
   */
  template <int dim>
  void
  change_grid(dealii::parallel::distributed::Triangulation<dim> &triangulation,
              Grid::Space<dim>                                  &space,
              PointTransfer<dim>                                &points,
              const std::vector<LinearAlgebra::Vector *>        &vectors);
} // namespace Riedel::Adaptation
