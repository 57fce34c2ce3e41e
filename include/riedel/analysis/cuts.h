// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/analysis/geometry.h>
#include <riedel/analysis/shear_bands.h>
#include <riedel/analysis/triangle_sampler.h>

#include <functional>
#include <optional>

namespace Riedel::Analysis
{
  /// A straight line across a band.
  struct Cut
  {
    Point centre; ///< on the ridge [m]
    Point normal; ///< unit vector across the band
  };

  /// Mean of a field over a piece of a straight line, in samples of distance @p
  /// step [m] up to @p half_length [m] to both sides of a place; nothing if one
  /// of them lies outside the body.
  std::optional<double>
  mean_along(const TriangleSampler &sampler,
             const Point           &place,
             const Point           &direction,
             double                 half_length,
             double                 step);

  /**
   * Full widths of a band where a profile across it is at 50 and 10 % of its
   * local maximum; NaN where it leaves the body or enters another band before
   * it reaches the level. @p profile: of the distance from the ridge [m], a
   * maximum in the band and zero beside it; nothing outside the body. The
   * maximum is sought within @p reach [m] of the ridge, and uphill from there;
   * @p step [m] is the distance of the samples.
   */
  Thickness
  cut_band(const std::function<std::optional<double>(double)> &profile,
           double                                              reach,
           double                                              step);
} // namespace Riedel::Analysis
