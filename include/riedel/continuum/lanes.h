// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/continuum/forward.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

#ifdef __SSE2__
#  include <immintrin.h>
#endif

namespace Riedel::Continuum
{
  /// n doubles as one vector of the compiler's own; n is 4 or 8.
  template <int n>
  struct VectorOfDoubles;

  template <>
  struct VectorOfDoubles<4>
  {
    typedef double type __attribute__((vector_size(4 * sizeof(double))));
  };

  template <>
  struct VectorOfDoubles<8>
  {
    typedef double type __attribute__((vector_size(8 * sizeof(double))));
  };

  /// n whole numbers as wide as a double, for the bits of n doubles.
  template <int n>
  struct VectorOfBits;

  template <>
  struct VectorOfBits<4>
  {
    typedef std::uint64_t type
      __attribute__((vector_size(4 * sizeof(std::uint64_t))));
  };

  template <>
  struct VectorOfBits<8>
  {
    typedef std::uint64_t type
      __attribute__((vector_size(8 * sizeof(std::uint64_t))));
  };



  /**
   * What the compiler's own vectors lack, for n doubles in one vector of the
   * processor that is compiled for: roots, and the signs as the bits of a
   * whole number.
   */
  template <int n>
  struct ProcessorVector;

  template <>
  struct ProcessorVector<1>
  {
    using type = double;

    static double
    sqrt(const double x)
    {
      return std::sqrt(x);
    }

    static int
    signs(const double x)
    {
      return std::signbit(x);
    }
  };

#ifdef __SSE2__
  template <>
  struct ProcessorVector<2>
  {
    using type = __m128d;

    static type
    sqrt(const type &x)
    {
      return _mm_sqrt_pd(x);
    }

    static int
    signs(const type &x)
    {
      return _mm_movemask_pd(x);
    }
  };
#endif

#ifdef __AVX__
  template <>
  struct ProcessorVector<4>
  {
    using type = __m256d;

    static type
    sqrt(const type &x)
    {
      return _mm256_sqrt_pd(x);
    }

    static int
    signs(const type &x)
    {
      return _mm256_movemask_pd(x);
    }
  };
#endif

#ifdef __AVX512F__
  template <>
  struct ProcessorVector<8>
  {
    using type = __m512d;

    static type
    sqrt(const type &x)
    {
      // with all lanes wanted; the plain form warns in GCC 12
      return _mm512_maskz_sqrt_pd(0xff, x);
    }

    static int
    signs(const type &x)
    {
      return _mm512_cmplt_epi64_mask(_mm512_castpd_si512(x),
                                     _mm512_setzero_si512());
    }
  };
#endif

  /// number of doubles in the longest vector of the processor
#if defined(__AVX512F__)
  constexpr int n_processor_doubles = 8;
#elif defined(__AVX__)
  constexpr int n_processor_doubles = 4;
#elif defined(__SSE2__)
  constexpr int n_processor_doubles = 2;
#else
  constexpr int n_processor_doubles = 1;
#endif

  /// How many points are worth to be computed at once.
  constexpr int n_native_lanes = std::max(4, n_processor_doubles);

  /// n doubles as the longest vectors of the processor that fit.
  template <int n>
  struct ProcessorVectors
  {
    static constexpr int n_each = std::min(n, n_processor_doubles);
    using Vector                = ProcessorVector<n_each>;

    typename Vector::type pieces[n / n_each];

    template <typename Doubles>
    explicit ProcessorVectors(const Doubles &doubles)
    {
      static_assert(sizeof(doubles) == sizeof(pieces), "n doubles");
      std::memcpy(&pieces, &doubles, sizeof(pieces));
    }
  };



  /// For every lane, whether something is true: what comparisons of Lanes give.
  template <int n>
  struct Mask
  {
    using Bits    = typename VectorOfBits<n>::type;
    using Doubles = typename VectorOfDoubles<n>::type;

    /// all bits of a lane are one (true) or zero
    Bits bits;

    Mask() = default;

    /// the same for all lanes
    Mask(const bool condition)
      : bits(Bits{} - static_cast<std::uint64_t>(condition))
    {}

    template <typename Comparison>
    static Mask
    of(const Comparison &comparison)
    {
      Mask result;
      result.bits = reinterpret_cast<Bits>(comparison);
      return result;
    }

    bool
    operator[](const unsigned int lane) const
    {
      return bits[lane] != 0;
    }

    friend Mask
    operator!(const Mask &a)
    {
      return of(~a.bits);
    }

    friend Mask
    operator&&(const Mask &a, const Mask &b)
    {
      return of(a.bits & b.bits);
    }

    friend Mask
    operator||(const Mask &a, const Mask &b)
    {
      return of(a.bits | b.bits);
    }
  };



  /**
   * The same number of n points, to compute them at once: every operation acts
   * on every lane alone, and a lane's result does not depend on the others.
   * The lanes are one vector of the compiler's own, which splits it where the
   * processor has shorter ones.
   *
   * A branch that may be taken by some lanes only must be written with
   * select(), any() and all(). These exist for bool, too, where they cost
   * nothing, so that one text serves double, Forward and Lanes.
   */
  template <int n>
  struct Lanes
  {
    using Doubles = typename VectorOfDoubles<n>::type;

    Doubles values;

    Lanes() = default;

    /// A constant. Implicit, because constants mix freely with numbers.
    Lanes(const double value)
      : values(Doubles{} + value)
    {}

    Lanes(const Doubles &values)
      : values(values)
    {}

    double
    operator[](const unsigned int lane) const
    {
      return values[lane];
    }

    Lanes &
    operator+=(const Lanes &b)
    {
      values += b.values;
      return *this;
    }

    friend Lanes
    operator-(const Lanes &a)
    {
      return -a.values;
    }

    friend Lanes
    operator+(const Lanes &a, const Lanes &b)
    {
      return a.values + b.values;
    }

    friend Lanes
    operator-(const Lanes &a, const Lanes &b)
    {
      return a.values - b.values;
    }

    friend Lanes
    operator*(const Lanes &a, const Lanes &b)
    {
      return a.values * b.values;
    }

    friend Lanes
    operator/(const Lanes &a, const Lanes &b)
    {
      return a.values / b.values;
    }

    friend Mask<n>
    operator<(const Lanes &a, const Lanes &b)
    {
      return Mask<n>::of(a.values < b.values);
    }

    friend Mask<n>
    operator<=(const Lanes &a, const Lanes &b)
    {
      return Mask<n>::of(a.values <= b.values);
    }

    friend Mask<n>
    operator>(const Lanes &a, const Lanes &b)
    {
      return Mask<n>::of(a.values > b.values);
    }

    friend Mask<n>
    operator>=(const Lanes &a, const Lanes &b)
    {
      return Mask<n>::of(a.values >= b.values);
    }

    friend Mask<n>
    operator==(const Lanes &a, const Lanes &b)
    {
      return Mask<n>::of(a.values == b.values);
    }
  };

  /// Does Number stand for several points?
  template <typename Number>
  struct IsLanes : std::false_type
  {};

  template <int n>
  struct IsLanes<Lanes<n>> : std::true_type
  {};

  template <int n_derivatives, int n>
  struct IsLanes<Forward<n_derivatives, Lanes<n>>> : std::true_type
  {};

  template <int n>
  Lanes<n>
  value_of(const Lanes<n> &x)
  {
    return x;
  }

  template <int n>
  Lanes<n>
  chain_rule(const Lanes<n> & /*x*/,
             const Lanes<n> &value,
             const Lanes<n> & /*slope*/)
  {
    return value;
  }

  /// What value_of() gives: Number without derivatives.
  template <typename Number>
  using ValueOf = decltype(value_of(std::declval<const Number &>()));

  /// What a comparison of values gives: bool or a Mask.
  template <typename Number>
  using ConditionOf =
    decltype(std::declval<ValueOf<Number>>() < std::declval<ValueOf<Number>>());



  /// Reads rows of numbers, one row for each lane. The last row fills the lanes
  /// beyond the @p n_rows.
  template <int n_lanes, std::size_t n>
  void
  read_rows(const double                  *rows,
            const unsigned int             n_rows,
            std::array<Lanes<n_lanes>, n> &numbers)
  {
    for (unsigned int lane = 0; lane < n_lanes; ++lane)
      {
        const double *row = rows + std::min(lane, n_rows - 1) * n;
        for (unsigned int i = 0; i < n; ++i)
          numbers[i].values[lane] = row[i];
      }
  }

  /// ... as the inputs of a function, in their order
  template <int n_derivatives, int n_lanes, std::size_t n>
  void
  read_rows(const double                                          *rows,
            const unsigned int                                     n_rows,
            std::array<Forward<n_derivatives, Lanes<n_lanes>>, n> &numbers)
  {
    std::array<Lanes<n_lanes>, n> values;
    read_rows(rows, n_rows, values);
    for (unsigned int i = 0; i < n; ++i)
      numbers[i] = Forward<n_derivatives, Lanes<n_lanes>>::input(values[i], i);
  }



  /// Writes the values of a lane and, if the numbers have them, their
  /// derivatives, a row for each number.
  template <typename Number, std::size_t n>
  void
  write_row(const std::array<Number, n>   &numbers,
            const unsigned int             lane,
            double                        *values,
            [[maybe_unused]] double *const derivatives)
  {
    for (unsigned int i = 0; i < n; ++i)
      {
        values[i] = value_of(numbers[i])[lane];
        if constexpr (!std::is_same<Number, ValueOf<Number>>::value)
          for (unsigned int j = 0; j < n; ++j)
            derivatives[i * n + j] = numbers[i].derivatives[j][lane];
      }
  }



  // ---- Decisions

  inline bool
  any(const bool condition)
  {
    return condition;
  }

  inline bool
  all(const bool condition)
  {
    return condition;
  }

  template <typename Number>
  Number
  select(const bool condition, const Number &if_true, const Number &if_false)
  {
    return condition ? if_true : if_false;
  }

  template <int n>
  bool
  any(const Mask<n> &mask)
  {
    using Vectors = ProcessorVectors<n>;
    const Vectors vectors(mask.bits);
    int           signs = 0;
    for (const auto &piece : vectors.pieces)
      signs |= Vectors::Vector::signs(piece);
    return signs != 0;
  }

  template <int n>
  bool
  all(const Mask<n> &mask)
  {
    return !any(!mask);
  }

  template <int n>
  Lanes<n>
  select(const Mask<n> &mask, const Lanes<n> &if_true, const Lanes<n> &if_false)
  {
    using Bits    = typename Mask<n>::Bits;
    using Doubles = typename Mask<n>::Doubles;
    return reinterpret_cast<Doubles>(
      (mask.bits & reinterpret_cast<Bits>(if_true.values)) |
      (~mask.bits & reinterpret_cast<Bits>(if_false.values)));
  }

  template <int n_derivatives, int n>
  Forward<n_derivatives, Lanes<n>>
  select(const Mask<n>                          &mask,
         const Forward<n_derivatives, Lanes<n>> &if_true,
         const Forward<n_derivatives, Lanes<n>> &if_false)
  {
    return {select(mask, if_true.value, if_false.value),
            DerivativeVector<n_derivatives, Lanes<n>>::pieces_of([&](int i) {
              return select(mask,
                            if_true.derivatives[i],
                            if_false.derivatives[i]);
            })};
  }

  /// as std::max: the first where one is not a number
  template <int n>
  Lanes<n>
  max(const Lanes<n> &a, const Lanes<n> &b)
  {
    return select(a < b, b, a);
  }

  /// as std::min
  template <int n>
  Lanes<n>
  min(const Lanes<n> &a, const Lanes<n> &b)
  {
    return select(b < a, b, a);
  }

  template <int n>
  Lanes<n>
  abs(const Lanes<n> &x)
  {
    using Bits    = typename Mask<n>::Bits;
    using Doubles = typename Mask<n>::Doubles;
    return reinterpret_cast<Doubles>(reinterpret_cast<Bits>(x.values) &
                                     ~(std::uint64_t(1) << 63));
  }

  template <int n>
  Mask<n>
  is_finite(const Lanes<n> &x)
  {
    return abs(x) <= Lanes<n>(std::numeric_limits<double>::max());
  }



  // ---- Functions
  //
  // std::exp and its like would have to be called lane by lane, at ten times
  // the cost. The functions below have no branches and are as exact as said,
  // in units of the last place of the result (ulp).

  /// Correctly rounded.
  template <int n>
  Lanes<n>
  sqrt(const Lanes<n> &x)
  {
    using Vectors = ProcessorVectors<n>;
    Vectors vectors(x.values);
    for (auto &piece : vectors.pieces)
      piece = Vectors::Vector::sqrt(piece);
    Lanes<n> result;
    std::memcpy(&result.values, &vectors.pieces, sizeof(vectors.pieces));
    return result;
  }

  /**
   * exp(x) = 2^k exp(r) with k the whole number next to x/ln 2. The remainder
   * r = x - k ln 2, |r| < .35, is exact to rounding because ln 2 is subtracted
   * in two parts, the first of which has so few digits that its product with
   * k is exact (Cody and Waite). exp(r) is its Taylor polynomial of degree 13,
   * whose remainder is below 5e-18. Error below 1 ulp; infinite above
   * 708, zero below -708.
   */
  template <int n>
  Lanes<n>
  exp(const Lanes<n> &x)
  {
    using Bits    = typename Mask<n>::Bits;
    using Doubles = typename Mask<n>::Doubles;

    constexpr double ln_2_high = 6.93147180369123816490e-01;
    constexpr double ln_2_low  = 1.90821492927058770002e-10;
    constexpr double inverse   = 1.44269504088896338700e+00;
    // A number whose last place is one: adding it rounds to whole numbers,
    // and leaves them in its last bits.
    constexpr double rounder = 6755399441055744.; // 1.5 * 2^52

    const Doubles shifted = x.values * inverse + rounder;
    const Doubles k       = shifted - rounder;
    const Doubles r       = (x.values - k * ln_2_high) - k * ln_2_low;

    // (exp(r) - 1 - r)/r^2, by pairs of terms to shorten the chain of
    // operations that wait for each other
    const Doubles r2 = r * r;
    const Doubles r4 = r2 * r2;
    const Doubles p0 =
      (1. / 2 + r * (1. / 6)) + r2 * (1. / 24 + r * (1. / 120));
    const Doubles p4 =
      (1. / 720 + r * (1. / 5040)) + r2 * (1. / 40320 + r * (1. / 362880));
    const Doubles p8 = (1. / 3628800 + r * (1. / 39916800)) +
                       r2 * (1. / 479001600 + r * (1. / 6227020800.));
    const Doubles mantissa = 1. + (r + r2 * (p0 + r4 * (p4 + r4 * p8)));

    const Bits     power = (reinterpret_cast<Bits>(shifted) + 1023) << 52;
    const Lanes<n> result(mantissa * reinterpret_cast<Doubles>(power));
    const double   largest = 708.;
    return select(x > Lanes<n>(largest),
                  Lanes<n>(std::numeric_limits<double>::infinity()),
                  select(x < Lanes<n>(-largest), Lanes<n>(0.), result));
  }

  /**
   * log(x) = k ln 2 + log(1 + f) with 1 + f between sqrt(1/2) and sqrt(2). With
   * s = f/(2 + f), log(1 + f) = 2 artanh s is an odd series in s; its
   * polynomial and the order of summation are those of fdlibm (Sun
   * Microsystems, 1993). Error below 1 ulp. For positive normal numbers:
   * everything else gives NaN.
   */
  template <int n>
  Lanes<n>
  log(const Lanes<n> &x)
  {
    using Bits    = typename Mask<n>::Bits;
    using Doubles = typename Mask<n>::Doubles;

    constexpr double        ln_2_high     = 6.93147180369123816490e-01;
    constexpr double        ln_2_low      = 1.90821492927058770002e-10;
    constexpr std::uint64_t root_half     = 0x3fe6a09e667f3bcd;
    constexpr std::uint64_t mantissa_bits = (std::uint64_t(1) << 52) - 1;
    // the bits of 2^52: a whole number in the last bits adds itself
    constexpr std::uint64_t bits_of_2_52 = 0x4330000000000000;

    // The exponent of x/sqrt(1/2) is k. It is kept positive by adding 2048.
    const Bits shifted =
      reinterpret_cast<Bits>(x.values) - root_half + (std::uint64_t(1) << 63);
    const Doubles k =
      reinterpret_cast<Doubles>((shifted >> 52) | bits_of_2_52) -
      (4503599627370496. + 2048.);
    const Doubles f =
      reinterpret_cast<Doubles>((shifted & mantissa_bits) + root_half) - 1.;

    const Doubles s  = f / (2. + f);
    const Doubles s2 = s * s;
    const Doubles s4 = s2 * s2;
    const Doubles even =
      s4 * (3.999999999940941908e-01 +
            s4 * (2.222219843214978396e-01 + s4 * 1.531383769920937332e-01));
    const Doubles odd =
      s2 *
      (6.666666666666735130e-01 +
       s4 * (2.857142874366239149e-01 +
             s4 * (1.818357216161805012e-01 + s4 * 1.479819860511658591e-01)));
    const Doubles  half_square = .5 * f * f;
    const Lanes<n> result(
      k * ln_2_high -
      ((half_square - (s * (half_square + (even + odd)) + k * ln_2_low)) - f));
    return select(x >= Lanes<n>(std::numeric_limits<double>::min()) &&
                    is_finite(x),
                  result,
                  Lanes<n>(std::numeric_limits<double>::quiet_NaN()));
  }

  /// log(1 + x), exact for small x, too: what 1 + x loses by rounding is added
  /// to the first order. Error below 2 ulp for |x| < 1/2.
  template <int n>
  Lanes<n>
  log1p(const Lanes<n> &x)
  {
    const Lanes<n> sum = 1. + x;
    return log(sum) + (x - (sum - 1.)) / sum;
  }

  /// exp(exponent log(x)): relative error below 1.5e-16 (2 + |log x^exponent|).
  /// For positive normal numbers as log().
  template <int n>
  Lanes<n>
  pow(const Lanes<n> &x, const double exponent)
  {
    return exp(exponent * log(x));
  }

  /// For positive normal numbers; errors as of pow().
  template <int n>
  Lanes<n>
  cbrt(const Lanes<n> &x)
  {
    return pow(x, 1. / 3.);
  }
} // namespace Riedel::Continuum
