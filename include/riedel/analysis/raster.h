// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/analysis/geometry.h>
#include <riedel/analysis/triangle_sampler.h>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace Riedel::Analysis
{
  /**
   * Rotations on a uniform raster, with a mask of the body. Raster point
   * (i, j) lies at origin + spacing (i, j) and has the index j n[0] + i. The
   * outermost points lie outside the body.
   */
  struct Raster
  {
    Point                      origin;
    double                     spacing; ///< [m]
    std::array<long, 2>        n;
    std::vector<double>        values; ///< [rad]; 0 outside the body
    std::vector<unsigned char> inside;

    /// Index of the raster point nearest to @p point, if that is in the body.
    std::optional<std::size_t>
    index_near(const Point &point) const;

    Point
    position(std::size_t index) const;

    /**
     * Bilinear interpolation. Of the four raster points around, those outside
     * the body do not count; nothing if more than half of the weight is
     * theirs.
     */
    std::optional<double>
    value(const Point &point) const;

    /// Distance of @p point from the nearest point outside the body, exact to
    /// half a spacing; @p limit if it is larger than that [m].
    double
    distance_to_outside(const Point &point, double limit) const;
  };

  Raster
  rasterise(const TriangleSampler &sampler, double spacing);

  /**
   * Convolution with a Gaussian of the standard deviation @p width [m]. The
   * weights of points outside the body are left out, so that a uniform field
   * stays uniform up to the boundary.
   */
  Raster
  smoothed(const Raster &raster, double width);

  /**
   * Typical width [m] of the zones of one sign in which |rotation| exceeds
   * @p level: at each raster point the shorter of its chords along both axes,
   * median over these zones; up to 1.4 times the width of an oblique band. 0
   * without such zones.
   */
  double
  typical_width(const Raster &raster, double level);
} // namespace Riedel::Analysis
