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
    const Grid::Space<dim>                 *space;
    std::vector<Prescribed>                 list;
    dealii::AffineConstraints<double>       constraints;
  };
} // namespace Riedel::Equilibrium
