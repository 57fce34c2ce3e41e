// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/errors.h>
#include <riedel/rank_meeting.h>
#include <riedel/run.h>

#include <deal.II/base/mpi.h>

#include <exception>
#include <iostream>
#include <string>

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const Riedel::RankMeeting                      meeting;
  const bool                                     speaks =
    dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;

  // says what went wrong: once, if all ranks know it
  const auto end = [&](const std::string &text, const int code) {
    const bool together = meeting.of_all_ranks();
    if (speaks || !together)
      std::cerr << text << std::endl;
    if (!together)
      MPI_Abort(MPI_COMM_WORLD, code);
    return code;
  };
  try
    {
      Riedel::run(argc, argv, speaks);
      return 0;
    }
  catch (const Riedel::InputError &error)
    {
      return end(error.what(), 2);
    }
  catch (const Riedel::ComputationError &error)
    {
      return end(std::string("The computation stopped.\n") + error.what(), 1);
    }
  catch (const std::exception &error)
    {
      return end(std::string("A defect of Riedel: ") + error.what(), 1);
    }
}
