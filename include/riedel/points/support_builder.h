// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/grid/space.h>
#include <riedel/points/material_points.h>
#include <riedel/points/supports.h>

#include <deal.II/base/quadrature.h>

#include <memory>
#include <vector>

namespace Riedel::Points
{
  /**
   * Computes the supports of every step: the one place that knows in which
   * configuration the shape functions live.
   */
  template <int dim>
  class SupportBuilder
  {
  public:
    virtual ~SupportBuilder() = default;

    /// @p follow_deformation: false if all laws are geometrically linear: then
    /// neither gradients nor points move. @p is_wall: sides of the grid (left,
    /// right, bottom, top, ...) whose normal displacement is prescribed: moving
    /// points stay before them.
    static std::unique_ptr<SupportBuilder>
    create(const Grid::Space<dim>       &space,
           const Grid::Parameters       &grid,
           const MovingPointsParameters &moving,
           const std::vector<bool>      &is_wall,
           const bool                    follow_deformation);

    /// The quadrature whose points the material points are seeded on.
    virtual dealii::Quadrature<dim>
    quadrature() const = 0;

    /// Supports of the next step after points have been seeded, or after the
    /// grid has changed. @p solution: displacements and rotations since the
    /// start at the relevant dofs, by local number; only "initial" reads it.
    virtual void
    rebuild(const std::vector<double> &solution,
            MaterialPoints<dim>       &points) = 0;

    /// A step of the increments @p du at the nodes (relevant dofs) and @p
    /// increments at the points has been accepted: points take their trial
    /// states, volumes, displacements and rotations, move if they do, and see
    /// the grid anew. The space's frame is already that of the next step.
    virtual void
    accept(const std::vector<double> &solution,
           const std::vector<double> &du,
           const std::vector<double> &increments,
           MaterialPoints<dim>       &points) = 0;

    const Supports<dim> &
    supports() const
    {
      return result;
    }

  protected:
    Supports<dim> result;
  };
} // namespace Riedel::Points
