// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/scene/command_line.h>
#include <riedel/scene/scene.h>

namespace Riedel
{
  /// Computes what the scene asks for, on all ranks of MPI_COMM_WORLD, into a
  /// results folder; returns the program's exit code. Throws InputError or
  /// ComputationError, on all ranks together.
  template <int dim>
  int
  run(const Scene::Scene<dim> &scene, const Scene::CommandLine &options);
} // namespace Riedel
