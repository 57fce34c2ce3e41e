// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/analysis/statistics.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Riedel::Analysis
{
  double
  quantile(std::vector<double> values, const double share)
  {
    if (values.empty())
      return std::numeric_limits<double>::quiet_NaN();

    const double      rank   = share * (values.size() - 1);
    const std::size_t lower  = static_cast<std::size_t>(rank);
    const auto        middle = values.begin() + lower;
    std::nth_element(values.begin(), middle, values.end());
    if (middle + 1 == values.end())
      return *middle;
    const double next = *std::min_element(middle + 1, values.end());
    return *middle + (rank - lower) * (next - *middle);
  }



  double
  median(std::vector<double> values)
  {
    values.erase(std::remove_if(values.begin(),
                                values.end(),
                                [](const double v) { return std::isnan(v); }),
                 values.end());
    return quantile(std::move(values), 0.5);
  }
} // namespace Riedel::Analysis
