// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/continuum/generalised.h>
#include <riedel/continuum/mobilised_friction.h>
#include <riedel/continuum/step_kinematics.h>
#include <riedel/element_test/element_test.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Riedel::ElementTest
{
  namespace
  {
    using Components = Continuum::Generalised<2>;
  } // namespace



  ElementTest::ElementTest(const Parameters       &parameters,
                           const Material::Law<2> &law)
    : parameters(parameters)
    , law(law)
    , stress_place(law.layout().find("stress"))
  {}



  Material::Report
  ElementTest::respond(const Motion &motion, std::vector<double> &trial) const
  {
    std::vector<double> stresses(law.n_generalised());
    Material::Batch     batch{1,
                          motion.increments.data(),
                          results.back().state.data(),
                          trial.data(),
                          stresses.data(),
                          nullptr};
    if (motion.axis_3_strain)
      batch.axis_3_strains = &*motion.axis_3_strain;
    const Material::Report report = law.respond(batch);
    if (report.refused > 0)
      throw ComputationError("The element test stopped in step " +
                             std::to_string(results.back().step + 1) + ": " +
                             Material::describe(report.reason) + ".");
    return report;
  }



  void
  ElementTest::evaluate(Row &row) const
  {
    const double *stress   = row.state.data() + stress_place;
    row.mean_pressure      = -(stress[0] + stress[1] + stress[2]) / 3.;
    const double shear     = .5 * (stress[3] + stress[4]);
    double       deviators = 2. * shear * shear;
    for (unsigned int i = 0; i < 3; ++i)
      {
        const double deviator = stress[i] + row.mean_pressure;
        deviators += deviator * deviator;
      }
    row.deviator           = std::sqrt(1.5 * deviators);
    row.mobilised_friction = Continuum::mobilised_friction(stress);
    if (parameters.is_undrained())
      row.excess_pore_pressure = stress[1] + parameters.vertical_pressure;
  }



  void
  ElementTest::advance(const Motion &motion)
  {
    Row row;
    row.step                      = results.back().step + 1;
    row.state                     = results.back().state;
    const Material::Report report = respond(motion, row.state);

    const std::vector<double> &H         = motion.increments;
    double                     strain_11 = H[Components::gradient(0, 0)];
    double                     strain_22 = H[Components::gradient(1, 1)];
    double                     shear =
      H[Components::gradient(0, 1)] + H[Components::gradient(1, 0)];
    if (!law.is_geometrically_linear())
      {
        const Continuum::StepKinematics<double> kinematics(H.data());
        if (kinematics.valid)
          {
            strain_11 = kinematics.log_f.mean + kinematics.log_f.difference;
            strain_22 = kinematics.log_f.mean - kinematics.log_f.difference;
            shear     = 2. * kinematics.log_f.shear;
          }
      }
    row.strain_11 = results.back().strain_11 + strain_11;
    row.strain_22 = results.back().strain_22 + strain_22;
    row.strain_33 =
      results.back().strain_33 + motion.axis_3_strain.value_or(0.);
    row.shear_strain = results.back().shear_strain + shear;
    row.substeps     = report.substeps;
    row.floored      = report.floored > 0;
    row.clamped      = report.clamped > 0;
    evaluate(row);
    results.push_back(row);
  }



  Motion
  ElementTest::motion(const double strain_11,
                      const double strain_22,
                      const double strain_33,
                      const double shear,
                      const double theta) const
  {
    Motion result;
    result.increments.assign(law.n_generalised(), 0.);
    std::vector<double> &H = result.increments;
    if (law.is_geometrically_linear())
      {
        H[Components::gradient(0, 0)] = strain_11;
        H[Components::gradient(1, 1)] = strain_22;
        H[Components::gradient(0, 1)] = shear;
      }
    else
      {
        // f = exp(L dt) of an upper triangle: f_12 is L_12 dt times the mean of
        // exp over the strains
        H[Components::gradient(0, 0)] = std::expm1(strain_11);
        H[Components::gradient(1, 1)] = std::expm1(strain_22);
        const double difference       = strain_22 - strain_11;
        const double mean =
          difference == 0. ?
            std::exp(strain_11) :
            std::exp(strain_11) * std::expm1(difference) / difference;
        H[Components::gradient(0, 1)] = shear * mean;
      }
    if (law.is_micropolar())
      H[Components::spin()] = theta;
    if (strain_33 != 0.)
      result.axis_3_strain = strain_33;
    return result;
  }



  Motion
  ElementTest::motion_of_step(const double lateral) const
  {
    const double strain = -parameters.axial_strain / parameters.steps;
    switch (parameters.test)
      {
        case Test::biaxial:
          return motion(strain, lateral, 0.);
        case Test::oedometer:
          return motion(0., strain, 0.);
        case Test::isotropic:
          return motion(strain, strain, strain);
        case Test::triaxial_drained:
          // the law is isotropic: equal strains give equal stresses
          return motion(strain, lateral, lateral);
        case Test::triaxial_undrained:
          return motion(strain, -.5 * strain, -.5 * strain);
        case Test::simple_shear:
          {
            const double shear = parameters.shear_strain / parameters.steps;
            // the spin w_21 = (L_21 - L_12)/2
            const double theta = parameters.turns_with_spin ?
                                   -.5 * shear :
                                   parameters.micro_rotation / parameters.steps;
            return motion(0.,
                          parameters.shear_keeps_volume ? 0. : lateral,
                          0.,
                          shear,
                          theta);
          }
        case Test::path:
          break;
      }
    Assert(false, dealii::ExcInternalError());
    return {};
  }



  double
  ElementTest::stress_22(const Motion &motion) const
  {
    std::vector<double> trial(results.back().state.size());
    respond(motion, trial);
    return trial[stress_place + 1];
  }



  double
  ElementTest::lateral_strain(const double guess) const
  {
    const double target = -parameters.vertical_pressure;
    const double size   = std::abs(parameters.test == Test::simple_shear ?
                                   parameters.shear_strain :
                                   parameters.axial_strain) /
                        parameters.steps;
    // rounding of the stresses, and of what is taken for kept
    const double *stress = results.back().state.data() + stress_place;
    const double  scale =
      std::max({std::abs(stress[0]), std::abs(stress[1]), std::abs(stress[2])});
    const double exact      = 1e-13 * scale + 1e-12;
    const double acceptable = 1e-6 * scale + 1e-6;

    // The secant through the last two points. sigma_22 jumps slightly where
    // the number of substeps changes: where the secant leaves the interval in
    // which the residual changes its sign, halve the interval.
    const auto residual_at = [&](const double strain) {
      return stress_22(motion_of_step(strain)) - target;
    };
    double strain = guess, residual = residual_at(guess);
    double best_strain = strain, best = std::abs(residual);
    double below = -std::numeric_limits<double>::infinity();
    double above = std::numeric_limits<double>::infinity();
    double next  = strain - std::copysign(1e-3 * size, residual);
    for (unsigned int iteration = 0; iteration < 100 && best > exact;
         ++iteration)
      {
        (residual < 0. ? below : above) = strain;
        const bool bracketed = std::isfinite(below) && std::isfinite(above);
        if (bracketed &&
            !(next > std::min(below, above) && next < std::max(below, above)))
          next = .5 * (below + above);
        if (next == strain)
          break;

        const double previous = residual;
        const double step     = next - strain;
        strain                = next;
        residual              = residual_at(strain);
        if (std::abs(residual) < best)
          {
            best        = std::abs(residual);
            best_strain = strain;
          }
        else if (best < 1e-12 * scale)
          break; // rounding
        const double slope = (residual - previous) / step;
        // extension makes the stress less compressive
        const double wanted =
          slope > 0. ? -residual / slope : std::copysign(size, -residual);
        next = strain + std::clamp(wanted, -10. * size, 10. * size);
      }
    if (best <= acceptable)
      return best_strain;
    throw ComputationError(
      "The element test stopped in step " +
      std::to_string(results.back().step + 1) +
      ": no lateral strain keeps sigma_22 at " + std::to_string(target) +
      " Pa; the best one misses it by " + std::to_string(best) + " Pa.");
  }



  const std::vector<Row> &
  ElementTest::run()
  {
    Problems problems;
    parameters.check_law(law, problems);
    if (!problems.errors.empty())
      throw InputError(problems.errors[0].path + ": " +
                       problems.errors[0].message);

    Material::InitialState initial;
    initial.stress[0][0] = -parameters.K0 * parameters.vertical_pressure;
    initial.stress[1][1] = -parameters.vertical_pressure;
    initial.stress[2][2] = -parameters.K0 * parameters.vertical_pressure;
    initial.void_ratio   = parameters.void_ratio;

    results.assign(1, Row());
    Row &start = results.front();
    start.state.resize(law.layout().size());
    law.initialise(initial, start.state.data());
    evaluate(start);

    if (parameters.test == Test::path)
      {
        for (const PathRow &row : parameters.path_rows())
          {
            Motion motion;
            motion.increments.assign(row.increments.begin(),
                                     row.increments.begin() +
                                       law.n_generalised());
            if (row.axis_3_strain != 0.)
              motion.axis_3_strain = row.axis_3_strain;
            for (unsigned int r = 0; r < row.repeats; ++r)
              advance(motion);
          }
        return results;
      }

    const bool keeps_stress =
      parameters.test == Test::biaxial ||
      parameters.test == Test::triaxial_drained ||
      (parameters.test == Test::simple_shear && !parameters.shear_keeps_volume);
    double lateral = 0.;
    for (unsigned int s = 0; s < parameters.steps; ++s)
      {
        if (keeps_stress)
          lateral = lateral_strain(lateral);
        advance(motion_of_step(lateral));
      }
    return results;
  }



  void
  ElementTest::write_csv(std::ostream &out) const
  {
    out << "step,strain 11,strain 22,strain 33,shear strain,volumetric strain";
    for (const Material::StateLayout::Slot &slot : law.layout().slots())
      for (const std::string &component : slot.components)
        {
          std::string name = slot.name;
          std::replace(name.begin(), name.end(), '_', ' ');
          out << ',' << name << (component.empty() ? "" : " ") << component;
          if (slot.unit != "1")
            out << " [" << slot.unit << ']';
        }
    out << ",mean pressure [Pa],deviator [Pa]";
    if (parameters.is_undrained())
      out << ",excess pore pressure [Pa]";
    out << ",mobilised friction angle [deg],substeps,floored,clamped\n";

    const auto precision = out.precision(12);
    for (const Row &row : results)
      {
        out << row.step << ',' << row.strain_11 << ',' << row.strain_22 << ','
            << row.strain_33 << ',' << row.shear_strain << ','
            << row.volumetric_strain();
        for (const double value : row.state)
          out << ',' << value;
        out << ',' << row.mean_pressure << ',' << row.deviator;
        if (parameters.is_undrained())
          out << ',' << row.excess_pore_pressure;
        out << ',' << row.mobilised_friction << ',' << row.substeps << ','
            << row.floored << ',' << row.clamped << '\n';
      }
    out.precision(precision);
  }
} // namespace Riedel::ElementTest
