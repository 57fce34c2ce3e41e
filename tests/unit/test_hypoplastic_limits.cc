// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <limits>

#include "law_tools.h"

using namespace Riedel;
using LawTools::Answer;
using LawTools::is_finite;
using LawTools::make_law;
using LawTools::make_state;
using LawTools::respond;

namespace
{
  double
  mean_pressure(const std::vector<double> &state)
  {
    return -(state[0] + state[1] + state[2]) / 3.;
  }
} // namespace



TEST_CASE("beyond the limits: finite and reported", "[unit][hypoplastic][law]")
{
  for (const std::string name : {"polar hypoplastic", "hypoplastic"})
    {
      const auto         law      = make_law(name);
      const bool         polar    = law->is_micropolar();
      const unsigned int n        = law->n_generalised();
      const auto         state_of = [&](const std::vector<double> &stress,
                                const double               void_ratio) {
        return make_state(*law, stress, {.5, .5}, void_ratio);
      };
      const auto increment = [&](const double h11, const double h22) {
        std::vector<double> d(n, 0.);
        d[0] = h11;
        d[3] = h22;
        d[1] = .1 * h11;
        return d;
      };
      INFO(name);

      SECTION(name + ": extension ends on the floor")
      {
        const Answer answer = respond(*law,
                                      state_of({-5e3, -5e3, -5e3, 0., 0.}, .7),
                                      increment(1e-2, 1e-2),
                                      true);
        CHECK(is_finite(answer));
        CHECK(answer.report.refused == 0);
        CHECK(answer.report.floored == 1);
        for (unsigned int i = 0; i < 3; ++i)
          CHECK(answer.state[i] == Approx(-100.).epsilon(1e-12));
        if (polar)
          CHECK(answer.state[5] == 0.);
        CHECK(1. + answer.state[law->layout().find("void_ratio")] ==
              Approx(1.7 * 1.01 * 1.01).epsilon(1e-14));
        // a solver finds stiffness there
        CHECK(answer.tangent[0] > 1e4);
        CHECK(answer.tangent[3 * n + 3] > 1e4);

        // it stays there, at the price of one substep, and comes back
        const Answer stays = respond(*law, answer.state, increment(1e-3, 1e-3));
        CHECK(stays.report.floored == 1);
        CHECK(stays.report.substeps == 1);
        CHECK(mean_pressure(stays.state) == Approx(100.).epsilon(1e-12));
        const Answer returns =
          respond(*law, answer.state, increment(-1e-3, -1e-3), true);
        CHECK(is_finite(returns));
        CHECK(returns.report.floored == 0);
        CHECK(mean_pressure(returns.state) > 200.);
      }

      SECTION(name + ": no jump where a point leaves the floor")
      {
        const auto          start = state_of({-100., -100., -100., 0., 0.}, .7);
        const unsigned int  n_directions = 20000;
        std::vector<double> before;
        double              largest = 0.;
        for (unsigned int i = 0; i <= n_directions; ++i)
          {
            // from compression through shear to extension and back
            const double angle = 2. * M_PI * i / n_directions;
            auto         d     = increment(-2e-4 * std::cos(angle), 0.);
            d[1]               = 2e-4 * std::sin(angle);
            const auto now     = respond(*law, start, d).state;
            for (unsigned int k = 0; i > 0 && k < 5; ++k)
              largest = std::max(largest, std::abs(now[k] - before[k]));
            before = now;
          }
        INFO("largest change between neighbours: " << largest << " Pa");
        CHECK(largest < 1.);
      }

      SECTION(name + ": tension and zero stress at the start")
      {
        for (const double stress : {0., 50e3})
          {
            const Answer answer =
              respond(*law,
                      state_of({stress, stress, stress, 0., 0.}, .7),
                      increment(-1e-3, 5e-4),
                      true);
            CHECK(is_finite(answer));
            CHECK(answer.report.refused == 0);
            CHECK(answer.report.floored == 1);
            CHECK(mean_pressure(answer.state) > 99.);
          }
      }

      SECTION(name + ": denser than the densest packing")
      {
        const Answer answer =
          respond(*law,
                  state_of({-100e3, -100e3, -100e3, 0., 0.}, .45),
                  increment(-1e-3, 0.),
                  true);
        CHECK(is_finite(answer));
        CHECK(answer.report.refused == 0);
        CHECK(answer.report.clamped == 1);

        // compaction on the floor is resisted below e_d, not above
        auto loose = state_of({-100., -100., -100., 0., 0.}, .52);
        auto dense = state_of({-100., -100., -100., 0., 0.}, .45);
        // shear drives both against the floor
        std::vector<double> d(n, 0.);
        d[0] = -5e-4;
        d[3] = 5.1e-4;
        CHECK(mean_pressure(respond(*law, loose, d).state) < 5e3);
        const double e_d      = .51 * std::exp(-std::sqrt(300. / 190e6));
        const double expected = 100. + 1e7 * (e_d - .45) / 1.45;
        const Answer resisted =
          respond(*law, dense, std::vector<double>(n, 0.), true);
        CHECK(resisted.report.floored == 1);
        CHECK(is_finite(resisted));
        CHECK(mean_pressure(resisted.state) == Approx(expected).epsilon(1e-10));
      }

      SECTION(name + ": five percent at once")
      {
        for (const double sign : {-1., 1.})
          {
            const Answer answer =
              respond(*law,
                      state_of({-100e3, -100e3, -100e3, 0., 0.}, .6),
                      increment(.05 * sign, -.03 * sign),
                      true);
            CHECK(is_finite(answer));
            CHECK(answer.report.refused == 0);
            CHECK(answer.report.substeps > 5);
          }
      }

      SECTION(name + ": dense and lowly stressed, driven into tension")
      {
        auto state = state_of({-2e3, -2e3, -2e3, 0., 0.}, .52);
        for (unsigned int i = 0; i < 100; ++i)
          {
            const Answer answer =
              respond(*law, state, increment(-1e-3, 2e-3), true);
            REQUIRE(is_finite(answer));
            REQUIRE(answer.report.refused == 0);
            REQUIRE(mean_pressure(answer.state) > 99.);
            state = answer.state;
          }
      }

      SECTION(name + ": refused increments leave a reason")
      {
        const auto start  = state_of({-100e3, -100e3, -100e3, 0., 0.}, .6);
        const auto reason = [&](const std::vector<double> &d) {
          const Answer answer = respond(*law, start, d, true);
          CHECK(answer.report.refused == 1);
          CHECK(answer.report.first_refused == 0);
          return answer.report.reason;
        };
        using Refusal = Material::Report::Refusal;
        CHECK(reason(increment(-1.5, 0.)) == Refusal::inverted_step);
        CHECK(reason(increment(-2., -2.)) == Refusal::inverted_step);
        CHECK(reason(increment(NAN, 0.)) == Refusal::not_finite);
        if (polar)
          {
            auto d = increment(0., 0.);
            d[4]   = NAN;
            CHECK(reason(d) == Refusal::not_finite);
          }
        const auto coarse =
          make_law(name, {{"Largest number of substeps", "2"}});
        const Answer answer = respond(*coarse, start, increment(-.02, .01));
        CHECK(answer.report.refused == 1);
        CHECK(answer.report.reason == Refusal::too_many_substeps);
        CHECK(Material::describe(answer.report.reason).size() > 20);
      }
    }
}



TEST_CASE("skew shear stresses without real deviator are counted",
          "[unit][hypoplastic][law]")
{
  const auto law = make_law("polar hypoplastic");
  const auto start =
    make_state(*law, {-100e3, -100e3, -100e3, 30e3, -30e3}, {0., 0.}, .65);
  const Answer answer =
    respond(*law, start, {-1e-4, 0., 0., 0., 0., 0., 0.}, true);
  CHECK(is_finite(answer));
  CHECK(answer.report.null_deviator == 1);
  const auto usual =
    make_state(*law, {-100e3, -120e3, -110e3, 30e3, 20e3}, {0., 0.}, .65);
  CHECK(respond(*law, usual, {-1e-4, 0., 0., 0., 0., 0., 0.})
          .report.null_deviator == 0);
}
