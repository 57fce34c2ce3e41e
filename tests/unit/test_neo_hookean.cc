// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/material/finite_strain_step.h>

#include <cmath>
#include <random>

#include "law_tools.h"

using namespace Riedel;
using LawTools::make_law;
using LawTools::respond;
using Material::FiniteStrainStep;
using Material::NeoHookeanElasticity;
using Material::StretchAndCurvature;

namespace
{
  NeoHookeanElasticity
  elasticity(const double alpha, const double beta)
  {
    NeoHookeanElasticity e;
    e.lambda = 1000.;
    e.mu     = 2000.;
    e.kappa  = 1000.;
    e.gamma  = 40.;
    e.alpha  = alpha;
    e.beta   = beta;
    return e;
  }



  template <int dim>
  StretchAndCurvature<dim, double>
  at_rest()
  {
    StretchAndCurvature<dim, double> state;
    state.elastic.components.fill(0.);
    state.total.components.fill(0.);
    state.curvature.components.fill(0.);
    return state;
  }



  /// T(theta), of which a = T dtheta is the spin of a change of the rotation
  /// vector, by its power series
  template <typename Number>
  std::array<std::array<Number, 3>, 3>
  tangent_of_rotation(const Number *theta)
  {
    Continuum::SpaceTensor<3, Number> A, T;
    A.components.fill(Number(0.));
    A(2, 1) = theta[0], A(1, 2) = -theta[0];
    A(0, 2) = theta[1], A(2, 0) = -theta[1];
    A(1, 0) = theta[2], A(0, 1) = -theta[2];
    T.components.fill(Number(0.));
    for (unsigned int order = 20; order >= 2; --order)
      {
        Continuum::add_to_diagonal(T, Number(1.));
        T = (1. / order) * (A * T);
      }
    Continuum::add_to_diagonal(T, Number(1.));
    std::array<std::array<Number, 3>, 3> result;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        result[i][j] = T(i, j);
    return result;
  }
} // namespace



TEST_CASE("power of neo-Hookean stresses is the rate of the stored energy",
          "[unit][neo_hookean]")
{
  // in the plane the generalised stresses are its derivatives
  using Number = Continuum::Forward<8>;
  std::mt19937                     generator(3);
  std::uniform_real_distribution<> uniform(-1., 1.);
  double                           worst = 0.;
  for (unsigned int path = 0; path < 20; ++path)
    {
      const NeoHookeanElasticity e     = elasticity(0., 0.);
      auto                       state = at_rest<2>();
      for (unsigned int number = 0; number < 30; ++number)
        {
          std::array<Number, 7> inputs;
          for (unsigned int i = 0; i < 7; ++i)
            inputs[i] =
              Number::input((i < 5 ? .15 : 5.) * uniform(generator), i);
          const FiniteStrainStep<2, true, Number> step(inputs, state);
          if (!step.valid || value_of(step.volume) < .05)
            break;
          const auto generalised =
            step.generalised(e.kirchhoff_stress(step.trial.elastic),
                             e.kirchhoff_couple_stress(step.trial.curvature,
                                                       step.trial.total));
          const Number psi = e.energy(step.trial.elastic, step.trial.curvature);
          double       size = 0.;
          for (const Number &s : generalised)
            size = std::max(size, std::abs(s.value));
          for (unsigned int i = 0; i < 7; ++i)
            worst =
              std::max(worst,
                       std::abs(generalised[i].value -
                                psi.derivatives[i] / step.initial_volume) /
                         size);
          for (unsigned int i = 0; i < 5; ++i)
            {
              state.elastic.components[i] =
                step.trial.elastic.components[i].value;
              state.total.components[i] = state.elastic.components[i];
            }
          for (unsigned int i = 0; i < 2; ++i)
            state.curvature.components[i] =
              step.trial.curvature.components[i].value;
        }
    }
  INFO("largest error " << worst);
  CHECK(worst < 1e-12);
}



TEST_CASE("... in space with spins as test functions", "[unit][neo_hookean]")
{
  using Number = Continuum::Forward<24>;
  std::mt19937                     generator(4);
  std::uniform_real_distribution<> uniform(-1., 1.);
  const NeoHookeanElasticity       e     = elasticity(5., 10.);
  auto                             state = at_rest<3>();
  double                           worst = 0.;
  for (unsigned int number = 0; number < 10; ++number)
    {
      std::array<Number, 21> inputs;
      for (unsigned int i = 0; i < 21; ++i)
        inputs[i] = Number::input((i < 9  ? .1 :
                                   i < 12 ? .6 :
                                            3.) *
                                    uniform(generator),
                                  i);
      const FiniteStrainStep<3, true, Number> step(inputs, state);
      REQUIRE(step.valid);
      const auto s =
        step.generalised(e.kirchhoff_stress(step.trial.elastic),
                         e.kirchhoff_couple_stress(step.trial.curvature,
                                                   step.trial.total));
      const Number psi = e.energy(step.trial.elastic, step.trial.curvature);

      // spin a = T dtheta and its gradient d(T Gamma) - a x (T Gamma) ... as a
      // derivative of the rotation: grad a = T dGamma + dT Gamma, both in the
      // frame of the start of the step
      const auto T = tangent_of_rotation(inputs.data() + 9);
      for (unsigned int d = 0; d < 21; ++d)
        {
          double power = 0.;
          for (unsigned int i = 0; i < 9; ++i)
            power += d == i ? s[i].value : 0.;
          for (unsigned int k = 0; k < 3; ++k)
            {
              if (d >= 9 && d < 12)
                power += s[9 + k].value * T[k][d - 9].value;
              for (unsigned int j = 0; j < 3; ++j)
                for (unsigned int l = 0; l < 3; ++l)
                  {
                    const unsigned int gamma = 12 + 3 * l + j;
                    double             rate  = 0.;
                    if (d == gamma)
                      rate += T[k][l].value;
                    // grad_j of T_kl(theta) dtheta_l with dtheta = e_(d - 9)
                    if (d >= 9 && d < 12)
                      rate +=
                        T[k][d - 9].derivatives[9 + l] * inputs[gamma].value;
                    power += s[12 + 3 * k + j].value * rate;
                  }
            }
          worst = std::max(
            worst,
            std::abs(power - psi.derivatives[d] / step.initial_volume) / e.mu);
        }
      for (unsigned int i = 0; i < 9; ++i)
        {
          state.elastic.components[i] = step.trial.elastic.components[i].value;
          state.total.components[i]   = state.elastic.components[i];
          state.curvature.components[i] =
            step.trial.curvature.components[i].value;
        }
    }
  INFO("largest error " << worst);
  CHECK(worst < 1e-12);
}



TEST_CASE("plane strain is a case of space", "[unit][neo_hookean]")
{
  // the stresses of the plane do not depend on alpha and beta
  const NeoHookeanElasticity plane = elasticity(0., 0.);
  const NeoHookeanElasticity space = elasticity(3., 20.);
  auto                       a     = at_rest<2>();
  auto                       b     = at_rest<3>();
  for (unsigned int number = 0; number < 4; ++number)
    {
      const std::array<double, 7> d{{.1, -.2, .15, -.05, .3, 2., -1.}};
      std::array<double, 21>      d3{};
      d3[0] = d[0], d3[1] = d[1], d3[3] = d[2], d3[4] = d[3];
      d3[11] = d[4], d3[18] = d[5], d3[19] = d[6];
      const FiniteStrainStep<2, true, double> step(d, a);
      const FiniteStrainStep<3, true, double> step_3(d3, b);
      a = step.trial;
      b = step_3.trial;
      const auto s =
        step.generalised(plane.kirchhoff_stress(a.elastic),
                         plane.kirchhoff_couple_stress(a.curvature, a.total));
      const auto s3 =
        step_3.generalised(space.kirchhoff_stress(b.elastic),
                           space.kirchhoff_couple_stress(b.curvature, b.total));
      const unsigned int place[7] = {0, 1, 3, 4, 11, 18, 19};
      for (unsigned int i = 0; i < 7; ++i)
        CHECK(s3[place[i]] == Approx(s[i]).epsilon(1e-12).margin(1e-10));
      CHECK(b.elastic(2, 2) == 0.);
    }
}



TEST_CASE("simple shear of neo-Hookean bodies (B2)", "[unit][neo_hookean]")
{
  for (const double kappa : {0., .8, 100.})
    {
      const auto                law = make_law("neo-Hookean micropolar",
                                {{"Lame modulus", "1.5"},
                                                {"Shear modulus", "1"},
                                                {"Couple modulus", std::to_string(kappa / 2)},
                                                {"Bending modulus", "1"}});
      const std::vector<double> zero(law->layout().size(), 0.);
      // free rotation: w = -atan(gamma/2); sigma = tau at J = 1
      const double gamma = 1.;
      const auto   free =
        respond(*law, zero, {0., gamma, 0., 0., -std::atan(gamma / 2), 0., 0.});
      CHECK(free.state[3] == Approx(gamma).epsilon(1e-14));
      CHECK(free.state[4] == Approx(gamma).epsilon(1e-14));
      CHECK(free.state[0] == Approx(gamma * gamma).epsilon(1e-14));
      CHECK(std::abs(free.stresses[4]) < 1e-14 * (1. + kappa));
      const auto locked = respond(*law, zero, {0., gamma, 0., 0., 0., 0., 0.});
      if (kappa == .8)
        {
          CHECK(locked.state[3] == Approx(1.4).epsilon(1e-14));
          CHECK(locked.state[4] == Approx(.6).epsilon(1e-14));
          CHECK(locked.state[0] == Approx(1.4).epsilon(1e-14));
        }
    }
}



TEST_CASE("bending of a neo-Hookean block into an arc (B4)",
          "[unit][neo_hookean]")
{
  // A plane X = const becomes a circle of radius r(X), sections turn by c Y
  // with their grains: V = diag(r', c r), k = c on the arc. The traction on the
  // faces X = -h/2, h/2 vanishes, the nominal stresses fulfil P_rr' = c P_tt,
  // and the moment is the integral of P_tt r plus that of the couple stress.
  for (const auto &[c, classical] : {std::pair<double, double>{.1, .02375253},
                                     {.3, .06992689},
                                     {.5, .11241285}})
    {
      const double              bending = .2;
      const auto                law     = make_law("neo-Hookean micropolar",
                                {{"Lame modulus", "1.5"},
                                                    {"Shear modulus", "1"},
                                                    {"Couple modulus", "0.7"},
                                                    {"Bending modulus", std::to_string(bending)}});
      const std::vector<double> zero(law->layout().size(), 0.);
      const auto stresses = [&](const double stretch, const double around) {
        return respond(*law,
                       zero,
                       {stretch - 1., 0., 0., around - 1., 0., 0., c},
                       true);
      };
      // r' from r and P_rr
      const auto stretch_of = [&](const double r, const double P) {
        double stretch = 1.;
        for (unsigned int i = 0; i < 50; ++i)
          {
            const auto   answer = stresses(stretch, c * r);
            const double change = (P - answer.stresses[0]) / answer.tangent[0];
            stretch += change;
            if (std::abs(change) < 1e-15)
              break;
          }
        return stretch;
      };
      constexpr unsigned int n = 200;
      // {P_rr at the outer face, moment} for the radius of the inner one
      const auto integrate = [&](const double inner) {
        using State      = std::array<double, 3>; // r, P_rr, moment
        const auto slope = [&](const State &y) {
          const double stretch = stretch_of(y[0], y[1]);
          const auto   answer  = stresses(stretch, c * y[0]);
          return State{{stretch,
                        c * answer.stresses[3],
                        answer.stresses[3] * y[0] + answer.stresses[6]}};
        };
        State        y{{inner, 0., 0.}};
        const double h = 1. / n;
        for (unsigned int i = 0; i < n; ++i)
          {
            const auto along = [&](const State &k, const double factor) {
              State z = y;
              for (unsigned int j = 0; j < 3; ++j)
                z[j] += factor * h * k[j];
              return z;
            };
            const State k1 = slope(y), k2 = slope(along(k1, .5)),
                        k3 = slope(along(k2, .5)), k4 = slope(along(k3, 1.));
            for (unsigned int j = 0; j < 3; ++j)
              y[j] += h / 6. * (k1[j] + 2. * k2[j] + 2. * k3[j] + k4[j]);
          }
        return y;
      };
      double a = 1. / c - .5, b = a + .01;
      double ra = integrate(a)[1], rb = integrate(b)[1];
      for (unsigned int i = 0; i < 20 && std::abs(b - a) > 1e-13; ++i)
        {
          const double next = b - rb * (b - a) / (rb - ra);
          a = b, ra = rb;
          b = next, rb = integrate(b)[1];
        }
      CHECK(integrate(b)[2] == Approx(classical + bending * c).margin(1e-8));
    }
}



TEST_CASE("superposed rotations turn neo-Hookean stresses (B1)",
          "[unit][neo_hookean]")
{
  for (const std::string name : {"neo-Hookean micropolar",
                                 "neo-Hookean",
                                 "Drucker-Prager micropolar",
                                 "Drucker-Prager"})
    for (const double degrees : {90., 180., 360., 720.})
      for (const unsigned int steps : {4u, 36u, 360u})
        {
          const auto          law = make_law(name);
          const unsigned int  n   = law->n_generalised();
          std::vector<double> start(law->layout().size());
          law->initialise({}, start.data());
          std::vector<double> d{.01, .02, -.03, -.02};
          if (n == 7)
            d.insert(d.end(), {.01, .1, -.2});
          start = respond(*law, start, d).state;

          const double angle = degrees / 180. * M_PI / steps;
          if (angle > 3.)
            continue;
          std::vector<double> turn{-2. * std::pow(std::sin(angle / 2), 2),
                                   -std::sin(angle),
                                   std::sin(angle),
                                   -2. * std::pow(std::sin(angle / 2), 2)};
          if (n == 7)
            turn.insert(turn.end(), {angle, 0., 0.});
          auto state = start;
          for (unsigned int step = 0; step < steps; ++step)
            {
              const auto answer = respond(*law, state, turn);
              REQUIRE(answer.report.refused == 0);
              state = answer.state;
            }
          const double c       = std::cos(degrees / 180. * M_PI),
                       s       = std::sin(degrees / 180. * M_PI);
          const double R[2][2] = {{c, -s}, {s, c}};
          const auto   turned  = [&](const unsigned int first) {
            const double          A[2][2] = {{start[first], start[first + 3]},
                                             {start[first + 4], start[first + 1]}};
            std::array<double, 4> B{};
            for (int i = 0; i < 2; ++i)
              for (int j = 0; j < 2; ++j)
                for (int k = 0; k < 2; ++k)
                  for (int l = 0; l < 2; ++l)
                    B[2 * i + j] += R[i][k] * A[k][l] * R[j][l];
            return B;
          };
          const auto sigma = turned(0);
          INFO(name << " " << degrees << " degrees in " << steps << " steps");
          CHECK(state[0] == Approx(sigma[0]).margin(1e-9));
          CHECK(state[1] == Approx(sigma[3]).margin(1e-9));
          CHECK(state[2] == Approx(start[2]).margin(1e-9));
          CHECK(state[3] == Approx(sigma[1]).margin(1e-9));
          CHECK(state[4] == Approx(sigma[2]).margin(1e-9));
          if (n == 7)
            {
              CHECK(state[5] ==
                    Approx(c * start[5] - s * start[6]).margin(1e-10));
              CHECK(state[6] ==
                    Approx(s * start[5] + c * start[6]).margin(1e-10));
            }
        }
}



TEST_CASE("neo-Hookean laws are linear for small strains",
          "[unit][neo_hookean]")
{
  // against the law of small strain, which A1 to A7 verify
  for (const bool micropolar : {false, true})
    {
      const std::string name = micropolar ? " micropolar" : "";
      const auto        law  = make_law("neo-Hookean" + name);
      const auto        linear =
        make_law("linear elastic" + name, {{"Kinematics", "small strain"}});
      std::vector<double> d{1., .5, -.3, .7};
      if (micropolar)
        d.insert(d.end(), {.2, 5., -3.});
      for (double &x : d)
        x *= 1e-9;
      const auto a =
        respond(*law, std::vector<double>(law->layout().size(), 0.), d, true);
      const auto b = respond(*linear,
                             std::vector<double>(linear->layout().size(), 0.),
                             d,
                             true);
      for (unsigned int i = 0; i < d.size(); ++i)
        {
          CHECK(a.stresses[i] == Approx(b.stresses[i]).epsilon(1e-7));
          for (unsigned int j = 0; j < d.size(); ++j)
            CHECK(a.tangent[i * d.size() + j] ==
                  Approx(b.tangent[i * d.size() + j]).margin(1e-4));
        }
    }
}



TEST_CASE("initial stresses of neo-Hookean laws", "[unit][neo_hookean]")
{
  for (const std::string name : {"neo-Hookean micropolar",
                                 "neo-Hookean",
                                 "Drucker-Prager micropolar",
                                 "Drucker-Prager"})
    for (const double size : {1e-9, 1., 100., 5e4})
      {
        const auto law =
          make_law(name,
                   name[0] == 'D' ?
                     LawTools::Settings{{"Friction angle", "60"}} :
                     LawTools::Settings{});
        Material::InitialState initial;
        initial.stress[0][0] = -1.1 * size;
        initial.stress[1][1] = -2. * size;
        initial.stress[2][2] = -1.5 * size;
        initial.stress[0][1] = .3 * size;
        Problems problems;
        law->check_initial(initial, "I", problems);
        CHECK(problems.errors.empty());
        std::vector<double> state(law->layout().size());
        law->initialise(initial, state.data());
        const std::vector<double> zero(law->n_generalised(), 0.);
        const auto                answer    = respond(*law, state, zero);
        const double              stress[5] = {-1.1, -2., -1.5, .3, .3};
        for (unsigned int i = 0; i < 5; ++i)
          {
            CHECK(state[i] == Approx(stress[i] * size).epsilon(1e-10));
            CHECK(answer.state[i] == Approx(state[i]).epsilon(1e-10));
          }
      }
}
