// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/continuum/generalised.h>
#include <riedel/continuum/step_kinematics.h>
#include <riedel/material/linear_elastic_micropolar.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <type_traits>

namespace Riedel::Material
{
  using Continuum::chain_rule;
  using Continuum::Forward;
  using Continuum::input;
  using Continuum::PlaneTensor;
  using Continuum::value_of;

  namespace
  {
    // Places in a point's state, in the order of the constructor.
    constexpr unsigned int couple_place = 5;

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
      return layout;
    }



    /// Mean of cos(s angle) over s from 0 to 1: sin(angle)/angle
    template <typename Number>
    Number
    mean_cosine(const Number &angle)
    {
      const double a = value_of(angle);
      if (std::abs(a) < 1e-2)
        {
          const double x = a * a;
          return chain_rule(angle,
                            1. + x * (-1. / 6 + x * (1. / 120 - x / 5040)),
                            a * (-1. / 3 + x * (1. / 30 - x / 840)));
        }
      const double mean = std::sin(a) / a;
      return chain_rule(angle, mean, (std::cos(a) - mean) / a);
    }



    /// Mean of sin(s angle) over s from 0 to 1: (1 - cos(angle))/angle
    template <typename Number>
    Number
    mean_sine(const Number &angle)
    {
      const double a = value_of(angle);
      if (std::abs(a) < 1e-2)
        {
          const double x = a * a;
          return chain_rule(angle,
                            a * (1. / 2 + x * (-1. / 24 + x / 720)),
                            1. / 2 + x * (-1. / 8 + x * (1. / 144 - x / 5760)));
        }
      const double half = std::sin(.5 * a);
      const double mean = 2. * half * half / a;
      return chain_rule(angle, mean, (std::sin(a) - mean) / a);
    }
  } // namespace



  template <bool micropolar>
  LinearElastic<micropolar>::LinearElastic()
    : slots(make_layout<micropolar>())
  {}



  template <bool micropolar>
  std::string
  LinearElastic<micropolar>::name() const
  {
    return micropolar ? "linear elastic micropolar" : "linear elastic";
  }



  template <bool micropolar>
  double
  LinearElastic<micropolar>::length() const
  {
    return micropolar ? std::sqrt(bending_modulus / (4. * shear_modulus)) : 0.;
  }



  template <bool micropolar>
  double
  LinearElastic<micropolar>::stiffness(const double * /*state*/) const
  {
    return 2. * shear_modulus;
  }



  template <bool micropolar>
  void
  LinearElastic<micropolar>::initialise(const InitialState &initial,
                                        double             *state) const
  {
    std::fill(state, state + slots.size(), 0.);
    state[0] = initial.stress[0][0];
    state[1] = initial.stress[1][1];
    state[2] = initial.stress[2][2];
    state[3] = initial.stress[0][1];
    state[4] = initial.stress[1][0];
  }



  template <bool micropolar>
  void
  LinearElastic<micropolar>::stresses_at_rest(const double *state,
                                              double       *stresses) const
  {
    stresses[0] = state[0];
    stresses[1] = state[3];
    stresses[2] = state[4];
    stresses[3] = state[1];
    if constexpr (micropolar)
      {
        stresses[4] = state[3] - state[4];
        stresses[5] = state[couple_place];
        stresses[6] = state[couple_place + 1];
      }
  }



  template <bool micropolar>
  template <typename Number>
  Report::Refusal
  LinearElastic<micropolar>::respond_point(const double *increment,
                                           const double  axis_3_strain,
                                           const double *committed,
                                           double       *trial,
                                           double       *stresses,
                                           double       *tangent) const
  {
    constexpr unsigned int n = micropolar ?
                                 Continuum::Generalised<2>::n_micropolar :
                                 Continuum::Generalised<2>::n_classical;

    Number inputs[n];
    for (unsigned int i = 0; i < n; ++i)
      inputs[i] = input<Number>(increment[i], i);

    PlaneTensor<Number>   sigma{Number(.5 * (committed[0] + committed[1])),
                              Number(.5 * (committed[0] - committed[1])),
                              Number(.5 * (committed[3] + committed[4])),
                              Number(.5 * (committed[4] - committed[3]))};
    Number                sigma_33(committed[2]);
    std::array<Number, 2> m{};
    if constexpr (micropolar)
      m = {
        {Number(committed[couple_place]), Number(committed[couple_place + 1])}};

    // isotropic in the plane, so that no rotation changes it
    sigma.mean += lame_modulus * axis_3_strain;
    sigma_33 += (lame_modulus + 2. * shear_modulus) * axis_3_strain;

    // The elastic relation between a strain increment and a stress increment.
    const auto add_increment = [&](const PlaneTensor<Number>   &strain,
                                   const std::array<Number, 2> &curvature) {
      sigma.mean += (2. * (lame_modulus + shear_modulus)) * strain.mean;
      sigma.difference += (2. * shear_modulus) * strain.difference;
      sigma.shear += (2. * shear_modulus) * strain.shear;
      sigma_33 += (2. * lame_modulus) * strain.mean;
      if constexpr (micropolar)
        {
          sigma.turn += (2. * couple_modulus) * strain.turn;
          for (unsigned int i = 0; i < 2; ++i)
            m[i] += bending_modulus * curvature[i];
        }
      else
        (void)curvature;
    };

    std::array<Number, 4> nominal_stress;
    std::array<Number, 2> nominal_couple_stress;
    Number                spin_stress;
    if (small_strain)
      {
        PlaneTensor<Number>   strain{.5 * (inputs[0] + inputs[3]),
                                   .5 * (inputs[0] - inputs[3]),
                                   .5 * (inputs[1] + inputs[2]),
                                   .5 * (inputs[2] - inputs[1])};
        std::array<Number, 2> curvature{};
        if constexpr (micropolar)
          {
            strain.turn += -inputs[4];
            curvature = {{inputs[5], inputs[6]}};
          }
        add_increment(strain, curvature);
        nominal_stress        = sigma.components();
        nominal_couple_stress = m;
        spin_stress           = -2. * sigma.turn;
      }
    else
      {
        const Continuum::StepKinematics<Number> kinematics(inputs);
        if (!kinematics.valid)
          return std::isfinite(value_of(kinematics.j)) ?
                   Report::Refusal::inverted_step :
                   Report::Refusal::not_finite;

        PlaneTensor<Number>   strain = kinematics.log_f;
        const Number          spin   = kinematics.log_f.turn;
        std::array<Number, 2> k{};
        if constexpr (micropolar)
          {
            strain = kinematics.stretching(inputs[4]);
            k =
              Continuum::StepKinematics<Number>::curvature(inputs, inputs + 5);
          }

        // The stretching turns backwards in the rotating frame; its mean over
        // the step gives the stress at the end.
        const Number cosine        = mean_cosine(2. * spin);
        const Number sine          = mean_sine(2. * spin);
        const Number single_cosine = mean_cosine(spin);
        const Number single_sine   = mean_sine(spin);
        add_increment({strain.mean,
                       cosine * strain.difference + sine * strain.shear,
                       cosine * strain.shear - sine * strain.difference,
                       strain.turn},
                      {{single_cosine * k[0] + single_sine * k[1],
                        single_cosine * k[1] - single_sine * k[0]}});

        const Continuum::PlaneRotation<Number> rotation(spin);
        sigma                 = sigma.to_fixed_frame(rotation);
        m                     = to_fixed_frame(m, rotation);
        nominal_stress        = kinematics.nominal(sigma.components());
        nominal_couple_stress = kinematics.nominal(m);
        spin_stress           = kinematics.j * (-2. * sigma.turn);
      }

    Number generalised[n];
    std::copy(nominal_stress.begin(), nominal_stress.end(), generalised);
    if constexpr (micropolar)
      {
        generalised[4] = spin_stress;
        generalised[5] = nominal_couple_stress[0];
        generalised[6] = nominal_couple_stress[1];
      }

    double sum = value_of(sigma_33);
    for (const Number &component : generalised)
      sum += value_of(component);
    if (!std::isfinite(sum))
      return Report::Refusal::not_finite;

    const std::array<Number, 4> components = sigma.components();
    trial[0]                               = value_of(components[0]);
    trial[1]                               = value_of(components[3]);
    trial[2]                               = value_of(sigma_33);
    trial[3]                               = value_of(components[1]);
    trial[4]                               = value_of(components[2]);
    if constexpr (micropolar)
      for (unsigned int i = 0; i < 2; ++i)
        trial[couple_place + i] = value_of(m[i]);

    for (unsigned int a = 0; a < n; ++a)
      stresses[a] = value_of(generalised[a]);
    if constexpr (!std::is_same<Number, double>::value)
      for (unsigned int a = 0; a < n; ++a)
        generalised[a].derivatives.copy_to(tangent + a * n, n);
    else
      (void)tangent;
    return Report::Refusal::none;
  }



  template <bool micropolar>
  template <typename Number>
  Report
  LinearElastic<micropolar>::respond_all(const Batch &batch) const
  {
    constexpr unsigned int n       = micropolar ?
                                       Continuum::Generalised<2>::n_micropolar :
                                       Continuum::Generalised<2>::n_classical;
    constexpr unsigned int n_state = micropolar ? 7 : 5;
    Report                 report;
    for (unsigned int p = 0; p < batch.n_points; ++p)
      {
        const Report::Refusal refusal = respond_point<Number>(
          batch.increments + p * n,
          batch.axis_3_strains == nullptr ? 0. : batch.axis_3_strains[p],
          batch.committed + p * n_state,
          batch.trial + p * n_state,
          batch.stresses + p * n,
          batch.tangents == nullptr ? nullptr : batch.tangents + p * n * n);
        if (refusal == Report::Refusal::none)
          {
            ++report.substeps;
            continue;
          }
        if (report.refused == 0)
          {
            report.first_refused = p;
            report.reason        = refusal;
          }
        ++report.refused;
      }
    return report;
  }



  template <bool micropolar>
  Report
  LinearElastic<micropolar>::respond(const Batch &batch) const
  {
    if (batch.tangents == nullptr)
      return respond_all<double>(batch);
    return respond_all<Forward<micropolar ? 8 : 4>>(batch);
  }



  template <bool micropolar>
  void
  LinearElastic<micropolar>::declare(dealii::ParameterHandler &prm) const
  {
    using dealii::Patterns::Double;
    using dealii::Patterns::Selection;

    prm.declare_entry(
      "Lame modulus", "0", Double(), "First Lame modulus lambda. Pa.", true);
    prm.declare_entry(
      "Shear modulus", "0", Double(), "Shear modulus mu. Pa.", true);
    if (micropolar)
      {
        prm.declare_entry("Couple modulus",
                          "0",
                          Double(),
                          "Modulus mu_c of the skew part: sigma_12 - sigma_21 "
                          "= 2 mu_c (eps_12 - eps_21). Pa.",
                          true);
        prm.declare_entry("Bending modulus",
                          "0",
                          Double(),
                          "Modulus B of the couple stress: m_i = B w,i. N.",
                          true);
      }
    prm.declare_entry("Kinematics",
                      "finite rotation",
                      Selection("finite rotation|small strain"),
                      "`finite rotation': a rate law in the frame that rotates "
                      "with the body; `small strain': all gradients refer to "
                      "the undeformed body.");
  }



  template <bool micropolar>
  void
  LinearElastic<micropolar>::parse(dealii::ParameterHandler &prm)
  {
    lame_modulus  = prm.get_double("Lame modulus");
    shear_modulus = prm.get_double("Shear modulus");
    if (micropolar)
      {
        couple_modulus  = prm.get_double("Couple modulus");
        bending_modulus = prm.get_double("Bending modulus");
      }
    small_strain = prm.get("Kinematics") == "small strain";
  }



  template <bool micropolar>
  void
  LinearElastic<micropolar>::check(const std::string &path,
                                   Problems          &problems) const
  {
    const auto require = [&](const bool         holds,
                             const std::string &entry,
                             const double       read,
                             const std::string &allowed) {
      if (holds)
        return;
      std::ostringstream text;
      text << entry << " is " << read
           << ", but elastic energy is positive only if " << allowed << ".";
      problems.error(path + "/" + entry, text.str());
    };
    require(shear_modulus > 0., "Shear modulus", shear_modulus, "mu > 0");
    require(3. * lame_modulus + 2. * shear_modulus > 0.,
            "Lame modulus",
            lame_modulus,
            "3 lambda + 2 mu > 0");
    if (micropolar)
      {
        require(couple_modulus >= 0.,
                "Couple modulus",
                couple_modulus,
                "mu_c >= 0");
        require(bending_modulus > 0.,
                "Bending modulus",
                bending_modulus,
                "B > 0");
      }
  }



  template <bool micropolar>
  void
  LinearElastic<micropolar>::check_initial(const InitialState & /*initial*/,
                                           const std::string & /*path*/,
                                           Problems & /*problems*/) const
  {
    // an elastic body may start from any stress
  }



  template class LinearElastic<true>;
  template class LinearElastic<false>;
} // namespace Riedel::Material
