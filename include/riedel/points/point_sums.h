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

  /// Displacements and micro-rotations since the start as nodes see them: means
  /// of the points, weighted with volume and shape function; relevant dofs by
  /// local number, zero at nodes that no point sees.
  template <int dim>
  std::vector<double>
  nodal_means(const Grid::Space<dim>    &space,
              const MaterialPoints<dim> &points,
              const Supports<dim>       &supports);
} // namespace Riedel::Points
