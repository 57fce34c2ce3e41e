// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/equilibrium/loads.h>
#include <riedel/grid/space.h>
#include <riedel/points/material_points.h>
#include <riedel/points/supports.h>

#include <vector>

namespace Riedel::Equilibrium
{
  /**
   * Ghost penalty of badly filled cells at the surface of the points. Nodes
   * that see little material would make the stiffness singular; between a
   * badly filled cell and its neighbours the energy
   *
   *     1/2 g k h int [d_n du]^2 + 1/2 g k l^2 h int [d_n dw]^2
   *
   * of the increments' jumps of the normal gradient keeps them close to a
   * linear continuation of the well filled cells (after Burman 2010; increments
   * only: the penalty forgets at the end of the step). k: stiffness of the
   * points near the face (Material::Law::stiffness), h: cell size across the
   * face, l: the law's length, g: factor.
   */
  template <int dim>
  class SurfaceStabilisation
  {
  public:
    SurfaceStabilisation(const Grid::Space<dim> &space,
                         const double            factor,
                         const double            length);

    /// Finds the faces and their stiffness, after points have moved.
    void
    rebuild(const Points::MaterialPoints<dim> &points,
            const Points::Supports<dim>       &supports);

    /// Adds the nodal forces of the increments @p du (relevant dofs).
    void
    add_forces(const std::vector<double> &du,
               std::vector<double>       &forces) const;

    /// Adds the stiffness; it does not depend on the increments.
    void
    add_stiffness(const typename Loads<dim>::AddMatrix &add_matrix) const;

    /// Dofs that a face couples, one list per face and component.
    std::vector<std::vector<dealii::types::global_dof_index>>
    couplings() const;

  private:
    /// A quadrature point of a face: the jump of the normal gradient is the sum
    /// of row times nodal value.
    struct Row
    {
      std::vector<dealii::types::global_dof_index> nodes;  ///< first dofs
      std::vector<double>                          row;    ///< 1/m
      double                                       weight; ///< g k h times area
    };

    const Grid::Space<dim> *space;
    const double            factor;
    const double            length;
    std::vector<Row>        rows;
  };
} // namespace Riedel::Equilibrium
