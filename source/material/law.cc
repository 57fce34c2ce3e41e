// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/continuum/generalised.h>
#include <riedel/material/law.h>

namespace Riedel::Material
{
  std::string
  describe(const Report::Refusal reason)
  {
    switch (reason)
      {
        case Report::Refusal::none:
          return "no point was refused";
        case Report::Refusal::inverted_step:
          return "the step turns a point inside out (det f <= 0) or rotates it "
                 "by 180 degrees against the grid; the step is too large";
        case Report::Refusal::too_many_substeps:
          return "the error control of the law needs more substeps than "
                 "`Largest number of substeps'; the step is too large";
        case Report::Refusal::no_return:
          return "the return to the yield surface has no solution that could "
                 "be found; the step is too large";
        case Report::Refusal::not_finite:
          return "an increment or a stress is not a finite number";
      }
    return "unknown reason";
  }



  void
  add_counts(Report &sum, const Report &b)
  {
    sum.floored += b.floored;
    sum.clamped += b.clamped;
    sum.null_deviator += b.null_deviator;
    sum.yielding += b.yielding;
    sum.at_apex += b.at_apex;
    sum.unregularised += b.unregularised;
    sum.without_strength += b.without_strength;
    sum.substeps += b.substeps;
    sum.refused += b.refused;
  }



  template <int dim>
  unsigned int
  Law<dim>::n_generalised() const
  {
    return is_micropolar() ? Continuum::Generalised<dim>::n_micropolar :
                             Continuum::Generalised<dim>::n_classical;
  }



  template class Law<2>;
  template class Law<3>;
} // namespace Riedel::Material
