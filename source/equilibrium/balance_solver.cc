// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/continuum/moment.h>
#include <riedel/equilibrium/balance.h>
#include <riedel/equilibrium/direct_solver.h>
#include <riedel/equilibrium/multigrid_solver.h>

/*
 * How a Balance solves its linear systems.
 */
namespace Riedel::Equilibrium
{
  namespace
  {
    /// In space a direct solver is faster below (doc/performance.md).
    constexpr unsigned int most_unknowns_of_direct_solver = 5000;
  } // namespace



  template <int dim>
  void
  Balance<dim>::make_solver()
  {
    const bool is_iterative =
      parameters->linear_solver == LinearSolverName::iterative ||
      (parameters->linear_solver == LinearSolverName::automatic && dim == 3 &&
       space->has_whole_nodes() &&
       space->dof_handler().n_dofs() > most_unknowns_of_direct_solver);
    if (is_iterative)
      solver = std::make_unique<MultigridSolver>(
        matrix,
        [this]() { return rigid_motions(); },
        MultigridSolver::Options{space->n_components(),
                                 parameters->linear_residual,
                                 parameters->most_linear_iterations});
    else
      solver = make_direct_solver(parameters->solver, matrix);
  }



  template <int dim>
  std::vector<double>
  Balance<dim>::rigid_motions() const
  {
    constexpr unsigned int n_rotations = Grid::Space<dim>::n_spin;
    const unsigned int     n           = space->owned().n_elements();
    std::vector<double>    motions((dim + n_rotations) * n, 0.0);
    for (unsigned int i = 0; i < n; ++i)
      {
        const unsigned int local =
          space->local(space->owned().nth_index_in_set(i));
        const unsigned int c = space->components()[local];
        if (c >= dim)
          {
            motions[c * n + i] = 1.0;
            continue;
          }
        motions[c * n + i] = 1.0;
        // the moment of a unit force is what it works on in a unit rotation
        dealii::Tensor<1, dim> unit;
        unit[c] = 1.0;
        const auto u =
          Continuum::moment_of(space->deformed_node(local, present), unit);
        for (unsigned int k = 0; k < n_rotations; ++k)
          motions[(dim + k) * n + i] = u[k];
      }
    return motions;
  }



  template void
  Balance<2>::make_solver();
  template std::vector<double>
  Balance<2>::rigid_motions() const;
  template void
  Balance<3>::make_solver();
  template std::vector<double>
  Balance<3>::rigid_motions() const;
} // namespace Riedel::Equilibrium
