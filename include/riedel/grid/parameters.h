// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/errors.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Riedel::Grid
{
  /// How the strain-like increments H and theta of a point are sampled
  /// (doc/theory/elements.md).
  enum class StrainSampling
  {
    full,            ///< at the point itself
    mean_dilatation, ///< volume part from the cell's mean
    assumed          ///< H and theta from fewer sampling points of the cell
  };

  enum class ReferenceConfiguration
  {
    initial, ///< shape functions on the undeformed grid: finite elements
    current  ///< on a grid that is put back after every step, through which the
             ///< points move: material point method
  };

  /// Section "Geometry": the body before the first step.
  struct GeometryParameters
  {
    /// dimension of the scene, set by parse()
    unsigned int dimension = 2;
    /// edge lengths of the box [m]; empty if the grid comes from a file
    std::vector<double> box;
    /// its lower left corner [m]
    std::vector<double> origin;
    /// a grid file (Gmsh .msh, UCD .inp, VTK .vtk); empty: a box
    std::string file;
    /// boundary id -> name. A box has left, right, bottom, top (, front, back)
    std::map<unsigned int, std::string> boundary_names;
    /// names of those that are arcs of a circle or parts of a sphere
    std::vector<std::string> round_boundaries;

    static void
    declare(dealii::ParameterHandler &prm);
    void
    parse(dealii::ParameterHandler &prm, const unsigned int dim);
    void
    check(Problems &problems) const;

    /// All boundary names, sorted by their id.
    std::vector<std::string>
    names() const;
  };

  /// Section "Grid".
  struct Parameters
  {
    /// cells of the box along each axis
    std::vector<unsigned int> cells;
    /// cells beyond the body, before each lower and behind each upper side:
    /// left, right, [front, back,] bottom, top; empty or all 0 for none
    std::vector<unsigned int> margin;
    /// uniform refinements of the grid of a file
    unsigned int           refinements   = 0;
    ReferenceConfiguration configuration = ReferenceConfiguration::initial;
    /// the axis along which the body repeats itself: what leaves it at one end
    /// comes in at the other
    std::optional<unsigned int> periodic_axis;
    /// polynomial degrees, 1 or 2; "automatic" is 2 in configuration initial
    /// of the plane, else 1
    unsigned int   displacement_degree = 2;
    unsigned int   rotation_degree     = 2;
    StrainSampling sampling            = StrainSampling::assumed;
    /// share of the point's own H and theta under assumed sampling
    double own_strain_fraction = 0.1;

    /// Is this side of the box, numbered as in #margin, tied to the opposite
    /// one?
    bool
    is_periodic(const unsigned int side) const
    {
      return periodic_axis && *periodic_axis == side / 2;
    }

    /// Does the grid end at this side of the body? Sides as in #margin.
    bool
    ends_at(const unsigned int side) const
    {
      return margin.empty() || margin[side] == 0;
    }

    static void
    declare(dealii::ParameterHandler &prm);
    /// @p dim: dimension of the scene
    void
    parse(dealii::ParameterHandler &prm, const unsigned int dim);
    void
    check(const GeometryParameters &geometry, Problems &problems) const;
  };
} // namespace Riedel::Grid
