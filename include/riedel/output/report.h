// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/output/rows.h>
#include <riedel/timer.h>

#include <string>

namespace Riedel::Output
{
  /// The first lines of a run: program, case, folder, ranks.
  std::string
  banner(const std::string &title,
         const std::string &case_file,
         const std::string &folder,
         const MPI_Comm     communicator);

  /// Column heads of step_line(); @p watched describes the force.
  std::string
  step_header(const std::string &watched, const unsigned int dim);

  /// A line per step for the terminal.
  template <int dim>
  std::string
  step_line(const StepRecord<dim> &record, const double force);

  /// A number with as many digits as a person wants to read.
  std::string
  number(const double value);

  /// The last lines of a run: counts, speed of the laws, memory, and where the
  /// time went. Collective.
  template <int dim>
  std::string
  summary(const StepRecord<dim>                           &record,
          const std::size_t                                floored,
          const std::size_t                                clamped,
          const unsigned int                               stalled,
          const typename Equilibrium::Assembly<dim>::Cost &law_cost,
          const Timer                                     &timer,
          const double                                     wall_seconds,
          const MPI_Comm                                   communicator);

  /// The measured bands in a line, or that there are none.
  std::string
  bands_line(const Analysis::ShearBands &bands, const double grain_size);
} // namespace Riedel::Output
