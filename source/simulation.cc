// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/analysis/deformed_field.h>
#include <riedel/interrupt.h>
#include <riedel/output/report.h>
#include <riedel/output/rows.h>
#include <riedel/points/point_sums.h>
#include <riedel/simulation.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace Riedel
{
  namespace
  {
    /// Two load parameters closer than this are the same mark.
    constexpr double mark_tolerance = 1e-10;



    /// Has the load reached another multiple of @p every since @p before?
    bool
    passed_mark(const double before, const double load, const double every)
    {
      return every > 0.0 && std::floor(load / every + mark_tolerance) >
                              std::floor(before / every + mark_tolerance);
    }
  } // namespace



  template <int dim>
  Simulation<dim>::Simulation(const MPI_Comm               communicator,
                              const Scene::Scene<dim>     &scene,
                              const Output::ResultsFolder &folder)
    : communicator(communicator)
    , scene(scene)
    , folder(folder)
    , is_first_rank(dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
    , wall_start(std::chrono::steady_clock::now())
    , body(communicator, scene.geometry, scene.grid)
    , space(body.triangulation(), scene.grid, scene.materials.is_micropolar())
    , points(body.triangulation(),
             scene.materials,
             scene.grid.configuration == Grid::ReferenceConfiguration::current ?
               &scene.moving_points :
               nullptr)
    , supports(Points::SupportBuilder<dim>::create(
        space,
        scene.grid,
        scene.moving_points,
        !scene.materials.materials.front().law->is_geometrically_linear()))
    , steps(scene.loading, scene.solver, points.are_moving())
    , extrapolation(
        scene.solver.predictor == Equilibrium::Predictor::previous ||
            (scene.solver.predictor == Equilibrium::Predictor::automatic &&
             scene.solver.scheme == Equilibrium::SchemeName::newton) ?
          1 :
          2)
    , averages(scene.geometry.names(), body, space)
    , log(folder.path("log.txt"),
          is_first_rank,
          // mpirun gives ranks a terminal even if its own output is a file
          dealii::Utilities::MPI::n_mpi_processes(communicator) == 1)
    , history(folder.path("history.csv"), is_first_rank)
    , bands_table(folder.path("bands.csv"), is_first_rank)
    , fields(folder, scene.output)
    , watch(scene.output, scene.boundary_conditions)
  {
    for (const auto &material : scene.materials.materials)
      grain_size = std::max(grain_size, material.law->length());
  }



  template <int dim>
  void
  Simulation<dim>::run()
  {
    start();
    const Interrupt interrupt(communicator);
    while (load < scene.loading.stop - mark_tolerance)
      {
        if (!solve_step())
          continue; // with a smaller step
        accept_step();
        measure_bands();
        record_step();
        write_fields();
        if (interrupt.requested())
          {
            log.line("Interrupted: the step is complete, results are written.");
            break;
          }
      }
    finish();
  }



  template <int dim>
  void
  Simulation<dim>::start()
  {
    auto set_up = std::make_unique<Timer::Scope>(timer, "set-up");
    if (points.are_moving())
      space.set_frame(Grid::Frame<dim>(body.grid_extent()));
    points.seed(supports->quadrature(), scene.initial_state, body.extent());
    solution = space.owned_vector();
    space.gather(solution, relevant_solution);
    supports->rebuild(relevant_solution, points);
    balance =
      std::make_unique<Equilibrium::Balance<dim>>(scene.boundary_conditions,
                                                  scene.loading,
                                                  scene.solver,
                                                  body,
                                                  space,
                                                  points,
                                                  supports->supports(),
                                                  timer);
    scheme    = Equilibrium::Scheme<dim>::create(scene.solver, *balance);
    increment = space.owned_vector();
    boundary_displacements = averages(relevant_solution);
    set_up.reset();

    // How far the initial state is from balance under the initial loads.
    LinearAlgebra::Vector r = space.owned_vector();
    balance->begin_step(relevant_solution, 0.0, 0.0);
    outcome.residual = balance->residual(increment, r);
    forces_before    = balance->external_forces();

    log.line(Output::banner(
      scene.general.title, scene.file, folder.name(), communicator));
    for (const std::string &warning : scene.warnings)
      log.line("Warning: " + warning);
    log.line(std::to_string(body.triangulation().n_global_active_cells()) +
             " cells, " + std::to_string(space.dof_handler().n_dofs()) +
             " unknowns.");
    if (outcome.residual.relative() > scene.solver.residual)
      log.line(
        "The initial stress is out of balance with the initial loads: "
        "forces " +
        Output::number(outcome.residual.force / outcome.residual.reference) +
        " of the reactions. The first step brings it into balance.");
    log.line(Output::step_header(watch.description()));
    record_step();
    write_fields();
  }



  template <int dim>
  bool
  Simulation<dim>::solve_step()
  {
    const double step = steps.next(load, next_mark(scene.output.fields_every));
    balance->begin_step(relevant_solution,
                        load,
                        load + step,
                        steps.share_of_uncut());

    const auto try_from = [&](const bool extrapolated) {
      outcome = first_guess(step, extrapolated);
      if (outcome.failure.empty())
        outcome = scheme->solve(*balance, increment, steps.is_last_chance());
    };
    const bool extrapolated = extrapolation.is_possible();
    try_from(extrapolated);
    // What points have not seen yet, an extrapolation only guesses; and a
    // smaller step may not be easier for them.
    if (!outcome.converged && extrapolated && points.are_moving())
      {
        scheme->distrust();
        try_from(false);
      }
    if (outcome.converged)
      return true;

    scheme->distrust();
    log.line("  step to s = " + Output::number(load + step) +
             " not solved: " + outcome.failure + ".");
    if (!steps.failed())
      {
        finish();
        throw ComputationError(
          "The step from s = " + Output::number(load) + " to " +
          Output::number(load + step) +
          " cannot be solved: " + outcome.failure + ".\n" +
          (scene.loading.fixed_steps ?
             "Loading/Fixed steps forbids a smaller one." :
             "A step of half this size would be below Loading/Smallest step "
             "= " +
               Output::number(scene.loading.smallest_step) + ".") +
          "\nResults up to s = " + Output::number(load) + " are in " +
          folder.name() + ".");
      }
    return false;
  }



  template <int dim>
  Equilibrium::Outcome
  Simulation<dim>::first_guess(const double step, const bool extrapolated)
  {
    Equilibrium::Outcome guess;
    if (extrapolated)
      {
        extrapolation.predict(step, increment);
        // a kink in what is prescribed must not end in the boundary's cells
        if (balance->mismatch(increment) < 0.1)
          {
            balance->impose(increment);
            return guess;
          }
      }
    guess.residual = balance->predict_with_tangent(increment);
    if (guess.residual.refused)
      guess.failure = balance->describe_refusal(guess.residual);
    return guess;
  }



  template <int dim>
  void
  Simulation<dim>::accept_step()
  {
    const Timer::Scope scope(timer, "update of points and supports");
    external_work += 0.5 * ((balance->external_forces() * increment) +
                            (forces_before * increment));
    forces_before = balance->external_forces();
    stress_work += balance->stress_work();

    if (points.are_moving())
      balance->continue_to_unseen(increment);
    std::vector<double> du;
    space.gather(increment, du);
    extrapolation.accept(steps.tried(), increment);
    steps.succeeded(outcome.iterations);
    load += steps.tried();
    ++n_steps;
    n_floored_points += outcome.residual.sweep.total.floored;
    n_clamped_points += outcome.residual.sweep.total.clamped;

    if (points.are_moving())
      space.set_frame(balance->walls(load));
    else
      {
        solution += increment;
        space.gather(solution, relevant_solution);
      }
    supports->accept(relevant_solution,
                     du,
                     balance->point_increments(),
                     points);
    add_boundary_displacements(du);
    if (points.are_moving() && balance->supports_changed())
      scheme->distrust();
  }



  template <int dim>
  void
  Simulation<dim>::add_boundary_displacements(const std::vector<double> &du)
  {
    const auto added = averages(du);
    for (std::size_t b = 0; b < added.size(); ++b)
      for (std::size_t c = 0; c < added[b].size(); ++c)
        boundary_displacements[b][c] += added[b][c];
    if (!points.are_moving())
      return;
    // Where no wall holds the body: the side of the box around all points.
    const auto extent  = Points::extent(points, communicator);
    const auto is_wall = [this](const std::string &name, const unsigned int d) {
      for (const auto &boundary : scene.boundary_conditions.boundaries)
        if (boundary.name == name)
          return boundary.displacement[d].given();
      return false;
    };
    for (std::size_t b = 0; b < added.size(); ++b)
      {
        const auto         name = scene.geometry.names()[b];
        const unsigned int side = body.boundary(name), d = side / 2;
        if (!scene.grid.ends_at(side) || !is_wall(name, d))
          boundary_displacements[b][d] =
            side % 2 == 0 ?
              extent.lower_bound(d) - body.extent().lower_bound(d) :
              extent.upper_bound(d) - body.extent().upper_bound(d);
      }
  }



  template <int dim>
  void
  Simulation<dim>::measure_bands()
  {
    const double every = scene.output.bands_every;
    const bool   last  = load > scene.loading.stop - mark_tolerance;
    if (grain_size == 0.0 || every == 0.0 ||
        !(last || passed_mark(last_bands, load, every)))
      return;
    const Timer::Scope scope(timer, "measurement of bands");
    last_bands = load;

    const auto field =
      Analysis::collect_deformed_field(space, shown_solution(), points);
    Analysis::BandMeasureOptions options;
    options.grain_size = grain_size;
    if (is_first_rank)
      {
        bands = Analysis::measure_shear_bands(field, options);
        bands_table.add(Output::bands_row(n_steps, load, bands, grain_size));
      }
  }



  template <int dim>
  void
  Simulation<dim>::record_step()
  {
    const auto record = make_record();
    history.add(Output::history_row(record));
    log.line(Output::step_line(record, watch.force(record.reactions)));
    log.progress(load / scene.loading.stop, wall_seconds());
  }



  template <int dim>
  void
  Simulation<dim>::write_fields()
  {
    const bool last = load > scene.loading.stop - mark_tolerance;
    if (n_steps > 0 && !last &&
        !passed_mark(last_fields, load, scene.output.fields_every))
      return;
    const Timer::Scope scope(timer, "files of fields");
    last_fields = load;
    fields.write(load, space, shown_solution(), points);
  }



  template <int dim>
  std::vector<double>
  Simulation<dim>::shown_solution() const
  {
    return points.are_moving() ?
             Points::nodal_means(space, points, supports->supports()) :
             relevant_solution;
  }



  template <int dim>
  double
  Simulation<dim>::next_mark(const double every) const
  {
    if (every == 0.0)
      return scene.loading.stop;
    const double next =
      every * (std::floor(load / every + mark_tolerance) + 1.0);
    return std::min(next, scene.loading.stop);
  }



  template <int dim>
  void
  Simulation<dim>::finish()
  {
    // an interrupted or failed run keeps its last state
    if (last_fields < load)
      {
        const Timer::Scope scope(timer, "files of fields");
        fields.write(load, space, shown_solution(), points);
      }
    const auto record = make_record();
    log.line(Output::summary(record,
                             n_floored_points,
                             n_clamped_points,
                             balance->law_cost(),
                             timer,
                             wall_seconds(),
                             communicator));
    if (last_bands > 0.0)
      log.line("At s = " + Output::number(last_bands) + ": " +
               Output::bands_line(bands, grain_size));
    log.line("Results are in " + folder.name() + ".");
  }



  template <int dim>
  Output::StepRecord<dim>
  Simulation<dim>::make_record() const
  {
    Output::StepRecord<dim> record;
    record.number        = n_steps;
    record.load          = load;
    record.step          = n_steps == 0 ? 0.0 : steps.tried();
    record.cuts          = steps.n_cuts();
    record.boundaries    = scene.geometry.names();
    record.displacements = boundary_displacements;
    for (const auto &boundary : scene.boundary_conditions.boundaries)
      record.supported.push_back(boundary.name);
    record.reactions      = balance->reactions();
    record.external_work  = external_work;
    record.stress_work    = stress_work;
    record.outcome        = outcome;
    record.sweeps         = balance->n_sweeps;
    record.factorisations = balance->n_factorisations;
    record.n_bands        = bands.bands.size();
    record.cpu_seconds =
      dealii::Utilities::MPI::sum(Timer::cpu_seconds(), communicator);
    Output::sum_up_points(points, communicator, record);
    return record;
  }



  template <int dim>
  double
  Simulation<dim>::wall_seconds() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() -
                                         wall_start)
      .count();
  }



  template class Simulation<2>;
} // namespace Riedel
