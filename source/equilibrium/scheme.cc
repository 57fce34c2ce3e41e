// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/equilibrium/anderson.h>
#include <riedel/equilibrium/scheme.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Riedel::Equilibrium
{
  namespace
  {
    std::string
    no_balance(const unsigned int iterations,
               const Residual    &residual,
               const double       allowed,
               const std::string &where)
    {
      std::ostringstream text;
      text.precision(3);
      text << "no balance after " << iterations << " iterations: forces "
           << residual.force / residual.reference << ", moments "
           << residual.moment / residual.reference
           << " of the reactions and loads, " << allowed << " allowed";
      if (!where.empty())
        text << "; " << where;
      return text.str();
    }



    /// Line search: adds the largest of the fractions 1, 1/2, ... of the
    /// correction that reduces the residual; the last one if none does.
    template <int dim>
    Residual
    search_along(Balance<dim>                &balance,
                 const Residual              &before,
                 const LinearAlgebra::Vector &delta,
                 LinearAlgebra::Vector       &du,
                 LinearAlgebra::Vector       &r)
    {
      const LinearAlgebra::Vector from = du;
      Residual                    residual;
      for (double fraction = 1.0; fraction > 0.05; fraction *= 0.5)
        {
          balance.advance(from, fraction, delta, du);
          residual = balance.residual(du, r);
          if (!residual.refused &&
              residual.relative() < (1.0 - 0.1 * fraction) * before.relative())
            break;
        }
      return residual;
    }



    /**
     * Newton's method may end in a cycle at a small residual: the number of
     * substeps of a law's integration is whole, and where it changes the
     * stress jumps by the integration's tolerance. No other step size would
     * help; so such a balance is taken, and counted.
     */
    class Stalling
    {
    public:
      explicit Stalling(const double allowed)
        : allowed(allowed)
      {}

      /// To be asked once per iteration of Newton's method.
      bool
      is_seen_at(const double residual)
      {
        n_in_row = residual < 0.7 * best ? 0 : n_in_row + 1;
        best     = std::min(best, residual);
        return n_in_row >= 4 && residual <= 10.0 * allowed &&
               residual <= 1.2 * best;
      }

    private:
      const double allowed;
      double       best     = std::numeric_limits<double>::infinity();
      unsigned int n_in_row = 0; ///< iterations without progress
    };



    /// Newton's method with the consistent tangent; the correction is halved
    /// until it reduces the residual.
    template <int dim>
    class Newton : public Scheme<dim>
    {
    public:
      explicit Newton(const SolverParameters &parameters)
        : parameters(parameters)
      {}

      Outcome
      solve(Balance<dim>          &balance,
            LinearAlgebra::Vector &du,
            const bool /*last_chance*/) override
      {
        LinearAlgebra::Vector r     = balance.vector();
        LinearAlgebra::Vector delta = balance.vector();
        Outcome               outcome;
        Stalling              stalling(parameters.residual);

        outcome.residual = balance.residual(du, r);
        while (true)
          {
            if (outcome.residual.refused)
              {
                outcome.failure = balance.describe_refusal(outcome.residual);
                return outcome;
              }
            if (outcome.residual.relative() <= parameters.residual)
              {
                outcome.converged = true;
                return outcome;
              }
            if (stalling.is_seen_at(outcome.residual.relative()))
              {
                outcome.converged = outcome.stalled = true;
                return outcome;
              }
            if (outcome.iterations == parameters.most_iterations)
              {
                outcome.failure = no_balance(outcome.iterations,
                                             outcome.residual,
                                             parameters.residual,
                                             balance.describe_worst(r));
                return outcome;
              }

            outcome.residual = balance.linearise(du, r);
            if (outcome.residual.refused)
              continue;
            balance.correction(r, delta);
            outcome.residual =
              search_along(balance, outcome.residual, delta, du, r);
            ++outcome.iterations;
          }
      }

    private:
      const SolverParameters parameters;
    };



    /// An old factor as preconditioner and Anderson acceleration; a new factor
    /// only when it becomes slow. A step that cannot be solved so is tried
    /// again by Newton's method before it is given up.
    template <int dim>
    class Accelerated : public Scheme<dim>
    {
    public:
      Accelerated(const SolverParameters &parameters,
                  const Balance<dim>     &balance)
        : parameters(parameters)
        , acceleration(parameters.secant_pairs, balance.metric())
        , newton(parameters)
      {}

      void
      distrust() override
      {
        factor_is_stale = true;
      }

      Outcome
      solve(Balance<dim>          &balance,
            LinearAlgebra::Vector &du,
            const bool             last_chance) override
      {
        const LinearAlgebra::Vector guess   = du;
        Outcome                     outcome = iterate(balance, du);
        if (!outcome.converged && last_chance)
          {
            const unsigned int in_vain = outcome.iterations;

            du      = guess;
            outcome = newton.solve(balance, du, last_chance);
            outcome.iterations += in_vain;
            // Newton's factors are not those of the secant pairs
            acceleration.clear();
            factor_is_stale = true;
          }
        return outcome;
      }

    private:
      Outcome
      iterate(Balance<dim> &balance, LinearAlgebra::Vector &du)
      {
        // A step for which so many factors were too slow is left to Newton's
        // method.
        constexpr unsigned int enough_factors = 3;

        LinearAlgebra::Vector r     = balance.vector();
        LinearAlgebra::Vector delta = balance.vector();
        Outcome               outcome;
        Stalling              stalling(parameters.residual);
        unsigned int          with_this_factor = 0, n_factors = 0;

        const auto make_factor = [&]() {
          outcome.residual = balance.linearise(du, r);
          if (outcome.residual.refused)
            return;
          acceleration.clear();
          factor_is_stale  = false;
          with_this_factor = 0;
          ++n_factors;
        };

        acceleration.interrupt();
        if (factor_is_stale || !balance.has_factors())
          make_factor();
        else
          outcome.residual = balance.residual(du, r);
        double before = outcome.residual.relative();
        while (true)
          {
            const double now = outcome.residual.relative();
            if (outcome.residual.refused)
              {
                outcome.failure = balance.describe_refusal(outcome.residual);
                return outcome;
              }
            if (now <= parameters.residual)
              {
                outcome.converged = true;
                factor_is_stale =
                  factor_is_stale ||
                  outcome.iterations > 1.5 * parameters.target_iterations;
                return outcome;
              }
            if (n_factors >= enough_factors && stalling.is_seen_at(now))
              {
                outcome.converged = outcome.stalled = true;
                factor_is_stale                     = true;
                return outcome;
              }
            if (outcome.iterations == parameters.most_iterations)
              {
                outcome.failure = no_balance(outcome.iterations,
                                             outcome.residual,
                                             parameters.residual,
                                             balance.describe_worst(r));
                return outcome;
              }

            const bool is_slow =
              with_this_factor >= parameters.refactor_after ||
              (with_this_factor >= 3 &&
               further_iterations(before, now) > parameters.patience) ||
              (n_factors >= enough_factors && with_this_factor > 0);
            if (is_slow)
              {
                make_factor();
                if (outcome.residual.refused)
                  continue;
              }

            balance.correction(r, delta);
            before = now;
            if (with_this_factor == 0)
              {
                // A full correction may lead far away where points begin to
                // yield or leave the floor.
                acceleration.remember(du, delta);
                outcome.residual =
                  search_along(balance, outcome.residual, delta, du, r);
              }
            else
              {
                acceleration.advance(du, delta);
                outcome.residual = balance.residual(du, r);
              }
            ++outcome.iterations;
            ++with_this_factor;
          }
      }

      /// Iterations to the allowed residual if each reduces it like the last.
      double
      further_iterations(const double before, const double now) const
      {
        return now < before ?
                 std::log(now / parameters.residual) / std::log(before / now) :
                 std::numeric_limits<double>::infinity();
      }

      const SolverParameters parameters;
      AndersonAcceleration   acceleration;
      Newton<dim>            newton;
      bool                   factor_is_stale = false;
    };
  } // namespace



  template <int dim>
  std::unique_ptr<Scheme<dim>>
  Scheme<dim>::create(const SolverParameters &parameters,
                      const Balance<dim>     &balance)
  {
    if (parameters.scheme == SchemeName::newton)
      return std::make_unique<Newton<dim>>(parameters);
    return std::make_unique<Accelerated<dim>>(parameters, balance);
  }



  template class Scheme<2>;
  template class Scheme<3>;
} // namespace Riedel::Equilibrium
