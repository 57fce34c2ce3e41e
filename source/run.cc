// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/element_test/element_test.h>
#include <riedel/errors.h>
#include <riedel/run.h>
#include <riedel/scene/command_line.h>
#include <riedel/scene/scene.h>
#include <riedel/simulation.h>

#include <deal.II/base/mpi.h>

#include <fstream>
#include <iostream>
#include <string>

namespace Riedel
{
  namespace
  {
    /// One material point; rank 0 alone has work to do.
    void
    run_element_test(const MPI_Comm               communicator,
                     const Scene::Scene<2>       &scene,
                     const Output::ResultsFolder &folder)
    {
      if (dealii::Utilities::MPI::this_mpi_process(communicator) != 0)
        return;
      ElementTest::ElementTest test(scene.element_test,
                                    *scene.materials.materials.front().law);
      const auto               write = [&]() {
        std::ofstream file(folder.path("element_test.csv"));
        test.write_csv(file);
        std::cout << test.rows().size() << " states in "
                  << folder.path("element_test.csv") << std::endl;
      };
      try
        {
          test.run();
        }
      catch (const ComputationError &)
        {
          write();
          throw;
        }
      write();
    }



    template <int dim>
    void
    compute(const Scene::Scene<dim> &scene, const Scene::CommandLine &options)
    {
      const bool is_element_test =
        scene.general.type == Scene::SimulationType::element_test;
      if (is_element_test && options.resume)
        throw InputError("An element test has no checkpoints: run it again "
                         "without --resume.");

      const MPI_Comm              communicator = MPI_COMM_WORLD;
      const Output::ResultsFolder folder(
        communicator,
        scene.general.results,
        options.resume    ? Output::Existing::resume :
        options.overwrite ? Output::Existing::replace :
                            Output::Existing::refuse,
        scene.original_text,
        Scene::print(scene.parameters, Scene::Format::prm));
      if (!is_element_test)
        Simulation<dim>(communicator, scene, folder).run();
      else if constexpr (dim == 2)
        run_element_test(communicator, scene, folder);
    }



    template <int dim>
    void
    run_case(const Scene::CommandLine &command, std::ostream &out)
    {
      const auto scene =
        Scene::read_scene<dim>(command.case_file, command.overrides);
      if (!command.validate && !command.print_parameters)
        return compute<dim>(scene, command);
      for (const std::string &warning : scene.warnings)
        out << "Warning: " << warning << std::endl;
      if (command.validate)
        out << command.case_file << " is valid." << std::endl;
      else
        out << print(scene.parameters, *command.print_parameters);
    }
  } // namespace



  void
  run(const int argc, char **argv, const bool speaks)
  {
    const Scene::CommandLine command = Scene::read_command_line(argc, argv);
    std::ostream             silence(nullptr);
    std::ostream            &out = speaks ? std::cout : silence;
    if (!command.answer.empty())
      out << command.answer;
    else if (command.case_file.empty())
      out << print(Scene::all_parameters(), *command.print_parameters);
    else if (Scene::dimension_of(command.case_file, command.overrides) == 3)
      run_case<3>(command, out);
    else
      run_case<2>(command, out);
  }
} // namespace Riedel
