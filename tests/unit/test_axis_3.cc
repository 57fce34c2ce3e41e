// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <limits>

#include "law_tools.h"

// Laws under a strain of axis 3: element tests, Loading/Strain 33.

using namespace Riedel;
using LawTools::Answer;
using LawTools::make_law;
using LawTools::make_state;

namespace
{
  Answer
  respond(const Material::Law<2>    &law,
          const std::vector<double> &state,
          const std::vector<double> &increments,
          const double               axis_3_strain,
          const bool                 with_tangent = false)
  {
    const unsigned int n = law.n_generalised();
    Answer             answer;
    answer.state.resize(law.layout().size());
    answer.stresses.resize(n);
    if (with_tangent)
      answer.tangent.resize(n * n);
    answer.report = law.respond({1,
                                 increments.data(),
                                 state.data(),
                                 answer.state.data(),
                                 answer.stresses.data(),
                                 with_tangent ? answer.tangent.data() : nullptr,
                                 &axis_3_strain});
    return answer;
  }



  /// Increments H_11, H_22 without shear.
  std::vector<double>
  stretch(const Material::Law<2> &law, const double h11, const double h22)
  {
    std::vector<double> d(law.n_generalised(), 0.);
    d[0] = h11;
    d[3] = h22;
    return d;
  }



  struct Case
  {
    std::string        law;
    LawTools::Settings settings;
    double             size; ///< of stresses [Pa]
  };

  const std::vector<Case> cases = {{"polar hypoplastic", {}, 100e3},
                                   {"hypoplastic", {}, 100e3},
                                   {"linear elastic micropolar", {}, 10.},
                                   {"linear elastic", {}, 10.},
                                   {"linear elastic",
                                    {{"Kinematics", "small strain"}},
                                    10.},
                                   {"Hencky", {}, 10.}};
} // namespace



TEST_CASE("axis 3 is an axis like the others", "[unit][axis_3]")
{
  // Plane strain with the axes renamed: axis 1 is held and axis 3 stretched.
  for (const Case &c : cases)
    {
      const auto law = make_law(c.law, c.settings);
      INFO(c.law);
      REQUIRE(law->can_stretch_axis_3());
      Material::InitialState plane, turned;
      const double           s[3]     = {-1., -1.5, -1.2};
      const unsigned int     other[3] = {2, 1, 0};
      for (unsigned int i = 0; i < 3; ++i)
        {
          plane.stress[i][i]                = s[i] * c.size;
          turned.stress[other[i]][other[i]] = s[i] * c.size;
        }
      plane.void_ratio = turned.void_ratio = .65;
      std::vector<double> state_plane(law->layout().size());
      std::vector<double> state_turned(law->layout().size());
      law->initialise(plane, state_plane.data());
      law->initialise(turned, state_turned.data());

      const double strain = -2e-3, h22 = 8e-4;
      const double h11 =
        law->is_geometrically_linear() ? strain : std::expm1(strain);
      for (unsigned int step = 0; step < 5; ++step)
        {
          state_plane =
            LawTools::respond(*law, state_plane, stretch(*law, h11, h22)).state;
          const Answer answer =
            respond(*law, state_turned, stretch(*law, 0., h22), strain);
          REQUIRE(answer.report.refused == 0);
          state_turned = answer.state;
        }
      for (unsigned int i = 0; i < 3; ++i)
        CHECK(state_turned[other[i]] == Approx(state_plane[i]).epsilon(1e-11));
      for (unsigned int i = 5; i < state_plane.size(); ++i)
        if (c.law != "Hencky") // its other values have axes, too
          CHECK(state_turned[i] == Approx(state_plane[i]).epsilon(1e-11));
    }
}



TEST_CASE("a strain of axis 3 of zero is plane strain", "[unit][axis_3]")
{
  for (const Case &c : cases)
    {
      const auto law = make_law(c.law, c.settings);
      INFO(c.law);
      const auto start = make_state(
        *law,
        {-c.size, -1.5 * c.size, -1.2 * c.size, .2 * c.size, .2 * c.size},
        {},
        .65);
      std::vector<double> d = stretch(*law, -1e-3, 5e-4);
      d[1]                  = 1e-3;
      if (law->is_micropolar())
        {
          d[4] = -2e-3;
          d[5] = .1;
        }
      const Answer plane = LawTools::respond(*law, start, d);
      const Answer zero  = respond(*law, start, d, 0.);
      for (unsigned int i = 0; i < plane.state.size(); ++i)
        CHECK(zero.state[i] == Approx(plane.state[i]).epsilon(1e-12));
      for (unsigned int i = 0; i < plane.stresses.size(); ++i)
        CHECK(zero.stresses[i] ==
              Approx(plane.stresses[i]).epsilon(1e-12).margin(1e-12));
    }
}



TEST_CASE("the void ratio follows all three axes", "[unit][axis_3]")
{
  for (const std::string name : {"polar hypoplastic", "hypoplastic"})
    {
      const auto         law = make_law(name);
      const unsigned int e   = law->layout().find("void_ratio");
      const auto         start =
        make_state(*law, {-100e3, -150e3, -120e3, 0., 0.}, {}, .65);
      const Answer answer =
        respond(*law, start, stretch(*law, -1e-3, 5e-4), -3e-3);
      CHECK(1. + answer.state[e] ==
            Approx(1.65 * .999 * 1.0005 * std::exp(-3e-3)).epsilon(1e-15));

      // constant volume keeps it, on the floor, too
      const double isochoric = -(std::log1p(-1e-3) + std::log1p(5e-4));
      CHECK(
        respond(*law, start, stretch(*law, -1e-3, 5e-4), isochoric).state[e] ==
        Approx(.65).epsilon(1e-14));
      const Answer floored = respond(*law, start, stretch(*law, .05, .05), .02);
      CHECK(floored.report.floored == 1);
      CHECK(1. + floored.state[e] ==
            Approx(1.65 * 1.05 * 1.05 * std::exp(.02)).epsilon(1e-14));
    }
}



TEST_CASE("a strain of axis 3 that is not a number is refused",
          "[unit][axis_3]")
{
  for (const Case &c : cases)
    {
      const auto law = make_law(c.law, c.settings);
      INFO(c.law);
      const auto start =
        make_state(*law, {-c.size, -c.size, -c.size, 0., 0.}, {}, .65);
      for (const double strain : {std::numeric_limits<double>::quiet_NaN(),
                                  std::numeric_limits<double>::infinity()})
        CHECK(respond(*law, start, stretch(*law, -1e-4, 0.), strain)
                .report.refused == 1);
    }
}



TEST_CASE("the tangent under a strain of axis 3 against central differences",
          "[unit][axis_3]")
{
  for (const std::string &name : Material::known_laws<2>())
    {
      const auto law = make_law(name);
      if (!law->can_stretch_axis_3())
        continue;
      INFO(name);
      const bool   is_sand     = name.find("hypoplastic") != std::string::npos;
      const double size        = is_sand ? 100e3 : 10.;
      const unsigned int n     = law->n_generalised();
      const auto         start = make_state(
        *law, {-size, -1.5 * size, -1.2 * size, .2 * size, .2 * size}, {}, .65);
      const double strain = -6e-4;
      auto         d      = stretch(*law, -4e-4, 3e-4);
      d[1]                = 5e-4;
      d[2]                = 2e-4;
      if (law->is_micropolar())
        {
          d[4] = -1e-4;
          d[5] = .1;
          d[6] = -.2;
        }
      const Answer answer = respond(*law, start, d, strain, true);
      const Answer value  = respond(*law, start, d, strain);
      REQUIRE(answer.report.refused == 0);
      const double scale = law->stiffness(start.data());
      for (unsigned int b = 0; b < n; ++b)
        {
          CHECK(answer.stresses[b] ==
                Approx(value.stresses[b]).epsilon(1e-10).margin(1e-10 * size));
          // curvatures are 1/m: of the size of a strain over the law's length
          const double h    = b < 5 ? 1e-7 : 1e-4;
          auto         plus = d, minus = d;
          plus[b] += h;
          minus[b] -= h;
          const auto up   = respond(*law, start, plus, strain);
          const auto down = respond(*law, start, minus, strain);
          for (unsigned int a = 0; a < n; ++a)
            CHECK(answer.tangent[a * n + b] ==
                  Approx((up.stresses[a] - down.stresses[a]) / (2. * h))
                    .epsilon(2e-5)
                    .margin(2e-5 * scale));
        }
    }
}
