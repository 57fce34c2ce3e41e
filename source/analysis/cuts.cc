// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/analysis/cuts.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace Riedel::Analysis
{
  namespace
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();

    /// Distances from @p start along @p direction at which the rotation falls
    /// to 50 and 10 % of @p peak.
    std::array<double, 2>
    half_widths(const TriangleSampler &sampler,
                const Point           &start,
                const Point           &direction,
                const double           sign,
                const double           peak,
                const double           step)
    {
      const std::array<double, 2> levels = {{0.5 * peak, 0.1 * peak}};
      // a rise by more than this is another band; kinks rise less
      const double valley = 0.1 * peak;

      std::array<double, 2> result = {{nan, nan}};
      unsigned int          next   = 0;
      double                before = peak, least = peak;
      for (unsigned int k = 1; next < levels.size(); ++k)
        {
          const auto value = sampler.value(advance(start, k * step, direction));
          if (!value || sign * *value > least + valley)
            break;
          const double v = sign * *value;
          while (next < levels.size() && v <= levels[next])
            {
              const double share = (before - levels[next]) / (before - v);
              result[next++]     = (k - 1 + share) * step;
            }
          before = v;
          least  = std::fmin(least, v);
        }
      return result;
    }
  } // namespace



  CutWidths
  cut_band(const TriangleSampler &sampler,
           const Point           &centre,
           const Point           &normal,
           const double           sign,
           const double           reach,
           const double           step)
  {
    const auto value = [&](const int k) {
      const auto v = sampler.value(advance(centre, k * step, normal));
      return v ? sign * *v : -std::numeric_limits<double>::infinity();
    };

    const int limit = static_cast<int>(std::ceil(reach / step));
    int       best  = 0;
    for (int k = -limit; k <= limit; ++k)
      if (value(k) > value(best))
        best = k;
    for (const int side : {-1, 1})
      while (value(best + side) > value(best))
        best += side;

    const double peak = value(best);
    if (!(peak > 0.))
      return {nan, nan};
    const Point maximum = advance(centre, best * step, normal);
    const auto  ahead = half_widths(sampler, maximum, normal, sign, peak, step);
    const auto  behind =
      half_widths(sampler, maximum, reversed(normal), sign, peak, step);
    return {ahead[0] + behind[0], ahead[1] + behind[1]};
  }
} // namespace Riedel::Analysis
