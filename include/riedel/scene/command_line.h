// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/scene/declared_parameters.h>

#include <optional>
#include <string>
#include <vector>

namespace Riedel::Scene
{
  /// What the user asked for.
  struct CommandLine
  {
    /// the .prm file; empty only for --print-parameters and answers
    std::string case_file;
    /// texts "Section/Parameter=value" of --set
    std::vector<std::string> overrides;
    /// read and check only
    bool validate = false;
    /// replace the results of an earlier run
    bool overwrite = false;
    /// go on from the last checkpoint in the results folder
    bool resume = false;
    /// print the parameters in this format instead of computing
    std::optional<Format> print_parameters;
    /// if not empty: print this text (--help, --version) and end
    std::string answer;
  };

  /// Throws InputError for a command line that cannot be understood.
  CommandLine
  read_command_line(const int argc, const char *const *argv);
} // namespace Riedel::Scene
