// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/analysis/point_search.h>

#include <cmath>

namespace Riedel::Analysis
{
  PointSearch::PointSearch(const DeformedField &field, const double bin_size)
    : field(field)
    , bin_size(bin_size)
  {
    for (std::size_t k = 0; k < field.points.size(); ++k)
      points_in_bin[bin(field.points[k])].push_back(k);
  }



  std::pair<long, long>
  PointSearch::bin(const Point &place) const
  {
    return {static_cast<long>(std::floor(place[0] / bin_size)),
            static_cast<long>(std::floor(place[1] / bin_size))};
  }



  std::optional<std::size_t>
  PointSearch::nearest(const Point &place, const double limit) const
  {
    const auto from = bin({{place[0] - limit, place[1] - limit}});
    const auto to   = bin({{place[0] + limit, place[1] + limit}});

    std::optional<std::size_t> result;
    double                     least = limit;
    for (long i = from.first; i <= to.first; ++i)
      for (long j = from.second; j <= to.second; ++j)
        {
          const auto found = points_in_bin.find({i, j});
          if (found == points_in_bin.end())
            continue;
          for (const std::size_t k : found->second)
            if (distance(field.points[k], place) <= least)
              {
                least  = distance(field.points[k], place);
                result = k;
              }
        }
    return result;
  }
} // namespace Riedel::Analysis
