// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/continuum/lanes.h>

#include <array>
#include <cmath>

namespace Riedel::Continuum
{
  /**
   * Cosine and sine of an angle [rad]. The angles of a step are mostly small:
   * the polynomials are then exact to rounding and many times cheaper.
   */
  template <typename Value>
  struct Turn
  {
    Value cosine;
    Value sine;

    /// Where the polynomials hold, up to this angle
    static constexpr double largest_small_angle = .05;

    static Turn
    small(const Value &angle)
    {
      const Value x = angle * angle;
      return {
        1. + x * (-1. / 2 + x * (1. / 24 + x * (-1. / 720 + x * (1. / 40320)))),
        angle *
          (1. + x * (-1. / 6 +
                     x * (1. / 120 + x * (-1. / 5040 + x * (1. / 362880)))))};
    }
  };

  inline Turn<double>
  turn(const double angle)
  {
    if (std::abs(angle) < Turn<double>::largest_small_angle)
      return Turn<double>::small(angle);
    return {std::cos(angle), std::sin(angle)};
  }

  /// For small angles only: the caller leaves other lanes to double.
  template <int n>
  Turn<Lanes<n>>
  turn(const Lanes<n> &angle)
  {
    return Turn<Lanes<n>>::small(angle);
  }

  /**
   * Rotation of the axes of the plane: cosine and sine of an angle and of
   * twice the angle.
   */
  template <typename Number>
  struct PlaneRotation
  {
    Number cosine;
    Number sine;
    Number cosine_of_double;
    Number sine_of_double;

    PlaneRotation(const Number &angle)
    {
      using Value              = ValueOf<Number>;
      const Turn<Value> single = turn(value_of(angle));
      cosine                   = chain_rule(angle, single.cosine, -single.sine);
      sine                     = chain_rule(angle, single.sine, single.cosine);
      const Value c            = 1. - 2. * single.sine * single.sine;
      const Value s            = 2. * single.sine * single.cosine;
      cosine_of_double         = chain_rule(angle, c, -2. * s);
      sine_of_double           = chain_rule(angle, s, 2. * c);
    }
  };

  /**
   * A tensor of the plane by its four parts on which a rotation of the axes
   * acts simply:
   *
   *     A_11 = mean + difference     A_12 = shear - turn
   *     A_22 = mean - difference     A_21 = shear + turn
   */
  template <typename Number>
  struct PlaneTensor
  {
    Number mean;
    Number difference;
    Number shear;
    Number turn;

    /// R A R^T: the components in the fixed frame of a tensor that is given in
    /// a frame turned by the rotation R, counter-clockwise.
    PlaneTensor
    to_fixed_frame(const PlaneRotation<Number> &rotation) const
    {
      return {mean,
              rotation.cosine_of_double * difference -
                rotation.sine_of_double * shear,
              rotation.cosine_of_double * shear +
                rotation.sine_of_double * difference,
              turn};
    }

    /// R^T A R: the components in the turned frame.
    PlaneTensor
    to_turned_frame(const PlaneRotation<Number> &rotation) const
    {
      return {mean,
              rotation.cosine_of_double * difference +
                rotation.sine_of_double * shear,
              rotation.cosine_of_double * shear -
                rotation.sine_of_double * difference,
              turn};
    }

    /// in the order 11, 12, 21, 22
    std::array<Number, 4>
    components() const
    {
      return {
        {mean + difference, shear - turn, shear + turn, mean - difference}};
    }
  };

  /// R v: components in the fixed frame of a vector given in the turned one.
  template <typename Number>
  std::array<Number, 2>
  to_fixed_frame(const std::array<Number, 2> &v,
                 const PlaneRotation<Number> &rotation)
  {
    return {{rotation.cosine * v[0] - rotation.sine * v[1],
             rotation.cosine * v[1] + rotation.sine * v[0]}};
  }

  /// R^T v
  template <typename Number>
  std::array<Number, 2>
  to_turned_frame(const std::array<Number, 2> &v,
                  const PlaneRotation<Number> &rotation)
  {
    return {{rotation.cosine * v[0] + rotation.sine * v[1],
             rotation.cosine * v[1] - rotation.sine * v[0]}};
  }
} // namespace Riedel::Continuum
