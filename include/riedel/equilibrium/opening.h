// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/equilibrium/opening_parameters.h>
#include <riedel/grid/space.h>
#include <riedel/linear_algebra.h>
#include <riedel/points/material_points.h>
#include <riedel/points/supports.h>

namespace Riedel::Equilibrium
{
  /**
   * The measured opening: one component of the displacement of a place minus
   * that of another, a linear function of the displacements of the nodes. In
   * the configuration "current" the places are those of two material points.
   */
  template <int dim>
  class Opening
  {
  public:
    /// Of finite elements. Collective. Throws InputError if a place is outside
    /// the body.
    Opening(const OpeningParameters<dim> &parameters,
            const Grid::Space<dim>       &space);

    /// Of points that move, for the next step: those that were nearest to the
    /// places before the first step. Collective.
    Opening(const OpeningParameters<dim>      &parameters,
            const Grid::Space<dim>            &space,
            const Points::MaterialPoints<dim> &points,
            const Points::Supports<dim>       &supports);

    /// What the points have moved apart before the step [m]; 0 for finite
    /// elements, whose solution has it.
    double
    before() const
    {
      return opening_before;
    }

    /// Of displacements (or increments) @p u at the owned dofs [m]; collective.
    double
    operator()(const LinearAlgebra::Vector &u) const
    {
      return weights * u;
    }

  private:
    /// Adds @p factor times the shape functions at a place.
    void
    add(const std::vector<double> &place,
        const unsigned int         component,
        const double               factor,
        const std::string         &parameter,
        const Grid::Space<dim>    &space);

    /// Adds @p factor times what the point nearest to a place sees.
    void
    add(const std::vector<double>         &place,
        const unsigned int                 component,
        const double                       factor,
        const Grid::Space<dim>            &space,
        const Points::MaterialPoints<dim> &points,
        const Points::Supports<dim>       &supports);

    LinearAlgebra::Vector weights;
    double                opening_before = 0.0;
  };
} // namespace Riedel::Equilibrium
