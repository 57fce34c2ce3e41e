// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/material/prestress.h>

#include <cmath>

namespace Riedel::Material
{
  namespace
  {
    template <typename Number>
    using Tensor = Continuum::SpaceTensor<2, Number>;



    /// V^2 - I for the volume change w = J - 1
    template <typename Number>
    Tensor<Number>
    square_minus_one(const NeoHookeanElasticity &elasticity,
                     const Tensor<double>       &stress,
                     const Number               &w)
    {
      Tensor<Number> S = ((1. + w) / elasticity.mu) * stress;
      Continuum::add_to_diagonal(
        S, Number((-.5 * elasticity.lambda / elasticity.mu) * w * (2. + w)));
      return S;
    }



    Tensor<double>
    values(const Tensor<Continuum::Forward<4>> &S)
    {
      Tensor<double> result;
      for (unsigned int i = 0; i < S.n; ++i)
        result.components[i] = S.components[i].value;
      return result;
    }



    /// sqrt(I + S) - I of a symmetric positive definite I + S
    Tensor<double>
    root_minus_one(const Tensor<double> &S)
    {
      // sqrt(A) = (A + sqrt(det A) I)/sqrt(tr A + 2 sqrt(det A)) in the plane
      const double   trace = S(0, 0) + S(1, 1);
      const double   minor = trace + S(0, 0) * S(1, 1) - S(0, 1) * S(1, 0);
      const double   e     = minor / (1. + std::sqrt(1. + minor));
      const double   sum   = trace + 2. * e;
      const double   t     = sum / (2. + std::sqrt(4. + sum));
      Tensor<double> root  = (1. / (2. + t)) * S;
      root(0, 0) += (e - t) / (2. + t);
      root(1, 1) += (e - t) / (2. + t);
      root(2, 2) = S(2, 2) / (1. + std::sqrt(1. + S(2, 2)));
      return root;
    }



    bool
    is_positive(const Tensor<double> &S)
    {
      return 1. + S(2, 2) > 0. && 1. + S(0, 0) > 0. &&
             (1. + S(0, 0)) * (1. + S(1, 1)) > S(0, 1) * S(1, 0);
    }
  } // namespace



  std::optional<Continuum::SpaceTensor<2, double>>
  strain_of_stress(const NeoHookeanElasticity          &elasticity,
                   const dealii::SymmetricTensor<2, 3> &stress)
  {
    using Number = Continuum::Forward<4>;
    Tensor<double> sigma;
    for (const auto &[i, j] :
         {std::make_pair(0, 0), {1, 1}, {2, 2}, {0, 1}, {1, 0}})
      sigma(i, j) = stress[i][j];

    // det V^2 - J^2 = 0 for w = J - 1: positive for small J, negative (or
    // without a V) beyond the solution. Newton's method between these.
    double w     = trace(sigma) / (3. * elasticity.bulk_modulus());
    double below = -1., above = 1e3;
    if (!(w > below && w < above))
      w = 0.;
    for (unsigned int iteration = 0; iteration < 200; ++iteration)
      {
        const auto S = square_minus_one(elasticity, sigma, Number::input(w, 0));
        double     next = w;
        if (is_positive(values(S)))
          {
            const Number x = Number::input(w, 0);
            const Number r = determinant_minus_one(S) - x * (2. + x);
            (r.value > 0. ? below : above) = w;
            const double newton            = w - r.value / r.derivatives[0];
            next =
              newton > below && newton < above ? newton : .5 * (below + above);
            if (r.value == 0. || std::abs(newton - w) <= 1e-16 * std::abs(w))
              break;
          }
        else
          {
            above = w;
            next  = .5 * (below + above);
          }
        if (next == w)
          break;
        w = next;
      }
    if (w > 999.)
      return {};
    const Tensor<double> S = square_minus_one(elasticity, sigma, w);
    if (!is_positive(S))
      return {};
    return root_minus_one(S);
  }
} // namespace Riedel::Material
