// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/equilibrium/assembly.h>
#include <riedel/equilibrium/boundary_conditions.h>
#include <riedel/equilibrium/linear_solver.h>
#include <riedel/equilibrium/loads.h>
#include <riedel/equilibrium/opening.h>
#include <riedel/equilibrium/parameters.h>
#include <riedel/equilibrium/plates.h>
#include <riedel/equilibrium/surface_stabilisation.h>
#include <riedel/equilibrium/virtual_stress.h>
#include <riedel/grid/body.h>
#include <riedel/grid/space.h>
#include <riedel/timer.h>

#include <memory>
#include <vector>

namespace Riedel::Equilibrium
{
  /// How far the forces and moments of a trial step are from balance.
  struct Residual
  {
    double force     = 0.0; ///< norm of the out-of-balance forces [N/m in 2D]
    double moment    = 0.0; ///< of the moments, divided by the law's length
    double reference = 0.0; ///< norm of reactions or loads
    /// what is missing of the step's opening, relative to it; 0 without
    /// control
    double      opening = 0.0;
    SweepReport sweep; ///< sums over all ranks, first_refused of this one
    bool        refused = false; ///< a point on some rank gave no result

    double
    relative() const
    {
      return std::max(std::max(force, moment) / reference, opening);
    }
  };

  /**
   * The equations of one load step: nodal forces of the stresses minus loads,
   * as a function of the displacement and rotation increments du, and their
   * linearisation. What solves them is a scheme (scheme.h).
   */
  template <int dim>
  class Balance
  {
  public:
    /// @p load is the load parameter of the state that the points are in: the
    /// plates are where they are then.
    Balance(const BoundaryConditionParameters<dim> &boundary_parameters,
            const PlatesParameters<dim>            &plate_parameters,
            const LoadingParameters<dim>           &loading,
            const SolverParameters                 &solver,
            const Grid::Body<dim>                  &body,
            const Grid::Space<dim>                 &space,
            Points::MaterialPoints<dim>            &points,
            const Points::Supports<dim>            &supports,
            Timer                                  &timer,
            const double                            load = 0.0);

    /// To be called when the supports have changed: points have moved. True if
    /// other nodes than before are seen by points.
    bool
    supports_changed();

    /// Starts a step from the displacement @p u (relevant dofs by local
    /// number) and the load parameter @p from to @p to. In the configuration
    /// "current" @p u is zero, and a step that is only the share @p release of
    /// one that could not be solved takes back only this share of the imbalance
    /// that points leave by moving (doc/theory/material_points.md).
    void
    begin_step(const std::vector<double> &u,
               const double               from,
               const double               to,
               const double               release = 1.0);

    /// After begin_step(), whose end @p to is then only the first guess of the
    /// load factor: the opening at the end of the step [m].
    void
    aim_at(const double opening_at_end);

    /// The load parameter of the last sweep: that of the step's end or, if an
    /// opening controls the load, the load factor.
    double
    load_factor() const
    {
      return load;
    }

    /// Where the walls of the grid are at a load parameter.
    Grid::Frame<dim>
    walls(const double s) const
    {
      return conditions.walls(s);
    }

    /// Dofs with prescribed increments.
    const std::vector<typename BoundaryConditions<dim>::Prescribed> &
    prescribed_dofs() const
    {
      return conditions.prescribed();
    }

    /// Dofs without increments of their own: prescribed or seen by no point.
    const std::vector<bool> &
    is_fixed() const
    {
      return conditions.is_fixed();
    }

    /// Generalised increments of the points after the last sweep.
    const std::vector<double> &
    point_increments() const
    {
      return assembly.point_increments();
    }

    /// A vector of increments, zero.
    LinearAlgebra::Vector
    vector() const
    {
      return space->owned_vector();
    }

    /// Gives the prescribed dofs of @p du their increments.
    void
    impose(LinearAlgebra::Vector &du) const;

    /// Largest difference between the prescribed increments and those of @p du,
    /// relative to the largest prescribed increment; or the kink in the motion
    /// of a plate.
    double
    mismatch(const LinearAlgebra::Vector &du) const;

    /// Out-of-balance forces @p r at @p du, zero at prescribed dofs. A residual
    /// sweep: laws are asked for values only.
    Residual
    residual(const LinearAlgebra::Vector &du, LinearAlgebra::Vector &r);

    /// The same, with the stiffness at @p du assembled and factorised.
    Residual
    linearise(const LinearAlgebra::Vector &du, LinearAlgebra::Vector &r);

    /// delta = -K^-1 r with the last factors.
    void
    correction(const LinearAlgebra::Vector &r, LinearAlgebra::Vector &delta);

    /// Sets @p du to @p from plus a fraction of the last correction, which
    /// includes that of the load factor if an opening controls it.
    void
    advance(const LinearAlgebra::Vector &from,
            const double                 fraction,
            const LinearAlgebra::Vector &delta,
            LinearAlgebra::Vector       &du);

    /// First guess from the tangent at zero increment under the prescribed
    /// increments of the step. Never the prescribed increments alone: they
    /// would localise in the boundary's cells.
    Residual
    predict_with_tangent(LinearAlgebra::Vector &du);

    bool
    has_factors() const
    {
      return factorised;
    }

    /// Squared weights that make rotations comparable with displacements.
    const LinearAlgebra::Vector &
    metric() const
    {
      return squared_lengths;
    }

    /// Loads plus reactions after the last sweep, all dofs: what does external
    /// work besides the plates, see plate_work().
    const LinearAlgebra::Vector &
    external_forces() const
    {
      return external;
    }

    /// The tractions of the plates become the points' own, before they move.
    void
    accept_contacts()
    {
      accepted_plates = plates.reports();
      plates.accept();
    }

    /// What the plates did in the last accepted step.
    const std::vector<typename Plates<dim>::Report> &
    plate_reports() const
    {
      return accepted_plates;
    }

    /// Force [N/m in 2D] and moment about the origin [N] that a boundary exerts
    /// on the body after the last sweep, or a plate after the last accepted
    /// step, summed over the ranks.
    struct Reaction
    {
      dealii::Tensor<1, dim> force;
      Continuum::Moment<dim> moment;
    };

    /// Of the boundaries with conditions, then of the plates.
    std::vector<Reaction>
    reactions() const;

    /// Work of the stresses over the step, all ranks.
    double
    stress_work() const;

    /// Work of the plates on the points over the step, all ranks.
    double
    plate_work() const;

    const typename Assembly<dim>::Cost &
    law_cost() const
    {
      return assembly.cost();
    }

    /// Takes over the counts of the balance on the grid before.
    void
    continue_counts(const Balance &before)
    {
      n_sweeps         = before.n_sweeps;
      n_factorisations = before.n_factorisations;
      assembly.continue_cost(before.assembly.cost());
      earlier_linear_counts = before.linear_counts();
    }

    /// Effort of an iterative linear solver.
    LinearCounts
    linear_counts() const
    {
      LinearCounts counts = earlier_linear_counts;
      if (solver)
        counts += solver->counts();
      return counts;
    }

    /// Where the residual of the last sweep is largest: a sentence for people.
    std::string
    describe_worst(const LinearAlgebra::Vector &r) const;

    /// Which point was refused in the last sweep and why: a sentence for
    /// people, the same on all ranks.
    std::string
    describe_refusal(const Residual &residual) const;

    std::uint64_t n_sweeps         = 0; ///< residual sweeps (values only)
    std::uint64_t n_factorisations = 0;

  private:
    void
    make_matrix();

    /// Chooses and makes the solver of linear systems.
    void
    make_solver();

    /// Rigid motions of the body as it is, all unknowns of one after all of
    /// another, for owned dofs: translations [m], then rotations [rad], which
    /// turn the grains with the body.
    std::vector<double>
    rigid_motions() const;

    void
    set_missing_diagonal();

    void
    find_extent();

    /// Loads and prescribed increments of the step at a load parameter.
    void
    set_load(const double s);

    /// Derivative of minus the residual by the load factor at @p du: its part
    /// of the prescribed increments is given.
    void
    add_load_derivative(const LinearAlgebra::Vector &du);

    /// Completes a correction of the increments by that of the load factor.
    void
    close_opening(LinearAlgebra::Vector &delta);

    /// Prescribed increments per load factor, by local number.
    std::vector<double>
    prescribed_rates() const;

    /// Stiffness under @p constraints at @p du, and its factors.
    Residual
    factorise_at(const LinearAlgebra::Vector             &du,
                 const dealii::AffineConstraints<double> &constraints,
                 LinearAlgebra::Vector                   &r,
                 LinearAlgebra::Vector                   &right_hand_side);

    Residual
    evaluate(const LinearAlgebra::Vector             &du,
             LinearAlgebra::Vector                   &r,
             const dealii::AffineConstraints<double> *constraints,
             LinearAlgebra::Vector                   *right_hand_side);

    const BoundaryConditionParameters<dim> *boundary_parameters;
    const LoadingParameters<dim>           *loading;
    const SolverParameters                 *parameters;
    const Grid::Body<dim>                  *body;
    const Grid::Space<dim>                 *space;
    Points::MaterialPoints<dim>            *points;
    const Points::Supports<dim>            *supports;
    Timer                                  *timer;

    BoundaryConditions<dim> conditions;
    Loads<dim>              loads;
    VirtualStress<dim>      virtual_stress;
    /// of points that move; else empty
    std::unique_ptr<SurfaceStabilisation<dim>> stabilisation;
    Plates<dim>                                plates;
    Assembly<dim>                              assembly;

    double                        length; ///< divides moments
    LinearAlgebra::SparseMatrix   matrix;
    std::unique_ptr<LinearSolver> solver;
    LinearCounts                  earlier_linear_counts;
    bool                          factorised = false;
    /// does the matrix have the entries of the present supports?
    bool has_matrix = false;
    /// norm of the diagonal of the displacements' stiffness
    double stiffness_norm = 0.0;

    std::vector<double> start;       ///< displacement at the step's start
    std::vector<double> prescribed;  ///< increments, by local number
    std::vector<double> body_forces; ///< relevant dofs
    std::vector<double>
           present; ///< displacement of the last sweep, relevant dofs
    double load;
    double step_from = 0.0; ///< load parameter at the start of the step

    /// of a control by opening; else empty
    std::unique_ptr<Opening<dim>> opening;
    double opening_of_step = 0.0; ///< its increment [m]; 0: not asked for
    double opening_gap     = 0.0; ///< what the last sweep lacks of it [m]
    /// minus the derivative of the residual by the load factor
    LinearAlgebra::Vector load_derivative;
    /// load factor where the last correction was made, and its correction
    double corrected_load = 0.0, load_correction = 0.0;
    /// nodal forces of the last sweep, relevant dofs
    std::vector<double> increment, internal, applied, plate_forces,
      virtual_forces;
    LinearAlgebra::Vector external, reaction, squared_lengths;
    /// imbalance that is not released yet; empty if it all is
    LinearAlgebra::Vector                     held;
    std::vector<bool>                         is_prescribed; ///< or hanging
    std::vector<bool>                         is_rotation;   ///< by owned place
    std::vector<typename Loads<dim>::Surface> surfaces;      ///< all ranks
    std::vector<typename Plates<dim>::Report> accepted_plates;
  };
} // namespace Riedel::Equilibrium
