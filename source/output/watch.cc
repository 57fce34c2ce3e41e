// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/output/watch.h>

namespace Riedel::Output
{
  namespace
  {
    /// Does a formula change with s? Asked at some place inside a body.
    template <int dim>
    bool
    changes(const Expression<dim> &formula)
    {
      dealii::Point<dim> place;
      for (unsigned int d = 0; d < dim; ++d)
        place[d] = 0.01 * (d + 1);
      for (const double s : {0.1, 0.37, 1.0})
        if (formula(place, s) != formula(place, 0.0))
          return true;
      return false;
    }
  } // namespace



  template <int dim>
  Watch<dim>::Watch(
    const Parameters                                    &parameters,
    const Equilibrium::BoundaryConditionParameters<dim> &conditions,
    const Equilibrium::PlatesParameters<dim>            &plates)
  {
    // in the order of the reactions
    const auto consider = [&](const unsigned int place, const auto &candidate) {
      const bool is_named = candidate.name == parameters.watch;
      if (boundary >= 0 || (!is_named && !parameters.watch.empty()))
        return;
      for (unsigned int d = 0; d < dim && boundary < 0; ++d)
        {
          const auto &formula = candidate.displacement[d];
          if (formula.given() && changes(formula))
            {
              boundary  = static_cast<int>(place);
              component = d;
              name      = candidate.name;
            }
        }
      if (boundary < 0 && is_named)
        {
          boundary = static_cast<int>(place);
          name     = candidate.name;
        }
    };
    unsigned int place = 0;
    for (const auto &candidate : conditions.boundaries)
      consider(place++, candidate);
    for (const auto &candidate : plates.plates)
      consider(place++, candidate);
  }



  template <int dim>
  double
  Watch<dim>::force(
    const std::vector<typename Equilibrium::Balance<dim>::Reaction> &reactions)
    const
  {
    return boundary < 0 ? 0.0 : reactions[boundary].force[component];
  }



  template <int dim>
  std::string
  Watch<dim>::description() const
  {
    return boundary < 0 ?
             std::string() :
             "force " + std::to_string(component + 1) + " on " + name;
  }



  template class Watch<2>;
  template class Watch<3>;
} // namespace Riedel::Output
