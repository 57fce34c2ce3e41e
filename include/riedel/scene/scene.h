// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/adaptation/parameters.h>
#include <riedel/checkpoint/parameters.h>
#include <riedel/element_test/parameters.h>
#include <riedel/equilibrium/parameters.h>
#include <riedel/equilibrium/plate_parameters.h>
#include <riedel/errors.h>
#include <riedel/grid/parameters.h>
#include <riedel/material/parameters.h>
#include <riedel/output/parameters.h>
#include <riedel/points/parameters.h>
#include <riedel/scene/declared_parameters.h>
#include <riedel/scene/general_parameters.h>

#include <string>
#include <utility>
#include <vector>

namespace Riedel::Scene
{
  /// The names that users choose, in the order of the file.
  struct Names
  {
    /// materials and the laws they ask for
    std::vector<std::pair<std::string, std::string>> materials;
    std::vector<std::string>                         zones;
    std::vector<std::string>                         regions;
    std::vector<std::string>                         boundaries;
    std::vector<std::string>                         plates;
  };

  /// Everything an input file says: the parameters of every room.
  template <int dim>
  struct Scene
  {
    GeneralParameters                             general;
    Grid::GeometryParameters                      geometry;
    Grid::Parameters                              grid;
    Material::Parameters<dim>                     materials;
    Points::MovingPointsParameters                moving_points;
    Points::InitialStateParameters<dim>           initial_state;
    Equilibrium::BoundaryConditionParameters<dim> boundary_conditions;
    Equilibrium::PlatesParameters<dim>            plates;
    Equilibrium::LoadingParameters<dim>           loading;
    Equilibrium::SolverParameters                 solver;
    Adaptation::Parameters<dim>                   adaptation;
    Output::Parameters                            output;
    Checkpoint::Parameters                        checkpoint;
    ElementTest::Parameters                       element_test;

    /// the case file as the user named it
    std::string file;
    /// what the user should know, ready to be printed
    std::vector<std::string> warnings;
    /// all parameters with their effective values
    std::vector<DeclaredParameter> parameters;
    /// the input as it was given, included files in their place
    std::string original_text;

    static void
    declare(dealii::ParameterHandler &prm, const Names &names);

    /// Throws ParameterError for a value that cannot be used.
    void
    parse(dealii::ParameterHandler &prm, const Names &names);

    /// The rules of every room and those between rooms.
    void
    check(Problems &problems) const;
  };

  /// What a case file and the overrides say of Dimension; 2 if they say
  /// nothing that can be used, which read_scene() then explains. Throws an
  /// InputError if the file cannot be read.
  unsigned int
  dimension_of(const std::string              &file,
               const std::vector<std::string> &overrides);

  /**
   * Reads a case file and the overrides "Section/Parameter=value" of the
   * command line. Throws an InputError whose text names every mistake that was
   * found with its place. It computes nothing and does not communicate: every
   * rank gets the same scene or the same error.
   */
  template <int dim>
  Scene<dim>
  read_scene(const std::string              &file,
             const std::vector<std::string> &overrides);

  /// All parameters there are, with one material for each known law, one zone,
  /// one boundary, one plate and one region.
  std::vector<DeclaredParameter>
  all_parameters();
} // namespace Riedel::Scene
