// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/equilibrium/balance.h>
#include <riedel/equilibrium/parameters.h>

#include <memory>
#include <string>

namespace Riedel::Equilibrium
{
  /// How the solution of a step ended.
  struct Outcome
  {
    bool converged = false;
    /// taken although the residual has stopped a little above the allowed one
    bool         stalled    = false;
    unsigned int iterations = 0;
    Residual     residual;
    std::string  failure; ///< a sentence for people, if not converged
  };

  /**
   * A way to solve the equations of a step from a first guess of the
   * increments.
   */
  template <int dim>
  class Scheme
  {
  public:
    virtual ~Scheme() = default;

    /// Improves @p du until balance or failure. @p last_chance: no smaller step
    /// will be tried, so that more effort is worth it.
    virtual Outcome
    solve(Balance<dim>          &balance,
          LinearAlgebra::Vector &du,
          const bool             last_chance) = 0;

    /// The next step should begin with a new factorisation.
    virtual void
    distrust()
    {}

    static std::unique_ptr<Scheme<dim>>
    create(const SolverParameters &parameters, const Balance<dim> &balance);
  };
} // namespace Riedel::Equilibrium
