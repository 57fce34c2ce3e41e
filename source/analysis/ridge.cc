// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/analysis/ridge.h>
#include <riedel/analysis/statistics.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace Riedel::Analysis
{
  namespace
  {
    /// What makes a maximum a ridge: the rotation falls by this share on both
    /// sides ...
    constexpr double least_drop = 0.25;
    /// ... before it rises above the maximum by this share (not 0, since the
    /// kinks of linear interpolation make small maxima on flanks).
    constexpr double rise = 0.02;



    class RidgeTracer
    {
    public:
      RidgeTracer(const Raster &raster, const RidgeOptions &options)
        : raster(raster)
        , options(options)
        , claimed(raster.values.size(), 0)
      {}

      std::vector<Ridge>
      trace();

    private:
      /// Is this raster point a maximum along one raster axis, with flanks?
      bool
      has_flanks(std::size_t index, long stride) const;

      /// Raster points that may lie on a ridge, strongest first.
      std::vector<std::size_t>
      candidates() const;

      /// Rotation times sign of the present ridge.
      std::optional<double>
      value(const Point &point) const;

      bool
      is_claimed(const Point &point) const;

      /// The direction in which the mean of the rotation is largest on a short
      /// line through @p point; nothing if no such line lies in the body.
      std::optional<Point>
      direction_at(const Point &point) const;

      /// Is @p point a maximum across @p direction, with clear flanks?
      bool
      is_maximum_across(const Point &point, const Point &direction) const;

      /// Appends points to @p path until the ridge ends.
      void
      follow(std::vector<Point> &path, const Point &first_direction) const;

      /// Distance from @p foot over which the rotation stays above the level
      /// and does not rise again [m].
      double
      flank_width(const Point &foot, const Point &direction) const;

      /// Marks the flanks of a finished path.
      void
      claim(const std::vector<Point> &path);

      const Raster              &raster;
      const RidgeOptions        &options;
      std::vector<unsigned char> claimed;
      double                     sign = 1.;
    };



    bool
    RidgeTracer::has_flanks(const std::size_t index, const long stride) const
    {
      const double peak = std::abs(raster.values[index]);
      if (std::abs(raster.values[index - stride]) > peak ||
          std::abs(raster.values[index + stride]) > peak)
        return false;
      for (const long step : {-stride, stride})
        {
          double v = peak;
          for (long k = index + step; v > (1. - least_drop) * peak; k += step)
            {
              v = std::abs(raster.values[k]);
              if (!raster.inside[k] || v > (1. + rise) * peak)
                return false;
            }
        }
      return true;
    }



    std::vector<std::size_t>
    RidgeTracer::candidates() const
    {
      // an oblique ridge is a maximum along both axes, one parallel to an
      // axis along the other
      std::vector<std::size_t> result;
      for (std::size_t k = 0; k < raster.values.size(); ++k)
        if (raster.inside[k] && std::abs(raster.values[k]) >= options.level &&
            (has_flanks(k, 1) || has_flanks(k, raster.n[0])))
          result.push_back(k);
      std::sort(result.begin(),
                result.end(),
                [this](const std::size_t a, const std::size_t b) {
                  const double va = std::abs(raster.values[a]);
                  const double vb = std::abs(raster.values[b]);
                  return va != vb ? va > vb : a < b;
                });
      return result;
    }



    std::optional<double>
    RidgeTracer::value(const Point &point) const
    {
      auto result = raster.value(point);
      if (result)
        *result *= sign;
      return result;
    }



    bool
    RidgeTracer::is_claimed(const Point &point) const
    {
      const auto index = raster.index_near(point);
      return index && claimed[*index];
    }



    std::optional<Point>
    RidgeTracer::direction_at(const Point &point) const
    {
      const double       reach        = 15. * options.grain_size;
      const double       least_share  = 0.6;
      const unsigned int n_directions = 36;
      const int          n_samples    = 15;

      std::optional<Point> best;
      double               largest_mean = 0.;
      for (unsigned int k = 0; k < n_directions; ++k)
        {
          const Point  direction = unit_vector(k * M_PI / n_directions);
          double       sum       = 0.;
          unsigned int n_inside  = 0;
          for (int i = -n_samples; i <= n_samples; ++i)
            if (const auto v =
                  value(advance(point, i * reach / n_samples, direction)))
              {
                sum += *v;
                ++n_inside;
              }
          if (n_inside >= least_share * (2 * n_samples + 1) &&
              sum / n_inside > largest_mean)
            {
              largest_mean = sum / n_inside;
              best         = direction;
            }
        }
      return best;
    }



    bool
    RidgeTracer::is_maximum_across(const Point &point,
                                   const Point &direction) const
    {
      const Point  normal = normal_to(direction);
      const double peak   = *value(point);
      for (const double side : {-1., 1.})
        {
          double least = peak;
          for (double s = raster.spacing; least > (1. - least_drop) * peak;
               s += raster.spacing)
            {
              const auto v = value(advance(point, side * s, normal));
              if (!v || *v > (1. + rise) * peak)
                return false;
              least = std::min(least, *v);
            }
        }
      return true;
    }



    void
    RidgeTracer::follow(std::vector<Point> &path,
                        const Point        &first_direction) const
    {
      const double step = options.step;
      // the maximum is sought up to 0.6 steps aside, that is within 31 degrees
      // of the direction of the last 10 d50
      const int    n_offsets    = 6;
      const double offset       = 0.1 * step;
      const double d50          = options.grain_size;
      const auto   steps_within = [&](const double multiple) {
        return static_cast<std::size_t>(std::ceil(multiple * d50 / step));
      };
      const std::size_t fit_steps  = std::max<std::size_t>(steps_within(10), 4);
      const std::size_t turn_limit = std::max<std::size_t>(steps_within(4), 3);
      const std::size_t claim_limit = steps_within(20);
      const std::size_t length_limit =
        4 * (raster.n[0] + raster.n[1]) * (raster.spacing / step) + 1;

      Point             direction = first_direction;
      std::size_t       n_turning = 0, n_claimed = 0;
      double            last_side = 0.;
      const std::size_t begin     = path.size();
      while (path.size() < begin + length_limit)
        {
          if (path.size() > fit_steps / 2)
            {
              const std::size_t n = std::min(path.size(), fit_steps);
              direction =
                fit_line(std::vector<Point>(path.end() - n, path.end()))
                  .direction;
            }

          const Point predicted = advance(path.back(), step, direction);
          const Point normal    = normal_to(direction);
          const auto  at        = [&](const int i) {
            return value(advance(predicted, i * offset, normal)).value_or(0.);
          };
          int best = 0;
          for (int i = 1; i <= n_offsets; ++i)
            for (const int candidate : {-i, i})
              if (at(candidate) > at(best))
                best = candidate;
          // half way to the maximum: the line follows without zigzag
          const Point next = advance(predicted, 0.5 * best * offset, normal);
          if (at(best) < options.level || !value(next))
            break;
          n_claimed = is_claimed(next) ? n_claimed + 1 : 0;

          const double side =
            std::abs(best) < n_offsets ? 0. : (best > 0 ? 1. : -1.);
          n_turning = (side != 0. && side == last_side) ? n_turning + 1 : 0;
          last_side = side;

          path.push_back(next);
          if (n_turning >= turn_limit)
            {
              // a sharp bend: another band, or none
              path.resize(path.size() - n_turning);
              return;
            }
          if (n_claimed >= claim_limit)
            break;
        }
      // the line may pass through the flank of another ridge, not end there
      path.resize(path.size() - n_claimed);
    }



    double
    RidgeTracer::flank_width(const Point &foot, const Point &direction) const
    {
      // a rise by more than this is another ridge
      const double valley = 0.1 * *value(foot);
      const double step   = 0.5 * raster.spacing;

      double least = *value(foot);
      double s     = 0.;
      while (true)
        {
          const auto v = value(advance(foot, s + step, direction));
          if (!v || *v < options.level || *v > least + valley)
            return s;
          least = std::min(least, *v);
          s += step;
        }
    }



    void
    RidgeTracer::claim(const std::vector<Point> &path)
    {
      const double step = 0.5 * raster.spacing;

      struct Flank
      {
        Point  foot;
        Point  direction;
        double width; ///< [m]
      };
      std::vector<Flank>  flanks;
      std::vector<double> widths;
      for (std::size_t k = 0; k < path.size(); ++k)
        {
          const Point before = path[k > 3 ? k - 3 : 0];
          const Point after  = path[std::min(k + 3, path.size() - 1)];
          const Point normal =
            normal_to(normalised(vector_between(before, after)));
          for (const Point &direction : {normal, reversed(normal)})
            {
              const double width = flank_width(path[k], direction);
              flanks.push_back({path[k], direction, width});
              widths.push_back(width);
            }
        }

      // where a band of the same sign crosses, the flank would be that band
      const double limit = 1.5 * median(std::move(widths));
      for (const Flank &flank : flanks)
        for (double s = 0.; s <= std::min(flank.width, limit); s += step)
          {
            const Point point = advance(flank.foot, s, flank.direction);
            for (const double dx : {-raster.spacing, 0., raster.spacing})
              for (const double dy : {-raster.spacing, 0., raster.spacing})
                if (const auto index =
                      raster.index_near({{point[0] + dx, point[1] + dy}}))
                  claimed[*index] = 1;
          }
    }



    std::vector<Ridge>
    RidgeTracer::trace()
    {
      const double shortest = 4. * options.grain_size;

      std::vector<Ridge> ridges;
      for (const std::size_t index : candidates())
        {
          if (claimed[index])
            continue;
          sign = raster.values[index] > 0. ? 1. : -1.;

          const Point start     = raster.position(index);
          const auto  direction = direction_at(start);
          if (!direction || !is_maximum_across(start, *direction))
            continue;

          std::vector<Point> path = {start};
          follow(path, *direction);
          std::reverse(path.begin(), path.end());
          follow(path, reversed(*direction));
          if (path.size() < 2)
            continue;

          claim(path);
          Ridge ridge;
          ridge.sign = sign;
          for (const Point &point : path)
            ridge.points.push_back({point, false});
          if (length(ridge) >= shortest)
            ridges.push_back(std::move(ridge));
        }
      return ridges;
    }
  } // namespace



  double
  length(const Ridge &ridge)
  {
    double result = 0.;
    for (std::size_t k = 1; k < ridge.points.size(); ++k)
      result +=
        distance(ridge.points[k - 1].position, ridge.points[k].position);
    return result;
  }



  std::vector<Ridge>
  trace_ridges(const Raster &raster, const RidgeOptions &options)
  {
    return RidgeTracer(raster, options).trace();
  }
} // namespace Riedel::Analysis
