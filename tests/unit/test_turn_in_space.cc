// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/continuum/newton.h>
#include <riedel/continuum/turn_in_space.h>

#include <deal.II/base/quadrature_lib.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

using namespace Riedel::Continuum;

namespace
{
  using Vector = std::array<double, 3>;

  Vector
  random_vector(std::mt19937 &generator, const double size)
  {
    std::normal_distribution<> normal;
    Vector                     v;
    for (double &component : v)
      component = normal(generator);
    const double length = std::hypot(v[0], v[1], v[2]);
    for (double &component : v)
      component *= size / length;
    return v;
  }

  /// exp(s A) - I by the power series
  SpaceTensor<3, double>
  rotation_by_series(const Vector &theta, const double s = 1.)
  {
    SpaceTensor<3, double> A;
    A.components.fill(0.);
    for (unsigned int k = 0; k < 3; ++k)
      {
        A((k + 2) % 3, (k + 1) % 3) = s * theta[k];
        A((k + 1) % 3, (k + 2) % 3) = -s * theta[k];
      }
    return exponential_minus_one(A);
  }

  double
  largest_difference(const SpaceTensor<3, double> &a,
                     const SpaceTensor<3, double> &b)
  {
    return largest_value((a - b).components);
  }

  const std::array<double, 8> angles{
    {1e-9, 1e-4, .1, .499999, .500001, 1., 3.14, 6.5}};
} // namespace



TEST_CASE("factors of a rotation, by series and in closed form", "[unit]")
{
  for (const double t : {1e-6, 1e-3, .1, .3, .4999, .5001, 1., 2., 3.1, 6.})
    {
      const long double x = t, q = x * x;
      const long double s = std::sin(x) / x, half = std::sin(x / 2);
      const long double c = 2 * half * half / q;
      // (t - sin t)/t^3 by as many terms as it takes
      long double d = 0, term = 1.L / 6;
      for (int k = 0; k < 40; ++k)
        {
          d += term;
          term *= -q / ((2 * k + 4.L) * (2 * k + 5.L));
        }
      const TurnFactors at(t * t);
      INFO("t = " << t);
      CHECK(at.factors[0] == Approx(static_cast<double>(s)).epsilon(1e-14));
      CHECK(at.factors[1] == Approx(static_cast<double>(c)).epsilon(1e-14));
      CHECK(at.factors[2] == Approx(static_cast<double>(d)).epsilon(1e-13));
      const double      h = 1e-4 * t * t;
      const TurnFactors above(t * t + h), below(t * t - h);
      for (unsigned int i = 0; i < 3; ++i)
        CHECK(at.slopes[i] ==
              Approx((above.factors[i] - below.factors[i]) / (2 * h))
                .epsilon(1e-6)
                .margin(1e-11 / (t * t)));
    }
}



TEST_CASE("rotation and tangent of a rotation vector", "[unit]")
{
  std::mt19937 generator(3);
  for (const double angle : angles)
    for (unsigned int sample = 0; sample < 10; ++sample)
      {
        const Vector              theta = random_vector(generator, angle);
        const TurnInSpace<double> turn(theta.data());
        INFO("angle " << angle);
        CHECK(largest_difference(turn.rotation, rotation_by_series(theta)) <
              1e-14 * std::max(angle, 1e-2));

        // T is the mean of exp(s A) over 0 < s < 1
        const dealii::QGauss<1> points(20);
        SpaceTensor<3, double>  mean;
        mean.components.fill(0.);
        for (unsigned int q = 0; q < points.size(); ++q)
          mean = mean + points.weight(q) *
                          rotation_by_series(theta, points.point(q)[0]);
        CHECK(largest_difference(turn.tangent, mean) <
              1e-14 * std::max(angle, 1e-2));
      }
}



TEST_CASE("derivatives of a rotation with respect to any inputs", "[unit]")
{
  // theta = M x with three inputs x among others
  using Number = Forward<8>;
  std::mt19937                     generator(5);
  std::uniform_real_distribution<> uniform(-1., 1.);
  for (const double angle : angles)
    {
      const Vector                      x = random_vector(generator, angle);
      std::array<Vector, 3>             M;
      std::array<Number, 3>             theta;
      const std::array<unsigned int, 3> places{{1, 2, 6}};
      for (unsigned int i = 0; i < 3; ++i)
        {
          theta[i] = 0.;
          for (unsigned int j = 0; j < 3; ++j)
            {
              M[i][j] = uniform(generator);
              theta[i] += M[i][j] * Number::input(x[j], places[j]);
            }
        }
      const TurnInSpace<Number> turn(theta.data());
      const double              h = 1e-5 * std::max(angle, 1e-3);
      for (unsigned int j = 0; j < 3; ++j)
        {
          const auto moved = [&](const double by) {
            Vector result;
            for (unsigned int i = 0; i < 3; ++i)
              result[i] = value_of(theta[i]) + by * M[i][j];
            return TurnInSpace<double>(result.data());
          };
          const TurnInSpace<double> above = moved(h), below = moved(-h);
          for (unsigned int i = 0; i < 9; ++i)
            {
              INFO("angle " << angle << ", input " << j << ", component " << i);
              CHECK(turn.rotation.components[i].derivatives[places[j]] ==
                    Approx((above.rotation.components[i] -
                            below.rotation.components[i]) /
                           (2 * h))
                      .epsilon(1e-6)
                      .margin(1e-8));
              CHECK(turn.tangent.components[i].derivatives[places[j]] ==
                    Approx((above.tangent.components[i] -
                            below.tangent.components[i]) /
                           (2 * h))
                      .epsilon(1e-6)
                      .margin(1e-8));
              CHECK(turn.rotation.components[i].derivatives[0] == 0.);
            }
        }
    }
}
