// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/material/hypoplastic_substep.h>
#include <riedel/material/law.h>
#include <riedel/material/substepping.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

namespace Riedel::Material
{
  /// What happened to a point in a step.
  struct HypoplasticPointReport
  {
    bool             floored = false;
    HypoplasticFlags flags;
    unsigned int     substeps = 0;
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

      put_on_floor(y, report);
      if (is_on_floor(y))
        {
          const Stress rate = rate_at(y, Number(initial_volume), 0., report);
          go_straight(rate, 1., y, report);
          return Report::Refusal::none;
        }

      const auto   loading_values   = loading.values();
      const double strain           = loading_values.length;
      const double stored_strain    = substep_strain;
      Number       volume           = Number(initial_volume);
      bool         rate_begin_known = false;
      bool         rejected         = false;
      Stress       rate_begin{};

      HypoplasticSubstep<micropolar, Number, axis_3> substep;
      BinarySubsteps substeps(controls.n_smallest_substeps,
                              strain > 0. ? stored_strain / strain : 1.);
      while (!substeps.done())
        {
          const double h = substeps.length();
          const double t = substeps.begin();

          if (!rate_begin_known)
            {
              rate_begin       = rate_at(y, volume, t, report);
              rate_begin_known = true;
            }
          const std::array<Number, 3> volumes = stage_volumes(volume, h);
          if (!substep.attempt(constants,
                               controls.floor_pressure,
                               {t, h},
                               y,
                               rate_begin,
                               volumes,
                               loading,
                               loading_values))
            {
              if (substeps.is_smallest())
                {
                  go_straight(rate_begin, 1. - t, y, report);
                  return Report::Refusal::none;
                }
              substeps.reject();
              rejected = true;
              continue;
            }

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

          y      = substep.end;
          volume = volumes[2];
          report.flags.merge(substep.flags);
          if (mean_pressure(y) <
              controls.smallest_pressure(Continuum::value_of(volume) - 1.))
            {
              go_straight(rate_begin, 1. - (t + h), y, report);
              return Report::Refusal::none;
            }

          // the last stage is the first of the next substep; in tangent
          // mode it was computed without derivatives
          rate_begin_known = false;
          if constexpr (!with_tangent)
            if (t + h < 1.)
              {
                rate_begin       = substep.rate_end;
                rate_begin_known = true;
                report.flags.merge(substep.flags_end);
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
          ++report.substeps;
        }
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
      // the state at the start has no derivatives
      const auto begin = values_of(y);

      Condition usual =
        substep_strain >= strain && is_compressive(y) &&
        mean_pressure(y) > controls.smallest_pressure(initial_void_ratio) *
                             (1. + floor_tolerance);
      if (!Continuum::any(usual))
        return usual;

      const Stress rate_begin =
        hypoplastic_rate<micropolar, Number, axis_3, Value>(constants,
                                                            begin,
                                                            initial_void_ratio,
                                                            loading.at(0.),
                                                            loading.length,
                                                            flags);
      HypoplasticSubstep<micropolar, Number, axis_3> substep;
      const std::array<Number, 3> volumes = stage_volumes(initial_volume, 1.);
      const Condition             compressive = substep.attempt(constants,
                                                    controls.floor_pressure,
                                                    {0., 1.},
                                                    begin,
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
              mean_pressure(y) >= controls.smallest_pressure(
                                    Continuum::value_of(volumes[2]) - 1.);

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
    template <typename Begin>
    std::array<Number, 3>
    stage_volumes(const Begin &begin, const double length) const
    {
      using std::exp;
      const Number growth      = exp(log_j * (.25 * length));
      const Number growth_half = growth * growth;
      const Number half        = begin * growth_half;
      return {{half, half * growth, half * growth_half}};
    }

    Stress
    rate_at(const Stress           &y,
            const Number           &volume,
            const double            time,
            HypoplasticPointReport &report) const
    {
      return hypoplastic_rate<micropolar, Number, axis_3>(constants,
                                                          y,
                                                          volume - 1.,
                                                          loading.at(time),
                                                          loading.length,
                                                          report.flags);
    }

    /// Puts a point that starts below the floor, or in tension, on it.
    void
    put_on_floor(Stress &y, HypoplasticPointReport &report) const
    {
      const double void_ratio = initial_volume - 1.;
      if (mean_pressure(y) >=
            controls.smallest_pressure(void_ratio) * (1. - floor_tolerance) &&
          is_compressive(y))
        return;
      return_to_floor(controls,
                      Number(void_ratio),
                      steepest_on_floor(constants),
                      y);
      report.floored = true;
    }

    /// Is it on the floor at the start of the step?
    bool
    is_on_floor(const Stress &y) const
    {
      return mean_pressure(y) <=
             controls.smallest_pressure(Value(initial_volume - 1.)) *
               (1. + floor_tolerance);
    }

    /// A point that starts on the floor, or falls on it, goes the @p rest of
    /// the step at a constant rate and is returned to the floor at its end: the
    /// stress is then a continuous function of the strain, without which there
    /// may be no balance.
    void
    go_straight(const Stress           &rate,
                const double            rest,
                Stress                 &y,
                HypoplasticPointReport &report) const
    {
      const double steepest =
        std::max(steepest_on_floor(constants), steepness(y));
      for (unsigned int i = 0; i < y.size(); ++i)
        y[i] += rest * rate[i];
      const bool on_floor =
        return_to_floor(controls, final_void_ratio, steepest, y);
      if (!std::is_same<Number, double>::value && on_floor)
        add_floor_stiffness(constants,
                            Continuum::value_of(final_void_ratio),
                            loading.at(1.),
                            y);
      report.floored = report.floored || on_floor;
      ++report.substeps;
    }

    const HypoplasticConstants &constants;
    const HypoplasticControls  &controls;
    const Loading              &loading;
    const Number               &log_j;
    const Value                 initial_volume;
    const Number               &final_void_ratio;
  };
} // namespace Riedel::Material
