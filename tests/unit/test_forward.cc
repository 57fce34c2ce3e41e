// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/continuum/forward.h>
#include <riedel/continuum/lanes.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <complex>

using namespace Riedel::Continuum;

namespace
{
  // Every operation of Forward at once. The same text with complex numbers
  // gives derivatives by the complex step, without cancellation.
  template <typename Number>
  Number
  everything(const Number &x, const Number &y)
  {
    using std::cos;
    using std::exp;
    using std::log;
    using std::pow;
    using std::sin;
    using std::sqrt;
    Number z = (x * y - 2. * x + y * 3. - 1.) / (x + y);
    z += sqrt(x * x + y * y) - pow(y, .3) * exp(-x) + 1. / (2. + y);
    z += log(x + 2. * y) * sin(x) - cos(y) / 4. + (5. - x) * (.5 + y);
    return -z;
  }

  template <int n>
  void
  compare(const double x, const double y)
  {
    const Forward<n> result =
      everything(Forward<n>::input(x, 1), input<Forward<n>>(y, n - 1));

    using Complex     = std::complex<double>;
    const double step = 1e-30;
    CHECK(result.value == Approx(everything(x, y)).epsilon(1e-15));
    CHECK(result.derivatives[1] ==
          Approx(everything(Complex(x, step), Complex(y)).imag() / step)
            .epsilon(1e-14));
    CHECK(result.derivatives[n - 1] ==
          Approx(everything(Complex(x), Complex(y, step)).imag() / step)
            .epsilon(1e-14));
    CHECK(result.derivatives[0] == 0.);
  }
} // namespace



TEST_CASE("forward numbers differentiate exactly", "[unit][forward]")
{
  for (const double x : {.3, 1.2, 4.})
    for (const double y : {.01, .7, 2.5})
      {
        compare<4>(x, y);
        compare<8>(x, y);
      }
}



TEST_CASE("forward numbers: log1p and helpers", "[unit][forward]")
{
  const Forward<4> x = Forward<4>::input(1e-12, 2);
  CHECK(log1p(x).value == Approx(1e-12 - .5e-24).epsilon(1e-15));
  CHECK(log1p(x).derivatives[2] == Approx(1.).epsilon(1e-11));

  CHECK(value_of(x) == 1e-12);
  CHECK(value_of(2.) == 2.);
  CHECK(only_derivatives(x).value == 0.);
  CHECK(only_derivatives(x).derivatives[2] == 1.);
  CHECK(only_derivatives(3.) == 0.);
  CHECK(chain_rule(x, 5., 7.).value == 5.);
  CHECK(chain_rule(x, 5., 7.).derivatives[2] == 7.);
}



TEST_CASE("forward numbers of several points are those of each",
          "[unit][forward][lanes]")
{
  // without sin, cos, which Lanes do not have
  const auto function = [](const auto &x, const auto &y) {
    using std::exp;
    using std::log;
    using std::log1p;
    using std::pow;
    using std::sqrt;
    auto z = (x * y - 2. * x + y * 3. - 1.) / (x + y);
    z += sqrt(x * x + y * y) - pow(y, .3) * exp(-x) + 1. / (2. + y);
    z += log(x + 2. * y) + log1p(x) / 4. + (5. - x) * (.5 + y);
    return -z;
  };
  using Value  = Lanes<4>;
  using Number = Forward<7, Value>;
  Value x, y;
  for (unsigned int lane = 0; lane < 4; ++lane)
    {
      x.values[lane] = .3 + lane;
      y.values[lane] = 2.5 - .7 * lane;
    }
  const Number all = function(Number::input(x, 1), Number::input(y, 6));
  // constants of lanes, and a choice by lanes
  const Number chosen = select(x > Value(2.), all, x * all + y - all / x);
  for (unsigned int lane = 0; lane < 4; ++lane)
    {
      const double     v = x[lane];
      const Forward<8> one =
        function(Forward<8>::input(v, 1), Forward<8>::input(y[lane], 6));
      const Forward<8> choice = v > 2. ? one : v * one + y[lane] - one / v;
      CHECK(all.value[lane] == Approx(one.value).epsilon(1e-15));
      CHECK(chosen.value[lane] == Approx(choice.value).epsilon(1e-15));
      for (unsigned int i = 0; i < 7; ++i)
        {
          CHECK(all.derivatives[i][lane] ==
                Approx(one.derivatives[i]).epsilon(1e-14));
          CHECK(chosen.derivatives[i][lane] ==
                Approx(choice.derivatives[i]).epsilon(1e-14));
        }
    }
}
