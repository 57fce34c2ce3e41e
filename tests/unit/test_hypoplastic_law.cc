// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "law_tools.h"

using namespace Riedel;
using LawTools::Answer;
using LawTools::is_finite;
using LawTools::make_law;
using LawTools::make_state;
using LawTools::respond;
using LawTools::rotation;

namespace
{
  constexpr double d_50 = .5e-3;

  class RandomPoints
  {
  public:
    RandomPoints(const Material::Law<2> &law, const unsigned int seed)
      : law(law)
      , generator(seed)
    {}

    std::vector<double>
    state()
    {
      const double p   = std::pow(10., 4.5 + uniform());
      const double s12 = .2 * p * uniform();
      const double s21 = s12 + (law.is_micropolar() ? .1 * p * uniform() : 0.);
      return make_state(law,
                        {-p * (1. + .4 * uniform()),
                         -p * (1. + .4 * uniform()),
                         -p * (1. + .4 * uniform()),
                         s12,
                         s21},
                        {.1 * p * d_50 * uniform(), .1 * p * d_50 * uniform()},
                        .7 + .15 * uniform());
    }

    std::vector<double>
    increments(const double size)
    {
      std::vector<double> result(law.n_generalised());
      for (unsigned int i = 0; i < result.size(); ++i)
        result[i] = (i < 5 ? size : .5 * size / d_50) * uniform();
      return result;
    }

    double
    uniform()
    {
      return distribution(generator);
    }

  private:
    const Material::Law<2>          &law;
    std::mt19937                     generator;
    std::uniform_real_distribution<> distribution{-1., 1.};
  };
} // namespace



TEST_CASE("a rigid rotation of a stressed point is exact (B1)",
          "[unit][hypoplastic][law]")
{
  for (const std::string name : {"polar hypoplastic", "hypoplastic"})
    for (const unsigned int n_steps : {4, 36, 360})
      {
        const auto   law   = make_law(name);
        const bool   polar = law->is_micropolar();
        const double s21   = polar ? 10e3 : 20e3;
        const auto   start = make_state(*law,
                                      {-100e3, -150e3, -120e3, 20e3, s21},
                                      {.02e3, -.01e3},
                                      .65);
        const double angle = 1.5707963267948966 / n_steps;
        auto         state = start;
        for (unsigned int step = 0; step < n_steps; ++step)
          {
            const Answer answer =
              respond(*law, state, rotation(angle, law->n_generalised()));
            REQUIRE(answer.report.refused == 0);
            state = answer.state;
          }
        // sigma' = R sigma R^T for a quarter turn: 11 <-> 22, 12 -> -21
        INFO(name << ", " << n_steps << " steps");
        CHECK(state[0] == Approx(-150e3).epsilon(1e-12));
        CHECK(state[1] == Approx(-100e3).epsilon(1e-12));
        CHECK(state[2] == Approx(-120e3).epsilon(1e-12));
        CHECK(state[3] == Approx(-s21).epsilon(1e-11));
        CHECK(state[4] == Approx(-20e3).epsilon(1e-11));
        CHECK(state[law->layout().find("void_ratio")] ==
              Approx(.65).epsilon(1e-12));
        if (polar)
          {
            CHECK(state[5] == Approx(.01e3).epsilon(1e-11));
            CHECK(state[6] == Approx(.02e3).epsilon(1e-11));
          }
      }
}



TEST_CASE("solid volume: 1 + e follows det f whatever the path",
          "[unit][hypoplastic][law]")
{
  const auto         law = make_law("polar hypoplastic");
  RandomPoints       random(*law, 11);
  const unsigned int e = law->layout().find("void_ratio");
  for (unsigned int i = 0; i < 200; ++i)
    {
      const auto   state  = random.state();
      const auto   d      = random.increments(3e-3);
      const Answer answer = respond(*law, state, d);
      const double j      = (1. + d[0]) * (1. + d[3]) - d[1] * d[2];
      CHECK(1. + answer.state[e] == Approx((1. + state[e]) * j).epsilon(1e-15));
    }
}



TEST_CASE("rate independence: one step or the same motion in four",
          "[unit][hypoplastic][law]")
{
  // f = exp(L): a shear with stretch along its axis has simple powers
  const auto law =
    make_law("polar hypoplastic", {{"Substep tolerance", "1e-8"}});
  const auto start        = make_state(*law,
                                {-100e3, -150e3, -120e3, 20e3, 10e3},
                                {.02e3, -.01e3},
                                .65);
  const auto simple_shear = [](const double shear, const double theta) {
    return std::vector<double>{0., shear, 0., 0., theta, 0., 0.};
  };
  const Answer once  = respond(*law, start, simple_shear(4e-3, -1e-3));
  auto         state = start;
  for (unsigned int i = 0; i < 4; ++i)
    state = respond(*law, state, simple_shear(1e-3, -.25e-3)).state;
  for (unsigned int i = 0; i < 7; ++i)
    CHECK(state[i] == Approx(once.state[i]).epsilon(1e-6));
}



TEST_CASE("a superposed rotation only rotates the result",
          "[unit][hypoplastic][law]")
{
  const auto                law   = make_law("polar hypoplastic");
  const auto                start = make_state(*law,
                                {-100e3, -150e3, -120e3, 20e3, 10e3},
                                {.02e3, -.01e3},
                                .65);
  const std::vector<double> d{-1e-3, 4e-4, 2e-3, 5e-4, -1e-3, .6, -.3};

  const double angle = .9, c = std::cos(angle), s = std::sin(angle);
  const double R[2][2] = {{c, -s}, {s, c}};
  const auto   rotate4 = [&](const double *a) {
    std::array<double, 4> b{};
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        for (int k = 0; k < 2; ++k)
          for (int l = 0; l < 2; ++l)
            b[2 * i + j] += R[i][k] * a[2 * k + l] * R[j][l];
    return b;
  };
  const auto vector = [&](const double *a) {
    return std::array<double, 2>{{c * a[0] - s * a[1], s * a[0] + c * a[1]}};
  };

  const double plane[4] = {start[0], start[3], start[4], start[1]};
  const auto   sigma    = rotate4(plane);
  const auto   m        = vector(&start[5]);
  const auto   turned =
    make_state(*law,
               {sigma[0], sigma[3], start[2], sigma[1], sigma[2]},
               {m[0], m[1]},
               .65);
  const auto H     = rotate4(d.data());
  const auto Gamma = vector(&d[5]);

  const Answer a = respond(*law, start, d);
  const Answer b =
    respond(*law, turned, {H[0], H[1], H[2], H[3], d[4], Gamma[0], Gamma[1]});
  const auto P = rotate4(a.stresses.data());
  const auto M = vector(&a.stresses[5]);
  for (int i = 0; i < 4; ++i)
    CHECK(b.stresses[i] == Approx(P[i]).epsilon(1e-10));
  CHECK(b.stresses[4] == Approx(a.stresses[4]).epsilon(1e-10));
  CHECK(b.stresses[5] == Approx(M[0]).epsilon(1e-10));
  CHECK(b.stresses[6] == Approx(M[1]).epsilon(1e-10));
  CHECK(a.report.substeps == b.report.substeps);
}



TEST_CASE("value and tangent mode agree; a batch is its points",
          "[unit][hypoplastic][law]")
{
  for (const std::string name : {"polar hypoplastic", "hypoplastic"})
    {
      const auto         law       = make_law(name);
      const unsigned int n         = law->n_generalised(),
                         n_state   = law->layout().size();
      const unsigned int  n_points = 50;
      RandomPoints        random(*law, 21);
      std::vector<double> committed, increments;
      for (unsigned int p = 0; p < n_points; ++p)
        {
          const auto s = random.state(), d = random.increments(1e-3);
          committed.insert(committed.end(), s.begin(), s.end());
          increments.insert(increments.end(), d.begin(), d.end());
        }
      std::vector<double> trial(committed.size()), stresses(increments.size());
      std::vector<double> tangents(n_points * n * n);
      const Material::Report report = law->respond({n_points,
                                                    increments.data(),
                                                    committed.data(),
                                                    trial.data(),
                                                    stresses.data(),
                                                    tangents.data()});
      CHECK(report.refused == 0);
      unsigned long long substeps = 0;
      for (unsigned int p = 0; p < n_points; ++p)
        {
          const Answer single = respond(*law,
                                        {committed.begin() + p * n_state,
                                         committed.begin() + (p + 1) * n_state},
                                        {increments.begin() + p * n,
                                         increments.begin() + (p + 1) * n});
          substeps += single.report.substeps;
          for (unsigned int i = 0; i < n; ++i)
            CHECK(stresses[p * n + i] == Approx(single.stresses[i])
                                           .epsilon(1e-11)
                                           .margin(i < 5 ? 1e-6 : 1e-9));
        }
      CHECK(substeps == report.substeps);
    }
}



TEST_CASE("tangent against central differences on random points",
          "[unit][hypoplastic][law]")
{
  for (const std::string name : {"polar hypoplastic", "hypoplastic"})
    {
      const auto         law = make_law(name);
      const unsigned int n   = law->n_generalised();
      RandomPoints       random(*law, 31);
      unsigned int       compared = 0, jumped = 0, substepped = 0, singular = 0;
      double             worst = 0.;
      for (unsigned int sample = 0; compared < 1000 && sample < 2000; ++sample)
        {
          const auto   state = random.state();
          const double size  = std::pow(10., -4. + 2. * (sample % 4) / 3.);
          const auto   d     = random.increments(size);
          const Answer at    = respond(*law, state, d, true);
          REQUIRE(is_finite(at));
          REQUIRE(at.report.refused == 0);
          // the floor has a stiffness of its own, a null deviator is a kink
          if (at.report.floored > 0 || at.report.null_deviator > 0)
            {
              ++singular;
              continue;
            }

          // rows of M in Pa, columns of Gamma as strain
          const auto scale = [](const unsigned int i) {
            return i < 5 ? 1. : d_50;
          };
          double largest = 0.;
          for (unsigned int a = 0; a < n; ++a)
            for (unsigned int b = 0; b < n; ++b)
              largest = std::max(largest,
                                 std::abs(at.tangent[a * n + b]) /
                                   (scale(a) * scale(b)));
          double error      = 0.;
          bool   same_steps = true;
          for (unsigned int b = 0; b < n; ++b)
            {
              const double step = 1e-4 * size / scale(b);
              auto         plus = d, minus = d;
              plus[b] += step;
              minus[b] -= step;
              const Answer up   = respond(*law, state, plus);
              const Answer down = respond(*law, state, minus);
              same_steps        = same_steps &&
                           up.report.substeps == at.report.substeps &&
                           down.report.substeps == at.report.substeps;
              double first = 0., second = 0.;
              for (unsigned int a = 0; a < n; ++a)
                {
                  const double slope =
                    (up.stresses[a] - down.stresses[a]) / (2. * step);
                  const double bend =
                    (up.stresses[a] - 2. * at.stresses[a] + down.stresses[a]) /
                    step;
                  first  = std::max(first, std::abs(slope) / scale(a));
                  second = std::max(second, std::abs(bend) / scale(a));
                  error  = std::max(error,
                                   std::abs(slope - at.tangent[a * n + b]) /
                                     (scale(a) * scale(b)));
                }
              // another sequence of the same number of substeps shows as a
              // jump: a smooth response bends by 1e-4 of its slope
              same_steps = same_steps && second < 1e-2 * first;
            }
          if (!same_steps)
            {
              // the sequence of substeps jumps between the two: no derivative
              ++jumped;
              continue;
            }
          ++compared;
          substepped += at.report.substeps > 1;
          worst = std::max(worst, error / largest);
          // Truncation of the differences is (1e-4)^2 of a response that
          // varies over the size of the increment or, near a small deviator,
          // over less; rounding 1e-16 p / (1e-4 size E) is below 1e-8.
          INFO(name << ", sample " << sample << ", increment " << size
                    << ", substeps " << at.report.substeps);
          CHECK(error < 1e-5 * largest);
        }
      INFO("worst relative error " << worst << ", compared " << compared
                                   << ", jumped " << jumped << ", substepped "
                                   << substepped);
      CHECK(compared > 850);
      CHECK(substepped > 100);
      CHECK(jumped < 20);
    }
}



TEST_CASE("at rest: stresses, and a tangent from the linear part",
          "[unit][hypoplastic][law]")
{
  const auto   law    = make_law("polar hypoplastic");
  const auto   start  = make_state(*law,
                                {-100e3, -150e3, -120e3, 20e3, 10e3},
                                {.02e3, -.01e3},
                                .65);
  const Answer answer = respond(*law, start, std::vector<double>(7, 0.), true);
  REQUIRE(is_finite(answer));
  double at_rest[7];
  law->stresses_at_rest(start.data(), at_rest);
  const double expected[7] = {-100e3, 20e3, 10e3, -150e3, 10e3, 20., -10.};
  for (unsigned int i = 0; i < 7; ++i)
    {
      CHECK(at_rest[i] == Approx(expected[i]).epsilon(1e-14));
      CHECK(answer.stresses[i] == Approx(expected[i]).epsilon(1e-14));
    }
  for (unsigned int i = 0; i < start.size(); ++i)
    CHECK(answer.state[i] == Approx(start[i]).epsilon(1e-14));

  // dM_1/dGamma_1 = f_s a_1^2 d50^2 (1 + m^_1^2) without the r part, of which
  // the derivative at r = 0 is zero; f_s and a_1 of D1
  const double f_s = 304118.8393554030e3, a_1 = .306206907504;
  const double m_hat = 20. / (-370e3 * d_50);
  CHECK(
    answer.tangent[5 * 7 + 5] ==
    Approx(f_s * a_1 * a_1 * d_50 * d_50 * (1. + m_hat * m_hat)).epsilon(1e-9));
}



TEST_CASE("small grains: the polar law becomes the classical one",
          "[unit][hypoplastic][law]")
{
  const auto classical = make_law("hypoplastic");
  const auto polar =
    make_law("polar hypoplastic", {{"Mean grain diameter", "1e-9"}});
  const std::vector<double> stress{-100e3, -150e3, -120e3, 20e3, 20e3};
  const auto                c_start = make_state(*classical, stress, {}, .65);
  const auto                p_start = make_state(*polar, stress, {0., 0.}, .65);

  const std::vector<double> d{-1e-3, 4e-4, 2e-3, 5e-4};
  // grains that rotate with the continuum, and a strong curvature
  const double theta = std::atan2(d[2] - d[1], 2. + d[0] + d[3]);
  // the spin of log f is close to, but not, the polar decomposition's
  const Answer a = respond(*classical, c_start, d);
  const Answer b =
    respond(*polar, p_start, {d[0], d[1], d[2], d[3], theta, 100., -50.});
  for (unsigned int i = 0; i < 5; ++i)
    CHECK(b.state[i] == Approx(a.state[i]).epsilon(1e-5));
  CHECK(b.state[7] == Approx(a.state[5]).epsilon(1e-14));

  // with large grains it is another law
  const auto   coarse = make_law("polar hypoplastic");
  const Answer other =
    respond(*coarse, p_start, {d[0], d[1], d[2], d[3], theta, 100., -50.});
  CHECK(std::abs(other.state[0] - a.state[0]) > 1e-2 * std::abs(a.state[0]));
}



TEST_CASE("polar constant: its three forms", "[unit][hypoplastic][law]")
{
  const auto couple = [](const std::string &text) {
    const auto law = make_law("polar hypoplastic", {{"Polar constant", text}});
    const auto start = make_state(*law,
                                  {-100e3, -150e3, -120e3, 20e3, 10e3},
                                  {.02e3, -.01e3},
                                  .65);
    // dominated by r: a long way, so that the couple stress feels a_c
    return respond(*law, start, {0., 1e-3, 0., 0., 0., 1., 0.}).state[5];
  };
  const double a_1 = .306206907504; // of D1, at the start
  CHECK(couple("a1 + 1/a1") == Approx(couple("a1+1/a1")).epsilon(1e-15));
  // close to the number at the start of the step, and ordered
  const double published = couple("1/a1");
  CHECK(couple(std::to_string(1. / a_1)) == Approx(published).epsilon(5e-3));
  CHECK(couple("a1 + 1/a1") < published);
  CHECK(couple("a1 + 1/a1") ==
        Approx(couple(std::to_string(a_1 + 1. / a_1))).epsilon(5e-3));
}



TEST_CASE("the first substep comes from the committed state",
          "[unit][hypoplastic][law]")
{
  const auto         law  = make_law("polar hypoplastic");
  const unsigned int slot = law->layout().find("substep");
  const auto         start =
    make_state(*law, {-50e3, -50e3, -50e3, 0., 0.}, {0., 0.}, .6);
  CHECK(start[slot] == 1.);
  const std::vector<double> d{-5e-3, 1e-3, 0., 1e-3, 0., 1., 0.};
  const Answer              first = respond(*law, start, d);
  CHECK(first.report.substeps > 1);
  // about the strain that one substep took
  CHECK(first.state[slot] < 5e-3);
  CHECK(first.state[slot] > 1e-5);

  // a small step needs one substep and does not spoil what is known
  const std::vector<double> tiny{-1e-9, 0., 0., 0., 0., 0., 0.};
  const Answer              second = respond(*law, first.state, tiny);
  CHECK(second.report.substeps == 1);
  CHECK(second.state[slot] >= first.state[slot]);

  // started finely, the result is the same within the tolerance
  auto fine            = start;
  fine[slot]           = 1e-5;
  const Answer careful = respond(*law, fine, d);
  CHECK(careful.report.substeps > first.report.substeps);
  CHECK(careful.state[0] == Approx(first.state[0]).epsilon(1e-3));
}



TEST_CASE("constants and initial states are checked by name",
          "[unit][hypoplastic][law]")
{
  const auto problems_of = [](const LawTools::Settings &changes) {
    Problems problems;
    make_law("polar hypoplastic", changes)->check("Materials/sand", problems);
    return problems;
  };
  CHECK(problems_of({}).errors.empty());
  CHECK(problems_of({}).warnings.empty());
  const std::vector<std::pair<std::string, std::string>> wrong = {
    {"Critical friction angle", "90"},
    {"Critical friction angle", "0"},
    {"Granular hardness", "-1"},
    {"Minimum void ratio", "0"},
    {"Critical void ratio", "0.5"},
    {"Maximum void ratio", "0.8"},
    {"Density exponent", "0"},
    {"Hardness exponent", "1.5"},
    {"Mean grain diameter", "0"},
    {"Polar constant", "2/a1"},
    {"Floor pressure", "0"},
    {"Substep tolerance", "2"},
    {"Density exponent", "2"}}; // h_i < 0
  for (const auto &[entry, value] : wrong)
    {
      INFO(entry << " = " << value);
      const Problems problems = problems_of({{entry, value}});
      REQUIRE(problems.errors.size() == 1);
      CHECK(problems.errors[0].path == "Materials/sand/" + entry);
      CHECK(problems.errors[0].message.find("must") != std::string::npos);
    }
  CHECK(problems_of({{"Polar constant", "1.5"}}).warnings.size() == 1);
  CHECK(problems_of({{"Polar constant", "3"}}).warnings.empty());

  const auto initial = [](const double p, const double e) {
    Material::InitialState state;
    for (unsigned int i = 0; i < 3; ++i)
      state.stress[i][i] = -p;
    state.void_ratio = e;
    Problems problems;
    make_law("polar hypoplastic")->check_initial(state, "Initial", problems);
    return std::make_pair(problems.errors.size(), problems.warnings.size());
  };
  CHECK(initial(100e3, .6) == std::make_pair<std::size_t, std::size_t>(0, 0));
  CHECK(initial(100e3, 0.).first == 1);
  CHECK(initial(-100e3, .6).first == 1);
  CHECK(initial(500., .6).second == 1);
  CHECK(initial(2e6, .6).second == 1);
  CHECK(initial(100e3, .45).second == 1);
  CHECK(initial(100e3, 1.28).second == 1);
}



TEST_CASE("the stiffness is the factor of the linear part of the rate",
          "[unit][hypoplastic][law]")
{
  for (const std::string name : {"polar hypoplastic", "hypoplastic"})
    {
      const auto law = make_law(name);
      for (const double pressure : {1e3, 100e3, 500e3})
        for (const double ratio : {1., .5, 2.})
          {
            // A stretching d with s:d = 0, there and back: what remains of the
            // rate is f_s a_1^2 d. The next order is f_s^2/p d^2, 1e-7 of it.
            const double s22   = -pressure * ratio;
            const auto   start = make_state(
              *law, {-pressure, s22, -1.2 * pressure, 0., 0.}, {}, .65);
            const double        size = 1e-11;
            std::vector<double> d(law->n_generalised(), 0.);
            d[0]            = size;
            d[3]            = size * pressure / s22;
            const auto up   = respond(*law, start, d).state;
            d[0]            = -d[0];
            d[3]            = -d[3];
            const auto down = respond(*law, start, d).state;
            CHECK(law->stiffness(start.data()) ==
                  Approx((up[0] - down[0]) / (2. * size)).epsilon(1e-6));
          }
    }
}



TEST_CASE("the stiffness respects the floor and is never zero or NaN",
          "[unit][hypoplastic][law]")
{
  for (const std::string name : {"polar hypoplastic", "hypoplastic"})
    {
      const auto   law      = make_law(name);
      const double floor    = 100.;
      const auto   on_floor = [&](const double void_ratio) {
        return law->stiffness(
          make_state(*law, {-floor, -floor, -floor, 0., 0.}, {}, void_ratio)
            .data());
      };
      const double at_floor = on_floor(.65);
      CHECK(at_floor > 0.);
      const std::vector<std::vector<double>> below = {
        {0., 0., 0., 0., 0.},
        {-1., -2., -1., 0., 0.},
        {1e3, 1e3, 1e3, 0., 0.},
        {-1e5, 1e5, -1e5, 0., 0.},
        {-1e5, -1e5, -1e5, 2e5, 2e5},
        {std::numeric_limits<double>::quiet_NaN(), 0., 0., 0., 0.}};
      for (const auto &stress : below)
        CHECK(law->stiffness(make_state(*law, stress, {}, .65).data()) ==
              Approx(at_floor).epsilon(1e-14));

      // below e_d the floor rises with the resistance against compaction
      for (const double void_ratio : {0., .1, .4, .5, 2., 10.})
        {
          CHECK(std::isfinite(on_floor(void_ratio)));
          CHECK(on_floor(void_ratio) > 0.);
        }
      CHECK(on_floor(.4) > on_floor(.5));

      RandomPoints points(*law, 3);
      for (unsigned int sample = 0; sample < 1000; ++sample)
        {
          auto state = points.state();
          // skew parts beyond those of any body, too
          state[3]               = 2. * state[0] * points.uniform();
          state[4]               = 2. * state[0] * points.uniform();
          const double stiffness = law->stiffness(state.data());
          REQUIRE(std::isfinite(stiffness));
          REQUIRE(stiffness > 0.);
        }
    }
}
