// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/material/finite_strain_law.h>

#include <string>

namespace Riedel::Material
{
  /**
   * Elastoplasticity at finite strain with the yield function of Drucker and
   * Prager: `Drucker-Prager micropolar`, and `Drucker-Prager`, its classical
   * counterpart. Equations and sources: doc/theory/elastoplasticity.md.
   */
  template <int dim, bool micropolar>
  class DruckerPrager : public FiniteStrainLaw<dim, micropolar, true>
  {
  public:
    DruckerPrager();

    std::string
    name() const override;

    void
    declare(dealii::ParameterHandler &prm) const override;

    void
    parse(dealii::ParameterHandler &prm) override;

    void
    check(const std::string &path, Problems &problems) const override;

  private:
    double      friction_angle  = 0.; ///< rad
    double      dilatancy_angle = 0.; ///< rad
    double      cohesion        = 0.; ///< c' [Pa]
    std::string matching        = "plane strain";
    std::string set             = "de Borst";
    bool        set_is_readable = true;
  };

  /**
   * The special case without friction and dilatancy: `von Mises micropolar` and
   * `von Mises`.
   */
  template <int dim, bool micropolar>
  class VonMises : public FiniteStrainLaw<dim, micropolar, true>
  {
  public:
    VonMises();

    std::string
    name() const override;

    void
    declare(dealii::ParameterHandler &prm) const override;

    void
    parse(dealii::ParameterHandler &prm) override;

    void
    check(const std::string &path, Problems &problems) const override;

  private:
    std::string set             = "de Borst";
    bool        set_is_readable = true;
  };

  /**
   * Friction A and strength per cohesion c/c' of the yield function that fits
   * the angles of friction and dilatancy [rad], and the dilatancy B. @p
   * matching: `plane strain`, `compression` or `extension`.
   */
  struct Cone
  {
    double friction, dilatancy, strength_per_cohesion;

    Cone(const std::string &matching,
         const double       friction_angle,
         const double       dilatancy_angle);
  };
} // namespace Riedel::Material
