// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/analysis/geometry.h>

namespace Riedel::Analysis
{
  Line
  fit_line(const std::vector<Point> &points)
  {
    Point centre = {{0., 0.}};
    for (const Point &point : points)
      centre = advance(centre, 1. / points.size(), point);

    double xx = 0., xy = 0., yy = 0.;
    for (const Point &point : points)
      {
        const Point r = vector_between(centre, point);
        xx += r[0] * r[0];
        xy += r[0] * r[1];
        yy += r[1] * r[1];
      }

    Point direction = unit_vector(0.5 * std::atan2(2. * xy, xx - yy));
    if (dot(direction, vector_between(points.front(), points.back())) < 0.)
      direction = reversed(direction);
    return {centre, direction};
  }
} // namespace Riedel::Analysis
