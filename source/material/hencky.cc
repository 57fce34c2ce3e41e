// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/continuum/generalised.h>
#include <riedel/continuum/step_kinematics.h>
#include <riedel/material/hencky.h>

#include <deal.II/base/parameter_handler.h>

#include <boost/math/special_functions/lambert_w.hpp>

#include <algorithm>
#include <array>
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
    constexpr unsigned int n = Continuum::Generalised<2>::n_classical;

    // Places in a point's state, in the order of the constructor.
    constexpr unsigned int strain_place = 5;
    constexpr unsigned int n_state      = strain_place + 4;

    StateLayout
    make_layout()
    {
      StateLayout layout;
      layout.add("stress",
                 "Pa",
                 "Cauchy stress, tension positive, second index: face normal",
                 {"11", "22", "33", "12", "21"});
      layout.add("logarithmic_strain",
                 "1",
                 "elastic strain ln(b)/2 from the stress-free state, extension "
                 "positive",
                 {"11", "22", "33", "12"});
      return layout;
    }



    /// arsinh(sqrt x)/sqrt x for x >= 0; smooth at 0, where the principal
    /// strains are equal
    template <typename Number>
    Number
    arsinh_ratio(const Number &x)
    {
      const double v = value_of(x);
      if (v < Continuum::StepKinematics<Number>::largest_in_series)
        return Continuum::StepKinematics<Number>::series(x);
      const double root  = std::sqrt(v);
      const double ratio = std::asinh(root) / root;
      return chain_rule(x, ratio, .5 * (1. / std::sqrt(1. + v) - ratio) / v);
    }
  } // namespace



  Hencky::Hencky()
    : slots(make_layout())
  {}



  double
  Hencky::stiffness(const double *state) const
  {
    const double *strain = state + strain_place;
    return 2. * shear_modulus * std::exp(-(strain[0] + strain[1] + strain[2]));
  }



  void
  Hencky::initialise(const InitialState &initial, double *state) const
  {
    // With t = tr eps, t exp(-t) = tr sigma/(3 lambda + 2 mu); of its two
    // solutions in tension the one that belongs to the smaller strain.
    const double trace = -boost::math::lambert_w0(
      -dealii::trace(initial.stress) / volumetric_modulus());
    const double J      = std::exp(trace);
    const auto   strain = [&](const unsigned int i, const unsigned int j) {
      return (J * initial.stress[i][j] - (i == j ? lame_modulus * trace : 0.)) /
             (2. * shear_modulus);
    };
    state[0]                = initial.stress[0][0];
    state[1]                = initial.stress[1][1];
    state[2]                = initial.stress[2][2];
    state[3]                = initial.stress[0][1];
    state[4]                = initial.stress[1][0];
    state[strain_place]     = strain(0, 0);
    state[strain_place + 1] = strain(1, 1);
    state[strain_place + 2] = strain(2, 2);
    state[strain_place + 3] = strain(0, 1);
  }



  void
  Hencky::stresses_at_rest(const double *state, double *stresses) const
  {
    stresses[0] = state[0];
    stresses[1] = state[3];
    stresses[2] = state[4];
    stresses[3] = state[1];
  }



  template <typename Number>
  Report::Refusal
  Hencky::respond_point(const double *increment,
                        const double  axis_3_strain,
                        const double *committed,
                        double       *trial,
                        double       *stresses,
                        double       *tangent) const
  {
    using std::exp;
    using std::log1p;

    Number H[n];
    for (unsigned int i = 0; i < n; ++i)
      H[i] = input<Number>(increment[i], i);
    const Number volume_change = (H[0] + H[3]) + (H[0] * H[3] - H[1] * H[2]);
    const Number j             = 1. + volume_change;
    if (!(value_of(j) > 0.))
      return std::isfinite(value_of(j)) ? Report::Refusal::inverted_step :
                                          Report::Refusal::not_finite;

    // In the plane, the strain at the start is its mean and a deviator of
    // length r, and b/sqrt(det b) = cosh(2 r) I + S with S = sinh(2 r)/r times
    // this deviator. So det b > 0, and no eigenvalue has to be computed.
    const double *strain_n = committed + strain_place;
    const double  mean_n   = .5 * (strain_n[0] + strain_n[1]);
    const double  dev_n    = .5 * (strain_n[0] - strain_n[1]);
    const double  r        = std::hypot(dev_n, strain_n[3]);
    const double  cosine   = std::cosh(2. * r);
    const double  sine     = r > 0. ? std::sinh(2. * r) / r : 2.;
    const double  S_dev    = sine * dev_n;
    const double  S_12     = sine * strain_n[3];

    // The deviator of f (cosh(2 r) I + S) f^T / j = b/sqrt(det b) at the end.
    // That of f f^T is formed from H, which may be small beside I.
    const Number f_11      = 1. + H[0];
    const Number f_22      = 1. + H[3];
    const Number inverse_j = 1. / j;
    const Number b_dev =
      inverse_j *
      ((.5 * cosine) *
         ((H[0] - H[3]) * (f_11 + f_22) + (H[1] - H[2]) * (H[1] + H[2])) +
       (.5 * S_dev) * (f_11 * f_11 - H[1] * H[1] - H[2] * H[2] + f_22 * f_22) +
       S_12 * (f_11 * H[1] - H[2] * f_22));
    const Number b_12 = inverse_j * (cosine * (f_11 * H[2] + H[1] * f_22) +
                                     S_dev * (f_11 * H[2] - H[1] * f_22) +
                                     S_12 * (f_11 * f_22 + H[1] * H[2]));

    // the length of this deviator is sinh(2 r) at the end
    const Number ratio = .5 * arsinh_ratio(b_dev * b_dev + b_12 * b_12);
    const PlaneTensor<Number> strain{mean_n + .5 * log1p(volume_change),
                                     ratio * b_dev,
                                     ratio * b_12,
                                     Number(0.)};

    const double                strain_33 = strain_n[2] + axis_3_strain;
    const Number                trace     = 2. * strain.mean + strain_33;
    const Number                inverse_J = exp(-trace);
    const Number                isotropic = (lame_modulus * inverse_J) * trace;
    const Number                two_mu    = (2. * shear_modulus) * inverse_J;
    const Number                sigma_33  = isotropic + two_mu * strain_33;
    const std::array<Number, n> sigma =
      PlaneTensor<Number>{isotropic + two_mu * strain.mean,
                          two_mu * strain.difference,
                          two_mu * strain.shear,
                          Number(0.)}
        .components();
    const std::array<Number, n> P =
      Continuum::nominal_stress(sigma, Continuum::step_cofactor(H));

    double sum = value_of(sigma_33);
    for (const Number &component : P)
      sum += value_of(component);
    if (!std::isfinite(sum))
      return Report::Refusal::not_finite;

    trial[0]                = value_of(sigma[0]);
    trial[1]                = value_of(sigma[3]);
    trial[2]                = value_of(sigma_33);
    trial[3]                = value_of(sigma[1]);
    trial[4]                = value_of(sigma[2]);
    trial[strain_place]     = value_of(strain.mean + strain.difference);
    trial[strain_place + 1] = value_of(strain.mean - strain.difference);
    trial[strain_place + 2] = strain_33;
    trial[strain_place + 3] = value_of(strain.shear);

    for (unsigned int a = 0; a < n; ++a)
      stresses[a] = value_of(P[a]);
    if constexpr (!std::is_same<Number, double>::value)
      for (unsigned int a = 0; a < n; ++a)
        P[a].derivatives.copy_to(tangent + a * n, n);
    else
      (void)tangent;
    return Report::Refusal::none;
  }



  template <typename Number>
  Report
  Hencky::respond_all(const Batch &batch) const
  {
    Report report;
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



  Report
  Hencky::respond(const Batch &batch) const
  {
    if (batch.tangents == nullptr)
      return respond_all<double>(batch);
    return respond_all<Forward<n>>(batch);
  }



  void
  Hencky::declare(dealii::ParameterHandler &prm) const
  {
    using dealii::Patterns::Double;

    prm.declare_entry(
      "Young modulus", "0", Double(), "Young's modulus E. Pa.", true);
    prm.declare_entry("Poisson ratio",
                      "0",
                      Double(),
                      "Poisson's ratio nu, of logarithmic strains. "
                      "Dimensionless.",
                      true);
  }



  void
  Hencky::parse(dealii::ParameterHandler &prm)
  {
    young_modulus = prm.get_double("Young modulus");
    poisson_ratio = prm.get_double("Poisson ratio");
    shear_modulus = young_modulus / (2. * (1. + poisson_ratio));
    lame_modulus =
      2. * shear_modulus * poisson_ratio / (1. - 2. * poisson_ratio);
  }



  void
  Hencky::check(const std::string &path, Problems &problems) const
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
    require(young_modulus > 0., "Young modulus", young_modulus, "E > 0");
    require(poisson_ratio > -1. && poisson_ratio < .5,
            "Poisson ratio",
            poisson_ratio,
            "-1 < nu < 1/2");
  }



  void
  Hencky::check_initial(const InitialState &initial,
                        const std::string  &path,
                        Problems           &problems) const
  {
    // t exp(-t) is at most 1/e
    const double largest = volumetric_modulus() / std::exp(1.);
    const double trace   = dealii::trace(initial.stress);
    if (volumetric_modulus() > 0. && trace > largest)
      {
        std::ostringstream text;
        text << "The trace of the initial stress is " << trace
             << " Pa, but a body of this law bears no more than (3 lambda + 2 "
                "mu)/e = "
             << largest << " Pa in tension.";
        problems.error(path, text.str());
      }
  }
} // namespace Riedel::Material
