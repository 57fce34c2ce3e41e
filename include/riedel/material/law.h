// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/errors.h>
#include <riedel/material/state_layout.h>

#include <deal.II/base/symmetric_tensor.h>

#include <memory>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Riedel::Material
{
  /**
   * The points a law is asked about in one call. All arrays are row-major, a
   * row per point. n_generalised = Law::n_generalised(), n_state =
   * Law::layout().size().
   */
  struct Batch
  {
    unsigned int  n_points;
    const double *increments; ///< n_points x n_generalised: H, theta, Gamma
    const double *committed;  ///< n_points x n_state: state at the step's start
    double       *trial;      ///< n_points x n_state: state at the step's end
    double       *stresses; ///< n_points x n_generalised: P, t, M [Pa, Pa, N/m]
    /// n_points x n_generalised x n_generalised, d stress_a / d increment_b;
    /// null if only the stresses are wanted
    double *tangents;
    /// n_points logarithmic strains of axis 3 in the step, extension positive;
    /// null: plane strain. For laws that say Law::can_stretch_axis_3(). State
    /// and void ratio follow it; stresses stay those of the plane, where j is
    /// det f in the plane, and so do the tangents.
    const double *axis_3_strains = nullptr;
  };

  /**
   * What happened in a batch beyond plain sailing. Every count is a number of
   * points. Reports of several batches are summed.
   */
  struct Report
  {
    enum class Refusal
    {
      none,
      inverted_step,     ///< det f <= 0 or a relative rotation of 180 degrees
      too_many_substeps, ///< the error control did not end
      no_return,         ///< no way back to the yield surface was found
      not_finite         ///< a stress is not a number
    };

    unsigned int floored       = 0; ///< put to the floor pressure
    unsigned int clamped       = 0; ///< density factor clamped
    unsigned int null_deviator = 0; ///< s*_kl s*_lk <= 0, taken as zero
    unsigned int yielding      = 0; ///< on the yield surface
    unsigned int at_apex       = 0; ///< of these, at its apex
    /// yielding with softening so steep that the couple modulus does not exceed
    /// |mu_ep|: the micropolar continuum does not regularise it
    unsigned int       unregularised    = 0;
    unsigned int       without_strength = 0; ///< nearly nothing is left of it
    unsigned long long substeps         = 0; ///< accepted substeps, all points
    unsigned int       refused          = 0; ///< points without a result
    /// first refused point: index in the batch, reason, what is known
    unsigned int first_refused = 0;
    Refusal      reason        = Refusal::none;
  };

  /// Adds the counts of @p b, but not what it says of its refused points.
  void
  add_counts(Report &sum, const Report &b);

  /// A sentence for people on why a point was refused.
  std::string
  describe(Report::Refusal reason);

  /// What the scene knows about a point before the first step.
  struct InitialState
  {
    dealii::SymmetricTensor<2, 3> stress;           ///< Pa, tension positive
    double                        void_ratio = 0.0; ///< pore / solid volume
  };

  /**
   * A constitutive law: a function from the generalised increments of a step
   * to the generalised stresses on the start-of-step configuration
   * (Continuum::Generalised gives the order of components). Its derivative is
   * the full consistent tangent. The law never sees the grid. It is stateless:
   * respond() may be called at any time, any number of times, for any points.
   */
  template <int dim>
  class Law
  {
  public:
    virtual ~Law() = default;

    /// The name in the .prm file.
    virtual std::string
    name() const = 0;

    /// Does the law need micro-rotations?
    virtual bool
    is_micropolar() const = 0;

    /// True if stresses and gradients all refer to the undeformed body, as in
    /// a small-strain law: the grid's deformation is then ignored.
    virtual bool
    is_geometrically_linear() const
    {
      return false;
    }

    /// Does respond() understand Batch::axis_3_strains?
    virtual bool
    can_stretch_axis_3() const
    {
      return false;
    }

    /// Number of generalised increments: 7 or 4 in plane strain, 21 or 9 in 3D.
    unsigned int
    n_generalised() const;

    /// The state slots this law needs. Slots that other parts read by name:
    /// "stress" {"11","22","33","12","21"} Pa, "couple_stress" {"1","2"} N/m,
    /// "void_ratio".
    virtual const StateLayout &
    layout() const = 0;

    /// The length that makes moments comparable with forces, e.g. d50 [m]; 0
    /// for a classical law.
    virtual double
    length() const = 0;

    /// The length by which shear bands are measured and grids are refined, d50
    /// [m]; 0 if the law knows of no grains.
    virtual double
    grain_size() const
    {
      return length();
    }

    /// A scale of the tangent at rest [Pa], from the committed state only;
    /// used to scale stabilisation terms. It is the factor of the linear part
    /// of the stretching in the rate of stress, 2 mu in elasticity. Positive
    /// and finite for every state that the law has left or could start from.
    virtual double
    stiffness(const double *state) const = 0;

    /// Writes the state of a point before the first step into @p state
    /// (layout().size() values).
    virtual void
    initialise(const InitialState &initial, double *state) const = 0;

    /// Generalised stresses of a state at zero increment (P = sigma, t_3 =
    /// sigma_12 - sigma_21, M = m).
    virtual void
    stresses_at_rest(const double *state, double *stresses) const = 0;

    /// The law itself. Fills trial, stresses and, if asked for, tangents of
    /// every point that is not refused.
    virtual Report
    respond(const Batch &batch) const = 0;

    /// Declares the law's own parameters in the present subsection.
    virtual void
    declare(dealii::ParameterHandler &prm) const = 0;

    /// Reads them.
    virtual void
    parse(dealii::ParameterHandler &prm) = 0;

    /// Violated rules and warnings; @p path is the law's subsection.
    virtual void
    check(const std::string &path, Problems &problems) const = 0;

    /// Rules and warnings about a state in which the scene starts a point.
    virtual void
    check_initial(const InitialState &initial,
                  const std::string  &path,
                  Problems           &problems) const = 0;
  };

  /// Names of all laws that are known in @p dim dimensions, as written in the
  /// .prm file.
  template <int dim>
  std::vector<std::string>
  known_laws();

  /// A law by its name; throws std::out_of_range for an unknown one.
  template <int dim>
  std::unique_ptr<Law<dim>>
  create_law(const std::string &name);
} // namespace Riedel::Material
