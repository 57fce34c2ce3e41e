// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/continuum/generalised.h>
#include <riedel/continuum/step_kinematics.h>
#include <riedel/material/hypoplastic_places.h>
#include <riedel/material/hypoplastic_step.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Riedel::Material
{
  /**
   * What surrounds the integration of a step: kinematics, the state in the
   * rotating frame, and the way back to the fixed frame. Number is that of
   * one point or Lanes for several. With axis_3, a strain of axis 3 is given,
   * too.
   */
  template <bool micropolar, typename Number, bool axis_3 = false>
  struct HypoplasticPoint
  {
    using Value    = Continuum::ValueOf<Number>;
    using Place    = HypoplasticPlaces<micropolar>;
    using Rotation = Continuum::PlaneRotation<Number>;

    /// number of generalised components
    static constexpr unsigned int n =
      micropolar ? Continuum::Generalised<2>::n_micropolar :
                   Continuum::Generalised<2>::n_classical;

    Continuum::StepKinematics<Number>              kinematics;
    HypoplasticLoading<micropolar, Number, axis_3> loading;
    /// stress; couple stress divided by d_50
    HypoplasticStress<micropolar, Number> y;
    Value                                 initial_volume;
    Number                                final_void_ratio;
    Value                                 substep_strain;

    /// what the step makes of the point
    std::array<Value, Place::n> trial;
    std::array<Number, n>       generalised;

    /// Only the kinematics is set: it says whether the rest can be.
    explicit HypoplasticPoint(const std::array<Number, n> &inputs)
      : kinematics(inputs.data())
    {}

    void
    start(const std::array<Number, n>       &inputs,
          const std::array<Value, Place::n> &committed,
          const double                       mean_grain_diameter,
          [[maybe_unused]] const double      axis_3_strain = 0.)
    {
      loading.d    = kinematics.log_f;
      loading.k    = {{Number(0.), Number(0.)}};
      loading.spin = kinematics.log_f.turn;
      if constexpr (micropolar)
        {
          loading.d = kinematics.stretching(inputs[4]);
          loading.k =
            Continuum::StepKinematics<Number>::curvature(inputs.data(),
                                                         inputs.data() + 5);
          for (Number &component : loading.k)
            component = component * mean_grain_diameter;
        }
      if constexpr (axis_3)
        loading.d_33[0] = Number(axis_3_strain);
      loading.length = stretching_length(loading.at(0.));

      for (unsigned int i = 0; i < 5; ++i)
        y[i] = Number(committed[Place::stress + i]);
      if constexpr (micropolar)
        for (unsigned int i = 0; i < 2; ++i)
          y[5 + i] =
            Number(committed[Place::couple_stress + i] / mean_grain_diameter);
      initial_volume   = 1. + committed[Place::void_ratio];
      final_void_ratio = initial_volume * kinematics.j - 1.;
      if constexpr (axis_3)
        {
          // the volume is that of three axes; no store of its own, which
          // would cost plane strain 1 percent of the time of a tangent
          kinematics.log_j += Number(axis_3_strain);
          final_void_ratio =
            initial_volume * (kinematics.j * std::exp(axis_3_strain)) - 1.;
        }
      substep_strain = committed[Place::substep];
    }

    /// finite if everything that start() has set is
    Value
    sum_at_start() const
    {
      Value sum = Continuum::value_of(loading.length) +
                  Continuum::value_of(loading.spin) + initial_volume +
                  substep_strain;
      for (const Number &component : y)
        sum += Continuum::value_of(component);
      return sum;
    }

    HypoplasticStep<micropolar, Number, axis_3>
    integrator(const HypoplasticConstants &constants,
               const HypoplasticControls  &controls) const
    {
      return {constants,
              controls,
              loading,
              kinematics.log_j,
              initial_volume,
              final_void_ratio};
    }

    /// Back to the fixed frame and to the start-of-step configuration.
    void
    finish(const double mean_grain_diameter)
    {
      const Rotation                       rotation(loading.spin);
      const Continuum::PlaneTensor<Number> turned{.5 * (y[0] + y[1]),
                                                  .5 * (y[0] - y[1]),
                                                  .5 * (y[3] + y[4]),
                                                  .5 * (y[4] - y[3])};
      const std::array<Number, 4>          sigma =
        turned.to_fixed_frame(rotation).components();
      const std::array<Number, 4> P = kinematics.nominal(sigma);
      std::copy(P.begin(), P.end(), generalised.begin());

      trial[Place::stress]     = Continuum::value_of(sigma[0]);
      trial[Place::stress + 1] = Continuum::value_of(sigma[3]);
      trial[Place::stress + 2] = Continuum::value_of(y[2]);
      trial[Place::stress + 3] = Continuum::value_of(sigma[1]);
      trial[Place::stress + 4] = Continuum::value_of(sigma[2]);
      if constexpr (micropolar)
        {
          generalised[4] = kinematics.j * (-2. * turned.turn);
          const std::array<Number, 2> couple_stress = Continuum::to_fixed_frame(
            std::array<Number, 2>{
              {y[5] * mean_grain_diameter, y[6] * mean_grain_diameter}},
            rotation);
          const std::array<Number, 2> M = kinematics.nominal(couple_stress);
          std::copy(M.begin(), M.end(), generalised.begin() + 5);
          for (unsigned int i = 0; i < 2; ++i)
            trial[Place::couple_stress + i] =
              Continuum::value_of(couple_stress[i]);
        }
      trial[Place::void_ratio] = Continuum::value_of(final_void_ratio);
      trial[Place::substep]    = substep_strain;
    }

    /// finite if everything that finish() has set is
    Value
    sum_at_end() const
    {
      Value sum = Continuum::value_of(y[2]);
      for (const Number &component : generalised)
        sum += Continuum::value_of(component);
      return sum;
    }
  };
} // namespace Riedel::Material
