// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/continuum/step_kinematics.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <random>

using namespace Riedel::Continuum;

namespace
{
  using Long   = long double;
  using Matrix = std::array<Long, 4>; // 11, 12, 21, 22

  Matrix
  product(const Matrix &a, const Matrix &b)
  {
    return {{a[0] * b[0] + a[1] * b[2],
             a[0] * b[1] + a[1] * b[3],
             a[2] * b[0] + a[3] * b[2],
             a[2] * b[1] + a[3] * b[3]}};
  }

  /// exp(L) - I by scaling and a Taylor series in extended precision
  Matrix
  exponential_less_identity(Matrix L)
  {
    const int doublings = 12;
    for (Long &component : L)
      component /= std::pow(2.L, doublings);
    Matrix sum{}, term{{1, 0, 0, 1}};
    for (int i = 1; i < 25; ++i)
      {
        term = product(term, L);
        for (int c = 0; c < 4; ++c)
          {
            term[c] /= i;
            sum[c] += term[c];
          }
      }
    // (I + s)^2 - I = 2 s + s s
    for (int d = 0; d < doublings; ++d)
      {
        const Matrix square = product(sum, sum);
        for (int c = 0; c < 4; ++c)
          sum[c] = 2 * sum[c] + square[c];
      }
    return sum;
  }

  std::array<double, 4>
  logarithm(const std::array<double, 4> &H)
  {
    const StepKinematics<double> kinematics(H.data());
    REQUIRE(kinematics.valid);
    return kinematics.log_f.components();
  }
} // namespace



TEST_CASE("log f is exact to rounding, for steps of any size",
          "[unit][kinematics]")
{
  std::mt19937                     generator(3);
  std::uniform_real_distribution<> uniform(-1., 1.);
  for (const double size : {1e-14, 1e-9, 1e-6, 1e-4, 1e-3, 1e-2, .1, .5})
    {
      double worst = 0.;
      for (unsigned int sample = 0; sample < 300; ++sample)
        {
          Matrix L{};
          for (Long &component : L)
            component = size * uniform(generator);
          const Matrix          H_exact = exponential_less_identity(L);
          std::array<double, 4> H;
          for (int c = 0; c < 4; ++c)
            H[c] = static_cast<double>(H_exact[c]);
          const std::array<double, 4> found = logarithm(H);
          for (int c = 0; c < 4; ++c)
            worst =
              std::max(worst, std::abs(found[c] - static_cast<double>(L[c])));
        }
      INFO("size " << size << ", error " << worst);
      // a few roundings of the largest component, never of one
      CHECK(worst < 2e-15 * size);
    }
}



TEST_CASE("log f of a rotation is the angle", "[unit][kinematics]")
{
  for (const double angle :
       {1e-10, 1e-3, .03, .06, .5, 1.5707963267948966, 2.5, 3.1, -1.2, -3.})
    {
      const double                s = std::sin(angle);
      const double                c = -2. * std::pow(std::sin(angle / 2), 2);
      const std::array<double, 4> L = logarithm({{c, -s, s, c}});
      INFO("angle " << angle);
      CHECK(L[2] == Approx(angle).epsilon(1e-13));
      CHECK(L[1] == Approx(-angle).epsilon(1e-13));
      CHECK(std::abs(L[0]) < 1e-15);
      CHECK(std::abs(L[3]) < 1e-15);
    }
}



TEST_CASE("steps without a logarithm are refused", "[unit][kinematics]")
{
  const auto valid = [](const std::array<double, 4> &H) {
    return StepKinematics<double>(H.data()).valid;
  };
  CHECK(valid({{0., 0., 0., 0.}}));
  CHECK_FALSE(valid({{-1., 0., 0., 0.}}));   // no volume
  CHECK_FALSE(valid({{-2.5, 0., 0., 0.}}));  // inside out
  CHECK_FALSE(valid({{-2., 0., 0., -2.}}));  // half a turn
  CHECK_FALSE(valid({{-3., 0., 0., -2.5}})); // two negative eigenvalues
  CHECK_FALSE(valid({{NAN, 0., 0., 0.}}));
}



TEST_CASE("derivatives of log f against differences", "[unit][kinematics]")
{
  using Number = Forward<4>;
  std::mt19937                     generator(5);
  std::uniform_real_distribution<> uniform(-1., 1.);
  for (const double size : {1e-4, .03, .3, .9})
    for (unsigned int sample = 0; sample < 50; ++sample)
      {
        std::array<double, 4> H;
        for (double &component : H)
          component = size * uniform(generator);
        Number inputs[4];
        for (int i = 0; i < 4; ++i)
          inputs[i] = Number::input(H[i], i);
        const StepKinematics<Number> kinematics(inputs);
        if (!kinematics.valid || value_of(kinematics.j) < .1)
          continue;
        const auto log_f = kinematics.log_f.components();
        for (int b = 0; b < 4; ++b)
          {
            const double step = 1e-6;
            auto         plus = H, minus = H;
            plus[b] += step;
            minus[b] -= step;
            const auto up = logarithm(plus), down = logarithm(minus);
            for (int a = 0; a < 4; ++a)
              CHECK(log_f[a].derivatives[b] ==
                    Approx((up[a] - down[a]) / (2. * step))
                      .epsilon(1e-6)
                      .margin(1e-7));
          }
      }
}



TEST_CASE("curvature and nominal stresses", "[unit][kinematics]")
{
  const double H[]     = {.1, -.2, .3, .05};
  const double Gamma[] = {2., -3.};
  // k (I + f)/2 = Gamma
  const auto k = StepKinematics<double>::curvature(H, Gamma);
  CHECK(k[0] * (1. + H[0] / 2) + k[1] * H[2] / 2 == Approx(Gamma[0]));
  CHECK(k[0] * H[1] / 2 + k[1] * (1. + H[3] / 2) == Approx(Gamma[1]));

  // P f^T = j sigma, M f^T = j m
  const StepKinematics<double> kinematics(H);
  const double                 f[] = {1.1, -.2, .3, 1.05};
  CHECK(kinematics.j == Approx(f[0] * f[3] - f[1] * f[2]));
  const std::array<double, 4> sigma{{1., 2., 3., 4.}};
  const auto                  P = kinematics.nominal(sigma);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      CHECK(P[2 * i] * f[2 * j] + P[2 * i + 1] * f[2 * j + 1] ==
            Approx(kinematics.j * sigma[2 * i + j]));
  const auto M = kinematics.nominal(std::array<double, 2>{{5., 6.}});
  CHECK(M[0] * f[0] + M[1] * f[1] == Approx(kinematics.j * 5.));
  CHECK(M[0] * f[2] + M[1] * f[3] == Approx(kinematics.j * 6.));
}



TEST_CASE("small angles turn exactly", "[unit][kinematics]")
{
  for (const double angle : {0., 1e-8, -1e-3, .0499, .0501, -1., 3.})
    {
      CHECK(std::abs(turn(angle).sine - std::sin(angle)) < 2e-16);
      CHECK(std::abs(turn(angle).cosine - std::cos(angle)) < 3e-16);
    }

  const PlaneRotation<double> rotation(.4);
  const PlaneTensor<double>   A{1., 2., 3., 4.};
  const auto                  fixed = A.to_fixed_frame(rotation);
  const double                c = std::cos(.4), s = std::sin(.4);
  const auto                  a = A.components(), b = fixed.components();
  // (R A R^T)_11 and _12
  CHECK(b[0] == Approx(c * c * a[0] - c * s * (a[1] + a[2]) + s * s * a[3]));
  CHECK(b[1] == Approx(c * c * a[1] + c * s * (a[0] - a[3]) - s * s * a[2]));
  const auto back = fixed.to_turned_frame(rotation).components();
  for (int i = 0; i < 4; ++i)
    CHECK(back[i] == Approx(a[i]));
}
