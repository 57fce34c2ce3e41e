// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cmath>
#include <vector>

namespace Riedel::Analysis
{
  /// A point or a vector in the plane [m].
  using Point = std::array<double, 2>;

  inline double
  dot(const Point &a, const Point &b)
  {
    return a[0] * b[0] + a[1] * b[1];
  }

  /// Out-of-plane component of a x b.
  inline double
  cross(const Point &a, const Point &b)
  {
    return a[0] * b[1] - a[1] * b[0];
  }

  /// The vector from @p start to @p end.
  inline Point
  vector_between(const Point &start, const Point &end)
  {
    return {{end[0] - start[0], end[1] - start[1]}};
  }

  inline double
  distance(const Point &a, const Point &b)
  {
    return std::hypot(b[0] - a[0], b[1] - a[1]);
  }

  /// start + length * direction
  inline Point
  advance(const Point &start, const double length, const Point &direction)
  {
    return {
      {start[0] + length * direction[0], start[1] + length * direction[1]}};
  }

  /// @p direction turned by 90 degrees, counterclockwise.
  inline Point
  normal_to(const Point &direction)
  {
    return {{-direction[1], direction[0]}};
  }

  inline Point
  reversed(const Point &direction)
  {
    return {{-direction[0], -direction[1]}};
  }

  /// @p vector, not zero, scaled to unit length.
  inline Point
  normalised(const Point &vector)
  {
    const double size = std::hypot(vector[0], vector[1]);
    return {{vector[0] / size, vector[1] / size}};
  }

  /// Unit vector at @p angle [rad] to the x axis.
  inline Point
  unit_vector(const double angle)
  {
    return {{std::cos(angle), std::sin(angle)}};
  }

  /// A straight line; the direction has unit length.
  struct Line
  {
    Point centre;
    Point direction;
  };

  /**
   * The line with the least sum of squared normal distances to the points: it
   * passes through their mean along the larger principal axis. It points from
   * the first to the last point. At least two different points are needed.
   */
  Line
  fit_line(const std::vector<Point> &points);
} // namespace Riedel::Analysis
