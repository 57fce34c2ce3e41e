// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/analysis/triangle_search.h>

#include <vector>

namespace Riedel::Analysis
{
  /**
   * A field of the material points at the nodes of the triangles: means
   * weighted with volume and linear shape function, then the means of what
   * these miss at the points (Points::nodal_values does the same on the grid).
   * So the field of finite elements and of points that move is one and the
   * same kind of function. A node that no point sees takes the mean of its
   * neighbours; zero if none of these has a value. @p values: of the points.
   */
  std::vector<double>
  nodal_means(const DeformedField       &field,
              const TriangleSearch      &search,
              const std::vector<double> &values);
} // namespace Riedel::Analysis
