// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/errors.h>
#include <riedel/scene/command_line.h>
#include <riedel/scene/scene.h>
#include <riedel/run.h>

#include <deal.II/base/mpi.h>

#include <exception>
#include <iostream>

namespace
{
  /// Does what needs no computing, or leaves it to the simulation.
  int
  run(const int argc, char **argv, const bool speaks)
  {
    using namespace Riedel;
    const Scene::CommandLine command = Scene::read_command_line(argc, argv);
    std::ostream             silence(nullptr);
    std::ostream            &out = speaks ? std::cout : silence;
    std::ostream            &err = speaks ? std::cerr : silence;

    if (!command.answer.empty())
      out << command.answer;
    else if (command.case_file.empty())
      out << print(Scene::all_parameters(), *command.print_parameters);
    else
      {
        const auto scene =
          Scene::read_scene<2>(command.case_file, command.overrides);
        for (const std::string &warning : scene.warnings)
          err << "Warning: " << warning << std::endl;
        if (command.print_parameters)
          out << print(scene.parameters, *command.print_parameters);
        else if (command.validate)
          out << command.case_file << " is valid." << std::endl;
        else
          return Riedel::run<2>(scene, command);
      }
    return 0;
  }
} // namespace



int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool                                     speaks =
    dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;

  // InputError and ComputationError are thrown on all ranks together.
  try
    {
      return run(argc, argv, speaks);
    }
  catch (const Riedel::InputError &error)
    {
      if (speaks)
        std::cerr << error.what() << std::endl;
      return 2;
    }
  catch (const Riedel::ComputationError &error)
    {
      if (speaks)
        std::cerr << "The computation stopped.\n" << error.what() << std::endl;
      return 1;
    }
  catch (const std::exception &error)
    {
      // perhaps on one rank only: the others would wait for it forever
      std::cerr << "Riedel has a defect, please report it:\n"
                << error.what() << std::endl;
      if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
        MPI_Abort(MPI_COMM_WORLD, 1);
      return 1;
    }
}
