// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/errors.h>

#include <array>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Riedel::ElementTest
{
  enum class Test
  {
    biaxial,   ///< axis 1 shortened, sigma_22 kept constant
    oedometer, ///< axis 2 shortened, no lateral strain
    isotropic, ///< axes 1 and 2 shortened alike
    path       ///< given increments
  };

  /// Generalised increments of a material point, repeated.
  struct PathRow
  {
    std::array<double, 7> increments; ///< H_11 H_12 H_21 H_22 theta Gamma_1 _2
    unsigned int          repeats = 1;
  };

  /**
   * Section "Element test": the loading of one material point, used by
   * `Simulation type = element test`.
   */
  struct Parameters
  {
    Test         test = Test::biaxial;
    std::string  material;               ///< name of the material, or empty
    double       void_ratio        = 0.; ///< at the start
    double       vertical_pressure = 0.; ///< -sigma_22 at the start [Pa]
    double       K0                = 1.; ///< sigma_11 = sigma_33 = K0 sigma_22
    double       axial_strain      = 0.; ///< logarithmic shortening at the end
    unsigned int steps             = 1;  ///< of equal logarithmic strain
    std::string  increments;             ///< rows of a path, inline
    std::string  increments_file;        ///< rows of a path, a CSV file

    static void
    declare(dealii::ParameterHandler &prm);
    void
    parse(dealii::ParameterHandler &prm);
    void
    check(Problems &problems) const;

    /// The rows of a path; throws InputError if they cannot be read.
    std::vector<PathRow>
    path_rows() const;
  };
} // namespace Riedel::ElementTest
