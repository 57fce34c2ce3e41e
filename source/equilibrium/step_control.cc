// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/equilibrium/step_control.h>

#include <algorithm>
#include <cmath>

namespace Riedel::Equilibrium
{
  double
  StepControl::next(const double s, const double mark)
  {
    const double rest = mark - s;
    last              = size;
    // A rest slightly above or below one step is taken as one step, one
    // slightly below two steps in two equal ones: no tiny steps before marks.
    if (rest <= size * (1.0 + 1e-9))
      last = rest;
    else if (!fixed && rest < 2.0 * size)
      last = 0.5 * rest;
    if (failures_in_a_row == 0)
      uncut = last;
    return last;
  }



  void
  StepControl::succeeded(const unsigned int iterations)
  {
    failures_in_a_row = 0;
    if (fixed)
      return;
    const double factor = std::sqrt(static_cast<double>(target_iterations) /
                                    std::max(iterations, 1u));
    // a step shortened by a mark must not make the following ones small
    size =
      std::max(last * std::clamp(factor, least_factor, 1.5), factor >= 1.0 ? size : 0.0);
    size = std::clamp(size, smallest, largest);
  }



  bool
  StepControl::failed()
  {
    ++cuts;
    ++failures_in_a_row;
    size = 0.5 * last;
    return !fixed && size >= smallest;
  }
} // namespace Riedel::Equilibrium
