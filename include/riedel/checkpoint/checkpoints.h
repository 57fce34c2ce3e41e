// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/checkpoint/changes.h>
#include <riedel/checkpoint/parameters.h>
#include <riedel/checkpoint/store.h>
#include <riedel/grid/space.h>
#include <riedel/linear_algebra.h>
#include <riedel/points/material_points.h>

#include <deal.II/distributed/tria.h>

#include <chrono>
#include <string>
#include <vector>

namespace Riedel::Checkpoint
{
  /**
   * Writes and reads the state of a run (doc/checkpoint.md). A checkpoint has
   * the grid with vectors of dofs and the points, which deal.II redistributes
   * on any number of ranks, and a text of bytes that the run packs itself
   * (archive.h).
   *
   * All functions are collective.
   */
  template <int dim>
  class Checkpoints
  {
  public:
    /// What deal.II writes and reads. Vectors without entries are read as
    /// zeros.
    struct Bodies
    {
      dealii::parallel::distributed::Triangulation<dim> &triangulation;
      Grid::Space<dim>                                  &space;
      Points::MaterialPoints<dim>                       &points;
      std::vector<LinearAlgebra::Vector *>               vectors;
    };

    /// What find() has found.
    struct Found
    {
      std::string  name;
      unsigned int step  = 0;
      double       load  = 0.0;
      unsigned int ranks = 0; ///< that wrote it
      /// checkpoints that were passed over, and why: sentences
      std::vector<std::string> warnings;
    };

    /// @p results: the folder of the run; @p settings: all its parameters.
    Checkpoints(const MPI_Comm              communicator,
                const std::string          &results,
                const Parameters           &parameters,
                const std::vector<Setting> &settings);

    /// Is there none of @p step yet, and is it time for one?
    bool
    is_due(const unsigned int step);

    /// Should a run that ends after @p step leave its state behind?
    /// @p in_order: it has reached its end; if that came before the first
    /// checkpoint was due, it needs none.
    bool
    is_due_at_end(const unsigned int step, const bool in_order) const;

    /// Writes a checkpoint; see Bodies and archive.h. Returns an empty text, or
    /// a sentence about a disk that refused: the run can go on.
    std::string
    write(const unsigned int step,
          const double       load,
          const std::string &state,
          const Bodies      &bodies);

    /// The checkpoint to resume from: the last one that is complete. Throws
    /// InputError if there is none, or if a parameter differs that may not.
    Found
    find() const;

    /// The run goes on from this one: newer ones are removed.
    void
    return_to(const Found &found);

    /// Name of the last one that was written or returned to.
    const std::string &
    last() const
    {
      return last_name;
    }

    /// The packed state in a checkpoint.
    std::string
    read_state(const std::string &name) const;

    /// Grid, dofs, vectors and points of a checkpoint in the place of the
    /// present ones. The points' bookkeeping must have been unpacked before.
    void
    read_bodies(const std::string &name, const Bodies &bodies) const;

  private:
    double
    minutes_since_last() const;

    const MPI_Comm                        communicator;
    const bool                            is_first_rank;
    const std::string                     results;
    const Parameters                      parameters;
    const std::vector<Setting>            settings;
    const Store                           store;
    std::string                           last_name;
    unsigned int                          last_step = 0;
    std::chrono::steady_clock::time_point last_time;
  };
} // namespace Riedel::Checkpoint
