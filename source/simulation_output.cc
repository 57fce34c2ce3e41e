// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/analysis/deformed_field.h>
#include <riedel/continuum/mobilised_friction.h>
#include <riedel/output/report.h>
#include <riedel/output/rows.h>
#include <riedel/points/point_sums.h>
#include <riedel/simulation.h>

#include <deal.II/base/mpi.h>

#include <cmath>

/*
 * What a Simulation measures, writes and says, and when.
 */
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
  void
  Simulation<dim>::say_hello()
  {
    log.line(Output::banner(
      scene.general.title, scene.file, folder.name(), communicator));
    for (const std::string &warning : scene.warnings)
      log.line("Warning: " + warning);
    log.line(std::to_string(body.triangulation().n_global_active_cells()) +
             " cells, " + std::to_string(space.dof_handler().n_dofs()) +
             " unknowns.");
  }



  template <int dim>
  bool
  Simulation<dim>::are_bands_measured() const
  {
    return dim == 2 && grain_size > 0.0 && scene.output.bands_every > 0.0;
  }



  template <int dim>
  std::array<double, 4>
  Simulation<dim>::mean_increment() const
  {
    std::array<double, 4> H{};
    if constexpr (dim == 2)
      if (are_bands_measured())
        H = Analysis::mean_gradient(points,
                                    balance->point_increments(),
                                    communicator);
    return H;
  }



  template <int dim>
  void
  Simulation<dim>::observe_peak(const std::array<double, 4> &H)
  {
    if constexpr (dim == 2)
      {
        const auto   stress   = Analysis::mean_stress(points, communicator);
        const double friction = Continuum::mobilised_friction(stress.data());
        if (!(friction <= peak.friction))
          peak = {friction, Analysis::dilatancy_angle(H)};
      }
    else
      (void)H;
  }



  template <int dim>
  void
  Simulation<dim>::measure_bands()
  {
    if (!are_bands_measured() ||
        !(is_complete() ||
          passed_mark(last_bands, load, scene.output.bands_every)))
      return;
    const Timer::Scope scope(timer, "measurement of bands");
    last_bands = load;

    if constexpr (dim == 2)
      {
        const auto field =
          Analysis::collect_deformed_field(space, shown_solution(), points);
        const auto stress = Analysis::mean_stress(points, communicator);
        Analysis::BandMeasureOptions options;
        options.grain_size = grain_size;
        if (is_first_rank)
          {
            const auto before = std::move(bands);
            bands             = Analysis::measure_shear_bands(field, options);
            const Output::BandAngles angles = {
              Analysis::angle_to_minor_stress(bands, stress),
              peak,
              {bands.friction, Analysis::dilatancy_inside(before, bands)}};
            bands_table.add(
              Output::bands_row(n_steps, load, bands, angles, grain_size));
          }
      }
  }



  template <int dim>
  void
  Simulation<dim>::record_step()
  {
    const auto record = make_record();
    history.add(Output::history_row(record));
    log.line(Output::step_line(record, watch.force(record.reactions)));
    const auto &loading = scene.loading;
    log.progress((load - loading.start) / (loading.stop - loading.start),
                 wall_seconds());
  }



  template <int dim>
  void
  Simulation<dim>::write_fields()
  {
    if (n_steps > 0 && !is_complete() &&
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
             Points::nodal_values(space, points, supports->supports()) :
             relevant_solution;
  }



  template <int dim>
  bool
  Simulation<dim>::is_complete() const
  {
    return load > scene.loading.stop - mark_tolerance;
  }



  template <int dim>
  double
  Simulation<dim>::next_mark(const double every) const
  {
    // what is prescribed may have a kink where a stage before the loading ends
    const double end = load < -mark_tolerance ? 0.0 : scene.loading.stop;
    if (every == 0.0)
      return end;
    const double next =
      every * (std::floor(load / every + mark_tolerance) + 1.0);
    return std::min(next, end);
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
    const auto record   = make_record();
    auto       law_cost = earlier_law_cost;
    law_cost += balance->law_cost();
    log.line(Output::summary(record,
                             n_floored_points,
                             n_clamped_points,
                             n_stalled_steps,
                             law_cost,
                             timer,
                             wall_seconds() - earlier.wall,
                             communicator));
    if (last_bands > scene.loading.start)
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
    if (scene.loading.opening.controls)
      record.controlled = {load_factor,
                           load * scene.loading.opening.final_opening};
    for (const auto &boundary : scene.boundary_conditions.boundaries)
      record.supported.push_back(boundary.name);
    record.reactions = balance->reactions();
    Output::add_plates(balance->plate_reports(), record);
    record.external_work  = external_work;
    record.stress_work    = stress_work;
    record.outcome        = outcome;
    const Spent total     = spent();
    record.sweeps         = total.sweeps;
    record.factorisations = total.factorisations;
    record.linear         = total.linear;
    record.n_bands        = bands.bands.size();
    record.cpu_seconds    = total.cpu;
    if (adaptivity.is_on())
      record.grid = grid_record;
    Output::sum_up_points(points, communicator, record);
    return record;
  }



  template <int dim>
  typename Simulation<dim>::Spent
  Simulation<dim>::spent() const
  {
    Spent total = earlier;
    total.cpu +=
      dealii::Utilities::MPI::sum(Timer::cpu_seconds(), communicator);
    total.wall = wall_seconds();
    total.sweeps += balance->n_sweeps;
    total.factorisations += balance->n_factorisations;
    total.linear += balance->linear_counts();
    return total;
  }



  template <int dim>
  double
  Simulation<dim>::wall_seconds() const
  {
    return earlier.wall + std::chrono::duration<double>(
                            std::chrono::steady_clock::now() - wall_start)
                            .count();
  }



  template void
  Simulation<2>::say_hello();
  template bool
  Simulation<2>::are_bands_measured() const;
  template std::array<double, 4>
  Simulation<2>::mean_increment() const;
  template void
  Simulation<2>::observe_peak(const std::array<double, 4> &);
  template void
  Simulation<2>::measure_bands();
  template void
  Simulation<2>::record_step();
  template void
  Simulation<2>::write_fields();
  template std::vector<double>
  Simulation<2>::shown_solution() const;
  template bool
  Simulation<2>::is_complete() const;
  template double
  Simulation<2>::next_mark(const double) const;
  template void
  Simulation<2>::finish();
  template Output::StepRecord<2>
  Simulation<2>::make_record() const;
  template Simulation<2>::Spent
  Simulation<2>::spent() const;
  template double
  Simulation<2>::wall_seconds() const;
  template void
  Simulation<3>::say_hello();
  template bool
  Simulation<3>::are_bands_measured() const;
  template std::array<double, 4>
  Simulation<3>::mean_increment() const;
  template void
  Simulation<3>::observe_peak(const std::array<double, 4> &);
  template void
  Simulation<3>::measure_bands();
  template void
  Simulation<3>::record_step();
  template void
  Simulation<3>::write_fields();
  template std::vector<double>
  Simulation<3>::shown_solution() const;
  template bool
  Simulation<3>::is_complete() const;
  template double
  Simulation<3>::next_mark(const double) const;
  template void
  Simulation<3>::finish();
  template Output::StepRecord<3>
  Simulation<3>::make_record() const;
  template Simulation<3>::Spent
  Simulation<3>::spent() const;
  template double
  Simulation<3>::wall_seconds() const;
} // namespace Riedel
