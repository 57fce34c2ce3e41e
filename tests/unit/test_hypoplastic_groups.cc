// SPDX-License-Identifier: LGPL-2.1-or-later

// Several points are computed at once. A point's result must not show who its
// neighbours were.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "law_tools.h"

using namespace Riedel;
using LawTools::make_law;
using LawTools::make_state;

namespace
{
  constexpr double d_50 = .5e-3;
  /// fills what a law has to write
  constexpr double unwritten = -7.;

  /// Points with everything a law has to answer for their batch.
  struct Points
  {
    Points(const Material::Law<2> &law)
      : law(law)
      , n(law.n_generalised())
      , n_state(law.layout().size())
    {}

    void
    add(const std::vector<double> &state, const std::vector<double> &increment)
    {
      committed.insert(committed.end(), state.begin(), state.end());
      increments.insert(increments.end(), increment.begin(), increment.end());
      ++size;
    }

    void
    add(const Points &other, const unsigned int p)
    {
      add({other.committed.begin() + p * n_state,
           other.committed.begin() + (p + 1) * n_state},
          {other.increments.begin() + p * n,
           other.increments.begin() + (p + 1) * n});
    }

    /// @param one_by_one by way of a strain of axis 3 that is zero
    void
    respond(const bool with_tangent = false, const bool one_by_one = false)
    {
      const std::vector<double> no_strain(size, 0.);
      trial.assign(committed.size(), unwritten);
      stresses.assign(increments.size(), unwritten);
      tangents.assign(increments.size() * n, unwritten);
      report = law.respond({size,
                            increments.data(),
                            committed.data(),
                            trial.data(),
                            stresses.data(),
                            with_tangent ? tangents.data() : nullptr,
                            one_by_one ? no_strain.data() : nullptr});
    }

    const Material::Law<2> &law;
    const unsigned int      n, n_state;
    unsigned int            size = 0;
    std::vector<double>     committed, increments, trial, stresses, tangents;
    Material::Report        report;
  };

  /// Points of all kinds in random order: most in the usual case, and such
  /// that substep, float up to the floor, are clamped, turn far or are refused.
  Points
  mixed_points(const Material::Law<2> &law, const unsigned int n_points)
  {
    std::mt19937                     generator(31);
    std::uniform_real_distribution<> distribution(-1., 1.);
    const auto uniform = [&]() { return distribution(generator); };

    Points points(law);
    for (unsigned int p = 0; p < n_points; ++p)
      {
        const unsigned int kind = generator() % 20;

        double pressure = std::pow(10., 4.5 + uniform());
        double bend = .4, shear = .2, skew = .1, couple = .1;
        double void_ratio = .7 + .15 * uniform();
        double size       = std::pow(10., -4.5 + uniform());
        if (kind == 0) // isotropic
          bend = shear = skew = couple = 0.;
        if (kind == 1) // no deviator, but skew
          {
            bend = shear = couple = 0.;
            skew                  = .8;
          }
        if (kind == 2)
          void_ratio = .45;
        if (kind == 3 || kind == 4)
          size = 3e-3;
        if (kind == 5)
          pressure = 120.;
        if (kind == 6) // compacted below the densest packing on the floor
          {
            pressure   = 100.;
            void_ratio = .505;
            bend = shear = skew = couple = 0.;
          }
        const double        s12 = shear * pressure * uniform();
        std::vector<double> state =
          make_state(law,
                     {-pressure * (1. + bend * uniform()),
                      -pressure * (1. + bend * uniform()),
                      -pressure * (1. + bend * uniform()),
                      s12,
                      s12 + (law.is_micropolar() ? skew * pressure * uniform() :
                                                   0.)},
                     {couple * pressure * d_50 * uniform(),
                      couple * pressure * d_50 * uniform()},
                     void_ratio);
        if (kind == 7 || kind == 8) // what a substep resolves is remembered
          state.back() = size * (1. + uniform());

        std::vector<double> increment(law.n_generalised());
        for (unsigned int i = 0; i < increment.size(); ++i)
          increment[i] = (i < 5 ? size : .5 * size / d_50) * uniform();
        if (kind == 9) // into tension
          increment[0] = increment[3] = .02;
        if (kind == 10 || kind == 11) // a large rotation
          {
            const double angle = kind == 10 ? .04 : .3;
            increment[0] += std::cos(angle) - 1.;
            increment[1] -= std::sin(angle);
            increment[2] += std::sin(angle);
            increment[3] += std::cos(angle) - 1.;
            if (law.is_micropolar())
              increment[4] += angle;
          }
        if (kind == 12)
          increment[0] = -1.5;
        if (kind == 13)
          increment[generator() % increment.size()] =
            std::numeric_limits<double>::quiet_NaN();
        if (kind == 14)
          state[generator() % state.size()] =
            std::numeric_limits<double>::infinity();
        if (kind == 15)
          std::fill(increment.begin(), increment.end(), 0.);
        points.add(state, increment);
      }
    return points;
  }
} // namespace



TEST_CASE("a point's answer does not depend on its neighbours",
          "[unit][hypoplastic][groups]")
{
  const bool with_tangent = GENERATE(false, true);
  for (const std::string name : {"polar hypoplastic", "hypoplastic"})
    {
      const auto law   = make_law(name);
      Points     batch = mixed_points(*law, 1003);
      batch.respond(with_tangent);

      // every kind of point is there
      const Material::Report &report = batch.report;
      CHECK(report.refused > 0);
      CHECK(report.floored > 0);
      CHECK(report.clamped > 0);
      CHECK((report.null_deviator > 0 || !law->is_micropolar()));
      CHECK(report.substeps > batch.size);

      Material::Report sum;
      unsigned int     n_different = 0;
      for (unsigned int p = 0; p < batch.size; ++p)
        {
          Points single(*law);
          single.add(batch, p);
          single.respond(with_tangent);
          if (single.report.refused > 0 && sum.refused == 0)
            {
              CHECK(report.first_refused == p);
              CHECK(report.reason == single.report.reason);
            }
          sum.refused += single.report.refused;
          sum.floored += single.report.floored;
          sum.clamped += single.report.clamped;
          sum.null_deviator += single.report.null_deviator;
          sum.substeps += single.report.substeps;
          n_different +=
            !std::equal(single.trial.begin(),
                        single.trial.end(),
                        batch.trial.begin() + p * batch.n_state) ||
            !std::equal(single.stresses.begin(),
                        single.stresses.end(),
                        batch.stresses.begin() + p * batch.n) ||
            !std::equal(single.tangents.begin(),
                        single.tangents.end(),
                        batch.tangents.begin() + p * batch.n * batch.n);
        }
      CHECK(n_different == 0);
      CHECK(sum.refused == report.refused);
      CHECK(sum.floored == report.floored);
      CHECK(sum.clamped == report.clamped);
      CHECK(sum.null_deviator == report.null_deviator);
      CHECK(sum.substeps == report.substeps);

      // in another order
      std::vector<unsigned int> order(batch.size);
      std::iota(order.begin(), order.end(), 0);
      std::shuffle(order.begin(), order.end(), std::mt19937(5));
      Points shuffled(*law);
      for (const unsigned int p : order)
        shuffled.add(batch, p);
      shuffled.respond(with_tangent);
      for (unsigned int q = 0; q < batch.size; ++q)
        n_different +=
          !std::equal(batch.trial.begin() + order[q] * batch.n_state,
                      batch.trial.begin() + (order[q] + 1) * batch.n_state,
                      shuffled.trial.begin() + q * batch.n_state);
      CHECK(n_different == 0);
    }
}



TEST_CASE("stresses of groups are those of the tangent mode",
          "[unit][hypoplastic][groups]")
{
  for (const std::string name : {"polar hypoplastic", "hypoplastic"})
    for (const LawTools::Settings &settings :
         {LawTools::Settings{},
          LawTools::Settings{{"Hardness exponent", "0.28"}}})
      {
        const auto law    = make_law(name, settings);
        Points     values = mixed_points(*law, 1003), tangents = values;
        values.respond();
        tangents.respond(true);
        CHECK(values.report.refused == tangents.report.refused);
        CHECK(values.report.floored == tangents.report.floored);
        CHECK(values.report.clamped == tangents.report.clamped);
        CHECK(values.report.null_deviator == tangents.report.null_deviator);
        CHECK(values.report.substeps == tangents.report.substeps);

        // relative to the point's stress; couple stresses divided by d_50
        double worst = 0., worst_void_ratio = 0., worst_substep = 0.;
        for (unsigned int p = 0; p < values.size; ++p)
          {
            const double *a     = values.stresses.data() + p * values.n;
            const double *b     = tangents.stresses.data() + p * values.n;
            double        scale = 0.;
            for (unsigned int i = 0; i < 4; ++i)
              scale = std::max(scale, std::abs(b[i]));
            for (unsigned int i = 0; i < values.n; ++i)
              worst =
                std::max(worst,
                         std::abs(a[i] - b[i]) / (scale * (i < 5 ? 1. : d_50)));
            const auto difference = [&](const unsigned int place) {
              return std::abs(values.trial[p * values.n_state + place] /
                                tangents.trial[p * values.n_state + place] -
                              1.);
            };
            worst_void_ratio =
              std::max(worst_void_ratio, difference(values.n_state - 2));
            worst_substep =
              std::max(worst_substep, difference(values.n_state - 1));
          }
        INFO(name);
        CHECK(worst < 1e-12);
        CHECK(worst_void_ratio < 1e-14);
        // it follows from an error estimate, which may be mere rounding
        CHECK(worst_substep < 1e-5);
      }
}



TEST_CASE("tangents of groups are those of points one by one",
          "[unit][hypoplastic][groups]")
{
  for (const std::string name : {"polar hypoplastic", "hypoplastic"})
    {
      const auto law    = make_law(name);
      Points     groups = mixed_points(*law, 1003), points = groups;
      groups.respond(true);
      points.respond(true, true);
      CHECK(groups.report.refused == points.report.refused);
      CHECK(groups.report.substeps == points.report.substeps);

      // components as of stresses: couple stresses divided by d_50, for
      // curvatures times d_50; relative to the point's largest
      double       worst     = 0.;
      unsigned int n_resting = 0;
      for (unsigned int p = 0; p < groups.size; ++p)
        {
          const unsigned int n = groups.n, begin = p * n * n;
          double             scale = 0., difference = 0.;
          for (unsigned int i = 0; i < n; ++i)
            for (unsigned int j = 0; j < n; ++j)
              {
                const double unit = (i < 5 ? 1. : d_50) * (j < 5 ? 1. : d_50);
                const double a    = groups.tangents[begin + i * n + j] / unit;
                const double b    = points.tangents[begin + i * n + j] / unit;
                scale             = std::max(scale, std::abs(b));
                difference        = std::max(difference, std::abs(a - b));
                CHECK(std::isfinite(a));
              }
          worst = std::max(worst, difference / scale);
          n_resting += std::all_of(groups.increments.begin() + p * n,
                                   groups.increments.begin() + (p + 1) * n,
                                   [](const double x) { return x == 0.; });
        }
      INFO(name);
      CHECK(worst < 1e-11);
      CHECK(n_resting > 10);
    }
}
