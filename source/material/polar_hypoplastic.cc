// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/continuum/generalised.h>
#include <riedel/continuum/step_kinematics.h>
#include <riedel/material/polar_hypoplastic.h>

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
  template <typename Number>
  Report::Refusal
  Hypoplastic<micropolar>::respond_point(const double           *increment,
                                         const double           *committed,
                                         double                 *trial,
                                         double                 *stresses,
                                         double                 *tangent,
                                         HypoplasticPointReport &report) const
  {
    constexpr unsigned int n = micropolar ?
                                 Continuum::Generalised<2>::n_micropolar :
                                 Continuum::Generalised<2>::n_classical;
    using Place              = Places<micropolar>;

    Number inputs[n];
    for (unsigned int i = 0; i < n; ++i)
      inputs[i] = input<Number>(increment[i], i);

    const Continuum::StepKinematics<Number> kinematics(inputs);
    if (!kinematics.valid)
      return std::isfinite(value_of(kinematics.j)) ?
               Report::Refusal::inverted_step :
               Report::Refusal::not_finite;

    HypoplasticLoading<micropolar, Number> loading;
    loading.d    = kinematics.log_f;
    loading.k    = {{Number(0.), Number(0.)}};
    loading.spin = kinematics.log_f.turn;
    if constexpr (micropolar)
      {
        loading.d = kinematics.stretching(inputs[4]);
        loading.k =
          Continuum::StepKinematics<Number>::curvature(inputs, inputs + 5);
        for (Number &component : loading.k)
          component = component * constants.mean_grain_diameter;
      }
    loading.length = stretching_length(loading.at(0.));

    // The state in the rotating frame; couple stresses divided by d_50.
    HypoplasticStress<micropolar, Number> y;
    for (unsigned int i = 0; i < 5; ++i)
      y[i] = Number(committed[stress_place + i]);
    if constexpr (micropolar)
      for (unsigned int i = 0; i < 2; ++i)
        y[5 + i] = Number(committed[Place::couple_stress + i] /
                          constants.mean_grain_diameter);
    const double initial_volume   = 1. + committed[Place::void_ratio];
    const Number final_void_ratio = initial_volume * kinematics.j - 1.;
    double       substep_strain   = committed[Place::substep];

    double sum = value_of(loading.length) + value_of(loading.spin) +
                 initial_volume + substep_strain;
    for (const Number &component : y)
      sum += value_of(component);
    if (!std::isfinite(sum))
      return Report::Refusal::not_finite;

    const HypoplasticStep<micropolar, Number> step(constants,
                                                   controls,
                                                   loading,
                                                   kinematics.log_j,
                                                   initial_volume,
                                                   final_void_ratio);
    const Report::Refusal refusal = step.integrate(y, substep_strain, report);
    if (refusal != Report::Refusal::none)
      return refusal;

    // back to the fixed frame and to the start-of-step configuration
    const Continuum::PlaneRotation<Number> rotation(loading.spin);
    const Continuum::PlaneTensor<Number>   turned{.5 * (y[0] + y[1]),
                                                .5 * (y[0] - y[1]),
                                                .5 * (y[3] + y[4]),
                                                .5 * (y[4] - y[3])};
    const std::array<Number, 4>            sigma =
      turned.to_fixed_frame(rotation).components();
    const std::array<Number, 4> P = kinematics.nominal(sigma);

    Number generalised[n];
    std::copy(P.begin(), P.end(), generalised);
    std::array<Number, 2> couple_stress{};
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

    sum = value_of(y[2]);
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
    trial[Place::substep]    = substep_strain;

    for (unsigned int a = 0; a < n; ++a)
      stresses[a] = value_of(generalised[a]);
    if constexpr (!std::is_same<Number, double>::value)
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
        HypoplasticPointReport point;
        const Report::Refusal  refusal =
          respond_point<Number>(batch.increments + p * n,
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
    // The classical law knows the polar constants too, and ignores them: to
    // compare, one changes only the law.
    const std::string ignored =
      micropolar ? "" : " The classical law ignores it.";
    prm.declare_entry("Mean grain diameter",
                      "0",
                      Double(),
                      "Length d_50 that sets the width of shear bands [m]." +
                        ignored,
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
