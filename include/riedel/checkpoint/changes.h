// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace Riedel::Checkpoint
{
  /// A parameter of the present run.
  struct Setting
  {
    std::string path; ///< sections and parameter, separated by '/'
    std::string value;
    std::string default_value;
  };

  /// May a resumed run have another value of this parameter? It may if the
  /// state that has been reached does not depend on it.
  bool
  may_change(const std::string &path);

  /// Parameters that differ from those of the checkpoint and may not: a line
  /// for people each, "Section/Parameter: old in the checkpoint, new now".
  /// "1e5" and "100e3" are the same.
  std::vector<std::string>
  forbidden_changes(
    const std::vector<std::pair<std::string, std::string>> &saved,
    const std::vector<Setting>                             &present);
} // namespace Riedel::Checkpoint
