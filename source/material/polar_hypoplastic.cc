// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/continuum/lanes.h>
#include <riedel/material/hypoplastic_response.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Riedel::Material
{
  using Continuum::Forward;

  namespace
  {
    template <bool micropolar>
    StateLayout
    make_layout()
    {
      StateLayout layout;
      layout.add("stress",
                 "Pa",
                 "Cauchy stress, tension positive, second index: face normal",
                 {"11", "22", "33", "12", "21"});
      if (micropolar)
        layout.add("couple_stress",
                   "N/m",
                   "couple stress m_31, m_32 on faces with normals 1, 2",
                   {"1", "2"});
      layout.add("void_ratio", "1", "volume of pores over volume of grains");
      layout.add("substep",
                 "1",
                 "strain that one substep of the law resolves; a step's first "
                 "substep follows from it");
      return layout;
    }

    /// How many points are computed at once.
    constexpr int n_lanes = Continuum::n_native_lanes;
  } // namespace



  template <bool micropolar>
  Hypoplastic<micropolar>::Hypoplastic()
    : slots(make_layout<micropolar>())
  {}



  template <bool micropolar>
  std::string
  Hypoplastic<micropolar>::name() const
  {
    return micropolar ? "polar hypoplastic" : "hypoplastic";
  }



  template <bool micropolar>
  void
  Hypoplastic<micropolar>::initialise(const InitialState &initial,
                                      double             *state) const
  {
    std::fill(state, state + slots.size(), 0.);
    double *stress           = state + Place::stress;
    stress[0]                = initial.stress[0][0];
    stress[1]                = initial.stress[1][1];
    stress[2]                = initial.stress[2][2];
    stress[3]                = initial.stress[0][1];
    stress[4]                = initial.stress[1][0];
    state[Place::void_ratio] = initial.void_ratio;
    state[Place::substep]    = HypoplasticControls::largest_substep_strain;
  }



  template <bool micropolar>
  void
  Hypoplastic<micropolar>::stresses_at_rest(const double *state,
                                            double       *stresses) const
  {
    const double *stress = state + Place::stress;
    stresses[0]          = stress[0];
    stresses[1]          = stress[3];
    stresses[2]          = stress[4];
    stresses[3]          = stress[1];
    if constexpr (micropolar)
      {
        stresses[4] = stress[3] - stress[4];
        stresses[5] = state[Place::couple_stress];
        stresses[6] = state[Place::couple_stress + 1];
      }
  }



  template <bool micropolar>
  double
  Hypoplastic<micropolar>::stiffness(const double *state) const
  {
    const double          void_ratio = state[Place::void_ratio];
    std::array<double, 5> stress;
    std::copy_n(state + Place::stress, stress.size(), stress.begin());

    const double floor = parameters.controls.smallest_pressure(void_ratio);
    if (!(mean_pressure(stress) >= floor) || !is_compressive(stress))
      stress = {{-floor, -floor, -floor, 0., 0.}};

    const double trace = stress[0] + stress[1] + stress[2];
    for (double &component : stress)
      component /= trace;
    const double determinant =
      (stress[0] - 1. / 3.) * (stress[1] - 1. / 3.) - stress[3] * stress[4];
    HypoplasticFlags                 ignored;
    const HypoplasticFactors<double> factors(parameters.constants,
                                             trace,
                                             stress[2] - 1. / 3.,
                                             determinant,
                                             void_ratio,
                                             ignored);
    return factors.f_s * factors.a_1 * factors.a_1;
  }



  template <bool micropolar>
  template <typename Number>
  void
  Hypoplastic<micropolar>::respond_group(const Batch       &batch,
                                         const unsigned int first,
                                         Report            &report) const
  {
    using Value                         = Continuum::ValueOf<Number>;
    using Mask                          = Continuum::Mask<n_lanes>;
    using Step                          = HypoplasticPoint<micropolar, Number>;
    constexpr bool         with_tangent = !std::is_same<Number, Value>::value;
    constexpr unsigned int n            = Step::n;
    constexpr unsigned int n_state      = Place::n;

    // where the batch ends inside the group, its last point fills the lanes
    const unsigned int n_points =
      std::min<unsigned int>(n_lanes, batch.n_points - first);
    std::array<Number, n>      inputs;
    std::array<Value, n_state> committed;
    Continuum::read_rows(batch.increments + first * n, n_points, inputs);
    Continuum::read_rows(batch.committed + first * n_state,
                         n_points,
                         committed);

    Step                       step(inputs);
    HypoplasticFlagsOf<Number> flags;
    Mask                       usual = step.kinematics.valid;
    if (any(usual))
      {
        step.start(inputs, committed, parameters.constants.mean_grain_diameter);
        usual = usual && is_finite(step.sum_at_start()) &&
                abs(Continuum::value_of(step.loading.spin)) <
                  Continuum::Turn<Value>::largest_small_angle;
        usual =
          usual && step.integrator(parameters.constants, parameters.controls)
                     .integrate_at_once(step.y, step.substep_strain, flags);
        step.finish(parameters.constants.mean_grain_diameter);
        usual = usual && is_finite(step.sum_at_end());
      }

    for (unsigned int lane = 0; lane < n_points; ++lane)
      if (usual[lane])
        {
          const unsigned int p = first + lane;
          for (unsigned int i = 0; i < n_state; ++i)
            batch.trial[p * n_state + i] = step.trial[i][lane];
          Continuum::write_row(step.generalised,
                               lane,
                               batch.stresses + p * n,
                               with_tangent ? batch.tangents + p * n * n :
                                              nullptr);
          report.clamped += flags.clamped[lane];
          report.null_deviator += flags.null_deviator[lane];
          ++report.substeps;
        }
      else
        respond_point<
          std::conditional_t<with_tangent, Forward<micropolar ? 8 : 4>, double>,
          false>(batch, first + lane, report);
  }



  template <bool micropolar>
  Report
  Hypoplastic<micropolar>::respond(const Batch &batch) const
  {
    using Value       = Continuum::Lanes<n_lanes>;
    using WithTangent = Forward<HypoplasticPoint<micropolar, Value>::n, Value>;
    Report report;
    if (batch.axis_3_strains != nullptr)
      return respond_across_plane(batch);
    for (unsigned int first = 0; first < batch.n_points; first += n_lanes)
      if (batch.tangents == nullptr)
        respond_group<Value>(batch, first, report);
      else
        respond_group<WithTangent>(batch, first, report);
    return report;
  }



  template <bool micropolar>
  void
  Hypoplastic<micropolar>::declare(dealii::ParameterHandler &prm) const
  {
    HypoplasticParameters::declare(micropolar, prm);
  }



  template <bool micropolar>
  void
  Hypoplastic<micropolar>::parse(dealii::ParameterHandler &prm)
  {
    parameters.parse(micropolar, prm);
  }



  template <bool micropolar>
  void
  Hypoplastic<micropolar>::check(const std::string &path,
                                 Problems          &problems) const
  {
    parameters.check(micropolar, path, problems);
  }



  template <bool micropolar>
  void
  Hypoplastic<micropolar>::check_initial(const InitialState &initial,
                                         const std::string  &path,
                                         Problems           &problems) const
  {
    parameters.check_initial(initial, path, problems);
  }



  template class Hypoplastic<true>;
  template class Hypoplastic<false>;
} // namespace Riedel::Material
