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
    bool         converged  = false;
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

    /// Improves @p du until balance or failure.
    virtual Outcome
    solve(Balance<dim> &balance, LinearAlgebra::Vector &du) = 0;

    /// The next step should begin with a new factorisation.
    virtual void
    distrust()
    {}

    static std::unique_ptr<Scheme<dim>>
    create(const SolverParameters &parameters, const Balance<dim> &balance);
  };
} // namespace Riedel::Equilibrium
