// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/analysis/ridge.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace Riedel::Analysis
{
  namespace
  {
    /// One end of a ridge.
    struct End
    {
      Point  position;
      Line   line;   ///< through the part next to the end, pointing out of it
      double length; ///< of the ridge [m]
    };



    /**
     * The line is that of the last 40 d50, without the last 4 d50, where
     * a crossing band bends the ridge.
     */
    End
    end_of(const Ridge &ridge, const bool last, const RidgeOptions &options)
    {
      std::vector<Point> points;
      for (const RidgePoint &point : ridge.points)
        points.push_back(point.position);
      if (!last)
        std::reverse(points.begin(), points.end());

      const Point       position = points.back();
      const double      density  = options.grain_size / options.step;
      const std::size_t left_out = static_cast<std::size_t>(4. * density);
      const std::size_t fitted   = static_cast<std::size_t>(40. * density) + 2;
      if (points.size() > 4 * left_out)
        points.resize(points.size() - left_out);
      if (points.size() > fitted)
        points.erase(points.begin(), points.end() - fitted);
      return {position, fit_line(points), length(ridge)};
    }



    /// Does a band of the sign opposite to @p sign pass through the gap?
    bool
    is_crossed(const Point        &start,
               const Point        &end,
               const double        sign,
               const Raster       &raster,
               const RidgeOptions &options)
    {
      const double reach     = 40. * options.grain_size;
      const Point  gap       = vector_between(start, end);
      const double direction = std::atan2(gap[1], gap[0]);

      const auto meets_opposite = [&](const Point &from, const Point &along) {
        for (double s = 0.; s < reach; s += options.step)
          {
            const auto v = raster.value(advance(from, s, along));
            if (!v)
              return false;
            if (sign * *v <= -options.level)
              return true;
          }
        return false;
      };

      for (const double share : {0.25, 0.5, 0.75})
        for (int degrees = 50; degrees <= 130; degrees += 10)
          {
            const Point from  = advance(start, share, gap);
            const Point along = unit_vector(direction + degrees * M_PI / 180.);
            if (meets_opposite(from, along) &&
                meets_opposite(from, reversed(along)))
              return true;
          }
      return false;
    }



    /// Is the rotation above the level all through the gap, because a band of
    /// the same sign passes there?
    bool
    is_filled(const Point        &start,
              const Point        &end,
              const double        sign,
              const Raster       &raster,
              const RidgeOptions &options)
    {
      const Point  gap  = vector_between(start, end);
      const double size = std::hypot(gap[0], gap[1]);
      for (double s = 0.; s < size; s += options.step)
        if (sign * raster.value(advance(start, s / size, gap)).value_or(0.) <
            options.level)
          return false;
      return true;
    }



    /**
     * A small gap only has to be straight from end to end. Near a crossing two
     * oblique bands push each other aside, so that across it the ends may lie
     * off the line; then the middles of the parts on both sides have to lie in
     * the direction of these parts.
     */
    bool
    can_join(const End          &a,
             const End          &b,
             const double        sign,
             const Raster       &raster,
             const RidgeOptions &options)
    {
      const double d50             = options.grain_size;
      const double largest_gap     = 40. * d50;
      const double free_gap        = 5. * d50;
      const double lateral         = 3. * d50;
      const double cosine_free     = std::cos(20. * M_PI / 180.);
      const double cosine_crossing = std::cos(25. * M_PI / 180.);

      const Point  gap  = vector_between(a.position, b.position);
      const double size = std::hypot(gap[0], gap[1]);
      // a bridge longer than what it joins would be guesswork
      if (size > std::min({largest_gap, a.length, b.length}))
        return false;

      const Point  onwards = reversed(b.line.direction);
      const double cosine  = dot(a.line.direction, onwards);
      if (cosine <= 0.)
        return false;

      const Point mean = normalised(
        {{a.line.direction[0] + onwards[0], a.line.direction[1] + onwards[1]}});
      if (size <= free_gap && cosine >= cosine_free && dot(mean, gap) >= 0. &&
          std::abs(cross(mean, gap)) <= lateral)
        return true;

      const Point chord =
        normalised(vector_between(a.line.centre, b.line.centre));
      return dot(chord, a.line.direction) >= cosine_crossing &&
             dot(chord, onwards) >= cosine_crossing && dot(chord, gap) > 0. &&
             (is_filled(a.position, b.position, sign, raster, options) ||
              is_crossed(a.position, b.position, sign, raster, options));
    }



    /// Appends @p tail to @p ridge with a straight bridge.
    void
    append(Ridge &ridge, const Ridge &tail, const double step)
    {
      const Point start = ridge.points.back().position;
      const Point gap   = vector_between(start, tail.points.front().position);
      const unsigned int n = static_cast<unsigned int>(
        std::round(std::hypot(gap[0], gap[1]) / step));
      for (unsigned int k = 1; k < n; ++k)
        ridge.points.push_back({advance(start, double(k) / n, gap), true});
      ridge.points.insert(ridge.points.end(),
                          tail.points.begin(),
                          tail.points.end());
    }
  } // namespace



  std::vector<Ridge>
  join_collinear(std::vector<Ridge>  pieces,
                 const Raster       &raster,
                 const RidgeOptions &options)
  {
    while (true)
      {
        std::vector<std::array<End, 2>> ends;
        for (const Ridge &piece : pieces)
          ends.push_back(
            {{end_of(piece, false, options), end_of(piece, true, options)}});

        // smallest gap first: a wrong partner further away has no chance
        std::size_t  best_a = 0, best_b = 0;
        unsigned int best_end_a = 0, best_end_b = 0;
        double       smallest = std::numeric_limits<double>::infinity();
        for (std::size_t a = 0; a < pieces.size(); ++a)
          for (std::size_t b = a + 1; b < pieces.size(); ++b)
            for (unsigned int end_a = 0; end_a < 2; ++end_a)
              for (unsigned int end_b = 0; end_b < 2; ++end_b)
                {
                  const double gap =
                    distance(ends[a][end_a].position, ends[b][end_b].position);
                  if (pieces[a].sign != pieces[b].sign || gap >= smallest ||
                      !can_join(ends[a][end_a],
                                ends[b][end_b],
                                pieces[a].sign,
                                raster,
                                options))
                    continue;
                  smallest   = gap;
                  best_a     = a;
                  best_b     = b;
                  best_end_a = end_a;
                  best_end_b = end_b;
                }
        if (std::isinf(smallest))
          return pieces;

        Ridge &a = pieces[best_a];
        Ridge &b = pieces[best_b];
        if (best_end_a == 0)
          std::reverse(a.points.begin(), a.points.end());
        if (best_end_b == 1)
          std::reverse(b.points.begin(), b.points.end());
        append(a, b, options.step);
        pieces.erase(pieces.begin() + best_b);
      }
  }
} // namespace Riedel::Analysis
