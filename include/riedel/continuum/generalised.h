// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace Riedel::Continuum
{
  /**
   * Component order of the generalised increments of a step and of the
   * stresses that are power conjugate to them (doc/theory/conventions.md).
   *
   *     increments  H = grad_n(du), theta = dw, Gamma = grad_n(dw)
   *     stresses    P = j sigma f^-T, t_k = j e_kij sigma_ij, M = j m f^-T
   *
   * with f = I + H and j = det f. In plane strain the order is
   *
   *     H_11 H_12 H_21 H_22 | theta_3 | Gamma_31 Gamma_32
   *     P_11 P_12 P_21 P_22 | t_3     | M_31     M_32
   *
   * A classical continuum has the first block only.
   */
  template <int dim>
  struct Generalised
  {
    static constexpr unsigned int n_spin     = (dim == 2 ? 1 : 3);
    static constexpr unsigned int n_gradient = dim * dim;
    /// number of components of a classical continuum
    static constexpr unsigned int n_classical = n_gradient;
    /// number of components of a micropolar continuum
    static constexpr unsigned int n_micropolar =
      n_gradient + n_spin + n_spin * dim;

    /// index of H_ij
    static constexpr unsigned int
    gradient(const unsigned int i, const unsigned int j)
    {
      return i * dim + j;
    }

    /// index of theta_k
    static constexpr unsigned int
    spin(const unsigned int k = 0)
    {
      return n_gradient + k;
    }

    /// index of Gamma_kj
    static constexpr unsigned int
    curvature(const unsigned int k, const unsigned int j)
    {
      return n_gradient + n_spin + k * dim + j;
    }
  };
} // namespace Riedel::Continuum
