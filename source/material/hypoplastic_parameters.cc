// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/material/hypoplastic_parameters.h>
#include <riedel/material/substepping.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <array>
#include <sstream>

namespace Riedel::Material
{
  void
  HypoplasticParameters::declare(const bool                micropolar,
                                 dealii::ParameterHandler &prm)
  {
    using dealii::Patterns::Anything;
    using dealii::Patterns::Double;
    using dealii::Patterns::Integer;

    prm.declare_entry("Critical friction angle",
                      "0",
                      Double(),
                      "Friction angle of the sand in triaxial compression when "
                      "it shears at constant volume, phi_c. Degrees.",
                      true);
    prm.declare_entry("Granular hardness",
                      "0",
                      Double(),
                      "Pressure scale h_s of the compression law e = e_0 "
                      "exp(-(3 p/h_s)^n). Pa.",
                      true);
    prm.declare_entry("Minimum void ratio",
                      "0",
                      Double(),
                      "Void ratio of the densest packing at zero pressure, "
                      "e_d0. Dimensionless.",
                      true);
    prm.declare_entry("Critical void ratio",
                      "0",
                      Double(),
                      "Void ratio at which the sand shears at constant volume, "
                      "at zero pressure, e_c0. Dimensionless.",
                      true);
    prm.declare_entry("Maximum void ratio",
                      "0",
                      Double(),
                      "Void ratio of the loosest packing at zero pressure, "
                      "e_i0. Dimensionless.",
                      true);
    prm.declare_entry("Density exponent",
                      "0",
                      Double(),
                      "Exponent alpha of the density factor f_d = ((e - "
                      "e_d)/(e_c - e_d))^alpha. Dimensionless.",
                      true);
    prm.declare_entry("Hardness exponent",
                      "0",
                      Double(),
                      "Exponent n of the compression law. Dimensionless.",
                      true);
    // The classical law knows the polar constants too, its stresses ignore
    // them: to compare, one changes only the law.
    const std::string ignored =
      micropolar ? "" : " The classical law ignores it.";
    prm.declare_entry("Mean grain diameter",
                      "0",
                      Double(),
                      micropolar ?
                        "Length d_50 that sets the width of shear bands [m]." :
                        "Length d_50 [m]; the classical law only measures "
                        "shear bands and sizes of cells by it.",
                      micropolar);
    prm.declare_entry("Polar constant",
                      "1/a1",
                      Anything(),
                      "Micropolar constant a_c: \"1/a1\" (the published "
                      "choice), \"a1 + 1/a1\" (a band then ends at the "
                      "critical void ratio exactly) or a number. "
                      "Dimensionless." +
                        ignored);
    prm.declare_entry("Floor pressure",
                      "100",
                      Double(),
                      "Smallest mean pressure: a point below it is returned to "
                      "it and counted; its deviator and couple stress vanish "
                      "with the pressure that it would have. Pa.");
    prm.declare_entry("Substep tolerance",
                      "1e-4",
                      Double(),
                      "Local error of one substep, relative to the size of "
                      "stress and couple stress. Dimensionless.");
    prm.declare_entry("Largest number of substeps",
                      "8192",
                      Integer(),
                      "Substeps of one step at most; the smallest substep is "
                      "the step divided by the largest power of two in this "
                      "number. Beyond it the point is refused.");
  }



  void
  HypoplasticParameters::parse(const bool                micropolar,
                               dealii::ParameterHandler &prm)
  {
    constants               = HypoplasticConstants();
    constexpr double radian = 3.14159265358979323846 / 180.;
    constants.critical_friction_angle =
      prm.get_double("Critical friction angle") * radian;
    constants.granular_hardness   = prm.get_double("Granular hardness");
    constants.minimum_void_ratio  = prm.get_double("Minimum void ratio");
    constants.critical_void_ratio = prm.get_double("Critical void ratio");
    constants.maximum_void_ratio  = prm.get_double("Maximum void ratio");
    constants.density_exponent    = prm.get_double("Density exponent");
    constants.hardness_exponent   = prm.get_double("Hardness exponent");
    grain_diameter                = prm.get_double("Mean grain diameter");
    if (micropolar)
      {
        constants.mean_grain_diameter = grain_diameter;
        polar_constant                = prm.get("Polar constant");

        constants.polar_number  = 0.;
        constants.polar_inverse = 0.;
        constants.polar_linear  = 0.;
        polar_constant_ok       = true;
        std::string plain       = polar_constant;
        plain.erase(std::remove(plain.begin(), plain.end(), ' '), plain.end());
        if (plain == "1/a1")
          constants.polar_inverse = 1.;
        else if (plain == "a1+1/a1" || plain == "1/a1+a1")
          {
            constants.polar_inverse = 1.;
            constants.polar_linear  = 1.;
          }
        else
          {
            std::istringstream text(plain);
            polar_constant_ok =
              (text >> constants.polar_number) && text.peek() == EOF;
          }
      }
    controls.floor_pressure    = prm.get_double("Floor pressure");
    controls.substep_tolerance = prm.get_double("Substep tolerance");
    controls.n_smallest_substeps =
      BinarySubsteps::subdivision(static_cast<unsigned int>(
        std::max(1L, prm.get_integer("Largest number of substeps"))));

    constants.derive();
    controls.densest_at_floor = constants.minimum_void_ratio *
                                constants.compression(controls.floor_pressure);
  }



  namespace
  {
    template <typename T>
    std::string
    text_of(const T &value)
    {
      std::ostringstream text;
      text << value;
      return text.str();
    }
  } // namespace



  void
  HypoplasticParameters::check(const bool         micropolar,
                               const std::string &path,
                               Problems          &problems) const
  {
    constexpr double degree = 180. / 3.14159265358979323846;

    const auto require = [&](const bool         holds,
                             const std::string &entry,
                             const double       read,
                             const std::string &allowed) {
      if (!holds)
        problems.error(path + "/" + entry,
                       entry + " is " + text_of(read) + ", but " + allowed +
                         ".");
    };

    const double phi_c = constants.critical_friction_angle * degree;
    const double e_d   = constants.minimum_void_ratio;
    const double e_c   = constants.critical_void_ratio;
    const double e_i   = constants.maximum_void_ratio;
    const double n     = constants.hardness_exponent;

    const std::size_t errors_before = problems.errors.size();
    require(phi_c > 0. && phi_c < 90.,
            "Critical friction angle",
            phi_c,
            "it must lie between 0 and 90 degrees");
    require(constants.granular_hardness > 0.,
            "Granular hardness",
            constants.granular_hardness,
            "it must be a positive pressure in Pa (sands: about 1e8 to 1e10)");
    require(e_d > 0., "Minimum void ratio", e_d, "it must be positive");
    require(e_c > e_d,
            "Critical void ratio",
            e_c,
            "it must be above the minimum void ratio, " + text_of(e_d));
    require(e_i > e_c,
            "Maximum void ratio",
            e_i,
            "it must be above the critical void ratio, " + text_of(e_c));
    require(constants.density_exponent > 0.,
            "Density exponent",
            constants.density_exponent,
            "it must be positive (sands: 0.1 to 0.3)");
    require(n > 0. && n < 1.,
            "Hardness exponent",
            n,
            "it must lie between 0 and 1 (sands: 0.2 to 0.5)");
    if (micropolar)
      {
        require(constants.mean_grain_diameter > 0.,
                "Mean grain diameter",
                constants.mean_grain_diameter,
                "it must be a positive length in m");
        if (!polar_constant_ok)
          problems.error(path + "/Polar constant",
                         "Polar constant is \"" + polar_constant +
                           "\", but it must be \"1/a1\", \"a1 + 1/a1\" or "
                           "a number.");
        else if (constants.polar_inverse == 0. && constants.polar_number < 2.)
          problems.warning(path + "/Polar constant",
                           "Polar constant is " +
                             text_of(constants.polar_number) +
                             "; below 2 the couple stress of a shear band can "
                             "grow without a limit.");
      }
    require(controls.floor_pressure > 0.,
            "Floor pressure",
            controls.floor_pressure,
            "it must be a positive pressure in Pa");
    require(controls.substep_tolerance > 0. && controls.substep_tolerance < 1.,
            "Substep tolerance",
            controls.substep_tolerance,
            "it must lie between 0 and 1 (1e-6 to 1e-3 are sensible)");

    // only if the constants it follows from are in order
    if (problems.errors.size() == errors_before && !(constants.h_i > 0.))
      problems.error(path + "/Density exponent",
                     "These constants give the stiffness constant h_i = "
                     "1/c_1^2 + 1/3 - ((e_i0 - e_d0)/(e_c0 - e_d0))^alpha / "
                     "(c_1 sqrt(3)) = " +
                       text_of(constants.h_i) +
                       ", but it must be positive: lower the density exponent "
                       "or the maximum void ratio.");
  }



  void
  HypoplasticParameters::check_initial(const InitialState &initial,
                                       const std::string  &path,
                                       Problems           &problems) const
  {
    const double p = -dealii::trace(initial.stress) / 3.;
    const double e = initial.void_ratio;
    if (!(e > 0.))
      problems.error(path,
                     "The void ratio is " + text_of(e) +
                       ", but it must be positive.");

    const std::array<double, 5> stress{{initial.stress[0][0],
                                        initial.stress[1][1],
                                        initial.stress[2][2],
                                        initial.stress[0][1],
                                        initial.stress[0][1]}};
    if (!is_compressive(stress))
      {
        problems.error(path,
                       "The initial stress (11: " + text_of(stress[0]) +
                         ", 22: " + text_of(stress[1]) + ", 33: " +
                         text_of(stress[2]) + ", 12: " + text_of(stress[3]) +
                         " Pa) is not compressive in all directions; a "
                         "hypoplastic body must start under pressure.");
        return;
      }
    if (p < 1e3 || p > 1e6)
      problems.warning(path,
                       "The initial mean pressure is " + text_of(p) +
                         " Pa; the law is meant for 1e3 to 1e6 Pa.");
    const double factor = constants.compression(p);
    if (e > 0. && e < constants.minimum_void_ratio * factor)
      problems.warning(path,
                       "The void ratio " + text_of(e) +
                         " is below that of the densest packing, " +
                         text_of(constants.minimum_void_ratio * factor) +
                         " at this pressure; the density factor is clamped.");
    if (e > constants.maximum_void_ratio * factor)
      problems.warning(path,
                       "The void ratio " + text_of(e) +
                         " is above that of the loosest packing, " +
                         text_of(constants.maximum_void_ratio * factor) +
                         " at this pressure.");
  }
} // namespace Riedel::Material
