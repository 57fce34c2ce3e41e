// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/material/parameters.h>
#include <riedel/material/state_layout.h>
#include <riedel/points/parameters.h>

#include <deal.II/base/quadrature.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/particles/particle_handler.h>

#include <string>
#include <vector>

namespace Riedel::Points
{
  /// Gravity acceleration that relates weight and mass [m/s2].
  constexpr double gravity = 9.81;

  /**
   * The material points: they carry volume, mass, stress, couple stress, void
   * ratio and history. The committed state of a point lives in the properties
   * of its particle, so that it travels with the point between ranks and grids;
   * its slots are those every point has (see the constructor) and the union of
   * the slots of the scene's laws.
   *
   * During a step, points are addressed by their place in the step's order (see
   * set_order()): all points of the first law, then those of the second, and so
   * on. The laws' states are copied to contiguous arrays: committed() and
   * trial(). accept() copies the trial states to the particles; a step that is
   * given up needs nothing to be undone.
   *
   * Volumes, masses and the like are per metre of thickness in plane strain.
   */
  template <int dim>
  class MaterialPoints
  {
  public:
    MaterialPoints(
      dealii::parallel::distributed::Triangulation<dim> &triangulation,
      const Material::Parameters<dim>                   &materials);

    /// Puts a point on every quadrature point of every cell, with its initial
    /// state. Throws InputError for a point that no material claims.
    void
    seed(const dealii::Quadrature<dim>     &quadrature,
         const InitialStateParameters<dim> &initial,
         const dealii::BoundingBox<dim>    &body);

    /// Removes all points: they cannot be touched until the next set_order().
    void
    clear();

    /// Puts a point into a cell: its place in the cell and in the undeformed
    /// body [m], an id that no other point has, the slots of layout().
    void
    insert(
      const typename dealii::Triangulation<dim>::active_cell_iterator &cell,
      const dealii::Point<dim>           &place_in_cell,
      const dealii::Point<dim>           &position,
      const dealii::types::particle_index id,
      const double                       *slots_of_point);

    /// After the last insert(); collective.
    void
    finish_insertion();

    const dealii::Particles::ParticleHandler<dim> &
    particles() const
    {
      return handler;
    }

    /// Slots of a point's committed state.
    const Material::StateLayout &
    layout() const
    {
      return slots;
    }

    const Material::Parameters<dim> &
    materials() const
    {
      return *laws;
    }

    /// Number of a particle's material.
    unsigned int
    material(
      const typename dealii::Particles::ParticleHandler<dim>::particle_iterator
        &particle) const;

    /// The points of one law are neighbours in the step's order.
    struct Range
    {
      unsigned int material;
      unsigned int first;
      unsigned int last; ///< one behind
    };

    /// Fixes the order of points for the coming steps; points of one material
    /// must be neighbours. Copies the committed states of the laws.
    void
    set_order(const std::vector<typename dealii::Particles::ParticleHandler<
                dim>::particle_iterator> &order);

    const std::vector<Range> &
    ranges() const
    {
      return law_ranges;
    }

    /// Points on this rank.
    unsigned int
    n_points() const
    {
      return static_cast<unsigned int>(rows.size());
    }

    /// Committed slots of a point; see layout() for places.
    double *
    row(const unsigned int point)
    {
      return rows[point];
    }

    const double *
    row(const unsigned int point) const
    {
      return rows[point];
    }

    dealii::types::particle_index
    id(const unsigned int point) const
    {
      return ids[point];
    }

    /// Active cell index of the cell that a point is in.
    unsigned int
    cell(const unsigned int point) const
    {
      return cells[point];
    }

    /// Position of a point before the first step [m].
    const dealii::Point<dim> &
    initial_position(const unsigned int point) const
    {
      return positions[point];
    }

    /// State of the laws at the start of the step, from @p point on.
    const double *
    committed(const unsigned int point) const
    {
      return committed_states.data() + state_offset[point];
    }

    /// ... and at its end.
    double *
    trial(const unsigned int point)
    {
      return trial_states.data() + state_offset[point];
    }

    /// The trial states become the committed ones.
    void
    accept();

    /// Places of the slots that every point has.
    struct Places
    {
      unsigned int material, initial_volume, volume, mass, displacement,
        micro_rotation;
    } place;

  private:
    void
    copy_states(const bool to_rows);

    const dealii::Triangulation<dim>       *triangulation;
    const Material::Parameters<dim>        *laws;
    Material::StateLayout                   slots;
    dealii::Particles::ParticleHandler<dim> handler;

    /// per material: place in a point's row of every value of the law's state
    std::vector<std::vector<unsigned int>> law_places;

    std::vector<double *>                      rows;
    std::vector<dealii::types::particle_index> ids;
    std::vector<dealii::Point<dim>>            positions;
    std::vector<unsigned int>                  cells;
    std::vector<Range>                         law_ranges;
    std::vector<std::size_t>                   state_offset;
    std::vector<double>                        committed_states;
    std::vector<double>                        trial_states;
  };
} // namespace Riedel::Points
