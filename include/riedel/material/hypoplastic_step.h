// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/continuum/lanes.h>
#include <riedel/continuum/plane_tensor.h>
#include <riedel/material/hypoplastic_rate.h>
#include <riedel/material/law.h>
#include <riedel/material/substepping.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

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



  /// What happened to a point in a step.
  struct HypoplasticPointReport
  {
    bool             floored = false;
    HypoplasticFlags flags;
    unsigned int     substeps = 0;
  };



  /// The values of an array of numbers.
  template <typename Number, std::size_t n>
  std::array<Continuum::ValueOf<Number>, n>
  values_of(const std::array<Number, n> &numbers)
  {
    std::array<Continuum::ValueOf<Number>, n> values;
    for (std::size_t i = 0; i < n; ++i)
      values[i] = Continuum::value_of(numbers[i]);
    return values;
  }



  /// What drives a point through a step: d^c dt and k d_50 dt in the fixed
  /// frame, and the spin by which the rotating frame turns.
  /// @tparam axis_3 is d_33 given, as in element tests? Otherwise it is zero.
  template <bool micropolar, typename Number, bool axis_3 = false>
  struct HypoplasticLoading
  {
    Continuum::PlaneTensor<Number> d;
    std::array<Number, 2>          k;
    Number                         spin;
    /// sqrt(d^c:d^c + (k d_50)^2), the same in every frame
    Number length;
    /// d_33 dt, the same in every frame
    std::array<Number, axis_3 ? 1 : 0> d_33;

    /// Components in the frame that has turned for the part @p time of the
    /// step.
    HypoplasticStretching<micropolar, Number, axis_3>
    at(const double time) const
    {
      if (time == 0.)
        return components(d, k);
      const Continuum::PlaneRotation<Number> rotation(spin * time);
      return components(d.to_turned_frame(rotation),
                        micropolar ? to_turned_frame(k, rotation) : k);
    }

    HypoplasticLoading<micropolar, Continuum::ValueOf<Number>, axis_3>
    values() const
    {
      HypoplasticLoading<micropolar, Continuum::ValueOf<Number>, axis_3> result{
        {Continuum::value_of(d.mean),
         Continuum::value_of(d.difference),
         Continuum::value_of(d.shear),
         Continuum::value_of(d.turn)},
        values_of(k),
        Continuum::value_of(spin),
        Continuum::value_of(length),
        {}};
      if constexpr (axis_3)
        result.d_33 = values_of(d_33);
      return result;
    }

  private:
    HypoplasticStretching<micropolar, Number, axis_3>
    components(const Continuum::PlaneTensor<Number> &d,
               const std::array<Number, 2>          &k) const
    {
      const Number d_11 = d.mean + d.difference;
      const Number d_22 = d.mean - d.difference;
      if constexpr (micropolar && axis_3)
        return {{d_11,
                 d_22,
                 d.shear - d.turn,
                 d.shear + d.turn,
                 k[0],
                 k[1],
                 d_33[0]}};
      else if constexpr (micropolar)
        return {{d_11, d_22, d.shear - d.turn, d.shear + d.turn, k[0], k[1]}};
      else if constexpr (axis_3)
        return {{d_11, d_22, d.shear, d.shear, d_33[0]}};
      else
        return {{d_11, d_22, d.shear, d.shear}};
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



  /// One substep of the integrator.
  template <bool micropolar, typename Number, bool axis_3 = false>
  struct HypoplasticSubstep
  {
    using Value         = Continuum::ValueOf<Number>;
    using Loading       = HypoplasticLoading<micropolar, Number, axis_3>;
    using LoadingValues = HypoplasticLoading<micropolar, Value, axis_3>;
    using Condition     = Continuum::ConditionOf<Number>;
    using Flags         = BasicHypoplasticFlags<Condition>;
    using Stress        = HypoplasticStress<micropolar, Number>;
    using StressValues  = HypoplasticStress<micropolar, Value>;

    /// Start and length, as parts of the step.
    struct Interval
    {
      double begin;
      double length;
    };

    Stress       end;
    StressValues rate_end;
    /// estimated error, relative to the size of the stresses
    Value error;
    /// of the stages inside the substep
    Flags flags;
    /// of its end
    Flags flags_end;

    /**
     * Takes the substep. Returns false, with the other members undefined, if
     * a stage or the end is in tension.
     *
     * @param volumes 1 + e at 1/2, 3/4 and the end of the substep
     */
    Condition
    attempt(const HypoplasticConstants  &constants,
            const double                 floor_pressure,
            const Interval              &interval,
            const Stress                &begin,
            const Stress                &rate_begin,
            const std::array<Number, 3> &volumes,
            const Loading               &loading,
            const LoadingValues         &loading_values)
    {
      using Continuum::any;
      using std::max;
      using std::sqrt;

      const double t = interval.begin;
      const double h = interval.length;
      const double lowest =
        HypoplasticControls::smallest_stage_pressure * floor_pressure;
      flags = flags_end = Flags();

      Stress stage;
      for (unsigned int i = 0; i < stage.size(); ++i)
        stage[i] = begin[i] + (.5 * h) * rate_begin[i];
      Condition compressive = mean_pressure(stage) > lowest;
      if (!any(compressive))
        return compressive;
      const Stress rate_half =
        hypoplastic_rate<micropolar, Number, axis_3>(constants,
                                                     stage,
                                                     volumes[0] - 1.,
                                                     loading.at(t + .5 * h),
                                                     loading.length,
                                                     flags);

      for (unsigned int i = 0; i < stage.size(); ++i)
        stage[i] = begin[i] + (.75 * h) * rate_half[i];
      compressive = compressive && mean_pressure(stage) > lowest;
      if (!any(compressive))
        return compressive;
      const Stress rate_quarter =
        hypoplastic_rate<micropolar, Number, axis_3>(constants,
                                                     stage,
                                                     volumes[1] - 1.,
                                                     loading.at(t + .75 * h),
                                                     loading.length,
                                                     flags);

      for (unsigned int i = 0; i < end.size(); ++i)
        end[i] = begin[i] + (h * BogackiShampine::advance[0]) * rate_begin[i] +
                 (h * BogackiShampine::advance[1]) * rate_half[i] +
                 (h * BogackiShampine::advance[2]) * rate_quarter[i];
      compressive =
        compressive && mean_pressure(end) > lowest && is_compressive(end);
      if (!any(compressive))
        return compressive;

      // the last stage serves the error only, and needs no derivatives
      const StressValues values = values_of(end);
      rate_end                  = hypoplastic_rate<micropolar, Value, axis_3>(
        constants,
        values,
        Continuum::value_of(volumes[2]) - 1.,
        loading_values.at(t + h),
        loading_values.length,
        flags_end);

      // Separate norms of stress and couple stress. Their lower bounds keep
      // points near the floor, or without couple stress, from endless
      // accuracy.
      Value stress_error = 0., couple_error = 0.;
      Value stress_scale = 0., couple_scale = 0.;
      for (unsigned int i = 0; i < end.size(); ++i)
        {
          const Value difference =
            h *
            (BogackiShampine::error[0] * Continuum::value_of(rate_begin[i]) +
             BogackiShampine::error[1] * Continuum::value_of(rate_half[i]) +
             BogackiShampine::error[2] * Continuum::value_of(rate_quarter[i]) +
             BogackiShampine::error[3] * rate_end[i]);
          (i < 5 ? stress_error : couple_error) += difference * difference;
          (i < 5 ? stress_scale : couple_scale) += values[i] * values[i];
        }
      stress_scale =
        max(stress_scale, Value(100. * floor_pressure * floor_pressure));
      couple_scale       = max(couple_scale, Value(.01 * stress_scale));
      Value error_square = stress_error / stress_scale;
      if constexpr (micropolar)
        error_square = max(error_square, Value(couple_error / couple_scale));
      error = sqrt(error_square);
      return compressive;
    }
  };



  /**
   * The integration of hypoplastic_rate() over a step in the rotating frame:
   * adaptive substeps, and the floor under the pressure.
   */
  template <bool micropolar, typename Number, bool axis_3 = false>
  class HypoplasticStep
  {
  public:
    using Value     = Continuum::ValueOf<Number>;
    using Condition = Continuum::ConditionOf<Number>;
    using Stress    = HypoplasticStress<micropolar, Number>;
    using Loading   = HypoplasticLoading<micropolar, Number, axis_3>;

    /**
     * @param log_j ln of the ratio of volumes, end to start of the step
     * @param initial_volume 1 + e at the start
     * @param final_void_ratio e at the end
     */
    HypoplasticStep(const HypoplasticConstants &constants,
                    const HypoplasticControls  &controls,
                    const Loading              &loading,
                    const Number               &log_j,
                    const Value                &initial_volume,
                    const Number               &final_void_ratio)
      : constants(constants)
      , controls(controls)
      , loading(loading)
      , log_j(log_j)
      , initial_volume(initial_volume)
      , final_void_ratio(final_void_ratio)
    {}

    /**
     * Takes the stresses @p y from the start to the end of the step.
     *
     * @param substep_strain strain that one substep resolves: read for the
     *   first substep, and replaced by what this step has found
     */
    Report::Refusal
    integrate(Stress                 &y,
              double                 &substep_strain,
              HypoplasticPointReport &report) const
    {
      constexpr bool with_tangent = !std::is_same<Number, double>::value;

      const auto   loading_values = loading.values();
      const double strain         = loading_values.length;
      const double stored_strain  = substep_strain;

      Number volume   = Number(initial_volume);
      bool   on_floor = false;
      Stress rate_begin{};

      // A point that starts on the floor, or falls on it, goes the rest of the
      // step at a constant rate and is returned to the floor at its end: the
      // stress is then a continuous function of the strain, without which
      // there may be no balance.
      const auto go_straight = [&](const double rest) {
        const double steepest = std::max(steepest_on_floor(), steepness(y));
        for (unsigned int i = 0; i < y.size(); ++i)
          y[i] += rest * rate_begin[i];
        on_floor       = return_to_floor(y, final_void_ratio, steepest);
        report.floored = report.floored || on_floor;
        ++report.substeps;
      };

      const double initial_void_ratio = initial_volume - 1.;
      if (mean_pressure(y) < controls.smallest_pressure(initial_void_ratio) *
                               (1. - floor_tolerance) ||
          !is_compressive(y))
        {
          return_to_floor(y, Number(initial_void_ratio), steepest_on_floor());
          report.floored = true;
        }
      const bool starts_on_floor = is_on_floor(y, initial_void_ratio);

      HypoplasticSubstep<micropolar, Number, axis_3> substep;
      HypoplasticFlags                               flags_begin;
      bool                                           rate_begin_known = false;
      bool                                           rejected         = false;
      BinarySubsteps substeps(controls.n_smallest_substeps,
                              strain > 0. ? stored_strain / strain : 1.);
      while (!substeps.done())
        {
          const double h = substeps.length();
          const double t = substeps.begin();

          if (!rate_begin_known)
            {
              flags_begin = HypoplasticFlags();
              rate_begin =
                hypoplastic_rate<micropolar, Number, axis_3>(constants,
                                                             y,
                                                             volume - 1.,
                                                             loading.at(t),
                                                             loading.length,
                                                             flags_begin);
              rate_begin_known = true;
            }

          if (starts_on_floor)
            {
              report.flags.merge(flags_begin);
              go_straight(1.);
              break;
            }

          const std::array<Number, 3> volumes     = stage_volumes(volume, h);
          const Number               &volume_end  = volumes[2];
          const bool                  compressive = substep.attempt(constants,
                                                   controls.floor_pressure,
                                                   {t, h},
                                                   y,
                                                   rate_begin,
                                                   volumes,
                                                   loading,
                                                   loading_values);
          if (!compressive && !substeps.is_smallest())
            {
              substeps.reject();
              rejected = true;
              continue;
            }
          if (!compressive)
            {
              report.flags.merge(flags_begin);
              go_straight(1. - t);
              break;
            }
          else
            {
              const double error = substep.error / controls.substep_tolerance;
              if (!(error <= 1.))
                {
                  if (substeps.is_smallest())
                    return std::isfinite(error) ?
                             Report::Refusal::too_many_substeps :
                             Report::Refusal::not_finite;
                  substeps.reject(h * BogackiShampine::suggested_length(error));
                  rejected = true;
                  continue;
                }

              y = substep.end;
              report.flags.merge(flags_begin);
              report.flags.merge(substep.flags);
              if (mean_pressure(y) < controls.smallest_pressure(
                                       Continuum::value_of(volume_end) - 1.))
                {
                  go_straight(1. - (t + h));
                  break;
                }

              // the last stage is the first of the next substep; in tangent
              // mode it was computed without derivatives
              rate_begin_known = false;
              if constexpr (!with_tangent)
                {
                  rate_begin       = substep.rate_end;
                  flags_begin      = substep.flags_end;
                  rate_begin_known = true;
                }

              double wanted = 1.;
              if (h < 1. ||
                  substep_strain < HypoplasticControls::largest_substep_strain)
                {
                  // without a rejection the step says nothing against what
                  // earlier steps have found
                  wanted         = h * BogackiShampine::suggested_length(error);
                  substep_strain = rejected ?
                                     wanted * strain :
                                     std::max(stored_strain, wanted * strain);
                  substep_strain =
                    std::min(substep_strain,
                             HypoplasticControls::largest_substep_strain);
                }
              substeps.accept(wanted);
            }
          volume = volume_end;
          ++report.substeps;
        }

      // On the floor the stress does not feel the strain. A solver needs some
      // stiffness there: the isotropic one of the law at this pressure.
      if (with_tangent && on_floor)
        add_floor_stiffness(y);
      return Report::Refusal::none;
    }

    /**
     * integrate() for several points at once, in the usual case: one substep
     * spans the step, as the point believed from the start, which is not on the
     * floor and does not come to it. Returns for which points that is so; what
     * it leaves of the others means nothing.
     */
    Condition
    integrate_at_once(Stress                     &y,
                      Value                      &substep_strain,
                      HypoplasticFlagsOf<Number> &flags) const
    {
      using std::max;
      using std::min;

      const auto   loading_values     = loading.values();
      const Value &strain             = loading_values.length;
      const Value  initial_void_ratio = initial_volume - 1.;

      Condition usual =
        substep_strain >= strain && is_compressive(y) &&
        mean_pressure(y) > controls.smallest_pressure(initial_void_ratio) *
                             (1. + floor_tolerance);
      if (!Continuum::any(usual))
        return usual;

      const Stress rate_begin =
        hypoplastic_rate<micropolar, Number, axis_3>(constants,
                                                     y,
                                                     initial_void_ratio,
                                                     loading.at(0.),
                                                     loading.length,
                                                     flags);
      HypoplasticSubstep<micropolar, Number, axis_3> substep;
      const std::array<Number, 3> volumes = stage_volumes(initial_volume, 1.);
      const Condition             compressive = substep.attempt(constants,
                                                    controls.floor_pressure,
                                                    {0., 1.},
                                                    y,
                                                    rate_begin,
                                                    volumes,
                                                    loading,
                                                    loading_values);
      usual                                   = usual && compressive;
      if (!Continuum::any(usual))
        return usual;
      flags.merge(substep.flags);
      const Value error = substep.error / controls.substep_tolerance;
      y                 = substep.end;
      usual             = usual && error <= 1. &&
              mean_pressure(y) >= controls.smallest_pressure(volumes[2] - 1.);

      const Value largest(HypoplasticControls::largest_substep_strain);
      if (Continuum::any(substep_strain < largest))
        {
          const Value resolved =
            strain * BogackiShampine::suggested_length(error);
          substep_strain =
            Continuum::select(substep_strain < largest,
                              min(max(substep_strain, resolved), largest),
                              substep_strain);
        }
      return usual;
    }

  private:
    /// Relative distance from the floor that counts as none.
    static constexpr double floor_tolerance = 1e-9;

    /// 1 + e at 1/2, 3/4 and the end of a substep, with one exponential
    std::array<Number, 3>
    stage_volumes(const Number &begin, const double length) const
    {
      using std::exp;
      const Number growth      = exp(log_j * (.25 * length));
      const Number growth_half = growth * growth;
      const Number half        = begin * growth_half;
      return {{half, half * growth, half * growth_half}};
    }

    /// |deviator and couple stress| / mean pressure of the steepest critical
    /// state, 3/c_1; there the principal stresses are still compressive.
    double
    steepest_on_floor() const
    {
      return 3. / constants.c_1;
    }

    /// |deviator and couple stress| / mean pressure, but no more than what
    /// keeps the principal stresses compressive; 0 without pressure.
    static double
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
    bool
    return_to_floor(Stress       &y,
                    const Number &void_ratio,
                    const double  steepest) const
    {
      using std::sqrt;
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

    Condition
    is_on_floor(const Stress &y, const Value &void_ratio) const
    {
      return mean_pressure(y) <=
             controls.smallest_pressure(void_ratio) * (1. + floor_tolerance);
    }

    /// Adds f_s (a_1^2 d^c + I tr d^c / 9) and f_s a_1^2 k d_50 at the
    /// pressure of @p y to its derivatives, not to its value. d_33 is a given
    /// number without derivatives, if there is one.
    void
    add_floor_stiffness(Stress &y) const
    {
      using Continuum::only_derivatives;
      HypoplasticFlags                 ignored;
      const HypoplasticFactors<double> factors(constants,
                                               -3. * mean_pressure(y),
                                               0.,
                                               0.,
                                               Continuum::value_of(
                                                 final_void_ratio),
                                               ignored);
      const auto                       d = loading.at(1.);
      const double stiffness = factors.f_s * factors.a_1 * factors.a_1;
      const Number isotropic = (factors.f_s / 9.) * (d[0] + d[1]);
      y[0] += only_derivatives(stiffness * d[0] + isotropic);
      y[1] += only_derivatives(stiffness * d[1] + isotropic);
      y[2] += only_derivatives(isotropic);
      for (unsigned int i = 2; i + 1 < y.size(); ++i)
        y[1 + i] += only_derivatives(stiffness * d[i]);
    }

    const HypoplasticConstants &constants;
    const HypoplasticControls  &controls;
    const Loading              &loading;
    const Number               &log_j;
    const Value                 initial_volume;
    const Number               &final_void_ratio;
  };
} // namespace Riedel::Material
