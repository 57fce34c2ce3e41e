// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <mpi.h>

namespace Riedel
{
  /**
   * While an object of this class lives, the first Ctrl-C (SIGINT) or SIGTERM
   * is only remembered, so that the run can end in good order; the second one
   * ends the program at once.
   */
  class Interrupt
  {
  public:
    explicit Interrupt(const MPI_Comm communicator);
    ~Interrupt();

    Interrupt(const Interrupt &) = delete;

    /// Has any rank been interrupted? Collective.
    bool
    requested() const;

  private:
    const MPI_Comm communicator;
  };
} // namespace Riedel
