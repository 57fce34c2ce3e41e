// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/config.h>
#include <deal.II/base/index_set.h>

/**
 * The one place for differences between versions of deal.II.
 */
namespace Riedel::Compat
{
  /// reinit() of an AffineConstraints object for locally relevant dofs.
  template <typename Constraints>
  void
  reinit_constraints(Constraints                             &constraints,
                     [[maybe_unused]] const dealii::IndexSet &owned,
                     const dealii::IndexSet                  &relevant)
  {
#if DEAL_II_VERSION_GTE(9, 6, 0)
    constraints.reinit(owned, relevant);
#else
    constraints.reinit(relevant);
#endif
  }

  /// The communicator of a triangulation or dof handler.
  template <typename Object>
  auto
  communicator(const Object &object)
  {
#if DEAL_II_VERSION_GTE(9, 7, 0)
    return object.get_mpi_communicator();
#else
    return object.get_communicator();
#endif
  }
} // namespace Riedel::Compat
