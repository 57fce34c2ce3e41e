// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>

namespace Riedel::Grid
{
  /**
   * Where the grid of the configuration "current" is: it is put back after
   * every step, but follows its walls, so that it stays fitted to them. A point
   * X of the undeformed grid is at
   *
   *     x_d = a_d + (X_d - A_d) (b_d - a_d) / (B_d - A_d),
   *
   * A and B the corners of the undeformed grid, a and b the present ones [m].
   * In the configuration "initial" it is the identity.
   */
  template <int dim>
  class Frame
  {
  public:
    Frame() = default;

    /// The grid where it was before the first step.
    explicit Frame(const dealii::BoundingBox<dim> &grid)
      : undeformed(grid)
      , present(grid)
      , is_identity(false)
    {}

    /// Moves the walls to @p lower and @p upper [m].
    void
    move_to(const dealii::Point<dim> &lower, const dealii::Point<dim> &upper)
    {
      present = dealii::BoundingBox<dim>(std::make_pair(lower, upper));
    }

    const dealii::BoundingBox<dim> &
    grid() const
    {
      return present;
    }

    /// Present over undeformed length along an axis.
    double
    stretch(const unsigned int d) const
    {
      return is_identity ? 1.0 :
                           present.side_length(d) / undeformed.side_length(d);
    }

    dealii::Point<dim>
    to_space(const dealii::Point<dim> &X) const
    {
      if (is_identity)
        return X;
      dealii::Point<dim> x;
      for (unsigned int d = 0; d < dim; ++d)
        x[d] = present.lower_bound(d) +
               (X[d] - undeformed.lower_bound(d)) * stretch(d);
      return x;
    }

    dealii::Point<dim>
    to_grid(const dealii::Point<dim> &x) const
    {
      if (is_identity)
        return x;
      dealii::Point<dim> X;
      for (unsigned int d = 0; d < dim; ++d)
        X[d] = undeformed.lower_bound(d) +
               (x[d] - present.lower_bound(d)) / stretch(d);
      return X;
    }

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &undeformed &present &is_identity;
    }

  private:
    dealii::BoundingBox<dim> undeformed, present;
    bool                     is_identity = true;
  };
} // namespace Riedel::Grid
