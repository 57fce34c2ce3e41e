// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/output/point_fields.h>

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Riedel::Output
{
  namespace
  {
    /// The smallest and the largest principal stress of the symmetric part.
    /// @p stress: 11, 22, 33, 12, 21, in space also 13, 31, 23, 32.
    std::pair<double, double>
    extreme_stresses(const double *stress, const bool is_in_plane)
    {
      if (is_in_plane)
        {
          const double mean   = 0.5 * (stress[0] + stress[1]);
          const double radius = std::hypot(0.5 * (stress[0] - stress[1]),
                                           0.5 * (stress[3] + stress[4]));
          return std::minmax({mean - radius, mean + radius, stress[2]});
        }
      dealii::SymmetricTensor<2, 3> S;
      for (unsigned int d = 0; d < 3; ++d)
        S[d][d] = stress[d];
      S[0][1]           = 0.5 * (stress[3] + stress[4]);
      S[0][2]           = 0.5 * (stress[5] + stress[6]);
      S[1][2]           = 0.5 * (stress[7] + stress[8]);
      const auto values = dealii::eigenvalues(S); // in descending order
      return {values[2], values[0]};
    }

    /// Degrees; 0 where no principal stress is compressive.
    double
    mobilised_friction(const double *stress, const bool is_in_plane)
    {
      const auto [smallest, largest] = extreme_stresses(stress, is_in_plane);
      const double sum               = smallest + largest;
      if (!(sum < 0.0))
        return 0.0;
      return std::asin(std::min((smallest - largest) / sum, 1.0)) * 180.0 /
             M_PI;
    }
  } // namespace



  PointFields::PointFields(const Material::StateLayout &layout)
    : stress(layout.find("stress"))
  {
    for (const auto &slot : layout.slots())
      {
        list.push_back({slot.name, slot.unit, slot.components});
        for (unsigned int c = 0; c < slot.size(); ++c)
          places.push_back(slot.first + c);
      }
    total = places.size();
    if (stress != Material::StateLayout::absent)
      {
        list.push_back({"mean_stress", "Pa", {""}});
        list.push_back({"mobilised_friction", "deg", {""}});
        total += 2;
        for (const auto &slot : layout.slots())
          if (slot.name == "stress")
            is_in_plane = slot.size() == 5;
      }
  }



  std::string
  PointFields::Field::file_name(const unsigned int component) const
  {
    // deal.II allows letters, digits, '_', '<', '>', '(' and ')' in names
    std::string       allowed_unit = unit;
    const std::size_t slash        = unit.find('/');
    if (slash != std::string::npos)
      allowed_unit.replace(slash, 1, "_per_");
    return name + (components[component].empty() ? "" : "_") +
           components[component] + "(" + allowed_unit + ")";
  }



  void
  PointFields::evaluate(const double *row, double *values) const
  {
    for (const unsigned int place : places)
      *values++ = row[place];
    if (stress != Material::StateLayout::absent)
      {
        const double *s = row + stress;
        *values++       = (s[0] + s[1] + s[2]) / 3.0;
        *values++       = mobilised_friction(s, is_in_plane);
      }
  }
} // namespace Riedel::Output
