// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/equilibrium/anderson.h>
#include <riedel/equilibrium/scheme.h>

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
      /// Line search: the largest of the fractions 1, 1/2, ... of the
      /// correction that reduces the residual; the last one if none does.
      static Residual
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
            du = from;
            du.add(fraction, delta);
            residual = balance.residual(du, r);
            if (!residual.refused &&
                residual.relative() <
                  (1.0 - 0.1 * fraction) * before.relative())
              break;
          }
        return residual;
      }

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
        LinearAlgebra::Vector r     = balance.vector();
        LinearAlgebra::Vector delta = balance.vector();
        Outcome               outcome;
        unsigned int          with_this_factor = 0;

        acceleration.interrupt();
        outcome.residual = balance.residual(du, r);
        double before    = outcome.residual.relative();
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
               further_iterations(before, now) > parameters.patience);
            if (factor_is_stale || is_slow || !balance.has_factors())
              {
                outcome.residual = balance.linearise(du, r);
                if (outcome.residual.refused)
                  continue;
                acceleration.clear();
                factor_is_stale  = false;
                with_this_factor = 0;
              }

            balance.correction(r, delta);
            acceleration.advance(du, delta);
            before           = now;
            outcome.residual = balance.residual(du, r);
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
} // namespace Riedel::Equilibrium
