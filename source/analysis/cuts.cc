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

    using Profile = std::function<std::optional<double>(double)>;



    /// Distances from @p start, to one side (+1 or -1), at which the profile
    /// falls to 50 and 10 % of @p peak.
    std::array<double, 2>
    half_widths(const Profile &profile,
                const double   start,
                const int      side,
                const double   peak,
                const double   step)
    {
      const std::array<double, 2> levels = {{0.5 * peak, 0.1 * peak}};
      // a rise by more than this is another band; kinks rise less
      const double valley = 0.1 * peak;

      std::array<double, 2> result = {{nan, nan}};
      unsigned int          next   = 0;
      double                before = peak, least = peak;
      for (unsigned int k = 1; next < levels.size(); ++k)
        {
          const auto value = profile(start + side * (k * step));
          if (!value || *value > least + valley)
            break;
          while (next < levels.size() && *value <= levels[next])
            {
              const double share = (before - levels[next]) / (before - *value);
              result[next++]     = (k - 1 + share) * step;
            }
          before = *value;
          least  = std::fmin(least, *value);
        }
      return result;
    }
  } // namespace



  std::optional<double>
  mean_along(const TriangleSampler &sampler,
             const Point           &place,
             const Point           &direction,
             const double           half_length,
             const double           step)
  {
    const int n   = static_cast<int>(std::lround(half_length / step));
    double    sum = 0.;
    for (int i = -n; i <= n; ++i)
      {
        const auto value = sampler.value(advance(place, i * step, direction));
        if (!value)
          return std::nullopt;
        sum += *value;
      }
    return sum / (2 * n + 1);
  }



  Thickness
  cut_band(const Profile &profile, const double reach, const double step)
  {
    const auto value = [&](const int k) {
      return profile(k * step).value_or(
        -std::numeric_limits<double>::infinity());
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
    const auto ahead  = half_widths(profile, best * step, 1, peak, step);
    const auto behind = half_widths(profile, best * step, -1, peak, step);
    return {ahead[0] + behind[0], ahead[1] + behind[1]};
  }
} // namespace Riedel::Analysis
