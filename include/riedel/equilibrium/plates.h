// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/equilibrium/loads.h>
#include <riedel/equilibrium/plate_parameters.h>
#include <riedel/grid/space.h>
#include <riedel/points/box_weights.h>
#include <riedel/points/material_points.h>

#include <string>
#include <vector>

namespace Riedel::Equilibrium
{
  /**
   * Contact of moving material points with rigid plates that do not fit the
   * grid (doc/theory/contact.md). It acts on the face of a point's box that
   * looks at the plate: the face moves by the means of the shape functions over
   * it, and so the plate's traction spreads to the nodes.
   *
   * With n out of the plate and v the motion of the face relative to the plate
   * in the step, pressure and shear of the plate on the point are
   *
   *     p = k <g - n.v>,   k = penalty times stiffness of the point / box
   * length t = t_n - k v_t, cut to |t| <= tan(phi) p.
   *
   * The state of a contact is its traction: the penetration g at the start of a
   * step is that which gives the accepted pressure, because the box changes its
   * length otherwise than its face moves. A small share of the difference to
   * the geometric penetration is taken up in every step.
   *
   * Areas, stiffness and the face in contact are those of the step's start.
   */
  template <int dim>
  class Plates
  {
  public:
    Plates(const PlatesParameters<dim> &parameters,
           const Grid::Space<dim>      &space,
           Points::MaterialPoints<dim> &points);

    /// Slots that the points need for contact; none without plates.
    static Material::StateLayout
    slots(const PlatesParameters<dim> &parameters);

    /// Finds the points near the plates, which are where the load parameter @p
    /// s puts them, after points have moved.
    void
    rebuild(const double s);

    /// Dofs that a contact couples.
    std::vector<std::vector<dealii::types::global_dof_index>>
    couplings() const;

    /// The plates' motion of the step is that from the load parameter @p from
    /// to @p to.
    void
    move(const double from, const double to);

    /// Largest relative change of a plate's velocity since the last accepted
    /// step: increments cannot be extrapolated over a kink.
    double
    kink() const;

    /// While on, points in contact neither slide nor part from the plate, even
    /// if they would: for a first guess, which then follows the plate.
    void
    set_sticking(const bool on)
    {
      is_sticking = on;
    }

    /// Adds the nodal forces of the plates at the increments @p du (relevant
    /// dofs) and, if @p add_matrix is not empty, minus their derivative.
    void
    add_forces(const std::vector<double>            &du,
               std::vector<double>                  &forces,
               const typename Loads<dim>::AddMatrix &add_matrix);

    /// The tractions of the last sweep become the points' own. To be called
    /// before the points move.
    void
    accept();

    /// Work of the tractions on the points over the step (trapezoidal), after a
    /// sweep [J/m in 2D]. Collective.
    double
    work() const;

    /// What a plate does after the last sweep.
    struct Report
    {
      std::string            name;
      dealii::Tensor<1, dim> displacement; ///< since the start [m]
      dealii::Tensor<1, dim> force;        ///< on the body [N/m in 2D]
      Continuum::Moment<dim> moment;       ///< about the origin [N in 2D]
      unsigned int           n_contacts = 0, n_sliding = 0; ///< points
    };

    /// One per plate, over all ranks. Collective.
    std::vector<Report>
    reports() const;

  private:
    /// A point near a plate.
    struct Contact
    {
      unsigned int       point;
      unsigned int       plate;
      unsigned int       face;   ///< of the plate, in deal.II's order
      dealii::Point<dim> centre; ///< of the box's face, start of the step [m]
      double             area;   ///< of the box's face over the plate's [m]
      double             stiffness;   ///< k [Pa/m]
      double             penetration; ///< at the start of the step [m]
      double             shear;       ///< t_n [Pa]
      dealii::Tensor<1, dim>               traction_before; ///< [Pa]
      std::vector<Points::NodeWeight<dim>> nodes;

      // after the last sweep
      dealii::Tensor<1, dim> motion;   ///< of the box's face [m]
      dealii::Tensor<1, dim> traction; ///< on the point [Pa]
      bool                   is_closed = false, is_sliding = false;
    };

    /// The face at which a box meets a plate: the one of least penetration.
    struct Meeting
    {
      unsigned int face        = 0;
      double       penetration = 0.0; ///< negative: a gap [m]
      double       area        = 0.0; ///< 0: they do not meet
    };

    Meeting
    meet(const dealii::BoundingBox<dim> &plate,
         const dealii::Point<dim>       &centre,
         const dealii::Tensor<1, dim>   &half_lengths) const;

    Meeting
    meet_at(const unsigned int              face,
            const dealii::BoundingBox<dim> &plate,
            const dealii::Point<dim>       &centre,
            const dealii::Tensor<1, dim>   &half_lengths) const;

    const PlatesParameters<dim> *parameters;
    const Grid::Space<dim>      *space;
    Points::MaterialPoints<dim> *points;
    unsigned int                 traction_place, face_place;

    std::vector<Contact> contacts;
    /// of every plate in the step, and since the start [m]
    std::vector<dealii::Tensor<1, dim>> motion, displacement;
    /// displacement per load parameter, of this step and the last accepted one
    std::vector<dealii::Tensor<1, dim>> rate, accepted_rate;
    bool                                is_sticking = false;
  };
} // namespace Riedel::Equilibrium
