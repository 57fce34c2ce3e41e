// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/material/finite_strain_step.h>
#include <riedel/material/neo_hookean_elasticity.h>

namespace Riedel::Material
{
  /**
   * The tangent of an elastic step of a neo-Hookean point in space, 21 x 21
   * (micropolar) or 9 x 9 in the order of Continuum::Generalised, row by row
   * [Pa, Pa m, N]. By hand, because forward numbers with 21 derivatives take
   * twice as long: with R = dQ^T, W = (I + E) R at the start and V = f W,
   *
   *     dV = df W + f (I + E) dR
   *     P  = J sigma f^-T/J_n,  dP = (d(J sigma) - P df^T) f^-T / J_n
   *     M  = conj(k) W_tot^T / J_n,  k = (dQ k_n + T Gamma V_tot) R
   *
   * where V_tot^T f^-T has become W_tot^T, so that M does not depend on H.
   *
   * @param increments 21 or 9 numbers; f must not be inverted
   * @param start stretch and curvature at the start of the step
   */
  template <bool micropolar>
  void
  elastic_tangent_in_space(const NeoHookeanElasticity           &elasticity,
                           const double                         *increments,
                           const StretchAndCurvature<3, double> &start,
                           double                               *tangent);
} // namespace Riedel::Material
