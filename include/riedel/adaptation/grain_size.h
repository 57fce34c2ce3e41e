// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/material/parameters.h>

#include <algorithm>

namespace Riedel::Adaptation
{
  /// The smallest length of the laws that have one, d50 [m]; 0 if none has.
  template <int dim>
  double
  smallest_length(const Material::Parameters<dim> &materials)
  {
    double smallest = 0.0;
    for (const auto &material : materials.materials)
      if (const double length = material.law->length(); length > 0.0)
        smallest = smallest > 0.0 ? std::min(smallest, length) : length;
    return smallest;
  }
} // namespace Riedel::Adaptation
