// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/material/drucker_prager.h>

#include <deal.II/base/parameter_handler.h>

#include <array>
#include <cmath>
#include <sstream>

namespace Riedel::Material
{
  namespace
  {
    constexpr double radian = 3.14159265358979323846 / 180.;

    template <typename T>
    std::string
    text_of(const T &value)
    {
      std::ostringstream text;
      text << value;
      return text.str();
    }



    /// Declares how the strength, here called @p strength, changes, and the
    /// form of J2.
    void
    declare_yielding(dealii::ParameterHandler &prm,
                     const std::string        &strength,
                     const bool                micropolar)
    {
      using dealii::Patterns::Anything;
      using dealii::Patterns::Double;
      using dealii::Patterns::Selection;

      prm.declare_entry("Hardening",
                        "none",
                        Selection("none|linear|exponential"),
                        "How the " + strength +
                          " changes with the hardening variable a, the sum of "
                          "the plastic multipliers: \"linear\", by Hardening "
                          "modulus times a up to the residual value, or "
                          "\"exponential\", towards the residual value by "
                          "exp(-a/Softening strain).");
      prm.declare_entry("Residual " + strength,
                        "0",
                        Double(),
                        "Value at which hardening or softening ends. Pa.");
      prm.declare_entry("Hardening modulus",
                        "0",
                        Double(),
                        "Slope of the " + strength +
                          " over a in linear hardening, negative for "
                          "softening. Pa.");
      prm.declare_entry("Softening strain",
                        "0.01",
                        Double(),
                        "a at which the exponential has 1/e of its way left. "
                        "Dimensionless.");
      prm.declare_entry(
        "J2 constants",
        "de Borst",
        Anything(),
        "Weights a1, a2, a3 of J2 = a1 s_ij s_ji + a2 s_ij s_ij + a3/L^2 m_ij "
        "m_ij: \"de Borst\" (1/4, 1/4, 1/2), \"static\" (-1/4, 3/4, 1), "
        "\"kinematic\" (1/8, 3/8, 1/4) or three numbers with a1 + a2 = 1/2. "
        "With a1 = a2 the skew stress stays elastic without a limit." +
          std::string(micropolar ? "" : " The classical law ignores it."));
    }



    /// Reads the form of J2; false if it cannot be read.
    bool
    read_set(const std::string &text, DruckerPragerPlasticity &plasticity)
    {
      const auto set = [&](const double a1, const double a2, const double a3) {
        plasticity.a1 = a1;
        plasticity.a2 = a2;
        plasticity.a3 = a3;
        return true;
      };
      if (text == "de Borst")
        return set(.25, .25, .5);
      if (text == "static")
        return set(-.25, .75, 1.);
      if (text == "kinematic")
        return set(.125, .375, .25);
      std::istringstream    stream(text);
      std::array<double, 3> a;
      for (unsigned int i = 0; i < 3; ++i)
        {
          if (i > 0 && (stream >> std::ws).peek() == ',')
            stream.get();
          if (!(stream >> a[i]))
            return false;
        }
      return set(a[0], a[1], a[2]) && (stream >> std::ws).eof();
    }



    /// Reads what declare_yielding() has declared; @p factor is c over the
    /// strength of the input file.
    void
    parse_yielding(dealii::ParameterHandler &prm,
                   const std::string        &strength,
                   const double              factor,
                   DruckerPragerPlasticity  &plasticity)
    {
      const std::string hardening = prm.get("Hardening");
      plasticity.hardening =
        hardening == "linear" ?
          Hardening::linear :
          (hardening == "exponential" ? Hardening::exponential :
                                        Hardening::none);
      plasticity.residual     = factor * prm.get_double("Residual " + strength);
      plasticity.modulus      = factor * prm.get_double("Hardening modulus");
      plasticity.decay_strain = prm.get_double("Softening strain");
    }



    /// The rules of what has been declared here.
    void
    check_yielding(const std::string             &path,
                   const std::string             &strength,
                   const std::string             &set,
                   const bool                     set_is_readable,
                   const bool                     micropolar,
                   const double                   factor,
                   const NeoHookeanElasticity    &elasticity,
                   const DruckerPragerPlasticity &plasticity,
                   Problems                      &problems)
    {
      const auto require = [&](const bool         holds,
                               const std::string &entry,
                               const std::string &read,
                               const std::string &allowed) {
        if (!holds)
          problems.error(path + "/" + entry,
                         entry + " is " + read + ", but " + allowed + ".");
      };
      if (micropolar)
        {
          if (!set_is_readable)
            problems.error(path + "/J2 constants",
                           "J2 constants is \"" + set +
                             "\", but it must be \"de Borst\", \"static\", "
                             "\"kinematic\" or three numbers a1, a2, a3.");
          else
            {
              require(std::abs(plasticity.a1 + plasticity.a2 - .5) < 1e-12,
                      "J2 constants",
                      set,
                      "a1 + a2 must be 1/2, so that shear of a symmetric "
                      "stress yields as usual");
              require(plasticity.a2 >= plasticity.a1,
                      "J2 constants",
                      set,
                      "J2 is positive only if a2 >= a1");
              require(plasticity.a3 > 0.,
                      "J2 constants",
                      set,
                      "J2 is positive only if a3 > 0");
            }
        }
      require(plasticity.residual >= 0.,
              "Residual " + strength,
              text_of(plasticity.residual / factor),
              "it must not be negative");

      const auto &p = plasticity;
      if (p.hardening == Hardening::none || !(elasticity.mu > 0.))
        return;
      if (p.hardening == Hardening::linear && p.modulus != 0.)
        require((p.residual - p.strength) * p.modulus >= 0.,
                "Residual " + strength,
                text_of(p.residual / factor),
                "with a hardening modulus of " + text_of(p.modulus / factor) +
                  " Pa it must be " + (p.modulus < 0. ? "below" : "above") +
                  " the initial one, " + text_of(p.strength / factor) + " Pa");
      if (p.hardening == Hardening::exponential)
        require(p.decay_strain > 0.,
                "Softening strain",
                text_of(p.decay_strain),
                "it must be positive");

      const double h = p.steepest_modulus();
      if (!(h < 0.))
        return;
      const std::string entry = p.hardening == Hardening::linear ?
                                  "Hardening modulus" :
                                  "Softening strain";
      const double stiffness  = 3. * elasticity.mu + elasticity.bulk_modulus() *
                                                      p.friction * p.dilatancy;
      require(stiffness + h > 0.,
              entry,
              text_of(p.hardening == Hardening::linear ? h / factor :
                                                         p.decay_strain),
              "the strength then falls by " + text_of(-h) +
                " Pa per unit of a, faster than the elastic stress, by 3 mu "
                "+ K A B = " +
                text_of(stiffness) + " Pa: a point could not follow");
      const double mu_ep = elasticity.mu * h / (h + 3. * elasticity.mu);
      if (micropolar && !(elasticity.couple_modulus() > std::abs(mu_ep)))
        problems.warning(
          path + "/" + entry,
          "The couple modulus, " + text_of(elasticity.couple_modulus()) +
            " Pa, does not exceed |mu_ep| = " + text_of(std::abs(mu_ep)) +
            " Pa, mu_ep = mu h/(h + 3 mu) with the slope h = " + text_of(h) +
            " Pa: the width of bands will be that of the cells. Such points "
            "are counted.");
      if (micropolar && p.residual == 0. && p.friction == 0.)
        problems.warning(
          path + "/Residual " + strength,
          "Without a residual strength the couple stress ends, and with it "
          "what gives bands a width: |m| <= L c/sqrt(3 a3). Such points are "
          "counted.");
      if (!micropolar)
        problems.warning(path + "/Hardening",
                         "A classical continuum that softens has no length: "
                         "the width of its bands is that of the cells.");
    }
  } // namespace



  Cone::Cone(const std::string &matching,
             const double       friction_angle,
             const double       dilatancy_angle)
  {
    const double phi = std::sin(friction_angle);
    const double psi = std::sin(dilatancy_angle);
    if (matching == "plane strain")
      {
        dilatancy      = std::sqrt(3.) * psi / std::sqrt(1. + psi * psi / 3.);
        const double D = std::sqrt((1. - dilatancy * dilatancy / 9.) / 3.) +
                         dilatancy * phi / 9.;
        friction              = phi / D;
        strength_per_cohesion = std::cos(friction_angle) / D;
        return;
      }
    const double sign     = matching == "compression" ? -1. : 1.;
    friction              = 6. * phi / (3. + sign * phi);
    dilatancy             = 6. * psi / (3. + sign * psi);
    strength_per_cohesion = 6. * std::cos(friction_angle) / (3. + sign * phi);
  }



  template <int dim, bool micropolar>
  DruckerPrager<dim, micropolar>::DruckerPrager()
    : FiniteStrainLaw<dim, micropolar, true>("cohesion",
                                             "cohesion c' that is left")
  {}



  template <int dim, bool micropolar>
  std::string
  DruckerPrager<dim, micropolar>::name() const
  {
    return micropolar ? "Drucker-Prager micropolar" : "Drucker-Prager";
  }



  template <int dim, bool micropolar>
  void
  DruckerPrager<dim, micropolar>::declare(dealii::ParameterHandler &prm) const
  {
    using dealii::Patterns::Double;
    using dealii::Patterns::Selection;

    this->declare_elasticity(prm);
    prm.declare_entry("Friction angle",
                      "0",
                      Double(),
                      "Angle of internal friction phi. Degrees.",
                      true);
    prm.declare_entry("Dilatancy angle",
                      "0",
                      Double(),
                      "Angle of dilatancy psi; equal to the friction angle: "
                      "associated flow. Degrees.",
                      true);
    prm.declare_entry("Cohesion", "0", Double(), "Cohesion c'. Pa.", true);
    prm.declare_entry("Cone matching",
                      "plane strain",
                      Selection("plane strain|compression|extension"),
                      "What the cone has in common with the yield surface of "
                      "Mohr and Coulomb: the limit load in plane strain with "
                      "this dilatancy, or the edges of triaxial compression or "
                      "extension.");
    declare_yielding(prm, "cohesion", micropolar);
  }



  template <int dim, bool micropolar>
  void
  DruckerPrager<dim, micropolar>::parse(dealii::ParameterHandler &prm)
  {
    this->parse_elasticity(prm);
    this->plasticity = DruckerPragerPlasticity();
    friction_angle   = prm.get_double("Friction angle") * radian;
    dilatancy_angle  = prm.get_double("Dilatancy angle") * radian;
    cohesion         = prm.get_double("Cohesion");
    matching         = prm.get("Cone matching");
    set              = prm.get("J2 constants");

    const Cone cone(matching, friction_angle, dilatancy_angle);
    this->strength_factor      = cone.strength_per_cohesion;
    this->plasticity.friction  = cone.friction;
    this->plasticity.dilatancy = cone.dilatancy;
    this->plasticity.strength  = this->strength_factor * cohesion;
    this->plasticity.length    = this->length();
    parse_yielding(prm, "cohesion", this->strength_factor, this->plasticity);
    set_is_readable = read_set(set, this->plasticity);
  }



  template <int dim, bool micropolar>
  void
  DruckerPrager<dim, micropolar>::check(const std::string &path,
                                        Problems          &problems) const
  {
    this->check_elasticity(path, problems);
    const auto require = [&](const bool         holds,
                             const std::string &entry,
                             const double       read,
                             const std::string &allowed) {
      if (!holds)
        problems.error(path + "/" + entry,
                       entry + " is " + text_of(read) + ", but " + allowed +
                         ".");
    };
    const double phi = friction_angle / radian, psi = dilatancy_angle / radian;
    require(phi >= 0. && phi < 90.,
            "Friction angle",
            phi,
            "it must lie between 0 and 90 degrees");
    require(psi >= 0. && psi <= phi,
            "Dilatancy angle",
            psi,
            "it must lie between 0 and the friction angle, " + text_of(phi) +
              " degrees: plastic flow would produce energy otherwise");
    require(cohesion >= 0., "Cohesion", cohesion, "it must not be negative");
    if (phi == 0.)
      require(cohesion > 0.,
              "Cohesion",
              cohesion,
              "a material without friction needs some");
    check_yielding(path,
                   "cohesion",
                   set,
                   set_is_readable,
                   micropolar,
                   this->strength_factor,
                   this->elasticity,
                   this->plasticity,
                   problems);
  }



  template <int dim, bool micropolar>
  VonMises<dim, micropolar>::VonMises()
    : FiniteStrainLaw<dim, micropolar, true>(
        "yield_stress",
        "yield stress sqrt(3 J2) that is left")
  {}



  template <int dim, bool micropolar>
  std::string
  VonMises<dim, micropolar>::name() const
  {
    return micropolar ? "von Mises micropolar" : "von Mises";
  }



  template <int dim, bool micropolar>
  void
  VonMises<dim, micropolar>::declare(dealii::ParameterHandler &prm) const
  {
    this->declare_elasticity(prm);
    prm.declare_entry("Yield stress",
                      "0",
                      dealii::Patterns::Double(),
                      "sqrt(3 J2) at which the material yields; the stress in "
                      "uniaxial tension. Pa.",
                      true);
    declare_yielding(prm, "yield stress", micropolar);
  }



  template <int dim, bool micropolar>
  void
  VonMises<dim, micropolar>::parse(dealii::ParameterHandler &prm)
  {
    this->parse_elasticity(prm);
    this->plasticity          = DruckerPragerPlasticity();
    this->plasticity.strength = prm.get_double("Yield stress");
    this->plasticity.length   = this->length();
    set                       = prm.get("J2 constants");
    parse_yielding(prm, "yield stress", 1., this->plasticity);
    set_is_readable = read_set(set, this->plasticity);
  }



  template <int dim, bool micropolar>
  void
  VonMises<dim, micropolar>::check(const std::string &path,
                                   Problems          &problems) const
  {
    this->check_elasticity(path, problems);
    if (!(this->plasticity.strength > 0.))
      problems.error(path + "/Yield stress",
                     "Yield stress is " + text_of(this->plasticity.strength) +
                       ", but it must be positive.");
    check_yielding(path,
                   "yield stress",
                   set,
                   set_is_readable,
                   micropolar,
                   1.,
                   this->elasticity,
                   this->plasticity,
                   problems);
  }



  template class DruckerPrager<2, false>;
  template class DruckerPrager<2, true>;
  template class DruckerPrager<3, false>;
  template class DruckerPrager<3, true>;
  template class VonMises<2, false>;
  template class VonMises<2, true>;
  template class VonMises<3, false>;
  template class VonMises<3, true>;
} // namespace Riedel::Material
