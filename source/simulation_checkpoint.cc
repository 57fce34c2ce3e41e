// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/checkpoint/archive.h>
#include <riedel/output/report.h>
#include <riedel/simulation.h>

#include <deal.II/base/mpi.h>

/*
 * How a Simulation is saved and resumed.
 */
namespace Riedel
{
  // What is added here changes the format:
  // Checkpoint::Metadata::present_format.
  template <int dim>
  template <class Archive>
  void
  Simulation<dim>::exchange(Archive &archive)
  {
    archive &n_steps &load &steps &extrapolation &points;
    archive &load_factor                         &load_factor_rate;

    Grid::Frame<dim> frame = space.frame();
    archive         &frame;
    space.set_frame(frame);

    archive &grid_record &last_look;

    archive &external_work &stress_work &boundary_displacements;

    archive &n_floored_points &n_clamped_points &n_stalled_steps;

    archive &bands &peak &last_bands &last_fields &fields &history &bands_table;
  }



  template <int dim>
  typename Checkpoint::Checkpoints<dim>::Bodies
  Simulation<dim>::bodies()
  {
    std::vector<LinearAlgebra::Vector *> vectors = {&solution, &forces_before};
    for (LinearAlgebra::Vector *vector : extrapolation.vectors())
      vectors.push_back(vector);
    return {body.triangulation(), space, points, vectors};
  }



  template <int dim>
  bool
  Simulation<dim>::save_checkpoint()
  {
    const Timer::Scope scope(timer, "checkpoints");
    Spent              total = spent();
    const std::string  state = Checkpoint::pack([&](auto &archive) {
      exchange(archive);
      archive &total;
    });
    const std::string error = checkpoints.write(n_steps, load, state, bodies());
    if (!error.empty())
      log.line("Warning: " + error);
    return error.empty();
  }



  template <int dim>
  void
  Simulation<dim>::load_checkpoint(const std::string &name)
  {
    const bool is_resumed = !balance;
    if (balance)
      earlier_law_cost += balance->law_cost();
    {
      const Timer::Scope scope(timer, "checkpoints");
      // factors, secant pairs and the like are not part of the state
      scheme.reset();
      balance.reset();
      Spent total;
      Checkpoint::unpack(checkpoints.read_state(name), [&](auto &archive) {
        exchange(archive);
        archive &total;
      });
      if (is_resumed)
        earlier = total;
      earlier.sweeps         = total.sweeps;
      earlier.factorisations = total.factorisations;
      earlier.linear         = total.linear;
      checkpoints.read_bodies(name, bodies());
    }
    prepare();
  }



  template <int dim>
  void
  Simulation<dim>::resume()
  {
    const auto found = checkpoints.find();
    load_checkpoint(found.name);

    // nothing in the folder has been changed up to here
    checkpoints.return_to(found);
    say_hello();
    for (const std::string &warning : found.warnings)
      log.line("Warning: " + warning);
    if (is_first_rank)
      {
        folder.write_inputs();
        fields.resume();
        for (Output::Table *table : {&history, &bands_table})
          if (!table->resume())
            log.line("Warning: a table has lost rows before the checkpoint: " +
                     table->file_name() + ".");
      }
    log.line(
      "Resumed at s = " + Output::number(load) + ", step " +
      std::to_string(n_steps) + ", from the checkpoint " + found.name +
      (found.ranks == dealii::Utilities::MPI::n_mpi_processes(communicator) ?
         "." :
         ", which was written on " + std::to_string(found.ranks) +
           (found.ranks == 1 ? " rank: " : " ranks: ") +
           "results differ by rounding errors."));
    if (is_complete())
      log.line("Loading/Stop = " + Output::number(scene.loading.stop) +
               " has been reached: a larger one lets the run go on.");
    log.line(Output::step_header(watch.description(), dim));
  }



  template <int dim>
  std::string
  Simulation<dim>::how_to_continue(const std::string &change) const
  {
    if (checkpoints.last().empty())
      return "";
    return "\nThe run goes on from there with\n  riedel " + scene.file +
           " --resume" + (change.empty() ? "" : " --set \"" + change + "\"") +
           "\nand the --set options of now. Sizes of steps and the solver may be "
           "changed.";
  }



  template void
  Simulation<2>::resume();
  template bool
  Simulation<2>::save_checkpoint();
  template void
  Simulation<2>::load_checkpoint(const std::string &);
  template std::string
  Simulation<2>::how_to_continue(const std::string &) const;
  template void
  Simulation<3>::resume();
  template bool
  Simulation<3>::save_checkpoint();
  template void
  Simulation<3>::load_checkpoint(const std::string &);
  template std::string
  Simulation<3>::how_to_continue(const std::string &) const;
} // namespace Riedel
