// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/continuum/forward.h>
#include <riedel/material/hypoplastic_point.h>
#include <riedel/material/polar_hypoplastic.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

/// The answer of one point, for the files that instantiate it.
namespace Riedel::Material
{
  template <bool micropolar>
  template <typename Number, bool axis_3>
  Report::Refusal
  Hypoplastic<micropolar>::respond_point(const double           *increment,
                                         const double            axis_3_strain,
                                         const double           *committed,
                                         double                 *trial,
                                         double                 *stresses,
                                         double                 *tangent,
                                         HypoplasticPointReport &report) const
  {
    using Step               = HypoplasticPoint<micropolar, Number, axis_3>;
    constexpr unsigned int n = Step::n;

    std::array<Number, n> inputs;
    for (unsigned int i = 0; i < n; ++i)
      inputs[i] = Continuum::input<Number>(increment[i], i);
    std::array<double, Place::n> state;
    std::copy_n(committed, state.size(), state.begin());

    Step step(inputs);
    if (!step.kinematics.valid)
      return std::isfinite(Continuum::value_of(step.kinematics.j)) ?
               Report::Refusal::inverted_step :
               Report::Refusal::not_finite;
    step.start(inputs,
               state,
               parameters.constants.mean_grain_diameter,
               axis_3_strain);
    if (!std::isfinite(step.sum_at_start()))
      return Report::Refusal::not_finite;

    const Report::Refusal refusal =
      step.integrator(parameters.constants, parameters.controls)
        .integrate(step.y, step.substep_strain, report);
    if (refusal != Report::Refusal::none)
      return refusal;

    step.finish(parameters.constants.mean_grain_diameter);
    if (!std::isfinite(step.sum_at_end()))
      return Report::Refusal::not_finite;

    std::copy(step.trial.begin(), step.trial.end(), trial);
    for (unsigned int a = 0; a < n; ++a)
      stresses[a] = Continuum::value_of(step.generalised[a]);
    if constexpr (!std::is_same<Number, double>::value)
      for (unsigned int a = 0; a < n; ++a)
        step.generalised[a].derivatives.copy_to(tangent + a * n, n);
    else
      (void)tangent;
    return Report::Refusal::none;
  }



  template <bool micropolar>
  template <typename Number, bool axis_3>
  void
  Hypoplastic<micropolar>::respond_point(const Batch       &batch,
                                         const unsigned int p,
                                         Report            &report) const
  {
    constexpr unsigned int n_state = Place::n;
    constexpr unsigned int n       = HypoplasticPoint<micropolar, Number>::n;

    HypoplasticPointReport point;
    const Report::Refusal  refusal =
      respond_point<Number, axis_3>(batch.increments + p * n,
                                    axis_3 ? batch.axis_3_strains[p] : 0.,
                                    batch.committed + p * n_state,
                                    batch.trial + p * n_state,
                                    batch.stresses + p * n,
                                    batch.tangents == nullptr ?
                                      nullptr :
                                      batch.tangents + p * n * n,
                                    point);
    if (refusal != Report::Refusal::none)
      {
        if (report.refused == 0)
          {
            report.first_refused = p;
            report.reason        = refusal;
          }
        ++report.refused;
        return;
      }
    report.floored += point.floored;
    report.clamped += point.flags.clamped;
    report.null_deviator += point.flags.null_deviator;
    report.substeps += point.substeps;
  }
} // namespace Riedel::Material
