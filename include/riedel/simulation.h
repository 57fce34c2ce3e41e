// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/adaptation/adaptivity.h>
#include <riedel/adaptation/record.h>
#include <riedel/analysis/boundary_averages.h>
#include <riedel/analysis/mobilised_angles.h>
#include <riedel/analysis/shear_bands.h>
#include <riedel/checkpoint/checkpoints.h>
#include <riedel/equilibrium/balance.h>
#include <riedel/equilibrium/predictor.h>
#include <riedel/equilibrium/scheme.h>
#include <riedel/equilibrium/step_control.h>
#include <riedel/grid/body.h>
#include <riedel/grid/space.h>
#include <riedel/output/fields.h>
#include <riedel/output/log.h>
#include <riedel/output/results_folder.h>
#include <riedel/output/rows.h>
#include <riedel/output/table.h>
#include <riedel/output/watch.h>
#include <riedel/points/material_points.h>
#include <riedel/points/support_builder.h>
#include <riedel/scene/scene.h>
#include <riedel/timer.h>

#include <array>
#include <chrono>
#include <functional>
#include <memory>

namespace Riedel
{
  /**
   * A boundary value problem from its first to its last load step. Owns the
   * body, the grid's unknowns, the points, the equations and the files.
   */
  template <int dim>
  class Simulation
  {
  public:
    Simulation(const MPI_Comm               communicator,
               const Scene::Scene<dim>     &scene,
               const Output::ResultsFolder &folder);

    /// Computes all steps, or those that are left of a run that is resumed.
    /// Throws ComputationError if a step cannot be solved; everything up to the
    /// last good step is on disk then.
    void
    run();

  private:
    void
    start();
    /// Goes on where the last checkpoint was written.
    void
    resume();
    void
    say_hello();
    /// Supports, equations and the residual at the start of a step, for a grid,
    /// points and a solution that are new.
    void
    prepare();
    bool
    solve_step();
    /// Balance of a step to @p s.
    void
    begin_step(const double s);
    /// What formulas get in place of s at the present state.
    double
    present_load() const
    {
      return scene.loading.opening.controls ? load_factor : load;
    }
    /// The same at the end of the step to @p s that has been tried.
    double
    load_at(const double s) const
    {
      return scene.loading.opening.controls ? balance->load_factor() : s;
    }
    /// Writes the first guess of a step's increments: extrapolated from the
    /// last steps, or by the tangent.
    Equilibrium::Outcome
    first_guess(const double step, const bool extrapolated);
    void
    accept_step();
    /// Refines and coarsens the grid where the criteria ask for it.
    void
    adapt_grid();
    /// Supports of the points and everything that knows the dofs, on a new
    /// grid.
    void
    rebuild_supports();
    void
    rebuild_equations();
    void
    add_boundary_displacements(const std::vector<std::vector<double>> &added);
    /// Of moving points, where no wall holds the body: the displacement of a
    /// boundary is that of the box around all points.
    void
    measure_free_boundaries();
    void
    record_step();
    void
    write_fields();
    bool
    are_bands_measured() const;
    /// Of the body in the step that has just been solved, before its points
    /// take it over. In plane strain: bands are measured there alone.
    std::array<double, 4>
    mean_increment() const;
    /// @p H: what mean_increment() was in the last step.
    void
    observe_peak(const std::array<double, 4> &H);
    void
    measure_bands();
    void
    finish();

    /// Displacements and rotations at the relevant dofs, for people.
    std::vector<double>
    shown_solution() const;

    /// Effort since the start of the run, also of what it goes on with.
    struct Spent
    {
      double        cpu = 0.0, wall = 0.0; ///< seconds; cpu of all ranks
      std::uint64_t sweeps = 0, factorisations = 0;
      Equilibrium::LinearCounts linear;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &cpu &wall &sweeps &factorisations &linear;
      }
    };

    Spent
    spent() const;

    /// False if the disk refused.
    bool
    save_checkpoint();
    void
    load_checkpoint(const std::string &name);
    /// A step to @p s in which points move farther than other ranks can take
    /// them over has not converged.
    void
    refuse_long_moves(const double s);
    /// A step of size @p step under a measured opening after which the load
    /// factor is far from what the last step lets expect has not converged: it
    /// may be another balance. Where a smaller step is no help the log says so.
    void
    refuse_jump_of_load(const double step);
    /// A line for the end of a message, if the run can be resumed; @p change:
    /// the --set option that may help, or nothing.
    std::string
    how_to_continue(const std::string &change) const;
    /// Does what changes the state of the run. If it fails, the message says
    /// which checkpoint the run can go on from.
    void
    from_last_checkpoint(const std::function<void()> &change);
    typename Checkpoint::Checkpoints<dim>::Bodies
    bodies();
    /// The numbers of the state of the run, to or from an archive.
    template <class Archive>
    void
    exchange(Archive &archive);

    /// Has Loading/Stop been reached?
    bool
    is_complete() const;
    double
    next_mark(const double every) const;
    Output::StepRecord<dim>
    make_record() const;
    double
    wall_seconds() const;

    const MPI_Comm                              communicator;
    const Scene::Scene<dim>                    &scene;
    const Output::ResultsFolder                &folder;
    const bool                                  is_first_rank;
    Timer                                       timer;
    const std::chrono::steady_clock::time_point wall_start;

    Grid::Body<dim>                              body;
    Grid::Space<dim>                             space;
    Adaptation::Adaptivity<dim>                  adaptivity;
    Points::MaterialPoints<dim>                  points;
    std::unique_ptr<Points::SupportBuilder<dim>> supports;
    std::unique_ptr<Equilibrium::Balance<dim>>   balance;
    std::unique_ptr<Equilibrium::Scheme<dim>>    scheme;
    Equilibrium::StepControl                     steps;
    Equilibrium::Extrapolation                   extrapolation;
    Analysis::BoundaryAverages<dim>              averages;

    Output::Log         log;
    Output::Table       history;
    Output::Table       bands_table;
    Output::Fields<dim> fields;
    Output::Watch<dim>  watch;

    Checkpoint::Checkpoints<dim> checkpoints;

    /// the largest of the laws' grain sizes, d50 [m]; 0 without grains
    double grain_size = 0.0;

    /// the state of the run; by a measured opening also the load factor, and
    /// its last change per share of the final opening
    double load_factor = 0.0, load_factor_rate = 0.0;

    unsigned int          n_steps = 0;
    double                load;
    LinearAlgebra::Vector solution;
    std::vector<double>   relevant_solution;
    /// mean displacements of the boundaries since the start
    std::vector<std::vector<double>> boundary_displacements;
    LinearAlgebra::Vector            increment;
    LinearAlgebra::Vector            guess; ///< where its iterations began
    LinearAlgebra::Vector forces_before;    ///< external, last accepted step
    Equilibrium::Outcome  outcome;
    double                external_work = 0.0, stress_work = 0.0;
    Analysis::ShearBands  bands;
    /// of the body, at its largest friction so far
    Analysis::MobilisedAngles peak;
    Adaptation::Record        grid_record;
    unsigned int              last_look = 0; ///< step of the last criteria
    double                    last_fields, last_bands;
    std::size_t               n_floored_points = 0, n_clamped_points = 0;
    unsigned int              n_stalled_steps = 0;

    /// by balances before the present one, and runs before this one
    Spent                                     earlier;
    typename Equilibrium::Assembly<dim>::Cost earlier_law_cost;
  };
} // namespace Riedel
