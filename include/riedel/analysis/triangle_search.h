// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/analysis/geometry.h>
#include <riedel/analysis/shear_bands.h>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace Riedel::Analysis
{
  /// Linear interpolation between the nodes of a triangle.
  struct TriangleWeights
  {
    std::array<unsigned int, 3> nodes;
    std::array<double, 3>       weights; ///< their sum is one
  };

  /**
   * Finds the triangle of the deformed body that a place lies in. A uniform
   * grid of bins makes the search cheap. Keeps a reference to the field.
   */
  class TriangleSearch
  {
  public:
    explicit TriangleSearch(const DeformedField &field);

    /// Nothing outside the body.
    std::optional<TriangleWeights>
    locate(const Point &point) const;

    /// Corners of the box around the body [m].
    Point
    lower() const
    {
      return box[0];
    }

    Point
    upper() const
    {
      return box[1];
    }

  private:
    /// Bin of @p point along @p axis, not limited to the grid.
    long
    bin(const Point &point, unsigned int axis) const;

    const DeformedField      &field;
    std::array<Point, 2>      box;
    double                    bin_size;
    std::array<long, 2>       n_bins;
    std::vector<std::size_t>  first_in_bin; ///< into triangle_in_bin
    std::vector<unsigned int> triangle_in_bin;
  };
} // namespace Riedel::Analysis
