// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/checkpoint/changes.h>

#include <catch2/catch.hpp>

using Riedel::Checkpoint::forbidden_changes;
using Riedel::Checkpoint::may_change;

namespace
{
  std::vector<std::string>
  changes(const std::string &path,
          const std::string &saved,
          const std::string &present)
  {
    return forbidden_changes({{path, saved}}, {{path, present, "default"}});
  }
} // namespace

TEST_CASE("a resumed run may change what the state does not depend on",
          "[unit]")
{
  for (const std::string path : {"Title",
                                 "Results",
                                 "Loading/Stop",
                                 "Loading/Largest step",
                                 "Solver/Scheme",
                                 "Output/Watch",
                                 "Checkpoint/Keep"})
    {
      CHECK(may_change(path));
      CHECK(changes(path, "1", "2").empty());
    }
  for (const std::string path : {"Dimension",
                                 "Titles",
                                 "Grid/Cells",
                                 "Loading/Gravity",
                                 "Materials/sand/Law",
                                 "Materials/Solver/Law"})
    {
      CHECK_FALSE(may_change(path));
      CHECK(changes(path, "1", "2") ==
            std::vector<std::string>{path +
                                     ": \"1\" in the checkpoint, \"2\" now"});
    }
}

TEST_CASE("values are compared, not texts", "[unit]")
{
  CHECK(changes("Grid/Cells", "20, 10", "20,10").empty());
  CHECK(changes("Grid/Cells", "20, 10", " 20 ,  10.0").empty());
  CHECK(changes("Initial state/K0", "100e3", "1e5").empty());
  CHECK_FALSE(changes("Grid/Cells", "20, 10", "20, 10, 1").empty());
  CHECK_FALSE(changes("Grid/Cells", "20, 10", "2010").empty());
  CHECK_FALSE(changes("Boundary conditions/a/Pressure", "2*s", "3*s").empty());
}

TEST_CASE("parameters that only one of the versions knows", "[unit]")
{
  // a new one with its default changes nothing
  CHECK(forbidden_changes({}, {{"Grid/New", "1", "1"}}).empty());
  CHECK(
    forbidden_changes({}, {{"Grid/New", "2", "1"}}) ==
    std::vector<std::string>{"Grid/New: \"1\" in the checkpoint, \"2\" now"});
  CHECK(forbidden_changes({{"Materials/clay/Box", ""}}, {}) ==
        std::vector<std::string>{
          "Materials/clay/Box: nothing in the checkpoint, not there now"});
}
