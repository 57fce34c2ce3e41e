// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/checkpoint/parameters.h>

#include <deal.II/base/parameter_handler.h>

namespace Riedel::Checkpoint
{
  namespace Patterns = dealii::Patterns;

  void
  Parameters::declare(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Checkpoint");
    prm.declare_entry("Every steps",
                      "0",
                      Patterns::Integer(0),
                      "Load steps between two checkpoints, from which "
                      "\"riedel case.prm --resume\" goes on; 0: only by the "
                      "clock.");
    prm.declare_entry("Every minutes",
                      "10",
                      Patterns::Double(0),
                      "Minutes (wall clock) between two checkpoints; 0: only "
                      "by steps. If both are 0, no checkpoint is written.");
    prm.declare_entry("Keep",
                      "2",
                      Patterns::Integer(1),
                      "Number of checkpoints that stay on the disk: the last "
                      "ones.");
    prm.leave_subsection();
  }



  void
  Parameters::parse(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Checkpoint");
    every_steps   = static_cast<unsigned int>(prm.get_integer("Every steps"));
    every_minutes = prm.get_double("Every minutes");
    keep          = static_cast<unsigned int>(prm.get_integer("Keep"));
    prm.leave_subsection();
  }
} // namespace Riedel::Checkpoint
