// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/continuum/newton.h>
#include <riedel/material/drucker_prager_plasticity.h>
#include <riedel/material/finite_strain_step.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <vector>

namespace Riedel::Material
{
  /// Where a step has ended.
  enum class Return
  {
    elastic, ///< inside the yield surface
    smooth,  ///< on the yield surface
    apex,    ///< at its apex
    failed   ///< nowhere: the equations could not be solved
  };

  /**
   * The implicit return to the yield surface (doc/theory/elastoplasticity.md,
   * section 4). On the smooth part
   *
   *     V^e = exp(-dl N) V^e_trial    k^e = k^e_trial - dl (dg/dm) Vtot    f =
   * 0
   *
   * for V^e, k^e and dl, with N = dg/dsigma, all at the end of the step. At the
   * apex the plastic strain X in V^e = exp(-X) V^e_trial follows from the
   * stress. Newton's method, with the strength reached in stages if it fails.
   */
  template <int dim, bool micropolar>
  class ReturnMapping
  {
  public:
    template <typename Number>
    using Tensor = Continuum::SpaceTensor<dim, Number>;
    template <typename Number>
    using Curvature = Continuum::CurvatureTensor<dim, Number>;
    template <typename Number>
    using Motion = StretchAndCurvature<dim, Number>;

    /// V^e, k^e (times L), dl
    static constexpr unsigned int n_curvatures =
      micropolar ? Curvature<double>::n : 0;
    static constexpr unsigned int n_smooth =
      Tensor<double>::n + n_curvatures + 1;
    static constexpr unsigned int n_apex = Tensor<double>::n;

    ReturnMapping(const NeoHookeanElasticity    &elasticity,
                  const DruckerPragerPlasticity &plasticity)
      : elasticity(elasticity)
      , plasticity(plasticity)
      , length(micropolar ? plasticity.length : 0.)
      , symmetric_flow(!micropolar || elasticity.kappa == 0. ||
                       plasticity.a1 == plasticity.a2)
      , scale(1. / (3. * elasticity.mu))
    {}

    /// J sigma and J m of a state.
    template <typename Number>
    struct Stress
    {
      Tensor<Number>    force;
      Curvature<Number> couple;
    };

    template <typename Number>
    Stress<Number>
    stress(const Motion<Number> &state) const
    {
      Stress<Number> result;
      result.force = elasticity.kirchhoff_stress(state.elastic);
      if constexpr (micropolar)
        result.couple =
          elasticity.kirchhoff_couple_stress(state.curvature, state.total);
      else
        result.couple.components.fill(Number(0.));
      return result;
    }

    /// What the yield function depends on [Pa].
    template <typename Value>
    struct Invariants
    {
      Value q, p;

      /// f
      Value
      function(const DruckerPragerPlasticity &plasticity,
               const Value                   &strength) const
      {
        return q + plasticity.friction * p - strength;
      }
    };

    /// ... of Cauchy's stresses at @p volume = det F, without derivatives
    template <typename Number>
    auto
    invariants(const Stress<Number> &stress, const Number &volume) const
    {
      using std::sqrt;
      using Value = Continuum::ValueOf<Number>;
      Tensor<Value>    s;
      Curvature<Value> m;
      for (unsigned int i = 0; i < s.n; ++i)
        s.components[i] = Continuum::value_of(stress.force.components[i]);
      for (unsigned int i = 0; i < m.n; ++i)
        m.components[i] = Continuum::value_of(stress.couple.components[i]);
      const Value inverse = 1. / Continuum::value_of(volume);
      const Value third   = (1. / 3.) * Continuum::trace(s);
      Continuum::add_to_diagonal(s, Value(-third));
      return Invariants<Value>{inverse * sqrt(plasticity.three_J2(s, m)),
                               inverse * third};
    }

    /// Does the yield function allow this? Up to rounding.
    template <typename Value>
    auto
    is_elastic(const Invariants<Value> &trial, const Value &strength) const
    {
      using std::abs;
      return trial.function(plasticity, strength) <=
             1e-12 * (trial.q + strength + abs(plasticity.friction * trial.p));
    }

    /**
     * Returns @p state from its trial values, with derivatives if Number has
     * them; @p volume is det F, @p given the invariants of the trial state and
     * @p a the hardening variable. Nothing is changed if it fails.
     */
    template <typename Number>
    Return
    operator()(Motion<Number>           &state,
               const Number             &volume,
               const Invariants<double> &given,
               double                   &a,
               std::vector<double>      *trace = nullptr) const
    {
      const double strength = plasticity.strength_at(a);
      if (is_elastic(given, strength))
        return Return::elastic;
      const double q_trial = given.q;
      const double f       = given.function(plasticity, strength);

      const Problem<double> trial =
        problem(values(state), double(Continuum::value_of(volume)), a);
      std::array<double, n_smooth> y;
      std::array<double, n_apex>   x;
      bool                         apex_is_next = start(trial, q_trial, f, y);
      Return                       result       = Return::failed;
      if (apex_is_next && solve_apex(trial, x, trace))
        result = Return::apex;
      else if (solve_smooth(trial, f, y, trace))
        result = Return::smooth;
      else if (!apex_is_next && solve_apex(trial, x, trace))
        result = Return::apex;
      else
        return Return::failed;

      if constexpr (std::is_same<Number, double>::value)
        {
          if (result == Return::smooth)
            finish_smooth(y, state, a);
          else
            finish_apex(trial, x, state, a);
        }
      else
        {
          const Problem<Number> here = problem(state, volume, a);
          if (result == Return::smooth)
            {
              std::array<Number, n_smooth> solution;
              if (!Continuum::differentiate_solution(
                    y,
                    [&](const auto &z) { return smooth(z, trial, 0.); },
                    [&](const auto &z) { return smooth(z, here, 0.); },
                    solution))
                return Return::failed;
              finish_smooth(solution, state, a);
            }
          else
            {
              std::array<Number, n_apex> solution;
              if (!Continuum::differentiate_solution(
                    x,
                    [&](const auto &z) { return apex(z, trial); },
                    [&](const auto &z) { return apex(z, here); },
                    solution))
                return Return::failed;
              finish_apex(here, solution, state, a);
            }
        }
      return result;
    }

  private:
    /// What the equations of a return know: the trial state.
    template <typename T>
    struct Problem
    {
      Motion<T> trial;
      T         volume;         ///< det F
      T         inverse_volume; ///< 1/det F
      double    a;              ///< hardening variable at the step's start
    };

    template <typename T>
    static Problem<T>
    problem(const Motion<T> &trial, const T &volume, const double a)
    {
      return {trial, volume, 1. / volume, a};
    }

    template <typename Number>
    static Motion<double>
    values(const Motion<Number> &state)
    {
      Motion<double> result;
      for (unsigned int i = 0; i < state.elastic.n; ++i)
        {
          result.elastic.components[i] =
            Continuum::value_of(state.elastic.components[i]);
          result.total.components[i] =
            Continuum::value_of(state.total.components[i]);
        }
      for (unsigned int i = 0; i < state.curvature.n; ++i)
        result.curvature.components[i] =
          Continuum::value_of(state.curvature.components[i]);
      return result;
    }

    /// exp(-x) V_trial - I
    template <typename X, typename T>
    static auto
    unload(const Tensor<X> &x, const Tensor<T> &trial)
    {
      const auto factor = Continuum::exponential_minus_one(-1. * x);
      return factor + trial + factor * trial;
    }



    // ---- The smooth part

    /// The equations; y are V^e - I, L k^e, dl. The yield function is to be
    /// @p target.
    template <typename Y, typename T>
    auto
    smooth(const std::array<Y, n_smooth> &y,
           const Problem<T>              &problem,
           const double                   target) const
    {
      using std::sqrt;
      using R = decltype(y[0] * problem.volume);

      Tensor<Y> E;
      std::copy_n(y.begin(), E.n, E.components.begin());
      const Y &dl = y[n_smooth - 1];

      Tensor<R> sigma = problem.inverse_volume * elasticity.kirchhoff_stress(E);
      const R   p     = (1. / 3.) * Continuum::trace(sigma);
      Continuum::add_to_diagonal(sigma, R(-p));
      Curvature<R> m;
      Curvature<Y> k;
      if constexpr (micropolar)
        {
          for (unsigned int i = 0; i < k.n; ++i)
            k.components[i] = (1. / length) * y[E.n + i];
          m = elasticity.kirchhoff_couple_stress(k, problem.trial.total);
          for (R &component : m.components)
            component = problem.inverse_volume * component;
        }
      else
        m.components.fill(R(0.));

      const R q    = sqrt(plasticity.three_J2(sigma, m));
      const R rate = dl / q;
      auto    x    = rate * plasticity.flow(sigma);
      Continuum::add_to_diagonal(x, R((plasticity.dilatancy / 3.) * dl));
      const auto unloaded = unload(x, problem.trial.elastic);

      std::array<R, n_smooth> r;
      for (unsigned int i = 0; i < E.n; ++i)
        r[i] = E.components[i] - unloaded.components[i];
      if constexpr (micropolar)
        {
          const auto flow = Continuum::times_one_plus(m, problem.trial.total);
          const R    part = (length * plasticity.couple_flow()) * rate;
          for (unsigned int i = 0; i < k.n; ++i)
            r[E.n + i] = length * (k.components[i] -
                                   problem.trial.curvature.components[i]) +
                         part * flow.components[i];
        }
      const Y strength = plasticity.strength_at(Y(problem.a + dl));
      r[n_smooth - 1] =
        scale * (q + plasticity.friction * p - strength - target);
      size_of_stress = Continuum::value_of(q) +
                       std::abs(plasticity.friction * Continuum::value_of(p)) +
                       Continuum::value_of(strength);
      size_of_strain = Continuum::largest_value(y);
      return r;
    }

    /// The start of the iteration: the return along the normal of the trial
    /// state, exact for small strain if the moduli of all parts of the stress
    /// agree. True if it leaves little of q, so that the apex may be meant.
    bool
    start(const Problem<double>        &problem,
          const double                  q,
          const double                  f,
          std::array<double, n_smooth> &y) const
    {
      auto sigma = problem.inverse_volume *
                   elasticity.kirchhoff_stress(problem.trial.elastic);
      const double p = (1. / 3.) * Continuum::trace(sigma);
      Continuum::add_to_diagonal(sigma, -p);
      if (!(q > 0.))
        {
          y.fill(0.);
          return true;
        }

      const auto   N  = (1. / q) * plasticity.flow(sigma);
      const auto   Nt = Continuum::transpose(N);
      const double even =
        .5 * (Continuum::contract(N, N) + Continuum::contract(N, Nt));
      const double odd =
        .5 * (Continuum::contract(N, N) - Continuum::contract(N, Nt));
      const double bending = plasticity.couple_flow() * elasticity.gamma;
      double       share   = 0.; // of the couple stress in q^2
      if constexpr (micropolar)
        {
          auto m = elasticity.kirchhoff_couple_stress(problem.trial.curvature,
                                                      problem.trial.total);
          share  = plasticity.couple_flow() * Continuum::contract(m, m) *
                  problem.inverse_volume * problem.inverse_volume / (q * q);
        }
      const double shear =
        2. * elasticity.mu * even + elasticity.kappa * odd + bending * share;
      const double whole =
        shear +
        elasticity.bulk_modulus() * plasticity.friction * plasticity.dilatancy +
        plasticity.modulus_at(problem.a);
      // not beyond what brings q to zero
      const double enough = q / shear;
      const double dl =
        std::min(whole > 0. ? f / whole : enough, .999 * enough);

      auto x = dl * N;
      Continuum::add_to_diagonal(x, plasticity.dilatancy / 3. * dl);
      const auto E = unload(x, problem.trial.elastic);
      std::copy(E.components.begin(), E.components.end(), y.begin());
      if constexpr (micropolar)
        for (unsigned int i = 0; i < n_curvatures; ++i)
          y[E.n + i] = length * problem.trial.curvature.components[i] /
                       (1. + bending * problem.inverse_volume * dl /
                               std::max(q - shear * dl, 1e-3 * q));
      y[n_smooth - 1] = dl;
      return dl > .5 * enough;
    }

    /// Newton's method; if it fails, with the yield function lowered in stages
    /// from its trial value @p f to zero.
    bool
    solve_smooth(const Problem<double>        &problem,
                 const double                  f,
                 std::array<double, n_smooth> &y,
                 std::vector<double>          *trace) const
    {
      const auto solve = [&](const double                  target,
                             std::array<double, n_smooth> &z) {
        return Continuum::newton(
                 [&](const auto &u) { return smooth(u, problem, target); },
                 [&]() { return size(); },
                 z,
                 trace) &&
               z[n_smooth - 1] >= 0.;
      };
      if (y[n_smooth - 1] > 0. && solve(0., y))
        return true;

      std::array<double, n_smooth> reached;
      std::copy(problem.trial.elastic.components.begin(),
                problem.trial.elastic.components.end(),
                reached.begin());
      for (unsigned int i = 0; i < n_curvatures; ++i)
        reached[Tensor<double>::n + i] =
          length * problem.trial.curvature.components[i];
      reached[n_smooth - 1] = 0.;
      double remaining = 1., factor = .5;
      for (unsigned int stage = 0; stage < 200 && factor < .999; ++stage)
        {
          y = reached;
          if (solve(factor * remaining * f, y))
            {
              remaining *= factor;
              reached = y;
              factor *= factor;
              if (solve(0., y))
                return true;
            }
          else
            factor = std::sqrt(factor);
        }
      return false;
    }

    template <typename Number>
    void
    finish_smooth(const std::array<Number, n_smooth> &y,
                  Motion<Number>                     &state,
                  double                             &a) const
    {
      std::copy_n(y.begin(), state.elastic.n, state.elastic.components.begin());
      for (unsigned int i = 0; i < n_curvatures; ++i)
        state.curvature.components[i] = (1. / length) * y[state.elastic.n + i];
      a += Continuum::value_of(y[n_smooth - 1]);
    }



    // ---- The apex

    /// dg/dm dl, the plastic curvature that leaves no elastic one
    template <typename T>
    static Curvature<T>
    plastic_curvature(const Problem<T> &problem)
    {
      return problem.trial.curvature *
             Continuum::transpose(
               Continuum::inverse_transposed(problem.trial.total));
    }

    /// The increment of a that belongs to the plastic strain @p x.
    template <typename X, typename T>
    auto
    apex_multiplier(const Tensor<X> &x, const Problem<T> &problem) const
    {
      using std::sqrt;
      using R        = decltype(x.components[0] * problem.volume);
      const R volume = R(Continuum::trace(x));
      if (plasticity.dilatancy > 0.)
        return R((1. / plasticity.dilatancy) * volume);
      R square =
        plasticity.dual_norm_squared(convert<R>(x),
                                     convert<R>(plastic_curvature(problem)),
                                     symmetric_flow);
      R shear(0.);
      if (Continuum::value_of(square) > 0.)
        shear = sqrt(square);
      if (plasticity.friction > 0.)
        shear += (1. / plasticity.friction) * volume;
      return shear;
    }

    template <typename R, typename X>
    static Tensor<R>
    convert(const Tensor<X> &x)
    {
      Tensor<R> result;
      for (unsigned int i = 0; i < x.n; ++i)
        result.components[i] = R(x.components[i]);
      return result;
    }

    template <typename R, typename X>
    static Curvature<R>
    convert(const Curvature<X> &x)
    {
      Curvature<R> result;
      for (unsigned int i = 0; i < x.n; ++i)
        result.components[i] = R(x.components[i]);
      return result;
    }

    /// The equations; the unknown is the plastic strain X.
    template <typename Y, typename T>
    auto
    apex(const std::array<Y, n_apex> &y, const Problem<T> &problem) const
    {
      using R = decltype(y[0] * problem.volume);
      Tensor<Y> x;
      x.components = y;
      const auto E = unload(x, problem.trial.elastic);
      auto sigma   = problem.inverse_volume * elasticity.kirchhoff_stress(E);
      size_of_strain =
        Continuum::largest_value(E.components) +
        1e-3 * Continuum::largest_value(problem.trial.elastic.components);

      std::array<R, n_apex> r;
      if (plasticity.friction > 0.)
        {
          const R a = R(problem.a) + apex_multiplier(x, problem);
          const R pressure =
            (-1. / plasticity.friction) * plasticity.strength_at(a);
          size_of_stress = std::abs(Continuum::value_of(pressure));
          Continuum::add_to_diagonal(sigma, pressure);
          for (unsigned int i = 0; i < 3; ++i)
            r[i] = scale * sigma.components[i];
        }
      else
        {
          // no pressure is the apex: that of the trial volume stays
          size_of_stress = std::abs(Continuum::value_of(sigma.components[2])) +
                           plasticity.strength;
          r[0] = scale * (sigma.components[0] - sigma.components[2]);
          r[1] = scale * (sigma.components[1] - sigma.components[2]);
          r[2] = R(Continuum::trace(x));
        }
      for (unsigned int i = 3; i < n_apex; i += 2)
        {
          r[i] = scale * (sigma.components[i] + sigma.components[i + 1]);
          if (symmetric_flow)
            r[i + 1] = R(y[i] - y[i + 1]);
          else
            r[i + 1] = scale * (sigma.components[i] - sigma.components[i + 1]);
        }
      return r;
    }

    /// The plastic strain that leaves no elastic one: the logarithm of the
    /// trial stretch. Of a flow without a skew part, that of its left stretch.
    std::array<double, n_apex>
    start_of_apex(const Problem<double> &problem) const
    {
      const Tensor<double>      &E = problem.trial.elastic;
      std::array<double, n_apex> x;
      if constexpr (dim == 2)
        {
          std::array<double, 4> plane{{E(0, 0), E(0, 1), E(1, 0), E(1, 1)}};
          if (symmetric_flow)
            {
              // V R^T with the rotation R of its polar decomposition
              const double c = 2. + E(0, 0) + E(1, 1), s = E(1, 0) - E(0, 1);
              const double length = std::hypot(c, s);
              const double cosine = c / length, sine = s / length;
              plane = {{(1. + E(0, 0)) * cosine - E(0, 1) * sine - 1.,
                        (1. + E(0, 0)) * sine + E(0, 1) * cosine,
                        E(1, 0) * cosine - (1. + E(1, 1)) * sine,
                        E(1, 0) * sine + (1. + E(1, 1)) * cosine - 1.}};
            }
          const Continuum::StepKinematics<double> log(plane.data());
          if (log.valid)
            {
              const auto c = log.log_f.components();
              return {{c[0], c[3], std::log1p(E(2, 2)), c[1], c[2]}};
            }
        }
      x = E.components;
      if (symmetric_flow)
        for (unsigned int i = 3; i < n_apex; i += 2)
          x[i] = x[i + 1] = .5 * (x[i] + x[i + 1]);
      return x;
    }

    /// Is the apex what the step ends in?
    bool
    solve_apex(const Problem<double>      &problem,
               std::array<double, n_apex> &x,
               std::vector<double>        *trace) const
    {
      const bool strength_ends = plasticity.hardening == Hardening::linear &&
                                 plasticity.residual == 0. &&
                                 plasticity.modulus < 0.;
      if (!(plasticity.friction > 0. || strength_ends))
        return false;
      x = start_of_apex(problem);
      if (!Continuum::newton([&](const auto &z) { return apex(z, problem); },
                             [&]() { return size(); },
                             x,
                             trace))
        return false;

      Tensor<double> strain;
      strain.components     = x;
      const double da       = apex_multiplier(strain, problem);
      const double rounding = 1e-12 * (1. + Continuum::largest_value(x));
      if (!(plasticity.friction > 0.))
        return plasticity.strength_at(problem.a + da) == 0.;
      if (plasticity.dilatancy > 0.)
        return std::sqrt(plasticity.dual_norm_squared(
                 strain, plastic_curvature(problem), symmetric_flow)) <=
               da + rounding;
      return Continuum::trace(strain) >= -rounding;
    }

    template <typename Number>
    void
    finish_apex(const Problem<Number>            &problem,
                const std::array<Number, n_apex> &x,
                Motion<Number>                   &state,
                double                           &a) const
    {
      Tensor<Number> strain;
      strain.components = x;
      state.elastic     = unload(strain, problem.trial.elastic);
      state.curvature.components.fill(Number(0.));
      a += Continuum::value_of(apex_multiplier(strain, problem));
    }



    /// The size of strains that the present stress means, and the rounding
    /// error of residuals.
    std::pair<double, double>
    size() const
    {
      const double stiff =
        1. + (elasticity.kappa + std::abs(elasticity.lambda)) / elasticity.mu;
      return {scale * size_of_stress,
              1e-15 * stiff * size_of_strain * (1. + size_of_strain) + 1e-300};
    }

    const NeoHookeanElasticity    &elasticity;
    const DruckerPragerPlasticity &plasticity;
    const double                   length;
    const bool                     symmetric_flow;
    const double                   scale;
    /// of the last residual
    mutable double size_of_stress = 0.;
    mutable double size_of_strain = 0.;
  };
} // namespace Riedel::Material
