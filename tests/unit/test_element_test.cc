// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/element_test/element_test.h>

#include <cmath>
#include <cstdio>
#include <sstream>

#include "law_tools.h"

using namespace Riedel;
using ElementTest::Parameters;
using ElementTest::Test;

namespace
{
  Parameters
  parse(const std::string &settings)
  {
    dealii::ParameterHandler prm;
    Parameters::declare(prm);
    prm.parse_input_from_string("subsection Element test\n" + settings +
                                "\nend\n");
    Parameters parameters;
    parameters.parse(prm);
    return parameters;
  }
} // namespace



TEST_CASE("parameters of the element test", "[unit][element_test]")
{
  const Parameters parameters = parse("set Test = oedometer\n"
                                      "set Material = sand\n"
                                      "set Void ratio = 0.7\n"
                                      "set Vertical pressure = 2e3\n"
                                      "set K0 = 0.4\n"
                                      "set Axial strain = 0.02\n"
                                      "set Steps = 40");
  CHECK(parameters.test == Test::oedometer);
  CHECK(parameters.material == "sand");
  CHECK(parameters.void_ratio == .7);
  CHECK(parameters.vertical_pressure == 2e3);
  CHECK(parameters.K0 == .4);
  CHECK(parameters.axial_strain == .02);
  CHECK(parameters.steps == 40);

  Problems problems;
  parameters.check(problems);
  CHECK(problems.errors.empty());

  parse("set Steps = 0\n set Axial strain = 0").check(problems);
  REQUIRE(problems.errors.size() == 2);
  CHECK(problems.errors[0].path == "Element test/Steps");
}



TEST_CASE("paths are read from text and from files", "[unit][element_test]")
{
  const auto rows = parse("set Test = path\n"
                          "set Increments = 1 2 3 4 5 6 7 ; "
                          "-1e-3, 0, 0, 0, 0, 0, 0, 20")
                      .path_rows();
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].increments[6] == 7.);
  CHECK(rows[0].repeats == 1);
  CHECK(rows[1].increments[0] == -1e-3);
  CHECK(rows[1].repeats == 20);

  const std::string name = "riedel_unit_path.csv";
  std::ofstream(name) << "# H11 ...\n1,2,3,4,5,6,7,8\n\n7,6,5,4,3,2,1\n";
  const auto from_file =
    parse("set Test = path\nset Increments file = " + name).path_rows();
  std::remove(name.c_str());
  REQUIRE(from_file.size() == 2);
  CHECK(from_file[0].repeats == 8);
  CHECK(from_file[1].increments[0] == 7.);

  for (const std::string wrong : {"set Increments = 1 2 3",
                                  "set Increments = 1 2 3 4 5 6 seven",
                                  "set Increments = 1 2 3 4 5 6 7 0.5",
                                  "set Increments file = does_not_exist.csv",
                                  "set Void ratio = 0.5"})
    {
      INFO(wrong);
      const Parameters parameters = parse("set Test = path\n" + wrong);
      CHECK_THROWS_AS(parameters.path_rows(), InputError);
      Problems problems;
      parameters.check(problems);
      CHECK(problems.errors.size() == 1);
    }
}



TEST_CASE("an elastic point in the element test", "[unit][element_test]")
{
  const auto law = LawTools::make_law("linear elastic");
  Parameters parameters;
  parameters.vertical_pressure = 10.;
  parameters.K0                = .5;
  parameters.axial_strain      = .01;
  parameters.steps             = 4;
  ElementTest::ElementTest test(parameters, *law);
  const auto              &rows = test.run();
  REQUIRE(rows.size() == 5);
  CHECK(rows[0].state[0] == -5.);
  // lateral: lambda (e1 + e2) + 2 mu e2 = 0, lambda = 1000, mu = 2000
  const double lateral = .01 * 1000. / 5000.;
  CHECK(rows[4].strain_11 == Approx(-.01).epsilon(1e-13));
  CHECK(rows[4].strain_22 == Approx(lateral).epsilon(1e-10));
  CHECK(rows[4].state[1] == Approx(-10.).epsilon(1e-10));
  CHECK(rows[4].state[0] ==
        Approx(-5. + 1000. * (lateral - .01) - 4000. * .01).epsilon(1e-10));

  parameters.test       = Test::isotropic;
  const auto &isotropic = test.run();
  CHECK(isotropic.back().state[0] - -5. == Approx(6000. * -.01).epsilon(1e-10));
  CHECK(isotropic.back().state[1] - -10. ==
        Approx(6000. * -.01).epsilon(1e-10));
}



TEST_CASE("rows of the element test as a file", "[unit][element_test]")
{
  const auto law = LawTools::make_law("polar hypoplastic");
  Parameters parameters;
  parameters.test              = Test::path;
  parameters.void_ratio        = .7;
  parameters.vertical_pressure = 100e3;
  parameters.increments        = "0 1e-3 0 0 0 0 0 3; 0 0 0 0 0 10 0";
  ElementTest::ElementTest test(parameters, *law);
  test.run();
  std::ostringstream out;
  test.write_csv(out);
  std::istringstream lines(out.str());
  std::string        line;
  std::getline(lines, line);
  CHECK(line ==
        "step,strain 11,strain 22,stress 11 [Pa],stress 22 [Pa],stress 33 "
        "[Pa],stress 12 [Pa],stress 21 [Pa],couple stress 1 [N/m],couple "
        "stress 2 [N/m],void ratio,substep,mobilised friction angle "
        "[deg],substeps,floored,clamped");
  const auto   columns = std::count(line.begin(), line.end(), ',');
  unsigned int n_rows  = 0;
  while (std::getline(lines, line))
    {
      CHECK(std::count(line.begin(), line.end(), ',') == columns);
      ++n_rows;
    }
  CHECK(n_rows == 5);
  CHECK(test.rows().back().state[5] != 0.);

  // the classical law has no grains that rotate
  const auto               classical = LawTools::make_law("hypoplastic");
  ElementTest::ElementTest wrong(parameters, *classical);
  CHECK_THROWS_AS(wrong.run(), ComputationError);
}



TEST_CASE("the element test says why it stopped", "[unit][element_test]")
{
  const auto law =
    LawTools::make_law("hypoplastic", {{"Largest number of substeps", "1"}});
  Parameters parameters;
  parameters.test              = Test::oedometer;
  parameters.void_ratio        = .6;
  parameters.vertical_pressure = 1e3;
  parameters.axial_strain      = .5;
  parameters.steps             = 5;
  ElementTest::ElementTest test(parameters, *law);
  try
    {
      test.run();
      FAIL("a step of ten percent in one substep was accepted");
    }
  catch (const ComputationError &error)
    {
      CHECK(std::string(error.what()).find("step 1") != std::string::npos);
      CHECK(std::string(error.what()).find("Largest number of substeps") !=
            std::string::npos);
    }
  CHECK(test.rows().size() == 1);
}
