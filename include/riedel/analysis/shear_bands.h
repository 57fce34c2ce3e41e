// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

namespace Riedel::Analysis
{
  /**
   * What the measurement of shear bands reads: the body in its deformed state
   * as triangles with nodal micro-rotations, and samples of the void ratio.
   * Independent of grids and points, so that every method of computation can
   * be measured alike.
   */
  struct DeformedField
  {
    /// deformed positions of the nodes [m]
    std::vector<std::array<double, 2>> nodes;
    /// micro-rotation of the nodes [rad]
    std::vector<double> rotation;
    /// triangles as node numbers; they tile the body
    std::vector<std::array<unsigned int, 3>> triangles;
    /// deformed positions [m] of material points ...
    std::vector<std::array<double, 2>> points;
    /// ... and their void ratios; empty if the scene has none
    std::vector<double> void_ratio;
  };

  struct BandMeasureOptions
  {
    double grain_size = 0.0; ///< d50 [m]
    /// a ridge counts where |rotation| exceeds this share of ...
    double threshold = 0.35;
    /// ... this percentile of |rotation| over the body
    double percentile = 99.0;
    /// shortest band: max(this [m], 20 d50)
    double shortest = 0.010;
    /// distance of cuts along a band and of cuts from boundaries and
    /// crossings, in d50
    double cut_spacing   = 2.0;
    double cut_clearance = 10.0;
    /// rotations below this [rad] are no band
    double least_rotation = 1e-3;
  };

  struct ShearBand
  {
    double sign;   ///< sign of the rotation
    double length; ///< along the ridge [m]
    double
      thickness_50; ///< full width at 50 % of the local maximum [m], median
    double       thickness_10; ///< full width at 10 % [m], median
    double       inclination;  ///< angle to the x axis, (-90, 90] [deg]
    double       spacing;  ///< to the nearest parallel band, NaN if none [m]
    double       rotation; ///< median of the ridge's rotation, with sign [rad]
    double       void_ratio;      ///< median on the ridge; NaN if not given
    unsigned int n_cuts;          ///< cuts that gave a thickness
    std::array<double, 2> centre; ///< of the ridge [m]

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &sign &length &thickness_50 &thickness_10 &inclination;
      archive &spacing &rotation &void_ratio &n_cuts    &centre[0] & centre[1];
    }
  };

  struct ShearBands
  {
    std::vector<ShearBand> bands; ///< longest first
    /// medians over the bands (lengths in m, NaN without bands); that of the
    /// inclination over its absolute values, since families of bands mirror
    /// each other [deg]
    double thickness_50, thickness_10, inclination, spacing;
    double void_ratio_inside; ///< median over the ridges; NaN without
    /// median where |w| < 5 % of the percentile; over all points without bands
    double void_ratio_outside;
    double largest_rotation; ///< over the body [rad]

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &bands &thickness_50 &thickness_10 &inclination &spacing;
      archive &void_ratio_inside &void_ratio_outside          &largest_rotation;
    }
  };

  /// Finds and measures the shear bands (doc/shear_bands.md).
  ShearBands
  measure_shear_bands(const DeformedField      &field,
                      const BandMeasureOptions &options);
} // namespace Riedel::Analysis
