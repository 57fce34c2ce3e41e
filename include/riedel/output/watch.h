// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/equilibrium/balance.h>
#include <riedel/equilibrium/parameters.h>
#include <riedel/equilibrium/plate_parameters.h>
#include <riedel/output/parameters.h>

#include <string>

namespace Riedel::Output
{
  /**
   * The force that a run shows on the terminal as P1: of the boundary or plate
   * named by Output/Watch, or of the first one with a prescribed displacement
   * that changes with s; boundaries come first.
   */
  template <int dim>
  class Watch
  {
  public:
    Watch(const Parameters                                    &parameters,
          const Equilibrium::BoundaryConditionParameters<dim> &conditions,
          const Equilibrium::PlatesParameters<dim>            &plates);

    /// The force [N/m in 2D]; 0 if there is nothing to watch. @p reactions:
    /// of the boundaries with conditions, then of the plates.
    double
    force(const std::vector<typename Equilibrium::Balance<dim>::Reaction>
            &reactions) const;

    /// "force 1 on left", or nothing.
    std::string
    description() const;

  private:
    int          boundary  = -1;
    unsigned int component = 0;
    std::string  name;
  };
} // namespace Riedel::Output
