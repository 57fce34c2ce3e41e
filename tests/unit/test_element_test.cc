// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/element_test/element_test.h>
#include <riedel/material/linear_elastic_micropolar.h>

#include <cmath>
#include <cstdio>
#include <sstream>

#include "law_tools.h"

using namespace Riedel;
using ElementTest::Parameters;
using ElementTest::Row;
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

  parameters.test         = Test::isotropic;
  const auto  &isotropic  = test.run();
  const double initial[3] = {-5., -10., -5.};
  for (unsigned int i = 0; i < 3; ++i) // 3 lambda + 2 mu
    CHECK(isotropic.back().state[i] - initial[i] ==
          Approx(7000. * -.01).epsilon(1e-10));
  CHECK(isotropic.back().strain_33 == Approx(-.01).epsilon(1e-13));
  CHECK(isotropic.back().volumetric_strain() == Approx(-.03).epsilon(1e-13));
  // of the initial stress
  CHECK(isotropic.back().deviator == Approx(5.).epsilon(1e-10));

  // Young's modulus mu (3 lambda + 2 mu)/(lambda + mu), Poisson's ratio 1/6
  parameters.test      = Test::triaxial_drained;
  parameters.K0        = 1.;
  const Row    drained = test.run().back();
  const double modulus = 2000. * 7000. / 3000.;
  CHECK(drained.state[0] - -10. == Approx(modulus * -.01).epsilon(1e-10));
  CHECK(drained.state[1] == Approx(-10.).epsilon(1e-10));
  CHECK(drained.state[2] == Approx(-10.).epsilon(1e-10));
  CHECK(drained.strain_22 == Approx(.01 / 6.).epsilon(1e-10));
  CHECK(drained.strain_33 == Approx(drained.strain_22).epsilon(1e-12));

  // constant volume: 2 mu times the strain
  parameters.test     = Test::triaxial_undrained;
  const Row undrained = test.run().back();
  CHECK(undrained.state[0] == Approx(-10. - 40.).epsilon(1e-10));
  CHECK(undrained.state[2] == Approx(-10. + 20.).epsilon(1e-10));
  CHECK(undrained.mean_pressure == Approx(10.).epsilon(1e-10));
  CHECK(undrained.deviator == Approx(60.).epsilon(1e-10));
  CHECK(undrained.excess_pore_pressure == Approx(20.).epsilon(1e-10));
}



TEST_CASE("simple shear with given micro-rotations", "[unit][element_test]")
{
  const auto law = LawTools::make_law("linear elastic micropolar",
                                      {{"Kinematics", "small strain"}});
  Parameters parameters;
  parameters.test         = Test::simple_shear;
  parameters.shear_strain = .01;
  parameters.steps        = 4;
  ElementTest::ElementTest test(parameters, *law);
  const Row                with_spin = test.run().back();
  CHECK(with_spin.state[3] == Approx(2000. * .01).epsilon(1e-10));
  CHECK(with_spin.state[4] == Approx(2000. * .01).epsilon(1e-10));
  CHECK(with_spin.shear_strain == Approx(.01).epsilon(1e-13));

  // the skew part is 2 mu_c times half of u_1,2 + 2 w
  parameters.turns_with_spin = false;
  parameters.micro_rotation  = .001;
  const Row given            = test.run().back();
  CHECK(given.state[3] == Approx(20. + 500. * .012).epsilon(1e-10));
  CHECK(given.state[4] == Approx(20. - 500. * .012).epsilon(1e-10));
}



TEST_CASE("tests that a law cannot do are refused by name",
          "[unit][element_test]")
{
  // the elastic law, as if it knew plane strain only
  struct PlaneLaw : public Material::LinearElasticClassical
  {
    bool
    can_stretch_axis_3() const override
    {
      return false;
    }
  };
  const PlaneLaw law;
  const auto     problems_of = [&](const std::string &settings) {
    Problems         problems;
    const Parameters parameters = parse(settings);
    parameters.check(problems);
    CHECK(problems.errors.empty());
    parameters.check_law(law, problems);
    return problems.errors;
  };
  for (const std::string possible :
       {"set Test = biaxial",
        "set Test = oedometer",
        "set Test = simple shear",
        "set Test = path\nset Increments = 1e-3 0 0 0 0 0 0 3 0"})
    CHECK(problems_of(possible).empty());
  for (const std::string impossible :
       {"set Test = isotropic",
        "set Test = triaxial drained",
        "set Test = triaxial undrained",
        "set Test = path\nset Increments = 1e-3 0 0 0 0 0 0 3 1e-3"})
    {
      INFO(impossible);
      const auto errors = problems_of(impossible);
      REQUIRE(errors.size() == 1);
      CHECK(errors[0].message.find("\"linear elastic\" knows plane strain") !=
            std::string::npos);
    }
  CHECK(problems_of("set Test = isotropic")[0].path == "Element test/Test");
  const auto rotation =
    problems_of("set Test = simple shear\nset Micro-rotation = 3");
  REQUIRE(rotation.size() == 1);
  CHECK(rotation[0].path == "Element test/Micro-rotation");

  const Parameters         isotropic = parse("set Test = isotropic");
  ElementTest::ElementTest test(isotropic, law);
  CHECK_THROWS_AS(test.run(), InputError);
}



TEST_CASE("entries of the new tests are checked", "[unit][element_test]")
{
  const Parameters shear = parse("set Test = simple shear\n"
                                 "set Shear strain = 0.2\n"
                                 "set Simple shear keeps = volume\n"
                                 "set Micro-rotation = -90");
  CHECK(shear.shear_strain == .2);
  CHECK(shear.shear_keeps_volume);
  CHECK(shear.is_undrained());
  CHECK_FALSE(shear.turns_with_spin);
  CHECK(shear.micro_rotation == Approx(-2. * std::atan(1.)).epsilon(1e-15));

  const std::vector<std::pair<std::string, std::string>> wrong = {
    {"set Test = simple shear\nset Shear strain = 0", "Shear strain"},
    {"set Test = simple shear\nset Micro-rotation = spin", "Micro-rotation"},
    {"set Test = biaxial\nset Micro-rotation = 3", "Micro-rotation"},
    {"set Test = triaxial drained\nset K0 = 0.5", "K0"},
    {"set Test = triaxial undrained\nset K0 = 0.5", "K0"}};
  for (const auto &[settings, entry] : wrong)
    {
      INFO(settings);
      Problems problems;
      parse(settings).check(problems);
      REQUIRE(problems.errors.size() == 1);
      CHECK(problems.errors[0].path == "Element test/" + entry);
    }
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
        "step,strain 11,strain 22,strain 33,shear strain,volumetric strain,"
        "stress 11 [Pa],stress 22 [Pa],stress 33 [Pa],stress 12 [Pa],stress 21 "
        "[Pa],couple stress 1 [N/m],couple stress 2 [N/m],void ratio,substep,"
        "mean pressure [Pa],deviator [Pa],mobilised friction angle [deg],"
        "substeps,floored,clamped");
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
  CHECK_THROWS_AS(wrong.run(), InputError);

  // a column more where water would have pressure
  parameters.test  = Test::triaxial_undrained;
  parameters.steps = 2;
  test.run();
  std::ostringstream undrained;
  test.write_csv(undrained);
  CHECK(undrained.str().find(",deviator [Pa],excess pore pressure "
                             "[Pa],mobilised") != std::string::npos);
}



TEST_CASE("a path with strains of axis 3", "[unit][element_test]")
{
  const auto law = LawTools::make_law("polar hypoplastic");
  Parameters path =
    parse("set Test = path\n"
          "set Vertical pressure = 1e3\n"
          "set Increments = -1e-5 0 0 -1e-5 0 0 0 100 -1e-5; 0 0 0 0 0 0 0 1");
  REQUIRE(path.path_rows().size() == 2);
  CHECK(path.path_rows()[0].axis_3_strain == -1e-5);
  CHECK(path.path_rows()[0].repeats == 100);
  CHECK(path.path_rows()[1].axis_3_strain == 0.);
  ElementTest::ElementTest test(path, *law);
  const Row                compressed = test.run().back();
  CHECK(compressed.strain_33 == Approx(-1e-3).epsilon(1e-12));
  // isotropic but for the difference of exp(e) - 1 and e
  CHECK(compressed.state[2] == Approx(compressed.state[0]).epsilon(1e-4));
  CHECK(compressed.state[0] == Approx(compressed.state[1]).epsilon(1e-12));
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
