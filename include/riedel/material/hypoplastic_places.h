// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace Riedel::Material
{
  /// Places in a point's state; the law declares its slots in this order.
  template <bool micropolar>
  struct HypoplasticPlaces
  {
    static constexpr unsigned int stress        = 0;
    static constexpr unsigned int couple_stress = 5;
    static constexpr unsigned int void_ratio    = micropolar ? 7 : 5;
    static constexpr unsigned int substep       = void_ratio + 1;
    static constexpr unsigned int n             = substep + 1;
  };
} // namespace Riedel::Material
