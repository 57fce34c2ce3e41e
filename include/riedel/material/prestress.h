// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/material/neo_hookean_elasticity.h>

#include <deal.II/base/symmetric_tensor.h>

#include <optional>

namespace Riedel::Material
{
  /**
   * The symmetric elastic strain V - I at which neo-Hookean elasticity has the
   * Cauchy stress @p stress [Pa], if the body has come there from its
   * stress-free state by V alone, J = det V:
   *
   *     V^2 = I + (J sigma - lambda/2 (J^2 - 1) I)/mu    det V = J
   *
   * In plane strain components 13 and 23 of the stress must be zero. Nothing if
   * there is no such strain.
   */
  template <int dim>
  std::optional<Continuum::SpaceTensor<dim, double>>
  strain_of_stress(const NeoHookeanElasticity          &elasticity,
                   const dealii::SymmetricTensor<2, 3> &stress);
} // namespace Riedel::Material
