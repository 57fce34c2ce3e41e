// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/checkpoint/checkpoints.h>
#include <riedel/checkpoint/metadata.h>
#include <riedel/errors.h>
#include <riedel/version.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>
#include <deal.II/distributed/solution_transfer.h>

#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <ctime>
#include <fstream>
#include <functional>
#include <iterator>

namespace Riedel::Checkpoint
{
  namespace
  {
    namespace fs  = std::filesystem;
    namespace MPI = dealii::Utilities::MPI;

    const std::string state_file = "state";
    const std::string grid_file  = "grid";



    std::string
    local_time()
    {
      const std::time_t now = std::time(nullptr);
      char              text[32];
      std::strftime(text,
                    sizeof text,
                    "%Y-%m-%d %H:%M:%S",
                    std::localtime(&now));
      return text;
    }



    /// About as many bytes as a checkpoint has, or some more.
    template <int dim>
    std::uintmax_t
    size(const typename Checkpoints<dim>::Bodies &bodies)
    {
      constexpr std::uintmax_t head = 100000, per_cell = 100, per_point = 50;
      return head +
             bodies.points.particles().n_global_particles() *
               (per_point + 8 * bodies.points.layout().size()) +
             bodies.triangulation.n_global_active_cells() *
               (per_cell + 8 * bodies.vectors.size() *
                             bodies.space.element().n_dofs_per_cell());
    }



    /// Does @p work on rank 0; what it says if the disk refuses, on all ranks.
    std::string
    try_on_first_rank(const MPI_Comm               communicator,
                      const std::function<void()> &work)
    {
      std::string error;
      if (MPI::this_mpi_process(communicator) == 0)
        try
          {
            work();
          }
        catch (const fs::filesystem_error &reason)
          {
            error =
              reason.path1().string() + ": " + reason.code().message() + ".";
          }
      return MPI::broadcast(communicator, error, 0);
    }
  } // namespace



  template <int dim>
  Checkpoints<dim>::Checkpoints(const MPI_Comm              communicator,
                                const std::string          &results,
                                const Parameters           &parameters,
                                const std::vector<Setting> &settings)
    : communicator(communicator)
    , is_first_rank(MPI::this_mpi_process(communicator) == 0)
    , results(results)
    , parameters(parameters)
    , settings(settings)
    , store(results)
    , last_time(std::chrono::steady_clock::now())
  {}



  template <int dim>
  double
  Checkpoints<dim>::minutes_since_last() const
  {
    const std::chrono::duration<double> seconds =
      std::chrono::steady_clock::now() - last_time;
    return MPI::broadcast(communicator, seconds.count() / 60.0, 0);
  }



  template <int dim>
  bool
  Checkpoints<dim>::is_due(const unsigned int step)
  {
    if (step == last_step)
      return false;
    return (parameters.every_steps > 0 && step % parameters.every_steps == 0) ||
           (parameters.every_minutes > 0.0 &&
            minutes_since_last() >= parameters.every_minutes);
  }



  template <int dim>
  bool
  Checkpoints<dim>::is_due_at_end(const unsigned int step,
                                  const bool         in_order) const
  {
    return parameters.enabled() && step != last_step &&
           (!in_order || !last_name.empty());
  }



  template <int dim>
  std::string
  Checkpoints<dim>::write(const unsigned int step,
                          const double       load,
                          const std::string &state,
                          const Bodies      &bodies)
  {
    fs::path    folder;
    std::string error = try_on_first_rank(communicator, [&]() {
      folder = store.begin();
      // p4est would end the program
      if (fs::space(folder).available < size<dim>(bodies))
        throw fs::filesystem_error(
          "write", folder, std::make_error_code(std::errc::no_space_on_device));
      std::ofstream stream(folder / state_file, std::ios::binary);
      stream.write(state.data(), state.size());
      if (!stream.flush())
        throw fs::filesystem_error("write",
                                   folder / state_file,
                                   std::make_error_code(std::errc::io_error));
    });
    if (error.empty())
      {
        const auto &space = bodies.space;
        // deal.II reads the values of ghosts, too
        std::vector<LinearAlgebra::Vector> ghosted;
        for (const LinearAlgebra::Vector *vector : bodies.vectors)
          {
            ghosted.emplace_back(space.owned(), space.relevant(), communicator);
            if (vector->size() > 0)
              ghosted.back() = *vector;
          }
        std::vector<const LinearAlgebra::Vector *> pointers;
        for (const LinearAlgebra::Vector &vector : ghosted)
          pointers.push_back(&vector);

        dealii::parallel::distributed::SolutionTransfer<dim,
                                                        LinearAlgebra::Vector>
          transfer(space.dof_handler());
        transfer.prepare_for_serialization(pointers);
        bodies.points.prepare_to_save();
        bodies.triangulation.save(
          (MPI::broadcast(communicator, folder.string(), 0) + "/") + grid_file);

        Metadata metadata;
        metadata.version = RIEDEL_VERSION;
        metadata.written = local_time();
        metadata.step    = step;
        metadata.load    = load;
        metadata.ranks   = MPI::n_mpi_processes(communicator);
        metadata.cells   = bodies.triangulation.n_global_active_cells();
        metadata.points  = bodies.points.particles().n_global_particles();
        for (const Setting &setting : settings)
          metadata.parameters.emplace_back(setting.path, setting.value);
        error = try_on_first_rank(communicator, [&]() {
          metadata.write(folder);
          last_name = store.publish(step, parameters.keep);
        });
      }
    last_name = MPI::broadcast(communicator, last_name, 0);
    // after an error it is tried again when the next one is due
    last_step = step;
    last_time = std::chrono::steady_clock::now();
    return error.empty() ? error : "No checkpoint could be written: " + error;
  }



  template <int dim>
  typename Checkpoints<dim>::Found
  Checkpoints<dim>::find() const
  {
    Found       found;
    std::string error;
    const auto  search = [&]() {
      for (const std::string &name : store.candidates())
        try
          {
            const Metadata metadata = Metadata::read(store.path(name));
            for (const std::string &change :
                 forbidden_changes(metadata.parameters, settings))
              error += "\n  " + change;
            if (!error.empty())
              error = "The checkpoint " + store.path(name).string() +
                      " was computed with other parameters:" + error +
                      "\nA resumed run must have the same ones. Set them "
                       "back, or start a new run in another folder with --set "
                       "\"Results=name\".\nWhat may change: Title, Results, "
                       "Loading/Stop, the sizes of the steps, and the sections "
                       "Solver, Output and Checkpoint.";
            found.name  = name;
            found.step  = metadata.step;
            found.load  = metadata.load;
            found.ranks = metadata.ranks;
            return;
          }
        catch (const std::runtime_error &reason)
          {
            found.warnings.push_back("The checkpoint " +
                                     store.path(name).string() +
                                     " cannot be used: " + reason.what() + ".");
          }
      for (const std::string &warning : found.warnings)
        error += warning + "\n";
      error += "Results: the folder \"" + results +
               "\" has no checkpoint to resume from. Start the run again with "
                "--overwrite; the section Checkpoint says how often one is "
                "written.";
    };
    const std::string refusal = try_on_first_rank(communicator, search);
    error = MPI::broadcast(communicator, error, 0) + refusal;
    if (!error.empty())
      throw InputError(error);
    found.name     = MPI::broadcast(communicator, found.name, 0);
    found.step     = MPI::broadcast(communicator, found.step, 0);
    found.load     = MPI::broadcast(communicator, found.load, 0);
    found.ranks    = MPI::broadcast(communicator, found.ranks, 0);
    found.warnings = MPI::broadcast(communicator, found.warnings, 0);
    return found;
  }



  template <int dim>
  void
  Checkpoints<dim>::return_to(const Found &found)
  {
    const std::string error =
      try_on_first_rank(communicator, [&]() { store.return_to(found.name); });
    if (!error.empty())
      throw InputError("The run cannot be resumed: " + error);
    last_name = found.name;
    last_step = found.step;
    last_time = std::chrono::steady_clock::now();
  }



  template <int dim>
  std::string
  Checkpoints<dim>::read_state(const std::string &name) const
  {
    std::string state;
    if (is_first_rank)
      {
        std::ifstream stream(store.path(name) / state_file, std::ios::binary);
        state.assign(std::istreambuf_iterator<char>(stream), {});
      }
    return MPI::broadcast(communicator, state, 0);
  }



  template <int dim>
  void
  Checkpoints<dim>::read_bodies(const std::string &name,
                                const Bodies      &bodies) const
  {
    auto &triangulation = bodies.triangulation;
    auto &space         = bodies.space;
    bodies.points.remove_all();
    // deal.II builds the saved grid from the coarse one
    while (triangulation.n_global_levels() > 1)
      triangulation.coarsen_global();
    triangulation.load((store.path(name) / grid_file).string());
    space.distribute();

    for (LinearAlgebra::Vector *vector : bodies.vectors)
      *vector = space.owned_vector();
    dealii::parallel::distributed::SolutionTransfer<dim, LinearAlgebra::Vector>
                                         transfer(space.dof_handler());
    std::vector<LinearAlgebra::Vector *> vectors = bodies.vectors;
    transfer.deserialize(vectors);
    bodies.points.load();
  }



  template class Checkpoints<2>;
  template class Checkpoints<3>;
} // namespace Riedel::Checkpoint
