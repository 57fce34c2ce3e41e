// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/analysis/raster.h>
#include <riedel/analysis/statistics.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Riedel::Analysis
{
  namespace
  {
    /**
     * Gives raster points that no triangle covers, but whose left and right
     * (or lower and upper) neighbours are in the body, the mean of these.
     * Straight triangles on curved or hanging edges leave such slits.
     */
    void
    close_slits(Raster &raster)
    {
      const std::vector<unsigned char> covered = raster.inside;
      for (long j = 1; j < raster.n[1] - 1; ++j)
        for (long i = 1; i < raster.n[0] - 1; ++i)
          {
            const long k = j * raster.n[0] + i;
            if (covered[k])
              continue;
            for (const long step : {1L, raster.n[0]})
              if (covered[k - step] && covered[k + step])
                {
                  raster.values[k] =
                    0.5 * (raster.values[k - step] + raster.values[k + step]);
                  raster.inside[k] = 1;
                }
          }
    }



    /// Convolves lines of @p data along @p axis with a symmetric kernel, whose
    /// first value is the central one.
    std::vector<double>
    convolve(const std::vector<double> &data,
             const std::array<long, 2> &n,
             const unsigned int         axis,
             const std::vector<double> &kernel)
    {
      const long          stride = (axis == 0 ? 1 : n[0]);
      const long          reach  = kernel.size() - 1;
      std::vector<double> result(data.size());
      for (long j = 0; j < n[1]; ++j)
        for (long i = 0; i < n[0]; ++i)
          {
            const long k  = j * n[0] + i;
            const long at = (axis == 0 ? i : j);
            const long lo = std::min(reach, at);
            const long hi = std::min(reach, n[axis] - 1 - at);
            double     s  = kernel[0] * data[k];
            for (long m = 1; m <= lo; ++m)
              s += kernel[m] * data[k - m * stride];
            for (long m = 1; m <= hi; ++m)
              s += kernel[m] * data[k + m * stride];
            result[k] = s;
          }
      return result;
    }
  } // namespace



  std::optional<std::size_t>
  Raster::index_near(const Point &point) const
  {
    const long i = std::lround((point[0] - origin[0]) / spacing);
    const long j = std::lround((point[1] - origin[1]) / spacing);
    if (i < 0 || j < 0 || i >= n[0] || j >= n[1] || !inside[j * n[0] + i])
      return std::nullopt;
    return j * n[0] + i;
  }



  Point
  Raster::position(const std::size_t index) const
  {
    const std::size_t row = index / n[0], column = index % n[0];
    return {{origin[0] + column * spacing, origin[1] + row * spacing}};
  }



  std::optional<double>
  Raster::value(const Point &point) const
  {
    const double x = (point[0] - origin[0]) / spacing;
    const double y = (point[1] - origin[1]) / spacing;
    const long   i = static_cast<long>(std::floor(x));
    const long   j = static_cast<long>(std::floor(y));
    if (i < 0 || j < 0 || i >= n[0] - 1 || j >= n[1] - 1)
      return std::nullopt;

    double sum = 0., weight = 0.;
    for (const long q : {0L, 1L})
      for (const long p : {0L, 1L})
        {
          const std::size_t k = (j + q) * n[0] + i + p;
          if (!inside[k])
            continue;
          const double w =
            (1. - std::abs(x - i - p)) * (1. - std::abs(y - j - q));
          sum += w * values[k];
          weight += w;
        }
    if (weight < 0.5)
      return std::nullopt;
    return sum / weight;
  }



  double
  Raster::distance_to_outside(const Point &point, const double limit) const
  {
    const long i0    = std::lround((point[0] - origin[0]) / spacing);
    const long j0    = std::lround((point[1] - origin[1]) / spacing);
    const long reach = static_cast<long>(std::ceil(limit / spacing)) + 1;

    double least = limit;
    for (long j = j0 - reach; j <= j0 + reach; ++j)
      for (long i = i0 - reach; i <= i0 + reach; ++i)
        {
          const bool in_body =
            i >= 0 && j >= 0 && i < n[0] && j < n[1] && inside[j * n[0] + i];
          if (in_body)
            continue;
          // the boundary lies, on average, half a spacing before this point
          const Point outside = {
            {origin[0] + i * spacing, origin[1] + j * spacing}};
          least = std::min(least, distance(point, outside) - 0.5 * spacing);
        }
    return std::max(least, 0.);
  }



  Raster
  rasterise(const TriangleSampler &sampler, const double spacing)
  {
    Raster raster;
    raster.spacing    = spacing;
    const Point lower = sampler.lower(), upper = sampler.upper();
    for (unsigned int axis = 0; axis < 2; ++axis)
      {
        raster.origin[axis] = lower[axis] - 0.75 * spacing;
        raster.n[axis]      = static_cast<long>(std::ceil(
                           (upper[axis] - raster.origin[axis]) / spacing)) +
                         2;
      }

    const std::size_t size = raster.n[0] * raster.n[1];
    raster.values.assign(size, 0.);
    raster.inside.assign(size, 0);
    for (std::size_t k = 0; k < size; ++k)
      if (const auto value = sampler.value(raster.position(k)))
        {
          raster.values[k] = *value;
          raster.inside[k] = 1;
        }
    close_slits(raster);
    return raster;
  }



  Raster
  smoothed(const Raster &raster, const double width)
  {
    // three standard deviations hold all but 0.3 % of the weight
    const double        sigma = width / raster.spacing;
    std::vector<double> kernel(static_cast<std::size_t>(3. * sigma) + 1);
    for (std::size_t m = 0; m < kernel.size(); ++m)
      kernel[m] = std::exp(-0.5 * m * m / (sigma * sigma));

    std::vector<double> weights(raster.inside.begin(), raster.inside.end());
    std::vector<double> values = raster.values;
    for (const unsigned int axis : {0, 1})
      {
        weights = convolve(weights, raster.n, axis, kernel);
        values  = convolve(values, raster.n, axis, kernel);
      }

    Raster result = raster;
    for (std::size_t k = 0; k < values.size(); ++k)
      if (raster.inside[k])
        result.values[k] = values[k] / weights[k];
    return result;
  }



  double
  typical_width(const Raster &raster, const double level)
  {
    const auto zone = [&](const std::size_t k) {
      if (!raster.inside[k] || std::abs(raster.values[k]) < level)
        return 0;
      return raster.values[k] > 0. ? 1 : -1;
    };

    std::vector<double> shorter(raster.values.size(),
                                std::numeric_limits<double>::infinity());
    for (const unsigned int axis : {0, 1})
      {
        const long stride = (axis == 0 ? 1 : raster.n[0]);
        const long across = (axis == 0 ? raster.n[0] : 1);
        for (long line = 0; line < raster.n[1 - axis]; ++line)
          for (long i = 0; i < raster.n[axis];)
            {
              const long first = line * across + i * stride;
              long       count = 1;
              while (i + count < raster.n[axis] &&
                     zone(first + count * stride) == zone(first))
                ++count;
              for (long m = 0; m < count; ++m)
                {
                  double &chord = shorter[first + m * stride];
                  chord         = std::min(chord, count * raster.spacing);
                }
              i += count;
            }
      }

    std::vector<double> chords;
    for (std::size_t k = 0; k < shorter.size(); ++k)
      if (zone(k) != 0)
        chords.push_back(shorter[k]);
    return chords.empty() ? 0. : median(std::move(chords));
  }
} // namespace Riedel::Analysis
