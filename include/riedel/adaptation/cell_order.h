// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/distributed/tria.h>

#include <vector>

namespace Riedel::Adaptation
{
  /**
   * The active cells of this rank along p4est's curve. Those of rank 0, then of
   * rank 1 and so on are all cells in an order that does not depend on the
   * number of ranks.
   */
  template <int dim>
  std::vector<typename dealii::Triangulation<dim>::active_cell_iterator>
  cells_along_curve(
    const dealii::parallel::distributed::Triangulation<dim> &triangulation);
} // namespace Riedel::Adaptation
