// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/material/law.h>

#include <string>

namespace Riedel::Material
{
  /**
   * Hencky elasticity in plane strain, a classical finite-strain law (4
   * generalised components): with the elastic left Cauchy-Green tensor b,
   *
   *     eps = ln(b)/2     tau = lambda tr(eps) I + 2 mu eps
   *     sigma = tau / J   J = exp(tr eps)
   *
   * in three dimensions; eps_33 keeps its initial value unless axis 3 is
   * stretched. A step with f = I + H makes f b f^T of b. The stress is a
   * function of the deformation alone, not of its path, and the tangent is
   * symmetric. Equations and source: doc/theory/hencky.md.
   *
   * State: stress [Pa], logarithmic_strain (eps, which stands for b: a small
   * strain is not lost beside the 1 of b). The strain is what the law reads,
   * the stress follows from it.
   */
  class Hencky : public Law<2>
  {
  public:
    Hencky();

    std::string
    name() const override
    {
      return "Hencky";
    }

    bool
    is_micropolar() const override
    {
      return false;
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

    double
    length() const override
    {
      return 0.;
    }

    /// 2 mu / J [Pa]: what 2 mu is per present volume
    double
    stiffness(const double *state) const override;

    /// The strain of the initial stress. J = 1 is the stress-free state, not
    /// the initial one.
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

    /// 3 lambda + 2 mu [Pa], tr tau / tr eps
    double
    volumetric_modulus() const
    {
      return 3. * lame_modulus + 2. * shear_modulus;
    }

    StateLayout slots;
    double      young_modulus = 0.; ///< E [Pa]
    double      poisson_ratio = 0.; ///< nu
    double      lame_modulus  = 0.; ///< lambda [Pa]
    double      shear_modulus = 0.; ///< mu [Pa]
  };
} // namespace Riedel::Material
