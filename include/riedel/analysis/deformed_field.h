// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/analysis/shear_bands.h>
#include <riedel/grid/space.h>
#include <riedel/points/material_points.h>

namespace Riedel::Analysis
{
  /**
   * The deformed body and its material points as the measurement
   * of bands reads it. Collects all ranks' parts on rank 0; empty on the
   * others. Every cell with points becomes 2 n^2 triangles, n the degree of the
   * element. @p solution: displacements and rotations at relevant dofs, by
   * local number; of moving points Points::nodal_values(): their grid is not
   * deformed.
   */
  DeformedField
  collect_deformed_field(const Grid::Space<2>            &space,
                         const std::vector<double>       &solution,
                         const Points::MaterialPoints<2> &points);
} // namespace Riedel::Analysis
