// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/errors.h>

#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Riedel::Equilibrium
{
  /// Entry "Control" of the section "Loading" and its subsection "Opening": the
  /// load factor is found from a measured opening (doc/theory/solution.md).
  template <int dim>
  struct OpeningParameters
  {
    bool         controls  = false;
    unsigned int component = 0; ///< of the displacement
    /// the opening is the displacement of the second place minus that of the
    /// first; undeformed [m]
    std::vector<double> from, to;
    double              final_opening = 0.0; ///< at s = 1 [m]

    static void
    declare(dealii::ParameterHandler &prm);
    void
    parse(dealii::ParameterHandler &prm);
    void
    check(Problems &problems) const;
  };
} // namespace Riedel::Equilibrium
