// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/material/hypoplastic_parameters.h>
#include <riedel/material/hypoplastic_places.h>
#include <riedel/material/hypoplastic_step.h>
#include <riedel/material/law.h>

#include <string>

namespace Riedel::Material
{
  /**
   * Hypoplasticity for granular bodies in plane strain: `polar hypoplastic`
   * (micropolar, 7 generalised components) after Tejchman, "Numerical studies
   * on patterning of shear zones in granular bodies", and its classical limit
   * `hypoplastic` (4 components, symmetric stretching, no couple stress).
   * Equations, limits and counted states:
   * doc/theory/polar_hypoplasticity.md. Axis 3 may be stretched, too
   * (Batch::axis_3_strains): d_33 then enters like d^c_11 and d^c_22.
   *
   * A step is integrated with a constant velocity gradient, L dt = log f, in
   * the frame that rotates with the continuum's spin, so that a rigid rotation
   * is exact in any number of steps and 1 + e is proportional to volume. The
   * tangent is the derivative of the sequence of substeps that was accepted.
   *
   * Several points are computed at once (Continuum::Lanes), as long as one
   * substep spans the step; a point's result does not depend on which points
   * these are.
   *
   * State: stress [Pa], couple_stress [N/m] (micropolar only), void_ratio,
   * substep (strain that one substep resolves; where a step starts).
   */
  template <bool micropolar>
  class Hypoplastic : public Law<2>
  {
  public:
    Hypoplastic();

    std::string
    name() const override;

    bool
    is_micropolar() const override
    {
      return micropolar;
    }

    bool
    can_stretch_axis_3() const override
    {
      return true;
    }

    const StateLayout &
    layout() const override
    {
      return slots;
    }

    /// d_50 [m]; 0 in the classical limit
    double
    length() const override
    {
      return micropolar ? parameters.constants.mean_grain_diameter : 0.;
    }

    /// d_50 [m], also of the classical law, whose stresses do not know it
    double
    grain_size() const override
    {
      return parameters.grain_diameter;
    }

    /// f_s a_1^2 [Pa], eqs. (16), (19), (26); of the state on the floor for a
    /// point that a step would put there
    double
    stiffness(const double *state) const override;

    void
    initialise(const InitialState &initial, double *state) const override;

    void
    stresses_at_rest(const double *state, double *stresses) const override;

    Report
    respond(const Batch &batch) const override;

    void
    declare(dealii::ParameterHandler &prm) const override;

    void
    parse(dealii::ParameterHandler &prm) override;

    void
    check(const std::string &path, Problems &problems) const override;

    void
    check_initial(const InitialState &initial,
                  const std::string  &path,
                  Problems           &problems) const override;

  private:
    using Place = HypoplasticPlaces<micropolar>;

    /// Point @p p of a batch, with derivatives if Number has them and with the
    /// strain of axis 3 if axis_3; adds it to the report.
    template <typename Number, bool axis_3>
    void
    respond_point(const Batch       &batch,
                  const unsigned int p,
                  Report            &report) const;

    template <typename Number, bool axis_3>
    Report::Refusal
    respond_point(const double           *increment,
                  const double            axis_3_strain,
                  const double           *committed,
                  double                 *trial,
                  double                 *stresses,
                  double                 *tangent,
                  HypoplasticPointReport &report) const;

    /// respond() with Batch::axis_3_strains
    Report
    respond_across_plane(const Batch &batch) const;

    /// The stresses, and tangents if Number has derivatives, of the points from
    /// @p first on, as many as there are lanes: those in the usual case at
    /// once, the others one by one.
    template <typename Number>
    void
    respond_group(const Batch       &batch,
                  const unsigned int first,
                  Report            &report) const;

    StateLayout           slots;
    HypoplasticParameters parameters;
  };

  using PolarHypoplastic     = Hypoplastic<true>;
  using ClassicalHypoplastic = Hypoplastic<false>;
} // namespace Riedel::Material
