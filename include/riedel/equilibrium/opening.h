// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/equilibrium/opening_parameters.h>
#include <riedel/grid/space.h>
#include <riedel/linear_algebra.h>

namespace Riedel::Equilibrium
{
  /**
   * The measured opening: one component of the displacement of a place minus
   * that of another, a linear function of the displacements of the nodes.
   */
  template <int dim>
  class Opening
  {
  public:
    /// Collective. Throws InputError if a place is outside the body.
    Opening(const OpeningParameters<dim> &parameters,
            const Grid::Space<dim>       &space);

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

    LinearAlgebra::Vector weights;
  };
} // namespace Riedel::Equilibrium
