// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/continuum/generalised.h>
#include <riedel/continuum/space_tensor.h>

#include <cmath>
#include <random>

#include "law_tools.h"

/*
 * The finite-strain laws in space: what a law of plane strain cannot show.
 */
using namespace Riedel;
using LawTools::make_law;
using LawTools::respond;
using Order  = Continuum::Generalised<3>;
using Tensor = Continuum::SpaceTensor<3, double>;

namespace
{
  const std::vector<std::string> names = {"neo-Hookean micropolar",
                                          "neo-Hookean",
                                          "Drucker-Prager micropolar",
                                          "Drucker-Prager",
                                          "von Mises micropolar",
                                          "von Mises"};

  std::unique_ptr<Material::Law<3>>
  law_in_space(const std::string &name)
  {
    LawTools::Settings settings;
    if (name.find("micropolar") != std::string::npos)
      settings = {{"Curvature modulus beta", "12"},
                  {"Curvature modulus alpha", "7"}};
    if (name.find("neo-Hookean") != 0)
      {
        settings["Hardening"]         = "linear";
        settings["Hardening modulus"] = "-300";
        if (name.find("micropolar") != std::string::npos)
          settings["J2 constants"] = "static";
      }
    return make_law<3>(name, settings);
  }

  std::vector<double>
  stress_free(const Material::Law<3> &law)
  {
    std::vector<double> state(law.layout().size());
    law.initialise({}, state.data());
    return state;
  }

  std::vector<double>
  random_increments(const Material::Law<3> &law,
                    const double            size,
                    std::mt19937           &generator)
  {
    std::uniform_real_distribution<> uniform(-1., 1.);
    std::vector<double>              d(law.n_generalised());
    for (unsigned int i = 0; i < d.size(); ++i)
      d[i] = (i < 12 ? size : 5. * size) * uniform(generator);
    return d;
  }

  /// exp(angle * axis x)
  Tensor
  rotation(const std::array<double, 3> &axis, const double angle)
  {
    Tensor A;
    A.components.fill(0.);
    A(2, 1) = axis[0], A(1, 2) = -axis[0];
    A(0, 2) = axis[1], A(2, 0) = -axis[1];
    A(1, 0) = axis[2], A(0, 1) = -axis[2];
    Tensor R = std::sin(angle) * A + (1. - std::cos(angle)) * (A * A);
    Continuum::add_to_diagonal(R, 1.);
    return R;
  }

  Tensor
  turned(const Tensor &R, const Tensor &A)
  {
    return R * A * Continuum::transpose(R);
  }

  Tensor
  tensor_in(const std::vector<double> &state, const unsigned int first)
  {
    Tensor A;
    std::copy_n(state.begin() + first, 9, A.components.begin());
    return A;
  }

  Tensor
  curvature_in(const std::vector<double> &state, const unsigned int first)
  {
    Tensor A;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        A(i, j) = state[first + 3 * i + j];
    return A;
  }

  double
  distance(const Tensor &a, const Tensor &b)
  {
    double largest = 0.;
    for (unsigned int i = 0; i < 9; ++i)
      largest = std::max(largest, std::abs(a.components[i] - b.components[i]));
    return largest;
  }
} // namespace



TEST_CASE("tangents in space against differences", "[unit][laws_in_space]")
{
  for (const std::string &name : names)
    {
      std::mt19937 generator(11);
      const auto   law    = law_in_space(name);
      const double length = law->length() > 0. ? law->length() : 1.;
      const auto   unit   = [&](const unsigned int i) {
        return i < 12 ? 1. : 1. / length;
      };
      unsigned int n_yielding = 0;
      double       worst      = 0.;
      for (unsigned int path = 0; path < 4; ++path)
        {
          auto state = stress_free(*law);
          for (unsigned int number = 0; number < 4; ++number)
            {
              const auto         d = random_increments(*law, .02, generator);
              const unsigned int n = d.size();
              const auto         answer = respond(*law, state, d, true);
              REQUIRE(answer.report.refused == 0);
              double largest = 0., error = 0.;
              for (unsigned int b = 0; b < n; ++b)
                {
                  const double h    = 1e-6 * unit(b);
                  auto         plus = d, minus = d;
                  plus[b] += h;
                  minus[b] -= h;
                  const auto up   = respond(*law, state, plus).stresses;
                  const auto down = respond(*law, state, minus).stresses;
                  for (unsigned int a = 0; a < n; ++a)
                    {
                      const double scale = unit(a) * unit(b);
                      const double ours  = scale * answer.tangent[a * n + b];
                      largest            = std::max(largest, std::abs(ours));
                      error =
                        std::max(error,
                                 std::abs(ours - scale * (up[a] - down[a]) /
                                                   (2. * h)));
                    }
                }
              worst = std::max(worst, error / largest);
              n_yielding += answer.report.yielding;
              state = answer.state;
            }
        }
      INFO(name << ": error " << worst << ", yielding " << n_yielding);
      CHECK(worst < 1e-7);
      CHECK((n_yielding > 8 || name.find("neo-Hookean") == 0));
    }
}



TEST_CASE("superposed rotations in space turn stresses (B1)",
          "[unit][laws_in_space]")
{
  const std::array<double, 3> axis{{2. / 7., -3. / 7., 6. / 7.}};
  for (const std::string &name : names)
    for (const auto &[degrees, steps] :
         {std::pair<double, unsigned int>{90., 1},
          {90., 4},
          {360., 3},
          {720., 5},
          {720., 72}})
      {
        std::mt19937 generator(5);
        const auto   law   = law_in_space(name);
        const auto   first = random_increments(*law, .02, generator);
        const auto   start = respond(*law, stress_free(*law), first).state;

        const double        total = degrees / 180. * M_PI;
        const double        angle = total / steps;
        const Tensor        step  = rotation(axis, angle);
        std::vector<double> turn(law->n_generalised(), 0.);
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            turn[Order::gradient(i, j)] = step(i, j) - (i == j ? 1. : 0.);
        if (law->is_micropolar())
          for (unsigned int k = 0; k < 3; ++k)
            turn[Order::spin(k)] = angle * axis[k];
        auto state = start;
        for (unsigned int number = 0; number < steps; ++number)
          {
            const auto answer = respond(*law, state, turn);
            REQUIRE(answer.report.refused == 0);
            state = answer.state;
          }

        INFO(name << ", " << degrees << " degrees in " << steps << " steps");
        const Tensor R      = rotation(axis, total);
        const auto   stress = tensor_in(start, 0);
        const double size   = distance(stress, 0. * stress);
        REQUIRE(size > 10.);
        CHECK(distance(tensor_in(state, 0), turned(R, stress)) < 1e-10 * size);
        if (law->is_micropolar())
          {
            const unsigned int m         = law->layout().find("couple_stress");
            const auto         couple    = curvature_in(start, m);
            const double       magnitude = distance(couple, 0. * couple);
            REQUIRE(magnitude > 1e-2);
            CHECK(distance(curvature_in(state, m), turned(R, couple)) <
                  1e-10 * magnitude);
          }
      }
}



TEST_CASE("laws of plane strain are those of space", "[unit][laws_in_space]")
{
  // of elastic laws whatever alpha and beta are; with beta, the couple stress
  // m_13 = beta k_31 of space would enter the yield function
  for (const std::string &name : names)
    {
      const bool         is_elastic = name.find("neo-Hookean") == 0;
      LawTools::Settings settings;
      if (!is_elastic)
        settings = {{"Hardening", "linear"}, {"Hardening modulus", "-300"}};
      const auto space =
        is_elastic ? law_in_space(name) : make_law<3>(name, settings);
      const auto          plane = make_law<2>(name, settings);
      std::vector<double> a(plane->layout().size()), b(space->layout().size());
      plane->initialise({}, a.data());
      space->initialise({}, b.data());
      std::mt19937                     generator(8);
      std::uniform_real_distribution<> uniform(-1., 1.);
      unsigned int                     n_yielding = 0;
      for (unsigned int number = 0; number < 12; ++number)
        {
          std::vector<double> d(plane->n_generalised());
          for (unsigned int i = 0; i < d.size(); ++i)
            d[i] = (i < 5 ? .02 : .1) * uniform(generator);
          std::vector<double> d3(space->n_generalised(), 0.);
          d3[0] = d[0], d3[1] = d[1], d3[3] = d[2], d3[4] = d[3];
          const std::vector<unsigned int> place = {0, 1, 3, 4, 11, 18, 19};
          for (unsigned int i = 4; i < d.size(); ++i)
            d3[place[i]] = d[i];
          const auto x = respond(*plane, a, d), y = respond(*space, b, d3);
          REQUIRE(x.report.refused + y.report.refused == 0);
          CHECK(x.report.yielding == y.report.yielding);
          n_yielding += x.report.yielding;
          double size = 0.;
          for (const double stress : x.stresses)
            size = std::max(size, std::abs(stress));
          INFO(name << ", step " << number);
          for (unsigned int i = 0; i < d.size(); ++i)
            CHECK(std::abs(y.stresses[place[i]] - x.stresses[i]) < 1e-9 * size);
          CHECK(std::abs(y.state[2] - x.state[2]) < 1e-9 * size);
          a = x.state;
          b = y.state;
        }
      CHECK((n_yielding > 2 || is_elastic));
    }
}
