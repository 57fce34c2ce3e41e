// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/errors.h>
#include <riedel/scene/scene.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>

using Catch::Contains;
using Riedel::InputError;
namespace Scene = Riedel::Scene;

namespace
{
  /// A right case, line by line: the places in the messages refer to it.
  const std::vector<std::string> right_case = {
    /*  1 */ "set Results = biaxial",
    /*  2 */ "subsection Geometry",
    /*  3 */ "  set Box = 0.10, 0.05",
    /*  4 */ "end",
    /*  5 */ "subsection Grid",
    /*  6 */ "  set Cells = 40, 20",
    /*  7 */ "end",
    /*  8 */ "subsection Materials",
    /*  9 */ "  subsection stone",
    /* 10 */ "    set Law = linear elastic",
    /* 11 */ "    set Lame modulus = 1e6",
    /* 12 */ "    set Shear modulus = 1e6",
    /* 13 */ "  end",
    /* 14 */ "end",
    /* 15 */ "subsection Initial state",
    /* 16 */ "  set Void ratio = 0.60",
    /* 17 */ "  set Vertical pressure at top = 100e3",
    /* 18 */ "  subsection Zones",
    /* 19 */ "    subsection weak spot",
    /* 20 */ "      set Box = 0, 0.025 : 0.0025, 0.0275",
    /* 21 */ "      set Void ratio = 0.90",
    /* 22 */ "    end",
    /* 23 */ "  end",
    /* 24 */ "end",
    /* 25 */ "subsection Boundary conditions",
    /* 26 */ "  subsection bottom",
    /* 27 */ "    set Displacement 2 = 0",
    /* 28 */ "  end",
    /* 29 */ "  subsection left",
    /* 30 */ "    set Displacement 1 = 0.005 * s",
    /* 31 */ "  end",
    /* 32 */ "  subsection top",
    /* 33 */ "    set Pressure = 100e3",
    /* 34 */ "    set Pressure acts on = initial area",
    /* 35 */ "  end",
    /* 36 */ "end",
    /* 37 */ "subsection Loading",
    /* 38 */ "  set Largest step = 0.004",
    /* 39 */ "end",
    /* 40 */ "subsection Output",
    /* 41 */ "  set Watch = left",
    /* 42 */ "end"};

  std::string
  file_name()
  {
    return (std::filesystem::temp_directory_path() / "riedel_case.prm")
      .string();
  }

  Scene::Scene<2>
  read(const std::vector<std::string> &lines,
       const std::vector<std::string> &overrides = {})
  {
    {
      std::ofstream file(file_name());
      for (const std::string &line : lines)
        file << line << '\n';
    }
    return Scene::read_scene<2>(file_name(), overrides);
  }

  /// The message if one line is replaced by another.
  std::string
  message(const unsigned int              line,
          const std::string              &text,
          const std::vector<std::string> &overrides = {})
  {
    std::vector<std::string> lines = right_case;
    if (line > 0)
      lines[line - 1] = text;
    try
      {
        read(lines, overrides);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "no error";
  }

  unsigned int
  count(const std::string &text, const std::string &part)
  {
    unsigned int n = 0;
    for (auto at = text.find(part); at != std::string::npos;
         at      = text.find(part, at + 1))
      ++n;
    return n;
  }
} // namespace

TEST_CASE("a right case is read", "[unit]")
{
  const Scene::Scene<2> scene = read(right_case, {"Loading/Stop=0.5"});
  CHECK(scene.warnings.empty());
  CHECK(scene.general.results == "biaxial");
  CHECK(scene.geometry.box == std::vector<double>{0.10, 0.05});
  CHECK(scene.geometry.origin == std::vector<double>{0.0, 0.0});
  CHECK(scene.geometry.names() ==
        std::vector<std::string>{"left", "right", "bottom", "top"});
  CHECK(scene.grid.cells == std::vector<unsigned int>{40, 20});
  CHECK(scene.grid.displacement_degree == 2);
  CHECK(scene.grid.rotation_degree == 2);
  CHECK(scene.grid.sampling == Riedel::Grid::StrainSampling::assumed);
  REQUIRE(scene.materials.materials.size() == 1);
  CHECK(scene.materials.materials[0].name == "stone");
  CHECK(scene.initial_state.void_ratio == 0.6);
  REQUIRE(scene.initial_state.zones.size() == 1);
  CHECK(scene.initial_state.zones[0].box.upper_bound(1) == 0.0275);
  CHECK(scene.initial_state.zones[0].void_ratio == 0.9);

  // in the order of the file
  const auto &boundaries = scene.boundary_conditions.boundaries;
  REQUIRE(boundaries.size() == 3);
  CHECK(boundaries[0].name == "bottom");
  CHECK(boundaries[1].name == "left");
  CHECK(boundaries[1].displacement[0](dealii::Point<2>(), 0.5) ==
        Approx(0.0025));
  CHECK_FALSE(boundaries[1].displacement[1].given());
  CHECK(boundaries[2].area == Riedel::Equilibrium::LoadArea::initial);
  CHECK(scene.loading.stop == 0.5);
  CHECK(scene.output.watch == "left");
}

TEST_CASE("automatic values", "[unit]")
{
  const auto linear = read(right_case, {"Grid/Displacement degree=1"});
  CHECK(linear.grid.rotation_degree == 1);
  CHECK(linear.grid.sampling == Riedel::Grid::StrainSampling::assumed);
  const auto mixed = read(right_case, {"Grid/Rotation degree=1"});
  CHECK(mixed.grid.displacement_degree == 2);
  CHECK(mixed.grid.sampling == Riedel::Grid::StrainSampling::full);
}

TEST_CASE("what is printed can be read again and means the same", "[unit]")
{
  const auto scene = read(right_case, {"Loading/Stop=0.5"});
  for (const auto format : {Scene::Format::prm, Scene::Format::short_prm})
    {
      const std::string text  = Scene::print(scene.parameters, format);
      const auto        again = read({text});
      CHECK(Scene::print(again.parameters, format) == text);
      CHECK(again.boundary_conditions.boundaries[0].name == "bottom");
    }
  const auto original = read({scene.original_text});
  CHECK(original.loading.stop == 0.5);

  const auto        all      = Scene::all_parameters();
  const std::string markdown = Scene::print(all, Scene::Format::markdown);
  for (const std::string &law : Riedel::Material::known_laws<2>())
    CHECK_THAT(markdown, Contains("### Materials/" + law + "\n"));
  CHECK_THAT(markdown,
             Contains("| `Pressure acts on` | `current area` | one of "
                      "initial area, current area |"));
  // every number says its unit or that it has none
  for (const auto &parameter : all)
    {
      INFO(parameter.path);
      CHECK_FALSE(parameter.documentation.empty());
    }
}

TEST_CASE("names with dots and underscores keep their shape", "[unit]")
{
  std::vector<std::string> lines = right_case;
  lines[8]                       = "  subsection layer_1.5 (upper)";
  const auto scene               = read(lines);
  CHECK(scene.materials.materials[0].name == "layer_1.5 (upper)");
  CHECK_THAT(Scene::print(scene.parameters, Scene::Format::short_prm),
             Contains("subsection layer_1.5 (upper)"));
}

TEST_CASE("unknown names are answered with the nearest", "[unit]")
{
  CHECK_THAT(message(6, "  set Celsl = 40, 20"),
             Contains("riedel_case.prm:6: Grid/Celsl") &&
               Contains("There is no parameter \"Celsl\" in section Grid. Did "
                        "you mean \"Cells\"?"));
  CHECK_THAT(message(6, "  set cells = 40, 20"),
             Contains(":6: Grid/cells") && Contains("Did you mean \"Cells\"?"));
  CHECK_THAT(message(5, "subsection Gird"),
             Contains(":5: Gird") && Contains("Did you mean \"Grid\"?"));
  CHECK_THAT(message(18, "  subsection Zone"),
             Contains(":18: Initial state/Zone") &&
               Contains("Did you mean \"Zones\"?"));
  CHECK_THAT(message(1, "set Result = x"),
             Contains(":1: Result\n") && Contains("Did you mean \"Results\"?"));
  CHECK_THAT(message(34, "    set Pressure act on = initial area"),
             Contains(":34: Boundary conditions/top/Pressure act on") &&
               Contains("Did you mean \"Pressure acts on\"?"));
  CHECK_THAT(message(41, "  set Watch = lefft"),
             Contains(":41: Output/Watch") &&
               Contains("Did you mean \"left\"?"));
  CHECK_THAT(message(29, "  subsection lft"),
             Contains(":29: Boundary conditions/lft") &&
               Contains("Did you mean \"left\"?") &&
               Contains("left, right, bottom, top"));
  CHECK_THAT(message(10, "    set Law = linear elastc"),
             Contains(":10: Materials/stone/Law") &&
               Contains("Did you mean \"linear elastic\"") &&
               // what depends on the law is not blamed
               !Contains("modulus"));
  CHECK_THAT(message(34, "    set Pressure acts on = inital area"),
             Contains(":34: ") &&
               Contains("The value \"inital area\" is not allowed. Did you "
                        "mean \"initial area\"?"));
  // in the wrong place
  CHECK_THAT(message(6, "  set K0 = 1"),
             Contains(":6: Grid/K0") &&
               Contains("\"K0\" belongs in section Initial state"));
  CHECK_THAT(message(38, "  subsection Geometry\n  end"),
             Contains(":38: Loading/Geometry") &&
               Contains("\"Geometry\" belongs outside all sections"));
  CHECK_THAT(message(3, "  subsection Box\n  end"),
             Contains(":3: Geometry/Box") && Contains("It is a parameter"));
  CHECK_THAT(message(1, "set Grid = 3"),
             Contains(":1: Grid") && Contains("It is a section"));
  CHECK_THAT(message(11, "    set Mean grain diameter = 1"),
             Contains(":11: ") && Contains("with the law \"linear elastic\""));
}

TEST_CASE("values that are not allowed", "[unit]")
{
  CHECK_THAT(message(6, "  set Cells = 40, x"),
             Contains(":6: Grid/Cells") &&
               Contains("The value \"40, x\" is not allowed") &&
               Contains("whole numbers >= 1") && Contains("along each axis"));
  CHECK_THAT(message(17, "  set Vertical pressure at top = 100 kPa"),
             Contains(":17: ") && Contains("Write the number without a unit") &&
               Contains("[Pa]"));
  CHECK_THAT(message(38, "  set Largest step = 0,004"),
             Contains(":38: ") && Contains("Write decimals with a point"));
  CHECK_THAT(message(38, "  set Largest step = -1"),
             Contains(":38: ") && Contains("Allowed: a number >= 0."));
  CHECK_THAT(message(38, "  set Largest step = 0"),
             Contains(":38: ") && Contains("larger than 0"));
  CHECK_THAT(message(1, "set Dimension = 4"),
             Contains(":1: Dimension") && Contains("Allowed: one of 2, 3"));
  CHECK_THAT(message(1, "set Results = runs/output/"),
             Contains(":1: Results") && Contains("\"output\""));
  CHECK_THAT(message(1, "set Results ="), Contains(":1: Results"));
  CHECK_THAT(message(30, "    set Displacement 1 = 0.005 * t"),
             Contains(":30: Boundary conditions/left/Displacement 1") &&
               Contains("\"0.005 * t\" cannot be read") &&
               Contains("the load parameter s"));
  CHECK_THAT(message(20, "      set Box = 0, 0.025"),
             Contains(":20: Initial state/Zones/weak spot/Box") &&
               Contains("x0, y0 : x1, y1"));
  CHECK_THAT(message(20, "      set Box = 0.1, 0 : 0, 0.1"),
             Contains(":20: ") && Contains("is empty"));
  CHECK_THAT(message(20, ""),
             Contains(":19: Initial state/Zones/weak spot/Box") &&
               Contains("The box is missing"));
}

TEST_CASE("values that are missing are missed", "[unit]")
{
  CHECK_THAT(message(11, ""),
             Contains(":9: Materials/stone/Lame modulus") &&
               Contains("The value is missing"));
  CHECK_THAT(message(10, ""),
             Contains(":9: Materials/stone/Law") && Contains("needs a law") &&
               Contains("linear elastic"));
  CHECK_THAT(message(3, ""), Contains(":2: Geometry/Box"));
  CHECK_THAT(message(6, ""), Contains(":5: Grid/Cells"));
  CHECK_THAT(message(16, ""), Contains(":15: Initial state/Void ratio"));
  CHECK_THAT(message(21, ""),
             Contains(":19: Initial state/Zones/weak spot/Void ratio"));
}

TEST_CASE("rules between parameters", "[unit]")
{
  CHECK_THAT(message(6, "  set Cells = 40"),
             Contains(":6: Grid/Cells") && Contains("needs 2 entries"));
  CHECK_THAT(message(3, "  set Box = 1, 2, 3"),
             Contains(":3: Geometry/Box") && Contains("needs 2 entries"));
  CHECK_THAT(message(20, "      set Box = 1, 1 : 2, 2"),
             Contains(":20: ") && Contains("outside the body"));
  CHECK_THAT(message(27, "    set Rotation = 0\n    set Displacement 2 = 0"),
             Contains(":27: Boundary conditions/bottom/Rotation") &&
               Contains("micro-rotations"));
  CHECK_THAT(message(38, "  set Body couple = 1"),
             Contains(":38: Loading/Body couple") &&
               Contains("micro-rotations"));
  CHECK_THAT(message(30, ""),
             Contains(":25: Boundary conditions") &&
               Contains("No boundary prescribes Displacement 1"));
  CHECK_THAT(message(34, "    set Displacement 2 = 0"),
             Contains(":33: Boundary conditions/top/Pressure") &&
               Contains("Remove one of the two"));
  CHECK_THAT(message(27, "    set Displacement 2 = 0\n    set Traction 2 = 0"),
             Contains(":28: Boundary conditions/bottom/Traction 2"));
  CHECK_THAT(message(38, "  set Initial step = 0.1"),
             Contains(":38: Loading/Initial step") &&
               Contains("larger than the largest"));
  CHECK_THAT(message(38, "  set Smallest step = 0.1"),
             Contains(":38: Loading/Smallest step"));
  CHECK_THAT(message(38, "  set Stop = 0"), Contains(":38: Loading/Stop"));
  CHECK_THAT(message(6,
                     "  set Cells = 4, 2\n  set Rotation degree = 1\n"
                     "  set Strain sampling = assumed"),
             Contains(":8: Grid/Strain sampling") && Contains("2 and 1"));
}

TEST_CASE("an element test needs a material and its own section only", "[unit]")
{
  const std::vector<std::string> lines = {"set Simulation type = element test",
                                          "subsection Materials",
                                          "  subsection stone",
                                          "    set Law = linear elastic",
                                          "    set Lame modulus = 1e6",
                                          "    set Shear modulus = 1e6",
                                          "  end",
                                          "end"};
  CHECK(read(lines).general.type == Scene::SimulationType::element_test);

  CHECK_THROWS_WITH(read(lines, {"Element test/Material=stnoe"}),
                    Contains("--set: Element test/Material") &&
                      Contains("\"stone\""));
  std::vector<std::string> two = lines;
  two.insert(two.end() - 1, lines.begin() + 2, lines.end() - 1);
  two[7] = "  subsection clay";
  CHECK_THROWS_WITH(read(two),
                    Contains(":2: Materials\n") && Contains("exactly one"));
}

TEST_CASE("--set is answered like the file", "[unit]")
{
  CHECK_THAT(message(0, "", {"Loading/Stp=1"}),
             Contains("--set: Loading/Stp") &&
               Contains("Did you mean \"Stop\"?"));
  CHECK_THAT(message(0, "", {"Loding/Stop=1"}),
             Contains("--set: Loding") && Contains("Did you mean \"Loading\""));
  CHECK_THAT(message(0, "", {"Materials/stnoe/Law=linear elastic"}),
             Contains("--set: Materials/stnoe") &&
               Contains("Did you mean \"stone\"?"));
  CHECK_THAT(message(0, "", {"Boundary conditions/rigth/Displacement 1=0"}),
             Contains("--set: Boundary conditions/rigth") &&
               Contains("Did you mean \"right\"?"));
  CHECK_THAT(message(0, "", {"Loading/Stop=x"}),
             Contains("--set: Loading/Stop") &&
               Contains("The value \"x\" is not allowed"));
  CHECK_THAT(message(0, "", {"Loading/Stop/Deep=x"}),
             Contains("--set: Loading/Stop") && Contains("It is a parameter"));
  CHECK(message(0, "", {"Boundary conditions/right/Displacement 1=0"}) ==
        "no error");
}

TEST_CASE("all mistakes come in one message", "[unit]")
{
  const std::string text =
    message(6, "  set Celsl = 40, 20", {"Loading/Stp=1", "Loading/Stop=x"});
  CHECK(count(text, "There is no parameter") == 2);
  CHECK_THAT(text, Contains("3 mistakes in the input."));

  const std::string many = message(6,
                                   "  set a1=1\n  set b2=1\n  set c3=1\n"
                                   "  set d4=1\n  set e5=1\n  set f6=1\n"
                                   "  set g7=1\n  set h8=1\n  set i9=1");
  CHECK(count(many, "There is no parameter") == 8);
  CHECK_THAT(many, Contains("9 mistakes in the input, the first 8 are shown."));
}

TEST_CASE("warnings have a place too", "[unit]")
{
  std::vector<std::string> lines = right_case;
  lines[37]        = "  set Largest step = 0.004\n  set Largest step = 0.002";
  const auto scene = read(lines, {"Solver/Residual=0.1"});
  REQUIRE(scene.warnings.size() == 2);
  CHECK_THAT(scene.warnings[0], Contains(":39: Loading/Largest step"));
  CHECK_THAT(scene.warnings[1], Contains("--set: Solver/Residual"));
  CHECK(scene.loading.largest_step == 0.002);
}
