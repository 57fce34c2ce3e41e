// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/continuum/lanes.h>
#include <riedel/continuum/step_kinematics.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

using namespace Riedel::Continuum;

namespace
{
  constexpr double infinite     = std::numeric_limits<double>::infinity();
  constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

  template <int n>
  Lanes<n>
  lanes_of(const std::array<double, n> &values)
  {
    Lanes<n> lanes;
    for (int lane = 0; lane < n; ++lane)
      lanes.values[lane] = values[lane];
    return lanes;
  }

  /// Largest relative error of @p function against @p exact, which computes
  /// with long doubles, at random places between two ends.
  template <int n, typename Function, typename Exact>
  double
  worst_error(const Function &function,
              const Exact    &exact,
              const double    from,
              const double    to)
  {
    std::mt19937                     generator(7);
    std::uniform_real_distribution<> uniform(from, to);
    double                           worst = 0.;
    for (unsigned int sample = 0; sample < 20000; ++sample)
      {
        std::array<double, n> x;
        for (double &value : x)
          value = uniform(generator);
        const Lanes<n> found = function(lanes_of<n>(x));
        for (int lane = 0; lane < n; ++lane)
          {
            const long double wanted = exact(static_cast<long double>(x[lane]));
            const long double error  = (found[lane] - wanted) / wanted;
            worst = std::max(worst, static_cast<double>(std::abs(error)));
          }
      }
    return worst;
  }

  template <int n>
  void
  check_functions()
  {
    using Number = Lanes<n>;
    using Long   = long double;

    const auto exponential       = [](const Number &x) { return exp(x); };
    const auto exact_exponential = [](const Long x) { return std::exp(x); };
    for (const double range : {1e-8, 1e-3, .4, 1., 20., 708.})
      {
        INFO("exp up to " << range);
        CHECK(worst_error<n>(exponential, exact_exponential, -range, range) <
              2.5e-16);
      }

    const auto logarithm       = [](const Number &x) { return log(x); };
    const auto exact_logarithm = [](const Long x) { return std::log(x); };
    for (const auto &[from, to] : std::vector<std::pair<double, double>>{
           {1e-300, 1e-299}, {1e-3, .1}, {.1, 3.}, {.999, 1.001}, {3., 1e200}})
      {
        INFO("log from " << from << " to " << to);
        CHECK(worst_error<n>(logarithm, exact_logarithm, from, to) < 3e-16);
      }

    const auto logarithm_1       = [](const Number &x) { return log1p(x); };
    const auto exact_logarithm_1 = [](const Long x) { return std::log1p(x); };
    for (const double range : {1e-20, 1e-12, 1e-6, 1e-3, .1, .5})
      {
        INFO("log1p up to " << range);
        CHECK(worst_error<n>(logarithm_1, exact_logarithm_1, -range, range) <
              4e-16);
      }

    // the density factor, and the compression law at small pressures
    for (const double exponent : {.05, .1, .3, .5, 1.})
      {
        const auto power = [&](const Number &x) { return pow(x, exponent); };
        const auto exact_power = [&](const Long x) {
          return std::pow(x, static_cast<Long>(exponent));
        };
        INFO("power " << exponent);
        CHECK(worst_error<n>(power, exact_power, .01, .1) < 1e-15);
        CHECK(worst_error<n>(power, exact_power, .1, 3.) < 1e-15);
        CHECK(worst_error<n>(power, exact_power, 1e-7, 1e-5) < 2e-15);
      }

    const auto third_root       = [](const Number &x) { return cbrt(x); };
    const auto exact_third_root = [](const Long x) { return std::cbrt(x); };
    CHECK(worst_error<n>(third_root, exact_third_root, 1e-30, 1e-29) < 1e-14);
    CHECK(worst_error<n>(third_root, exact_third_root, .001, 10.) < 1e-15);
  }

  template <int n>
  void
  check_ends()
  {
    const auto at = [](const double x) { return Lanes<n>(x); };
    CHECK(exp(at(0.))[n - 1] == 1.);
    CHECK(exp(at(750.))[0] == infinite);
    CHECK(exp(at(infinite))[0] == infinite);
    CHECK(exp(at(-750.))[0] == 0.);
    CHECK(exp(at(-infinite))[0] == 0.);
    CHECK(std::isnan(exp(at(not_a_number))[0]));
    CHECK(log(at(1.))[n - 1] == 0.);
    for (const double x : {0., -0., -1., infinite, not_a_number, 1e-310})
      CHECK(std::isnan(log(at(x))[0]));
    CHECK(pow(at(1.), .3)[0] == 1.);
    CHECK(log1p(at(0.))[0] == 0.);
    CHECK(std::isnan(log1p(at(-1.))[0]));
    CHECK(std::isnan(sqrt(at(-1.))[0]));
  }

  template <int n>
  void
  check_decisions()
  {
    std::array<double, n> values;
    for (int lane = 0; lane < n; ++lane)
      values[lane] = lane - 1.;
    values[n - 1]      = not_a_number;
    const Lanes<n> x   = lanes_of<n>(values);
    const Mask<n>  low = x < Lanes<n>(.5);

    CHECK(any(low));
    CHECK_FALSE(all(low));
    CHECK_FALSE(any(low && !low));
    CHECK(all(low || !low));
    CHECK(all(Mask<n>(true)));
    CHECK_FALSE(any(Mask<n>(false)));

    const Lanes<n> chosen  = select(low, 2. * x, Lanes<n>(7.));
    const Lanes<n> largest = max(x, Lanes<n>(0.));
    const Lanes<n> least   = min(x, Lanes<n>(0.));
    const Lanes<n> root    = sqrt(abs(x));
    for (int lane = 0; lane < n - 1; ++lane)
      {
        const double v = values[lane];
        CHECK(low[lane] == (v < .5));
        CHECK((x <= Lanes<n>(0.))[lane] == (v <= 0.));
        CHECK((x > Lanes<n>(0.))[lane] == (v > 0.));
        CHECK((x >= Lanes<n>(0.))[lane] == (v >= 0.));
        CHECK((x == Lanes<n>(0.))[lane] == (v == 0.));
        CHECK(chosen[lane] == (v < .5 ? 2. * v : 7.));
        CHECK(largest[lane] == std::max(v, 0.));
        CHECK(least[lane] == std::min(v, 0.));
        CHECK(root[lane] == std::sqrt(std::abs(v)));
        CHECK(is_finite(x)[lane]);
      }
    CHECK_FALSE(low[n - 1]);
    CHECK_FALSE((x == x)[n - 1]);
    CHECK_FALSE(is_finite(x)[n - 1]);
    CHECK_FALSE(is_finite(Lanes<n>(-infinite))[0]);
  }
} // namespace



TEST_CASE("functions of lanes are exact to rounding", "[unit][lanes]")
{
  check_functions<4>();
  check_functions<8>();
  check_ends<4>();
  check_ends<8>();
}



TEST_CASE("decisions are made for each lane", "[unit][lanes]")
{
  check_decisions<4>();
  check_decisions<8>();

  CHECK(any(true));
  CHECK_FALSE(all(false));
  CHECK(select(true, 1., 2.) == 1.);
  CHECK(select(false, 1., 2.) == 2.);
}



TEST_CASE("a lane does not depend on its neighbours", "[unit][lanes]")
{
  // the same number everywhere and between numbers that overflow
  const std::array<double, 8> mixed{
    {1e308, .37, -1e308, 0., not_a_number, .37, infinite, 1e-310}};
  const Lanes<8> alone(.37), among = lanes_of<8>(mixed);
  for (const unsigned int lane : {1u, 5u})
    {
      CHECK(exp(among)[lane] == exp(alone)[lane]);
      CHECK(log(among)[lane] == log(alone)[lane]);
      CHECK(log1p(among)[lane] == log1p(alone)[lane]);
      CHECK(pow(among, .3)[lane] == pow(alone, .3)[lane]);
      CHECK((1. / among)[lane] == (1. / alone)[lane]);
    }
}



TEST_CASE("kinematics of several points at once", "[unit][lanes][kinematics]")
{
  using Number = Lanes<8>;
  std::mt19937                     generator(11);
  std::uniform_real_distribution<> uniform(-1., 1.);
  for (const double size : {1e-9, 1e-4, 1e-2, .2, 2.})
    for (unsigned int sample = 0; sample < 50; ++sample)
      {
        std::array<Number, 4> H;
        for (Number &component : H)
          for (unsigned int lane = 0; lane < 8; ++lane)
            component.values[lane] = size * uniform(generator);
        const StepKinematics<Number> kinematics(H.data());
        for (unsigned int lane = 0; lane < 8; ++lane)
          {
            const std::array<double, 4> single{
              {H[0][lane], H[1][lane], H[2][lane], H[3][lane]}};
            const StepKinematics<double> expected(single.data());
            // large steps are left to double
            CHECK((size < .1 || !kinematics.valid[lane] || expected.valid));
            CHECK((size > .1 || kinematics.valid[lane]));
            if (!kinematics.valid[lane])
              continue;
            const double margin = 1e-15 * size;
            CHECK(kinematics.j[lane] == Approx(expected.j).epsilon(1e-15));
            CHECK(kinematics.log_j[lane] ==
                  Approx(expected.log_j).epsilon(1e-15).margin(margin));
            CHECK(kinematics.log_f.shear[lane] ==
                  Approx(expected.log_f.shear).epsilon(1e-14).margin(margin));
            CHECK(kinematics.log_f.turn[lane] ==
                  Approx(expected.log_f.turn).epsilon(1e-14).margin(margin));
          }
      }
}
