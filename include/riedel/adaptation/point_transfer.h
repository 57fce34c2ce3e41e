// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/distributed/tria.h>

namespace Riedel::Adaptation
{
  /**
   * What happens to the material points when the grid changes, in one
   * reference configuration.
   */
  template <int dim>
  class PointTransfer
  {
  public:
    virtual ~PointTransfer() = default;

    /// Before the grid changes; the flags are set.
    virtual void
    prepare() = 0;

    /// How much work a cell will be: points it will have. As the argument of
    /// deal.II's weight signal: @p status is that of the change.
    virtual unsigned int
    weight(
      const typename dealii::Triangulation<dim>::cell_iterator &cell,
      const typename dealii::Triangulation<dim>::CellStatus status) const = 0;

    /// On the new grid.
    virtual void
    finish() = 0;
  };
} // namespace Riedel::Adaptation
