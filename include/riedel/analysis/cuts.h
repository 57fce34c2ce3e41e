// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/analysis/geometry.h>
#include <riedel/analysis/triangle_sampler.h>

namespace Riedel::Analysis
{
  /// Full widths of a band on one straight cut [m]; NaN where the cut leaves
  /// the body or enters another band before it reaches the level.
  struct CutWidths
  {
    double at_50; ///< where the rotation is 50 % of the local maximum
    double at_10; ///< where it is 10 %
  };

  /**
   * Cuts a band at @p centre along the unit vector @p normal. The local
   * maximum of sign * rotation is sought within @p reach [m] of the centre,
   * and uphill from there; @p step [m] is the distance of the samples.
   */
  CutWidths
  cut_band(const TriangleSampler &sampler,
           const Point           &centre,
           const Point           &normal,
           double                 sign,
           double                 reach,
           double                 step);
} // namespace Riedel::Analysis
