// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/analysis/triangle_search.h>

#include <optional>
#include <vector>

namespace Riedel::Analysis
{
  /// A field anywhere in the body, interpolated linearly in the triangles from
  /// its values at the nodes. Keeps references to what it is given.
  class TriangleSampler
  {
  public:
    /// @p values: of the nodes.
    TriangleSampler(const TriangleSearch      &search,
                    const std::vector<double> &values)
      : search(search)
      , values(values)
    {}

    /// Nothing outside the body.
    std::optional<double>
    value(const Point &point) const
    {
      const auto place = search.locate(point);
      if (!place)
        return std::nullopt;
      double sum = 0.;
      for (unsigned int k = 0; k < 3; ++k)
        sum += place->weights[k] * values[place->nodes[k]];
      return sum;
    }

    Point
    lower() const
    {
      return search.lower();
    }

    Point
    upper() const
    {
      return search.upper();
    }

  private:
    const TriangleSearch      &search;
    const std::vector<double> &values;
  };
} // namespace Riedel::Analysis
