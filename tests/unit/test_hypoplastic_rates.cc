// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/material/hypoplastic_rate.h>

#include <catch2/catch.hpp>

#include <cmath>

#include "law_tools.h"

using namespace Riedel;
using Material::HypoplasticConstants;
using Material::HypoplasticFlags;

namespace
{
  constexpr double kPa = 1e3;

  HypoplasticConstants
  karlsruhe()
  {
    HypoplasticConstants constants;
    constants.critical_friction_angle = std::atan(1.) * 4. / 6.;
    constants.granular_hardness       = 190e6;
    constants.minimum_void_ratio      = .51;
    constants.critical_void_ratio     = .82;
    constants.maximum_void_ratio      = 1.3;
    constants.density_exponent        = .3;
    constants.hardness_exponent       = .5;
    constants.mean_grain_diameter     = .5e-3;
    constants.derive();
    return constants;
  }

  using Stress     = Material::HypoplasticStress<true, double>;
  using Stretching = Material::HypoplasticStretching<true, double>;

  /// Objective rates; stress in Pa, couple stress in N/m.
  Stress
  rate(const HypoplasticConstants &constants,
       Stress                      stress,
       const double                void_ratio,
       Stretching                  d)
  {
    HypoplasticFlags flags;
    for (unsigned int i = 0; i < 2; ++i)
      {
        stress[5 + i] /= constants.mean_grain_diameter;
        d[4 + i] *= constants.mean_grain_diameter;
      }
    Stress result = Material::hypoplastic_rate<true, double>(
      constants, stress, void_ratio, d, Material::stretching_length(d), flags);
    for (unsigned int i = 0; i < 2; ++i)
      result[5 + i] *= constants.mean_grain_diameter;
    CHECK_FALSE(flags.clamped);
    CHECK_FALSE(flags.null_deviator);
    return result;
  }
} // namespace



TEST_CASE("constants of Karlsruhe sand (benchmarks.md D, physics.md 2)",
          "[unit][hypoplastic]")
{
  const HypoplasticConstants constants = karlsruhe();
  CHECK(constants.c_1 == Approx(3.06186218).epsilon(1e-9));
  CHECK(constants.c_2 == Approx(2.625).epsilon(1e-14));
  CHECK(constants.h_i == Approx(.19034897).margin(1e-8));
}



TEST_CASE("golden rate (benchmarks.md D1)", "[unit][hypoplastic]")
{
  const HypoplasticConstants constants = karlsruhe();

  const double trace       = -370. * kPa;
  const double s_33        = 120. / 370. - 1. / 3.;
  const double determinant = (100. / 370. - 1. / 3.) * (150. / 370. - 1. / 3.) -
                             20. * 10. / (370. * 370.);
  HypoplasticFlags                           flags;
  const Material::HypoplasticFactors<double> factors(
    constants, trace, s_33, determinant, .65, flags);
  CHECK(factors.f_s == Approx(304118.8393554030 * kPa).epsilon(1e-12));
  CHECK(factors.f_d == Approx(.834081919300).epsilon(1e-11));
  CHECK(factors.a_1 == Approx(.306206907504).epsilon(1e-11));

  const Stress result     = rate(constants,
                             {{-100. * kPa,
                                   -150. * kPa,
                                   -120. * kPa,
                                   20. * kPa,
                                   10. * kPa,
                                   .02 * kPa,
                                   -.01 * kPa}},
                             .65,
                             {{-1., .5, .8, .2, 30., -50.}});
  const double expected[] = {-15947.836301664813,
                             51096.530721687144,
                             22275.90828248156,
                             13103.24540247877,
                             848.623813836591,
                             -5.436467203034,
                             2.468727400193};
  for (unsigned int i = 0; i < 7; ++i)
    CHECK(result[i] == Approx(expected[i] * kPa).epsilon(1e-11));
}



TEST_CASE("reference rates with Jaumann terms (rates.csv)",
          "[unit][hypoplastic]")
{
  const HypoplasticConstants constants = karlsruhe();
  const LawTools::Table      table("rates.csv");
  for (unsigned int row = 0; row < table.rows.size(); ++row)
    {
      INFO("row " << row);
      const auto get = [&](const std::string &column) {
        return table.number(row, column);
      };
      const double s[5] = {
        get("s11"), get("s22"), get("s33"), get("s12"), get("s21")};
      const double m[2]     = {get("m1"), get("m2")};
      const double rotation = get("wc");
      const double spin     = .5 * (get("u21") - get("u12"));

      const Stress objective = rate(constants,
                                    {{s[0] * kPa,
                                      s[1] * kPa,
                                      s[2] * kPa,
                                      s[3] * kPa,
                                      s[4] * kPa,
                                      m[0] * kPa,
                                      m[1] * kPa}},
                                    get("e"),
                                    {{get("u11"),
                                      get("u22"),
                                      get("u12") + rotation,
                                      get("u21") - rotation,
                                      get("k1"),
                                      get("k2")}});

      // w sigma - sigma w and w m with w_21 = -w_12 = spin
      const double jaumann[7] = {-spin * (s[4] + s[3]),
                                 spin * (s[3] + s[4]),
                                 0.,
                                 spin * (s[0] - s[1]),
                                 spin * (s[0] - s[1]),
                                 -spin * m[1],
                                 spin * m[0]};
      const char  *columns[7] = {
         "ds11", "ds22", "ds33", "ds12", "ds21", "dm1", "dm2"};
      for (unsigned int i = 0; i < 7; ++i)
        // the file has 12 digits
        CHECK(objective[i] / kPa + jaumann[i] ==
              Approx(get(columns[i])).epsilon(1e-9).margin(1e-9));
      CHECK((1. + get("e")) * (get("u11") + get("u22")) ==
            Approx(get("de")).epsilon(1e-9).margin(1e-9));
    }
}



TEST_CASE("rates do not depend on the direction of the axes",
          "[unit][hypoplastic]")
{
  const HypoplasticConstants constants = karlsruhe();
  const Stress     stress{{-100e3, -150e3, -120e3, 20e3, 10e3, 20., -10.}};
  const Stretching d{{-1., .5, .8, .2, 30., -50.}};

  const double c = std::cos(.7), s = std::sin(.7);
  const auto   turn = [&](const double a11,
                        const double a22,
                        const double a12,
                        const double a21) {
    return std::array<double, 4>{
      {c * c * a11 + s * s * a22 - c * s * (a12 + a21),
       s * s * a11 + c * c * a22 + c * s * (a12 + a21),
       c * c * a12 - s * s * a21 + c * s * (a11 - a22),
       c * c * a21 - s * s * a12 + c * s * (a11 - a22)}};
  };
  const auto turn_stress = [&](const Stress &x) {
    const auto t = turn(x[0], x[1], x[3], x[4]);
    return Stress{
      {t[0], t[1], x[2], t[2], t[3], c * x[5] - s * x[6], s * x[5] + c * x[6]}};
  };
  const auto       t = turn(d[0], d[1], d[2], d[3]);
  const Stretching turned{
    {t[0], t[1], t[2], t[3], c * d[4] - s * d[5], s * d[4] + c * d[5]}};

  const Stress expected = turn_stress(rate(constants, stress, .65, d));
  const Stress found    = rate(constants, turn_stress(stress), .65, turned);
  for (unsigned int i = 0; i < 7; ++i)
    CHECK(found[i] == Approx(expected[i]).epsilon(1e-12));
}
