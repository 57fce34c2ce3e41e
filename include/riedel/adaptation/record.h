// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/points/material_points.h>

#include <mpi.h>

#include <cstdint>
#include <vector>

namespace Riedel::Adaptation
{
  /// The grid of a step, and what changing it before this step has done; zero
  /// if it did not change then.
  struct Record
  {
    std::uint64_t cells = 0, unknowns = 0;
    unsigned int  n_changes = 0; ///< steps with a new grid since the start
    /// forces or moments out of balance on the new grid, relative to reactions
    double imbalance = 0.0;
    /// change of the watched boundary's force at the same load [N/m in 2D]
    double force_jump = 0.0;
    /// norm of the change of sum(sigma V) over the norm of this sum
    double stress_change = 0.0;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &cells &unknowns &n_changes &imbalance &force_jump &stress_change;
    }
  };

  /// The sum of stress times volume over the points of all ranks, by component
  /// [J/m in 2D].
  template <int dim>
  std::vector<double>
  summed_stress(const Points::MaterialPoints<dim> &points,
                const MPI_Comm                     communicator);

  /// Norm of the difference of two such sums over that of the first one.
  double
  relative_change(const std::vector<double> &before,
                  const std::vector<double> &after);
} // namespace Riedel::Adaptation
