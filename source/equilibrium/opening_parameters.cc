// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/equilibrium/opening_parameters.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <string>
#include <utility>

namespace Riedel::Equilibrium
{
  template <int dim>
  void
  OpeningParameters<dim>::declare(dealii::ParameterHandler &prm)
  {
    namespace Patterns = dealii::Patterns;
    prm.declare_entry("Control",
                      "load",
                      Patterns::Selection("load|opening"),
                      "What grows in a step. \"load\": s, which formulas use. "
                      "\"opening\": the displacement between two places, s "
                      "times Opening/Final opening; the formulas of boundary "
                      "conditions and loads get, in place of s, the load "
                      "factor that belongs to it. So the load may fall and "
                      "prescribed displacements may go back: snap-back.");
    prm.enter_subsection("Opening");
    prm.declare_entry("Component",
                      "1",
                      Patterns::Integer(1, dim),
                      "Which component of the displacement is measured.");
    prm.declare_entry("From",
                      "",
                      Patterns::List(Patterns::Double(), 0, dim),
                      "A place of the undeformed body [m]; of moving material "
                      "points the nearest one.");
    prm.declare_entry("To",
                      "",
                      Patterns::List(Patterns::Double(), 0, dim),
                      "The other place [m]: the opening is its displacement "
                      "minus that of From.");
    prm.declare_entry("Final opening",
                      "0",
                      Patterns::Double(),
                      "The opening at s = 1 [m], of either sign.");
    prm.leave_subsection();
  }



  template <int dim>
  void
  OpeningParameters<dim>::parse(dealii::ParameterHandler &prm)
  {
    const auto numbers = [&prm](const std::string &entry) {
      return dealii::Utilities::string_to_double(
        dealii::Utilities::split_string_list(prm.get(entry)));
    };
    controls = prm.get("Control") == "opening";
    prm.enter_subsection("Opening");
    component     = prm.get_integer("Component") - 1;
    from          = numbers("From");
    to            = numbers("To");
    final_opening = prm.get_double("Final opening");
    prm.leave_subsection();
  }



  template <int dim>
  void
  OpeningParameters<dim>::check(Problems &problems) const
  {
    const std::string section = "Loading/Opening";
    if (!controls)
      {
        if (!from.empty() || !to.empty() || final_opening != 0.0)
          problems.error(section,
                         "It has no effect: write \"set Control = opening\" in "
                         "section Loading, or remove it.");
        return;
      }
    if (final_opening == 0.0)
      problems.error(section + "/Final opening",
                     "With Control = opening it must not be 0.");
    for (const auto &[entry, place] :
         {std::make_pair("From", &from), std::make_pair("To", &to)})
      if (place->size() != dim)
        problems.error(section + "/" + entry,
                       "It needs " + std::to_string(dim) +
                         " coordinates [m]; there are " +
                         std::to_string(place->size()) + ".");
    if (from.size() == dim && from == to)
      problems.error(section + "/To", "It is the same place as From.");
  }



  template struct OpeningParameters<2>;
  template struct OpeningParameters<3>;
} // namespace Riedel::Equilibrium
