// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/adaptation/point_transfer.h>
#include <riedel/points/material_points.h>

namespace Riedel::Adaptation
{
  /**
   * Points in configuration "current": they stay where they are and belong to
   * the new cell around them. Where the cells have become smaller than their
   * boxes, the supports halve these (Points::CurrentSupports).
   */
  template <int dim>
  class MovingPointTransfer : public PointTransfer<dim>
  {
  public:
    explicit MovingPointTransfer(Points::MaterialPoints<dim> &points);

    void
    prepare() override;

    unsigned int
    weight(const typename dealii::Triangulation<dim>::cell_iterator &cell,
           const typename dealii::Triangulation<dim>::CellStatus     status)
      const override;

    void
    finish() override;

  private:
    Points::MaterialPoints<dim> *points;
  };
} // namespace Riedel::Adaptation
