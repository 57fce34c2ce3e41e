// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/grid/space.h>
#include <riedel/points/material_points.h>
#include <riedel/points/supports.h>

#include <deal.II/base/bounding_box.h>

#include <vector>

namespace Riedel::Points
{
  /// Smallest box around the boxes of all points of all ranks [m].
  template <int dim>
  dealii::BoundingBox<dim>
  extent(const MaterialPoints<dim> &points, const MPI_Comm communicator);

  /**
   * Displacements and micro-rotations since the start as a field on the grid:
   * relevant dofs by local number, zero at nodes that no point sees. Means of
   * the points, weighted with volume and shape function, and then the means
   * of what these miss at the points, @p n_corrections times (as Hammerquist
   * and Nairn 2017 do for velocities). The means alone would show a band of
   * three cells a tenth too thick; many corrections end at the projection,
   * which overshoots at a ridge and shows it too thin. With one, bands of three
   * cells and more are measured to 2 %.
   */
  template <int dim>
  std::vector<double>
  nodal_values(const Grid::Space<dim>    &space,
               const MaterialPoints<dim> &points,
               const Supports<dim>       &supports,
               const unsigned int         n_corrections = 1);
} // namespace Riedel::Points
