// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/analysis/reflections.h>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace Riedel::Analysis
{
  namespace
  {
    /// Where a band would leave the body.
    struct End
    {
      std::size_t ridge;
      Point       place;
    };



    /// The line from an inner point of the ridge to its end; of a ridge whose
    /// points come with the end in front. The last 4 d50 are left out: bands
    /// push each other aside where they meet.
    Point
    outward(const std::vector<Point> &points, const double grain_size)
    {
      std::vector<Point> near;
      for (const Point &point : points)
        {
          const double s = distance(points.front(), point);
          if (s >= 4. * grain_size && s <= 20. * grain_size)
            near.push_back(point);
        }
      return reversed(fit_line(near.size() >= 5 ? near : points).direction);
    }



    std::optional<Point>
    exit_place(const TriangleSearch &search,
               const Point          &end,
               const Point          &direction,
               const double          step,
               const double          reach)
    {
      for (double s = step; s <= reach; s += step)
        {
          const Point place = advance(end, s, direction);
          if (!search.locate(place))
            return place;
        }
      return std::nullopt;
    }
  } // namespace



  unsigned int
  count_reflections(const std::vector<Ridge> &ridges,
                    const TriangleSearch     &search,
                    const double              grain_size,
                    const double              reach)
  {
    std::vector<End> ends;
    for (std::size_t r = 0; r < ridges.size(); ++r)
      {
        std::vector<Point> points;
        for (const RidgePoint &point : ridges[r].points)
          points.push_back(point.position);
        for (unsigned int side = 0; side < 2; ++side)
          {
            if (const auto place = exit_place(search,
                                              points.front(),
                                              outward(points, grain_size),
                                              0.25 * grain_size,
                                              reach))
              ends.push_back({r, *place});
            std::reverse(points.begin(), points.end());
          }
      }

    struct Meeting
    {
      double      gap;
      std::size_t a, b;
    };
    std::vector<Meeting> meetings;
    for (std::size_t a = 0; a < ends.size(); ++a)
      for (std::size_t b = a + 1; b < ends.size(); ++b)
        {
          const double gap = distance(ends[a].place, ends[b].place);
          if (ridges[ends[a].ridge].sign != ridges[ends[b].ridge].sign &&
              gap <= reach)
            meetings.push_back({gap, a, b});
        }
    std::sort(meetings.begin(),
              meetings.end(),
              [](const Meeting &m, const Meeting &n) { return m.gap < n.gap; });

    unsigned int               count = 0;
    std::vector<unsigned char> is_taken(ends.size(), 0);
    for (const Meeting &meeting : meetings)
      if (!is_taken[meeting.a] && !is_taken[meeting.b])
        {
          is_taken[meeting.a] = is_taken[meeting.b] = 1;
          ++count;
        }
    return count;
  }
} // namespace Riedel::Analysis
