// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

namespace Riedel::Analysis
{
  /**
   * What the measurement of shear bands reads: the body in its deformed state
   * as triangles with nodal micro-rotations, and what the material points
   * carry. Independent of grids and points, so that every method of
   * computation can be measured alike. A list of nodes or points is as long as
   * nodes or points, or empty if the scene has no such thing.
   */
  struct DeformedField
  {
    /// deformed positions of the nodes [m]
    std::vector<std::array<double, 2>> nodes;
    /// micro-rotation of the nodes [rad]; empty: a classical continuum
    std::vector<double> rotation;
    /// triangles as node numbers; they tile the body, and neighbours share
    /// nodes
    std::vector<std::array<unsigned int, 3>> triangles;

    /// deformed positions [m] of the material points
    std::vector<std::array<double, 2>> points;
    std::vector<double>                volume; ///< present [m2]
    std::vector<double>                void_ratio;
    /// since the start
    std::vector<double> void_ratio_change;
    /// logarithm of present over initial volume
    std::vector<double> volume_strain;
    /// shear_strain() of the deformation gradient since the start
    std::vector<double> shear_strain;
    /// polar_rotation() of the deformation gradient since the start [rad]
    std::vector<double> spin;
    /// Continuum::mobilised_friction() [deg]
    std::vector<double> friction;
  };

  /**
   * Amount of shear of the deformation gradient 11, 12, 21, 22 in the plane:
   * sqrt(F:F/J - 2), J = det F. It is gamma in simple shear by gamma, whatever
   * volume change is added, the difference of the principal strains if these
   * are small, and zero if the plane keeps its angles.
   */
  double
  shear_strain(const std::array<double, 4> &F);

  /// Angle of R in F = R U, in the plane, counterclockwise [rad].
  double
  polar_rotation(const std::array<double, 4> &F);

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
    /// half the length along a band over which shear strain and void ratio are
    /// averaged at a cut, in d50
    double mean_length = 5.0;
    /// rotations below this [rad], and signed shear strains below twice this,
    /// are no band
    double least_rotation = 1e-3;
  };

  /// Full widths of a band [m].
  struct Thickness
  {
    double at_50; ///< where a field is at 50 % of its maximum on a cut
    double at_10; ///< at 10 %

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &at_50 &at_10;
    }
  };

  /// What is measured of a band, and of all bands as medians; what cannot be
  /// measured is NaN.
  struct BandMeasures
  {
    /// of the micro-rotation
    Thickness thickness;
    /// of the shear strain and of the change of the void ratio, both above
    /// what they are outside the bands
    Thickness shear_thickness, void_ratio_thickness;
    /// angle to the x axis, (-90, 90] [deg]
    double inclination;
    double spacing; ///< to the nearest parallel band [m]
    /// medians over the material points on the ridge
    double void_ratio, shear_strain, volume_strain;
    double friction; ///< mobilised angle in the plane [deg]

    /// All NaN.
    BandMeasures();

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &thickness &shear_thickness &void_ratio_thickness &inclination;
      archive &spacing &void_ratio &shear_strain &volume_strain &friction;
    }
  };

  struct ShearBand : public BandMeasures
  {
    double sign;                  ///< sign of the rotation
    double length;                ///< along the ridge [m]
    double rotation;              ///< median of the ridge's rotation, with sign
                                  ///< [rad]; of a classical continuum, of the
                                  ///< signed shear strain
    unsigned int          n_cuts; ///< cuts that gave a thickness
    std::array<double, 2> centre; ///< of the ridge [m]

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int version)
    {
      BandMeasures::serialize(archive, version);
      archive &sign &length &rotation &n_cuts &centre[0] & centre[1];
    }
  };

  /// Of the measures of all bands the medians; that of the inclination over its
  /// absolute values, since families of bands mirror each other.
  struct ShearBands : public BandMeasures
  {
    std::vector<ShearBand> bands; ///< longest first
    /// places at the boundary where two bands of opposite sign meet
    unsigned int n_reflections = 0;
    /// medians over the points where |rotation| < 5 % of the percentile; over
    /// all points without bands
    double void_ratio_outside, shear_strain_outside;
    double largest_rotation; ///< over the body [rad]; NaN without rotations

    ShearBands();

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int version)
    {
      BandMeasures::serialize(archive, version);
      archive &bands &n_reflections &void_ratio_outside;
      archive &shear_strain_outside &largest_rotation;
    }
  };

  /// Finds and measures the shear bands (doc/shear_bands.md).
  ShearBands
  measure_shear_bands(const DeformedField      &field,
                      const BandMeasureOptions &options);
} // namespace Riedel::Analysis
