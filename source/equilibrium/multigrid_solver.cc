// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/equilibrium/multigrid_solver.h>
#include <riedel/errors.h>

#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>

#include <Teuchos_ParameterList.hpp>

#include <ml_MultiLevelPreconditioner.h>

namespace Riedel::Equilibrium
{
  MultigridSolver::MultigridSolver(const LinearAlgebra::SparseMatrix &matrix,
                                   const RigidMotions &rigid_motions,
                                   const Options      &options)
    : matrix(&matrix)
    , rigid_motions(rigid_motions)
    , options(options)
  {}



  void
  MultigridSolver::factorise()
  {
    std::vector<double> motions = rigid_motions();
    const auto          n_rows  = matrix->trilinos_matrix().NumMyRows();

    Teuchos::ParameterList list;
    ML_Epetra::SetDefaults("SA", list);
    list.set("ML output", 0);
    list.set("PDE equations", static_cast<int>(options.unknowns_per_node));
    list.set("null space: type", "pre-computed");
    list.set("null space: dimension",
             static_cast<int>(n_rows == 0 ? 0 : motions.size() / n_rows));
    list.set("null space: vectors", motions.data());
    list.set("aggregation: type", "Uncoupled");
    // the unknowns of a node together: displacement and rotation of stiff
    // grains cannot be smoothed one without the other
    list.set("smoother: type", "symmetric block Gauss-Seidel");
    list.set("smoother: sweeps", 2);
    list.set("coarse: type", "Amesos-KLU");
    list.set("coarse: max size", 1000);
    preconditioner.clear();
    preconditioner.initialize(*matrix, list);
  }



  void
  MultigridSolver::solve(const LinearAlgebra::Vector &b,
                         LinearAlgebra::Vector       &x)
  {
    // the norm is that of the preconditioned residual: a length, whatever the
    // units of forces and moments are
    x = 0.0;
    dealii::ReductionControl                   control(options.most_iterations,
                                     /*absolute=*/0.0,
                                     options.residual);
    dealii::SolverGMRES<LinearAlgebra::Vector> solver(
      control, dealii::SolverGMRES<LinearAlgebra::Vector>::AdditionalData(60));
    bool finished = true;
    try
      {
        solver.solve(*matrix, x, b, preconditioner);
      }
    catch (const dealii::SolverControl::NoConvergence &)
      {
        finished = false;
      }
    const std::uint64_t n = control.last_step();
    linear_counts += {1, n, n, finished ? 0u : 1u};
  }
} // namespace Riedel::Equilibrium
