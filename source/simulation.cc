// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/adaptation/grid_change.h>
#include <riedel/adaptation/initial_point_transfer.h>
#include <riedel/adaptation/moving_point_transfer.h>
#include <riedel/analysis/deformed_field.h>
#include <riedel/equilibrium/unseen_dofs.h>
#include <riedel/interrupt.h>
#include <riedel/output/report.h>
#include <riedel/output/rows.h>
#include <riedel/points/motion.h>
#include <riedel/points/point_sums.h>
#include <riedel/simulation.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace Riedel
{
  namespace
  {
    std::vector<Checkpoint::Setting>
    settings(const std::vector<Scene::DeclaredParameter> &parameters)
    {
      std::vector<Checkpoint::Setting> result;
      for (const auto &parameter : parameters)
        result.push_back(
          {parameter.path, parameter.value, parameter.default_value});
      return result;
    }



    /// Sides of the grid whose normal displacement is prescribed.
    template <int dim>
    std::vector<bool>
    walls(const Scene::Scene<dim> &scene)
    {
      std::vector<bool> is_wall(2 * dim, false);
      for (const auto &[id, name] : scene.geometry.boundary_names)
        for (const auto &boundary : scene.boundary_conditions.boundaries)
          if (boundary.name == name && id < 2 * dim)
            is_wall[id] = boundary.displacement[id / 2].given();
      return is_wall;
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
    , adaptivity(scene.adaptation,
                 scene.materials,
                 scene.initial_state,
                 body.triangulation())
    , points(body.triangulation(),
             scene.materials,
             scene.grid.configuration == Grid::ReferenceConfiguration::current ?
               &scene.moving_points :
               nullptr,
             Equilibrium::Plates<dim>::slots(scene.plates))
    , supports(Points::SupportBuilder<dim>::create(
        space,
        scene.grid,
        scene.moving_points,
        walls(scene),
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
          dealii::Utilities::MPI::n_mpi_processes(communicator) == 1,
          folder.is_resumed())
    , history(folder.path("history.csv"), is_first_rank, folder.is_resumed())
    , bands_table(folder.path("bands.csv"), is_first_rank, folder.is_resumed())
    , fields(folder, scene.output)
    , watch(scene.output, scene.boundary_conditions, scene.plates)
    , checkpoints(communicator,
                  folder.name(),
                  scene.checkpoint,
                  settings(scene.parameters))
    , load(scene.loading.start)
    , last_fields(load)
    , last_bands(load)
  {
    for (const auto &material : scene.materials.materials)
      grain_size = std::max(grain_size, material.law->grain_size());
  }



  template <int dim>
  void
  Simulation<dim>::run()
  {
    if (folder.is_resumed())
      resume();
    else
      start();
    const Interrupt interrupt(communicator);
    while (!is_complete())
      {
        if (checkpoints.is_due(n_steps))
          {
            // it is read as by a resumed run: so both go on alike
            if (save_checkpoint())
              load_checkpoint(checkpoints.last());
          }
        from_last_checkpoint([this]() { adapt_grid(); });
        if (!solve_step())
          continue; // with a smaller step
        from_last_checkpoint([this]() { accept_step(); });
        measure_bands();
        record_step();
        write_fields();
        if (interrupt.requested())
          {
            if (checkpoints.is_due_at_end(n_steps, /*in_order=*/false))
              save_checkpoint();
            log.line("Interrupted: the step is complete, results are written." +
                     how_to_continue(""));
            break;
          }
      }
    if (checkpoints.is_due_at_end(n_steps, /*in_order=*/true))
      save_checkpoint();
    finish();
  }



  template <int dim>
  void
  Simulation<dim>::from_last_checkpoint(const std::function<void()> &change)
  {
    const double before = load;
    try
      {
        change();
      }
    catch (const ComputationError &error)
      {
        const std::string last = checkpoints.last();
        throw ComputationError(
          error.what() +
          ("\nResults up to s = " + Output::number(before) + " are in " +
           folder.name() + ". ") +
          (last.empty() ?
             "There is no checkpoint yet; Checkpoint/Every steps writes them "
             "more often." :
             "The last checkpoint is that of step " + last + "." +
               how_to_continue("")));
      }
  }



  template <int dim>
  void
  Simulation<dim>::start()
  {
    if (points.are_moving())
      space.set_frame(Grid::Frame<dim>(body.grid_extent()));
    if (adaptivity.refine_initially(body.triangulation()))
      space.distribute();
    points.seed(supports->quadrature(), scene.initial_state, body.extent());
    solution = space.owned_vector();
    prepare();
    forces_before = balance->external_forces();
    boundary_displacements =
      averages(relevant_solution, supports->supports().unseen_dofs);
    measure_free_boundaries();

    say_hello();
    // how far the initial state is from balance under the initial loads
    if (outcome.residual.relative() > scene.solver.residual)
      log.line(
        "The initial stress is out of balance with the initial loads: "
        "forces " +
        Output::number(outcome.residual.force / outcome.residual.reference) +
        " of the reactions. The first step brings it into balance.");
    log.line(Output::step_header(watch.description(), dim));
    record_step();
    write_fields();
  }



  template <int dim>
  void
  Simulation<dim>::prepare()
  {
    auto set_up = std::make_unique<Timer::Scope>(timer, "set-up");
    rebuild_supports();
    rebuild_equations();
    increment = space.owned_vector();
    set_up.reset();

    LinearAlgebra::Vector r = space.owned_vector();
    balance->begin_step(relevant_solution, present_load(), present_load());
    outcome.residual = balance->residual(increment, r);
  }



  template <int dim>
  void
  Simulation<dim>::rebuild_supports()
  {
    space.gather(solution, relevant_solution);
    supports->rebuild(relevant_solution, points);
  }



  template <int dim>
  void
  Simulation<dim>::rebuild_equations()
  {
    const auto before = std::move(balance);
    balance =
      std::make_unique<Equilibrium::Balance<dim>>(scene.boundary_conditions,
                                                  scene.plates,
                                                  scene.loading,
                                                  scene.solver,
                                                  body,
                                                  space,
                                                  points,
                                                  supports->supports(),
                                                  timer,
                                                  present_load());
    if (before)
      balance->continue_counts(*before);
    scheme = Equilibrium::Scheme<dim>::create(scene.solver, *balance);
    averages =
      Analysis::BoundaryAverages<dim>(scene.geometry.names(), body, space);
    grid_record.cells    = body.triangulation().n_global_active_cells();
    grid_record.unknowns = space.dof_handler().n_dofs();
  }



  template <int dim>
  void
  Simulation<dim>::adapt_grid()
  {
    if (!adaptivity.is_on() || last_look == n_steps)
      return; // a failed step is tried again on the same grid
    last_look             = n_steps;
    grid_record.imbalance = grid_record.force_jump = grid_record.stress_change =
      0.0;
    if (!adaptivity.is_due(n_steps))
      return;
    const Timer::Scope scope(timer, "adaptation of the grid");

    const double force_before = watch.force(balance->reactions());
    const auto stress_before  = Adaptation::summed_stress(points, communicator);
    std::vector<double> relevant_increment;
    unsigned int        round = 0;
    for (; round < adaptivity.n_rounds(); ++round)
      {
        space.gather(increment, relevant_increment);
        if (!adaptivity.mark(round == 0 && adaptivity.may_coarsen(n_steps),
                             body.triangulation(),
                             space,
                             points,
                             supports->supports(),
                             relevant_increment))
          break;
        std::vector<LinearAlgebra::Vector *> vectors = {&solution, &increment};
        for (LinearAlgebra::Vector *guess : extrapolation.vectors())
          if (guess->size() > 0) // after the first step one of them is empty
            vectors.push_back(guess);
        std::unique_ptr<Adaptation::PointTransfer<dim>> transfer;
        if (points.are_moving())
          transfer =
            std::make_unique<Adaptation::MovingPointTransfer<dim>>(points);
        else
          transfer = std::make_unique<Adaptation::InitialPointTransfer<dim>>(
            body.triangulation(), points, supports->quadrature());
        Adaptation::change_grid(body.triangulation(),
                                space,
                                *transfer,
                                vectors);
        rebuild_supports();
      }
    if (round == 0)
      return;
    rebuild_equations();

    // The state in balance on the old grid, seen by the new one. The next step
    // releases what is out of balance: holding the load for it does harm.
    LinearAlgebra::Vector r = space.owned_vector(), zero = space.owned_vector();
    balance->begin_step(relevant_solution, present_load(), present_load());
    const auto residual = balance->residual(zero, r);
    forces_before       = balance->external_forces();

    ++grid_record.n_changes;
    grid_record.imbalance  = residual.relative();
    grid_record.force_jump = watch.force(balance->reactions()) - force_before;
    grid_record.stress_change = Adaptation::relative_change(
      stress_before, Adaptation::summed_stress(points, communicator));
    log.line("  new grid: " + std::to_string(grid_record.cells) + " cells, " +
             std::to_string(grid_record.unknowns) +
             " unknowns; out of balance " +
             Output::number(grid_record.imbalance) + ", jump of P1 " +
             Output::number(1e-3 * grid_record.force_jump) +
             (dim == 2 ? " kN/m." : " kN."));
  }



  template <int dim>
  void
  Simulation<dim>::begin_step(const double s)
  {
    const auto &opening = scene.loading.opening;
    if (!opening.controls)
      {
        balance->begin_step(relevant_solution, load, s, steps.share_of_uncut());
        return;
      }
    balance->begin_step(relevant_solution,
                        load_factor,
                        load_factor + (s - load) * load_factor_rate,
                        steps.share_of_uncut());
    balance->aim_at(s * opening.final_opening);
  }



  template <int dim>
  bool
  Simulation<dim>::solve_step()
  {
    const double step = steps.next(load, next_mark(scene.output.fields_every));
    begin_step(load + step);

    const auto try_from = [&](const bool extrapolated) {
      outcome = first_guess(step, extrapolated);
      guess   = increment;
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
      refuse_long_moves(load + step);
    if (outcome.converged)
      refuse_jump_of_load(step);
    if (outcome.converged)
      return true;

    scheme->distrust();
    log.line("  step to s = " + Output::number(load + step) +
             " not solved: " + outcome.failure + ".");
    if (!steps.failed())
      {
        if (checkpoints.is_due_at_end(n_steps, /*in_order=*/false))
          save_checkpoint();
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
          folder.name() + "." +
          how_to_continue(
            scene.loading.fixed_steps ?
              "Loading/Fixed steps=false" :
              "Loading/Smallest step=" +
                Output::number(0.1 * scene.loading.smallest_step)));
      }
    return false;
  }



  template <int dim>
  void
  Simulation<dim>::refuse_long_moves(const double s)
  {
    // points are sent to ranks that own neighbouring cells
    if (!points.are_moving() ||
        dealii::Utilities::MPI::n_mpi_processes(communicator) == 1)
      return;
    std::vector<double> du;
    space.gather(increment, du);
    const auto next = balance->walls(load_at(s));
    // the neighbours of its cells each rank knows
    if (Points::largest_move(
          space, next, du, supports->supports().unseen_dofs) < 1.0)
      return;
    const auto n =
      Points::n_out_of_reach(space, next, du, points, supports->supports());
    if (n == 0)
      return;
    outcome.converged = false;
    outcome.failure =
      std::to_string(n) +
      " points move beyond the neighbours of their rank's cells";
  }



  template <int dim>
  void
  Simulation<dim>::refuse_jump_of_load(const double step)
  {
    if (!scene.loading.opening.controls || load_factor == 0.0)
      return;
    const double found    = balance->load_factor();
    const double expected = load_factor_rate * step;
    const double surprise = std::abs(found - load_factor - expected);
    if (surprise <=
        std::max(0.5 * std::max(std::abs(load_factor), std::abs(found)),
                 3.0 * std::abs(expected)))
      return;
    const std::string jump = "the load factor jumps from " +
                             Output::number(load_factor) + " to " +
                             Output::number(found);
    // Moving points that come into other cells put a body out of balance by
    // an amount that does not shrink with the step.
    if (points.are_moving() || scene.loading.fixed_steps ||
        0.5 * step < scene.loading.smallest_step)
      {
        log.line("  step to s = " + Output::number(load + step) + ": " + jump +
                 ".");
        return;
      }
    outcome.converged = false;
    outcome.failure   = jump + ", perhaps to another balance";
  }



  template <int dim>
  Equilibrium::Outcome
  Simulation<dim>::first_guess(const double step, const bool extrapolated)
  {
    Equilibrium::Outcome guess;
    if (extrapolated)
      {
        extrapolation.predict(step, increment);
        if (scene.loading.opening.controls)
          {
            balance->impose(increment);
            return guess;
          }
        // a kink in what is prescribed must not end in the boundary's cells
        if (balance->mismatch(increment) < 0.1)
          {
            balance->impose(increment);
            return guess;
          }
      }
    if (scene.loading.opening.controls)
      {
        // the first iteration begins with the tangent at zero increment
        increment = 0.0;
        return guess;
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
                            (forces_before * increment)) +
                     balance->plate_work();
    forces_before = balance->external_forces();
    stress_work += balance->stress_work();

    if (points.are_moving())
      Equilibrium::continue_to_unseen(space,
                                      supports->supports().unseen_dofs,
                                      balance->prescribed_dofs(),
                                      balance->walls(
                                        load_at(load + steps.tried())),
                                      increment);
    std::vector<double> du;
    space.gather(increment, du);
    // What a new grid has put out of balance is released in one step: it says
    // nothing about the step's size, nor about how the body moves on.
    const bool on_new_grid = grid_record.imbalance > 0.0;
    extrapolation.accept(steps.tried(), on_new_grid ? guess : increment);
    steps.succeeded(on_new_grid ? std::min(outcome.iterations,
                                           scene.solver.target_iterations) :
                                  outcome.iterations);
    if (scene.loading.opening.controls)
      {
        load_factor_rate =
          (balance->load_factor() - load_factor) / steps.tried();
        load_factor = balance->load_factor();
      }
    load += steps.tried();
    ++n_steps;
    n_floored_points += outcome.residual.sweep.total.floored;
    n_clamped_points += outcome.residual.sweep.total.clamped;
    n_stalled_steps += outcome.stalled;

    if (points.are_moving())
      space.set_frame(balance->walls(present_load()));
    else
      {
        solution += increment;
        space.gather(solution, relevant_solution);
      }
    balance->accept_contacts();
    // of the nodes that were seen in this step
    const auto added = averages(du, supports->supports().unseen_dofs);
    const auto H     = mean_increment();
    supports->accept(relevant_solution,
                     du,
                     balance->point_increments(),
                     points);
    add_boundary_displacements(added);
    if (are_bands_measured())
      observe_peak(H);
    if (points.are_moving() && balance->supports_changed())
      scheme->distrust();
  }



  template <int dim>
  void
  Simulation<dim>::add_boundary_displacements(
    const std::vector<std::vector<double>> &added)
  {
    for (std::size_t b = 0; b < added.size(); ++b)
      for (std::size_t c = 0; c < added[b].size(); ++c)
        boundary_displacements[b][c] += added[b][c];
    measure_free_boundaries();
  }



  template <int dim>
  void
  Simulation<dim>::measure_free_boundaries()
  {
    if (!points.are_moving())
      return;
    const auto extent  = Points::extent(points, communicator);
    const auto is_wall = [this](const std::string &name, const unsigned int d) {
      for (const auto &boundary : scene.boundary_conditions.boundaries)
        if (boundary.name == name)
          return boundary.displacement[d].given();
      return false;
    };
    for (std::size_t b = 0; b < boundary_displacements.size(); ++b)
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



  template class Simulation<2>;
  template class Simulation<3>;
} // namespace Riedel
