// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

namespace Riedel::Analysis
{
  /// Value below which @p share (0 to 1) of the values lie; NaN if there are
  /// none.
  double
  quantile(std::vector<double> values, double share);

  /// The median of the values that are numbers; NaN if there are none.
  double
  median(std::vector<double> values);
} // namespace Riedel::Analysis
