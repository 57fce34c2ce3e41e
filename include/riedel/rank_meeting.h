// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <mpi.h>

namespace Riedel
{
  /**
   * Where ranks meet after an error. Most errors are met by all ranks together;
   * one that concerns a part of the body may be met by one rank alone, while
   * the others would wait for it forever.
   */
  class RankMeeting
  {
  public:
    RankMeeting();
    ~RankMeeting();

    RankMeeting(const RankMeeting &) = delete;

    /// Do all ranks arrive here within a few seconds? If not, only MPI_Abort
    /// ends those that are still computing.
    bool
    of_all_ranks() const;

  private:
    /// of its own: the others may be in a collective call of another
    MPI_Comm communicator;
  };
} // namespace Riedel
