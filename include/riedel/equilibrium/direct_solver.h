// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/equilibrium/parameters.h>
#include <riedel/linear_algebra.h>

#include <memory>

namespace Riedel::Equilibrium
{
  /**
   * A sparse LU factorisation of an unsymmetric matrix. The symbolic phase is
   * done once per sparsity pattern, the numeric one as often as values change.
   */
  class DirectSolver
  {
  public:
    virtual ~DirectSolver() = default;

    /// Factorises the present values of the matrix given to create(). Throws
    /// ComputationError if that is impossible.
    virtual void
    factorise() = 0;

    /// x = A^-1 b with the last factors.
    virtual void
    solve(const LinearAlgebra::Vector &b, LinearAlgebra::Vector &x) = 0;

    /// A solver for @p matrix, which must outlive it and keep its pattern.
    static std::unique_ptr<DirectSolver>
    create(const DirectSolverName             name,
           const LinearAlgebra::SparseMatrix &matrix);
  };
} // namespace Riedel::Equilibrium
