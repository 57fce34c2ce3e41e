// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/element_test/element_test.h>
#include <riedel/material/hypoplastic_rate.h>

#include <cmath>

#include "law_tools.h"

using namespace Riedel;
using ElementTest::Row;
using ElementTest::Test;

namespace
{
  std::vector<Row>
  run(const Material::Law<2> &law,
      const Test              test,
      const double            void_ratio,
      const double            vertical_pressure,
      const double            axial_strain,
      const unsigned int      steps)
  {
    ElementTest::Parameters parameters;
    parameters.test              = test;
    parameters.void_ratio        = void_ratio;
    parameters.vertical_pressure = vertical_pressure;
    parameters.axial_strain      = axial_strain;
    parameters.steps             = steps;
    ElementTest::ElementTest element_test(parameters, law);
    return element_test.run();
  }

  /// The relative error of the biaxial reference path in steps of this size.
  void
  compare_biaxial(const std::string &law_name,
                  const unsigned int steps,
                  const double       tolerance)
  {
    const auto            law = LawTools::make_law(law_name);
    const unsigned int    e   = law->layout().find("void_ratio");
    const LawTools::Table table("biaxial_point.csv");
    std::string           present;
    std::vector<Row>      rows;
    for (unsigned int i = 0; i < table.rows.size(); ++i)
      {
        const std::string name = table.text(i, "case");
        if (name != present)
          {
            const double void_ratio = std::stod(name.substr(1, 4));
            const double pressure =
              std::stod(name.substr(name.find("_p") + 2)) * 1e3;
            rows    = run(*law, Test::biaxial, void_ratio, pressure, .3, steps);
            present = name;
          }
        const unsigned int step = static_cast<unsigned int>(
          std::lround(table.number(i, "eps1") / .3 * steps));
        const Row &row = rows.at(step);
        INFO(law_name << ", " << steps << " steps, case " << name << ", eps1 "
                      << table.number(i, "eps1"));
        CHECK(-row.strain_11 == Approx(table.number(i, "eps1")).epsilon(1e-12));
        CHECK(row.state[0] ==
              Approx(table.number(i, "s11") * 1e3).epsilon(tolerance));
        CHECK(row.state[2] ==
              Approx(table.number(i, "s33") * 1e3).epsilon(tolerance));
        CHECK(row.state[e] == Approx(table.number(i, "e")).epsilon(tolerance));
        CHECK(row.strain_22 ==
              Approx(table.number(i, "eps22")).epsilon(20. * tolerance));
        CHECK(row.mobilised_friction ==
              Approx(table.number(i, "phi_deg")).margin(20. * tolerance));
        CHECK_FALSE(row.floored);
        CHECK_FALSE(row.clamped);
      }
  }
} // namespace



TEST_CASE("biaxial compression of a point (biaxial_point.csv, D2)",
          "[unit][hypoplastic][paths]")
{
  // sigma_22 is constant at the ends of the steps only, which is an error of
  // second order in the step: 6e-6 at 1e-4, 6e-8 at 1e-5. One substep is
  // enough for each of these steps with the default tolerance.
  compare_biaxial("polar hypoplastic", 3000, 1e-5);
  compare_biaxial("hypoplastic", 3000, 1e-5);
  compare_biaxial("hypoplastic", 30000, 1e-7);
}



TEST_CASE("peak friction in biaxial compression (D2)",
          "[unit][hypoplastic][paths]")
{
  const auto peak = [](const double void_ratio, const double pressure) {
    const auto law = LawTools::make_law("polar hypoplastic");
    Row        best;
    for (const Row &row :
         run(*law, Test::biaxial, void_ratio, pressure, .08, 4000))
      if (row.mobilised_friction > best.mobilised_friction)
        best = row;
    return best;
  };
  const Row dense = peak(.6, 100e3);
  CHECK(dense.mobilised_friction == Approx(47.5922).margin(2e-4));
  CHECK(-dense.strain_11 == Approx(.0206).margin(1e-4));
  const Row medium = peak(.75, 100e3);
  CHECK(medium.mobilised_friction == Approx(36.1376).margin(2e-4));
  CHECK(-medium.strain_11 == Approx(.0275).margin(1e-4));
  const Row deep = peak(.6, 1000e3);
  CHECK(deep.mobilised_friction == Approx(40.2211).margin(2e-4));
  CHECK(-deep.strain_11 == Approx(.0603).margin(1e-4));
}



TEST_CASE("critical state in plane strain", "[unit][hypoplastic][paths]")
{
  const auto         law  = LawTools::make_law("polar hypoplastic");
  const auto         rows = run(*law, Test::biaxial, .6, 100e3, 6., 30000);
  const Row         &end  = rows.back();
  const double       p    = -(end.state[0] + end.state[1] + end.state[2]) / 3.;
  const unsigned int e    = law->layout().find("void_ratio");
  const double       e_c  = .82 * std::exp(-std::sqrt(3. * p / 190e6));
  CHECK(end.state[e] == Approx(e_c).epsilon(1e-4));
  CHECK(std::sin(end.mobilised_friction * std::atan(1.) / 45.) ==
        Approx(.564181).margin(2e-5));
}



TEST_CASE("oedometric compression (compression.csv, D3)",
          "[unit][hypoplastic][paths]")
{
  const auto            law = LawTools::make_law("polar hypoplastic");
  const unsigned int    e   = law->layout().find("void_ratio");
  const LawTools::Table table("compression.csv");
  unsigned int          compared = 0;
  for (const double void_ratio : {.6, .75})
    {
      const auto rows = run(*law, Test::oedometer, void_ratio, 1e3, .03, 2400);
      for (unsigned int i = 0; i < table.rows.size(); ++i)
        if (table.text(i, "test") == "oedo" &&
            table.number(i, "e0") == void_ratio)
          {
            const Row &row =
              rows.at(std::lround(table.number(i, "eps_vert") / .03 * 2400));
            INFO("e0 " << void_ratio << ", eps "
                       << table.number(i, "eps_vert"));
            CHECK(row.state[1] ==
                  Approx(table.number(i, "s_vert") * 1e3).epsilon(1e-5));
            CHECK(row.state[0] ==
                  Approx(table.number(i, "s_lat") * 1e3).epsilon(1e-5));
            CHECK(row.state[2] == Approx(row.state[0]).epsilon(1e-9));
            CHECK(row.state[e] == Approx(table.number(i, "e")).epsilon(1e-7));
            ++compared;
          }
    }
  CHECK(compared == 12);

  const auto loose = run(*law, Test::oedometer, .85, 1e3, .01, 800);
  CHECK(loose.back().state[1] == Approx(-151.079e3).epsilon(1e-5));
}



// Isotropic and triaxial compression are not plane strain. They check the
// scalar factors of the law, f_s, f_d and a_1, with the rate written out for
// principal axes here.
namespace
{
  struct PrincipalState
  {
    double s1, s2; // axial stress and the two equal lateral ones [Pa]
    double e;
  };

  Material::HypoplasticConstants
  karlsruhe()
  {
    Material::HypoplasticConstants constants;
    constants.critical_friction_angle = std::atan(1.) * 4. / 6.;
    constants.granular_hardness       = 190e6;
    constants.minimum_void_ratio      = .51;
    constants.critical_void_ratio     = .82;
    constants.maximum_void_ratio      = 1.3;
    constants.density_exponent        = .3;
    constants.hardness_exponent       = .5;
    constants.derive();
    return constants;
  }

  PrincipalState
  principal_rate(const PrincipalState &state, const double d1, const double d2)
  {
    const Material::HypoplasticConstants       constants = karlsruhe();
    Material::HypoplasticFlags                 flags;
    const double                               trace = state.s1 + 2. * state.s2;
    const double                               h1    = state.s1 / trace;
    const double                               h2    = state.s2 / trace;
    const Material::HypoplasticFactors<double> factors(constants,
                                                       trace,
                                                       h2 - 1. / 3.,
                                                       (h1 - 1. / 3.) *
                                                         (h2 - 1. / 3.),
                                                       state.e,
                                                       flags);
    const double r      = std::sqrt(d1 * d1 + 2. * d2 * d2);
    const double inner  = h1 * d1 + 2. * h2 * d2;
    const double a      = factors.a_1;
    const auto   stress = [&](const double h, const double d) {
      return factors.f_s *
             (a * a * d + h * inner + factors.f_d * a * (2. * h - 1. / 3.) * r);
    };
    return {stress(h1, d1), stress(h2, d2), (1. + state.e) * (d1 + 2. * d2)};
  }

  template <typename Rate>
  void
  advance(PrincipalState &state, const double step, const Rate &rate)
  {
    const auto shifted = [&](const PrincipalState &k, const double h) {
      return PrincipalState{state.s1 + h * k.s1,
                            state.s2 + h * k.s2,
                            state.e + h * k.e};
    };
    const PrincipalState k1 = rate(state);
    const PrincipalState k2 = rate(shifted(k1, step / 2));
    const PrincipalState k3 = rate(shifted(k2, step / 2));
    const PrincipalState k4 = rate(shifted(k3, step));
    state                   = PrincipalState{
      state.s1 + step / 6 * (k1.s1 + 2 * k2.s1 + 2 * k3.s1 + k4.s1),
      state.s2 + step / 6 * (k1.s2 + 2 * k2.s2 + 2 * k3.s2 + k4.s2),
      state.e + step / 6 * (k1.e + 2 * k2.e + 2 * k3.e + k4.e)};
  }
} // namespace



TEST_CASE("isotropic compression (compression.csv)",
          "[unit][hypoplastic][paths]")
{
  const LawTools::Table table("compression.csv");
  unsigned int          compared = 0;
  for (const double void_ratio : {.6, .75})
    {
      PrincipalState state{-1e3, -1e3, void_ratio};
      double         strain = 0.;
      for (unsigned int i = 0; i < table.rows.size(); ++i)
        if (table.text(i, "test") == "iso" &&
            table.number(i, "e0") == void_ratio)
          {
            const double end = table.number(i, "eps_vert");
            for (unsigned int s = 0; s < 2000; ++s)
              advance(state, (end - strain) / 2000, [](const auto &y) {
                return principal_rate(y, -1., -1.);
              });
            strain = end;
            // the first row of the file is good to 3e-7
            CHECK(state.s1 ==
                  Approx(table.number(i, "s_vert") * 1e3).epsilon(1e-6));
            CHECK(state.e == Approx(table.number(i, "e")).epsilon(1e-7));
            ++compared;
          }
    }
  CHECK(compared == 14);
}



TEST_CASE("triaxial peaks and the critical friction angle (D3)",
          "[unit][hypoplastic][paths]")
{
  const auto compress = [](const double void_ratio, const double strain) {
    PrincipalState state{-100e3, -100e3, void_ratio};
    double         peak = 0., at = 0., angle = 0.;
    const double   step = strain / 20000;
    for (unsigned int i = 0; i < 20000; ++i)
      {
        advance(state, step, [](const PrincipalState &y) {
          // lateral stretching that keeps the lateral stress
          double low = -1., high = 3.;
          for (unsigned int b = 0; b < 60; ++b)
            {
              const double middle = .5 * (low + high);
              (principal_rate(y, -1., middle).s2 < 0. ? low : high) = middle;
            }
          return principal_rate(y, -1., low);
        });
        angle = std::asin((state.s1 - state.s2) / (state.s1 + state.s2)) * 45. /
                std::atan(1.);
        if (angle > peak)
          {
            peak = angle;
            at   = (i + 1) * step;
          }
      }
    return std::array<double, 3>{{peak, at, angle}};
  };
  const auto dense = compress(.6, .05);
  CHECK(dense[0] == Approx(44.01).margin(.006));
  CHECK(dense[1] == Approx(.0258).margin(1e-4));
  CHECK(compress(.65, .1)[0] == Approx(38.29).margin(.006));
  CHECK(compress(.7, .1)[0] == Approx(34.47).margin(.006));
  // with a plus sign before cos 3 theta it would be 22 degrees
  CHECK(compress(.7, 8.)[2] == Approx(30.).margin(1e-2));
}
