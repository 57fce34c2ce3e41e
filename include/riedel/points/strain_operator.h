// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/points/supports.h>

#include <utility>

namespace Riedel::Points
{
  /**
   * The rows of one point of a patch: from the patch's nodal values to the
   * generalised increments H, theta, Gamma and back. The matrix B of the theory
   * (doc/theory/formulation.md).
   */
  template <int dim>
  class StrainOperator
  {
  public:
    StrainOperator(const Supports<dim>                 &supports,
                   const typename Supports<dim>::Patch &patch,
                   const unsigned int                   index_in_patch);

    /// increments = B values; @p values in the patch's order of dofs.
    void
    increments(const double *values, double *increments) const;

    /// values += volume * B^T stresses
    void
    add_forces(const double *stresses,
               const double  volume,
               double       *values) const;

    /// Writes the dense B: n_generalised rows, @p stride numbers from one to
    /// the next. Only the nonzero_range() of a row is written.
    void
    fill(double *B, const unsigned int stride) const;

    /// The dofs [first, second) that a row of B can depend on.
    std::pair<unsigned int, unsigned int>
    nonzero_range(const unsigned int row) const;

  private:
    unsigned int  n_nodes;
    unsigned int  n_rotation_nodes;
    const double *gradient;
    const double *dilatation; ///< null unless mean dilatation is sampled
    const double *spin_weight;
    const double *curvature_gradient;
  };
} // namespace Riedel::Points
