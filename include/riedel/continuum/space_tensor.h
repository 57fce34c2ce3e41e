// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/continuum/step_kinematics.h>

#include <array>
#include <cmath>
#include <type_traits>

namespace Riedel::Continuum
{
  /**
   * A tensor of three-dimensional mechanics. dim = 2 is plane strain: the four
   * components of the plane and 33, in the order 11, 22, 33, 12, 21 of a
   * point's stress; all others vanish. dim = 3: 11, 22, 33, 12, 21, 13, 31,
   * 23, 32.
   */
  template <int dim, typename Number>
  struct SpaceTensor
  {
    static constexpr unsigned int n = (dim == 2 ? 5 : 9);

    std::array<Number, n> components;

    /// Where component ij is. In plane strain i3 and 3i are not stored.
    static constexpr unsigned int
    place(const unsigned int i, const unsigned int j)
    {
      constexpr unsigned int places[3][3] = {{0, 3, 5}, {4, 1, 7}, {6, 8, 2}};
      return places[i][j];
    }

    /// Is component ij stored?
    static constexpr bool
    has(const unsigned int i, const unsigned int j)
    {
      return place(i, j) < n;
    }

    Number &
    operator()(const unsigned int i, const unsigned int j)
    {
      return components[place(i, j)];
    }

    const Number &
    operator()(const unsigned int i, const unsigned int j) const
    {
      return components[place(i, j)];
    }

    /// the place of ji, where that of ij is @p a
    static constexpr unsigned int
    transposed_place(const unsigned int a)
    {
      return a < 3 ? a : (a % 2 == 1 ? a + 1 : a - 1);
    }
  };

  template <int dim, typename A, typename B>
  auto
  operator+(const SpaceTensor<dim, A> &a, const SpaceTensor<dim, B> &b)
  {
    SpaceTensor<dim, decltype(a.components[0] + b.components[0])> sum;
    for (unsigned int i = 0; i < sum.n; ++i)
      sum.components[i] = a.components[i] + b.components[i];
    return sum;
  }

  template <int dim, typename A, typename B>
  auto
  operator-(const SpaceTensor<dim, A> &a, const SpaceTensor<dim, B> &b)
  {
    SpaceTensor<dim, decltype(a.components[0] - b.components[0])> difference;
    for (unsigned int i = 0; i < difference.n; ++i)
      difference.components[i] = a.components[i] - b.components[i];
    return difference;
  }

  template <int dim, typename A, typename Factor>
  auto
  operator*(const Factor &factor, const SpaceTensor<dim, A> &a)
  {
    SpaceTensor<dim, decltype(factor * a.components[0])> result;
    for (unsigned int i = 0; i < result.n; ++i)
      result.components[i] = factor * a.components[i];
    return result;
  }

  template <int dim, typename A>
  A
  trace(const SpaceTensor<dim, A> &a)
  {
    return a.components[0] + a.components[1] + a.components[2];
  }

  template <int dim, typename A>
  SpaceTensor<dim, A>
  transpose(const SpaceTensor<dim, A> &a)
  {
    SpaceTensor<dim, A> result;
    for (unsigned int i = 0; i < a.n; ++i)
      result.components[i] = a.components[a.transposed_place(i)];
    return result;
  }

  /// a_ik b_kj
  template <int dim, typename A, typename B>
  auto
  operator*(const SpaceTensor<dim, A> &a, const SpaceTensor<dim, B> &b)
  {
    SpaceTensor<dim, decltype(a.components[0] * b.components[0])> c;
    if constexpr (dim == 2)
      {
        c(0, 0) = a(0, 0) * b(0, 0) + a(0, 1) * b(1, 0);
        c(1, 1) = a(1, 0) * b(0, 1) + a(1, 1) * b(1, 1);
        c(0, 1) = a(0, 0) * b(0, 1) + a(0, 1) * b(1, 1);
        c(1, 0) = a(1, 0) * b(0, 0) + a(1, 1) * b(1, 0);
        c(2, 2) = a(2, 2) * b(2, 2);
      }
    else
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          c(i, j) = a(i, 0) * b(0, j) + a(i, 1) * b(1, j) + a(i, 2) * b(2, j);
    return c;
  }

  /// a_ij b_ij
  template <int dim, typename A, typename B>
  auto
  contract(const SpaceTensor<dim, A> &a, const SpaceTensor<dim, B> &b)
  {
    auto sum = a.components[0] * b.components[0];
    for (unsigned int i = 1; i < a.n; ++i)
      sum += a.components[i] * b.components[i];
    return sum;
  }

  /// Adds @p x to 11, 22 and 33.
  template <int dim, typename A>
  void
  add_to_diagonal(SpaceTensor<dim, A> &a, const A &x)
  {
    for (unsigned int i = 0; i < 3; ++i)
      a.components[i] += x;
  }

  /// det(I + a) - 1, exact to rounding of @p a
  template <int dim, typename A>
  A
  determinant_minus_one(const SpaceTensor<dim, A> &a)
  {
    const A minor = a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0);
    if constexpr (dim == 2)
      {
        const A plane = a(0, 0) + a(1, 1) + minor;
        return plane + a(2, 2) + plane * a(2, 2);
      }
    else
      {
        const A second = minor + a(0, 0) * a(2, 2) - a(0, 2) * a(2, 0) +
                         a(1, 1) * a(2, 2) - a(1, 2) * a(2, 1);
        const A third = a(2, 2) * minor +
                        a(0, 2) * (a(1, 0) * a(2, 1) - a(1, 1) * a(2, 0)) -
                        a(1, 2) * (a(0, 0) * a(2, 1) - a(0, 1) * a(2, 0));
        return trace(a) + second + third;
      }
  }

  /// (I + a)^-T
  template <int dim, typename A>
  SpaceTensor<dim, A>
  inverse_transposed(const SpaceTensor<dim, A> &a)
  {
    SpaceTensor<dim, A> F = a, c;
    add_to_diagonal(F, A(1.));
    if constexpr (dim == 2)
      {
        const A inverse = 1. / (F(0, 0) * F(1, 1) - F(0, 1) * F(1, 0));
        c(0, 0)         = inverse * F(1, 1);
        c(1, 1)         = inverse * F(0, 0);
        c(0, 1)         = -(inverse * F(1, 0));
        c(1, 0)         = -(inverse * F(0, 1));
        c(2, 2)         = 1. / F(2, 2);
      }
    else
      {
        const A inverse = 1. / (1. + determinant_minus_one(a));
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            {
              const unsigned int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
              const unsigned int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
              c(i, j) =
                inverse * (F(i1, j1) * F(i2, j2) - F(i1, j2) * F(i2, j1));
            }
      }
    return c;
  }

  /// exp(x) - 1, exact for small x
  template <int n>
  Forward<n>
  expm1(const Forward<n> &x)
  {
    return chain_rule(x, std::expm1(x.value), std::exp(x.value));
  }

  /// Number of terms of a + a^2/2! + a^3/3! + ... after which the rest is below
  /// the rounding error of the first; @p norm: that of a, or a bound of it
  inline unsigned int
  n_terms_of_exponential(const double norm)
  {
    unsigned int n    = 1;
    double       rest = .5 * norm; // norm^n/(n + 1)!
    for (; rest > 1e-17 && n < 40; rest *= norm / (n + 1))
      ++n;
    return n;
  }

  /// exp(a) - I, exact for small @p a. In the plane by the closed form of 2 x 2
  /// tensors, whose deviator has a square that is a number; in space by the
  /// power series of a/2^s and s squarings.
  template <int dim, typename Number>
  SpaceTensor<dim, Number>
  exponential_minus_one(const SpaceTensor<dim, Number> &a)
  {
    using std::expm1;
    SpaceTensor<dim, Number> x;
    if constexpr (dim == 2)
      {
        const Number mean       = .5 * (a(0, 0) + a(1, 1));
        const Number difference = .5 * (a(0, 0) - a(1, 1));
        const Number square     = difference * difference + a(0, 1) * a(1, 0);
        // cosh r - 1 and sinh r/r with r^2 = square
        const double q = value_of(square);
        double       cosine, sine, slope;
        if (std::abs(q) < 1e-2)
          {
            cosine = q * (1. / 2 + q * (1. / 24 + q * (1. / 720 + q / 40320)));
            sine =
              1. + q * (1. / 6 + q * (1. / 120 + q * (1. / 5040 + q / 362880)));
            slope = 1. / 6 + q * (1. / 60 + q * (1. / 1680 + q * (1. / 90720)));
          }
        else
          {
            const double r    = std::sqrt(std::abs(q));
            const double half = q > 0. ? std::sinh(.5 * r) : std::sin(.5 * r);
            cosine            = std::copysign(2. * half * half, q);
            sine              = (q > 0. ? std::sinh(r) : std::sin(r)) / r;
            slope             = .5 * (1. + cosine - sine) / q;
          }
        const Number c     = chain_rule(square, cosine, .5 * sine);
        const Number s     = chain_rule(square, sine, slope);
        const Number grown = expm1(mean);
        const Number scale = 1. + grown;
        const Number part  = grown + scale * c;
        const Number outer = scale * s;
        x(0, 0)            = part + outer * difference;
        x(1, 1)            = part - outer * difference;
        x(0, 1)            = outer * a(0, 1);
        x(1, 0)            = outer * a(1, 0);
        x(2, 2)            = expm1(a(2, 2));
      }
    else
      {
        double size = 0.;
        for (const Number &component : a.components)
          size = std::max(size, std::abs(value_of(component)));
        int squarings = 0;
        for (; size > .1 && squarings < 60; size *= .5)
          ++squarings;
        const SpaceTensor<dim, Number> small = std::ldexp(1., -squarings) * a;
        x                                    = small;
        for (unsigned int k = n_terms_of_exponential(3. * size); k >= 2; --k)
          x = small + (1. / k) * (small * x);
        for (int k = 0; k < squarings; ++k)
          x = 2. * x + x * x;
      }
    return x;
  }



  /**
   * A curvature or couple stress: the first index belongs to the rotation, the
   * second to the gradient or the face. dim = 2: 31 and 32. dim = 3: in the
   * order 11, 12, 13, 21, ...
   */
  template <int dim, typename Number>
  struct CurvatureTensor
  {
    static constexpr unsigned int n = (dim == 2 ? 2 : 9);

    std::array<Number, n> components;
  };

  /// k_il a_lj
  template <int dim, typename A, typename B>
  auto
  operator*(const CurvatureTensor<dim, A> &k, const SpaceTensor<dim, B> &a)
  {
    CurvatureTensor<dim, decltype(k.components[0] * a.components[0])> result;
    if constexpr (dim == 2)
      for (unsigned int j = 0; j < 2; ++j)
        result.components[j] =
          k.components[0] * a(0, j) + k.components[1] * a(1, j);
    else
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          result.components[3 * i + j] = k.components[3 * i] * a(0, j) +
                                         k.components[3 * i + 1] * a(1, j) +
                                         k.components[3 * i + 2] * a(2, j);
    return result;
  }

  /// k_il + k_im a_ml, that is k (I + a) where @p a may be small
  template <int dim, typename A, typename B>
  auto
  times_one_plus(const CurvatureTensor<dim, A> &k, const SpaceTensor<dim, B> &a)
  {
    auto result = k * a;
    for (unsigned int i = 0; i < k.n; ++i)
      result.components[i] += k.components[i];
    return result;
  }

  /// a_ij b_ij
  template <int dim, typename A, typename B>
  auto
  contract(const CurvatureTensor<dim, A> &a, const CurvatureTensor<dim, B> &b)
  {
    auto sum = a.components[0] * b.components[0];
    for (unsigned int i = 1; i < a.n; ++i)
      sum += a.components[i] * b.components[i];
    return sum;
  }
} // namespace Riedel::Continuum
