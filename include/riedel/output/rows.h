// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/adaptation/record.h>
#include <riedel/analysis/mobilised_angles.h>
#include <riedel/analysis/shear_bands.h>
#include <riedel/equilibrium/balance.h>
#include <riedel/equilibrium/scheme.h>
#include <riedel/material/parameters.h>
#include <riedel/points/material_points.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Riedel::Output
{
  /// Names (with units) and values of a table's row.
  using Row = std::vector<std::pair<std::string, double>>;

  /// What a step leaves behind, besides fields.
  template <int dim>
  struct StepRecord
  {
    unsigned int number = 0; ///< of the step; 0 is the initial state
    double       load   = 0.0;
    double       step   = 0.0;
    unsigned int cuts   = 0; ///< since the start

    /// by a measured opening: the load factor, and the opening [m]
    std::optional<std::pair<double, double>> controlled;

    /// names of all boundaries of the body, and their mean displacements and
    /// rotations
    std::vector<std::string>         boundaries;
    std::vector<std::vector<double>> displacements;
    /// names of the boundaries with conditions, and their reactions; behind
    /// them those of the plates, of which there is more in plates
    std::vector<std::string>                                  supported;
    std::vector<typename Equilibrium::Balance<dim>::Reaction> reactions;
    /// of every plate
    std::vector<typename Equilibrium::Plates<dim>::Report> plates;

    double external_work = 0.0, stress_work = 0.0; ///< since the start [J/m]
    /// sums over all ranks
    double        volume = 0.0, solids = 0.0, mass = 0.0;
    std::uint64_t n_points = 0;
    /// do points have a yield surface?
    bool has_plasticity = false;
    /// of points that move through the grid: split, merged, removed and held
    /// back by walls since the start, and what splitting and merging have added
    /// to the sums
    bool          are_moving = false;
    std::uint64_t n_split = 0, n_merged = 0, n_removed = 0, n_held = 0;
    typename Points::MaterialPoints<dim>::Sums drift;
    Equilibrium::Outcome                       outcome;
    std::uint64_t sweeps = 0, factorisations = 0; ///< since the start
    Equilibrium::LinearCounts         linear;     ///< likewise
    std::size_t                       n_bands     = 0;
    double                            cpu_seconds = 0.0; ///< of all ranks
    std::optional<Adaptation::Record> grid; ///< if the grid may change
  };

  /// Volume, mass and number of points over all ranks, into @p record.
  template <int dim>
  void
  sum_up_points(const Points::MaterialPoints<dim> &points,
                const MPI_Comm                     communicator,
                StepRecord<dim>                   &record);

  /// Appends the plates to the boundaries of @p record.
  template <int dim>
  void
  add_plates(
    const std::vector<typename Equilibrium::Plates<dim>::Report> &plates,
    StepRecord<dim>                                              &record);

  /// Difference of external and stress work over the larger one.
  template <int dim>
  double
  energy_error(const StepRecord<dim> &record);

  /// The row of history.csv (doc/output.md).
  template <int dim>
  Row
  history_row(const StepRecord<dim> &record);

  /// What the inclination of the bands is compared with.
  struct BandAngles
  {
    /// of the bands; NaN without bands [deg]
    double                    to_minor_stress;
    Analysis::MobilisedAngles at_peak; ///< of the whole body
    Analysis::MobilisedAngles inside;  ///< the bands
  };

  /// The row of bands.csv: lengths in mm and in grain sizes.
  Row
  bands_row(const unsigned int          step,
            const double                load,
            const Analysis::ShearBands &bands,
            const BandAngles           &angles,
            const double                grain_size);
} // namespace Riedel::Output
