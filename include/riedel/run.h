// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace Riedel
{
  /// Does what the command line asks for, on all ranks of MPI_COMM_WORLD:
  /// answers, or computes a case into a results folder. Throws InputError or
  /// ComputationError, on all ranks together.
  /// @param speaks does this rank write to the terminal?
  void
  run(const int argc, char **argv, const bool speaks);
} // namespace Riedel
