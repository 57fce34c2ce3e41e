// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/errors.h>

#include <deal.II/base/bounding_box.h>

#include <set>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Riedel::Adaptation
{
  /// What can make a cell worth refining (doc/adaptation.md).
  enum class Criterion
  {
    rotation_rate,
    shear_rate,
    void_ratio_change,
    gradient_jump,
    region,
    points_per_cell
  };

  /**
   * Section "Adaptation": where the grid is refined while the body is loaded,
   * how far, how often, and when it is made coarse again.
   */
  template <int dim>
  struct Parameters
  {
    /// empty: the grid stays as it is
    std::set<Criterion> criteria;
    /// most refinements on top of the grid of section "Grid"
    unsigned int levels = 0;
    /// edge of a cell where a criterion holds, in multiples of d50; 0: the
    /// levels alone limit the refinement
    double cell_size = 0.0;
    /// steps between two looks at the criteria
    unsigned int every_steps = 2;
    /// layers of cells around those where a criterion holds
    unsigned int buffer_layers = 1;
    /// cells that reach this share of no threshold are made coarse; 0: never
    double coarsen_below = 0.0;
    /// steps between two looks for cells to be made coarse
    unsigned int coarsen_every = 20;
    /// refined before the first step, and kept so
    bool zones_initially = false, random_field_initially = false;

    /// where a criterion begins to hold
    struct Thresholds
    {
      double rotation_rate     = 0.0; ///< times the nominal rate
      double shear_rate        = 0.0; ///< times the nominal rate
      double void_ratio_change = 0.0; ///< absolute value since the start
      double gradient_jump     = 0.0; ///< times the nominal rate
      double points_per_cell   = 0.0;
    } thresholds;

    /// A box of the undeformed body that is refined before the first step and
    /// stays so.
    struct Region
    {
      std::string              name;
      dealii::BoundingBox<dim> box;
    };
    std::vector<Region> regions;

    bool
    is_on() const
    {
      return !criteria.empty();
    }

    bool
    has(const Criterion criterion) const
    {
      return criteria.count(criterion) > 0;
    }

    static void
    declare(dealii::ParameterHandler       &prm,
            const std::vector<std::string> &region_names);
    void
    parse(dealii::ParameterHandler       &prm,
          const std::vector<std::string> &region_names);
    /// The rules of this section; @p micropolar, @p has_void_ratio: what the
    /// laws have; @p length: smallest length of a law, d50 [m], 0 if none has
    /// one; @p points_move: false in configuration "initial".
    void
    check(const bool   micropolar,
          const bool   has_void_ratio,
          const double length,
          const bool   points_move,
          Problems    &problems) const;
  };
} // namespace Riedel::Adaptation
