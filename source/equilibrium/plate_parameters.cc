// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/box.h>
#include <riedel/equilibrium/plate_parameters.h>
#include <riedel/pattern.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Riedel::Equilibrium
{
  using dealii::ParameterHandler;
  namespace Patterns = dealii::Patterns;

  namespace
  {
    std::string
    displacement_name(const unsigned int d)
    {
      return "Displacement " + std::to_string(d + 1);
    }

    /// Reads an angle from 0 to below 90 degrees.
    double
    read_angle(const std::string &text, const std::string &path)
    {
      const double most = 90.0;
      if (Patterns::Double().match(text))
        {
          const double angle = dealii::Utilities::string_to_double(text);
          if (angle >= 0.0 && angle < most)
            return angle;
        }
      throw ParameterError(path,
                           "\"" + text +
                             "\" is no friction angle. Write degrees from 0 to "
                             "below 90, or \"rough\".");
    }
  } // namespace



  template <int dim>
  dealii::Tensor<1, dim>
  PlateParameters<dim>::motion(const double s) const
  {
    dealii::Tensor<1, dim> result;
    for (unsigned int d = 0; d < dim; ++d)
      if (displacement[d].given())
        result[d] = displacement[d](box.center(), s);
    return result;
  }



  template <int dim>
  void
  PlatesParameters<dim>::declare(ParameterHandler               &prm,
                                 const std::vector<std::string> &names)
  {
    prm.enter_subsection("Plates");
    for (const std::string &name : names)
      {
        prm.enter_subsection(name);
        prm.declare_entry("Box",
                          "",
                          FormPattern(box_form<dim>()),
                          "Lower left and upper right corner of the block "
                          "before the first step [m]; it may touch the body. "
                          "Must be given.");
        for (unsigned int d = 0; d < dim; ++d)
          prm.declare_entry(displacement_name(d),
                            "0",
                            FormPattern("a number or a formula in s"),
                            "Displacement of the block since the start [m].");
        prm.declare_entry("Friction angle",
                          "0",
                          FormPattern("degrees from 0 to below 90, or rough"),
                          "Of Coulomb friction between block and points "
                          "[degrees]; 0: smooth, rough: points in contact do "
                          "not slide.");
        prm.declare_entry("Penalty",
                          "10",
                          Patterns::Double(0),
                          "Stiffness of the contact times the length of a "
                          "point's box, over the stiffness of the point.");
        prm.leave_subsection();
      }
    prm.leave_subsection();
  }



  template <int dim>
  void
  PlatesParameters<dim>::parse(ParameterHandler               &prm,
                               const std::vector<std::string> &names)
  {
    plates.clear();
    prm.enter_subsection("Plates");
    for (const std::string &name : names)
      {
        const std::string section = "Plates/" + name;
        prm.enter_subsection(name);
        PlateParameters<dim> plate;
        plate.name = name;
        plate.box  = read_box<dim>(prm.get("Box"), section + "/Box");
        for (unsigned int d = 0; d < dim; ++d)
          try
            {
              plate.displacement[d] =
                Expression<dim>(prm.get(displacement_name(d)));
            }
          catch (const std::invalid_argument &reason)
            {
              throw ParameterError(section + "/" + displacement_name(d),
                                   reason.what());
            }
        const std::string friction = prm.get("Friction angle");
        plate.is_rough             = friction == "rough";
        if (!plate.is_rough)
          plate.friction_coefficient =
            std::tan(read_angle(friction, section + "/Friction angle") *
                     dealii::numbers::PI / 180.0);
        plate.penalty = prm.get_double("Penalty");
        plates.push_back(plate);
        prm.leave_subsection();
      }
    prm.leave_subsection();
  }



  template <int dim>
  void
  PlatesParameters<dim>::check(const std::vector<std::string> &boundaries,
                               Problems                       &problems) const
  {
    for (const PlateParameters<dim> &plate : plates)
      {
        const std::string section = "Plates/" + plate.name;
        if (std::find(boundaries.begin(), boundaries.end(), plate.name) !=
            boundaries.end())
          problems.error(section,
                         "A boundary of the body has this name, too: their "
                         "columns in history.csv could not be told apart.");
        if (!(plate.penalty > 0.0))
          problems.error(section + "/Penalty", "It must be larger than 0.");
        if (plate.motion(0.0).norm() > 0.0)
          problems.error(section,
                         "The block has a displacement at s = 0. Give the "
                         "place before the first step as Box.");
      }
  }



  template struct PlateParameters<2>;
  template struct PlatesParameters<2>;
  template struct PlateParameters<3>;
  template struct PlatesParameters<3>;
} // namespace Riedel::Equilibrium
