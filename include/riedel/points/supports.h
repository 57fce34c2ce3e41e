// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/continuum/generalised.h>

#include <deal.II/base/types.h>

#include <vector>

namespace Riedel::Points
{
  /**
   * How the material points see the grid in one step: for every point the nodes
   * that it touches and their weights and gradients on the start-of-step
   * configuration. Computed once per step; the law, the assembly and the
   * solution do not know where it comes from.
   *
   * Points that share their nodes form a patch (in finite elements: the points
   * of a cell that have the same material). The dofs of a patch are ordered by
   * component: all nodes of u_1, all of u_2, ..., all of w. Arrays over the
   * points of a patch are laid out [point][axis][node].
   */
  template <int dim>
  struct Supports
  {
    static constexpr unsigned int n_spin = Continuum::Generalised<dim>::n_spin;

    struct Patch
    {
      unsigned int material;
      unsigned int first_point; ///< in the step's order of points
      unsigned int n_points;
      unsigned int n_nodes;               ///< of each displacement component
      unsigned int n_rotation_nodes;      ///< of each rotation component
      unsigned int n_dofs;                ///< all components
      std::size_t  first_dof;             ///< in #dofs
      std::size_t  first_weight;          ///< of [point][node], displacement
      std::size_t  first_rotation_weight; ///< of [point][node], rotation
    };

    std::vector<Patch> patches;

    /// dofs of the patches as local numbers (Grid::Space::local())
    std::vector<unsigned int> dofs;
    /// the same as global numbers
    std::vector<dealii::types::global_dof_index> global_dofs;

    /// shape values of the displacement at the point [point][node]
    std::vector<double> weight;
    /// gradients for H [point][axis][node], 1/m
    std::vector<double> gradient;
    /// mean of the cell minus own gradient, for the volume part of H
    /// [point][axis][node], 1/m; empty unless mean dilatation is sampled
    std::vector<double> dilatation;
    /// weights for theta [point][node]
    std::vector<double> spin_weight;
    /// gradients for Gamma [point][axis][node], 1/m
    std::vector<double> curvature_gradient;
    /// V_n of every point
    std::vector<double> volume;
    /// nodes that no point sees, by the local numbers of their dofs; none in
    /// the configuration "initial"
    std::vector<unsigned int> unseen_dofs;
  };
} // namespace Riedel::Points
