// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/continuum/rotation.h>

#include <catch2/catch.hpp>

using Riedel::Continuum::turned_further;
using Vector = std::array<double, 3>;

namespace
{
  double
  distance(const Vector &a, const Vector &b)
  {
    return std::sqrt((a[0] - b[0]) * (a[0] - b[0]) +
                     (a[1] - b[1]) * (a[1] - b[1]) +
                     (a[2] - b[2]) * (a[2] - b[2]));
  }

  /// exp(phi) x by Rodrigues' formula, which knows no quaternions
  Vector
  turn(const Vector &phi, const Vector &x)
  {
    const double angle =
      std::sqrt(phi[0] * phi[0] + phi[1] * phi[1] + phi[2] * phi[2]);
    const Vector n{{phi[0] / angle, phi[1] / angle, phi[2] / angle}};
    const double along = n[0] * x[0] + n[1] * x[1] + n[2] * x[2];
    Vector       result;
    for (unsigned int i = 0; i < 3; ++i)
      {
        const unsigned int j = (i + 1) % 3, k = (i + 2) % 3;
        result[i] = std::cos(angle) * x[i] +
                    std::sin(angle) * (n[j] * x[k] - n[k] * x[j]) +
                    (1. - std::cos(angle)) * along * n[i];
      }
    return result;
  }
} // namespace



TEST_CASE("rotations about one axis add up over many turns", "[unit][rotation]")
{
  for (const double step : {.01, M_PI / 2., 2., -2.5})
    {
      const Vector increment{{step * 2. / 7., step * 3. / 7., step * 6. / 7.}};
      Vector       phi{{0., 0., 0.}};
      for (unsigned int n = 1; n <= 40; ++n)
        {
          phi = turned_further(phi, increment);
          CHECK(
            distance(phi,
                     {{n * increment[0], n * increment[1], n * increment[2]}}) <
            1e-12 * n);
        }
    }
}



TEST_CASE("rotations about several axes follow each other", "[unit][rotation]")
{
  const Vector increments[] = {{{.3, -1.2, .7}},
                               {{0., 1.5, 0.}},
                               {{-2.1, .4, .9}},
                               {{1e-9, 2e-9, 0.}},
                               {{.1, .2, -3.}}};
  const Vector x{{1., 2., -.5}};
  Vector       phi{{0., 0., 0.}}, expected = x;
  for (unsigned int round = 0; round < 10; ++round)
    for (const Vector &increment : increments)
      {
        phi      = turned_further(phi, increment);
        expected = turn(increment, expected);
        CHECK(distance(turn(phi, x), expected) < 1e-12);
      }
  // there and back
  const Vector back =
    turned_further(turned_further({{.4, .5, .6}}, {{.3, -.2, .1}}),
                   {{-.3, .2, -.1}});
  CHECK(distance(back, {{.4, .5, .6}}) < 1e-15);
  CHECK(distance(turned_further({{0., 0., 0.}}, {{0., 0., 0.}}),
                 {{0., 0., 0.}}) == 0.);
}
