// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/types.h>
#include <deal.II/grid/tria.h>

#include <string>

namespace Riedel::Grid
{
  /**
   * Puts the nodes that refinement will add to a boundary on the circle, or the
   * sphere, of the nodes it has. To be called before the first refinement, when
   * every rank knows all coarse cells. Throws InputError if the nodes are not
   * on a circle.
   *
   * @param name of the boundary, for messages
   */
  template <int dim>
  void
  make_round(dealii::Triangulation<dim>      &tria,
             const dealii::types::boundary_id boundary,
             const std::string               &name);
} // namespace Riedel::Grid
