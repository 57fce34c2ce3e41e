// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>
#include <cstring>
#include <type_traits>

namespace Riedel::Continuum
{
  /// How the n derivatives of a number of several points (Lanes) are stored:
  /// each as such a number.
  template <int n, typename Value>
  struct DerivativeStore
  {
    using Piece                   = Value;
    static constexpr int n_pieces = n;

    template <typename Pieces>
    static Value
    get(const Pieces &pieces, const unsigned int i)
    {
      return pieces[i];
    }

    template <typename Pieces>
    static void
    set_unit(Pieces &pieces, const unsigned int place)
    {
      for (int i = 0; i < n; ++i)
        pieces[i] = Value(i == static_cast<int>(place) ? 1. : 0.);
    }
  };

  /// Those of one point: n doubles as vectors of the compiler's own, as long as
  /// the processor has them: GCC handles longer ones poorly. n is a multiple of
  /// 4.
  template <int n>
  struct DerivativeStore<n, double>
  {
    static constexpr int n_each =
#if defined(__AVX512F__)
      (n % 8 == 0 ? 8 : 4);
#elif defined(__AVX__)
      4;
#else
      2;
#endif
    typedef double Piece __attribute__((vector_size(n_each * sizeof(double))));
    static constexpr int n_pieces = n / n_each;

    template <typename Pieces>
    static double
    get(const Pieces &pieces, const unsigned int i)
    {
      return pieces[i / n_each][i % n_each];
    }

    /// By whole pieces: one that is written in parts is slow to read at once.
    template <typename Pieces>
    static void
    set_unit(Pieces &pieces, const unsigned int place)
    {
      struct Table
      {
        double numbers[2 * n] = {};

        constexpr Table()
        {
          numbers[n] = 1.;
        }
      };
      static constexpr Table table;
      std::memcpy(&pieces, table.numbers + n - place, n * sizeof(double));
    }
  };



  /// The derivatives of a number with respect to n inputs.
  template <int n, typename Value = double>
  class DerivativeVector
  {
    using Store                   = DerivativeStore<n, Value>;
    static constexpr int n_pieces = Store::n_pieces;

    typename Store::Piece pieces[n_pieces];

  public:
    DerivativeVector() = default;

    /// Piece by piece: GCC copies longer objects by an instruction (rep movs)
    /// that takes longer than an operation on them.
    DerivativeVector(const DerivativeVector &b)
    {
      *this = b;
    }

    DerivativeVector &
    operator=(const DerivativeVector &b)
    {
#pragma GCC unroll 8
      for (int i = 0; i < n_pieces; ++i)
        pieces[i] = b.pieces[i];
      return *this;
    }

    /// Unrolled, so that the compiler can keep pieces in registers: of its own
    /// accord it does not for 7 of them, which takes half as long again.
    template <typename Function>
    static DerivativeVector
    pieces_of(const Function &function)
    {
      DerivativeVector result;
#pragma GCC unroll 8
      for (int i = 0; i < n_pieces; ++i)
        result.pieces[i] = function(i);
      return result;
    }

    static DerivativeVector
    zero()
    {
      return pieces_of([](int) { return typename Store::Piece{}; });
    }

    Value
    operator[](const unsigned int i) const
    {
      return Store::get(pieces, i);
    }

    /// 1 at @p place, else 0
    static DerivativeVector
    unit(const unsigned int place)
    {
      DerivativeVector result;
      Store::set_unit(result.pieces, place);
      return result;
    }

    /// Writes the first @p n_wanted of doubles.
    void
    copy_to(double *numbers, const unsigned int n_wanted) const
    {
      static_assert(std::is_same<Value, double>::value, "of one point");
      std::memcpy(numbers, &pieces, n_wanted * sizeof(double));
    }

    DerivativeVector &
    operator+=(const DerivativeVector &b)
    {
      return *this = *this + b;
    }

    friend DerivativeVector
    operator+(const DerivativeVector &a, const DerivativeVector &b)
    {
      return pieces_of([&](int i) { return a.pieces[i] + b.pieces[i]; });
    }

    friend DerivativeVector
    operator-(const DerivativeVector &a, const DerivativeVector &b)
    {
      return pieces_of([&](int i) { return a.pieces[i] - b.pieces[i]; });
    }

    friend DerivativeVector
    operator-(const DerivativeVector &a)
    {
      return pieces_of([&](int i) { return -a.pieces[i]; });
    }

    friend DerivativeVector
    operator*(const DerivativeVector &a, const Value &factor)
    {
      return pieces_of([&](int i) { return a.pieces[i] * factor; });
    }

    /// a factor_a + b factor_b, in one pass
    friend DerivativeVector
    weighted_sum(const DerivativeVector &a,
                 const Value            &factor_a,
                 const DerivativeVector &b,
                 const Value            &factor_b)
    {
      return pieces_of(
        [&](int i) { return a.pieces[i] * factor_a + b.pieces[i] * factor_b; });
    }
  };



  /**
   * A number that carries its derivatives with respect to n inputs (forward
   * mode differentiation). Value is double for one point: every operation on
   * the derivatives is then a handful of vector instructions; n is 8 for the 7
   * increments of a micropolar continuum in plane strain and 4 for those of a
   * classical one. Or it is Lanes for several points at once, and n is the
   * number of inputs.
   *
   * There are no comparisons on purpose: decisions are made on value_of().
   */
  template <int n, typename Value = double>
  struct Forward
  {
    Value                      value;
    DerivativeVector<n, Value> derivatives;

    /// What an operation takes for a number without derivatives.
    template <typename Constant>
    using IfConstant = std::enable_if_t<std::is_same<Constant, Value>::value ||
                                        std::is_arithmetic<Constant>::value>;

    Forward() = default;

    /// As those of DerivativeVector: GCC would copy the value and what lies
    /// unused behind it at once, and wait for the value to be stored.
    Forward(const Forward &b)
      : value(b.value)
      , derivatives(b.derivatives)
    {}

    Forward &
    operator=(const Forward &b)
    {
      value       = b.value;
      derivatives = b.derivatives;
      return *this;
    }

    /// A constant. Implicit, because constants mix freely with numbers.
    template <typename Constant, typename = IfConstant<Constant>>
    Forward(const Constant &value)
      : value(value)
      , derivatives(DerivativeVector<n, Value>::zero())
    {}

    Forward(const Value &value, const DerivativeVector<n, Value> &derivatives)
      : value(value)
      , derivatives(derivatives)
    {}

    /// The input number @p place at the value @p value.
    static Forward
    input(const Value &value, const unsigned int place)
    {
      return {value, DerivativeVector<n, Value>::unit(place)};
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

    template <typename Constant, typename = IfConstant<Constant>>
    friend Forward
    operator+(const Forward &a, const Constant &b)
    {
      return {a.value + b, a.derivatives};
    }

    template <typename Constant, typename = IfConstant<Constant>>
    friend Forward
    operator+(const Constant &a, const Forward &b)
    {
      return {a + b.value, b.derivatives};
    }

    friend Forward
    operator-(const Forward &a, const Forward &b)
    {
      return {a.value - b.value, a.derivatives - b.derivatives};
    }

    template <typename Constant, typename = IfConstant<Constant>>
    friend Forward
    operator-(const Forward &a, const Constant &b)
    {
      return {a.value - b, a.derivatives};
    }

    template <typename Constant, typename = IfConstant<Constant>>
    friend Forward
    operator-(const Constant &a, const Forward &b)
    {
      return {a - b.value, -b.derivatives};
    }

    friend Forward
    operator*(const Forward &a, const Forward &b)
    {
      return {a.value * b.value,
              weighted_sum(a.derivatives, b.value, b.derivatives, a.value)};
    }

    template <typename Constant, typename = IfConstant<Constant>>
    friend Forward
    operator*(const Forward &a, const Constant &b)
    {
      return {a.value * b, a.derivatives * b};
    }

    template <typename Constant, typename = IfConstant<Constant>>
    friend Forward
    operator*(const Constant &a, const Forward &b)
    {
      return {a * b.value, b.derivatives * a};
    }

    friend Forward
    operator/(const Forward &a, const Forward &b)
    {
      const Value inverse  = 1. / b.value;
      const Value quotient = a.value * inverse;
      return {quotient,
              weighted_sum(
                a.derivatives, inverse, b.derivatives, -(quotient * inverse))};
    }

    template <typename Constant, typename = IfConstant<Constant>>
    friend Forward
    operator/(const Forward &a, const Constant &b)
    {
      return a * Value(1. / b);
    }

    template <typename Constant, typename = IfConstant<Constant>>
    friend Forward
    operator/(const Constant &a, const Forward &b)
    {
      const Value inverse  = 1. / b.value;
      const Value quotient = a * inverse;
      return {quotient, b.derivatives * (-quotient * inverse)};
    }
  };

  /// The value of a number, for decisions that are not differentiated.
  inline double
  value_of(const double x)
  {
    return x;
  }

  template <int n, typename Value>
  Value
  value_of(const Forward<n, Value> &x)
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

  template <int n, typename Value>
  Forward<n, Value>
  chain_rule(const Forward<n, Value> &x, const Value &value, const Value &slope)
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

  template <int n, typename Value>
  Forward<n, Value>
  only_derivatives(const Forward<n, Value> &x)
  {
    return {Value(0.), x.derivatives};
  }

  template <int n, typename Value>
  Forward<n, Value>
  sqrt(const Forward<n, Value> &x)
  {
    using std::sqrt;
    const Value root = sqrt(x.value);
    return chain_rule(x, root, Value(.5 / root));
  }

  template <int n, typename Value>
  Forward<n, Value>
  pow(const Forward<n, Value> &x, const double exponent)
  {
    using std::pow;
    const Value power = pow(x.value, exponent);
    return chain_rule(x, power, Value(exponent * power / x.value));
  }

  template <int n, typename Value>
  Forward<n, Value>
  exp(const Forward<n, Value> &x)
  {
    using std::exp;
    const Value exponential = exp(x.value);
    return chain_rule(x, exponential, exponential);
  }

  template <int n, typename Value>
  Forward<n, Value>
  log(const Forward<n, Value> &x)
  {
    using std::log;
    return chain_rule(x, log(x.value), Value(1. / x.value));
  }

  /// log(1 + x), exact for small x
  template <int n, typename Value>
  Forward<n, Value>
  log1p(const Forward<n, Value> &x)
  {
    using std::log1p;
    return chain_rule(x, log1p(x.value), Value(1. / (1. + x.value)));
  }

  template <int n, typename Value>
  Forward<n, Value>
  sin(const Forward<n, Value> &x)
  {
    return chain_rule(x, std::sin(x.value), std::cos(x.value));
  }

  template <int n, typename Value>
  Forward<n, Value>
  cos(const Forward<n, Value> &x)
  {
    return chain_rule(x, std::cos(x.value), -std::sin(x.value));
  }
} // namespace Riedel::Continuum
