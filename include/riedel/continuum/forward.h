// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>
#include <type_traits>

namespace Riedel::Continuum
{
  /**
   * n doubles as vectors of the compiler's own, as long as the processor has
   * them: GCC handles longer ones poorly. n is a multiple of 4.
   */
  template <int n>
  class DerivativeVector
  {
    static constexpr int n_each =
#if defined(__AVX512F__)
      (n % 8 == 0 ? 8 : 4);
#elif defined(__AVX__)
      4;
#else
      2;
#endif
    static constexpr int n_pieces = n / n_each;
    typedef double Piece __attribute__((vector_size(n_each * sizeof(double))));

    Piece pieces[n_pieces];

  public:
    static DerivativeVector
    zero()
    {
      DerivativeVector result;
      for (Piece &piece : result.pieces)
        piece = Piece{};
      return result;
    }

    double
    operator[](const unsigned int i) const
    {
      return pieces[i / n_each][i % n_each];
    }

    void
    set(const unsigned int i, const double value)
    {
      pieces[i / n_each][i % n_each] = value;
    }

    DerivativeVector &
    operator+=(const DerivativeVector &b)
    {
      return *this = *this + b;
    }

    friend DerivativeVector
    operator+(const DerivativeVector &a, const DerivativeVector &b)
    {
      DerivativeVector result;
      for (int i = 0; i < n_pieces; ++i)
        result.pieces[i] = a.pieces[i] + b.pieces[i];
      return result;
    }

    friend DerivativeVector
    operator-(const DerivativeVector &a, const DerivativeVector &b)
    {
      DerivativeVector result;
      for (int i = 0; i < n_pieces; ++i)
        result.pieces[i] = a.pieces[i] - b.pieces[i];
      return result;
    }

    friend DerivativeVector
    operator-(const DerivativeVector &a)
    {
      DerivativeVector result;
      for (int i = 0; i < n_pieces; ++i)
        result.pieces[i] = -a.pieces[i];
      return result;
    }

    friend DerivativeVector
    operator*(const DerivativeVector &a, const double factor)
    {
      DerivativeVector result;
      for (int i = 0; i < n_pieces; ++i)
        result.pieces[i] = a.pieces[i] * factor;
      return result;
    }

    friend DerivativeVector
    operator*(const double factor, const DerivativeVector &a)
    {
      return a * factor;
    }
  };



  /**
   * A number that carries its derivatives with respect to n inputs (forward
   * mode differentiation). Every operation on the derivatives is a handful of
   * vector instructions: n is 8 for the 7 increments of a micropolar continuum
   * in plane strain and 4 for those of a classical one.
   *
   * There are no comparisons on purpose: decisions are made on value_of().
   */
  template <int n>
  struct Forward
  {
    double              value;
    DerivativeVector<n> derivatives;

    Forward() = default;

    /// A constant. Implicit, because constants mix freely with numbers.
    Forward(const double value)
      : value(value)
      , derivatives(DerivativeVector<n>::zero())
    {}

    Forward(const double value, const DerivativeVector<n> &derivatives)
      : value(value)
      , derivatives(derivatives)
    {}

    /// The input number @p place at the value @p value.
    static Forward
    input(const double value, const unsigned int place)
    {
      Forward result(value);
      result.derivatives.set(place, 1.);
      return result;
    }

    Forward &
    operator+=(const Forward &b)
    {
      value += b.value;
      derivatives += b.derivatives;
      return *this;
    }

    friend Forward
    operator-(const Forward &a)
    {
      return {-a.value, -a.derivatives};
    }

    friend Forward
    operator+(const Forward &a, const Forward &b)
    {
      return {a.value + b.value, a.derivatives + b.derivatives};
    }

    friend Forward
    operator+(const Forward &a, const double b)
    {
      return {a.value + b, a.derivatives};
    }

    friend Forward
    operator+(const double a, const Forward &b)
    {
      return {a + b.value, b.derivatives};
    }

    friend Forward
    operator-(const Forward &a, const Forward &b)
    {
      return {a.value - b.value, a.derivatives - b.derivatives};
    }

    friend Forward
    operator-(const Forward &a, const double b)
    {
      return {a.value - b, a.derivatives};
    }

    friend Forward
    operator-(const double a, const Forward &b)
    {
      return {a - b.value, -b.derivatives};
    }

    friend Forward
    operator*(const Forward &a, const Forward &b)
    {
      return {a.value * b.value,
              a.derivatives * b.value + b.derivatives * a.value};
    }

    friend Forward
    operator*(const Forward &a, const double b)
    {
      return {a.value * b, a.derivatives * b};
    }

    friend Forward
    operator*(const double a, const Forward &b)
    {
      return {a * b.value, a * b.derivatives};
    }

    friend Forward
    operator/(const Forward &a, const Forward &b)
    {
      const double inverse  = 1. / b.value;
      const double quotient = a.value * inverse;
      return {quotient, (a.derivatives - b.derivatives * quotient) * inverse};
    }

    friend Forward
    operator/(const Forward &a, const double b)
    {
      return a * (1. / b);
    }

    friend Forward
    operator/(const double a, const Forward &b)
    {
      const double inverse  = 1. / b.value;
      const double quotient = a * inverse;
      return {quotient, b.derivatives * (-quotient * inverse)};
    }
  };

  /// The value of a number, for decisions that are not differentiated.
  inline double
  value_of(const double x)
  {
    return x;
  }

  template <int n>
  double
  value_of(const Forward<n> &x)
  {
    return x.value;
  }

  /// The input number @p place: the value alone if Number is double.
  template <typename Number>
  Number
  input(const double value, const unsigned int place)
  {
    if constexpr (std::is_same<Number, double>::value)
      {
        (void)place;
        return value;
      }
    else
      return Number::input(value, place);
  }

  /// f(x), where the value and the slope of f at x are known.
  inline double
  chain_rule(const double /*x*/, const double value, const double /*slope*/)
  {
    return value;
  }

  template <int n>
  Forward<n>
  chain_rule(const Forward<n> &x, const double value, const double slope)
  {
    return {value, x.derivatives * slope};
  }

  /// The number with its value replaced by zero: what a stiffness adds to a
  /// tangent without adding to the stress.
  inline double
  only_derivatives(const double /*x*/)
  {
    return 0.;
  }

  template <int n>
  Forward<n>
  only_derivatives(const Forward<n> &x)
  {
    return {0., x.derivatives};
  }

  template <int n>
  Forward<n>
  sqrt(const Forward<n> &x)
  {
    const double root = std::sqrt(x.value);
    return chain_rule(x, root, .5 / root);
  }

  template <int n>
  Forward<n>
  pow(const Forward<n> &x, const double exponent)
  {
    const double power = std::pow(x.value, exponent);
    return chain_rule(x, power, exponent * power / x.value);
  }

  template <int n>
  Forward<n>
  exp(const Forward<n> &x)
  {
    const double exponential = std::exp(x.value);
    return chain_rule(x, exponential, exponential);
  }

  template <int n>
  Forward<n>
  log(const Forward<n> &x)
  {
    return chain_rule(x, std::log(x.value), 1. / x.value);
  }

  /// log(1 + x), exact for small x
  template <int n>
  Forward<n>
  log1p(const Forward<n> &x)
  {
    return chain_rule(x, std::log1p(x.value), 1. / (1. + x.value));
  }

  template <int n>
  Forward<n>
  sin(const Forward<n> &x)
  {
    return chain_rule(x, std::sin(x.value), std::cos(x.value));
  }

  template <int n>
  Forward<n>
  cos(const Forward<n> &x)
  {
    return chain_rule(x, std::cos(x.value), -std::sin(x.value));
  }
} // namespace Riedel::Continuum
