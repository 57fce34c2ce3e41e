// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/material/law.h>
#include <riedel/material/state_layout.h>

#include <catch2/catch.hpp>

#include <stdexcept>

using Riedel::Material::StateLayout;

TEST_CASE("a state layout knows the order of its slots", "[unit][layout]")
{
  StateLayout layout;
  CHECK(layout.size() == 0);
  CHECK(layout.add("stress", "Pa", "", {"11", "22"}) == 0);
  CHECK(layout.add("void_ratio", "1", "") == 2);
  CHECK(layout.size() == 3);
  CHECK(layout.find("void_ratio") == 2);
  CHECK(layout.find("stress", "22") == 1);
  CHECK(layout.find("stress", "33") == StateLayout::absent);
  CHECK(layout.find("strain") == StateLayout::absent);

  // the same again is the same slot; a different one is a programmer's error
  CHECK(layout.add("stress", "Pa", "", {"11", "22"}) == 0);
  CHECK(layout.size() == 3);
  CHECK_THROWS_AS(layout.add("stress", "kPa", "", {"11", "22"}),
                  std::logic_error);
  CHECK_THROWS_AS(layout.add("stress", "Pa", "", {"11"}), std::logic_error);
}



TEST_CASE("layouts merge without repeating slots", "[unit][layout]")
{
  StateLayout a, b;
  a.add("stress", "Pa", "", {"11", "22"});
  b.add("void_ratio", "1", "");
  b.add("stress", "Pa", "", {"11", "22"});
  a.merge(b);
  CHECK(a.size() == 3);
  CHECK(a.find("void_ratio") == 2);
  CHECK(a.slots().size() == 2);
}



TEST_CASE("laws declare the slots that others read", "[unit][layout]")
{
  for (const std::string &name : Riedel::Material::known_laws<2>())
    {
      INFO(name);
      const auto law = Riedel::Material::create_law<2>(name);
      CHECK(law->name() == name);
      CHECK(law->n_generalised() == (law->is_micropolar() ? 7 : 4));
      for (const std::string component : {"11", "22", "33", "12", "21"})
        CHECK(law->layout().find("stress", component) != StateLayout::absent);
      CHECK((law->layout().find("couple_stress", "2") != StateLayout::absent) ==
            law->is_micropolar());
      CHECK((law->layout().find("void_ratio") != StateLayout::absent) ==
            (name.find("hypoplastic") != std::string::npos));
    }
  CHECK_THROWS_AS(Riedel::Material::create_law<2>("rubber"), std::out_of_range);
}
