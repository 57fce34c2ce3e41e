// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/grid/body.h>
#include <riedel/grid/space.h>

#include <string>
#include <vector>

namespace Riedel::Analysis
{
  /**
   * Mean displacement (and rotation) of the named boundaries, as integrals over
   * their undeformed surface: of the nodes that material sees, by the share of
   * the surface that is theirs.
   */
  template <int dim>
  class BoundaryAverages
  {
  public:
    BoundaryAverages(const std::vector<std::string> &names,
                     const Grid::Body<dim>          &body,
                     const Grid::Space<dim>         &space);

    /// Values [boundary][component] of a field given by its relevant dofs,
    /// without the nodes of @p unseen_dofs (Points::Supports); not a number if
    /// a boundary has no others. Collective.
    std::vector<std::vector<double>>
    operator()(const std::vector<double>       &relevant,
               const std::vector<unsigned int> &unseen_dofs = {}) const;

  private:
    struct Term
    {
      unsigned int boundary, component, dof;
      double       weight; ///< of the surface [m]
    };

    std::size_t             n_boundaries;
    const Grid::Space<dim> *space;
    std::vector<Term>       terms;
  };
} // namespace Riedel::Analysis
