// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/continuum/space_tensor.h>

#include <algorithm>
#include <cmath>

namespace Riedel::Material
{
  /// How the strength c depends on the hardening variable a.
  enum class Hardening
  {
    none,       ///< c = c_0
    linear,     ///< c = c_0 + h a, until it reaches c_r
    exponential ///< c = c_r + (c_0 - c_r) exp(-a/a_r)
  };

  /**
   * The yield function and the flow of micropolar Drucker-Prager plasticity
   * (equations and source: doc/theory/elastoplasticity.md, section 3):
   *
   *     f = q + A p - c(a)    g = q + B p    q = sqrt(3 J2)    p = sigma_kk/3
   *     J2 = a1 s_ij s_ji + a2 s_ij s_ij + a3/L^2 m_ij m_ij
   */
  struct DruckerPragerPlasticity
  {
    double a1        = .25; ///< a1 + a2 = 1/2
    double a2        = .25; ///< a2 >= a1
    double a3        = .5;
    double length    = 0.; ///< L [m]; 0: no couple stress
    double friction  = 0.; ///< A
    double dilatancy = 0.; ///< B

    Hardening hardening    = Hardening::none;
    double    strength     = 0.; ///< c_0 [Pa]
    double    residual     = 0.; ///< c_r [Pa]
    double    modulus      = 0.; ///< h = dc/da of linear hardening [Pa]
    double    decay_strain = 1.; ///< a_r of exponential hardening

    /// c(a) [Pa]
    double
    strength_at(const double a) const
    {
      switch (hardening)
        {
          case Hardening::none:
            return strength;
          case Hardening::linear:
            {
              const double c = strength + modulus * a;
              return modulus < 0. ? std::max(c, residual) :
                                    std::min(c, residual);
            }
          case Hardening::exponential:
            return residual +
                   (strength - residual) * std::exp(-a / decay_strain);
        }
      return strength;
    }

    /// dc/da [Pa]
    double
    modulus_at(const double a) const
    {
      switch (hardening)
        {
          case Hardening::none:
            return 0.;
          case Hardening::linear:
            {
              const double c = strength + modulus * a;
              return (modulus < 0. ? c > residual : c < residual) ? modulus :
                                                                    0.;
            }
          case Hardening::exponential:
            return (residual - strength) / decay_strain *
                   std::exp(-a / decay_strain);
        }
      return 0.;
    }

    /// The steepest dc/da, negative if there is softening [Pa]
    double
    steepest_modulus() const
    {
      return modulus_at(0.);
    }

    template <typename Number>
    Number
    strength_at(const Number &a) const
    {
      const double v = Continuum::value_of(a);
      return Continuum::chain_rule(a, strength_at(v), modulus_at(v));
    }

    /// 3 J2 of the deviator @p s and the couple stress @p m, as a sum of
    /// squares of the symmetric and the skew part: never negative by rounding
    template <int dim, typename Number>
    Number
    three_J2(const Continuum::SpaceTensor<dim, Number>     &s,
             const Continuum::CurvatureTensor<dim, Number> &m) const
    {
      const auto st   = Continuum::transpose(s);
      const auto even = .5 * (s + st);
      Number     sum  = (3. * (a1 + a2)) * Continuum::contract(even, even);
      if (a2 != a1)
        {
          const auto odd = .5 * (s - st);
          sum += (3. * (a2 - a1)) * Continuum::contract(odd, odd);
        }
      if (length > 0.)
        sum += (3. * a3 / (length * length)) * Continuum::contract(m, m);
      return sum;
    }

    /// q dg/ds = 3 (a1 s^T + a2 s), to which B/3 I comes for dg/dsigma
    template <int dim, typename Number>
    Continuum::SpaceTensor<dim, Number>
    flow(const Continuum::SpaceTensor<dim, Number> &s) const
    {
      return (3. * a1) * Continuum::transpose(s) + (3. * a2) * s;
    }

    /// q dg/dm over m: 3 a3/L^2 [1/m2]
    double
    couple_flow() const
    {
      return length > 0. ? 3. * a3 / (length * length) : 0.;
    }

    /// The norm that is dual to q: the smallest multiplier by which the
    /// deviatoric flow @p x and @p kappa can come about.
    /// @param symmetric the flow has no skew part (a1 = a2)
    template <int dim, typename Number>
    Number
    dual_norm_squared(const Continuum::SpaceTensor<dim, Number>     &x,
                      const Continuum::CurvatureTensor<dim, Number> &kappa,
                      const bool symmetric) const
    {
      const auto   xt   = Continuum::transpose(x);
      const auto   even = .5 * (x + xt);
      const Number mean = (1. / 3.) * Continuum::trace(x);
      Number       sum =
        (2. / 3.) * (Continuum::contract(even, even) - 3. * mean * mean);
      if (!symmetric)
        {
          const auto odd = .5 * (x - xt);
          sum += (1. / (3. * (a2 - a1))) * Continuum::contract(odd, odd);
        }
      if (length > 0.)
        sum +=
          (length * length / (3. * a3)) * Continuum::contract(kappa, kappa);
      return sum;
    }
  };
} // namespace Riedel::Material
