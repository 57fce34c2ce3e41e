// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/continuum/space_tensor.h>

#include <cmath>

namespace Riedel::Material
{
  /**
   * Neo-Hookean micropolar elasticity: stresses from the elastic left stretch
   * V = F Q^T and the left curvature k (equations and source:
   * doc/theory/elastoplasticity.md, section 1). A stretch is always given by
   * the strain E = V - I, in which small strains are not lost beside 1. All
   * functions exist for plane strain (dim = 2) and in space (dim = 3).
   */
  struct NeoHookeanElasticity
  {
    double lambda = 0.; ///< first Lame modulus [Pa]
    double mu     = 0.; ///< shear modulus [Pa]
    double kappa  = 0.; ///< 2 mu_c, twice the couple modulus [Pa]
    double alpha  = 0.; ///< curvature moduli [N]
    double beta   = 0.;
    double gamma  = 0.; ///< the bending modulus of plane strain

    /// mu_c [Pa]
    double
    couple_modulus() const
    {
      return .5 * kappa;
    }

    /// K = lambda + 2/3 mu [Pa]
    double
    bulk_modulus() const
    {
      return lambda + 2. / 3. * mu;
    }

    /// L, L^2 = (beta + gamma)/(2 mu) [m]
    double
    length() const
    {
      return std::sqrt((beta + gamma) / (2. * mu));
    }

    /// J sigma = lambda/2 (Je^2 - 1) I + mu (V V^T - I)
    ///           + kappa/2 (V - V^T) V^T
    template <int dim, typename Number>
    Continuum::SpaceTensor<dim, Number>
    kirchhoff_stress(const Continuum::SpaceTensor<dim, Number> &E) const
    {
      using Continuum::transpose;
      const auto   Et     = Continuum::transpose(E);
      const Number volume = Continuum::determinant_minus_one(E);
      auto         tau    = mu * (E + Et + E * Et);
      if (kappa != 0.)
        {
          const auto skew = (.5 * kappa) * (E - Et);
          tau             = tau + skew + skew * Et;
        }
      Continuum::add_to_diagonal(tau,
                                 Number((.5 * lambda) * volume *
                                        (2. + volume)));
      return tau;
    }

    /// J m = (alpha tr k I + beta k^T + gamma k) Vtot^T, with Vtot = I + total.
    /// In plane strain the components 31 and 32, for which only gamma counts.
    template <int dim, typename Number, typename Total>
    auto
    kirchhoff_couple_stress(
      const Continuum::CurvatureTensor<dim, Number> &k,
      const Continuum::SpaceTensor<dim, Total>      &total) const
    {
      Continuum::CurvatureTensor<dim, Number> conjugate;
      for (unsigned int i = 0; i < k.n; ++i)
        conjugate.components[i] = gamma * k.components[i];
      if constexpr (dim == 3)
        {
          const Number spherical =
            alpha * (k.components[0] + k.components[4] + k.components[8]);
          for (unsigned int i = 0; i < 3; ++i)
            {
              conjugate.components[4 * i] += spherical;
              for (unsigned int j = 0; j < 3; ++j)
                conjugate.components[3 * i + j] +=
                  beta * k.components[3 * j + i];
            }
        }
      return Continuum::times_one_plus(conjugate, Continuum::transpose(total));
    }

    /// stored energy per stress-free volume [J/m3], 0 at V = I and k = 0
    template <int dim, typename Number>
    Number
    energy(const Continuum::SpaceTensor<dim, Number>     &E,
           const Continuum::CurvatureTensor<dim, Number> &k) const
    {
      using std::log1p;
      const Number volume = Continuum::determinant_minus_one(E);
      const auto   skew   = .5 * (E - Continuum::transpose(E));
      Number       curved = gamma * Continuum::contract(k, k);
      if constexpr (dim == 3)
        {
          const auto  &c     = k.components;
          const Number trace = c[0] + c[4] + c[8];
          curved += alpha * trace * trace;
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int j = 0; j < 3; ++j)
              curved += beta * c[3 * i + j] * c[3 * j + i];
        }
      // V:V = 3 + 2 tr E + E:E and V:V - tr(V V) = 2 skew:skew
      return (.25 * lambda) * volume * (2. + volume) -
             (.5 * lambda + mu) * log1p(volume) +
             mu * (Continuum::trace(E) + .5 * Continuum::contract(E, E)) +
             (.5 * kappa) * Continuum::contract(skew, skew) + .5 * curved;
    }
  };
} // namespace Riedel::Material
