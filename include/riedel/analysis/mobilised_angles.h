// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/analysis/shear_bands.h>
#include <riedel/points/material_points.h>

#include <array>
#include <limits>
#include <vector>

namespace Riedel::Analysis
{
  /// Angles that sand mobilises in the plane [deg]; NaN if not known.
  struct MobilisedAngles
  {
    double friction  = std::numeric_limits<double>::quiet_NaN(); ///< phi
    double dilatancy = std::numeric_limits<double>::quiet_NaN(); ///< psi

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &friction &dilatancy;
    }
  };

  /**
   * @name Angle of a shear band to the direction of the minor principal
   * (compressive) stress [deg], as predicted.
   */
  ///@{
  /// 45 + phi/2: planes of largest obliquity of the stress (Coulomb 1773).
  double
  coulomb_angle(const MobilisedAngles &angles);

  /// 45 + psi/2: planes of no extension (Roscoe 1970).
  double
  roscoe_angle(const MobilisedAngles &angles);

  /// 45 + (phi + psi)/4, between the two (Arthur, Dunstan, Al-Ani and Assadi
  /// 1977).
  double
  arthur_angle(const MobilisedAngles &angles);
  ///@}

  /// psi with sin psi = volume increment / shear increment, the latter the
  /// difference of the principal strain increments; NaN without shear.
  double
  dilatancy_angle(const double volume_increment, const double shear_increment);

  /// psi of a mean gradient of displacement increments 11, 12, 21, 22.
  double
  dilatancy_angle(const std::array<double, 4> &H);

  /// psi in the bands between two measurements: by the changes of the median
  /// volume and shear strains on the ridges; NaN without bands in both.
  double
  dilatancy_inside(const ShearBands &before, const ShearBands &now);

  /// Volume mean over the body of the gradients of the increments of
  /// displacement 11, 12, 21, 22. @p increments: generalised ones of the
  /// points of this rank. Collective.
  std::array<double, 4>
  mean_gradient(const Points::MaterialPoints<2> &points,
                const std::vector<double>       &increments,
                const MPI_Comm                   communicator);

  /// Volume mean over the body of the stress 11, 22, 33, 12, 21 [Pa].
  /// Collective.
  std::array<double, 5>
  mean_stress(const Points::MaterialPoints<2> &points,
              const MPI_Comm                   communicator);

  /// Median over the bands of their angle to the direction of the minor
  /// principal compressive stress, from 0 to 90 degrees.
  double
  angle_to_minor_stress(const ShearBands            &bands,
                        const std::array<double, 5> &stress);
} // namespace Riedel::Analysis
