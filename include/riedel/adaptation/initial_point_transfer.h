// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/adaptation/point_transfer.h>
#include <riedel/points/material_points.h>

#include <deal.II/base/quadrature.h>

#include <vector>

namespace Riedel::Adaptation
{
  /**
   * Points in configuration "initial": every quadrature point of a new cell
   * gets a copy of the nearest old point of the cell that it comes from (its
   * parent, or its former children). The history is copied, never averaged.
   * Volumes V_0 are those of the quadrature, exact; masses follow the copied
   * density, scaled so that the mass of the old cell is kept
   * (doc/adaptation.md). Ids are new: consecutive in the order of the cells
   * along p4est's curve, whatever the number of ranks.
   */
  template <int dim>
  class InitialPointTransfer : public PointTransfer<dim>
  {
  public:
    InitialPointTransfer(
      dealii::parallel::distributed::Triangulation<dim> &triangulation,
      Points::MaterialPoints<dim>                       &points,
      const dealii::Quadrature<dim>                     &quadrature);

    void
    prepare() override;

    unsigned int
    weight(const typename dealii::Triangulation<dim>::cell_iterator &cell,
           const typename dealii::Triangulation<dim>::CellStatus     status)
      const override;

    void
    finish() override;

  private:
    using Cell = typename dealii::Triangulation<dim>::cell_iterator;

    dealii::parallel::distributed::Triangulation<dim> *triangulation;
    Points::MaterialPoints<dim>                       *points;
    const dealii::Quadrature<dim>                      quadrature;

    /// the points of every active cell of this rank: X, then the row
    std::vector<std::vector<double>> old_points;
    unsigned int                     handle = 0;
  };
} // namespace Riedel::Adaptation
