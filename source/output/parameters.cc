// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/output/parameters.h>
#include <riedel/pattern.h>

#include <deal.II/base/parameter_handler.h>

namespace Riedel::Output
{
  namespace Patterns = dealii::Patterns;

  void
  Parameters::declare(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Output");
    prm.declare_entry("Fields every",
                      "0.1",
                      Patterns::Double(0),
                      "Load parameter s between two sets of field files; 0: "
                      "only at the start and at the end.");
    prm.declare_entry("Write grid",
                      "true",
                      Patterns::Bool(),
                      "Fields on the grid for ParaView (.vtu, .pvd).");
    prm.declare_entry("Write points",
                      "true",
                      Patterns::Bool(),
                      "Fields at the material points for ParaView (.vtu, "
                      ".pvd) and for Python (.h5).");
    prm.declare_entry("Bands every",
                      "0.05",
                      Patterns::Double(0),
                      "Load parameter s between two measurements of the shear "
                      "bands; 0: never.");
    prm.declare_entry("Watch",
                      "",
                      FormPattern("the name of a boundary or plate"),
                      "The boundary or plate whose force the terminal shows; "
                      "without it, the first one that the load parameter "
                      "moves.");
    prm.leave_subsection();
  }



  void
  Parameters::parse(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Output");
    fields_every = prm.get_double("Fields every");
    write_grid   = prm.get_bool("Write grid");
    write_points = prm.get_bool("Write points");
    bands_every  = prm.get_double("Bands every");
    watch        = prm.get("Watch");
    prm.leave_subsection();
  }



  void
  Parameters::check(Problems &problems) const
  {
    if (!write_grid && !write_points)
      problems.warning("Output/Write grid",
                       "Neither grid nor points are written: there will be no "
                       "fields to look at.");
  }
} // namespace Riedel::Output
