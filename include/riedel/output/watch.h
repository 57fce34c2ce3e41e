// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/equilibrium/balance.h>
#include <riedel/equilibrium/parameters.h>
#include <riedel/output/parameters.h>

#include <string>

namespace Riedel::Output
{
  /**
   * The force that a run shows on the terminal as P1: of the boundary named by
   * Output/Watch, or of the first one with a prescribed displacement that
   * changes with s.
   */
  template <int dim>
  class Watch
  {
  public:
    Watch(const Parameters                                    &parameters,
          const Equilibrium::BoundaryConditionParameters<dim> &conditions);

    /// The force [N/m in 2D]; 0 if there is nothing to watch.
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
