// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/material/parameters.h>

#include <algorithm>

namespace Riedel::Adaptation
{
  /// The smallest grain size of the laws, d50 [m]; 0 if none has one.
  template <int dim>
  double
  smallest_grain_size(const Material::Parameters<dim> &materials)
  {
    double smallest = 0.0;
    for (const auto &material : materials.materials)
      if (const double size = material.law->grain_size(); size > 0.0)
        smallest = smallest > 0.0 ? std::min(smallest, size) : size;
    return smallest;
  }
} // namespace Riedel::Adaptation
