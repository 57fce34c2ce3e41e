// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/pattern.h>
#include <riedel/scene/general_parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <filesystem>

namespace Riedel::Scene
{
  namespace Patterns = dealii::Patterns;

  void
  GeneralParameters::declare(dealii::ParameterHandler &prm)
  {
    prm.declare_entry("Title",
                      "",
                      Patterns::Anything(),
                      "One line about the case, for the log.");
    prm.declare_entry("Dimension",
                      "2",
                      Patterns::Selection("2|3"),
                      "2 is plane strain; 3 is space, with axis 3 upwards and "
                      "the laws of finite strain.");
    prm.declare_entry(
      "Simulation type",
      "boundary value problem",
      Patterns::Selection("boundary value problem|element test"),
      "A body with boundaries, or the test of one material point on the path "
      "of section Element test.");
    prm.declare_entry("Results",
                      "results",
                      FormPattern("the name of a folder"),
                      "Folder for everything a run writes, relative to the "
                      "working directory.");
  }



  void
  GeneralParameters::parse(dealii::ParameterHandler &prm)
  {
    title     = prm.get("Title");
    dimension = prm.get_integer("Dimension");
    type      = prm.get("Simulation type") == "element test" ?
                  SimulationType::element_test :
                  SimulationType::boundary_value_problem;
    results   = prm.get("Results");
  }



  void
  GeneralParameters::check(Problems &problems) const
  {
    std::filesystem::path folder =
      std::filesystem::path(results).lexically_normal();
    if (!folder.has_filename())
      folder = folder.parent_path();
    const std::string name = folder.filename().string();
    if (name.empty() || name == "." || name == "..")
      problems.error("Results",
                     "\"" + results +
                       "\" is not the name of a new folder. Choose a name such "
                       "as \"results\".");
    // deal.II's test driver, which packagers of tests use, removes it
    else if (name == "output")
      problems.error("Results",
                     "The folder may not be called \"output\": other tools "
                     "use and remove folders of this name. Choose another "
                     "name, for example \"results\".");
  }
} // namespace Riedel::Scene
