// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/grid/cell_lattice.h>
#include <riedel/grid/space.h>
#include <riedel/points/material_points.h>

#include <vector>

namespace Riedel::Points
{
  /**
   * Finds points that may become one: in cells that hold many more than at the
   * start, because the grid has become coarse behind a band or the body is
   * compacted. Two points of a cell are a pair if their boxes form one box
   * (joint_box()) that is no larger than the first ones of such a cell and
   * would not be halved again, and if their states are near
   * (MaterialPoints::are_near()).
   */
  template <int dim>
  class Merging
  {
  public:
    Merging(const Grid::Space<dim>       &space,
            const Grid::CellLattice<dim> &lattice,
            const MaterialPoints<dim>    &points,
            const MovingPointsParameters &parameters);

    /// Merges in all cells that have too many points now, until there are no
    /// pairs in them on any rank; collective.
    void
    run(MaterialPoints<dim> &points) const;

  private:
    using Cell = typename dealii::Triangulation<dim>::active_cell_iterator;
    using Pair = typename MaterialPoints<dim>::Pair;
    using Particle =
      typename dealii::Particles::ParticleHandler<dim>::particle_iterator;

    /// A point of a cell, in coordinates of the undeformed grid.
    struct Candidate
    {
      Particle               particle;
      dealii::Point<dim>     X;
      dealii::Tensor<1, dim> half_lengths;
      bool                   is_taken = false;
    };

    void
    add_pairs(const Cell                &cell,
              const MaterialPoints<dim> &points,
              std::vector<Pair>         &pairs) const;

    /// Neighbours along an axis, from the lower end on.
    void
    add_pairs_along(const unsigned int         axis,
                    const Cell                &cell,
                    const MaterialPoints<dim> &points,
                    std::vector<Candidate>    &candidates,
                    std::vector<Pair>         &pairs) const;

    bool
    is_pair(const Candidate           &a,
            const Candidate           &b,
            const Cell                &cell,
            const MaterialPoints<dim> &points) const;

    const Grid::Space<dim>           *space;
    const Grid::CellLattice<dim>     *lattice;
    const MovingPointsParameters     *parameters;
    std::vector<Cell>                 full;
    mutable std::vector<unsigned int> touched;
  };
} // namespace Riedel::Points
