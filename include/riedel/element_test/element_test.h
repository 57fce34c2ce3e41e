// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/element_test/parameters.h>
#include <riedel/material/law.h>

#include <ostream>
#include <vector>

namespace Riedel::ElementTest
{
  /// The point at the end of a step.
  struct Row
  {
    unsigned int step = 0;
    /// sums of the logarithmic strains of the steps, extension positive
    double strain_11 = 0.;
    double strain_22 = 0.;
    /// all values of the law's state, in the order of its layout
    std::vector<double> state;
    /// largest ratio of shear to mean stress in the plane, as an angle [deg]
    double             mobilised_friction = 0.;
    unsigned long long substeps           = 0;
    bool               floored            = false;
    bool               clamped            = false;
  };

  /**
   * A laboratory test on one material point in plane strain: the law alone,
   * without grid and equilibrium. Stresses and strains are tension positive.
   */
  class ElementTest
  {
  public:
    /// Both must outlive this object.
    ElementTest(const Parameters &parameters, const Material::Law<2> &law);

    /**
     * Runs the test from its start and returns a row per step, the initial
     * state first. Throws ComputationError if the law refuses a step or the
     * lateral stress cannot be kept; the rows so far stay available in rows().
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
    /// Takes a step with these increments and appends its row.
    void
    advance(const std::vector<double> &increments);

    /// The increment of H_22 under which sigma_22 ends at its initial value.
    double
    lateral_increment(std::vector<double> increments, double guess) const;

    /// One call of the law for one point; throws if it is refused.
    Material::Report
    respond(const std::vector<double> &increments,
            std::vector<double>       &trial,
            std::vector<double>       &stresses,
            std::vector<double>       *tangent) const;

    const Parameters       &parameters;
    const Material::Law<2> &law;
    std::vector<Row>        results;
  };
} // namespace Riedel::ElementTest
