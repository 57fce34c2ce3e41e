// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/equilibrium/parameters.h>

#include <algorithm>

namespace Riedel::Equilibrium
{
  /**
   * The size of load steps: adapted to the number of iterations, halved after a
   * failure, shortened to meet marks (times of output and the end).
   */
  class StepControl
  {
  public:
    /// @p are_moving: points move through the grid. What they leave out of
    /// balance does not shrink with the step then, and a step that was hard
    /// would not have been easier if it had been smaller.
    template <int dim>
    StepControl(const LoadingParameters<dim> &loading,
                const SolverParameters       &solver,
                const bool                    are_moving = false)
      : largest(loading.largest_step)
      , smallest(loading.smallest_step)
      , fixed(loading.fixed_steps)
      , target_iterations(solver.target_iterations)
      , are_moving(are_moving)
      , size(loading.initial_step > 0.0 ? loading.initial_step :
                                          loading.largest_step)
    {}

    /// The next step from @p s, at most to @p mark > s.
    double
    next(const double s, const double mark);

    /// After a step that needed this many iterations.
    void
    succeeded(const unsigned int iterations);

    /// Halves the step; false if it would become smaller than allowed.
    bool
    failed();

    /// Would another failure end the run, or have smaller steps not helped?
    bool
    is_last_chance() const
    {
      return fixed || are_moving || failures_in_a_row >= 2 ||
             0.5 * last < smallest;
    }

    /// The size of the step last tried over that of the first try from the
    /// same state: less than 1 after cuts.
    double
    share_of_uncut() const
    {
      return failures_in_a_row == 0 ? 1.0 : last / uncut;
    }

    /// The step that was last tried.
    double
    tried() const
    {
      return last;
    }

    unsigned int
    n_cuts() const
    {
      return cuts;
    }

    /// The state of a run. Limits and fixed steps are those of the parameters,
    /// which may have changed since it was written.
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      double                               present = size;
      archive &present &last &uncut &cuts &failures_in_a_row;
      if (Archive::is_loading::value && !fixed)
        size = std::clamp(present, smallest, largest);
    }

  private:
    const double       largest;
    const double       smallest;
    const bool         fixed;
    const unsigned int target_iterations;
    const bool         are_moving;
    double             size;
    double             last              = 0.0;
    double             uncut             = 0.0; ///< first try from this state
    unsigned int       cuts              = 0;
    unsigned int       failures_in_a_row = 0;
  };
} // namespace Riedel::Equilibrium
