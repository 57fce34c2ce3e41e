// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/equilibrium/parameters.h>
#include <riedel/grid/body.h>
#include <riedel/grid/space.h>

#include <deal.II/lac/affine_constraints.h>

#include <vector>

namespace Riedel::Equilibrium
{
  /**
   * The prescribed displacements and rotations of the named boundaries. Where
   * two boundaries share a node and both prescribe a component, the one named
   * first in the file counts.
   */
  template <int dim>
  class BoundaryConditions
  {
  public:
    BoundaryConditions(const BoundaryConditionParameters<dim> &parameters,
                       const Grid::Body<dim>                  &body,
                       const Grid::Space<dim>                 &space);

    struct Prescribed
    {
      unsigned int dof; ///< local number
      unsigned int boundary;
      unsigned int component;
      bool         owned;
    };

    const std::vector<Prescribed> &
    prescribed() const
    {
      return list;
    }

    /// The value of a prescribed dof at a load parameter [m or rad].
    double
    value(const Prescribed &dof, const double s) const;

    /// Nodes that no point sees get no increments; dofs by local number.
    void
    set_unseen(const std::vector<unsigned int> &dofs);

    /// Owned or not, by local number: prescribed, or unseen.
    const std::vector<bool> &
    is_fixed() const
    {
      return fixed;
    }

    /// Where the walls of the grid are at a load parameter: a side of the grid
    /// whose normal displacement is prescribed moves with it, others stay.
    Grid::Frame<dim>
    walls(const double s) const;

    /// Hanging nodes, and zero for the prescribed dofs: what corrections obey.
    const dealii::AffineConstraints<double> &
    homogeneous() const
    {
      return constraints;
    }

    /// The same with given increments of the prescribed dofs, by local number.
    dealii::AffineConstraints<double>
    with_increments(const std::vector<double> &increment) const;

  private:
    const BoundaryConditionParameters<dim> *parameters;
    const Grid::Body<dim>                  *body;
    const Grid::Space<dim>                 *space;
    std::vector<Prescribed>                 list;
    std::vector<unsigned int>               unseen;
    std::vector<bool>                       fixed;
    dealii::AffineConstraints<double>       constraints;
  };
} // namespace Riedel::Equilibrium
