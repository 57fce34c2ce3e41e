// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/continuum/generalised.h>
#include <riedel/continuum/lanes.h>
#include <riedel/continuum/step_kinematics.h>
#include <riedel/material/polar_hypoplastic.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <type_traits>

namespace Riedel::Material
{
  using Continuum::Forward;
  using Continuum::input;
  using Continuum::to_fixed_frame;
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

    /// How many points are computed at once if only stresses are wanted.
    constexpr int n_lanes = Continuum::n_native_lanes;

    /// Reads rows of numbers, one row for each lane. The last row fills the
    /// lanes beyond the @p n_rows.
    template <std::size_t n>
    void
    read_rows(const double                             *rows,
              const unsigned int                        n_rows,
              std::array<Continuum::Lanes<n_lanes>, n> &numbers)
    {
      for (unsigned int lane = 0; lane < n_lanes; ++lane)
        {
          const double *row = rows + std::min(lane, n_rows - 1) * n;
          for (unsigned int i = 0; i < n; ++i)
            numbers[i].values[lane] = row[i];
        }
    }
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
    double *stress                        = state + stress_place;
    stress[0]                             = initial.stress[0][0];
    stress[1]                             = initial.stress[1][1];
    stress[2]                             = initial.stress[2][2];
    stress[3]                             = initial.stress[0][1];
    stress[4]                             = initial.stress[1][0];
    state[Places<micropolar>::void_ratio] = initial.void_ratio;
    state[Places<micropolar>::substep] =
      HypoplasticControls::largest_substep_strain;
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
  double
  Hypoplastic<micropolar>::stiffness(const double *state) const
  {
    const double          void_ratio = state[Places<micropolar>::void_ratio];
    std::array<double, 5> stress;
    std::copy_n(state + stress_place, stress.size(), stress.begin());

    const double floor = controls.smallest_pressure(void_ratio);
    if (!(mean_pressure(stress) >= floor) || !is_compressive(stress))
      stress = {{-floor, -floor, -floor, 0., 0.}};

    const double trace = stress[0] + stress[1] + stress[2];
    for (double &component : stress)
      component /= trace;
    const double determinant =
      (stress[0] - 1. / 3.) * (stress[1] - 1. / 3.) - stress[3] * stress[4];
    HypoplasticFlags                 ignored;
    const HypoplasticFactors<double> factors(
      constants, trace, stress[2] - 1. / 3., determinant, void_ratio, ignored);
    return factors.f_s * factors.a_1 * factors.a_1;
  }



  namespace
  {
    /**
     * What surrounds the integration of a step: kinematics, the state in the
     * rotating frame, and the way back to the fixed frame. Number is that of
     * one point or Lanes for several. With axis_3, a strain of axis 3 is given,
     * too.
     */
    template <bool micropolar, typename Number, bool axis_3 = false>
    struct PointStep
    {
      using Value    = Continuum::ValueOf<Number>;
      using Place    = Places<micropolar>;
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
      explicit PointStep(const std::array<Number, n> &inputs)
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
          y[i] = Number(committed[stress_place + i]);
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
        Value sum = value_of(loading.length) + value_of(loading.spin) +
                    initial_volume + substep_strain;
        for (const Number &component : y)
          sum += value_of(component);
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

        trial[stress_place]     = value_of(sigma[0]);
        trial[stress_place + 1] = value_of(sigma[3]);
        trial[stress_place + 2] = value_of(y[2]);
        trial[stress_place + 3] = value_of(sigma[1]);
        trial[stress_place + 4] = value_of(sigma[2]);
        if constexpr (micropolar)
          {
            generalised[4] = kinematics.j * (-2. * turned.turn);
            const std::array<Number, 2> couple_stress = to_fixed_frame(
              std::array<Number, 2>{
                {y[5] * mean_grain_diameter, y[6] * mean_grain_diameter}},
              rotation);
            const std::array<Number, 2> M = kinematics.nominal(couple_stress);
            std::copy(M.begin(), M.end(), generalised.begin() + 5);
            for (unsigned int i = 0; i < 2; ++i)
              trial[Place::couple_stress + i] = value_of(couple_stress[i]);
          }
        trial[Place::void_ratio] = value_of(final_void_ratio);
        trial[Place::substep]    = substep_strain;
      }

      /// finite if everything that finish() has set is
      Value
      sum_at_end() const
      {
        Value sum = value_of(y[2]);
        for (const Number &component : generalised)
          sum += value_of(component);
        return sum;
      }
    };
  } // namespace



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
    using Step               = PointStep<micropolar, Number, axis_3>;
    constexpr unsigned int n = Step::n;

    std::array<Number, n> inputs;
    for (unsigned int i = 0; i < n; ++i)
      inputs[i] = input<Number>(increment[i], i);
    std::array<double, Places<micropolar>::n> state;
    std::copy_n(committed, state.size(), state.begin());

    Step step(inputs);
    if (!step.kinematics.valid)
      return std::isfinite(value_of(step.kinematics.j)) ?
               Report::Refusal::inverted_step :
               Report::Refusal::not_finite;
    step.start(inputs, state, constants.mean_grain_diameter, axis_3_strain);
    if (!std::isfinite(step.sum_at_start()))
      return Report::Refusal::not_finite;

    const Report::Refusal refusal =
      step.integrator(constants, controls)
        .integrate(step.y, step.substep_strain, report);
    if (refusal != Report::Refusal::none)
      return refusal;

    step.finish(constants.mean_grain_diameter);
    if (!std::isfinite(step.sum_at_end()))
      return Report::Refusal::not_finite;

    std::copy(step.trial.begin(), step.trial.end(), trial);
    for (unsigned int a = 0; a < n; ++a)
      stresses[a] = value_of(step.generalised[a]);
    if constexpr (!std::is_same<Number, double>::value)
      for (unsigned int a = 0; a < n; ++a)
        for (unsigned int b = 0; b < n; ++b)
          tangent[a * n + b] = step.generalised[a].derivatives[b];
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
    constexpr unsigned int n_state = Places<micropolar>::n;
    constexpr unsigned int n       = PointStep<micropolar, Number>::n;

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



  template <bool micropolar>
  void
  Hypoplastic<micropolar>::respond_group(const Batch       &batch,
                                         const unsigned int first,
                                         Report            &report) const
  {
    using Number                   = Continuum::Lanes<n_lanes>;
    using Mask                     = Continuum::Mask<n_lanes>;
    using Step                     = PointStep<micropolar, Number>;
    constexpr unsigned int n       = Step::n;
    constexpr unsigned int n_state = Places<micropolar>::n;

    // where the batch ends inside the group, its last point fills the lanes
    const unsigned int n_points =
      std::min<unsigned int>(n_lanes, batch.n_points - first);
    std::array<Number, n>       inputs;
    std::array<Number, n_state> committed;
    read_rows(batch.increments + first * n, n_points, inputs);
    read_rows(batch.committed + first * n_state, n_points, committed);

    Step                       step(inputs);
    HypoplasticFlagsOf<Number> flags;
    Mask                       usual = step.kinematics.valid;
    if (any(usual))
      {
        step.start(inputs, committed, constants.mean_grain_diameter);
        usual =
          usual && is_finite(step.sum_at_start()) &&
          abs(step.loading.spin) < Continuum::Turn<Number>::largest_small_angle;
        usual =
          usual && step.integrator(constants, controls)
                     .integrate_at_once(step.y, step.substep_strain, flags);
        step.finish(constants.mean_grain_diameter);
        usual = usual && is_finite(step.sum_at_end());
      }

    for (unsigned int lane = 0; lane < n_points; ++lane)
      if (usual[lane])
        {
          const unsigned int p = first + lane;
          for (unsigned int i = 0; i < n_state; ++i)
            batch.trial[p * n_state + i] = step.trial[i][lane];
          for (unsigned int i = 0; i < n; ++i)
            batch.stresses[p * n + i] = step.generalised[i][lane];
          report.clamped += flags.clamped[lane];
          report.null_deviator += flags.null_deviator[lane];
          ++report.substeps;
        }
      else
        respond_point<double, false>(batch, first + lane, report);
  }



  template <bool micropolar>
  Report
  Hypoplastic<micropolar>::respond(const Batch &batch) const
  {
    using WithTangent = Forward<micropolar ? 8 : 4>;
    Report report;
    if (batch.axis_3_strains != nullptr)
      {
        // A variant with derivatives, which nobody needs, would make the
        // compiler inline less into that of plane strain: 3 percent of its
        // time.
        Assert(batch.tangents == nullptr, dealii::ExcNotImplemented());
        for (unsigned int p = 0; p < batch.n_points; ++p)
          respond_point<double, true>(batch, p, report);
      }
    else if (batch.tangents == nullptr)
      for (unsigned int first = 0; first < batch.n_points; first += n_lanes)
        respond_group(batch, first, report);
    else
      for (unsigned int p = 0; p < batch.n_points; ++p)
        respond_point<WithTangent, false>(batch, p, report);
    return report;
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
    // The classical law knows the polar constants too, its stresses ignore
    // them: to compare, one changes only the law.
    const std::string ignored =
      micropolar ? "" : " The classical law ignores it.";
    prm.declare_entry("Mean grain diameter",
                      "0",
                      Double(),
                      micropolar ?
                        "Length d_50 that sets the width of shear bands [m]." :
                        "Length d_50 [m]; the classical law only measures "
                        "shear bands and sizes of cells by it.",
                      micropolar);
    prm.declare_entry("Polar constant",
                      "1/a1",
                      Anything(),
                      "Micropolar constant a_c: \"1/a1\" (the published "
                      "choice), \"a1 + 1/a1\" (a band then ends at the "
                      "critical void ratio exactly) or a number. "
                      "Dimensionless." +
                        ignored);
    prm.declare_entry("Floor pressure",
                      "100",
                      Double(),
                      "Smallest mean pressure: a point below it is returned to "
                      "it and counted; its deviator and couple stress vanish "
                      "with the pressure that it would have. Pa.");
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
    constants               = HypoplasticConstants();
    constexpr double radian = 3.14159265358979323846 / 180.;
    constants.critical_friction_angle =
      prm.get_double("Critical friction angle") * radian;
    constants.granular_hardness   = prm.get_double("Granular hardness");
    constants.minimum_void_ratio  = prm.get_double("Minimum void ratio");
    constants.critical_void_ratio = prm.get_double("Critical void ratio");
    constants.maximum_void_ratio  = prm.get_double("Maximum void ratio");
    constants.density_exponent    = prm.get_double("Density exponent");
    constants.hardness_exponent   = prm.get_double("Hardness exponent");
    grain_diameter                = prm.get_double("Mean grain diameter");
    if (micropolar)
      {
        constants.mean_grain_diameter = grain_diameter;
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
            polar_constant_ok =
              (text >> constants.polar_number) && text.peek() == EOF;
          }
      }
    controls.floor_pressure    = prm.get_double("Floor pressure");
    controls.substep_tolerance = prm.get_double("Substep tolerance");
    controls.n_smallest_substeps =
      BinarySubsteps::subdivision(static_cast<unsigned int>(
        std::max(1L, prm.get_integer("Largest number of substeps"))));

    constants.derive();
    controls.densest_at_floor = constants.minimum_void_ratio *
                                constants.compression(controls.floor_pressure);
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
                         "Polar constant is \"" + polar_constant +
                           "\", but it must be \"1/a1\", \"a1 + 1/a1\" or "
                           "a number.");
        else if (constants.polar_inverse == 0. && constants.polar_number < 2.)
          problems.warning(path + "/Polar constant",
                           "Polar constant is " +
                             text_of(constants.polar_number) +
                             "; below 2 the couple stress of a shear band can "
                             "grow without a limit.");
      }
    require(controls.floor_pressure > 0.,
            "Floor pressure",
            controls.floor_pressure,
            "it must be a positive pressure in Pa");
    require(controls.substep_tolerance > 0. && controls.substep_tolerance < 1.,
            "Substep tolerance",
            controls.substep_tolerance,
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
                         ", 22: " + text_of(stress[1]) + ", 33: " +
                         text_of(stress[2]) + ", 12: " + text_of(stress[3]) +
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
