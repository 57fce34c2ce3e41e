// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/equilibrium/boundary_conditions.h>
#include <riedel/grid/space.h>
#include <riedel/linear_algebra.h>

#include <vector>

namespace Riedel::Equilibrium
{
  /**
   * Gives nodes that no point has seen in the step with the increments @p du
   * the mean increment of the other nodes of their cells, or none: a first
   * guess for the step in which they are seen. It reaches as many layers of
   * cells as points may cross in a step like this one.
   *
   * @param unseen_dofs as in Points::Supports; those that are also
   *   @p prescribed keep their increments
   * @param next where the grid will be put back to
   */
  template <int dim>
  void
  continue_to_unseen(
    const Grid::Space<dim>          &space,
    const std::vector<unsigned int> &unseen_dofs,
    const std::vector<typename BoundaryConditions<dim>::Prescribed> &prescribed,
    const Grid::Frame<dim>                                          &next,
    LinearAlgebra::Vector                                           &du);
} // namespace Riedel::Equilibrium
