// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/material/elastic_tangent.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace Riedel;

namespace
{
  /// Largest difference to forward numbers over states and steps of @p size,
  /// relative to the largest number of the tangent; curvatures in units of L.
  template <bool micropolar>
  double
  worst_difference(const double size, const bool plastic_before)
  {
    using Order = Continuum::Generalised<3>;
    constexpr unsigned int n =
      micropolar ? Order::n_micropolar : Order::n_classical;
    using Number = Continuum::Forward<Continuum::n_derivatives(n)>;

    Material::NeoHookeanElasticity e;
    e.lambda = 1000.;
    e.mu     = 2000.;
    if (micropolar)
      {
        e.kappa = 700.;
        e.alpha = 5.;
        e.beta  = 10.;
        e.gamma = 40.;
      }
    std::mt19937                     generator(11);
    std::uniform_real_distribution<> distribution(-1., 1.);
    const auto uniform = [&]() { return distribution(generator); };

    double worst = 0.;
    for (unsigned int sample = 0; sample < 20; ++sample)
      {
        Material::StretchAndCurvature<3, double> start;
        for (unsigned int i = 0; i < 9; ++i)
          {
            start.elastic.components[i]   = .1 * uniform();
            start.total.components[i]     = start.elastic.components[i];
            start.curvature.components[i] = micropolar ? 2. * uniform() : 0.;
            if (plastic_before)
              start.total.components[i] += .1 * uniform();
          }
        std::array<double, n> increments;
        std::array<Number, n> inputs;
        for (unsigned int i = 0; i < n; ++i)
          {
            increments[i] =
              (i < 9 ? .2 : (i < 12 ? 3. : 5.)) * size * uniform();
            inputs[i] = Number::input(increments[i], i);
          }

        const Material::FiniteStrainStep<3, micropolar, Number> step(inputs,
                                                                     start);
        REQUIRE(step.valid);
        Continuum::CurvatureTensor<3, Number> couple;
        couple.components.fill(Number(0.));
        if constexpr (micropolar)
          couple =
            e.kirchhoff_couple_stress(step.trial.curvature, step.trial.total);
        const auto expected =
          step.generalised(e.kirchhoff_stress(step.trial.elastic), couple);

        // every number must be written
        std::vector<double> found(n * n,
                                  std::numeric_limits<double>::quiet_NaN());
        Material::elastic_tangent_in_space<micropolar>(e,
                                                       increments.data(),
                                                       start,
                                                       found.data());
        double largest = 0., difference = 0.;
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            {
              // L = .1 m
              const double unit = (i < 12 ? 1. : .1) * (j < 12 ? 1. : .1);
              const double a    = expected[i].derivatives[j] / unit;
              const double b    = found[i * n + j] / unit;
              REQUIRE(std::isfinite(b));
              largest    = std::max(largest, std::abs(a));
              difference = std::max(difference, std::abs(a - b));
            }
        worst = std::max(worst, difference / largest);
      }
    return worst;
  }
} // namespace



TEST_CASE("elastic tangents in space in closed form and by forward numbers",
          "[unit][neo_hookean]")
{
  for (const double size : {0., 1e-8, 1e-3, .3, 1.})
    for (const bool plastic_before : {false, true})
      {
        INFO("size " << size << ", plastic before " << plastic_before);
        CHECK(worst_difference<true>(size, plastic_before) < 1e-13);
        CHECK(worst_difference<false>(size, plastic_before) < 1e-13);
      }
}
