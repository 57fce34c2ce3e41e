// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/errors.h>
#include <riedel/material/law.h>

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
    biaxial,            ///< plane strain; axis 1 shortened, sigma_22 kept
    oedometer,          ///< axis 2 shortened, axes 1 and 3 held
    isotropic,          ///< all three axes shortened alike
    triaxial_drained,   ///< axis 1 shortened, sigma_22 = sigma_33 kept
    triaxial_undrained, ///< axis 1 shortened, axes 2 and 3 keep the volume
    simple_shear,       ///< axis 1 slides along planes with normal 2
    path                ///< given increments
  };

  /// Generalised increments of a material point, repeated.
  struct PathRow
  {
    std::array<double, 7> increments; ///< H_11 H_12 H_21 H_22 theta Gamma_1 _2
    unsigned int          repeats = 1;
    /// logarithmic, extension positive
    double axis_3_strain = 0.;
  };

  /**
   * Section "Element test": the loading of one material point, used by
   * `Simulation type = element test`.
   */
  struct Parameters
  {
    Test        test = Test::biaxial;
    std::string material;               ///< name of the material, or empty
    double      void_ratio        = 0.; ///< at the start
    double      vertical_pressure = 0.; ///< -sigma_22 at the start [Pa]
    double      K0                = 1.; ///< sigma_11 = sigma_33 = K0 sigma_22
    double      axial_strain      = 0.; ///< logarithmic shortening at the end
    double      shear_strain      = 0.; ///< of simple shear, at the end
    /// Does simple shear keep the volume? Otherwise it keeps sigma_22.
    bool shear_keeps_volume = false;
    /// Do the grains of simple shear turn with the continuum's spin?
    bool   turns_with_spin = true;
    double micro_rotation  = 0.; ///< otherwise this, at the end [rad]
    /// what was read instead of a micro-rotation, or empty
    std::string  unreadable_micro_rotation;
    unsigned int steps = 1;       ///< of equal logarithmic strain
    std::string  increments;      ///< rows of a path, inline
    std::string  increments_file; ///< rows of a path, a CSV file

    static void
    declare(dealii::ParameterHandler &prm);
    void
    parse(dealii::ParameterHandler &prm);
    void
    check(Problems &problems) const;

    /// Rules between the test and the law under test.
    void
    check_law(const Material::Law<2> &law, Problems &problems) const;

    /// Is the volume kept, so that a saturated body would build up pore
    /// pressure?
    bool
    is_undrained() const;

    /// The rows of a path; throws InputError if they cannot be read.
    std::vector<PathRow>
    path_rows() const;
  };
} // namespace Riedel::ElementTest
