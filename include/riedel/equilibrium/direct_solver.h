// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/equilibrium/linear_solver.h>
#include <riedel/equilibrium/parameters.h>

#include <memory>

namespace Riedel::Equilibrium
{
  /**
   * A sparse LU factorisation. The symbolic phase is done once per sparsity
   * pattern, the numeric one as often as values change. The solver is for
   * @p matrix, which must outlive it and keep its pattern.
   */
  std::unique_ptr<LinearSolver>
  make_direct_solver(const DirectSolverName             name,
                     const LinearAlgebra::SparseMatrix &matrix);
} // namespace Riedel::Equilibrium
