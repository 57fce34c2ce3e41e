// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>

namespace Riedel::Continuum
{
  /// Angle [deg] whose sine is the largest shear stress in the plane over the
  /// mean pressure in the plane; 90 at no pressure. @p stress: 11, 22, 33, 12,
  /// 21 [Pa], tension positive, of which the symmetric part counts.
  inline double
  mobilised_friction(const double *stress)
  {
    const double shear =
      std::hypot(.5 * (stress[0] - stress[1]), .5 * (stress[3] + stress[4]));
    const double pressure = -.5 * (stress[0] + stress[1]);
    if (!(shear < pressure))
      return 90.;
    return std::asin(shear / pressure) * 180. / 3.14159265358979323846;
  }
} // namespace Riedel::Continuum
