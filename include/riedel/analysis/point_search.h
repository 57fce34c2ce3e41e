// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/analysis/geometry.h>
#include <riedel/analysis/shear_bands.h>

#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace Riedel::Analysis
{
  /// Finds the material point nearest to a place. Keeps a reference to the
  /// field.
  class PointSearch
  {
  public:
    /// @p bin_size [m] should be of the order of the points' distance.
    PointSearch(const DeformedField &field, double bin_size);

    /// Number of the nearest point not further than @p limit [m].
    std::optional<std::size_t>
    nearest(const Point &place, double limit) const;

  private:
    std::pair<long, long>
    bin(const Point &place) const;

    const DeformedField                                      &field;
    double                                                    bin_size;
    std::map<std::pair<long, long>, std::vector<std::size_t>> points_in_bin;
  };
} // namespace Riedel::Analysis
