// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/equilibrium/linear_counts.h>
#include <riedel/linear_algebra.h>

namespace Riedel::Equilibrium
{
  /// Solves systems with one unsymmetric matrix, whose values may change.
  class LinearSolver
  {
  public:
    virtual ~LinearSolver() = default;

    /// Makes factors, or a preconditioner, from the present values of the
    /// matrix. Throws ComputationError if that is impossible.
    virtual void
    factorise() = 0;

    /// x = A^-1 b with the matrix of the last factorise(). The matrix itself
    /// must not have changed since if the solver is iterative; @p x need not be
    /// initialised.
    virtual void
    solve(const LinearAlgebra::Vector &b, LinearAlgebra::Vector &x) = 0;

    /// Iterations since the solver was made.
    const LinearCounts &
    counts() const
    {
      return linear_counts;
    }

  protected:
    LinearCounts linear_counts;
  };
} // namespace Riedel::Equilibrium
