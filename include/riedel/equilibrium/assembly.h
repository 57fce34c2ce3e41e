// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/equilibrium/virtual_stress.h>
#include <riedel/linear_algebra.h>
#include <riedel/points/material_points.h>
#include <riedel/points/supports.h>

#include <deal.II/lac/affine_constraints.h>

#include <cstdint>
#include <string>
#include <vector>

namespace Riedel::Equilibrium
{
  /// What the points of this rank reported in one sweep.
  struct SweepReport
  {
    Material::Report total;
    /// first refused point, as its place in the step's order
    unsigned int first_refused = 0;
  };

  /**
   * From nodal increments to nodal forces and stiffness:
   *
   *     r = sum_p V_n B^T s(B du),   K = sum_p V_n B^T D B.
   *
   * One sweep is gather - increments - law (in batches) - scatter. Trial states
   * and stresses of all points stay available until the next sweep.
   */
  template <int dim>
  class Assembly
  {
  public:
    Assembly(Points::MaterialPoints<dim> &points,
             const Points::Supports<dim> &supports,
             const VirtualStress<dim>    &virtual_stress);

    /// Sizes of the work arrays, after points or supports have changed.
    void
    resize();

    /// Fixes the stresses at the start of the step, for the energy balance, and
    /// the logarithmic strain across the plane in it.
    void
    begin_step(const double strain_33);

    /// Adds the nodal forces of the stresses at increment @p du (relevant dofs
    /// by local number) to @p forces, those of the virtual stress to @p
    /// virtual_forces.
    SweepReport
    forces(const std::vector<double> &du,
           std::vector<double>       &forces,
           std::vector<double>       &virtual_forces);

    /// The same, and the stiffness into @p matrix, under @p constraints whose
    /// inhomogeneities go to @p right_hand_side.
    SweepReport
    forces_and_stiffness(const std::vector<double>               &du,
                         const dealii::AffineConstraints<double> &constraints,
                         std::vector<double>                     &forces,
                         std::vector<double>         &virtual_forces,
                         LinearAlgebra::SparseMatrix &matrix,
                         LinearAlgebra::Vector       &right_hand_side);

    /// Work of the stresses over the step (trapezoidal), after a sweep, on this
    /// rank [J, per metre in 2D].
    double
    stress_work() const;

    /// Seconds spent in laws, and points evaluated, since construction.
    struct Cost
    {
      double        value_seconds   = 0.0;
      double        tangent_seconds = 0.0;
      std::uint64_t value_points    = 0;
      std::uint64_t tangent_points  = 0;

      Cost &
      operator+=(const Cost &other)
      {
        value_seconds += other.value_seconds;
        tangent_seconds += other.tangent_seconds;
        value_points += other.value_points;
        tangent_points += other.tangent_points;
        return *this;
      }
    };

    /// Generalised increments of all points in the last sweep.
    const std::vector<double> &
    point_increments() const
    {
      return increments;
    }

    const Cost &
    cost() const
    {
      return law_cost;
    }

    /// Takes over what an assembly on another grid has cost.
    void
    continue_cost(const Cost &before)
    {
      law_cost = before;
    }

  private:
    SweepReport
    sweep(const std::vector<double>               &du,
          std::vector<double>                     &forces,
          std::vector<double>                     &virtual_forces,
          const dealii::AffineConstraints<double> *constraints,
          LinearAlgebra::SparseMatrix             *matrix,
          LinearAlgebra::Vector                   *right_hand_side);

    Points::MaterialPoints<dim> *points;
    const Points::Supports<dim> *supports;
    const VirtualStress<dim>    *virtual_stress;
    const unsigned int           n_generalised;

    /// per point: increments, stresses at the start and at the end
    std::vector<double> increments;
    std::vector<double> stresses_before;
    std::vector<double> stresses;
    std::vector<double> tangents; ///< of one chunk of points
    /// per point, in the step; empty in plane strain
    std::vector<double> axis_3_strains;
    Cost                law_cost;
  };
} // namespace Riedel::Equilibrium
