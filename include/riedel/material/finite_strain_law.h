// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/continuum/forward.h>
#include <riedel/continuum/generalised.h>
#include <riedel/continuum/newton.h>
#include <riedel/material/drucker_prager_plasticity.h>
#include <riedel/material/law.h>
#include <riedel/material/neo_hookean_elasticity.h>

#include <string>
#include <type_traits>

namespace Riedel::Material
{
  /**
   * What the finite-strain laws of neo-Hookean elasticity have in common:
   * state, kinematics, return to the yield surface, batches
   * (doc/theory/elastoplasticity.md). Micropolar laws have 7 generalised
   * components in plane strain and 21 in space, classical ones 4 and 9.
   *
   * State: stress [Pa], couple_stress [N/m] (micropolar), elastic_strain
   * (V^e - I), elastic_curvature [1/m] (micropolar). Plastic laws have also
   * total_strain (F Q^T - I, micropolar) or volume_ratio (det F, classical),
   * plastic_multiplier (the hardening variable), strength [Pa] and
   * yield_function [Pa]. The stress follows from the strains and curvatures,
   * which the law reads.
   */
  template <int dim, bool micropolar, bool plastic>
  class FiniteStrainLaw : public Law<dim>
  {
  public:
    bool
    is_micropolar() const override
    {
      return micropolar;
    }

    bool
    can_stretch_axis_3() const override
    {
      return dim == 2;
    }

    const StateLayout &
    layout() const override
    {
      return slots;
    }

    /// L = sqrt((beta + gamma)/(2 mu)) [m]; 0 for a classical law
    double
    length() const override
    {
      return micropolar ? elasticity.length() : 0.;
    }

    /// L [m], also of a classical law that was given moduli of curvature: its
    /// stresses do not know it
    double
    grain_size() const override
    {
      return length_of_bands;
    }

    /// 2 mu [Pa], whatever the state
    double
    stiffness(const double * /*state*/) const override
    {
      return 2. * elasticity.mu;
    }

    /// The symmetric elastic stretch that has the initial stress. It is a
    /// deformation from the stress-free state: J = det V^e.
    void
    initialise(const InitialState &initial, double *state) const override;

    void
    stresses_at_rest(const double *state, double *stresses) const override;

    Report
    respond(const Batch &batch) const override;

    void
    check_initial(const InitialState &initial,
                  const std::string  &path,
                  Problems           &problems) const override;

  protected:
    /// @param strength_slot name of the slot of the strength, @p
    ///        strength_meaning its description; for plastic laws
    FiniteStrainLaw(const std::string &strength_slot    = "",
                    const std::string &strength_meaning = "");

    void
    declare_elasticity(dealii::ParameterHandler &prm) const;

    void
    parse_elasticity(dealii::ParameterHandler &prm);

    void
    check_elasticity(const std::string &path, Problems &problems) const;

    NeoHookeanElasticity    elasticity;
    DruckerPragerPlasticity plasticity;
    /// c over what the slot of the strength shows
    double strength_factor = 1.;

  private:
    template <typename Number>
    void
    respond_point(const Batch       &batch,
                  const unsigned int p,
                  Report            &report) const;

    template <typename Number>
    Report::Refusal
    respond_point(const double *increment,
                  const double  axis_3_strain,
                  const double *committed,
                  double       *trial,
                  double       *stresses,
                  double       *tangent,
                  Report       &report) const;

    /// What one point is computed with.
    template <bool with_tangent>
    using NumberOfPoint = std::conditional_t<
      with_tangent,
      Continuum::Forward<Continuum::n_derivatives(
        micropolar ? Continuum::Generalised<dim>::n_micropolar :
                     Continuum::Generalised<dim>::n_classical)>,
      double>;

    /// Point @p p of a batch with its tangent, if that is known in closed form:
    /// of a point in space that stays elastic. Otherwise false, and the report
    /// is as it was.
    bool
    respond_elastic(const Batch       &batch,
                    const unsigned int p,
                    Report            &report) const;

    /// The points from @p first on, as many as there are lanes: the elastic
    /// ones at once, the others one by one.
    template <typename Number>
    void
    respond_group(const Batch       &batch,
                  const unsigned int first,
                  Report            &report) const;

    /// Counts a point that yields at the multiplier @p a and the pressure part
    /// A p of its strength.
    void
    count_yielding(const double a, const double A_p, Report &report) const;

    StateLayout slots;
    double      length_of_bands = 0.;
  };

  /// `neo-Hookean micropolar` and the classical `neo-Hookean`: elasticity.
  template <int dim, bool micropolar>
  class NeoHookean : public FiniteStrainLaw<dim, micropolar, false>
  {
  public:
    std::string
    name() const override;

    void
    declare(dealii::ParameterHandler &prm) const override;

    void
    parse(dealii::ParameterHandler &prm) override;

    void
    check(const std::string &path, Problems &problems) const override;
  };
} // namespace Riedel::Material
