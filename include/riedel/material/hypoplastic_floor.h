// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/continuum/lanes.h>
#include <riedel/material/hypoplastic_rate.h>

#include <algorithm>
#include <cmath>

namespace Riedel::Material
{
  /// What keeps the integration of the rate in its limits.
  struct HypoplasticControls
  {
    double floor_pressure    = 0.; ///< [Pa]
    double substep_tolerance = 0.; ///< relative
    /// smallest substeps in a step, a power of two
    unsigned int n_smallest_substeps = 1;
    /// e_d at the floor pressure
    double densest_at_floor = 0.;

    /// Stiffness of the resistance against compaction below e_d [Pa]
    static constexpr double compaction_resistance = 1e7;

    /// A stage whose pressure is below this part of the floor pressure is
    /// not evaluated: the rate is singular at zero pressure.
    static constexpr double smallest_stage_pressure = .1;

    /// Strain that one substep is believed to resolve if nothing is known.
    static constexpr double largest_substep_strain = 1.;

    /// Pressure below which a point is put to rest on it [Pa]: the floor
    /// pressure and, below e_d, the resistance against further compaction.
    template <typename Number>
    Number
    smallest_pressure(const Number &void_ratio) const
    {
      const auto denser = Continuum::value_of(void_ratio) < densest_at_floor;
      if (!Continuum::any(denser))
        return Number(floor_pressure);
      return Continuum::select(denser,
                               floor_pressure +
                                 compaction_resistance *
                                   (densest_at_floor - void_ratio) /
                                   (1. + void_ratio),
                               Number(floor_pressure));
    }
  };



  /// -tr sigma / 3 [Pa]
  template <typename Stress>
  Continuum::ValueOf<typename Stress::value_type>
  mean_pressure(const Stress &y)
  {
    return (Continuum::value_of(y[0]) + Continuum::value_of(y[1]) +
            Continuum::value_of(y[2])) *
           (-1. / 3.);
  }



  /// Are the principal stresses (of the symmetric part) compressive?
  template <typename Stress>
  Continuum::ConditionOf<typename Stress::value_type>
  is_compressive(const Stress &y)
  {
    const auto s11 = Continuum::value_of(y[0]), s22 = Continuum::value_of(y[1]);
    const auto s12 =
      .5 * (Continuum::value_of(y[3]) + Continuum::value_of(y[4]));
    return s11 + s22 < 0. && s11 * s22 > s12 * s12 &&
           Continuum::value_of(y[2]) < 0.;
  }



  /// |deviator and couple stress| / mean pressure of the steepest critical
  /// state, 3/c_1; there the principal stresses are still compressive.
  inline double
  steepest_on_floor(const HypoplasticConstants &constants)
  {
    return 3. / constants.c_1;
  }



  /// |deviator and couple stress| / mean pressure, but no more than what keeps
  /// the principal stresses compressive; 0 without pressure.
  template <typename Stress>
  double
  steepness(const Stress &y)
  {
    constexpr double most     = 1.2; // sqrt(3/2) is the limit
    const double     pressure = mean_pressure(y);
    double           square   = 0.;
    for (unsigned int i = 0; i < y.size(); ++i)
      square +=
        std::pow(Continuum::value_of(y[i]) + (i < 3 ? pressure : 0.), 2);
    return pressure > 0. ? std::min(most, std::sqrt(square) / pressure) : 0.;
  }



  /**
   * Returns stresses below the floor to it: the mean pressure becomes that of
   * the floor, the other parts shrink with the pressure that was there and
   * vanish with it. Above and below, these parts are cut to @p steepest times
   * the mean pressure. True if the pressure was below the floor.
   */
  template <typename Stress>
  bool
  return_to_floor(const HypoplasticControls         &controls,
                  const typename Stress::value_type &void_ratio,
                  const double                       steepest,
                  Stress                            &y)
  {
    using std::sqrt;
    using Number          = typename Stress::value_type;
    const Number pressure = (y[0] + y[1] + y[2]) * (-1. / 3.);
    const Number least    = controls.smallest_pressure(void_ratio);
    const bool   is_below =
      Continuum::value_of(pressure) < Continuum::value_of(least);

    Number share(1.);
    if (is_below)
      share =
        Continuum::value_of(pressure) > 0. ? pressure / least : Number(0.);
    const Number kept   = is_below ? least : pressure;
    Number       square = Number(0.);
    for (unsigned int i = 0; i < y.size(); ++i)
      {
        if (i < 3)
          y[i] += pressure;
        y[i] = y[i] * share;
        square += y[i] * y[i];
      }
    const Number limit = steepest * kept;
    if (Continuum::value_of(square) > std::pow(Continuum::value_of(limit), 2))
      {
        const Number shrink = limit / sqrt(square);
        for (unsigned int i = 0; i < y.size(); ++i)
          y[i] = y[i] * shrink;
      }
    for (unsigned int i = 0; i < 3; ++i)
      y[i] = y[i] - kept;
    return is_below;
  }



  /**
   * On the floor the stress does not feel the strain. A solver needs some
   * stiffness there, the isotropic one of the law at this pressure: adds
   * f_s (a_1^2 d^c + I tr d^c / 9) and f_s a_1^2 k d_50 at the pressure of @p y
   * to its derivatives, not to its value. @p d is the generalised stretching at
   * the end of the step; its d_33 is a given number without derivatives, if
   * there is one.
   */
  template <typename Stress, typename Stretching>
  void
  add_floor_stiffness(const HypoplasticConstants &constants,
                      const double                void_ratio,
                      const Stretching           &d,
                      Stress                     &y)
  {
    using Continuum::only_derivatives;
    using Number = typename Stress::value_type;
    HypoplasticFlags                 ignored;
    const HypoplasticFactors<double> factors(
      constants, -3. * mean_pressure(y), 0., 0., void_ratio, ignored);
    const double stiffness = factors.f_s * factors.a_1 * factors.a_1;
    const Number isotropic = (factors.f_s / 9.) * (d[0] + d[1]);
    y[0] += only_derivatives(stiffness * d[0] + isotropic);
    y[1] += only_derivatives(stiffness * d[1] + isotropic);
    y[2] += only_derivatives(isotropic);
    for (unsigned int i = 2; i + 1 < y.size(); ++i)
      y[1 + i] += only_derivatives(stiffness * d[i]);
  }
} // namespace Riedel::Material
