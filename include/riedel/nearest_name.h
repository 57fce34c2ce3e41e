// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace Riedel
{
  /**
   * The number of letters to insert, delete, replace or swap with their
   * neighbour that turn one word into the other; capitals count as small
   * letters.
   */
  unsigned int
  edit_distance(const std::string &first, const std::string &second);

  /**
   * The candidates that a user may have meant by @p name, nearest first, at
   * most three. Empty if nothing is near.
   */
  std::vector<std::string>
  nearest_names(const std::string              &name,
                const std::vector<std::string> &candidates);

  /**
   * ` Did you mean "Cells"?` with a leading blank, or an empty text if no
   * candidate is near.
   */
  std::string
  did_you_mean(const std::string              &name,
               const std::vector<std::string> &candidates);

  /// `left, right, bottom`
  std::string
  enumerate(const std::vector<std::string> &names);
} // namespace Riedel
