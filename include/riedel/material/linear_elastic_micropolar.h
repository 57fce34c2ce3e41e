// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/material/law.h>

#include <string>

namespace Riedel::Material
{
  /**
   * Linear elasticity in plane strain: `linear elastic micropolar` (7
   * generalised components) and the classical `linear elastic` (4).
   *
   * Small strain: with eps_12 = H_12 + theta, eps_21 = H_21 - theta,
   *
   *     sigma = sigma_n + lambda tr(eps) I + 2 mu sym(eps) + 2 mu_c skew(eps)
   *     m     = m_n + B Gamma
   *
   * and all gradients refer to the undeformed body. Finite rotation: the same
   * relation between objective rates, with L dt = log f constant over the
   * step, integrated exactly in the frame that rotates with the spin. The
   * classical law has no skew part and no couple stress. Where axis 3
   * is stretched, tr(eps) and sigma_33 have this strain, too.
   *
   * State: stress [Pa], couple_stress [N/m] (micropolar only).
   */
  template <bool micropolar>
  class LinearElastic : public Law<2>
  {
  public:
    LinearElastic();

    std::string
    name() const override;

    bool
    is_micropolar() const override
    {
      return micropolar;
    }

    bool
    is_geometrically_linear() const override
    {
      return small_strain;
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

    /// the bending length sqrt(B / (4 mu)) [m]; 0 for the classical law
    double
    length() const override;

    /// 2 mu [Pa], whatever the state
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
    template <typename Number>
    Report
    respond_all(const Batch &batch) const;

    template <typename Number>
    Report::Refusal
    respond_point(const double *increment,
                  const double  axis_3_strain,
                  const double *committed,
                  double       *trial,
                  double       *stresses,
                  double       *tangent) const;

    StateLayout slots;
    double      lame_modulus    = 0.;    ///< lambda [Pa]
    double      shear_modulus   = 0.;    ///< mu [Pa]
    double      couple_modulus  = 0.;    ///< mu_c [Pa]
    double      bending_modulus = 0.;    ///< B [N]
    bool        small_strain    = false; ///< otherwise: finite rotation
  };

  using LinearElasticMicropolar = LinearElastic<true>;
  using LinearElasticClassical  = LinearElastic<false>;
} // namespace Riedel::Material
