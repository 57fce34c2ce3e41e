// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/analysis/cuts.h>
#include <riedel/analysis/geometry.h>
#include <riedel/analysis/raster.h>
#include <riedel/analysis/ridge.h>
#include <riedel/analysis/shear_bands.h>
#include <riedel/analysis/triangle_sampler.h>

#include <cstddef>
#include <vector>

namespace Riedel::Analysis
{
  /**
   * Measures ridges that are known to be bands, on points that keep their
   * clearance from boundaries and crossings. Keeps references to what it is
   * given.
   */
  class BandMeter
  {
  public:
    /**
     * @param options Spacing and clearance of cuts.
     * @param sampler What the bands have been found by.
     * @param raster Tells the distance from boundaries.
     * @param ridges All bands, since they cross each other.
     * @param maximum_reach How far beside the ridge the largest value of a
     *   cut is sought [m].
     */
    BandMeter(const BandMeasureOptions &options,
              const TriangleSampler    &sampler,
              const Raster             &raster,
              const std::vector<Ridge> &ridges,
              double                    maximum_reach);

    /// Sign, length, inclination, rotation and centre.
    ShearBand
    measure(const Ridge &ridge) const;

    /// Where the ridge is cut: from its undisturbed points, in equal distances.
    std::vector<Cut>
    cuts(const Ridge &ridge) const;

    struct Widths
    {
      Thickness    thickness; ///< medians over the cuts
      unsigned int n_cuts;    ///< cuts that gave the width at 50 %
    };

    /**
     * Widths of sign * (field - background), see cut_band(). Values are means
     * along the band over @p half_length [m] to both sides of the cut: what the
     * points carry scatters between the points of a cell, and a mean along a
     * straight band does not widen it.
     */
    Widths
    widths(const std::vector<Cut> &cuts,
           const TriangleSampler  &field,
           double                  background,
           double                  sign,
           double                  half_length) const;

    /// Straight line through the undisturbed part of the ridge.
    Line
    axis(const Ridge &ridge) const;

  private:
    /// Which points lie on the ridge, far from boundaries and crossings?
    std::vector<unsigned char>
    undisturbed(const Ridge &ridge) const;

    /// Direction of the ridge around point @p k, from undisturbed points.
    Point
    direction(const Ridge                      &ridge,
              const std::vector<unsigned char> &usable,
              std::size_t                       k) const;

    const BandMeasureOptions &options;
    const TriangleSampler    &sampler;
    const Raster             &raster;
    const double              clearance; ///< [m]
    const std::vector<Point>  crossings;
    const double              maximum_reach; ///< [m]
  };
} // namespace Riedel::Analysis
