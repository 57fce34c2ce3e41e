// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/errors.h>
#include <riedel/expression.h>

#include <deal.II/base/bounding_box.h>

#include <array>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Riedel::Equilibrium
{
  /// A rigid rectangular block that pushes material points and does not turn.
  template <int dim>
  struct PlateParameters
  {
    std::string              name;
    dealii::BoundingBox<dim> box; ///< before the first step [m]
    /// motion since the start [m]; zero if not given
    std::array<Expression<dim>, dim> displacement;
    /// tangent of the friction angle; without meaning if rough
    double friction_coefficient = 0.0;
    /// points in contact do not slide at all
    bool is_rough = false;
    /// contact stiffness times box length over the points' stiffness
    double penalty = 10.0;

    /// Where the block has moved at a load parameter [m].
    dealii::Tensor<1, dim>
    motion(const double s) const;
  };

  /// Section "Plates": one subsection per plate.
  template <int dim>
  struct PlatesParameters
  {
    std::vector<PlateParameters<dim>> plates;

    static void
    declare(dealii::ParameterHandler       &prm,
            const std::vector<std::string> &names);
    /// Throws ParameterError for a box, formula or angle that cannot be read.
    void
    parse(dealii::ParameterHandler &prm, const std::vector<std::string> &names);
    /// @p boundaries: names that a plate may not have
    void
    check(const std::vector<std::string> &boundaries, Problems &problems) const;
  };
} // namespace Riedel::Equilibrium
