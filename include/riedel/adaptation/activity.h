// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/adaptation/fixed_regions.h>
#include <riedel/adaptation/parameters.h>
#include <riedel/grid/space.h>
#include <riedel/points/material_points.h>
#include <riedel/points/supports.h>

#include <vector>

namespace Riedel::Adaptation
{
  /**
   * How active every cell is: the largest of what the criteria measure over
   * their thresholds, by active cell index; a criterion holds from 1 on. Zero
   * in cells of other ranks.
   *
   * The measures read the points and the nodal increments of the last step
   * only, so they serve every reference configuration (doc/adaptation.md). A
   * cell has the largest value of its points. @p increment: relevant dofs by
   * local number. Collective.
   */
  template <int dim>
  std::vector<double>
  activity(const Parameters<dim>             &parameters,
           const FixedRegions<dim>           &regions,
           const Grid::Space<dim>            &space,
           const Points::MaterialPoints<dim> &points,
           const Points::Supports<dim>       &supports,
           const std::vector<double>         &increment);

  /// sqrt(2 e:e) with the deviator e of the strain that a displacement gradient
  /// H has, in plane strain: the shear angle in simple shear.
  template <int dim>
  double
  shear_of(const double *H);
} // namespace Riedel::Adaptation
