// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace Riedel::Material
{
  /**
   * The named, unit-carrying slots of a material point's state. One place
   * knows the order of components: whoever needs a slot asks for it by name.
   */
  class StateLayout
  {
  public:
    static constexpr unsigned int absent = static_cast<unsigned int>(-1);

    struct Slot
    {
      std::string              name;       ///< e.g. "stress"
      std::string              unit;       ///< e.g. "Pa"; "1" if none
      std::vector<std::string> components; ///< e.g. {"11", "22"}; {""} scalar
      unsigned int             first;      ///< place of the first component
      /// one-line meaning, for files and documentation
      std::string description;

      unsigned int
      size() const
      {
        return static_cast<unsigned int>(components.size());
      }
    };

    /// Adds a slot behind the present ones; a slot of this name must not exist
    /// with other components. Returns the place of its first component.
    unsigned int
    add(const std::string              &name,
        const std::string              &unit,
        const std::string              &description,
        const std::vector<std::string> &components = {""});

    /// Adds the slots of @p other that are not here yet.
    void
    merge(const StateLayout &other);

    /// Place of the first component of a slot, or #absent.
    unsigned int
    find(const std::string &name) const;

    /// Place of one component of a slot, or #absent.
    unsigned int
    find(const std::string &name, const std::string &component) const;

    /// All slots in order.
    const std::vector<Slot> &
    slots() const
    {
      return list;
    }

    /// Number of doubles of a point's state.
    unsigned int
    size() const
    {
      return n_values;
    }

  private:
    std::vector<Slot> list;
    unsigned int      n_values = 0;
  };
} // namespace Riedel::Material
