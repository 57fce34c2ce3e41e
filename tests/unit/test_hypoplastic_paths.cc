// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/element_test/element_test.h>

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



TEST_CASE("isotropic compression (compression.csv)",
          "[unit][hypoplastic][paths]")
{
  for (const std::string law_name : {"polar hypoplastic", "hypoplastic"})
    {
      const auto            law = LawTools::make_law(law_name);
      const unsigned int    e   = law->layout().find("void_ratio");
      const LawTools::Table table("compression.csv");
      unsigned int          compared = 0;
      for (const double void_ratio : {.6, .75})
        {
          const auto rows =
            run(*law, Test::isotropic, void_ratio, 1e3, .014, 2800);
          for (unsigned int i = 0; i < table.rows.size(); ++i)
            if (table.text(i, "test") == "iso" &&
                table.number(i, "e0") == void_ratio)
              {
                const Row &row =
                  rows.at(std::lround(table.number(i, "eps_vert") / 5e-6));
                INFO(law_name << ", e0 " << void_ratio << ", eps "
                              << table.number(i, "eps_vert"));
                for (unsigned int axis = 0; axis < 3; ++axis)
                  CHECK(row.state[axis] ==
                        Approx(table.number(i, "s_vert") * 1e3).epsilon(1e-5));
                CHECK(row.state[e] ==
                      Approx(table.number(i, "e")).epsilon(1e-7));
                CHECK(row.deviator < 1e-9 * row.mean_pressure);
                ++compared;
              }
        }
      CHECK(compared == 14);
    }
}



TEST_CASE("isotropic compression of the loosest packing is the law e_i(p)",
          "[unit][hypoplastic][paths]")
{
  // eq. (22): e = e_i0 exp(-(3 p/h_s)^n) is a solution of the rate
  const auto law = LawTools::make_law("polar hypoplastic");
  const auto e_i = [](const double p) {
    return 1.3 * std::exp(-std::sqrt(3. * p / 190e6));
  };
  const auto rows      = run(*law, Test::isotropic, e_i(1e3), 1e3, .05, 5000);
  const unsigned int e = law->layout().find("void_ratio");
  CHECK(rows.back().mean_pressure > 500e3);
  for (unsigned int i = 0; i < rows.size(); i += 500)
    CHECK(rows[i].state[e] == Approx(e_i(rows[i].mean_pressure)).epsilon(1e-6));
}



TEST_CASE("drained triaxial peaks (D3)", "[unit][hypoplastic][paths]")
{
  const auto law  = LawTools::make_law("polar hypoplastic");
  const auto peak = [&](const double void_ratio) {
    Row best;
    for (const Row &row :
         run(*law, Test::triaxial_drained, void_ratio, 100e3, .1, 5000))
      if (row.mobilised_friction > best.mobilised_friction)
        best = row;
    // the cell pressure, on both lateral axes
    CHECK(best.state[1] == Approx(-100e3).epsilon(1e-11));
    CHECK(best.state[2] == Approx(best.state[1]).epsilon(1e-12));
    CHECK(best.strain_33 == Approx(best.strain_22).epsilon(1e-12));
    return best;
  };
  const Row dense = peak(.6);
  CHECK(dense.mobilised_friction == Approx(44.01).margin(.005));
  CHECK(-dense.strain_11 == Approx(.0258).margin(5e-5));
  CHECK(peak(.65).mobilised_friction == Approx(38.29).margin(.005));
  CHECK(peak(.7).mobilised_friction == Approx(34.47).margin(.005));
}



TEST_CASE("triaxial compression ends at the critical friction angle",
          "[unit][hypoplastic][paths]")
{
  // with a plus sign before cos 3 theta it would be 22 degrees
  const auto         law = LawTools::make_law("polar hypoplastic");
  const unsigned int e   = law->layout().find("void_ratio");
  const auto         e_c = [](const double p) {
    return .82 * std::exp(-std::sqrt(3. * p / 190e6));
  };
  for (const double void_ratio : {.6, .9})
    {
      const Row end =
        run(*law, Test::triaxial_drained, void_ratio, 100e3, 6., 20000).back();
      INFO("drained, e0 " << void_ratio);
      CHECK(end.mobilised_friction == Approx(30.).margin(1e-3));
      CHECK(end.state[e] == Approx(e_c(end.mean_pressure)).epsilon(1e-4));
    }

  // Undrained, the pressure comes to where the void ratio is critical: dense
  // sand gains pressure, loose sand loses it.
  for (const double void_ratio : {.75, .8})
    {
      const auto rows =
        run(*law, Test::triaxial_undrained, void_ratio, 100e3, 3., 60000);
      double error = 0.;
      for (const Row &row : rows)
        error = std::max({error,
                          std::abs(row.volumetric_strain()),
                          std::abs(row.state[e] - void_ratio)});
      const Row   &end = rows.back();
      const double p_c = 190e6 / 3. * std::pow(std::log(.82 / void_ratio), 2);
      INFO("undrained, e0 " << void_ratio);
      CHECK(error < 1e-12);
      CHECK(end.mobilised_friction == Approx(30.).margin(1e-3));
      CHECK(end.deviator / end.mean_pressure == Approx(1.2).epsilon(1e-4));
      CHECK(end.mean_pressure == Approx(p_c).epsilon(1e-3));
      CHECK(end.excess_pore_pressure ==
            Approx(100e3 + end.state[1]).epsilon(1e-14));
      CHECK((end.excess_pore_pressure > 0.) == (void_ratio == .8));
    }
}



TEST_CASE("simple shear", "[unit][hypoplastic][paths]")
{
  const auto              polar     = LawTools::make_law("polar hypoplastic");
  const auto              classical = LawTools::make_law("hypoplastic");
  ElementTest::Parameters parameters;
  parameters.test              = Test::simple_shear;
  parameters.void_ratio        = .7;
  parameters.vertical_pressure = 100e3;
  parameters.shear_strain      = 8.;
  parameters.steps             = 20000;
  const auto end               = [&](const Material::Law<2> &law) {
    ElementTest::ElementTest test(parameters, law);
    return test.run().back();
  };

  const auto angle = [](const Row &row) {
    return std::atan(row.state[3] / -row.state[1]) * 45. / std::atan(1.);
  };

  SECTION("at constant normal stress: tan = sin of plane strain")
  {
    // The stress turns with the spin and must be turned back all the time,
    // which costs an angle in proportion to p/f_s, that is to sqrt(p): the
    // critical angle without it is that of no pressure.
    const auto at_pressure = [&](const double pressure) {
      parameters.vertical_pressure = pressure;
      return end(*polar);
    };
    const Row low  = at_pressure(4e3);
    const Row high = at_pressure(16e3);
    CHECK(2. * angle(low) - angle(high) == Approx(29.431).margin(1e-3));
    CHECK(angle(low) - angle(high) > .01);

    CHECK(high.state[1] == Approx(-16e3).epsilon(1e-11));
    CHECK(high.strain_11 == Approx(0.).margin(1e-12));
    CHECK(high.strain_33 == 0.);
    CHECK(high.shear_strain == Approx(8.).epsilon(1e-10));
    // grains that turn with the continuum: nothing is polar
    CHECK(high.state[4] == Approx(high.state[3]).epsilon(1e-10));
    CHECK(end(*classical).state[3] == Approx(high.state[3]).epsilon(1e-9));
  }

  SECTION("at constant volume the void ratio stays")
  {
    parameters.shear_keeps_volume = true;
    const unsigned int e          = polar->layout().find("void_ratio");
    const Row          row        = end(*polar);
    CHECK(row.state[e] == Approx(.7).epsilon(1e-12));
    CHECK(row.excess_pore_pressure ==
          Approx(row.state[1] + 100e3).epsilon(1e-14));
    CHECK(.82 * std::exp(-std::sqrt(3. * row.mean_pressure / 190e6)) ==
          Approx(.7).epsilon(1e-3));
  }

  SECTION("grains that do not turn make the stress skew")
  {
    parameters.shear_strain    = .05;
    parameters.turns_with_spin = false;
    const Row held             = end(*polar);
    CHECK(std::abs(held.state[3] - held.state[4]) > .1 * held.state[3]);
    // with the angle of the spin they turn as the continuum does
    parameters.micro_rotation  = -.025;
    const Row turned           = end(*polar);
    parameters.turns_with_spin = true;
    CHECK(turned.state[3] == Approx(end(*polar).state[3]).epsilon(1e-9));
  }
}
