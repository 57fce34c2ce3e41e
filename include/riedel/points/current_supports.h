// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/grid/cell_lattice.h>
#include <riedel/grid/parameters.h>
#include <riedel/grid/space.h>
#include <riedel/points/box_weights.h>
#include <riedel/points/support_builder.h>

#include <memory>
#include <vector>

namespace Riedel::Points
{
  /**
   * Supports of the reference configuration "current" (material point method):
   * shape functions live on the grid where it is put back to at the start of
   * the step, and points see them through their boxes (BoxWeights). The points
   * of a cell share the nodes that any of them sees.
   *
   * Strain sampling is that of the elements of degree 1: the rows that give H
   * and theta are the volume-weighted means over the points of a cell plus a
   * fraction of the point's own.
   */
  template <int dim>
  class CurrentSupports : public SupportBuilder<dim>
  {
  public:
    CurrentSupports(const Grid::Space<dim>       &space,
                    const Grid::Parameters       &grid,
                    const MovingPointsParameters &moving,
                    const std::vector<bool>      &is_wall,
                    const bool                    follow_deformation);

    dealii::Quadrature<dim>
    quadrature() const override;

    void
    rebuild(const std::vector<double> &solution,
            MaterialPoints<dim>       &points) override;

    void
    accept(const std::vector<double> &solution,
           const std::vector<double> &du,
           const std::vector<double> &increments,
           MaterialPoints<dim>       &points) override;

  private:
    using SupportBuilder<dim>::result;
    using Particle =
      typename dealii::Particles::ParticleHandler<dim>::particle_iterator;

    /// The points of a cell and what they see.
    struct CellPoints
    {
      std::vector<Particle>                        particles;
      std::vector<double>                          volume;
      std::vector<std::vector<NodeWeight<dim>>>    seen;  ///< by every point
      std::vector<dealii::types::global_dof_index> nodes; ///< by any of them
    };

    CellPoints
    look_from(
      const typename dealii::DoFHandler<dim>::active_cell_iterator &cell,
      const BoxWeights<dim>                                        &weights,
      const MaterialPoints<dim> &points) const;

    void
    add_patches(const CellPoints          &cell,
                const unsigned int         material,
                const MaterialPoints<dim> &points,
                std::vector<Particle>     &order);

    /// Halves boxes that are longer than the smallest cell they touch, or
    /// larger than 0.55 of their own cell. True if there were any, on any rank.
    bool
    split_large_boxes(const Grid::CellLattice<dim> &lattice,
                      MaterialPoints<dim>          &points) const;

    void
    find_unseen_nodes();

    /// A place before the walls for a point that has moved to @p x [m]. Points
    /// move by means over their boxes and may come to a wall before their boxes
    /// have.
    dealii::Point<dim>
    before_walls(const dealii::Point<dim>     &x,
                 const dealii::Tensor<1, dim> &half_lengths) const;

    /// Puts points that are not before the walls there: halves of a box that
    /// lay across a wall.
    void
    hold_before_walls(MaterialPoints<dim> &points) const;

    void
    advance(const std::vector<double> &du,
            const std::vector<double> &increments,
            MaterialPoints<dim>       &points) const;

    const Grid::Space<dim>      *space;
    const Grid::Parameters       parameters;
    const MovingPointsParameters moving;
    const std::vector<bool>      is_wall;
    const bool                   follow_deformation;
  };
} // namespace Riedel::Points
