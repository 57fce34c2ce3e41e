// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/equilibrium/linear_solver.h>

#include <deal.II/lac/trilinos_precondition.h>

#include <functional>
#include <vector>

namespace Riedel::Equilibrium
{
  /**
   * GMRES, preconditioned by one cycle of algebraic multigrid by smoothed
   * aggregation (Trilinos' ML) on the whole system of displacements and
   * rotations (doc/theory/solution.md).
   *
   * Coarse spaces contain the rigid motions of the body, in which displacements
   * and rotations are coupled: u = omega x x with w = omega. Nothing else that
   * is needed has small energy.
   */
  class MultigridSolver : public LinearSolver
  {
  public:
    /// Rigid motions, one after another, each with a value for every owned row.
    using RigidMotions = std::function<std::vector<double>()>;

    struct Options
    {
      /// unknowns of a node, which follow each other in the matrix
      unsigned int unknowns_per_node;
      /// the residual is reduced to this share of the right side
      double       residual;
      unsigned int most_iterations;
    };

    /// For @p matrix, which must outlive it and keep its pattern.
    MultigridSolver(const LinearAlgebra::SparseMatrix &matrix,
                    const RigidMotions                &rigid_motions,
                    const Options                     &options);

    void
    factorise() override;

    /// A system that is not solved after the most iterations is left as it is
    /// and counted: what comes of it, the nonlinear iteration sees.
    void
    solve(const LinearAlgebra::Vector &b, LinearAlgebra::Vector &x) override;

  private:
    const LinearAlgebra::SparseMatrix        *matrix;
    const RigidMotions                        rigid_motions;
    const Options                             options;
    dealii::TrilinosWrappers::PreconditionAMG preconditioner;
  };
} // namespace Riedel::Equilibrium
