// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/material/hypoplastic_floor.h>
#include <riedel/material/hypoplastic_loading.h>
#include <riedel/material/substepping.h>

#include <array>
#include <cmath>

namespace Riedel::Material
{
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
     * @tparam Begin Stress, or StressValues at the start of a step
     */
    template <typename Begin>
    Condition
    attempt(const HypoplasticConstants  &constants,
            const double                 floor_pressure,
            const Interval              &interval,
            const Begin                 &begin,
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
} // namespace Riedel::Material
