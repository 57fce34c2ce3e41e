// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/continuum/generalised.h>
#include <riedel/equilibrium/opening_parameters.h>
#include <riedel/errors.h>
#include <riedel/expression.h>

#include <array>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Riedel::Equilibrium
{
  /// What the intensity of a surface load refers to.
  enum class LoadArea
  {
    initial, ///< a dead load: the total force does not follow the surface
    current  ///< per present length (2D) or area (3D)
  };

  /// How a pressure enters the equations (doc/theory/loads.md).
  enum class LoadForm
  {
    automatic,        ///< until the configuration is known
    surface_integral, ///< integrals over the boundary's faces
    virtual_stress    ///< volume terms of a virtual stress field
  };

  /// Section "Boundary conditions": one subsection per named boundary. What is
  /// not given is free.
  template <int dim>
  struct BoundaryParameters
  {
    static constexpr unsigned int n_spin = Continuum::Generalised<dim>::n_spin;

    std::string name;
    /// prescribed displacement components [m]
    std::array<Expression<dim>, dim> displacement;
    /// prescribed micro-rotation [rad]; in 2D one, named "Rotation"
    std::array<Expression<dim>, n_spin> rotation;
    /// pressure, positive in compression, normal to the surface [Pa]
    Expression<dim> pressure;
    /// traction components [Pa]
    std::array<Expression<dim>, dim> traction;
    /// couple traction [N/m]; in 2D one, named "Couple traction"
    std::array<Expression<dim>, n_spin> couple_traction;
    /// dead load or not, for pressure, traction and couple traction
    LoadArea area = LoadArea::current;
    LoadForm form = LoadForm::automatic;
  };

  template <int dim>
  struct BoundaryConditionParameters
  {
    /// in the order of the file: where two boundaries share a node and both
    /// prescribe a component, the one named first counts
    std::vector<BoundaryParameters<dim>> boundaries;

    static void
    declare(dealii::ParameterHandler       &prm,
            const std::vector<std::string> &names);
    /// Throws InputError for a formula that cannot be read.
    void
    parse(dealii::ParameterHandler &prm, const std::vector<std::string> &names);
    /// Replaces every "automatic" form of a load.
    void
    choose_form(const LoadForm form);
    /// @p known: the boundaries of the geometry
    void
    check(const std::vector<std::string> &known,
          const bool                      micropolar,
          Problems                       &problems) const;
  };

  /// Section "Loading": the load parameter s runs from start to stop.
  template <int dim>
  struct LoadingParameters
  {
    /// not above 0; below, s = 0 ends a stage that prepares the loading
    double start         = 0.0;
    double initial_step  = 0.0; ///< 0: the largest step
    double largest_step  = 0.004;
    double smallest_step = 1e-6;
    double stop          = 1.0;
    /// steps never change: no growth, no cut
    bool fixed_steps = false;
    /// if it controls, formulas get the load factor in place of s
    OpeningParameters<dim> opening;

    /// In plane strain: logarithmic strain across the plane since the start, a
    /// formula in s alone. Not given: zero.
    Expression<dim> strain_33;

    /// body force per initial volume [N/m3] besides the weight of Initial state
    std::array<Expression<dim>, dim> body_force;
    /// couple per initial volume [N/m2]
    std::array<Expression<dim>, Continuum::Generalised<dim>::n_spin>
      body_couple;

    static void
    declare(dealii::ParameterHandler &prm);
    void
    parse(dealii::ParameterHandler &prm);
    void
    check(const bool micropolar, Problems &problems) const;

    /// #strain_33 at a load parameter
    double
    strain_33_at(const double s) const
    {
      return strain_33.given() ? strain_33(dealii::Point<dim>(), s) : 0.0;
    }
  };

  enum class SchemeName
  {
    accelerated, ///< old factor, Anderson acceleration (doc/theory/solution.md)
    newton       ///< full Newton with consistent tangent and line search
  };

  enum class Predictor
  {
    automatic, ///< quadratic for accelerated, previous for newton
    quadratic, ///< through the last accepted steps
    previous   ///< the previous increment, scaled
  };

  enum class DirectSolverName
  {
    mumps,
    umfpack ///< on one rank only
  };

  enum class LinearSolverName
  {
    automatic, ///< by dimension and number of unknowns (Balance::make_solver)
    direct,
    iterative ///< GMRES with algebraic multigrid
  };

  /// Section "Solver".
  struct SolverParameters
  {
    SchemeName       scheme        = SchemeName::accelerated;
    Predictor        predictor     = Predictor::automatic;
    DirectSolverName solver        = DirectSolverName::mumps;
    LinearSolverName linear_solver = LinearSolverName::automatic;
    /// reduction of a linear system's residual by the iterative solver
    double       linear_residual        = 1e-3;
    unsigned int most_linear_iterations = 300;
    /// largest residual of forces, and of moments divided by the law's length,
    /// relative to the norm of the reactions
    double residual = 1e-6;
    /// iterations after which a step is cut
    unsigned int most_iterations = 25;
    /// number of iterations the step size is adapted to
    unsigned int target_iterations = 7;
    /// refactor after so many iterations with one factor in one step
    unsigned int refactor_after = 16;
    /// refactor if more further iterations would be needed at the last rate of
    /// convergence
    double patience = 30.0;
    /// secant pairs kept by the acceleration; 0: modified Newton
    unsigned int secant_pairs = 10;

    static void
    declare(dealii::ParameterHandler &prm);
    void
    parse(dealii::ParameterHandler &prm);
    void
    check(Problems &problems) const;
  };
} // namespace Riedel::Equilibrium
