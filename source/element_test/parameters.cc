// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/element_test/parameters.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <utility>

namespace Riedel::ElementTest
{
  namespace
  {
    const std::string section = "Element test";

    const std::vector<std::pair<std::string, Test>> test_names = {
      {"biaxial", Test::biaxial},
      {"oedometer", Test::oedometer},
      {"isotropic", Test::isotropic},
      {"triaxial drained", Test::triaxial_drained},
      {"triaxial undrained", Test::triaxial_undrained},
      {"simple shear", Test::simple_shear},
      {"path", Test::path}};



    /// Numbers separated by commas or blanks; throws std::exception.
    PathRow
    parse_row(std::string text)
    {
      std::replace(text.begin(), text.end(), ',', ' ');
      std::istringstream  words(text);
      std::vector<double> numbers;
      for (std::string word; words >> word;)
        numbers.push_back(dealii::Utilities::string_to_double(word));
      if (numbers.size() < 7 || numbers.size() > 9)
        throw std::invalid_argument("wrong number of columns");

      PathRow row;
      std::copy(numbers.begin(), numbers.begin() + 7, row.increments.begin());
      if (numbers.size() >= 8)
        {
          if (!(numbers[7] >= 1. && numbers[7] <= 1e9 &&
                numbers[7] == std::floor(numbers[7])))
            throw std::invalid_argument("repeats");
          row.repeats = static_cast<unsigned int>(numbers[7]);
        }
      if (numbers.size() == 9)
        row.axis_3_strain = numbers[8];
      return row;
    }
  } // namespace



  void
  Parameters::declare(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    prm.enter_subsection(section);
    std::string names;
    for (const auto &[name, value] : test_names)
      names += (names.empty() ? "" : "|") + name;
    prm.declare_entry(
      "Test",
      "biaxial",
      Selection(names),
      "`biaxial': axis 1 is shortened, sigma_22 stays constant, plane strain; "
      "`oedometer': axis 2 is shortened, axes 1 and 3 are held; `isotropic': "
      "all three axes are shortened alike; `triaxial drained': axis 1 is "
      "shortened, sigma_22 = sigma_33 stay constant; `triaxial undrained': "
      "axis 1 is shortened at constant volume, axes 2 and 3 become longer "
      "alike; `simple shear': planes with normal 2 slide along axis 1, which "
      "like axis 3 keeps its length; `path': given increments.");
    prm.declare_entry("Material",
                      "",
                      Anything(),
                      "Name of the material under test. Empty: the only one.");
    prm.declare_entry("Void ratio",
                      "0.6",
                      Double(),
                      "Void ratio at the start. Dimensionless.");
    prm.declare_entry("Vertical pressure",
                      "100e3",
                      Double(),
                      "-sigma_22 at the start. Kept in biaxial and drained "
                      "triaxial tests, as the cell pressure, and in simple "
                      "shear that keeps the normal stress. Pa.");
    prm.declare_entry("K0",
                      "1",
                      Double(),
                      "Ratio sigma_11/sigma_22 = sigma_33/sigma_22 at the "
                      "start. 1 in triaxial tests. Dimensionless.");
    prm.declare_entry("Axial strain",
                      "0.1",
                      Double(),
                      "Logarithmic shortening of the axis at the end of the "
                      "test, in an isotropic test of every axis. "
                      "Dimensionless.");
    prm.declare_entry("Shear strain",
                      "0.1",
                      Double(),
                      "Shear strain gamma_12 at the end of simple shear. "
                      "Dimensionless.");
    prm.declare_entry("Simple shear keeps",
                      "normal stress",
                      Selection("normal stress|volume"),
                      "What stays constant in simple shear: sigma_22, or the "
                      "volume (as in an undrained test).");
    prm.declare_entry("Micro-rotation",
                      "continuum spin",
                      Anything(),
                      "How grains turn in simple shear: with the `continuum "
                      "spin', as in a classical continuum, or to this angle "
                      "at the end of the test, counter-clockwise positive. "
                      "Degrees.");
    prm.declare_entry("Steps",
                      "1000",
                      Integer(),
                      "Number of equal steps to the axial or shear strain.");
    prm.declare_entry("Increments",
                      "",
                      Anything(),
                      "Rows of a path, separated by semicolons: H11 H12 H21 "
                      "H22 theta Gamma1 Gamma2; optional are the number of "
                      "repeats and, behind it, the logarithmic strain of axis "
                      "3. Dimensionless, rad, 1/m.");
    prm.declare_entry("Increments file",
                      "",
                      Anything(),
                      "Comma separated file with such rows, one per line, "
                      "relative to the working directory; lines that start "
                      "with # are skipped.");
    prm.leave_subsection();
  }



  void
  Parameters::parse(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection(section);
    const std::string name = prm.get("Test");
    test                   = std::find_if(test_names.begin(),
                        test_names.end(),
                        [&](const auto &entry) { return entry.first == name; })
             ->second;
    material           = prm.get("Material");
    void_ratio         = prm.get_double("Void ratio");
    vertical_pressure  = prm.get_double("Vertical pressure");
    K0                 = prm.get_double("K0");
    axial_strain       = prm.get_double("Axial strain");
    shear_strain       = prm.get_double("Shear strain");
    shear_keeps_volume = prm.get("Simple shear keeps") == "volume";

    const std::string rotation = prm.get("Micro-rotation");
    turns_with_spin            = rotation == "continuum spin";
    micro_rotation             = 0.;
    unreadable_micro_rotation.clear();
    if (!turns_with_spin)
      try
        {
          micro_rotation = dealii::Utilities::string_to_double(rotation) *
                           3.14159265358979323846 / 180.;
        }
      catch (const std::exception &)
        {
          unreadable_micro_rotation = rotation;
        }
    steps = static_cast<unsigned int>(std::max(0L, prm.get_integer("Steps")));
    increments      = prm.get("Increments");
    increments_file = prm.get("Increments file");
    prm.leave_subsection();
  }



  void
  Parameters::check(Problems &problems) const
  {
    // stresses and void ratio are the business of the law
    if (test == Test::path)
      {
        try
          {
            path_rows();
          }
        catch (const InputError &error)
          {
            problems.error(section + (increments.empty() ? "/Increments file" :
                                                           "/Increments"),
                           error.what());
          }
        return;
      }
    if (steps < 1)
      problems.error(section + "/Steps", "A test needs at least one step.");
    if (test == Test::simple_shear)
      {
        if (shear_strain == 0.)
          problems.error(section + "/Shear strain",
                         "Shear strain is 0, but simple shear must shear the "
                         "body.");
        if (!unreadable_micro_rotation.empty())
          problems.error(section + "/Micro-rotation",
                         "Micro-rotation is \"" + unreadable_micro_rotation +
                           "\", but it must be \"continuum spin\" or an "
                           "angle in degrees.");
        return;
      }
    if (!turns_with_spin)
      problems.error(section + "/Micro-rotation",
                     "Grains turn in simple shear only. Remove it, or write "
                     "\"set Test = simple shear\".");
    if ((test == Test::triaxial_drained || test == Test::triaxial_undrained) &&
        K0 != 1.)
      {
        std::ostringstream text;
        text << "K0 is " << K0
             << ", but a triaxial test begins with the cell pressure on all "
                "sides, K0 = 1.";
        problems.error(section + "/K0", text.str());
      }
    if (axial_strain == 0.)
      problems.error(section + "/Axial strain",
                     "Axial strain is 0, but a test must shorten (positive) or "
                     "stretch (negative) the body.");
  }



  void
  Parameters::check_law(const Material::Law<2> &law, Problems &problems) const
  {
    const auto refuse_axis_3 = [&](const std::string &entry,
                                   const std::string &what) {
      problems.error(section + entry,
                     what + " changes the length of axis 3, but the law \"" +
                       law.name() +
                       "\" knows plane strain only. It can do the tests "
                       "biaxial, oedometer, simple shear, and paths without a "
                       "strain of axis 3.");
    };

    switch (test)
      {
        case Test::isotropic:
        case Test::triaxial_drained:
        case Test::triaxial_undrained:
          if (!law.can_stretch_axis_3())
            refuse_axis_3("/Test", "This test");
          break;

        case Test::simple_shear:
          if (!turns_with_spin && !law.is_micropolar())
            problems.error(section + "/Micro-rotation",
                           "The law \"" + law.name() +
                             "\" is not micropolar: its grains have no "
                             "rotation of their own. Write \"continuum "
                             "spin\".");
          break;

        case Test::path:
          {
            const std::string entry =
              increments.empty() ? "/Increments file" : "/Increments";
            std::vector<PathRow> rows;
            try
              {
                rows = path_rows();
              }
            catch (const InputError &)
              {
                break; // check() has said so
              }
            bool stretches = false, rotates = false;
            for (const PathRow &row : rows)
              {
                stretches = stretches || row.axis_3_strain != 0.;
                for (unsigned int i = law.n_generalised(); i < 7; ++i)
                  rotates = rotates || row.increments[i] != 0.;
              }
            if (stretches && !law.can_stretch_axis_3())
              refuse_axis_3(entry, "This path");
            if (rotates)
              problems.error(section + entry,
                             "The path rotates the grains, but the law \"" +
                               law.name() +
                               "\" is not micropolar: theta, Gamma1 and "
                               "Gamma2 must be 0.");
            break;
          }

        case Test::biaxial:
        case Test::oedometer:
          break;
      }
  }



  bool
  Parameters::is_undrained() const
  {
    return test == Test::triaxial_undrained ||
           (test == Test::simple_shear && shear_keeps_volume);
  }



  std::vector<PathRow>
  Parameters::path_rows() const
  {
    if (increments.empty() == increments_file.empty())
      throw InputError("A path needs either `Increments' or `Increments file', "
                       "one of them.");

    std::vector<std::string> lines;
    if (!increments.empty())
      lines = dealii::Utilities::split_string_list(increments, ';');
    else
      {
        std::ifstream file(increments_file);
        if (!file)
          throw InputError("The file `" + increments_file +
                           "' of increments cannot be read.");
        for (std::string line; std::getline(file, line);)
          lines.push_back(dealii::Utilities::trim(line));
      }

    std::vector<PathRow> rows;
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (!lines[i].empty() && lines[i][0] != '#')
        try
          {
            rows.push_back(parse_row(lines[i]));
          }
        catch (const std::exception &)
          {
            throw InputError("Row " + std::to_string(i + 1) +
                             " of the increments is `" + lines[i] +
                             "', but it must be the seven numbers H11 H12 H21 "
                             "H22 theta Gamma1 Gamma2 and, if wanted, a whole "
                             "number of repeats and behind it the strain of "
                             "axis 3.");
          }
    if (rows.empty())
      throw InputError("The path has no increments.");
    return rows;
  }
} // namespace Riedel::ElementTest
