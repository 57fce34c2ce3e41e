// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <random>

#include "law_tools.h"

using namespace Riedel;
using LawTools::make_law;
using LawTools::make_state;
using LawTools::respond;
using LawTools::rotation;

namespace
{
  // the constants of make_law()
  constexpr double lambda = 1000., mu = 2000., mu_c = 500., bending = 40.;
} // namespace



TEST_CASE("small strain elasticity, component by component", "[unit][elastic]")
{
  const auto law =
    make_law("linear elastic micropolar", {{"Kinematics", "small strain"}});
  CHECK(law->is_geometrically_linear());
  CHECK(law->length() == Approx(std::sqrt(bending / (4. * mu))));

  const std::vector<double> start =
    make_state(*law, {10., 20., 30., 40., 50.}, {6., 7.}, 0.);
  const std::vector<double> d{.1, -.2, .3, .4, .15, 2., -3.};
  const auto                answer = respond(*law, start, d);
  const double              trace  = d[0] + d[3];
  const double              e12 = d[1] + d[4], e21 = d[2] - d[4];
  const double              s11 = 10. + lambda * trace + 2. * mu * d[0];
  const double              s22 = 20. + lambda * trace + 2. * mu * d[3];
  const double              s12 = 40. + (mu + mu_c) * e12 + (mu - mu_c) * e21;
  const double              s21 = 50. + (mu - mu_c) * e12 + (mu + mu_c) * e21;
  CHECK(answer.stresses[0] == Approx(s11).epsilon(1e-14));
  CHECK(answer.stresses[1] == Approx(s12).epsilon(1e-14));
  CHECK(answer.stresses[2] == Approx(s21).epsilon(1e-14));
  CHECK(answer.stresses[3] == Approx(s22).epsilon(1e-14));
  CHECK(answer.stresses[4] == Approx(s12 - s21).epsilon(1e-14));
  CHECK(answer.stresses[5] == Approx(6. + bending * d[5]).epsilon(1e-14));
  CHECK(answer.stresses[6] == Approx(7. + bending * d[6]).epsilon(1e-14));
  CHECK(answer.state[2] == Approx(30. + lambda * trace).epsilon(1e-14));
  CHECK(answer.state[3] == Approx(s12).epsilon(1e-14));

  // the classical law is the same without rotations
  const auto classical =
    make_law("linear elastic", {{"Kinematics", "small strain"}});
  const auto c = respond(*classical,
                         make_state(*classical, {0., 0., 0., 0., 0.}, {}, 0.),
                         {.1, -.2, .3, .4});
  CHECK(c.stresses[1] == Approx(mu * .1).epsilon(1e-14));
  CHECK(c.stresses[2] == c.stresses[1]);
  CHECK(c.stresses[0] == Approx(lambda * .5 + 2. * mu * .1).epsilon(1e-14));
}



TEST_CASE("finite rotations of an elastic body give no stress",
          "[unit][elastic]")
{
  for (const std::string name : {"linear elastic micropolar", "linear elastic"})
    {
      const auto law = make_law(name);
      CHECK_FALSE(law->is_geometrically_linear());
      for (const double angle : {.001, .3, 1.5707963267948966, 3.})
        {
          const auto answer =
            respond(*law,
                    std::vector<double>(law->layout().size(), 0.),
                    rotation(angle, law->n_generalised()));
          for (const double stress : answer.stresses)
            CHECK(std::abs(stress) < 1e-12 * mu);
        }

      // and they turn a stress that is there
      auto state = make_state(*law, {100., -50., 20., 30., 30.}, {4., 1.}, 0.);
      for (unsigned int step = 0; step < 36; ++step)
        state = respond(*law,
                        state,
                        rotation(1.5707963267948966 / 36, law->n_generalised()))
                  .state;
      CHECK(state[0] == Approx(-50.).epsilon(1e-12));
      CHECK(state[1] == Approx(100.).epsilon(1e-12));
      CHECK(state[2] == Approx(20.).epsilon(1e-12));
      CHECK(state[3] == Approx(-30.).epsilon(1e-12));
      if (law->is_micropolar())
        {
          CHECK(state[5] == Approx(-1.).epsilon(1e-11));
          CHECK(state[6] == Approx(4.).epsilon(1e-11));
        }
    }
}



TEST_CASE("finite rotation kinematics: known stretches and objectivity",
          "[unit][elastic]")
{
  const auto                law = make_law("linear elastic micropolar");
  const std::vector<double> zero(law->layout().size(), 0.);

  // uniaxial stretch: logarithmic strain
  auto stretch = respond(*law, zero, {.5, 0., 0., 0., 0., 0., 0.});
  CHECK(stretch.state[0] ==
        Approx((lambda + 2. * mu) * std::log(1.5)).epsilon(1e-13));
  CHECK(stretch.state[2] == Approx(lambda * std::log(1.5)).epsilon(1e-13));
  // P_22 = j sigma_22 / f_22
  CHECK(stretch.stresses[3] == Approx(1.5 * stretch.state[1]).epsilon(1e-13));

  // rotating the whole experiment rotates the result
  const double angle = .8, c = std::cos(angle), s = std::sin(angle);
  const double R[2][2] = {{c, -s}, {s, c}};
  const std::vector<double> d{.02, -.05, .1, .03, .07, 1., -2.};
  std::vector<double>       turned(7, 0.);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      for (int k = 0; k < 2; ++k)
        for (int l = 0; l < 2; ++l)
          turned[2 * i + j] += R[i][k] * d[2 * k + l] * R[j][l];
  turned[4]             = d[4];
  turned[5]             = c * d[5] - s * d[6];
  turned[6]             = s * d[5] + c * d[6];
  const auto a          = respond(*law, zero, d).stresses;
  const auto b          = respond(*law, zero, turned).stresses;
  double     rotated[4] = {0., 0., 0., 0.};
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      for (int k = 0; k < 2; ++k)
        for (int l = 0; l < 2; ++l)
          rotated[2 * i + j] += R[i][k] * a[2 * k + l] * R[j][l];
  for (int i = 0; i < 4; ++i)
    CHECK(b[i] == Approx(rotated[i]).epsilon(1e-12).margin(1e-10));
  CHECK(b[4] == Approx(a[4]).epsilon(1e-12));
  CHECK(b[5] == Approx(c * a[5] - s * a[6]).epsilon(1e-12));

  // a constant velocity gradient in one step or, as its square root, in two
  const auto once  = respond(*law, zero, {.21, 0., 0., 0., 0., 0., 0.});
  const auto half  = respond(*law, zero, {.1, 0., 0., 0., 0., 0., 0.});
  const auto twice = respond(*law, half.state, {.1, 0., 0., 0., 0., 0., 0.});
  CHECK(twice.state[0] == Approx(once.state[0]).epsilon(1e-13));
}



TEST_CASE("simple shear of an elastic body in many steps is Jaumann's",
          "[unit][elastic]")
{
  // closed form of the Jaumann rate in simple shear: sigma_12 = mu sin(gamma),
  // sigma_11 = mu (1 - cos(gamma)); each step is exact for constant velocity
  // gradient, and simple shear has one
  const auto          law = make_law("linear elastic");
  std::vector<double> state(law->layout().size(), 0.);
  for (unsigned int i = 0; i < 3; ++i)
    state = respond(*law, state, {0., .5, 0., 0.}).state;
  CHECK(state[3] == Approx(mu * std::sin(1.5)).epsilon(1e-12));
  CHECK(state[0] == Approx(mu * (1. - std::cos(1.5))).epsilon(1e-12));
}



TEST_CASE("elastic tangents against central differences", "[unit][elastic]")
{
  std::mt19937                     generator(7);
  std::uniform_real_distribution<> uniform(-1., 1.);
  for (const std::string name : {"linear elastic micropolar", "linear elastic"})
    for (const std::string kinematics : {"finite rotation", "small strain"})
      for (const double size : {1e-3, .2})
        for (unsigned int sample = 0; sample < 20; ++sample)
          {
            const auto law = make_law(name, {{"Kinematics", kinematics}});
            const unsigned int  n = law->n_generalised();
            std::vector<double> state(law->layout().size()), increments(n);
            for (double &value : state)
              value = 300. * uniform(generator);
            for (double &value : increments)
              value = size * uniform(generator);
            const auto answer = respond(*law, state, increments, true);
            const auto value  = respond(*law, state, increments);
            for (unsigned int b = 0; b < n; ++b)
              {
                CHECK(value.stresses[b] ==
                      Approx(answer.stresses[b]).epsilon(1e-12).margin(1e-9));
                auto plus = increments, minus = increments;
                plus[b] += 1e-5;
                minus[b] -= 1e-5;
                const auto up   = respond(*law, state, plus).stresses;
                const auto down = respond(*law, state, minus).stresses;
                for (unsigned int a = 0; a < n; ++a)
                  // rounding 1e-12/1e-5, truncation 1e-10 of the moduli
                  CHECK(answer.tangent[a * n + b] ==
                        Approx((up[a] - down[a]) / 2e-5)
                          .epsilon(1e-6)
                          .margin(1e-5 * mu * .1));
              }
          }
}



TEST_CASE("elastic constants are checked by name", "[unit][elastic]")
{
  const auto messages = [](const LawTools::Settings &changes) {
    Problems problems;
    make_law("linear elastic micropolar", changes)->check("M", problems);
    return problems.errors;
  };
  CHECK(messages({}).empty());
  CHECK(messages({{"Lame modulus", "-1300"}}).empty());

  const std::vector<std::array<std::string, 3>> wrong = {
    {{"Shear modulus", "0", "mu > 0"}},
    {{"Lame modulus", "-1400", "3 lambda + 2 mu > 0"}},
    {{"Couple modulus", "-1", "mu_c >= 0"}},
    {{"Bending modulus", "0", "B > 0"}}};
  for (const auto &[entry, value, rule] : wrong)
    {
      const auto errors = messages({{entry, value}});
      REQUIRE(errors.size() == 1);
      CHECK(errors[0].path == "M/" + entry);
      CHECK(errors[0].message.find(rule) != std::string::npos);
    }
}



TEST_CASE("the stiffness of an elastic law is 2 mu", "[unit][elastic]")
{
  for (const std::string name : {"linear elastic micropolar", "linear elastic"})
    {
      const auto law = make_law(name);
      for (const double stress : {0., -100e3, 100e3})
        CHECK(law->stiffness(
                make_state(*law, {stress, 0., 0., 0., 0.}, {}, 0.).data()) ==
              2. * mu);
    }
}
