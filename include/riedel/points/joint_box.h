// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <optional>

namespace Riedel::Points
{
  /// The axis-parallel box of a point.
  template <int dim>
  struct PointBox
  {
    dealii::Point<dim>     centre;
    dealii::Tensor<1, dim> half_lengths;
  };

  /**
   * The box of a point that takes the place of two, if these are neighbours
   * along one axis and form nearly one box: gap, offset and difference of the
   * edges below a tenth of the edges. It covers both; its centre divides the
   * line between their centres so that volumes in the ratio @p share of @p a to
   * 1 - share of @p b keep their first moment.
   */
  template <int dim>
  std::optional<PointBox<dim>>
  joint_box(const PointBox<dim> &a, const PointBox<dim> &b, const double share);
} // namespace Riedel::Points
