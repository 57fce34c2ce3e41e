// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/continuum/generalised.h>
#include <riedel/grid/frame.h>
#include <riedel/grid/parameters.h>
#include <riedel/material/parameters.h>
#include <riedel/material/state_layout.h>
#include <riedel/points/parameters.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/quadrature.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/particles/particle_handler.h>

#include <array>
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
   * In the configuration "initial" the place of a particle is its place before
   * the first step; in "current" it is where the point is now, in coordinates
   * of the undeformed grid (Grid::Frame).
   *
   * Volumes, masses and the like are per metre of thickness in plane strain.
   */
  template <int dim>
  class MaterialPoints
  {
  public:
    /// @p moving: the points of the configuration "current"; null for
    /// "initial". They stay if all laws are geometrically linear. @p more:
    /// slots that every point has besides its own and its law's.
    MaterialPoints(
      dealii::parallel::distributed::Triangulation<dim> &triangulation,
      const Material::Parameters<dim>                   &materials,
      const MovingPointsParameters                      *moving = nullptr,
      const Material::StateLayout &more = Material::StateLayout());

    MaterialPoints(const MaterialPoints &) = delete;
    MaterialPoints &
    operator=(const MaterialPoints &) = delete;

    /// Do points move through the grid?
    bool
    are_moving() const
    {
      return moving != nullptr &&
             !laws->materials.front().law->is_geometrically_linear();
    }

    /// Only for points of the configuration "current".
    const MovingPointsParameters &
    moving_parameters() const
    {
      return *moving;
    }

    /// Puts a point on every quadrature point of every cell of the @p body,
    /// with its initial state. Throws InputError for a point that no material
    /// claims.
    void
    seed(const dealii::Quadrature<dim>     &quadrature,
         const InitialStateParameters<dim> &initial,
         const dealii::BoundingBox<dim>    &body);

    /// Attaches the points to the grid before it is saved.
    void
    prepare_to_save();

    /// The points that came with a grid that has been loaded; their
    /// bookkeeping, serialize(), must have been read before. Their order has
    /// to be fixed again.
    void
    load();

    /// Before the cells of the grid are refined, coarsened or sent to other
    /// ranks: points go with them.
    void
    prepare_for_new_grid();

    /// Afterwards; their order has to be fixed again.
    void
    arrive_on_new_grid();

    /// Before another grid is loaded.
    void
    remove_all();

    /// What of the points is not attached to the grid. Throws InputError if
    /// the points that are read have other slots.
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      std::string names = slot_names();
      archive    &names;
      check_slots(names);
      archive &handler &split_count &merged_count &removed_count &held_count;
      archive &drift_of_sums.volume &drift_of_sums.solids &drift_of_sums.mass;
    }

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
    /// must be neighbours. Copies the committed states of the laws. @p frame:
    /// where the grid is.
    void
    set_order(const std::vector<typename dealii::Particles::ParticleHandler<
                dim>::particle_iterator> &order,
              const Grid::Frame<dim>     &frame = Grid::Frame<dim>());

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
    dealii::Point<dim>
    initial_position(const unsigned int point) const
    {
      return are_moving() ? positions[point] - displacement(point) :
                            positions[point];
    }

    /// Position of a point at the start of the step [m].
    dealii::Point<dim>
    position(const unsigned int point) const
    {
      return are_moving() ? positions[point] :
                            positions[point] + displacement(point);
    }

    /// Half the edge lengths of a point's present box [m]: those of its first
    /// box times the diagonal of the stretch U of F = R U; zero for points
    /// without a box.
    dealii::Tensor<1, dim>
    half_lengths(const double *row) const;

    /// Moves a point during accept(): the particle goes to @p x [m], in a grid
    /// at @p frame. Call relocate() when all have moved.
    void
    move(const unsigned int        point,
         const dealii::Point<dim> &x,
         const Grid::Frame<dim>   &frame);

    /// Turns a point during accept() by the rotation vector @p theta [rad].
    void
    turn(const unsigned int                                             point,
         const std::array<double, Continuum::Generalised<dim>::n_spin> &theta);

    /// A point and the axis along which its box is halved.
    struct Halving
    {
      typename dealii::Particles::ParticleHandler<dim>::particle_iterator point;
      unsigned int                                                        axis;
    };

    /// Halves the boxes of points of this rank (collective): two points share
    /// volume and mass, at the centres of the halves, so that the first moments
    /// are kept too; displacements differ so that the halves have also been
    /// side by side before the first step, all else is copied. Call relocate()
    /// afterwards. @p frame: where the grid is.
    void
    split(const std::vector<Halving> &halvings, const Grid::Frame<dim> &frame);

    /// Points split since the start, on all ranks.
    std::uint64_t
    n_split() const
    {
      return split_count;
    }

    /// Two points of a cell that become one, which has the place of the first
    /// in the cell's list.
    struct Pair
    {
      typename dealii::Particles::ParticleHandler<dim>::particle_iterator first;
      typename dealii::Particles::ParticleHandler<dim>::particle_iterator other;
    };

    /// Merges pairs of points of this rank (collective); a point may be in one
    /// pair only, and its boxes must have a joint_box(). Volume, mass, solid
    /// volume V/(1 + e), the volume's first moment and the summed stresses are
    /// kept; see merge_rows(). @p frame: where the grid is.
    void
    merge(const std::vector<Pair> &pairs, const Grid::Frame<dim> &frame);

    /// Points that have gone into others since the start, on all ranks.
    std::uint64_t
    n_merged() const
    {
      return merged_count;
    }

    /// May two points be merged, by their states? Both must have the same
    /// material, and the same values in the slots that are neither every
    /// point's nor the law's (contacts with plates); stresses, couple stresses
    /// over the law's length, and void ratios may differ by @p tolerance.
    bool
    are_near(const double *row,
             const double *other,
             const double  tolerance) const;

    /// Sums over points that splitting and merging have to keep.
    struct Sums
    {
      double volume = 0.0; ///< V
      double solids = 0.0; ///< V/(1 + e); zero for laws without void ratio
      double mass   = 0.0;
    };

    /// What splitting and merging have added to the sums over all ranks since
    /// the start: rounding errors.
    const Sums &
    drift() const
    {
      return drift_of_sums;
    }

    /// A point of this rank was held back by a wall.
    void
    count_held()
    {
      ++held_here;
    }

    /// How often a point was held back by a wall, on all ranks.
    std::uint64_t
    n_held() const
    {
      return held_count;
    }

    /// Points that have left the grid since the start, on all ranks.
    std::uint64_t
    n_removed() const
    {
      return removed_count;
    }

    /// Finds the cells of all points and sends points to the ranks that own
    /// them; then the order has to be fixed anew. Counts the points that have
    /// left the grid; throws ComputationError for one if the scene does not
    /// allow it.
    void
    relocate();

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
        micro_rotation, half_length, deformation_gradient;
      unsigned int void_ratio; ///< of laws that have one
    } place;

  private:
    using Particle =
      typename dealii::Particles::ParticleHandler<dim>::particle_iterator;

    void
    copy_states(const bool to_rows);

    /// A place of the undeformed grid for a point that is in @p cell, where
    /// deal.II 9.4 can sort it: a little beside the faces of cells, where
    /// rounding puts points into neither cell; on several ranks it loses them
    /// then. And it divides by the distance from vertices.
    dealii::Point<dim>
    sortable_place(
      const dealii::Point<dim>                                 &X,
      const typename dealii::Triangulation<dim>::cell_iterator &cell) const;

    /// Adds @p factor times a point's part of the sums.
    void
    add(const double *row, const double factor, Sums &sums) const;

    /// Sets the first box and the deformation gradient so that the present box
    /// has @p half_lengths [m] and det F is V/V_0: F keeps its directions and
    /// ratios.
    void
    set_half_lengths(const dealii::Tensor<1, dim> &half_lengths,
                     double                       *row) const;

    /// Adds the @p other point to a point, both of the same material; not its
    /// box. Displacement, micro-rotation and stresses are volume-weighted
    /// means, the void ratio follows from the sum of the solid volumes. All
    /// else that a law remembers is copied from the larger one: a mean of two
    /// histories is none.
    void
    merge_rows(double *row, const double *other) const;

    /// How much farther a place at a @p distance from the point has been
    /// displaced, (I - F^-1) dx [m].
    dealii::Tensor<1, dim>
    displacement_over(const double       distance,
                      const unsigned int axis,
                      const double      *row) const;

    /// Sums a count and a drift up over the ranks.
    void
    add_to_history(const std::uint64_t n_here,
                   const Sums         &drift_here,
                   std::uint64_t      &count);

    /// Names and sizes of the slots: `material 1, stress 5, ...`
    std::string
    slot_names() const;

    void
    check_slots(const std::string &names) const;

    dealii::Tensor<1, dim>
    displacement(const unsigned int point) const
    {
      dealii::Tensor<1, dim> u;
      for (unsigned int d = 0; d < dim; ++d)
        u[d] = rows[point][place.displacement + d];
      return u;
    }

    const dealii::Triangulation<dim> *triangulation;
    /// of moving points: the box that the undeformed grid fills
    dealii::BoundingBox<dim>         grid;
    const Material::Parameters<dim> *laws;
    const MovingPointsParameters    *moving;
    Material::StateLayout            slots;
    /// the handler keeps a pointer to it
    const dealii::MappingQ1<dim>            mapping;
    dealii::Particles::ParticleHandler<dim> handler;

    /// per material: place in a point's row of every value of the law's state
    std::vector<std::vector<unsigned int>> law_places;

    /// slots that are neither every point's nor a law's
    std::vector<unsigned int> more_places;

    std::uint64_t                              split_count  = 0;
    std::uint64_t                              merged_count = 0;
    Sums                                       drift_of_sums;
    std::uint64_t                              removed_count = 0;
    std::uint64_t                              held_count    = 0;
    std::uint64_t                              held_here = 0; ///< not added yet
    std::vector<Particle>                      particle_at;
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
