// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cmath>

namespace Riedel::Continuum
{
  /**
   * The rotation vector of exp(@p increment) exp(@p phi) [rad], by unit
   * quaternions: rotations in space do not add up, and their product stays a
   * rotation however often it is taken.
   *
   * The same rotation has rotation vectors that differ by whole turns about
   * their axis; the result is the one nearest to @p phi, so that a body that
   * turns about one axis shows its whole angle.
   */
  inline std::array<double, 3>
  turned_further(const std::array<double, 3> &phi,
                 const std::array<double, 3> &increment)
  {
    struct Quaternion
    {
      double                scalar;
      std::array<double, 3> vector;
    };
    const auto norm = [](const std::array<double, 3> &a) {
      return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    };
    const auto quaternion = [&](const std::array<double, 3> &a) {
      const double angle = norm(a);
      // sin(angle/2)/angle
      const double factor =
        angle > 1e-8 ? std::sin(.5 * angle) / angle : .5 - angle * angle / 48.;
      return Quaternion{std::cos(.5 * angle),
                        {{factor * a[0], factor * a[1], factor * a[2]}}};
    };
    const Quaternion p = quaternion(increment), q = quaternion(phi);

    Quaternion r;
    r.scalar = p.scalar * q.scalar;
    for (unsigned int i = 0; i < 3; ++i)
      {
        const unsigned int j = (i + 1) % 3, k = (i + 2) % 3;
        r.scalar -= p.vector[i] * q.vector[i];
        r.vector[i] = p.scalar * q.vector[i] + q.scalar * p.vector[i] +
                      p.vector[j] * q.vector[k] - p.vector[k] * q.vector[j];
      }

    double                sine   = norm(r.vector);
    std::array<double, 3> axis   = r.vector;
    const double          before = norm(phi);
    if (sine == 0. && before == 0.)
      return {{0., 0., 0.}};
    if (sine < 1e-8 && before > 1.)
      {
        // next to whole turns rounding decides on the axis: that of before
        sine = 0.;
        for (unsigned int i = 0; i < 3; ++i)
          {
            axis[i] = phi[i] / before;
            sine += axis[i] * r.vector[i];
          }
      }
    else
      for (double &component : axis)
        component /= sine;
    const double angle = 2. * std::atan2(sine, r.scalar);
    // the whole turns that bring angle * axis next to phi
    const double along = axis[0] * phi[0] + axis[1] * phi[1] + axis[2] * phi[2];
    const double turn  = 2. * 3.14159265358979323846;
    const double nearby = angle + turn * std::round((along - angle) / turn);
    return {{nearby * axis[0], nearby * axis[1], nearby * axis[2]}};
  }
} // namespace Riedel::Continuum
