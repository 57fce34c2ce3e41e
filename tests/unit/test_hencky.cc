// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "law_tools.h"

using namespace Riedel;
using LawTools::make_law;
using LawTools::respond;
using Material::Report;

namespace
{
  // the constants of make_law()
  constexpr double E = 1000., nu = .25, mu = 400., lambda = 400.;

  /// place of the strains behind the stress
  constexpr unsigned int strain = 5;

  using Matrix = std::array<double, 4>; ///< 11, 12, 21, 22

  Matrix
  operator*(const Matrix &a, const Matrix &b)
  {
    return {{a[0] * b[0] + a[1] * b[2],
             a[0] * b[1] + a[1] * b[3],
             a[2] * b[0] + a[3] * b[2],
             a[2] * b[1] + a[3] * b[3]}};
  }

  Matrix
  inverse(const Matrix &a)
  {
    const double det = a[0] * a[3] - a[1] * a[2];
    return {{a[3] / det, -a[1] / det, -a[2] / det, a[0] / det}};
  }

  /// H = f - I
  std::vector<double>
  increments(const Matrix &f)
  {
    return {f[0] - 1., f[1], f[2], f[3] - 1.};
  }

  std::vector<double>
  rotation(const double angle)
  {
    const double s = std::sin(angle);
    const double c = -2. * std::pow(std::sin(angle / 2), 2);
    return {c, -s, s, c};
  }

  Material::InitialState
  initial_state(const double s11,
                const double s22,
                const double s33,
                const double s12)
  {
    Material::InitialState initial;
    initial.stress[0][0] = s11;
    initial.stress[1][1] = s22;
    initial.stress[2][2] = s33;
    initial.stress[0][1] = s12;
    return initial;
  }

  std::vector<double>
  start(const Material::Law<2> &law,
        const double            s11 = 0.,
        const double            s22 = 0.,
        const double            s33 = 0.,
        const double            s12 = 0.)
  {
    std::vector<double> state(law.layout().size());
    law.initialise(initial_state(s11, s22, s33, s12), state.data());
    return state;
  }

  /// the stored energy per volume of the stress-free state
  double
  energy(const std::vector<double> &state)
  {
    const double *e     = state.data() + strain;
    const double  trace = e[0] + e[1] + e[2];
    return .5 * lambda * trace * trace +
           mu * (e[0] * e[0] + e[1] * e[1] + e[2] * e[2] + 2. * e[3] * e[3]);
  }

  double
  stress_size(const std::vector<double> &state)
  {
    double square = 0.;
    for (unsigned int i = 0; i < 5; ++i)
      square += state[i] * state[i];
    return std::sqrt(square);
  }

  double
  volume(const std::vector<double> &state)
  {
    return std::exp(state[strain] + state[strain + 1] + state[strain + 2]);
  }
} // namespace



TEST_CASE("Hencky: what kind of law it is", "[unit][hencky]")
{
  const auto law = make_law("Hencky");
  CHECK(law->name() == "Hencky");
  CHECK_FALSE(law->is_micropolar());
  CHECK_FALSE(law->is_geometrically_linear());
  CHECK(law->n_generalised() == 4);
  CHECK(law->length() == 0.);
  CHECK(law->layout().find("stress") == 0);
  CHECK(law->layout().find("logarithmic_strain", "33") == strain + 2);
}



TEST_CASE("Hencky: uniaxial stretch", "[unit][hencky]")
{
  const auto law = make_law("Hencky");
  for (const double stretch : {1e-3, .2, .9, 1. + 1e-9, 1.5, 20.})
    {
      const double log    = std::log(stretch);
      const auto   answer = respond(*law, start(*law), {stretch - 1., 0, 0, 0});
      REQUIRE(answer.report.refused == 0);
      // rounding of stretch - 1 counts for the smallest
      const double tolerance = 1e-14 + 1e-16 / std::abs(log);
      CHECK(answer.state[0] ==
            Approx((lambda + 2. * mu) * log / stretch).epsilon(tolerance));
      CHECK(answer.state[1] ==
            Approx(lambda * log / stretch).epsilon(tolerance));
      CHECK(answer.state[2] == Approx(answer.state[1]).epsilon(1e-14));
      CHECK(answer.state[3] == 0.);
      CHECK(answer.state[4] == 0.);
      // P_11 = j sigma_11/f_11, P_22 = j sigma_22
      CHECK(answer.stresses[0] == Approx(answer.state[0]).epsilon(1e-14));
      CHECK(answer.stresses[3] ==
            Approx(stretch * answer.state[1]).epsilon(1e-14));
    }

  // and in a hundred steps
  auto state = start(*law);
  for (unsigned int step = 0; step < 100; ++step)
    state = respond(*law, state, {0., 0., 0., std::pow(.1, .01) - 1.}).state;
  CHECK(state[1] ==
        Approx((lambda + 2. * mu) * std::log(.1) / .1).epsilon(1e-13));
  CHECK(state[0] == Approx(lambda * std::log(.1) / .1).epsilon(1e-13));
}



TEST_CASE("Hencky: simple shear", "[unit][hencky]")
{
  // b = [1 + g^2, g; g, 1] has the principal strains +-arsinh(g/2) and the
  // deviator (g^2/2, g) of length sinh(2 arsinh(g/2)) = g sqrt(1 + g^2/4)
  const auto law = make_law("Hencky");
  for (const double g : {1e-6, .03, .5, 2., 50.})
    {
      const auto   answer = respond(*law, start(*law), {0., g, 0., 0.});
      const double part =
        2. * mu * std::asinh(.5 * g) / (g * std::sqrt(1. + .25 * g * g));
      CHECK(answer.state[0] == Approx(part * .5 * g * g).epsilon(1e-13));
      CHECK(answer.state[1] == Approx(-part * .5 * g * g).epsilon(1e-13));
      CHECK(std::abs(answer.state[2]) < 1e-13 * mu);
      CHECK(answer.state[3] == Approx(part * g).epsilon(1e-13));
      CHECK(answer.state[4] == answer.state[3]);
    }
}



TEST_CASE("Hencky: small strains are those of linear elasticity",
          "[unit][hencky]")
{
  const auto                law = make_law("Hencky");
  const std::vector<double> d{1e-9, -2e-9, 5e-9, 3e-9};
  const auto                s     = respond(*law, start(*law), d).stresses;
  const double              trace = d[0] + d[3];
  CHECK(s[0] == Approx(lambda * trace + 2. * mu * d[0]).epsilon(1e-7));
  CHECK(s[1] == Approx(mu * (d[1] + d[2])).epsilon(1e-7));
  CHECK(s[2] == Approx(mu * (d[1] + d[2])).epsilon(1e-7));
  CHECK(s[3] == Approx(lambda * trace + 2. * mu * d[3]).epsilon(1e-7));
}



TEST_CASE("Hencky: a rigid rotation of a stressed point is exact (B1)",
          "[unit][hencky]")
{
  const auto   law    = make_law("Hencky");
  const auto   begin  = start(*law, -100., -350., -120., 80.);
  const double size   = stress_size(begin);
  const double tensor = 1e-12 * size;
  for (const double quarters : {1., 2., 4.})
    for (const unsigned int n_steps : {4, 36, 360})
      {
        const double angle = quarters * 1.5707963267948966 / n_steps;
        auto         state = begin;
        for (unsigned int step = 0; step < n_steps; ++step)
          {
            const auto answer = respond(*law, state, rotation(angle));
            REQUIRE(answer.report.refused == 0);
            state = answer.state;
            CHECK(std::abs(stress_size(state) - size) < tensor);
          }
        const bool quarter = quarters == 1.;
        CHECK(std::abs(state[0] - begin[quarter ? 1 : 0]) < tensor);
        CHECK(std::abs(state[1] - begin[quarter ? 0 : 1]) < tensor);
        CHECK(std::abs(state[2] - begin[2]) < tensor);
        CHECK(std::abs(state[3] - (quarter ? -1. : 1.) * begin[3]) < tensor);
        CHECK(state[4] == state[3]);
        CHECK(energy(state) == Approx(energy(begin)).epsilon(1e-12));
      }

  // a half turn in one step, too: the law knows no limit but det f > 0
  const auto half = respond(*law, begin, {-2., 0., 0., -2.});
  REQUIRE(half.report.refused == 0);
  for (unsigned int i = 0; i < begin.size(); ++i)
    CHECK(half.state[i] == Approx(begin[i]).epsilon(1e-13));
}



TEST_CASE("Hencky: the experiment turned gives the stress turned",
          "[unit][hencky]")
{
  const auto   law   = make_law("Hencky");
  const double angle = .8, c = std::cos(angle), s = std::sin(angle);
  const Matrix R{{c, -s, s, c}}, f{{1.3, -.4, .2, .7}};
  const auto   straight = respond(*law, start(*law), increments(f));
  const auto   turned   = respond(*law, start(*law), increments(R * f));
  const Matrix sigma{{straight.state[0],
                      straight.state[3],
                      straight.state[4],
                      straight.state[1]}};
  const Matrix expected = R * sigma * inverse(R);
  CHECK(turned.state[0] == Approx(expected[0]).epsilon(1e-13));
  CHECK(turned.state[3] == Approx(expected[1]).epsilon(1e-13));
  CHECK(turned.state[1] == Approx(expected[3]).epsilon(1e-13));
}



TEST_CASE("Hencky: the stress does not depend on the path", "[unit][hencky]")
{
  const auto                       law = make_law("Hencky");
  std::mt19937                     generator(5);
  std::uniform_real_distribution<> uniform(-1., 1.);
  for (unsigned int sample = 0; sample < 50; ++sample)
    {
      const auto begin = start(*law,
                               150. * uniform(generator),
                               150. * uniform(generator),
                               150. * uniform(generator),
                               100. * uniform(generator));
      Matrix     F{{1., 0., 0., 1.}};
      auto       state = begin;
      for (unsigned int step = 0; step < 10; ++step)
        {
          const Matrix f{{1. + .3 * uniform(generator),
                          .3 * uniform(generator),
                          .3 * uniform(generator),
                          1. + .3 * uniform(generator)}};
          F     = f * F;
          state = respond(*law, state, increments(f)).state;
        }
      const auto   at_once = respond(*law, begin, increments(F)).state;
      const auto   back    = respond(*law, state, increments(inverse(F))).state;
      const double large   = stress_size(state) + stress_size(begin) + mu;
      for (unsigned int i = 0; i < 5; ++i)
        {
          CHECK(std::abs(at_once[i] - state[i]) < 1e-11 * large);
          CHECK(std::abs(back[i] - begin[i]) < 1e-11 * large);
        }
    }
}



TEST_CASE("Hencky: the tangent against central differences", "[unit][hencky]")
{
  const auto                       law = make_law("Hencky");
  std::mt19937                     generator(7);
  std::uniform_real_distribution<> uniform(-1., 1.);

  const auto check = [&](const std::vector<double> &state,
                         const std::vector<double> &d) {
    const auto answer = respond(*law, state, d, true);
    const auto value  = respond(*law, state, d);
    REQUIRE(answer.report.refused == 0);
    for (unsigned int b = 0; b < 4; ++b)
      {
        CHECK(value.stresses[b] ==
              Approx(answer.stresses[b]).epsilon(1e-12).margin(1e-12 * mu));
        auto plus = d, minus = d;
        plus[b] += 1e-5;
        minus[b] -= 1e-5;
        const auto   up     = respond(*law, state, plus);
        const auto   down   = respond(*law, state, minus);
        const double before = volume(state);
        for (unsigned int a = 0; a < 4; ++a)
          {
            CHECK(answer.tangent[a * 4 + b] ==
                  Approx((up.stresses[a] - down.stresses[a]) / 2e-5)
                    .epsilon(1e-6)
                    .margin(1e-6 * mu));
            // there is a stored energy
            CHECK(answer.tangent[a * 4 + b] == Approx(answer.tangent[b * 4 + a])
                                                 .epsilon(1e-11)
                                                 .margin(1e-11 * mu));
          }
        CHECK(answer.stresses[b] ==
              Approx((energy(up.state) - energy(down.state)) / 2e-5 / before)
                .epsilon(1e-6)
                .margin(1e-6 * mu));
      }
  };

  for (const double size : {1e-9, 1e-3, .05, .4})
    for (unsigned int sample = 0; sample < 25; ++sample)
      {
        const auto          state = start(*law,
                                 200. * uniform(generator),
                                 200. * uniform(generator),
                                 200. * uniform(generator),
                                 150. * uniform(generator));
        std::vector<double> d(4);
        for (double &value : d)
          value = size * uniform(generator);
        check(state, d);
      }

  // equal principal strains: at rest, after volume change and rotation, and
  // where a step makes them equal; and next to it
  for (const double p : {0., 100., -200.})
    {
      const auto isotropic = start(*law, p, p, p);
      check(isotropic, {0., 0., 0., 0.});
      check(isotropic, {.3, 0., 0., .3});
      check(isotropic, rotation(1.));
      check(isotropic, {.3 + 1e-8, 0., 1e-9, .3});
    }
  const auto stretched = respond(*law, start(*law), {1., 0., 0., 0.}).state;
  check(stretched, {-.5, 0., 0., 0.});
  check(stretched, {0., 0., 0., 1.});
  // on both sides of the series' end, q = sinh(2 r)^2 = 2e-3
  for (const double stretch : {.04466, .04474, .0448, .0449})
    check(start(*law), {stretch, 0., 0., 0.});
}



TEST_CASE("Hencky: an initial stress is reproduced", "[unit][hencky]")
{
  const auto law  = make_law("Hencky");
  const auto none = start(*law);
  CHECK(
    std::all_of(none.begin(), none.end(), [](double x) { return x == 0.; }));

  // from soft to far beyond the stiffness; K0 states and shear
  for (const double s22 : {-1e-6, -1., -500., -1e5, 1e-3, 150.})
    for (const double K0 : {.4, 1., 1.5})
      for (const double shear : {0., .3})
        {
          const auto state = start(*law, K0 * s22, s22, K0 * s22, shear * s22);
          CHECK(state[0] == K0 * s22);
          CHECK(state[1] == s22);
          CHECK(state[2] == K0 * s22);
          CHECK(state[3] == shear * s22);
          CHECK(state[4] == shear * s22);
          double rest[4];
          law->stresses_at_rest(state.data(), rest);
          const auto answer = respond(*law, state, {0., 0., 0., 0.});
          for (unsigned int i = 0; i < 4; ++i)
            CHECK(std::abs(answer.stresses[i] - rest[i]) <
                  1e-13 * std::abs(s22));
          for (unsigned int i = 0; i < 5; ++i)
            CHECK(std::abs(answer.state[i] - state[i]) < 1e-13 * std::abs(s22));
        }
}



TEST_CASE("Hencky: a stress found by straining is that of the same strain",
          "[unit][hencky]")
{
  // the initial stress counts its volume from the stress-free state: what was
  // compressed goes on as what starts from the same stress
  const auto law      = make_law("Hencky");
  const auto strained = respond(*law, start(*law), {-.3, .1, .2, -.4}).state;
  const auto given =
    start(*law, strained[0], strained[1], strained[2], strained[3]);
  for (unsigned int i = 0; i < given.size(); ++i)
    CHECK(given[i] == Approx(strained[i]).epsilon(1e-12).margin(1e-14));
}



TEST_CASE("Hencky: the stiffness is 2 mu per present volume", "[unit][hencky]")
{
  const auto law = make_law("Hencky");
  CHECK(law->stiffness(start(*law).data()) == 2. * mu);
  const auto half = respond(*law, start(*law), {-.5, 0., 0., 0.}).state;
  CHECK(law->stiffness(half.data()) == Approx(4. * mu).epsilon(1e-14));
}



TEST_CASE("Hencky: what cannot be answered is refused", "[unit][hencky]")
{
  const auto   law  = make_law("Hencky");
  const auto   from = start(*law, -100., -200., -100., 50.);
  const double nan  = std::numeric_limits<double>::quiet_NaN();
  const double inf  = std::numeric_limits<double>::infinity();
  const std::vector<std::pair<std::vector<double>, Report::Refusal>> wrong = {
    {{-1., 0., 0., 0.}, Report::Refusal::inverted_step},
    {{-1.5, 0., 0., 0.}, Report::Refusal::inverted_step},
    {{0., 2., .5, 0.}, Report::Refusal::inverted_step},
    {{nan, 0., 0., 0.}, Report::Refusal::not_finite},
    {{0., nan, 0., 0.}, Report::Refusal::not_finite},
    {{inf, 0., 0., 0.}, Report::Refusal::not_finite},
    {{1e200, 0., 0., 1e200}, Report::Refusal::not_finite}};
  for (const bool with_tangent : {false, true})
    for (const auto &[d, reason] : wrong)
      {
        const auto answer = respond(*law, from, d, with_tangent);
        INFO(d[0] << " " << d[1] << " " << d[2] << " " << d[3]);
        CHECK(answer.report.refused == 1);
        CHECK(answer.report.reason == reason);
      }

  // in a batch the others are answered
  const std::vector<double> d{.1, 0., 0., 0., -2., 0., 0., 0., .1, 0., 0., 0.};
  std::vector<double>       committed, trial(27), stresses(12);
  for (unsigned int p = 0; p < 3; ++p)
    committed.insert(committed.end(), from.begin(), from.end());
  const Report report = law->respond(
    {3, d.data(), committed.data(), trial.data(), stresses.data(), nullptr});
  CHECK(report.refused == 1);
  CHECK(report.first_refused == 1);
  CHECK(report.substeps == 2);
  CHECK(stresses[8] == stresses[0]);
  CHECK(trial[18] == trial[0]);
  CHECK(stresses[0] != 0.);
}



TEST_CASE("Hencky: constants and initial stress are checked", "[unit][hencky]")
{
  const auto messages = [](const LawTools::Settings &changes) {
    Problems problems;
    make_law("Hencky", changes)->check("M", problems);
    return problems.errors;
  };
  CHECK(messages({}).empty());
  CHECK(messages({{"Poisson ratio", "-0.9"}}).empty());
  const std::vector<std::array<std::string, 3>> wrong = {
    {{"Young modulus", "0", "E > 0"}},
    {{"Young modulus", "-5", "E > 0"}},
    {{"Poisson ratio", "0.5", "-1 < nu < 1/2"}},
    {{"Poisson ratio", "-1", "-1 < nu < 1/2"}}};
  for (const auto &[entry, value, rule] : wrong)
    {
      const auto errors = messages({{entry, value}});
      REQUIRE(errors.size() == 1);
      CHECK(errors[0].path == "M/" + entry);
      CHECK(errors[0].message.find(rule) != std::string::npos);
    }

  // the trace of the stress is at most (3 lambda + 2 mu)/e = 735.76 Pa
  const auto   law     = make_law("Hencky");
  const double largest = (3. * lambda + 2. * mu) / std::exp(1.) / 3.;
  CHECK(E == Approx(mu * (3. * lambda + 2. * mu) / (lambda + mu)));
  CHECK(nu == Approx(lambda / (2. * (lambda + mu))));
  for (const auto &[s, n_errors] : {std::make_pair(.999 * largest, 0u),
                                    std::make_pair(1.001 * largest, 1u)})
    {
      Problems problems;
      law->check_initial(initial_state(s, s, s, 0.), "I", problems);
      CHECK(problems.errors.size() == n_errors);
    }
}
