// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/material/drucker_prager.h>
#include <riedel/material/return_mapping.h>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <random>

#include "law_tools.h"

using namespace Riedel;
using LawTools::Answer;
using LawTools::make_law;
using LawTools::respond;
using LawTools::Settings;

namespace
{
  /// the constants of B7
  const Settings soil = {{"Lame modulus", "8000"},
                         {"Shear modulus", "6000"},
                         {"Couple modulus", "3000"},
                         {"Bending modulus", "1.2"},
                         {"Friction angle", "30"},
                         {"Dilatancy angle", "10"},
                         {"Cohesion", "20"}};

  Settings
  with(Settings settings, const Settings &changes)
  {
    for (const auto &[entry, value] : changes)
      settings[entry] = value;
    return settings;
  }

  std::vector<double>
  stress_free(const Material::Law<2> &law)
  {
    std::vector<double> state(law.layout().size());
    law.initialise({}, state.data());
    return state;
  }

  double
  slot(const Material::Law<2>    &law,
       const std::vector<double> &state,
       const std::string         &name)
  {
    return state[law.layout().find(name)];
  }



  /// The largest difference of the tangent from central differences, relative
  /// to the largest component; rotations and curvatures in units of strain.
  double
  tangent_error(const Material::Law<2>    &law,
                const std::vector<double> &state,
                const std::vector<double> &d,
                const double               length)
  {
    const unsigned int n      = law.n_generalised();
    const auto         answer = respond(law, state, d, true);
    REQUIRE(answer.report.refused == 0);
    double largest = 0., error = 0.;
    for (unsigned int b = 0; b < n; ++b)
      {
        const double unit = b < 5 ? 1. : 1. / length;
        const double step = 3e-7 * unit;
        auto         plus = d, minus = d;
        plus[b] += step;
        minus[b] -= step;
        const auto up   = respond(law, state, plus).stresses;
        const auto down = respond(law, state, minus).stresses;
        for (unsigned int a = 0; a < n; ++a)
          {
            const double scale = unit * (a < 5 ? 1. : 1. / length);
            const double ours  = answer.tangent[a * n + b] * scale;
            largest            = std::max(largest, std::abs(ours));
            error              = std::max(error,
                             std::abs(ours -
                                      (up[a] - down[a]) / (2. * step) * scale));
          }
      }
    return error / largest;
  }
} // namespace



TEST_CASE("constants of the cone (B7)", "[unit][drucker_prager]")
{
  constexpr double     degree = M_PI / 180.;
  const Material::Cone plane("plane strain", 30 * degree, 10 * degree);
  CHECK(plane.friction == Approx(.84588575).margin(1e-8));
  CHECK(plane.dilatancy == Approx(.29926722).margin(1e-8));
  CHECK(20. * plane.strength_per_cohesion == Approx(29.30234178).margin(1e-8));
  const Material::Cone compression("compression", 30 * degree, 0.);
  CHECK(compression.friction == Approx(1.2).epsilon(1e-14));
  CHECK(compression.dilatancy == 0.);
  const Material::Cone extension("extension", 30 * degree, 30 * degree);
  CHECK(extension.friction == Approx(6. * .5 / 3.5).epsilon(1e-14));
  CHECK(extension.dilatancy == Approx(extension.friction).epsilon(1e-14));
  // associated flow in plane strain: A = B = sqrt3 sin/sqrt(1 + sin^2/3)
  const Material::Cone associated("plane strain", .5, .5);
  CHECK(associated.friction == Approx(associated.dilatancy).epsilon(1e-14));
}



TEST_CASE("return of a large step (B7)", "[unit][drucker_prager]")
{
  struct Expected
  {
    std::string           set;
    double                multiplier;
    std::array<double, 7> stress; // 11, 22, 33, 12, 21, m1, m2
  };
  // s12 of the second set has been computed to more digits than are printed in
  // benchmarks.md, whose seventh digit of it is wrong by 4 units
  const Expected cases[] = {{"de Borst",
                             .032684654928,
                             {{-158.136634689,
                               -335.965732639,
                               -230.0129792,
                               220.121783799,
                               -20.507435244,
                               .100385537187,
                               -.176530531879}}},
                            {"static",
                             .035021341132,
                             {{-172.171639753,
                               -341.582481520,
                               -239.616445967,
                               132.601617642,
                               65.665826984,
                               .057220441226,
                               -.101044680687}}}};
  for (const Expected &expected : cases)
    {
      const auto law = make_law("Drucker-Prager micropolar",
                                with(soil, {{"J2 constants", expected.set}}));
      CHECK(law->length() == Approx(.01).epsilon(1e-14));
      // k = Gamma dQ^T
      const double              c = std::cos(-.01), s = std::sin(-.01);
      const std::vector<double> d{
        .02, .06, 0., -.03, -.01, .3 * c - .5 * s, -.3 * s - .5 * c};
      const auto answer = respond(*law, stress_free(*law), d);
      CHECK(slot(*law, answer.state, "plastic_multiplier") ==
            Approx(expected.multiplier).epsilon(1e-8));
      for (unsigned int i = 0; i < 7; ++i)
        CHECK(answer.state[i] == Approx(expected.stress[i]).epsilon(1e-8));
      CHECK(slot(*law, answer.state, "cohesion") == Approx(20.));
      CHECK(std::abs(slot(*law, answer.state, "yield_function")) < 1e-9);
      CHECK(answer.report.yielding == 1);
      CHECK(answer.report.at_apex == 0);
    }
}



TEST_CASE("tangents of plastic laws against central differences",
          "[unit][drucker_prager]")
{
  std::mt19937                     generator(5);
  std::uniform_real_distribution<> uniform(-1., 1.);
  unsigned int                     n_apex = 0, n_smooth = 0, n_elastic = 0;
  const std::vector<std::pair<std::string, Settings>> laws = {
    {"Drucker-Prager micropolar", soil},
    {"Drucker-Prager micropolar", with(soil, {{"J2 constants", "static"}})},
    {"Drucker-Prager micropolar",
     with(soil,
          {{"J2 constants", "0.1, 0.4, 2"},
           {"Dilatancy angle", "30"},
           {"Hardening", "linear"},
           {"Hardening modulus", "-300"},
           {"Residual cohesion", "4"}})},
    {"Drucker-Prager micropolar",
     with(soil,
          {{"Hardening", "exponential"},
           {"Residual cohesion", "8"},
           {"Softening strain", "0.05"}})},
    {"Drucker-Prager micropolar",
     with(soil,
          {{"Dilatancy angle", "0"},
           {"J2 constants", "kinematic"},
           {"Hardening", "linear"},
           {"Hardening modulus", "300"},
           {"Residual cohesion", "80"}})},
    {"Drucker-Prager", {{"Lame modulus", "8000"}, {"Shear modulus", "6000"}}},
    {"von Mises micropolar",
     {{"J2 constants", "kinematic"},
      {"Hardening", "linear"},
      {"Hardening modulus", "-200"},
      {"Residual yield stress", "10"}}},
    {"von Mises",
     {{"Hardening", "linear"},
      {"Hardening modulus", "100"},
      {"Residual yield stress", "1e9"}}}};
  for (const auto &[name, settings] : laws)
    for (const double size : {3e-3, .05, .3})
      for (unsigned int sample = 0; sample < 25; ++sample)
        {
          const auto         law    = make_law(name, settings);
          const unsigned int n      = law->n_generalised();
          const double       length = law->is_micropolar() ? law->length() : 1.;
          const auto         increments = [&](const double factor) {
            std::vector<double> d(n);
            for (unsigned int i = 0; i < n; ++i)
              d[i] = factor * (i < 5 ? 1. : 1. / length) * uniform(generator);
            return d;
          };
          // a state that has yielded, then any step; every third sample is
          // pulled, to come to the apex
          auto first = increments(.01);
          if (sample % 3 == 0)
            first[0] = first[3] = .02;
          const auto start  = respond(*law, stress_free(*law), first).state;
          auto       second = increments(size);
          if (sample % 3 == 0)
            {
              second[0] += size;
              second[3] += size;
            }
          const auto answer = respond(*law, start, second);
          if (answer.report.refused > 0)
            {
              CHECK(answer.report.reason ==
                    Material::Report::Refusal::inverted_step);
              continue;
            }
          n_apex += answer.report.at_apex;
          n_smooth += answer.report.yielding - answer.report.at_apex;
          n_elastic += answer.report.yielding == 0;
          CHECK(slot(*law, answer.state, "yield_function") <
                1e-9 * (20. + std::abs(answer.state[0])));
          INFO(name << " size " << size << " sample " << sample << " apex "
                    << answer.report.at_apex);
          CHECK(tangent_error(*law, start, second, length) < 3e-6);
        }
  INFO("elastic " << n_elastic << " smooth " << n_smooth << " apex " << n_apex);
  CHECK(n_smooth > 200);
  CHECK(n_apex > 50);
  CHECK(n_elastic > 2);
}



TEST_CASE("Newton's method of the return is quadratic",
          "[unit][drucker_prager]")
{
  Material::NeoHookeanElasticity elasticity;
  elasticity.lambda = 8000.;
  elasticity.mu = elasticity.kappa = 6000.;
  elasticity.gamma                 = 1.2;
  Material::DruckerPragerPlasticity plasticity;
  plasticity.length = elasticity.length();
  const Material::Cone cone("plane strain", M_PI / 6, M_PI / 18);
  plasticity.friction  = cone.friction;
  plasticity.dilatancy = cone.dilatancy;
  plasticity.strength  = 20. * cone.strength_per_cohesion;
  const std::array<std::array<double, 3>, 3> sets = {
    {{{.25, .25, .5}}, {{-.25, .75, 1.}}, {{.125, .375, .25}}}};
  std::ostringstream table;
  for (const auto &[a1, a2, a3] : sets)
    for (const double size : {.1, 1., 5.})
      {
        plasticity.a1 = a1, plasticity.a2 = a2, plasticity.a3 = a3;
        Material::StretchAndCurvature<2, double> rest;
        rest.elastic.components.fill(0.);
        rest.total.components.fill(0.);
        rest.curvature.components.fill(0.);
        const std::array<double, 7>                 d{{.02 * size,
                                                       .06 * size,
                                                       0.,
                                                       -.03 * size,
                                                       -.01 * size,
                                                       .3 * size,
                                                       -.5 * size}};
        Material::FiniteStrainStep<2, true, double> step(d, rest);
        const Material::ReturnMapping<2, true> mapping(elasticity, plasticity);
        std::vector<double>                    trace;
        double                                 a = 0.;
        const auto                             where =
          mapping(step.trial,
                  step.volume,
                  mapping.invariants(mapping.stress(step.trial), step.volume),
                  a,
                  &trace);
        CHECK(where == Material::Return::smooth);
        table << "a = (" << a1 << ", " << a2 << ", " << a3 << "), size " << size
              << ":";
        for (const double r : trace)
          table << ' ' << std::setprecision(2) << r;
        table << '\n';
        REQUIRE(trace.size() >= 3);
        CHECK(trace.size() <= 10);
        // the last two steps: e_k+1 < C e_k^2, down to rounding
        const unsigned int k = trace.size() - 1;
        CHECK(trace[k] < std::max(1e3 * trace[k - 1] * trace[k - 1], 1e-14));
      }
  INFO(table.str());
  CHECK(true);
}



TEST_CASE("plastic laws are objective", "[unit][drucker_prager]")
{
  // the whole experiment turned: f -> R f R^T; and a rotation that comes
  // afterwards within the step: f -> R f
  for (const std::string name : {"Drucker-Prager micropolar", "Drucker-Prager"})
    for (const std::string set : {"de Borst", "static"})
      {
        const auto law = make_law(name, with(soil, {{"J2 constants", set}}));
        const unsigned int  n = law->n_generalised();
        std::vector<double> first{.01, -.03, .02, -.02},
          second{-.02, .03, .04, .01};
        if (n == 7)
          {
            first.insert(first.end(), {.02, .5, 1.});
            second.insert(second.end(), {-.01, -1., .5});
          }
        const auto a = respond(*law, stress_free(*law), first);
        const auto b = respond(*law, a.state, second);
        REQUIRE(b.report.yielding == 1);

        const double angle = 1.1, c = std::cos(angle), s = std::sin(angle);
        auto         d = second;
        // R (I + H) - I
        d[0] = c * (1. + second[0]) - s * second[2] - 1.;
        d[1] = c * second[1] - s * (1. + second[3]);
        d[2] = s * (1. + second[0]) + c * second[2];
        d[3] = s * second[1] + c * (1. + second[3]) - 1.;
        if (n == 7)
          d[4] += angle;
        const auto t = respond(*law, a.state, d);
        CHECK(t.state[0] == Approx(c * c * b.state[0] + s * s * b.state[1] -
                                   c * s * (b.state[3] + b.state[4]))
                              .epsilon(1e-10));
        CHECK(t.state[2] == Approx(b.state[2]).epsilon(1e-11));
        CHECK(t.state[4] == Approx(c * c * b.state[4] - s * s * b.state[3] +
                                   c * s * (b.state[0] - b.state[1]))
                              .epsilon(1e-10));
        CHECK(slot(*law, t.state, "plastic_multiplier") ==
              Approx(slot(*law, b.state, "plastic_multiplier")).epsilon(1e-11));
        if (n == 7)
          CHECK(t.state[5] ==
                Approx(c * b.state[5] - s * b.state[6]).epsilon(1e-10));
      }
}



TEST_CASE("classical laws are the limit without couple stress",
          "[unit][drucker_prager]")
{
  // a classical law against a micropolar one whose grains turn freely: with
  // kappa = 0 their rotation has no meaning
  const auto classical = make_law("Drucker-Prager", soil);
  const auto polar =
    make_law("Drucker-Prager micropolar",
             with(soil, {{"Couple modulus", "0"}, {"J2 constants", "static"}}));
  auto a = stress_free(*classical), b = stress_free(*polar);
  for (unsigned int step = 0; step < 10; ++step)
    {
      const std::vector<double> d{-.01, .02, .01, .004};
      const auto                x = respond(*classical, a, d);
      const auto                y =
        respond(*polar, b, {d[0], d[1], d[2], d[3], .1 * step, 0., 0.});
      for (unsigned int i = 0; i < 4; ++i)
        CHECK(y.stresses[i] == Approx(x.stresses[i]).epsilon(1e-9));
      a = x.state;
      b = y.state;
      CHECK(x.report.yielding == 1);
      // its elastic stretch is symmetric
      const unsigned int e = classical->layout().find("elastic_strain");
      CHECK(a[e + 3] == Approx(a[e + 4]).margin(1e-14));
    }
}



TEST_CASE("the limit of plane strain is that of Mohr and Coulomb",
          "[unit][drucker_prager]")
{
  // Shear of a point under kept stress: associated flow and the plane strain
  // match give (s1 - s3)/2 = c' cos phi - (s1 + s3)/2 sin phi in the end.
  for (const auto &[phi, psi] :
       {std::pair<double, double>{20., 20.}, {30., 10.}, {30., 0.}})
    {
      const auto law =
        make_law("Drucker-Prager",
                 with(soil,
                      {{"Friction angle", std::to_string(phi)},
                       {"Dilatancy angle", std::to_string(psi)}}));
      auto state = stress_free(*law);
      // the flow of plane strain with the dilatancy angle: e11 + e22 =
      // sin(psi) |e11 - e22|; logarithmic
      const double s = std::sin(psi * M_PI / 180.);
      for (unsigned int step = 0; step < 400; ++step)
        {
          const double e = 2e-4;
          state =
            respond(
              *law,
              state,
              {std::expm1(-e * (1. - s)), 0., 0., std::expm1(e * (1. + s))})
              .state;
        }
      const double angle = phi * M_PI / 180.;
      const double shear = .5 * (state[1] - state[0]);
      const double limit =
        20. * std::cos(angle) - .5 * (state[0] + state[1]) * std::sin(angle);
      CHECK(shear == Approx(limit).epsilon(1e-6));
    }
}



TEST_CASE("rules of the plastic constants", "[unit][drucker_prager]")
{
  const auto problems = [](const std::string &law, const Settings &changes) {
    Problems result;
    make_law(law, changes)->check("M", result);
    return result;
  };
  const std::string dp = "Drucker-Prager micropolar",
                    vm = "von Mises micropolar";
  CHECK(problems(dp, {}).errors.empty());
  CHECK(problems(dp, {}).warnings.empty());
  CHECK(problems(vm, {}).errors.empty());
  const std::vector<std::array<std::string, 4>> wrong = {
    {{dp, "Shear modulus", "0", "mu > 0"}},
    {{dp, "Lame modulus", "-1400", "3 lambda + 2 mu > 0"}},
    {{dp, "Couple modulus", "-1", "mu_c >= 0"}},
    {{dp, "Bending modulus", "0", "gamma > 0"}},
    {{dp, "Curvature modulus beta", "-40", "gamma > |beta|"}},
    {{dp, "Curvature modulus alpha", "-14", "3 alpha + beta + gamma > 0"}},
    {{dp, "J2 constants", "0.3, 0.2, 1", "a2 >= a1"}},
    {{dp, "J2 constants", "0.2 0.2 1", "a1 + a2"}},
    {{dp, "J2 constants", "0.25, 0.25, 0", "a3 > 0"}},
    {{dp, "J2 constants", "my own", "three numbers"}},
    {{dp, "Friction angle", "90", "between 0 and 90"}},
    {{dp, "Dilatancy angle", "31", "friction angle"}},
    {{dp, "Cohesion", "-1", "negative"}},
    {{dp, "Residual cohesion", "-1", "negative"}},
    {{vm, "Yield stress", "0", "positive"}}};
  for (const auto &[law, entry, value, rule] : wrong)
    {
      const auto errors = problems(law, {{entry, value}}).errors;
      INFO(entry << " = " << value);
      REQUIRE(errors.size() == 1);
      CHECK(errors[0].path == "M/" + entry);
      CHECK(errors[0].message.find(rule) != std::string::npos);
    }

  // a strength that falls faster than elastic stress
  const auto steep = problems(vm,
                              {{"Hardening", "linear"},
                               {"Hardening modulus", "-6100"},
                               {"Residual yield stress", "10"}});
  REQUIRE(steep.errors.size() == 1);
  CHECK(steep.errors[0].message.find("3 mu + K A B = 6000") !=
        std::string::npos);
  // mu_c = 500 against |mu_ep| = 2000 h/(6000 - h) = 400 and 571
  const auto softening = [&](const std::string &h) {
    return problems(vm,
                    {{"Hardening", "linear"},
                     {"Hardening modulus", h},
                     {"Residual yield stress", "10"}})
      .warnings;
  };
  CHECK(softening("-1000").empty());
  REQUIRE(softening("-1333").size() == 1);
  CHECK(softening("-1333")[0].message.find("571.2") != std::string::npos);
  // no residual strength
  const auto lost = problems(vm,
                             {{"Hardening", "linear"},
                              {"Hardening modulus", "-500"},
                              {"Residual yield stress", "0"}});
  REQUIRE(lost.warnings.size() == 1);
  CHECK(lost.warnings[0].message.find("couple stress ends") !=
        std::string::npos);
  // an initial stress outside the yield surface
  Material::InitialState initial;
  initial.stress[1][1] = -1000.;
  Problems outside;
  make_law(dp, soil)->check_initial(initial, "Initial state", outside);
  REQUIRE(outside.errors.size() == 1);
  CHECK(outside.errors[0].message.find("outside the yield surface") !=
        std::string::npos);
}



TEST_CASE("a classical law has no length, but one to measure bands by",
          "[unit][drucker_prager]")
{
  for (const auto &[name, length] :
       {std::make_pair("Drucker-Prager micropolar", .01),
        std::make_pair("Drucker-Prager", 0.)})
    {
      const auto law = make_law(name, soil);
      CHECK(law->length() == Approx(length).epsilon(1e-14));
      CHECK(law->grain_size() == Approx(.01).epsilon(1e-14));
      const auto unbent =
        make_law(name, with(soil, {{"Bending modulus", "0"}}));
      CHECK(unbent->grain_size() == 0.);
    }
}
