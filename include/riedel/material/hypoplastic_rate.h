// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/continuum/forward.h>
#include <riedel/continuum/lanes.h>

#include <array>
#include <cmath>

namespace Riedel::Material
{
  /**
   * The constants of polar hypoplasticity, with what follows from them.
   * Equation numbers: Tejchman, "Numerical studies on patterning of shear
   * zones in granular bodies"; doc/theory/polar_hypoplasticity.md.
   */
  struct HypoplasticConstants
  {
    double critical_friction_angle = 0.; ///< phi_c [rad]
    double granular_hardness       = 0.; ///< h_s [Pa]
    double minimum_void_ratio      = 0.; ///< e_d0 at zero pressure
    double critical_void_ratio     = 0.; ///< e_c0 at zero pressure
    double maximum_void_ratio      = 0.; ///< e_i0 at zero pressure
    double density_exponent        = 0.; ///< alpha
    double hardness_exponent       = 0.; ///< n
    double mean_grain_diameter     = 0.; ///< d_50 [m]

    /// a_c = polar_number + polar_inverse / a_1 + polar_linear a_1
    double polar_number  = 0.;
    double polar_inverse = 1.;
    double polar_linear  = 0.;

    /// The base of f_d = ((e - e_d)/(e_c - e_d))^alpha is not less than this.
    static constexpr double smallest_density_base = .01;

    double c_1 = 0.; ///< eq. (26)
    double c_2 = 0.; ///< eq. (26)
    double h_i = 0.; ///< eq. (20)
    /// h_s / (n h_i), the constant factor of f_s [Pa]
    double stiffness_factor = 0.;

    /// Computes c_1, c_2, h_i and the stiffness factor from the others.
    void
    derive()
    {
      const double s = std::sin(critical_friction_angle);
      c_1            = std::sqrt(3. / 8.) * (3. - s) / s;
      c_2            = 3. / 8. * (3. + s) / s;
      h_i            = 1. / (c_1 * c_1) + 1. / 3. -
            std::pow((maximum_void_ratio - minimum_void_ratio) /
                       (critical_void_ratio - minimum_void_ratio),
                     density_exponent) /
              (c_1 * std::sqrt(3.));
      stiffness_factor = granular_hardness / (hardness_exponent * h_i);
    }

    /// exp(-(3 p / h_s)^n), by which e_i0, e_d0 and e_c0 fall with pressure
    double
    compression(const double pressure) const
    {
      return std::exp(
        -std::pow(3. * pressure / granular_hardness, hardness_exponent));
    }
  };



  /// Places at which the rate had to be kept away from a singularity.
  /// @tparam Condition bool, or a mask of several points
  template <typename Condition>
  struct BasicHypoplasticFlags
  {
    /// density base below its smallest value
    Condition clamped = false;
    /// |s^*| taken as zero, or cos 3 theta bounded
    Condition null_deviator = false;

    void
    merge(const BasicHypoplasticFlags &other)
    {
      clamped       = clamped || other.clamped;
      null_deviator = null_deviator || other.null_deviator;
    }
  };

  using HypoplasticFlags = BasicHypoplasticFlags<bool>;

  /// The flags of the points that Number stands for.
  template <typename Number>
  using HypoplasticFlagsOf =
    BasicHypoplasticFlags<Continuum::ConditionOf<Number>>;



  /// The scalar factors of the rate at a state.
  template <typename Number>
  struct HypoplasticFactors
  {
    /// bound of |cos 3 theta|
    static constexpr double largest_cosine = 2.;

    Number f_s; ///< [Pa]
    Number f_d;
    Number a_1;

    /**
     * @param trace tr sigma [Pa], negative
     * @param deviator_33 out-of-plane component of s^* = dev(sigma/tr sigma)
     * @param determinant of the in-plane block of s^*; with tr s^* = 0 it
     *   gives both invariants: s^*_kl s^*_lk = 2 (s^*_33^2 - determinant) and
     *   s^*_kl s^*_lm s^*_mk = 3 s^*_33 determinant
     */
    HypoplasticFactors(const HypoplasticConstants &constants,
                       const Number               &trace,
                       const Number               &deviator_33,
                       const Number               &determinant,
                       const Number               &void_ratio,
                       HypoplasticFlagsOf<Number> &flags)
    {
      using Continuum::any;
      using Continuum::select;
      using Continuum::value_of;
      using std::abs;
      using std::exp;
      using std::pow;
      using std::sqrt;

      const Number y  = trace * (-1. / constants.granular_hardness);
      const Number yn = constants.hardness_exponent == .5 ?
                          Number(sqrt(y)) :
                          Number(pow(y, constants.hardness_exponent));

      // The limiting void ratios fall with exp(-yn); all ratios are formed
      // with e exp(yn) instead, which needs one exponential.
      const Number growth = exp(yn);
      Number       scaled = void_ratio * growth;
      const double range =
        constants.critical_void_ratio - constants.minimum_void_ratio;
      const double smallest =
        constants.minimum_void_ratio +
        HypoplasticConstants::smallest_density_base * range;
      const auto clamped = !(value_of(scaled) > smallest);
      if (any(clamped))
        {
          scaled        = select(clamped, Number(smallest), scaled);
          flags.clamped = flags.clamped || clamped;
        }
      const Number base =
        (scaled - constants.minimum_void_ratio) * (1. / range);
      f_d = pow(base, constants.density_exponent);
      f_s = (growth + constants.maximum_void_ratio) * y / (scaled * yn) *
            constants.stiffness_factor;

      const Number deviator_square =
        2. * (deviator_33 * deviator_33 - determinant);
      const auto   square      = value_of(deviator_square);
      const double null        = 1e-24; // |s^*| = 1e-12
      const auto   anisotropic = square > null;
      Number       inverse_a1  = Number(constants.c_1);
      if (any(anisotropic))
        {
          const Number length = sqrt(deviator_square);
          // |s^*| cos 3 theta, eq. (27)
          Number cosine_part =
            deviator_33 * determinant * (-3. * std::sqrt(6.)) / deviator_square;
          // |cos 3 theta| is at most 1 for a symmetric tensor, slightly more
          // for usual skew parts and without bound where s^*_kl s^*_lk
          // vanishes. The bound makes 1/a_1 continuous there.
          const auto bounded =
            anisotropic &&
            abs(value_of(cosine_part)) > largest_cosine * value_of(length);
          if (any(bounded))
            {
              flags.null_deviator  = flags.null_deviator || bounded;
              const Number largest = largest_cosine * length;
              const Number bound =
                select(value_of(cosine_part) > 0., largest, -largest);
              cosine_part = select(bounded, bound, cosine_part);
            }
          inverse_a1 =
            select(anisotropic,
                   constants.c_1 + constants.c_2 * (length + cosine_part),
                   inverse_a1);
        }
      flags.null_deviator = flags.null_deviator || square < -null;
      a_1                 = 1. / inverse_a1;
    }
  };



  /// Stress 11, 22, 33, 12, 21 and, if micropolar, the couple stress divided
  /// by d_50: all in Pa.
  template <bool micropolar, typename Number>
  using HypoplasticStress = std::array<Number, micropolar ? 7 : 5>;

  /// d^c_11, d^c_22, d^c_12, d^c_21 and, if micropolar, k_1 d_50, k_2 d_50; the
  /// last one is d_33 if axis 3 is stretched.
  template <bool micropolar, typename Number, bool axis_3 = false>
  using HypoplasticStretching =
    std::array<Number, (micropolar ? 6 : 4) + (axis_3 ? 1 : 0)>;



  /// r = sqrt(d^c:d^c + (k d_50).(k d_50)); its derivative at zero is zero
  template <typename Stretching>
  typename Stretching::value_type
  stretching_length(const Stretching &d)
  {
    using Continuum::chain_rule;
    using Continuum::select;
    using std::sqrt;
    using Number  = typename Stretching::value_type;
    using Value   = Continuum::ValueOf<Number>;
    Number square = d[0] * d[0];
    for (unsigned int i = 1; i < d.size(); ++i)
      square += d[i] * d[i];
    const Value length = sqrt(Continuum::value_of(square));
    const auto  rests  = length == Value(0.);
    const Value slope =
      select(rests, Value(0.), Value(.5 / select(rests, Value(1.), length)));
    return chain_rule(square, length, slope);
  }



  /**
   * Objective rates F and G/d_50 [Pa per unit of pseudo-time], eqs. (16), (17):
   *
   *     F = f_s [ a_1^2 d^c + s^ (s^:d^c + m^.k d_50) + f_d a_1 (s^ + s^*) r ]
   *     G/d_50 = f_s a_1^2 [ k d_50 + m^ (s^:d^c + m^.k d_50 + f_d a_c r) ]
   *
   * with s^ = sigma / tr sigma and m^ = m / (d_50 tr sigma). tr sigma must be
   * negative.
   *
   * @param d stretching; without axis_3, d^c_33 = 0
   * @param r its length, stretching_length(d)
   * @tparam State Number, or ValueOf<Number> for a state without derivatives
   */
  template <bool micropolar,
            typename Number,
            bool axis_3    = false,
            typename State = Number>
  HypoplasticStress<micropolar, Number>
  hypoplastic_rate(const HypoplasticConstants                 &constants,
                   const HypoplasticStress<micropolar, State> &stress,
                   const State                                &void_ratio,
                   const HypoplasticStretching<micropolar, Number, axis_3> &d,
                   const Number                                            &r,
                   HypoplasticFlagsOf<Number> &flags)
  {
    const State trace   = stress[0] + stress[1] + stress[2];
    const State inverse = 1. / trace;

    HypoplasticStress<micropolar, State> s;
    for (unsigned int i = 0; i < s.size(); ++i)
      s[i] = stress[i] * inverse;

    const State deviator_33 = s[2] - 1. / 3.;
    const State determinant = (s[0] - 1. / 3.) * (s[1] - 1. / 3.) - s[3] * s[4];
    const HypoplasticFactors<State> factors(
      constants, trace, deviator_33, determinant, void_ratio, flags);
    const State &a_1 = factors.a_1;

    Number power = s[0] * d[0] + s[1] * d[1] + s[3] * d[2] + s[4] * d[3];
    if constexpr (micropolar)
      power += s[5] * d[4] + s[6] * d[5];
    if constexpr (axis_3)
      power += s[2] * d.back();

    const Number fd_r         = factors.f_d * r;
    const Number nonlinear    = fd_r * a_1;
    const State  a_1_square   = a_1 * a_1;
    const State  linear       = factors.f_s * a_1_square;
    const Number along_stress = factors.f_s * (power + 2. * nonlinear);
    const Number isotropic    = factors.f_s * nonlinear * (1. / 3.);

    HypoplasticStress<micropolar, Number> rate;
    rate[0] = linear * d[0] + along_stress * s[0] - isotropic;
    rate[1] = linear * d[1] + along_stress * s[1] - isotropic;
    rate[2] = along_stress * s[2] - isotropic;
    if constexpr (axis_3)
      rate[2] += linear * d.back();
    rate[3] = linear * d[2] + along_stress * s[3];
    rate[4] = linear * d[3] + along_stress * s[4];
    if constexpr (micropolar)
      {
        // a_1^2 a_c in one polynomial, so that 1/a_1 is never formed again
        const Number along_couple =
          factors.f_s * (a_1_square * power +
                         nonlinear * (constants.polar_inverse +
                                      a_1 * (constants.polar_number +
                                             a_1 * constants.polar_linear)));
        rate[5] = linear * d[4] + along_couple * s[5];
        rate[6] = linear * d[5] + along_couple * s[6];
      }
    return rate;
  }
} // namespace Riedel::Material
