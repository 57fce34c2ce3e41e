// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/continuum/generalised.h>
#include <riedel/continuum/step_kinematics.h>
#include <riedel/element_test/element_test.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Riedel::ElementTest
{
  namespace
  {
    using Components = Continuum::Generalised<2>;



    /// Angle [deg] whose sine is the largest shear stress in the plane over
    /// the mean pressure in the plane (symmetric part); 90 at no pressure.
    double
    friction_angle(const double *stress)
    {
      const double shear =
        std::hypot(.5 * (stress[0] - stress[1]), .5 * (stress[3] + stress[4]));
      const double pressure = -.5 * (stress[0] + stress[1]);
      if (!(shear < pressure))
        return 90.;
      return std::asin(shear / pressure) * 180. / 3.14159265358979323846;
    }
  } // namespace



  ElementTest::ElementTest(const Parameters       &parameters,
                           const Material::Law<2> &law)
    : parameters(parameters)
    , law(law)
  {}



  Material::Report
  ElementTest::respond(const std::vector<double> &increments,
                       std::vector<double>       &trial,
                       std::vector<double>       &stresses,
                       std::vector<double>       *tangent) const
  {
    const Material::Batch  batch{1,
                                increments.data(),
                                results.back().state.data(),
                                trial.data(),
                                stresses.data(),
                                tangent == nullptr ? nullptr : tangent->data()};
    const Material::Report report = law.respond(batch);
    if (report.refused > 0)
      throw ComputationError("The element test stopped in step " +
                             std::to_string(results.back().step + 1) + ": " +
                             Material::describe(report.reason) + ".");
    return report;
  }



  void
  ElementTest::advance(const std::vector<double> &increments)
  {
    Row row;
    row.step  = results.back().step + 1;
    row.state = results.back().state;
    std::vector<double>    stresses(law.n_generalised());
    const Material::Report report =
      respond(increments, row.state, stresses, nullptr);

    double strain_11 = increments[Components::gradient(0, 0)];
    double strain_22 = increments[Components::gradient(1, 1)];
    if (!law.is_geometrically_linear())
      {
        const Continuum::StepKinematics<double> kinematics(increments.data());
        if (kinematics.valid)
          {
            strain_11 = kinematics.log_f.mean + kinematics.log_f.difference;
            strain_22 = kinematics.log_f.mean - kinematics.log_f.difference;
          }
      }
    row.strain_11 = results.back().strain_11 + strain_11;
    row.strain_22 = results.back().strain_22 + strain_22;
    row.mobilised_friction =
      friction_angle(row.state.data() + law.layout().find("stress"));
    row.substeps = report.substeps;
    row.floored  = report.floored > 0;
    row.clamped  = report.clamped > 0;
    results.push_back(row);
  }



  double
  ElementTest::lateral_increment(std::vector<double> increments,
                                 const double        guess) const
  {
    const unsigned int  place   = Components::gradient(1, 1);
    const unsigned int  n       = law.n_generalised();
    const double        target  = -parameters.vertical_pressure;
    const double        stretch = law.is_geometrically_linear() ?
                                    1. :
                                    1. + increments[Components::gradient(0, 0)];
    std::vector<double> trial(results.back().state.size());
    std::vector<double> stresses(n);
    std::vector<double> tangent(n * n);

    // P_22 = sigma_22 f_11 while f_21 = 0
    increments[place] = guess;
    double best       = std::numeric_limits<double>::infinity();
    double result     = guess;
    for (unsigned int iteration = 0; iteration < 50; ++iteration)
      {
        respond(increments, trial, stresses, &tangent);
        const double residual = stresses[place] / stretch - target;
        // to rounding: go on until it does not get better any more
        if (std::abs(residual) < best)
          {
            best   = std::abs(residual);
            result = increments[place];
          }
        else if (best < 1e-9 * std::abs(target) + 1e-9)
          return result;
        if (best < 1e-14 * std::abs(target))
          return result;
        const double slope = tangent[place * n + place] / stretch;
        const double limit =
          10. * std::abs(increments[Components::gradient(0, 0)]);
        const double step = -residual / slope;
        increments[place] += std::min(limit, std::max(-limit, step));
      }
    if (best < 1e-6 * std::abs(target) + 1e-6)
      return result;
    throw ComputationError(
      "The element test stopped in step " +
      std::to_string(results.back().step + 1) +
      ": no lateral strain keeps sigma_22 at " + std::to_string(target) +
      " Pa; the best one misses it by " + std::to_string(best) + " Pa.");
  }



  const std::vector<Row> &
  ElementTest::run()
  {
    Material::InitialState initial;
    initial.stress[0][0] = -parameters.K0 * parameters.vertical_pressure;
    initial.stress[1][1] = -parameters.vertical_pressure;
    initial.stress[2][2] = -parameters.K0 * parameters.vertical_pressure;
    initial.void_ratio   = parameters.void_ratio;

    results.assign(1, Row());
    Row &start = results.front();
    start.state.resize(law.layout().size());
    law.initialise(initial, start.state.data());
    start.mobilised_friction =
      friction_angle(start.state.data() + law.layout().find("stress"));

    std::vector<double> increments(law.n_generalised(), 0.);
    if (parameters.test == Test::path)
      {
        for (const PathRow &row : parameters.path_rows())
          {
            for (unsigned int i = increments.size(); i < 7; ++i)
              if (row.increments[i] != 0.)
                throw ComputationError("The path rotates the grains, but the "
                                       "law `" +
                                       law.name() + "' is not micropolar.");
            std::copy(row.increments.begin(),
                      row.increments.begin() + increments.size(),
                      increments.begin());
            for (unsigned int r = 0; r < row.repeats; ++r)
              advance(increments);
          }
        return results;
      }

    // equal logarithmic strains; a small-strain law takes them as they are
    const double strain = -parameters.axial_strain / parameters.steps;
    const double shortening =
      law.is_geometrically_linear() ? strain : std::expm1(strain);
    const unsigned int axis_1 = Components::gradient(0, 0);
    const unsigned int axis_2 = Components::gradient(1, 1);
    for (unsigned int s = 0; s < parameters.steps; ++s)
      {
        switch (parameters.test)
          {
            case Test::biaxial:
              increments[axis_1] = shortening;
              increments[axis_2] =
                lateral_increment(increments, increments[axis_2]);
              break;
            case Test::oedometer:
              increments[axis_2] = shortening;
              break;
            case Test::isotropic:
              increments[axis_1] = shortening;
              increments[axis_2] = shortening;
              break;
            case Test::path:
              break;
          }
        advance(increments);
      }
    return results;
  }



  void
  ElementTest::write_csv(std::ostream &out) const
  {
    out << "step,strain 11,strain 22";
    for (const Material::StateLayout::Slot &slot : law.layout().slots())
      for (const std::string &component : slot.components)
        {
          std::string name = slot.name;
          std::replace(name.begin(), name.end(), '_', ' ');
          out << ',' << name << (component.empty() ? "" : " ") << component;
          if (slot.unit != "1")
            out << " [" << slot.unit << ']';
        }
    out << ",mobilised friction angle [deg],substeps,floored,clamped\n";

    const auto precision = out.precision(12);
    for (const Row &row : results)
      {
        out << row.step << ',' << row.strain_11 << ',' << row.strain_22;
        for (const double value : row.state)
          out << ',' << value;
        out << ',' << row.mobilised_friction << ',' << row.substeps << ','
            << row.floored << ',' << row.clamped << '\n';
      }
    out.precision(precision);
  }
} // namespace Riedel::ElementTest
