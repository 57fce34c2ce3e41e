// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/rank_meeting.h>

#include <chrono>
#include <thread>

namespace Riedel
{
  RankMeeting::RankMeeting()
  {
    MPI_Comm_dup(MPI_COMM_WORLD, &communicator);
  }



  RankMeeting::~RankMeeting()
  {
    MPI_Comm_free(&communicator);
  }



  bool
  RankMeeting::of_all_ranks() const
  {
    using namespace std::chrono;
    MPI_Request request;
    int         all_here = 0;
    MPI_Ibarrier(communicator, &request);
    const auto latest = steady_clock::now() + seconds(5);
    while (all_here == 0 && steady_clock::now() < latest)
      {
        MPI_Test(&request, &all_here, MPI_STATUS_IGNORE);
        if (all_here == 0)
          std::this_thread::sleep_for(milliseconds(5));
      }
    return all_here != 0;
  }
} // namespace Riedel
