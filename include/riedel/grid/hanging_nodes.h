// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/types.h>
#include <deal.II/lac/affine_constraints.h>

namespace Riedel::Grid
{
  /// Calls function(master, factor) for every dof that @p dof hangs on; for one
  /// that does not hang with itself and 1.
  template <typename Function>
  void
  for_masters(const dealii::AffineConstraints<double> &hanging_nodes,
              const dealii::types::global_dof_index    dof,
              const Function                          &function)
  {
    const auto *masters = hanging_nodes.get_constraint_entries(dof);
    if (masters == nullptr)
      function(dof, 1.0);
    else
      for (const auto &[master, factor] : *masters)
        function(master, factor);
  }
} // namespace Riedel::Grid
