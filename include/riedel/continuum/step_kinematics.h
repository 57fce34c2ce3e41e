// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/continuum/plane_tensor.h>

#include <array>
#include <cmath>

namespace Riedel::Continuum
{
  /// cof f = j f^-T of f = I + H; both in the order 11, 12, 21, 22
  template <typename Number>
  std::array<Number, 4>
  step_cofactor(const Number *H)
  {
    return {{1. + H[3], -H[2], -H[1], 1. + H[0]}};
  }

  /// P = j sigma f^-T = sigma cof f, all in the order 11, 12, 21, 22
  template <typename Number>
  std::array<Number, 4>
  nominal_stress(const std::array<Number, 4> &sigma,
                 const std::array<Number, 4> &cofactor)
  {
    return {{sigma[0] * cofactor[0] + sigma[1] * cofactor[2],
             sigma[0] * cofactor[1] + sigma[1] * cofactor[3],
             sigma[2] * cofactor[0] + sigma[3] * cofactor[2],
             sigma[2] * cofactor[1] + sigma[3] * cofactor[3]}};
  }

  /**
   * Kinematics of a point in a step in plane strain. The velocity gradient L
   * is constant over the step, so that L dt = log f with f = I + H.
   *
   * Everything is computed from H itself, never from f - I: with dev H the 2D
   * deviator and q = (dev H)_kl (dev H)_lk / (2 det f) = c^2 - 1,
   *
   *     log f = ln(j)/2 I + x dev H / sqrt(j),  x = arsinh(sqrt q) / sqrt q
   *
   * (x = arcsin(sqrt -q)/sqrt -q for q < 0 and pi minus the arc for c < 0),
   * which is the closed form with c = tr f / (2 sqrt j), acos(c)/sqrt(1 - c^2)
   * and acosh(c)/sqrt(c^2 - 1), without its cancellation near c = 1.
   */
  template <typename Number>
  struct StepKinematics
  {
    /// det f
    Number j;
    /// ln det f, the volumetric strain increment
    Number log_j;
    /// log f, the strain and the spin w_21 dt (turn) of the step
    PlaneTensor<Number> log_f;
    /// cof f = j f^-T in the order 11, 12, 21, 22
    std::array<Number, 4> cofactor;

    /// The step can be taken: det f > 0 and c > -1. If not, only j is set.
    /// For Lanes: the step can be taken and the series for x holds.
    ConditionOf<Number> valid;

    /// @param H H_11, H_12, H_21, H_22
    StepKinematics(const Number *H)
    {
      using std::abs;
      using std::log1p;
      using std::sqrt;

      const Number half_difference = .5 * (H[0] - H[3]);
      const Number half_trace      = .5 * (H[0] + H[3]);
      const Number product         = H[1] * H[2];
      const Number volume_change   = 2. * half_trace + (H[0] * H[3] - product);
      j                            = 1. + volume_change;
      valid                        = value_of(j) > 0.;
      if (!any(valid))
        return;

      const Number inverse_j = 1. / j;
      const Number q =
        (half_difference * half_difference + product) * inverse_j;
      const auto c_positive = 1. + value_of(half_trace) > 0.;
      const auto series_holds =
        c_positive && abs(value_of(q)) < largest_in_series;
      const Number inverse_root_j = sqrt(inverse_j);
      Number       x;
      if constexpr (IsLanes<Number>::value)
        {
          valid = valid && series_holds;
          x     = series(q);
        }
      else if (series_holds)
        x = series(q);
      else
        {
          const double v = value_of(q);
          if (!c_positive && !(v < 0.))
            {
              // two negative eigenvalues, or a rotation by 180 degrees
              valid = false;
              return;
            }
          // c is the better variable here: as a function of q, x has a
          // branch point at a quarter turn
          const Number c    = (1. + half_trace) * inverse_root_j;
          const double root = std::sqrt(std::abs(v));
          const double arc =
            v > 0. ? std::asinh(root) : std::atan2(root, value_of(c));
          x = chain_rule(c, arc / root, (1. - value_of(c) * arc / root) / v);
        }

      log_j              = log1p(volume_change);
      const Number scale = x * inverse_root_j;
      log_f.mean         = .5 * log_j;
      log_f.difference   = scale * half_difference;
      log_f.shear        = scale * (.5 * (H[1] + H[2]));
      log_f.turn         = scale * (.5 * (H[2] - H[1]));
      cofactor           = step_cofactor(H);
    }

    /// The increment d^c dt of a point that rotates by @p theta: L dt without
    /// w^c, d^c_12 = L_12 + theta, d^c_21 = L_21 - theta.
    PlaneTensor<Number>
    stretching(const Number &theta) const
    {
      return {log_f.mean, log_f.difference, log_f.shear, log_f.turn - theta};
    }

    /// k dt = Gamma_i [2 (I + f)^-1]_ij: curvature increment on the
    /// configuration in the middle of the step [1/m]
    static std::array<Number, 2>
    curvature(const Number *H, const Number *Gamma)
    {
      const Number a11     = 1. + .5 * H[0];
      const Number a12     = .5 * H[1];
      const Number a21     = .5 * H[2];
      const Number a22     = 1. + .5 * H[3];
      const Number inverse = 1. / (a11 * a22 - a12 * a21);
      return {{(Gamma[0] * a22 - Gamma[1] * a21) * inverse,
               (Gamma[1] * a11 - Gamma[0] * a12) * inverse}};
    }

    /// P = j sigma f^-T in the order 11, 12, 21, 22; sigma in that order, too
    std::array<Number, 4>
    nominal(const std::array<Number, 4> &sigma) const
    {
      return nominal_stress(sigma, cofactor);
    }

    /// M = j m f^-T
    std::array<Number, 2>
    nominal(const std::array<Number, 2> &m) const
    {
      return {{m[0] * cofactor[0] + m[1] * cofactor[2],
               m[0] * cofactor[1] + m[1] * cofactor[3]}};
    }

    /// Up to this |q| the series is exact to rounding.
    static constexpr double largest_in_series = 2e-3;

    /// x = arsinh(sqrt q)/sqrt q as a power series in q
    static Number
    series(const Number &q)
    {
      const ValueOf<Number> v = value_of(q);
      return chain_rule(
        q,
        1. + v * (-1. / 6 +
                  v * (3. / 40 +
                       v * (-5. / 112 + v * (35. / 1152 - v * (63. / 2816))))),
        -1. / 6 +
          v * (3. / 20 +
               v * (-15. / 112 +
                    v * (35. / 288 + v * (-315. / 2816 + v * (693. / 6656))))));
    }
  };
} // namespace Riedel::Continuum
