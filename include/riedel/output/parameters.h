// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/errors.h>

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Riedel::Output
{
  /// Section "Output".
  struct Parameters
  {
    /// load parameter between two sets of field files; 0: only first and last
    double fields_every = 0.1;
    bool   write_grid   = true; ///< VTU + PVD of the grid
    bool   write_points = true; ///< VTU + PVD and HDF5 of the points
    /// load parameter between two measurements of the bands; 0: never
    double bands_every = 0.05;
    /// boundary or plate whose force is P1 on the terminal; empty: the first
    /// one with a prescribed displacement that depends on s
    std::string watch;

    static void
    declare(dealii::ParameterHandler &prm);
    void
    parse(dealii::ParameterHandler &prm);
    void
    check(Problems &problems) const;
  };
} // namespace Riedel::Output
