// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/continuum/space_tensor.h>

#include <array>
#include <cmath>
#include <type_traits>

namespace Riedel::Continuum
{
  /**
   * sin t/t, (1 - cos t)/t^2 and (t - sin t)/t^3 as functions of q = t^2, and
   * their slopes: the power series sum_k (-q)^k/(2 k + i)!, i = 1, 2, 3, below
   * q = 1/4, where the closed forms lose digits.
   */
  struct TurnFactors
  {
    std::array<double, 3> factors;
    std::array<double, 3> slopes;

    explicit TurnFactors(const double q)
    {
      if (q < .25)
        {
          for (unsigned int i = 0; i < 3; ++i)
            {
              // rest below 1e-17
              constexpr int last = 8;
              double        term = inverse_factorial(2 * last + i + 1);
              factors[i] = slopes[i] = 0.;
              for (int k = last; k >= 0; --k)
                {
                  slopes[i]  = factors[i] + q * slopes[i];
                  factors[i] = (k % 2 == 0 ? term : -term) + q * factors[i];
                  term *= (2. * k + i + 1.) * (2. * k + i);
                }
            }
          return;
        }
      const double t    = std::sqrt(q);
      const double half = std::sin(.5 * t);
      factors           = {
                  {std::sin(t) / t, 2. * half * half / q, (t - std::sin(t)) / (t * q)}};
      slopes = {{(std::cos(t) - factors[0]) / (2. * q),
                 (factors[0] - 2. * factors[1]) / (2. * q),
                 (factors[1] - 3. * factors[2]) / (2. * q)}};
    }

  private:
    static constexpr double
    inverse_factorial(const unsigned int n)
    {
      double result = 1.;
      for (unsigned int k = 2; k <= n; ++k)
        result /= k;
      return result;
    }
  };



  /**
   * The rotation exp(A) and the tangent of the exponential map, T = I + A/2! +
   * A^2/3! + ..., of a rotation vector theta [rad]; A is its skew tensor. By
   * Rodrigues' formula, whose factors are functions of |theta|^2:
   *
   *     exp(A) = I + s A + c A^2    T = I + c A + d A^2
   *
   * With derivatives: the three with respect to theta are computed first,
   * those with respect to the inputs by the chain rule.
   */
  template <typename Number>
  struct TurnInSpace
  {
    /// exp(A) - I
    SpaceTensor<3, Number> rotation;
    /// T - I
    SpaceTensor<3, Number> tangent;

    /// @param theta three components
    explicit TurnInSpace(const Number *theta)
    {
      if constexpr (std::is_same<Number, double>::value)
        compute({{theta[0], theta[1], theta[2]}}, rotation, tangent);
      else
        {
          using Three = Forward<4>;
          std::array<Three, 3> inputs;
          for (unsigned int i = 0; i < 3; ++i)
            inputs[i] = Three::input(theta[i].value, i);
          SpaceTensor<3, Three> exponential, integral;
          compute(inputs, exponential, integral);
          const auto chained = [&](const Three &x) {
            Number result(x.value);
            for (unsigned int i = 0; i < 3; ++i)
              result.derivatives += theta[i].derivatives * x.derivatives[i];
            return result;
          };
          for (unsigned int i = 0; i < rotation.n; ++i)
            {
              rotation.components[i] = chained(exponential.components[i]);
              tangent.components[i]  = chained(integral.components[i]);
            }
        }
    }

  private:
    template <typename X>
    static void
    compute(const std::array<X, 3> &theta,
            SpaceTensor<3, X>      &exponential,
            SpaceTensor<3, X>      &integral)
    {
      const X q =
        theta[0] * theta[0] + theta[1] * theta[1] + theta[2] * theta[2];
      const TurnFactors at(value_of(q));
      const X           s = chain_rule(q, at.factors[0], at.slopes[0]);
      const X           c = chain_rule(q, at.factors[1], at.slopes[1]);
      const X           d = chain_rule(q, at.factors[2], at.slopes[2]);
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          {
            // A^2 = theta theta^T - q I
            X square = theta[i] * theta[j];
            if (i == j)
              square += -q;
            exponential(i, j) = c * square;
            integral(i, j)    = d * square;
          }
      for (unsigned int k = 0; k < 3; ++k)
        {
          const unsigned int i = (k + 1) % 3, j = (k + 2) % 3;
          exponential(j, i) += s * theta[k];
          exponential(i, j) += -(s * theta[k]);
          integral(j, i) += c * theta[k];
          integral(i, j) += -(c * theta[k]);
        }
    }
  };
} // namespace Riedel::Continuum
