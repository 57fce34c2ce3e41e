// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/analysis/triangle_search.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Riedel::Analysis
{
  TriangleSearch::TriangleSearch(const DeformedField &field)
    : field(field)
  {
    const double infinity = std::numeric_limits<double>::infinity();
    box[0]                = {{infinity, infinity}};
    box[1]                = {{-infinity, -infinity}};
    for (const auto &triangle : field.triangles)
      for (const unsigned int node : triangle)
        for (unsigned int axis = 0; axis < 2; ++axis)
          {
            const double x = field.nodes[node][axis];
            box[0][axis]   = std::min(box[0][axis], x);
            box[1][axis]   = std::max(box[1][axis], x);
          }

    // about one triangle per bin: a triangle then lies in a few bins
    const Point size = vector_between(box[0], box[1]);
    bin_size         = std::sqrt(size[0] * size[1] / field.triangles.size());
    for (unsigned int axis = 0; axis < 2; ++axis)
      n_bins[axis] = bin(box[1], axis) + 1;

    // two passes over the triangles: count, then fill
    first_in_bin.assign(n_bins[0] * n_bins[1] + 1, 0);
    for (const bool fill : {false, true})
      {
        for (unsigned int t = 0; t < field.triangles.size(); ++t)
          {
            const auto &triangle = field.triangles[t];
            long        from[2], to[2];
            for (unsigned int axis = 0; axis < 2; ++axis)
              {
                const auto limits =
                  std::minmax({bin(field.nodes[triangle[0]], axis),
                               bin(field.nodes[triangle[1]], axis),
                               bin(field.nodes[triangle[2]], axis)});
                from[axis] = limits.first;
                to[axis]   = limits.second;
              }
            for (long j = from[1]; j <= to[1]; ++j)
              for (long i = from[0]; i <= to[0]; ++i)
                {
                  const std::size_t b = j * n_bins[0] + i;
                  if (fill)
                    triangle_in_bin[--first_in_bin[b]] = t;
                  else
                    ++first_in_bin[b];
                }
          }
        if (!fill)
          {
            // after this first_in_bin holds the end of each bin; filling
            // counts it down to the beginning
            for (std::size_t b = 1; b < first_in_bin.size(); ++b)
              first_in_bin[b] += first_in_bin[b - 1];
            triangle_in_bin.resize(first_in_bin.back());
          }
      }
  }



  long
  TriangleSearch::bin(const Point &point, const unsigned int axis) const
  {
    return static_cast<long>(
      std::floor((point[axis] - box[0][axis]) / bin_size));
  }



  std::optional<TriangleWeights>
  TriangleSearch::locate(const Point &point) const
  {
    // straight triangles along curved edges or at hanging nodes leave slits:
    // a point so little outside a triangle, in shares of its height, is taken
    // for inside
    const double tolerance = 0.02;

    const long i = bin(point, 0), j = bin(point, 1);
    if (i < 0 || j < 0 || i >= n_bins[0] || j >= n_bins[1])
      return std::nullopt;

    std::optional<TriangleWeights> result;
    double                         best = -tolerance;
    const std::size_t              b    = j * n_bins[0] + i;
    for (std::size_t k = first_in_bin[b]; k < first_in_bin[b + 1]; ++k)
      {
        const auto &[n0, n1, n2] = field.triangles[triangle_in_bin[k]];
        const Point &origin      = field.nodes[n0];
        const Point  e1          = vector_between(origin, field.nodes[n1]);
        const Point  e2          = vector_between(origin, field.nodes[n2]);
        const Point  r           = vector_between(origin, point);
        const double area        = cross(e1, e2);
        const double l1          = cross(r, e2) / area;
        const double l2          = cross(e1, r) / area;
        const double least       = std::min({l1, l2, 1. - l1 - l2});
        // the NaN of a triangle without area is refused
        if (!(least >= best))
          continue;
        best   = least;
        result = TriangleWeights{{{n0, n1, n2}}, {{1. - l1 - l2, l1, l2}}};
        if (least >= 0.)
          break;
      }
    return result;
  }
} // namespace Riedel::Analysis
