// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/linear_algebra.h>

#include <vector>

namespace Riedel::Equilibrium
{
  /**
   * First guess of a step's increments: the accepted steps extrapolated in the
   * load parameter.
   */
  class Extrapolation
  {
  public:
    /// @p order 1: the previous increment, scaled; 2: a parabola through the
    /// last three accepted states, as soon as there are that many.
    explicit Extrapolation(const unsigned int order);

    /// Remembers an accepted step.
    void
    accept(const double step, const LinearAlgebra::Vector &du);

    /// False before the first accepted step.
    bool
    is_possible() const
    {
      return n_steps > 0;
    }

    /// The guess for the next step.
    void
    predict(const double step, LinearAlgebra::Vector &du) const;

    /// What belongs to the state of a run ...
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &n_steps &last_step &step_before;
    }

    /// ... with these vectors, which may be empty; they also go to a new grid.
    std::vector<LinearAlgebra::Vector *>
    vectors()
    {
      return {&last_du, &du_before};
    }

  private:
    const unsigned int    order;
    unsigned int          n_steps   = 0;
    double                last_step = 0.0, step_before = 0.0;
    LinearAlgebra::Vector last_du, du_before;
  };
} // namespace Riedel::Equilibrium
