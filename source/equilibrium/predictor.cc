// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/equilibrium/predictor.h>

namespace Riedel::Equilibrium
{
  Extrapolation::Extrapolation(const unsigned int order)
    : order(order)
  {}



  void
  Extrapolation::accept(const double step, const LinearAlgebra::Vector &du)
  {
    std::swap(last_du, du_before);
    step_before = last_step;
    last_du     = du;
    last_step   = step;
    ++n_steps;
  }



  void
  Extrapolation::predict(const double step, LinearAlgebra::Vector &du) const
  {
    du = last_du;
    du *= step / last_step;
    if (order < 2 || n_steps < 2)
      return;
    // Newton's form of the parabola: slope of the last step plus curvature
    const double factor = step * (step + last_step) / (last_step + step_before);
    du.add(factor / last_step, last_du, -factor / step_before, du_before);
  }



  std::vector<LinearAlgebra::Vector *>
  Extrapolation::vectors()
  {
    std::vector<LinearAlgebra::Vector *> result;
    if (n_steps > 0)
      result.push_back(&last_du);
    if (n_steps > 1)
      result.push_back(&du_before);
    return result;
  }
} // namespace Riedel::Equilibrium
