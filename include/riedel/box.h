// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/bounding_box.h>

#include <string>

namespace Riedel
{
  /// How a box is written: "x0, y0 : x1, y1".
  template <int dim>
  std::string
  box_form();

  /// Reads a box [m]. Throws ParameterError with @p path if @p text is none or
  /// the box is empty.
  template <int dim>
  dealii::BoundingBox<dim>
  read_box(const std::string &text, const std::string &path);
} // namespace Riedel
