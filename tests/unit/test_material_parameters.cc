// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/material/parameters.h>

#include "law_tools.h"

using namespace Riedel;

namespace
{
  using Names = std::vector<std::pair<std::string, std::string>>;

  Material::Parameters<2>
  parse(const Names &names, const std::string &text)
  {
    dealii::ParameterHandler prm;
    Material::Parameters<2>::declare(prm, names);
    prm.parse_input_from_string("subsection Materials\n" + text + "\nend\n");
    Material::Parameters<2> parameters;
    parameters.parse(prm, names);
    return parameters;
  }

  std::string
  elastic(const std::string &name,
          const std::string &law,
          const std::string &more = "")
  {
    return "subsection " + name + "\nset Law = " + law +
           "\nset Lame modulus = 1\nset Shear modulus = 1\n" + more + "\nend\n";
  }

  const std::string micropolar_moduli =
    "set Couple modulus = 1\nset Bending modulus = 1\n";
} // namespace



TEST_CASE("materials by name and place", "[unit][material]")
{
  const auto parameters =
    parse({{"soil", "linear elastic"}, {"block", "linear elastic"}},
          elastic("soil", "linear elastic") +
            elastic("block", "linear elastic", "set Box = 0.5, 0 : 1, 0.25"));
  REQUIRE(parameters.materials.size() == 2);
  CHECK(parameters.materials[0].name == "soil");
  CHECK(parameters.materials[0].everywhere);
  CHECK_FALSE(parameters.materials[1].everywhere);
  CHECK_FALSE(parameters.is_micropolar());
  CHECK(parameters.material_at({.2, .1}) == 0);
  CHECK(parameters.material_at({.7, .1}) == 1);
  CHECK(parameters.material_at({.7, .3}) == 0);
  Problems problems;
  parameters.check(problems);
  CHECK(problems.errors.empty());

  const auto only =
    parse({{"block", "linear elastic"}},
          elastic("block", "linear elastic", "set Box = 0.5, 0 : 1, 0.25"));
  CHECK(only.material_at({.2, .1}) == -1);
}



TEST_CASE("what is wrong with materials is said", "[unit][material]")
{
  Problems nothing;
  Material::Parameters<2>().check(nothing);
  REQUIRE(nothing.errors.size() == 1);

  Problems mixed;
  parse({{"soil", "linear elastic"}, {"sand", "linear elastic micropolar"}},
        elastic("soil", "linear elastic") +
          elastic("sand", "linear elastic micropolar", micropolar_moduli))
    .check(mixed);
  REQUIRE(mixed.errors.size() == 1);
  CHECK(mixed.errors[0].path == "Materials/sand/Law");
  CHECK(mixed.errors[0].message.find("\"soil\"") != std::string::npos);
  CHECK(mixed.errors[0].message.find("\"sand\"") != std::string::npos);

  for (const std::string text :
       {"1, 2", "0, 0 : 1", "a, b : c, d", "0, 1 : 1, 0.5"})
    try
      {
        parse({{"soil", "linear elastic"}},
              elastic("soil", "linear elastic", "set Box = " + text));
        FAIL("a box was accepted: " + text);
      }
    catch (const ParameterError &error)
      {
        CHECK(error.path == "Materials/soil/Box");
      }

  // a law of a material is checked under its path
  Problems law;
  parse({{"sand", "linear elastic micropolar"}},
        elastic("sand", "linear elastic micropolar"))
    .check(law);
  REQUIRE(law.errors.size() == 1);
  CHECK(law.errors[0].path == "Materials/sand/Bending modulus");
}



TEST_CASE("an unknown law declares only what every material has",
          "[unit][material]")
{
  dealii::ParameterHandler prm;
  Material::Parameters<2>::declare(prm,
                                   {{"sand", "plar hypoplastic"}, {"b", ""}});
  prm.enter_subsection("Materials");
  prm.enter_subsection("sand");
  CHECK(prm.get("Box").empty());
  CHECK_THROWS(prm.set("Granular hardness", "1"));
  // the pattern names the known laws
  CHECK_THROWS(prm.set("Law", "plar hypoplastic"));
  for (const std::string &law : Material::known_laws<2>())
    CHECK_NOTHROW(prm.set("Law", law));
  prm.leave_subsection();
  prm.leave_subsection();

  Material::Parameters<2> parameters;
  try
    {
      parameters.parse(prm, {{"sand", "plar hypoplastic"}});
      FAIL("an unknown law was accepted");
    }
  catch (const InputError &error)
    {
      const std::string text = error.what();
      CHECK(text.find("Materials/sand/Law") != std::string::npos);
      CHECK(text.find("\"plar hypoplastic\"") != std::string::npos);
      CHECK(text.find("polar hypoplastic") != std::string::npos);
    }
}



TEST_CASE("Karlsruhe sand is the published one", "[unit][material]")
{
  std::ifstream file(std::string(RIEDEL_TEST_DIR) +
                     "/../prm/sand/karlsruhe.prm");
  REQUIRE(file.good());
  std::stringstream text;
  text << file.rdbuf();
  const auto parameters =
    parse({{"sand", "polar hypoplastic"}},
          "subsection sand\nset Law = polar hypoplastic\n" + text.str() +
            "\nend");
  Problems problems;
  parameters.check(problems);
  CHECK(problems.errors.empty());
  CHECK(problems.warnings.empty());
  CHECK(parameters.is_micropolar());
  const auto &law = *parameters.materials[0].law;
  CHECK(law.length() == .5e-3);

  // the same answer as with the constants of these tests
  const auto                expected = LawTools::make_law("polar hypoplastic");
  const auto                state    = LawTools::make_state(law,
                                          {-1e5, -1.5e5, -1.2e5, 2e4, 1e4},
                                          {20., -10.},
                                          .65);
  const std::vector<double> d{-1e-3, 1e-4, 2e-4, 5e-4, 1e-4, 1., 0.};
  CHECK(LawTools::respond(law, state, d).stresses ==
        LawTools::respond(*expected, state, d).stresses);
}
