// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/continuum/newton.h>
#include <riedel/material/prestress.h>

#include <cmath>

namespace Riedel::Material
{
  namespace
  {
    template <int dim, typename Number>
    using Tensor = Continuum::SpaceTensor<dim, Number>;



    /// V^2 - I for the volume change w = J - 1
    template <int dim, typename Number>
    Tensor<dim, Number>
    square_minus_one(const NeoHookeanElasticity &elasticity,
                     const Tensor<dim, double>  &stress,
                     const Number               &w)
    {
      Tensor<dim, Number> S = ((1. + w) / elasticity.mu) * stress;
      Continuum::add_to_diagonal(
        S, Number((-.5 * elasticity.lambda / elasticity.mu) * w * (2. + w)));
      return S;
    }



    template <int dim>
    Tensor<dim, double>
    values(const Tensor<dim, Continuum::Forward<4>> &S)
    {
      Tensor<dim, double> result;
      for (unsigned int i = 0; i < S.n; ++i)
        result.components[i] = S.components[i].value;
      return result;
    }



    /// sqrt(I + S) - I of a symmetric positive definite I + S
    Tensor<2, double>
    root_minus_one(const Tensor<2, double> &S)
    {
      // sqrt(A) = (A + sqrt(det A) I)/sqrt(tr A + 2 sqrt(det A)) in the plane
      const double      trace = S(0, 0) + S(1, 1);
      const double      minor = trace + S(0, 0) * S(1, 1) - S(0, 1) * S(1, 0);
      const double      e     = minor / (1. + std::sqrt(1. + minor));
      const double      sum   = trace + 2. * e;
      const double      t     = sum / (2. + std::sqrt(4. + sum));
      Tensor<2, double> root  = (1. / (2. + t)) * S;
      root(0, 0) += (e - t) / (2. + t);
      root(1, 1) += (e - t) / (2. + t);
      root(2, 2) = S(2, 2) / (1. + std::sqrt(1. + S(2, 2)));
      return root;
    }



    /// In space by the iteration of Denman and Beavers (1976) for the root Y
    /// and its inverse Z.
    Tensor<3, double>
    root_minus_one(const Tensor<3, double> &S)
    {
      const Tensor<3, double> none{};
      Tensor<3, double>       Y = S, Z = none; // without I
      const auto              inverse_minus_one = [](const auto &A) {
        auto B = Continuum::transpose(Continuum::inverse_transposed(A));
        Continuum::add_to_diagonal(B, -1.);
        return B;
      };
      for (unsigned int k = 0; k < 50; ++k)
        {
          const auto next     = .5 * (Y + inverse_minus_one(Z));
          Z                   = .5 * (Z + inverse_minus_one(Y));
          const double change = Continuum::largest_value((next - Y).components);
          Y                   = next;
          if (change <= 1e-16)
            break;
        }
      return Y;
    }



    /// Is I + S positive definite? By its principal minors.
    template <int dim>
    bool
    is_positive(const Tensor<dim, double> &S)
    {
      const double plane = (1. + S(0, 0)) * (1. + S(1, 1)) - S(0, 1) * S(1, 0);
      return 1. + S(2, 2) > 0. && 1. + S(0, 0) > 0. && plane > 0. &&
             1. + determinant_minus_one(S) > 0.;
    }
  } // namespace



  template <int dim>
  std::optional<Continuum::SpaceTensor<dim, double>>
  strain_of_stress(const NeoHookeanElasticity          &elasticity,
                   const dealii::SymmetricTensor<2, 3> &stress)
  {
    using Number = Continuum::Forward<4>;
    Tensor<dim, double> sigma;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        if (sigma.has(i, j))
          sigma(i, j) = stress[i][j];

    // det V^2 - J^2 = 0 for w = J - 1: positive for small J, negative (or
    // without a V) beyond the solution. Newton's method between these.
    double w     = trace(sigma) / (3. * elasticity.bulk_modulus());
    double below = -1., above = 1e3;
    if (!(w > below && w < above))
      w = 0.;
    for (unsigned int iteration = 0; iteration < 200; ++iteration)
      {
        const auto S =
          square_minus_one<dim>(elasticity, sigma, Number::input(w, 0));
        double next = w;
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
    const Tensor<dim, double> S = square_minus_one<dim>(elasticity, sigma, w);
    if (!is_positive(S))
      return {};
    return root_minus_one(S);
  }



  template std::optional<Continuum::SpaceTensor<2, double>>
  strain_of_stress<2>(const NeoHookeanElasticity &,
                      const dealii::SymmetricTensor<2, 3> &);
  template std::optional<Continuum::SpaceTensor<3, double>>
  strain_of_stress<3>(const NeoHookeanElasticity &,
                      const dealii::SymmetricTensor<2, 3> &);
} // namespace Riedel::Material
