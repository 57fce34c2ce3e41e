// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/analysis/ridge.h>
#include <riedel/analysis/triangle_search.h>

#include <vector>

namespace Riedel::Analysis
{
  /**
   * Number of places at the boundary of the body where two bands of opposite
   * sign meet: there one is reflected as the other one. Near such a place their
   * rotations cancel and the ridges end, so that both are prolonged straight on
   * from their ends, by @p reach [m] at most, to where they leave the body; the
   * two places may be as far apart as this. An end belongs to one reflection
   * only, the nearest ones first.
   */
  unsigned int
  count_reflections(const std::vector<Ridge> &ridges,
                    const TriangleSearch     &search,
                    const double              grain_size,
                    const double              reach);
} // namespace Riedel::Analysis
