// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/grid/cell_lattice.h>

#include <deal.II/base/types.h>
#include <deal.II/lac/affine_constraints.h>

#include <vector>

namespace Riedel::Points
{
  /// What a point sees of a node: means of the node's shape function and of its
  /// gradient over the point's box.
  template <int dim>
  struct NodeWeight
  {
    dealii::types::global_dof_index node; ///< the node's first dof
    double                          weight;
    dealii::Tensor<1, dim>          gradient; ///< 1/m
  };

  /**
   * Generalised interpolation (GIMP; Bardenhagen and Kober 2004) on a grid with
   * hanging nodes: means of the *constrained* multilinear basis over a box. The
   * box is clipped by every leaf it touches; the mean of a multilinear function
   * over an axis-parallel piece is its value at the piece's centre, so that one
   * evaluation per piece is exact. A hanging node's share goes to its masters.
   * A part of the box outside the grid is cut off.
   *
   * Coordinates are those of the undeformed grid. A box without volume gives
   * the shape functions at its point: the plain material point method.
   */
  template <int dim>
  class BoxWeights
  {
  public:
    /// Vertex dofs of a leaf must be numbered one after the other, the first
    /// component first; @p constraints: the hanging nodes, at least of all own
    /// and ghost cells.
    BoxWeights(const Grid::CellLattice<dim>            &lattice,
               const dealii::AffineConstraints<double> &constraints);

    /// The nodes a box sees, in ascending order of their dofs. False if the box
    /// lies outside the grid or reaches beyond the ghost cells.
    bool
    evaluate(const dealii::Point<dim>     &centre,
             const dealii::Tensor<1, dim> &half_lengths,
             std::vector<NodeWeight<dim>> &nodes) const;

  private:
    void
    add(const dealii::types::global_dof_index node,
        const double                          weight,
        const dealii::Tensor<1, dim>         &gradient,
        std::vector<NodeWeight<dim>>         &nodes) const;

    const Grid::CellLattice<dim>            *lattice;
    const dealii::AffineConstraints<double> *constraints;
    /// first dof of every vertex of every leaf [leaf][vertex]
    std::vector<dealii::types::global_dof_index> vertex_dofs;
    mutable std::vector<unsigned int>            leaves;
  };
} // namespace Riedel::Points
