// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/errors.h>
#include <riedel/scene/input_file.h>

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>

using Riedel::InputError;
using Riedel::Scene::InputFile;

namespace
{
  /// A folder of files that is gone at the end.
  class Folder
  {
  public:
    Folder()
      : path(std::filesystem::temp_directory_path() / "riedel_input_file")
    {
      std::filesystem::remove_all(path);
      std::filesystem::create_directories(path / "parts");
    }

    ~Folder()
    {
      std::filesystem::remove_all(path);
    }

    std::string
    write(const std::string &name, const std::string &text) const
    {
      std::ofstream(path / name) << text;
      return (path / name).string();
    }

    const std::filesystem::path path;
  };

  std::string
  message(const std::string &file, const std::vector<std::string> &set = {})
  {
    try
      {
        InputFile input(file, set);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "no error";
  }
} // namespace

TEST_CASE("the grammar of input files", "[unit]")
{
  const Folder    folder;
  const InputFile input(folder.write("case.prm",
                                     "# a comment\n"
                                     "set  Void   ratio =  0.6   # pores\n"
                                     "\n"
                                     "subsection Initial  state\r\n"
                                     "\tset K0=1\n"
                                     "  subsection Zones\n"
                                     "    set Long = 1, \\ # goes on\n"
                                     "               2\n"
                                     "    set Sum = a = b\n"
                                     "    set Empty =\n"
                                     "  end # of Zones\n"
                                     "end\n"
                                     "set Last = 1"),
                        {});
  const auto     &entries = input.entries();
  REQUIRE(entries.size() == 6);
  CHECK(entries[0].path == "Void ratio");
  CHECK(entries[0].value == "0.6");
  CHECK(entries[0].place.line == 2);
  CHECK(entries[1].path == "Initial state/K0");
  CHECK(entries[1].value == "1");
  CHECK(entries[2].path == "Initial state/Zones/Long");
  CHECK(entries[2].value == "1, 2");
  CHECK(entries[2].place.line == 7);
  CHECK(entries[3].value == "a = b");
  CHECK(entries[3].place.line == 9);
  CHECK(entries[4].value.empty());
  CHECK(entries[5].path == "Last");
  CHECK(entries[5].place.line == 13);

  CHECK(input.names_in("Initial state") == std::vector<std::string>{"Zones"});
  CHECK(input.value("Initial state/K0") == "1");
  CHECK(input.place("Initial state/K0").line == 5);
  CHECK(input.place("Initial state/Zones/Other").line == 6);
  CHECK(input.place("Grid/Cells").text() == input.name());
}

TEST_CASE("included files are relative to the file that includes", "[unit]")
{
  const Folder folder;
  folder.write("parts/sand.prm", "set Grain = 1\ninclude deep.prm\n");
  folder.write("parts/deep.prm", "set Depth = 2\nset Grain = 3\n");
  const InputFile input(folder.write("case.prm",
                                     "subsection Materials\n"
                                     "  subsection sand\n"
                                     "    include parts/sand.prm # constants\n"
                                     "    set Law = one\n"
                                     "  end\n"
                                     "end\n"
                                     "include \"parts/../parts/deep.prm\"\n"),
                        {});
  REQUIRE(input.entries().size() == 6);
  CHECK(input.entries()[1].path == "Materials/sand/Depth");
  // the last value counts
  CHECK(input.value("Materials/sand/Grain") == "3");
  CHECK(input.place("Materials/sand/Grain").text() ==
        (folder.path / "parts/deep.prm").string() + ":2");
  CHECK(input.value("Depth") == "2");
  // an include that overrides is a normal use
  CHECK(input.repeated().empty());

  // the original text can be read without the included files
  const InputFile again(folder.write("again.prm", input.original_text()), {});
  REQUIRE(again.entries().size() == 6);
  for (unsigned int i = 0; i < 6; ++i)
    {
      CHECK(again.entries()[i].path == input.entries()[i].path);
      CHECK(again.entries()[i].value == input.entries()[i].value);
    }
  CHECK_THAT(input.original_text(),
             Catch::Contains("    # included from parts/sand.prm\n"));
}

TEST_CASE("--set overrides the file", "[unit]")
{
  const Folder      folder;
  const std::string file =
    folder.write("case.prm", "subsection A\n  set B = 1\nend\n");
  const InputFile input(file, {"A/B = 2", "Top=x=y", "A/C/D=0"});
  CHECK(input.value("A/B") == "2");
  CHECK(input.place("A/B").text() == "--set");
  CHECK(input.value("Top") == "x=y");
  CHECK(input.names_in("A") == std::vector<std::string>{"C"});
  CHECK(input.place("A/C/Other").text() == "--set");
  CHECK(input.repeated().empty());

  const InputFile again(folder.write("again.prm", input.original_text()), {});
  CHECK(again.value("A/B") == "2");
  CHECK(again.value("A/C/D") == "0");

  CHECK_THAT(message(file, {"A/B"}), Catch::Contains("there is no \"=\""));
  CHECK_THAT(message(file, {"A//B=1"}), Catch::Contains("a name is missing"));
  CHECK_THAT(message(file, {"=1"}), Catch::Contains("name of the parameter"));
  CHECK_THAT(message(file, {"A/B=1 # x"}), Catch::Contains("has no \"#\""));
}

TEST_CASE("a value that is set twice in a file is worth a warning", "[unit]")
{
  const Folder    folder;
  const InputFile input(folder.write("case.prm", "set A = 1\n\nset A = 2\n"),
                        {});
  REQUIRE(input.repeated().size() == 1);
  CHECK_THAT(input.repeated()[0],
             Catch::Contains("case.prm:3: A is set again; line 1"));
  CHECK(input.value("A") == "2");
}

TEST_CASE("violations of the grammar name their place", "[unit]")
{
  using Catch::Contains;
  const Folder folder;
  const auto   read = [&folder](const std::string &text) {
    return message(folder.write("case.prm", text));
  };

  CHECK_THAT(read("\nsett A = 1\n"),
             Contains("case.prm:2: cannot read \"sett A = 1\"") &&
               Contains("Did you mean \"set\"?"));
  CHECK_THAT(read("Cells = 40, 20\n"),
             Contains("case.prm:1") &&
               Contains("Did you mean \"set Cells = 40, 20\"?"));
  CHECK_THAT(read("subsecton A\nend\n"),
             Contains("case.prm:1") &&
               Contains("Did you mean \"subsection\"?"));
  CHECK_THAT(read("set A 1\n"),
             Contains("case.prm:1") && Contains("has no \"=\""));
  CHECK_THAT(read("set = 1\n"), Contains("name of the parameter is missing"));
  CHECK_THAT(read("subsection\nend\n"),
             Contains("name of the subsection is missing"));
  CHECK_THAT(read("subsection a/b\nend\n"), Contains("contains a \"/\""));
  CHECK_THAT(read("subsection A\nend\nend\n"),
             Contains("case.prm:3: this \"end\" has no \"subsection\""));
  CHECK_THAT(read("subsection A\nend of A\n"),
             Contains("case.prm:2: \"end\" stands alone"));
  CHECK_THAT(read("\nsubsection A\n  set B = 1\n"),
             Contains("case.prm:2: section A begins here and is never closed"));
  CHECK_THAT(read("set A = 1 \\"), Contains("case.prm:1: the file ends"));
  CHECK_THAT(read("include\n"), Contains("name of the file to include"));
  // the indentation tells which end is missing
  CHECK_THAT(read("subsection A\n  subsection B\n    set C = 1\nend\n"),
             Contains("case.prm:1: section A") && Contains("missing before") &&
               Contains("case.prm:4, for section "
                        "A/B of line 2"));
}

TEST_CASE("files that cannot be read are named", "[unit]")
{
  using Catch::Contains;
  const Folder folder;
  folder.write("parts/sand.prm", "");
  CHECK_THAT(message((folder.path / "cse.prm").string()),
             Contains("Cannot open the file") && Contains("does not exist"));
  folder.write("case.prm", "\ninclude parts/snad.prm\n");
  CHECK_THAT(message((folder.path / "cse.prm").string()),
             Contains("Did you mean \"case.prm\"?"));
  CHECK_THAT(message(folder.path.string()), Contains("it is a folder"));
  CHECK_THAT(message((folder.path / "case.prm").string()),
             Contains("case.prm:2: cannot open the included file") &&
               Contains("Did you mean \"sand.prm\"?"));
  CHECK_THAT(message(folder.write("case.prm", "include part/sand.prm\n")),
             Contains("There is no folder"));

  folder.write("parts/a.prm", "include ../case.prm\n");
  CHECK_THAT(message(folder.write("case.prm", "\ninclude parts/a.prm\n")),
             Contains("a.prm:1: files include each other in a circle: case.prm "
                      "includes a.prm includes case.prm"));
  CHECK_THAT(message(folder.write("self.prm", "include self.prm\n")),
             Contains("self.prm:1") && Contains("circle"));
  // an `end` closes sections of its own file only
  folder.write("parts/end.prm", "set A = 1\nend\n");
  CHECK_THAT(message(folder.write(
               "case.prm", "subsection B\ninclude parts/end.prm\nend\n")),
             Contains("end.prm:2: this \"end\" has no \"subsection\""));
}
