// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/analysis/geometry.h>
#include <riedel/analysis/raster.h>

#include <vector>

namespace Riedel::Analysis
{
  struct RidgePoint
  {
    Point position;
    /// not on a ridge of the rotation, but between two collinear pieces of it
    bool bridged;
  };

  /// A line of locally largest |rotation| of one sign.
  struct Ridge
  {
    double                  sign;   ///< of the rotation, +1 or -1
    std::vector<RidgePoint> points; ///< in order, about one step apart
  };

  struct RidgeOptions
  {
    double grain_size; ///< d50 [m]
    double level;      ///< |rotation| on a ridge is at least this [rad]
    double step;       ///< distance of the points along a ridge [m]
  };

  /// Length of the line through the points, with the bridges [m].
  double
  length(const Ridge &ridge);

  /**
   * Traces pieces of ridges in the (smoothed) raster: from the strongest point
   * not yet belonging to a ridge both ways, until the rotation falls below the
   * level, the body ends or the line bends sharply. No bridges.
   */
  std::vector<Ridge>
  trace_ridges(const Raster &raster, const RidgeOptions &options);

  /**
   * Joins collinear pieces of one sign across small gaps, and across larger
   * ones where a band of the opposite sign passes through the gap.
   */
  std::vector<Ridge>
  join_collinear(std::vector<Ridge>  pieces,
                 const Raster       &raster,
                 const RidgeOptions &options);
} // namespace Riedel::Analysis
