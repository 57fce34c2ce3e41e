// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/errors.h>
#include <riedel/rank_meeting.h>
#include <riedel/run.h>
#include <riedel/scene/command_line.h>
#include <riedel/scene/scene.h>

#include <deal.II/base/mpi.h>

#include <exception>
#include <iostream>
#include <string>

namespace
{
  template <int dim>
  int
  run_case(const Riedel::Scene::CommandLine &command, std::ostream &out)
  {
    using namespace Riedel;
    const auto scene =
      Scene::read_scene<dim>(command.case_file, command.overrides);
    if (!command.validate && !command.print_parameters)
      return Riedel::run<dim>(scene, command);
    for (const std::string &warning : scene.warnings)
      out << "Warning: " << warning << std::endl;
    if (command.validate)
      out << command.case_file << " is valid." << std::endl;
    else
      out << print(scene.parameters, *command.print_parameters);
    return 0;
  }



  int
  run(const int argc, char **argv, const bool speaks)
  {
    using namespace Riedel;
    const Scene::CommandLine command = Scene::read_command_line(argc, argv);
    std::ostream             silence(nullptr);
    std::ostream            &out = speaks ? std::cout : silence;
    if (!command.answer.empty())
      out << command.answer;
    else if (command.case_file.empty())
      out << print(Scene::all_parameters(), *command.print_parameters);
    else
      {
        const auto file = command.case_file;
        if (Scene::dimension_of(file, command.overrides) == 3)
          return run_case<3>(command, out);
        return run_case<2>(command, out);
      }
    return 0;
  }
} // namespace



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
      return run(argc, argv, speaks);
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
