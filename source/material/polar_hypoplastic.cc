// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/continuum/generalised.h>
#include <riedel/continuum/step_kinematics.h>
#include <riedel/material/polar_hypoplastic.h>
#include <riedel/material/substepping.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <type_traits>

namespace Riedel::Material
{
  using Continuum::Forward;
  using Continuum::input;
  using Continuum::only_derivatives;
  using Continuum::to_fixed_frame;
  using Continuum::to_turned_frame;
  using Continuum::value_of;

  namespace
  {
    // Places in a point's state. The constructor declares the slots in this
    // order.
    constexpr unsigned int stress_place = 0;

    template <bool micropolar>
    struct Places
    {
      static constexpr unsigned int couple_stress = 5;
      static constexpr unsigned int void_ratio    = micropolar ? 7 : 5;
      static constexpr unsigned int substep       = void_ratio + 1;
      static constexpr unsigned int n             = substep + 1;
    };

    /// Strain that one substep resolves where nothing is known yet.
    constexpr double largest_substep_strain = 1.;

    /// Stiffness of the resistance against compaction below e_d [Pa]
    constexpr double compaction_resistance = 1e7;

    /// A stage whose pressure is below this part of the floor pressure is
    /// not evaluated: the rate is singular at zero pressure.
    constexpr double smallest_stage_pressure = .1;



    template <typename To, typename From, std::size_t n>
    std::array<To, n>
    convert(const std::array<From, n> &from)
    {
      if constexpr (std::is_same<To, From>::value)
        return from;
      else
        {
          std::array<To, n> to;
          for (std::size_t i = 0; i < n; ++i)
            to[i] = value_of(from[i]);
          return to;
        }
    }



    /// What drives a point through a step: d^c dt and k d_50 dt in the fixed
    /// frame, and the spin by which the rotating frame turns.
    template <bool micropolar, typename Number>
    struct Loading
    {
      Continuum::PlaneTensor<Number> d;
      std::array<Number, 2>          k;
      Number                         spin;
      /// sqrt(d^c:d^c + (k d_50)^2), the same in every frame
      Number length;

      /// Components in the frame that has turned for the part @p time of the
      /// step.
      HypoplasticStretching<micropolar, Number>
      at(const double time) const
      {
        if (time == 0.)
          return components(d, k);
        const Continuum::PlaneRotation<Number> rotation(spin * time);
        return components(d.to_turned_frame(rotation),
                          micropolar ? to_turned_frame(k, rotation) : k);
      }

      Loading<micropolar, double>
      values() const
      {
        return {{value_of(d.mean),
                 value_of(d.difference),
                 value_of(d.shear),
                 value_of(d.turn)},
                convert<double>(k),
                value_of(spin),
                value_of(length)};
      }

    private:
      static HypoplasticStretching<micropolar, Number>
      components(const Continuum::PlaneTensor<Number> &d,
                 const std::array<Number, 2>          &k)
      {
        const Number d_11 = d.mean + d.difference;
        const Number d_22 = d.mean - d.difference;
        if constexpr (micropolar)
          return {
            {d_11, d_22, d.shear - d.turn, d.shear + d.turn, k[0], k[1]}};
        else
          return {{d_11, d_22, d.shear, d.shear}};
      }
    };



    /// -tr sigma / 3 [Pa]
    template <typename Stress>
    double
    pressure(const Stress &y)
    {
      return (value_of(y[0]) + value_of(y[1]) + value_of(y[2])) * (-1. / 3.);
    }



    /// Are the principal stresses (of the symmetric part) compressive?
    template <typename Stress>
    bool
    is_compressive(const Stress &y)
    {
      const double s11 = value_of(y[0]), s22 = value_of(y[1]);
      const double s12 = .5 * (value_of(y[3]) + value_of(y[4]));
      return s11 + s22 < 0. && s11 * s22 > s12 * s12 && value_of(y[2]) < 0.;
    }



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
  } // namespace



  template <bool micropolar>
  struct Hypoplastic<micropolar>::PointReport
  {
    bool             floored = false;
    HypoplasticFlags flags;
    unsigned int     substeps = 0;
  };



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
    double *stress = state + stress_place;
    stress[0]      = initial.stress[0][0];
    stress[1]      = initial.stress[1][1];
    stress[2]      = initial.stress[2][2];
    stress[3]      = initial.stress[0][1];
    stress[4]      = initial.stress[1][0];
    state[Places<micropolar>::void_ratio] = initial.void_ratio;
    state[Places<micropolar>::substep]    = largest_substep_strain;
  }



  template <bool micropolar>
  void
  Hypoplastic<micropolar>::stresses_at_rest(const double *state,
                                            double       *stresses) const
  {
    const double *stress = state + stress_place;
    stresses[0]          = stress[0];
    stresses[1]          = stress[3];
    stresses[2]          = stress[4];
    stresses[3]          = stress[1];
    if constexpr (micropolar)
      {
        stresses[4] = stress[3] - stress[4];
        stresses[5] = state[Places<micropolar>::couple_stress];
        stresses[6] = state[Places<micropolar>::couple_stress + 1];
      }
  }



  template <bool micropolar>
  template <typename Number>
  Number
  Hypoplastic<micropolar>::smallest_pressure(const Number &void_ratio) const
  {
    if (value_of(void_ratio) < densest_at_floor)
      return floor_pressure + compaction_resistance *
                                (densest_at_floor - void_ratio) /
                                (1. + void_ratio);
    return Number(floor_pressure);
  }



  template <bool micropolar>
  template <typename Number>
  Report::Refusal
  Hypoplastic<micropolar>::respond_point(const double *increment,
                                         const double *committed,
                                         double       *trial,
                                         double       *stresses,
                                         double       *tangent,
                                         PointReport  &report) const
  {
    using std::exp;
    constexpr bool         with_tangent = !std::is_same<Number, double>::value;
    constexpr unsigned int n            = micropolar ?
                                            Continuum::Generalised<2>::n_micropolar :
                                            Continuum::Generalised<2>::n_classical;
    using Place                         = Places<micropolar>;
    using Stress                        = HypoplasticStress<micropolar, Number>;
    using StressValues                  = HypoplasticStress<micropolar, double>;

    Number inputs[n];
    for (unsigned int i = 0; i < n; ++i)
      inputs[i] = input<Number>(increment[i], i);

    const Continuum::StepKinematics<Number> kinematics(inputs);
    if (!kinematics.valid)
      return std::isfinite(value_of(kinematics.j)) ?
               Report::Refusal::inverted_step :
               Report::Refusal::not_finite;

    Loading<micropolar, Number> loading;
    loading.d    = kinematics.log_f;
    loading.k    = {{Number(0.), Number(0.)}};
    loading.spin = kinematics.log_f.turn;
    if constexpr (micropolar)
      {
        loading.d = kinematics.stretching(inputs[4]);
        loading.k = Continuum::StepKinematics<Number>::curvature(inputs,
                                                                 inputs + 5);
        for (Number &component : loading.k)
          component = component * constants.mean_grain_diameter;
      }
    loading.length = stretching_length(loading.at(0.));
    const Loading<micropolar, double> loading_values = loading.values();
    const double                      strain         = loading_values.length;

    // The state in the rotating frame; couple stresses divided by d_50.
    Stress y;
    for (unsigned int i = 0; i < 5; ++i)
      y[i] = Number(committed[stress_place + i]);
    if constexpr (micropolar)
      for (unsigned int i = 0; i < 2; ++i)
        y[5 + i] = Number(committed[Place::couple_stress + i] /
                          constants.mean_grain_diameter);
    const double initial_volume   = 1. + committed[Place::void_ratio];
    Number       volume           = Number(initial_volume);
    const Number final_volume     = initial_volume * kinematics.j;
    const Number final_void_ratio = final_volume - 1.;

    double check = strain + loading_values.spin + initial_volume;
    for (const Number &component : y)
      check += value_of(component);
    if (!std::isfinite(check))
      return Report::Refusal::not_finite;

    bool       on_floor     = false;
    const auto put_on_floor = [&](const Number &void_ratio) {
      y              = Stress{};
      const Number p = smallest_pressure(void_ratio);
      for (unsigned int i = 0; i < 3; ++i)
        y[i] = -p;
      on_floor       = true;
      report.floored = true;
    };

    if (pressure(y) < smallest_pressure(value_of(volume) - 1.) ||
        !is_compressive(y))
      put_on_floor(volume - 1.);

    const double stored_strain = committed[Place::substep];
    double       next_strain   = stored_strain;
    bool         rejected      = false;

    BinarySubsteps substeps(n_smallest_substeps,
                            strain > 0. ? stored_strain / strain : 1.);
    Stress           rate_begin;
    HypoplasticFlags flags_begin;
    bool             rate_begin_known = false;
    while (!substeps.done())
      {
        const double h = substeps.length();
        const double t = substeps.begin();

        if (!rate_begin_known)
          {
            flags_begin = HypoplasticFlags();
            rate_begin = hypoplastic_rate<micropolar, Number>(constants,
                                                              y,
                                                              volume - 1.,
                                                              loading.at(t),
                                                              loading.length,
                                                              flags_begin);
            rate_begin_known = true;
          }

        // A point on the floor that is being unloaded stays there. The
        // direction of a step is constant, so that is true for all of it.
        if (pressure(rate_begin) <= 0. &&
            pressure(y) <=
              smallest_pressure(value_of(volume) - 1.) * (1. + 1e-9))
          {
            put_on_floor(final_void_ratio);
            report.flags.merge(flags_begin);
            ++report.substeps;
            break;
          }

        const Number growth         = exp(kinematics.log_j * (.25 * h));
        const Number growth_half    = growth * growth;
        const Number volume_half    = volume * growth_half;
        const Number volume_quarter = volume_half * growth;
        const Number volume_end     = volume_half * growth_half;

        // One attempt. False: a stage or the end is in tension.
        Stress       y_end;
        StressValues rate_end;
        double       error = 0.;
        // of the stages inside the substep and of its end
        HypoplasticFlags flags, flags_end;
        const auto   attempt = [&]() {
          const double lowest = smallest_stage_pressure * floor_pressure;

          Stress y_stage;
          for (unsigned int i = 0; i < y.size(); ++i)
            y_stage[i] = y[i] + (.5 * h) * rate_begin[i];
          if (!(pressure(y_stage) > lowest))
            return false;
          const Stress rate_half =
            hypoplastic_rate<micropolar, Number>(constants,
                                                 y_stage,
                                                 volume_half - 1.,
                                                 loading.at(t + .5 * h),
                                                 loading.length,
                                                 flags);

          for (unsigned int i = 0; i < y.size(); ++i)
            y_stage[i] = y[i] + (.75 * h) * rate_half[i];
          if (!(pressure(y_stage) > lowest))
            return false;
          const Stress rate_quarter =
            hypoplastic_rate<micropolar, Number>(constants,
                                                 y_stage,
                                                 volume_quarter - 1.,
                                                 loading.at(t + .75 * h),
                                                 loading.length,
                                                 flags);

          for (unsigned int i = 0; i < y.size(); ++i)
            y_end[i] = y[i] +
                       (h * BogackiShampine::advance[0]) * rate_begin[i] +
                       (h * BogackiShampine::advance[1]) * rate_half[i] +
                       (h * BogackiShampine::advance[2]) * rate_quarter[i];
          if (!(pressure(y_end) > lowest) || !is_compressive(y_end))
            return false;

          const StressValues values = convert<double>(y_end);
          rate_end                  = hypoplastic_rate<micropolar, double>(
            constants,
            values,
            value_of(volume_end) - 1.,
            loading_values.at(t + h),
            loading_values.length,
            flags_end);

          // separate norms of stress and couple stress; scales keep points
          // near the floor, or without couple stress, from endless accuracy
          double stress_error = 0., couple_error = 0.;
          double stress_scale = 0., couple_scale = 0.;
          for (unsigned int i = 0; i < y.size(); ++i)
            {
              const double difference =
                h * (BogackiShampine::error[0] * value_of(rate_begin[i]) +
                     BogackiShampine::error[1] * value_of(rate_half[i]) +
                     BogackiShampine::error[2] * value_of(rate_quarter[i]) +
                     BogackiShampine::error[3] * rate_end[i]);
              (i < 5 ? stress_error : couple_error) += difference * difference;
              (i < 5 ? stress_scale : couple_scale) += values[i] * values[i];
            }
          stress_scale =
            std::max(stress_scale, 100. * floor_pressure * floor_pressure);
          couple_scale = std::max(couple_scale, .01 * stress_scale);
          error        = std::sqrt(stress_error / stress_scale);
          if constexpr (micropolar)
            error = std::max(error, std::sqrt(couple_error / couple_scale));
          error /= substep_tolerance;
          return true;
        };

        if (!attempt())
          {
            if (!substeps.is_smallest())
              {
                substeps.reject();
                rejected = true;
                continue;
              }
            put_on_floor(volume_end - 1.);
            rate_begin_known = false;
            substeps.accept(h);
          }
        else if (!(error <= 1.))
          {
            if (substeps.is_smallest())
              return std::isfinite(error) ? Report::Refusal::too_many_substeps :
                                            Report::Refusal::not_finite;
            substeps.reject(h * BogackiShampine::suggested_length(error));
            rejected = true;
            continue;
          }
        else
          {
            y        = y_end;
            on_floor = false;
            report.flags.merge(flags_begin);
            report.flags.merge(flags);
            if (pressure(y) < smallest_pressure(value_of(volume_end) - 1.))
              put_on_floor(volume_end - 1.);
            if constexpr (with_tangent)
              rate_begin_known = false;
            else
              {
                rate_begin       = rate_end;
                flags_begin      = flags_end;
                rate_begin_known = !on_floor;
              }
            double wanted = 1.;
            if (h < 1. || next_strain < largest_substep_strain)
              {
                wanted      = h * BogackiShampine::suggested_length(error);
                next_strain = rejected ?
                                wanted * strain :
                                std::max(stored_strain, wanted * strain);
                next_strain = std::min(next_strain, largest_substep_strain);
              }
            substeps.accept(wanted);
          }
        volume = volume_end;
        ++report.substeps;
      }

    // On the floor the stress does not feel the strain. A solver needs some
    // stiffness there: the isotropic one of the law at this pressure.
    if (with_tangent && on_floor)
      {
        HypoplasticFlags                 ignored;
        const HypoplasticFactors<double> factors(
          constants,
          -3. * pressure(y),
          0.,
          0.,
          value_of(final_void_ratio),
          ignored);
        const double stiffness =
          factors.f_s * factors.a_1 * factors.a_1;
        const auto   d        = loading.at(1.);
        const Number isotropic = (factors.f_s / 9.) * (d[0] + d[1]);
        y[0] += only_derivatives(stiffness * d[0] + isotropic);
        y[1] += only_derivatives(stiffness * d[1] + isotropic);
        y[2] += only_derivatives(isotropic);
        for (unsigned int i = 2; i < d.size(); ++i)
          y[1 + i] += only_derivatives(stiffness * d[i]);
      }

    // back to the fixed frame
    const Continuum::PlaneRotation<Number> rotation(loading.spin);
    const Continuum::PlaneTensor<Number>   turned{.5 * (y[0] + y[1]),
                                                .5 * (y[0] - y[1]),
                                                .5 * (y[3] + y[4]),
                                                .5 * (y[4] - y[3])};
    const std::array<Number, 4>            sigma =
      turned.to_fixed_frame(rotation).components();

    Number generalised[n];
    {
      const std::array<Number, 4> P = kinematics.nominal(sigma);
      std::copy(P.begin(), P.end(), generalised);
    }
    std::array<Number, 2> couple_stress;
    if constexpr (micropolar)
      {
        generalised[4] = kinematics.j * (-2. * turned.turn);
        couple_stress  = to_fixed_frame(
          std::array<Number, 2>{{y[5] * constants.mean_grain_diameter,
                                 y[6] * constants.mean_grain_diameter}},
          rotation);
        const std::array<Number, 2> M = kinematics.nominal(couple_stress);
        generalised[5]                = M[0];
        generalised[6]                = M[1];
      }

    double sum = value_of(y[2]);
    for (const Number &component : generalised)
      sum += value_of(component);
    if (!std::isfinite(sum))
      return Report::Refusal::not_finite;

    double *stress = trial + stress_place;
    stress[0]      = value_of(sigma[0]);
    stress[1]      = value_of(sigma[3]);
    stress[2]      = value_of(y[2]);
    stress[3]      = value_of(sigma[1]);
    stress[4]      = value_of(sigma[2]);
    if constexpr (micropolar)
      for (unsigned int i = 0; i < 2; ++i)
        trial[Place::couple_stress + i] = value_of(couple_stress[i]);
    trial[Place::void_ratio] = value_of(final_void_ratio);
    trial[Place::substep]    = next_strain;

    for (unsigned int a = 0; a < n; ++a)
      stresses[a] = value_of(generalised[a]);
    if constexpr (with_tangent)
      for (unsigned int a = 0; a < n; ++a)
        for (unsigned int b = 0; b < n; ++b)
          tangent[a * n + b] = generalised[a].derivatives[b];
    else
      (void)tangent;
    return Report::Refusal::none;
  }



  template <bool micropolar>
  template <typename Number>
  Report
  Hypoplastic<micropolar>::respond_all(const Batch &batch) const
  {
    constexpr unsigned int n_state = Places<micropolar>::n;
    constexpr unsigned int n       = micropolar ?
                                       Continuum::Generalised<2>::n_micropolar :
                                       Continuum::Generalised<2>::n_classical;
    Report                 report;
    for (unsigned int p = 0; p < batch.n_points; ++p)
      {
        PointReport           point;
        const Report::Refusal refusal = respond_point<Number>(
          batch.increments + p * n,
          batch.committed + p * n_state,
          batch.trial + p * n_state,
          batch.stresses + p * n,
          batch.tangents == nullptr ? nullptr : batch.tangents + p * n * n,
          point);
        if (refusal != Report::Refusal::none)
          {
            if (report.refused == 0)
              {
                report.first_refused = p;
                report.reason        = refusal;
              }
            ++report.refused;
            continue;
          }
        report.floored += point.floored;
        report.clamped += point.flags.clamped;
        report.null_deviator += point.flags.null_deviator;
        report.substeps += point.substeps;
      }
    return report;
  }



  template <bool micropolar>
  Report
  Hypoplastic<micropolar>::respond(const Batch &batch) const
  {
    if (batch.tangents == nullptr)
      return respond_all<double>(batch);
    return respond_all<Forward<micropolar ? 8 : 4>>(batch);
  }



  template <bool micropolar>
  void
  Hypoplastic<micropolar>::declare(dealii::ParameterHandler &prm) const
  {
    using dealii::Patterns::Anything;
    using dealii::Patterns::Double;
    using dealii::Patterns::Integer;

    prm.declare_entry("Critical friction angle",
                      "0",
                      Double(),
                      "Friction angle of the sand in triaxial compression when "
                      "it shears at constant volume, phi_c. Degrees.",
                      true);
    prm.declare_entry("Granular hardness",
                      "0",
                      Double(),
                      "Pressure scale h_s of the compression law e = e_0 "
                      "exp(-(3 p/h_s)^n). Pa.",
                      true);
    prm.declare_entry("Minimum void ratio",
                      "0",
                      Double(),
                      "Void ratio of the densest packing at zero pressure, "
                      "e_d0. Dimensionless.",
                      true);
    prm.declare_entry("Critical void ratio",
                      "0",
                      Double(),
                      "Void ratio at which the sand shears at constant volume, "
                      "at zero pressure, e_c0. Dimensionless.",
                      true);
    prm.declare_entry("Maximum void ratio",
                      "0",
                      Double(),
                      "Void ratio of the loosest packing at zero pressure, "
                      "e_i0. Dimensionless.",
                      true);
    prm.declare_entry("Density exponent",
                      "0",
                      Double(),
                      "Exponent alpha of the density factor f_d = ((e - "
                      "e_d)/(e_c - e_d))^alpha. Dimensionless.",
                      true);
    prm.declare_entry("Hardness exponent",
                      "0",
                      Double(),
                      "Exponent n of the compression law. Dimensionless.",
                      true);
    if (micropolar)
      {
        prm.declare_entry("Mean grain diameter",
                          "0",
                          Double(),
                          "Length d_50 that sets the width of shear bands. m.",
                          true);
        prm.declare_entry("Polar constant",
                          "1/a1",
                          Anything(),
                          "Micropolar constant a_c: `1/a1' (the published "
                          "choice), `a1 + 1/a1' (a band then ends at the "
                          "critical void ratio exactly) or a number. "
                          "Dimensionless.");
      }
    prm.declare_entry("Floor pressure",
                      "100",
                      Double(),
                      "Smallest mean pressure: a point below it is put on it, "
                      "isotropically and without couple stress, and counted. "
                      "Pa.");
    prm.declare_entry("Substep tolerance",
                      "1e-4",
                      Double(),
                      "Local error of one substep, relative to the size of "
                      "stress and couple stress. Dimensionless.");
    prm.declare_entry("Largest number of substeps",
                      "8192",
                      Integer(),
                      "Substeps of one step at most; the smallest substep is "
                      "the step divided by the largest power of two in this "
                      "number. Beyond it the point is refused.");
  }



  template <bool micropolar>
  void
  Hypoplastic<micropolar>::parse(dealii::ParameterHandler &prm)
  {
    constants                         = HypoplasticConstants();
    constexpr double radian           = 3.14159265358979323846 / 180.;
    constants.critical_friction_angle =
      prm.get_double("Critical friction angle") * radian;
    constants.granular_hardness  = prm.get_double("Granular hardness");
    constants.minimum_void_ratio = prm.get_double("Minimum void ratio");
    constants.critical_void_ratio = prm.get_double("Critical void ratio");
    constants.maximum_void_ratio  = prm.get_double("Maximum void ratio");
    constants.density_exponent    = prm.get_double("Density exponent");
    constants.hardness_exponent   = prm.get_double("Hardness exponent");
    if (micropolar)
      {
        constants.mean_grain_diameter = prm.get_double("Mean grain diameter");
        polar_constant                = prm.get("Polar constant");

        constants.polar_number  = 0.;
        constants.polar_inverse = 0.;
        constants.polar_linear  = 0.;
        polar_constant_ok       = true;
        std::string plain       = polar_constant;
        plain.erase(std::remove(plain.begin(), plain.end(), ' '), plain.end());
        if (plain == "1/a1")
          constants.polar_inverse = 1.;
        else if (plain == "a1+1/a1" || plain == "1/a1+a1")
          {
            constants.polar_inverse = 1.;
            constants.polar_linear  = 1.;
          }
        else
          {
            std::istringstream text(plain);
            polar_constant_ok = (text >> constants.polar_number) &&
                                text.peek() == EOF;
          }
      }
    floor_pressure    = prm.get_double("Floor pressure");
    substep_tolerance = prm.get_double("Substep tolerance");
    n_smallest_substeps = BinarySubsteps::subdivision(static_cast<unsigned int>(
      std::max(1L, prm.get_integer("Largest number of substeps"))));

    constants.derive();
    densest_at_floor = constants.minimum_void_ratio *
                       constants.compression(floor_pressure);
  }



  namespace
  {
    template <typename T>
    std::string
    text_of(const T &value)
    {
      std::ostringstream text;
      text << value;
      return text.str();
    }
  } // namespace



  template <bool micropolar>
  void
  Hypoplastic<micropolar>::check(const std::string &path,
                                 Problems          &problems) const
  {
    constexpr double degree = 180. / 3.14159265358979323846;

    const auto require = [&](const bool         holds,
                             const std::string &entry,
                             const double       read,
                             const std::string &allowed) {
      if (!holds)
        problems.error(path + "/" + entry,
                       entry + " is " + text_of(read) + ", but " + allowed +
                         ".");
    };

    const double phi_c = constants.critical_friction_angle * degree;
    const double e_d   = constants.minimum_void_ratio;
    const double e_c   = constants.critical_void_ratio;
    const double e_i   = constants.maximum_void_ratio;
    const double n     = constants.hardness_exponent;

    const std::size_t errors_before = problems.errors.size();
    require(phi_c > 0. && phi_c < 90.,
            "Critical friction angle",
            phi_c,
            "it must lie between 0 and 90 degrees");
    require(constants.granular_hardness > 0.,
            "Granular hardness",
            constants.granular_hardness,
            "it must be a positive pressure in Pa (sands: about 1e8 to 1e10)");
    require(e_d > 0., "Minimum void ratio", e_d, "it must be positive");
    require(e_c > e_d,
            "Critical void ratio",
            e_c,
            "it must be above the minimum void ratio, " + text_of(e_d));
    require(e_i > e_c,
            "Maximum void ratio",
            e_i,
            "it must be above the critical void ratio, " + text_of(e_c));
    require(constants.density_exponent > 0.,
            "Density exponent",
            constants.density_exponent,
            "it must be positive (sands: 0.1 to 0.3)");
    require(n > 0. && n < 1.,
            "Hardness exponent",
            n,
            "it must lie between 0 and 1 (sands: 0.2 to 0.5)");
    if (micropolar)
      {
        require(constants.mean_grain_diameter > 0.,
                "Mean grain diameter",
                constants.mean_grain_diameter,
                "it must be a positive length in m");
        if (!polar_constant_ok)
          problems.error(path + "/Polar constant",
                         "Polar constant is `" + polar_constant +
                           "', but it must be `1/a1', `a1 + 1/a1' or a "
                           "number.");
        else if (constants.polar_inverse == 0. && constants.polar_number < 2.)
          problems.warning(path + "/Polar constant",
                           "Polar constant is " +
                             text_of(constants.polar_number) +
                             "; below 2 the couple stress of a shear band can "
                             "grow without a limit.");
      }
    require(floor_pressure > 0.,
            "Floor pressure",
            floor_pressure,
            "it must be a positive pressure in Pa");
    require(substep_tolerance > 0. && substep_tolerance < 1.,
            "Substep tolerance",
            substep_tolerance,
            "it must lie between 0 and 1 (1e-6 to 1e-3 are sensible)");

    // only if the constants it follows from are in order
    if (problems.errors.size() == errors_before && !(constants.h_i > 0.))
      problems.error(path + "/Density exponent",
                     "These constants give the stiffness constant h_i = "
                     "1/c_1^2 + 1/3 - ((e_i0 - e_d0)/(e_c0 - e_d0))^alpha / "
                     "(c_1 sqrt(3)) = " +
                       text_of(constants.h_i) +
                       ", but it must be positive: lower the density exponent "
                       "or the maximum void ratio.");
  }



  template <bool micropolar>
  void
  Hypoplastic<micropolar>::check_initial(const InitialState &initial,
                                         const std::string  &path,
                                         Problems           &problems) const
  {
    const double p = -dealii::trace(initial.stress) / 3.;
    const double e = initial.void_ratio;
    if (!(e > 0.))
      problems.error(path,
                     "The void ratio is " + text_of(e) +
                       ", but it must be positive.");

    const std::array<double, 5> stress{{initial.stress[0][0],
                                        initial.stress[1][1],
                                        initial.stress[2][2],
                                        initial.stress[0][1],
                                        initial.stress[0][1]}};
    if (!is_compressive(stress))
      {
        problems.error(path,
                       "The initial stress (11: " + text_of(stress[0]) +
                         ", 22: " + text_of(stress[1]) +
                         ", 33: " + text_of(stress[2]) +
                         ", 12: " + text_of(stress[3]) +
                         " Pa) is not compressive in all directions; a "
                         "hypoplastic body must start under pressure.");
        return;
      }
    if (p < 1e3 || p > 1e6)
      problems.warning(path,
                       "The initial mean pressure is " + text_of(p) +
                         " Pa; the law is meant for 1e3 to 1e6 Pa.");
    const double factor = constants.compression(p);
    if (e > 0. && e < constants.minimum_void_ratio * factor)
      problems.warning(path,
                       "The void ratio " + text_of(e) +
                         " is below that of the densest packing, " +
                         text_of(constants.minimum_void_ratio * factor) +
                         " at this pressure; the density factor is clamped.");
    if (e > constants.maximum_void_ratio * factor)
      problems.warning(path,
                       "The void ratio " + text_of(e) +
                         " is above that of the loosest packing, " +
                         text_of(constants.maximum_void_ratio * factor) +
                         " at this pressure.");
  }



  template class Hypoplastic<true>;
  template class Hypoplastic<false>;
} // namespace Riedel::Material
