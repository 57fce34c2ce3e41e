// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/element_test/parameters.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

namespace Riedel::ElementTest
{
  namespace
  {
    const std::string section = "Element test";



    /// Numbers separated by commas or blanks; throws std::exception.
    PathRow
    parse_row(std::string text)
    {
      std::replace(text.begin(), text.end(), ',', ' ');
      std::istringstream  words(text);
      std::vector<double> numbers;
      for (std::string word; words >> word;)
        numbers.push_back(dealii::Utilities::string_to_double(word));
      if (numbers.size() != 7 && numbers.size() != 8)
        throw std::invalid_argument("wrong number of columns");

      PathRow row;
      std::copy(numbers.begin(), numbers.begin() + 7, row.increments.begin());
      if (numbers.size() == 8)
        {
          if (!(numbers[7] >= 1. && numbers[7] <= 1e9 &&
                numbers[7] == std::floor(numbers[7])))
            throw std::invalid_argument("repeats");
          row.repeats = static_cast<unsigned int>(numbers[7]);
        }
      return row;
    }
  } // namespace



  void
  Parameters::declare(dealii::ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    prm.enter_subsection(section);
    prm.declare_entry("Test",
                      "biaxial",
                      Selection("biaxial|oedometer|isotropic|path"),
                      "`biaxial': axis 1 is shortened, sigma_22 stays "
                      "constant; `oedometer': axis 2 is shortened without "
                      "lateral strain; `isotropic': axes 1 and 2 are shortened "
                      "alike (plane strain: axis 3 is not); `path': given "
                      "increments.");
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
                      "-sigma_22 at the start; in a biaxial test throughout. "
                      "Pa.");
    prm.declare_entry("K0",
                      "1",
                      Double(),
                      "Ratio sigma_11/sigma_22 = sigma_33/sigma_22 at the "
                      "start. Dimensionless.");
    prm.declare_entry("Axial strain",
                      "0.1",
                      Double(),
                      "Logarithmic shortening of the axis at the end of the "
                      "test. Dimensionless.");
    prm.declare_entry("Steps",
                      "1000",
                      Integer(),
                      "Number of equal steps to the axial strain.");
    prm.declare_entry("Increments",
                      "",
                      Anything(),
                      "Rows of a path, separated by semicolons: H11 H12 H21 "
                      "H22 theta Gamma1 Gamma2 and the number of repeats "
                      "(optional). Dimensionless, rad, 1/m.");
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
    test                   = name == "biaxial"   ? Test::biaxial :
                             name == "oedometer" ? Test::oedometer :
                             name == "isotropic" ? Test::isotropic :
                                                   Test::path;
    material               = prm.get("Material");
    void_ratio             = prm.get_double("Void ratio");
    vertical_pressure      = prm.get_double("Vertical pressure");
    K0                     = prm.get_double("K0");
    axial_strain           = prm.get_double("Axial strain");
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
    if (axial_strain == 0.)
      problems.error(section + "/Axial strain",
                     "Axial strain is 0, but a test must shorten (positive) or "
                     "stretch (negative) the body.");
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
                             "number of repeats.");
          }
    if (rows.empty())
      throw InputError("The path has no increments.");
    return rows;
  }
} // namespace Riedel::ElementTest
