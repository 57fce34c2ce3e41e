// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/material/state_layout.h>

#include <stdexcept>

namespace Riedel::Material
{
  unsigned int
  StateLayout::add(const std::string              &name,
                   const std::string              &unit,
                   const std::string              &description,
                   const std::vector<std::string> &components)
  {
    for (const Slot &slot : list)
      if (slot.name == name)
        {
          if (slot.components != components || slot.unit != unit)
            throw std::logic_error("state slot '" + name +
                                   "' is declared twice and differently");
          return slot.first;
        }
    list.push_back({name, unit, components, n_values, description});
    n_values += list.back().size();
    return list.back().first;
  }



  void
  StateLayout::merge(const StateLayout &other)
  {
    for (const Slot &slot : other.list)
      add(slot.name, slot.unit, slot.description, slot.components);
  }



  unsigned int
  StateLayout::find(const std::string &name) const
  {
    for (const Slot &slot : list)
      if (slot.name == name)
        return slot.first;
    return absent;
  }



  unsigned int
  StateLayout::find(const std::string &name, const std::string &component) const
  {
    for (const Slot &slot : list)
      if (slot.name == name)
        for (unsigned int c = 0; c < slot.size(); ++c)
          if (slot.components[c] == component)
            return slot.first + c;
    return absent;
  }
} // namespace Riedel::Material
