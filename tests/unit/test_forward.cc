// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/continuum/forward.h>

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
