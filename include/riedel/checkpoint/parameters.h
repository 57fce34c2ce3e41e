// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace dealii
{
  class ParameterHandler;
}

namespace Riedel::Checkpoint
{
  /// Section "Checkpoint".
  struct Parameters
  {
    unsigned int every_steps   = 0;    ///< steps between two; 0: do not count
    double       every_minutes = 10.0; ///< wall time between two; 0: no clock
    unsigned int keep          = 2;    ///< checkpoints left on disk

    /// Does this run write any?
    bool
    enabled() const
    {
      return every_steps > 0 || every_minutes > 0.0;
    }

    static void
    declare(dealii::ParameterHandler &prm);
    void
    parse(dealii::ParameterHandler &prm);
  };
} // namespace Riedel::Checkpoint
