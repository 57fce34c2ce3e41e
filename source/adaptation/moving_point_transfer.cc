// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/adaptation/moving_point_transfer.h>

namespace Riedel::Adaptation
{
  template <int dim>
  MovingPointTransfer<dim>::MovingPointTransfer(
    Points::MaterialPoints<dim> &points)
    : points(&points)
  {}



  template <int dim>
  void
  MovingPointTransfer<dim>::prepare()
  {
    points->prepare_for_new_grid();
  }



  template <int dim>
  unsigned int
  MovingPointTransfer<dim>::weight(
    const typename dealii::Triangulation<dim>::cell_iterator &cell,
    const typename dealii::Triangulation<dim>::CellStatus     status) const
  {
    // the points of a cell that is divided are counted for its first child
    unsigned int n = 0;
    if (status == dealii::Triangulation<dim>::CELL_COARSEN)
      for (const auto &child : cell->child_iterators())
        n += points->particles().n_particles_in_cell(child);
    else
      n = points->particles().n_particles_in_cell(cell);
    return n;
  }



  template <int dim>
  void
  MovingPointTransfer<dim>::finish()
  {
    points->arrive_on_new_grid();
  }



  template class MovingPointTransfer<2>;
  template class MovingPointTransfer<3>;
} // namespace Riedel::Adaptation
