// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

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
     * @param sampler The rotation, from which widths are taken.
     * @param raster Tells the distance from boundaries.
     * @param ridges All bands, since they cross each other.
     * @param maximum_reach How far beside the ridge the largest rotation of a
     *   cut is sought [m].
     */
    BandMeter(const BandMeasureOptions &options,
              const TriangleSampler    &sampler,
              const Raster             &raster,
              const std::vector<Ridge> &ridges,
              double                    maximum_reach);

    /// All but spacing and void ratio.
    ShearBand
    measure(const Ridge &ridge) const;

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
