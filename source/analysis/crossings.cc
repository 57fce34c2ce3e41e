// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/analysis/crossings.h>
#include <riedel/analysis/statistics.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace Riedel::Analysis
{
  namespace
  {
    std::vector<Point>
    prolonged(const Ridge &ridge, const double prolongation)
    {
      std::vector<Point> points;
      for (const RidgePoint &point : ridge.points)
        points.push_back(point.position);
      const Point direction = fit_line(points).direction;
      points.insert(points.begin(),
                    advance(points.front(), -prolongation, direction));
      points.push_back(advance(points.back(), prolongation, direction));
      return points;
    }



    /// Intersection of the segments from @p a to @p b and from @p c to @p d.
    std::optional<Point>
    intersection(const Point &a, const Point &b, const Point &c, const Point &d)
    {
      const Point  ab    = vector_between(a, b);
      const Point  cd    = vector_between(c, d);
      const Point  ac    = vector_between(a, c);
      const double area  = cross(ab, cd);
      const double along = cross(ac, cd) / area;
      const double other = cross(ac, ab) / area;
      // the NaN of parallel segments is refused
      if (along >= 0. && along <= 1. && other >= 0. && other <= 1.)
        return advance(a, along, ab);
      return std::nullopt;
    }
  } // namespace



  std::vector<Point>
  find_crossings(const std::vector<Ridge> &ridges, const double prolongation)
  {
    std::vector<Point> crossings;

    for (const Ridge &ridge : ridges)
      for (std::size_t k = 0; k < ridge.points.size(); ++k)
        if (ridge.points[k].bridged)
          {
            const std::size_t first = k;
            while (ridge.points[k].bridged)
              ++k;
            crossings.push_back(ridge.points[(first + k) / 2].position);
          }

    std::vector<std::vector<Point>> lines;
    for (const Ridge &ridge : ridges)
      lines.push_back(prolonged(ridge, prolongation));
    for (std::size_t a = 0; a < lines.size(); ++a)
      for (std::size_t b = a + 1; b < lines.size(); ++b)
        for (std::size_t i = 1; i < lines[a].size(); ++i)
          for (std::size_t j = 1; j < lines[b].size(); ++j)
            if (const auto point = intersection(
                  lines[a][i - 1], lines[a][i], lines[b][j - 1], lines[b][j]))
              crossings.push_back(*point);
    return crossings;
  }



  double
  normal_distance(const Ridge &ridge, const Line &line, const Ridge &other)
  {
    // positions of the other ridge along and across the line
    std::vector<Point> relative;
    for (const RidgePoint &point : other.points)
      {
        const Point r = vector_between(line.centre, point.position);
        relative.push_back(
          {{dot(line.direction, r), cross(line.direction, r)}});
      }

    std::vector<double> distances;
    for (const RidgePoint &point : ridge.points)
      {
        const Point  r      = vector_between(line.centre, point.position);
        const double along  = dot(line.direction, r);
        const double across = cross(line.direction, r);
        for (std::size_t k = 1; k < relative.size(); ++k)
          {
            const Point &p = relative[k - 1], &q = relative[k];
            if ((p[0] <= along) == (q[0] <= along))
              continue;
            const double share = (along - p[0]) / (q[0] - p[0]);
            distances.push_back(
              std::abs(p[1] + share * (q[1] - p[1]) - across));
            break;
          }
      }
    return median(distances);
  }
} // namespace Riedel::Analysis
