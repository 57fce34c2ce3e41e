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
    template <int dim>
    StepControl(const LoadingParameters<dim> &loading,
                const SolverParameters       &solver)
      : largest(loading.largest_step)
      , smallest(loading.smallest_step)
      , fixed(loading.fixed_steps)
      , target_iterations(solver.target_iterations)
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
      return fixed || failures_in_a_row >= 2 || 0.5 * last < smallest;
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
      double                        present = size;
      archive &present &last &cuts &failures_in_a_row;
      if (Archive::is_loading::value && !fixed)
        size = std::clamp(present, smallest, largest);
    }

  private:
    const double       largest;
    const double       smallest;
    const bool         fixed;
    const unsigned int target_iterations;
    double             size;
    double             last              = 0.0;
    unsigned int       cuts              = 0;
    unsigned int       failures_in_a_row = 0;
  };
} // namespace Riedel::Equilibrium
