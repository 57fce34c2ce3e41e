// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/material/state_layout.h>

#include <string>
#include <vector>

namespace Riedel::Output
{
  /**
   * What a point's row says, as named fields for files: all slots, and what
   * follows from the stress: mean stress [Pa] and mobilised friction angle
   * [deg], sin phi = (s_1 - s_3)/(s_1 + s_3) of the extreme principal stresses
   * of its symmetric part.
   */
  class PointFields
  {
  public:
    explicit PointFields(const Material::StateLayout &layout);

    struct Field
    {
      std::string              name; ///< "stress"
      std::string              unit; ///< "Pa"
      std::vector<std::string> components;

      /// "stress_11(Pa)": what file formats allow as a name
      std::string
      file_name(const unsigned int component) const;
    };

    const std::vector<Field> &
    fields() const
    {
      return list;
    }

    /// Total number of components.
    unsigned int
    n_values() const
    {
      return total;
    }

    /// All components of all fields of a row.
    void
    evaluate(const double *row, double *values) const;

  private:
    std::vector<Field>        list;
    std::vector<unsigned int> places; ///< of the slots' components
    unsigned int              stress; ///< place of stress 11, or absent
    bool                      is_in_plane = true;
    unsigned int              total       = 0;
  };
} // namespace Riedel::Output
