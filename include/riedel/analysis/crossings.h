// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/analysis/geometry.h>
#include <riedel/analysis/ridge.h>

#include <vector>

namespace Riedel::Analysis
{
  /**
   * Where ridges meet: intersections of the lines through their points, both
   * ends prolonged by @p prolongation [m], and the middles of bridges (a band
   * may be crossed by one that is itself too short to count).
   */
  std::vector<Point>
  find_crossings(const std::vector<Ridge> &ridges, double prolongation);

  /**
   * Median distance [m] of @p other from @p ridge, measured along the normal
   * of @p line, the straight line through the ridge, from those points of the
   * ridge whose normal meets the other one; NaN if none does.
   */
  double
  normal_distance(const Ridge &ridge, const Line &line, const Ridge &other);
} // namespace Riedel::Analysis
