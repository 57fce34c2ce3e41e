// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/errors.h>

#include <deal.II/base/bounding_box.h>

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Riedel::Points
{
  /// How a point of the configuration "current" sees the grid.
  enum class Shape
  {
    generalised, ///< means over its box (GIMP)
    point        ///< the shape functions at its place: the plain method
  };

  /// Section "Material points", for the configuration "current".
  struct MovingPointsParameters
  {
    Shape shape = Shape::generalised;
    /// points of a cell along each axis at the start
    unsigned int per_axis = 2;
    /// factor of the penalty that holds badly filled cells at the surface
    double surface_stabilisation = 0.1;
    /// points that leave the grid are removed and counted; else they stop the
    /// run
    bool remove_leaving = false;
    /// points of cells with more than these are merged; 0: never
    unsigned int merge_above = 12;
    /// how much states of points that are merged may differ, relative
    double merge_tolerance = 0.05;

    static void
    declare(dealii::ParameterHandler &prm);
    void
    parse(dealii::ParameterHandler &prm);
  };

  /**
   * Section "Initial state": the vertical stress sigma_22 = -(p + gamma_d (h -
   * x_2)) with gamma_d = gamma_s/(1 + e0) of the uniform void ratio e0 and h
   * the height of the body's top, sigma_11 = sigma_33 = K0 sigma_22. Zones and
   * the random field change the void ratio only (and so the mass of a point).
   */
  template <int dim>
  struct InitialStateParameters
  {
    double void_ratio        = 0.0;
    double pressure_at_top   = 0.0; ///< Pa, compression positive
    double grain_unit_weight = 0.0; ///< gamma_s [N/m3]
    double K0                = 1.0;

    /// A box with another void ratio; the last of overlapping zones counts.
    struct Zone
    {
      std::string              name;
      dealii::BoundingBox<dim> box;
      double                   void_ratio;
    };
    std::vector<Zone> zones;

    /// Void ratio e0 + amplitude r in square cells of edge cell_size, r uniform
    /// in (0.01, 0.99), from the seed and the cell's place only: the same on
    /// every grid and any number of ranks. Zones overrule it.
    struct RandomField
    {
      double       amplitude = 0.0; ///< 0: no random field
      double       cell_size = 0.0; ///< m
      unsigned int seed      = 1;
    } random_field;

    static void
    declare(dealii::ParameterHandler       &prm,
            const std::vector<std::string> &zone_names);
    void
    parse(dealii::ParameterHandler       &prm,
          const std::vector<std::string> &zone_names);
    /// Rules that need no laws and no grid.
    void
    check(Problems &problems) const;
  };
} // namespace Riedel::Points
