// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/material/hypoplastic_floor.h>
#include <riedel/material/hypoplastic_rate.h>
#include <riedel/material/law.h>

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Riedel::Material
{
  /// What a scene says of a hypoplastic material. The classical law
  /// (@p micropolar is false) knows the polar constants too, and ignores them.
  struct HypoplasticParameters
  {
    HypoplasticConstants constants;
    HypoplasticControls  controls;
    /// d_50 [m]; the constants of the classical law have none
    double grain_diameter = 0.;

    static void
    declare(const bool micropolar, dealii::ParameterHandler &prm);

    void
    parse(const bool micropolar, dealii::ParameterHandler &prm);

    void
    check(const bool         micropolar,
          const std::string &path,
          Problems          &problems) const;

    void
    check_initial(const InitialState &initial,
                  const std::string  &path,
                  Problems           &problems) const;

  private:
    std::string polar_constant    = "1/a1";
    bool        polar_constant_ok = true;
  };
} // namespace Riedel::Material
