// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/adaptation/parameters.h>
#include <riedel/points/parameters.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/grid/tria.h>

#include <vector>

namespace Riedel::Adaptation
{
  /**
   * The parts of the undeformed body that are refined before the first step and
   * stay so: regions, and what the initial state makes heterogeneous. A fine
   * band that grows from a coarse imperfection keeps the coarse one's history.
   */
  template <int dim>
  class FixedRegions
  {
  public:
    FixedRegions(const Parameters<dim>                     &parameters,
                 const Points::InitialStateParameters<dim> &initial);

    /// Has the cell a part of a region in its inside?
    bool
    meet(const typename dealii::Triangulation<dim>::cell_iterator &cell) const;

  private:
    bool                                  everywhere;
    std::vector<dealii::BoundingBox<dim>> boxes;
  };
} // namespace Riedel::Adaptation
