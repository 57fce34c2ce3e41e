// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/analysis/raster.h>
#include <riedel/analysis/ridge.h>
#include <riedel/analysis/shear_bands.h>
#include <riedel/analysis/triangle_search.h>

#include <vector>

namespace Riedel::Analysis
{
  /**
   * By which bands are found, of the nodes: the micro-rotation or, in a
   * classical continuum, the shear strain in excess of its 20th percentile over
   * the points, with the sign of the rotation of the deformation gradient. It
   * counts up to four times this rotation (simple shear turns by half of its
   * angle), so that what is stretched without turning is no band. Empty if the
   * points have no shear strains.
   */
  std::vector<double>
  band_indicator(const DeformedField &field, const TriangleSearch &search);

  /// Lines that are bands, and the field in which they have been found.
  struct FoundBands
  {
    std::vector<Ridge> ridges;    ///< longest first
    Raster             smooth;    ///< of the indicator
    double             smoothing; ///< standard deviation [m]
    double             reference; ///< high percentile of the absolute indicator
  };

  /// @p indicator: of the nodes; @p least: below it there is no band.
  FoundBands
  find_bands(const DeformedField       &field,
             const TriangleSearch      &search,
             const std::vector<double> &indicator,
             const double               least,
             const BandMeasureOptions  &options);
} // namespace Riedel::Analysis
