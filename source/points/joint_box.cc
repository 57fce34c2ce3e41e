// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/points/joint_box.h>

#include <algorithm>
#include <cmath>

namespace Riedel::Points
{
  namespace
  {
    /// What two boxes may lack to one, in shares of their mean edge.
    constexpr double tolerance = 0.1;



    template <int dim>
    bool
    are_side_by_side(const PointBox<dim> &a,
                     const PointBox<dim> &b,
                     const unsigned int   axis)
    {
      for (unsigned int d = 0; d < dim; ++d)
        {
          const double edge     = a.half_lengths[d] + b.half_lengths[d];
          const double distance = std::abs(a.centre[d] - b.centre[d]);
          const bool   fits =
            d == axis ? std::abs(distance - edge) < tolerance * edge :
                          distance < tolerance * edge &&
                          std::abs(a.half_lengths[d] - b.half_lengths[d]) <
                            0.5 * tolerance * edge;
          if (!fits)
            return false;
        }
      return true;
    }
  } // namespace



  template <int dim>
  std::optional<PointBox<dim>>
  joint_box(const PointBox<dim> &a, const PointBox<dim> &b, const double share)
  {
    bool fits = false;
    for (unsigned int axis = 0; axis < dim; ++axis)
      fits = fits || are_side_by_side(a, b, axis);
    if (!fits)
      return {};

    PointBox<dim> result;
    result.centre = a.centre + (1.0 - share) * (b.centre - a.centre);
    for (unsigned int d = 0; d < dim; ++d)
      for (const auto *box : {&a, &b})
        result.half_lengths[d] =
          std::max(result.half_lengths[d],
                   std::abs(box->centre[d] - result.centre[d]) +
                     box->half_lengths[d]);
    return result;
  }



  template std::optional<PointBox<2>>
  joint_box(const PointBox<2> &, const PointBox<2> &, const double);
  template std::optional<PointBox<3>>
  joint_box(const PointBox<3> &, const PointBox<3> &, const double);
} // namespace Riedel::Points
