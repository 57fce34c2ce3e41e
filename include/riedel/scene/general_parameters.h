// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/errors.h>

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Riedel::Scene
{
  enum class SimulationType
  {
    boundary_value_problem, ///< a body with boundaries
    element_test            ///< one material point on a prescribed path
  };

  /// The parameters outside all sections.
  struct GeneralParameters
  {
    /// one line for people, in the head of the log
    std::string    title;
    unsigned int   dimension = 2;
    SimulationType type      = SimulationType::boundary_value_problem;
    /// folder for everything a run writes, relative to the working directory
    std::string results = "results";

    static void
    declare(dealii::ParameterHandler &prm);
    void
    parse(dealii::ParameterHandler &prm);
    void
    check(Problems &problems) const;
  };
} // namespace Riedel::Scene
