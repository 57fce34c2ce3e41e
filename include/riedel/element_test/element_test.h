// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/element_test/parameters.h>
#include <riedel/material/law.h>

#include <optional>
#include <ostream>
#include <vector>

namespace Riedel::ElementTest
{
  /// What moves a point in a step.
  struct Motion
  {
    /// generalised increments, as many as the law has
    std::vector<double> increments;
    /// logarithmic strain of axis 3; not in tests in plane strain
    std::optional<double> axis_3_strain;
  };

  /// The point at the end of a step.
  struct Row
  {
    unsigned int step = 0;
    /// sums of the logarithmic strains of the steps, extension positive
    double strain_11 = 0.;
    double strain_22 = 0.;
    double strain_33 = 0.;
    /// sum of L_12 dt + L_21 dt of the steps
    double shear_strain = 0.;
    /// all values of the law's state, in the order of its layout
    std::vector<double> state;
    /// -tr sigma / 3 [Pa]
    double mean_pressure = 0.;
    /// sqrt(3/2 s:s) of the symmetric deviator s, not negative [Pa]
    double deviator = 0.;
    /// largest ratio of shear to mean stress in the plane, as an angle [deg]
    double mobilised_friction = 0.;
    /// what the pore water of an undrained test has got if the total stress 22
    /// is kept [Pa]
    double             excess_pore_pressure = 0.;
    unsigned long long substeps             = 0;
    bool               floored              = false;
    bool               clamped              = false;

    double
    volumetric_strain() const
    {
      return strain_11 + strain_22 + strain_33;
    }
  };

  /**
   * A laboratory test on one material point: the law alone, without grid and
   * equilibrium. Stresses and strains are tension positive.
   *
   * In tests other than paths the velocity gradient L is constant over a step
   * and given by L dt, so that strains of steps add up.
   */
  class ElementTest
  {
  public:
    /// Both must outlive this object.
    ElementTest(const Parameters &parameters, const Material::Law<2> &law);

    /**
     * Runs the test from its start and returns a row per step, the initial
     * state first. Throws InputError if the law cannot do this test, and
     * ComputationError if the law refuses a step or the lateral stress cannot
     * be kept; the rows so far stay available in rows().
     */
    const std::vector<Row> &
    run();

    const std::vector<Row> &
    rows() const
    {
      return results;
    }

    /// All rows as comma separated values with a header that names units.
    void
    write_csv(std::ostream &out) const;

  private:
    /// Takes a step and appends its row.
    void
    advance(const Motion &motion);

    /// The motion of a step of a test that is not a path. @p lateral is the
    /// strain that the test adjusts to keep sigma_22, if it does.
    Motion
    motion_of_step(const double lateral) const;

    /// The motion with L dt = strains on the diagonal and @p shear in 12, and
    /// the micro-rotation @p theta.
    Motion
    motion(const double strain_11,
           const double strain_22,
           const double strain_33,
           const double shear = 0.,
           const double theta = 0.) const;

    /// The lateral strain under which sigma_22 ends at its initial value,
    /// looked for from @p guess on.
    double
    lateral_strain(const double guess) const;

    /// sigma_22 at the end of a step [Pa]
    double
    stress_22(const Motion &motion) const;

    /// One call of the law for one point; throws if it is refused.
    Material::Report
    respond(const Motion &motion, std::vector<double> &trial) const;

    /// Fills what follows from the state.
    void
    evaluate(Row &row) const;

    const Parameters       &parameters;
    const Material::Law<2> &law;
    const unsigned int      stress_place;
    std::vector<Row>        results;
  };
} // namespace Riedel::ElementTest
