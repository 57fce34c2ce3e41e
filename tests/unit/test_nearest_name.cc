// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/nearest_name.h>

#include <catch2/catch.hpp>

using namespace Riedel;

TEST_CASE("edit distance counts letters and neighbours that swap", "[unit]")
{
  CHECK(edit_distance("", "") == 0);
  CHECK(edit_distance("", "abc") == 3);
  CHECK(edit_distance("Cells", "cells") == 0);
  CHECK(edit_distance("Cells", "Cels") == 1);
  CHECK(edit_distance("Cells", "Celsl") == 1);
  CHECK(edit_distance("Cells", "Sells") == 1);
  CHECK(edit_distance("kitten", "sitting") == 3);
  CHECK(edit_distance("kitten", "sitting") ==
        edit_distance("sitting", "kitten"));
}

TEST_CASE("nearest names come nearest first and far ones not at all", "[unit]")
{
  const std::vector<std::string> names = {"left", "right", "bottom", "top"};
  CHECK(nearest_names("lft", names) == std::vector<std::string>{"left"});
  CHECK(nearest_names("Right", names) == std::vector<std::string>{"right"});
  CHECK(nearest_names("ceiling", names).empty());
  // one wrong letter of one letter says nothing
  CHECK(nearest_names("3", {"2"}).empty());
  // a word too many
  CHECK(nearest_names("Void ratio of the sand", {"K0", "Void ratio"}) ==
        std::vector<std::string>{"Void ratio"});
  CHECK(nearest_names("Displacement 3",
                      {"Rotation", "Displacement 1", "Displacement 2"}) ==
        std::vector<std::string>{"Displacement 1", "Displacement 2"});
}

TEST_CASE("did you mean reads like a sentence", "[unit]")
{
  CHECK(did_you_mean("lft", {"left", "top"}) == " Did you mean \"left\"?");
  CHECK(did_you_mean("Step 3", {"Step 1", "Step 2"}) ==
        " Did you mean \"Step 1\" or \"Step 2\"?");
  CHECK(did_you_mean("ceiling", {"left", "top"}).empty());
  CHECK(enumerate({"left", "top"}) == "left, top");
}
