// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/output/rows.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Riedel::Output
{
  template <int dim>
  void
  sum_up_points(const Points::MaterialPoints<dim> &points,
                const MPI_Comm                     communicator,
                StepRecord<dim>                   &record)
  {
    const unsigned int  e = points.layout().find("void_ratio");
    std::vector<double> here(4, 0.0), all(4);
    for (unsigned int p = 0; p < points.n_points(); ++p)
      {
        if (e != Material::StateLayout::absent)
          here[3] +=
            points.row(p)[points.place.volume] / (1.0 + points.row(p)[e]);
        here[0] += points.row(p)[points.place.volume];
        here[1] += points.row(p)[points.place.mass];
      }
    here[2] = points.n_points();
    dealii::Utilities::MPI::sum(here, communicator, all);
    record.volume         = all[0];
    record.mass           = all[1];
    record.solids         = all[3];
    record.n_points       = static_cast<std::uint64_t>(all[2]);
    record.has_plasticity = points.layout().find("plastic_multiplier") !=
                            Material::StateLayout::absent;
    record.are_moving = points.are_moving();
    record.n_split    = points.n_split();
    record.n_merged   = points.n_merged();
    record.drift      = points.drift();
    record.n_removed  = points.n_removed();
    record.n_held     = points.n_held();
  }



  template <int dim>
  void
  add_plates(
    const std::vector<typename Equilibrium::Plates<dim>::Report> &plates,
    StepRecord<dim>                                              &record)
  {
    record.plates = plates;
    for (const auto &plate : plates)
      {
        record.boundaries.push_back(plate.name);
        record.displacements.emplace_back(plate.displacement.begin_raw(),
                                          plate.displacement.end_raw());
        record.supported.push_back(plate.name);
      }
  }



  template <int dim>
  double
  energy_error(const StepRecord<dim> &record)
  {
    const double largest =
      std::max(std::abs(record.external_work), std::abs(record.stress_work));
    return largest == 0.0 ?
             0.0 :
             (record.external_work - record.stress_work) / largest;
  }



  template <int dim>
  Row
  history_row(const StepRecord<dim> &record)
  {
    const std::string per_metre = (dim == 2 ? "/m" : "");
    Row               row       = {{"step [1]", record.number},
                                   {"load [1]", record.load},
                                   {"step size [1]", record.step}};
    if (record.controlled)
      {
        row.emplace_back("load factor [1]", record.controlled->first);
        row.emplace_back("opening [m]", record.controlled->second);
      }

    for (std::size_t b = 0; b < record.boundaries.size(); ++b)
      {
        const std::string &name   = record.boundaries[b];
        const auto        &values = record.displacements[b];
        for (unsigned int c = 0; c < values.size(); ++c)
          if (c < dim)
            row.emplace_back(name + " u" + std::to_string(c + 1) + " [m]",
                             values[c]);
          else
            row.emplace_back(name + " rotation" +
                               (dim == 2 ? "" :
                                           " " + std::to_string(c - dim + 1)) +
                               " [rad]",
                             values[c]);

        // a boundary without conditions is free: nothing acts on it
        typename Equilibrium::Balance<dim>::Reaction reaction;
        const auto                                   place =
          std::find(record.supported.begin(), record.supported.end(), name);
        if (place != record.supported.end())
          reaction = record.reactions[place - record.supported.begin()];
        for (unsigned int d = 0; d < dim; ++d)
          row.emplace_back(name + " force " + std::to_string(d + 1) + " [N" +
                             per_metre + "]",
                           reaction.force[d]);
        for (unsigned int k = 0; k < reaction.moment.dimension; ++k)
          row.emplace_back(name + " moment" +
                             (dim == 2 ?
                                " [N]" :
                                " " + std::to_string(k + 1) + " [N m]"),
                           reaction.moment[k]);
      }

    for (const auto &plate : record.plates)
      {
        row.emplace_back(plate.name + " contacts [1]", plate.n_contacts);
        row.emplace_back(plate.name + " sliding [1]", plate.n_sliding);
      }

    const auto &residual = record.outcome.residual;
    const auto &report   = residual.sweep.total;
    const Row   rest     = {
            {"external work [J" + per_metre + "]", record.external_work},
            {"stress work [J" + per_metre + "]", record.stress_work},
            {"energy error [1]", energy_error(record)},
            {dim == 2 ? "volume [m2]" : "volume [m3]", record.volume},
            {dim == 2 ? "solid volume [m2]" : "solid volume [m3]", record.solids},
            {"mass [kg" + per_metre + "]", record.mass},
            {"points [1]", static_cast<double>(record.n_points)},
            {"iterations [1]", record.outcome.iterations},
            {"force residual [1]", residual.force / residual.reference},
            {"moment residual [1]", residual.moment / residual.reference},
            {"sweeps [1]", static_cast<double>(record.sweeps)},
            {"factorisations [1]", static_cast<double>(record.factorisations)},
            {"cuts [1]", record.cuts},
            {"floored points [1]", report.floored},
            {"clamped points [1]", report.clamped},
            {"null deviators [1]", report.null_deviator},
            {"substeps [1]", static_cast<double>(report.substeps)},
            {"bands [1]", static_cast<double>(record.n_bands)},
            {"cpu time [s]", record.cpu_seconds}};
    row.insert(row.end(), rest.begin(), rest.end());
    if (record.has_plasticity)
      {
        row.emplace_back("yielding points [1]", report.yielding);
        row.emplace_back("points at the apex [1]", report.at_apex);
        row.emplace_back("unregularised points [1]", report.unregularised);
        row.emplace_back("points without strength [1]",
                         report.without_strength);
      }
    if (record.are_moving)
      {
        row.emplace_back("split points [1]",
                         static_cast<double>(record.n_split));
        row.emplace_back("merged points [1]",
                         static_cast<double>(record.n_merged));
        const auto share = [](const double drift, const double sum) {
          return sum > 0.0 ? drift / sum : 0.0;
        };
        row.emplace_back("volume drift [1]",
                         share(record.drift.volume, record.volume));
        row.emplace_back("solid volume drift [1]",
                         share(record.drift.solids, record.solids));
        row.emplace_back("mass drift [1]",
                         share(record.drift.mass, record.mass));
        row.emplace_back("removed points [1]",
                         static_cast<double>(record.n_removed));
        row.emplace_back("points held by walls [1]",
                         static_cast<double>(record.n_held));
      }

    if (record.grid)
      {
        const Row grid = {
          {"cells [1]", static_cast<double>(record.grid->cells)},
          {"unknowns [1]", static_cast<double>(record.grid->unknowns)},
          {"grid changes [1]", record.grid->n_changes},
          {"imbalance after change [1]", record.grid->imbalance},
          {"force jump at change [N" + per_metre + "]",
           record.grid->force_jump},
          {"stress change at change [1]", record.grid->stress_change}};
        row.insert(row.end(), grid.begin(), grid.end());
      }
    return row;
  }



  Row
  bands_row(const unsigned int          step,
            const double                load,
            const Analysis::ShearBands &bands,
            const BandAngles           &angles,
            const double                grain_size)
  {
    Row        row        = {{"step [1]", step},
                             {"load [1]", load},
                             {"bands [1]", static_cast<double>(bands.bands.size())}};
    const auto add_widths = [&](const std::string         &name,
                                const Analysis::Thickness &thickness) {
      row.emplace_back(name + " at 50 % [mm]", 1e3 * thickness.at_50);
      row.emplace_back(name + " at 10 % [mm]", 1e3 * thickness.at_10);
      row.emplace_back(name + " at 50 % [d50]", thickness.at_50 / grain_size);
      row.emplace_back(name + " at 10 % [d50]", thickness.at_10 / grain_size);
    };
    add_widths("thickness", bands.thickness);
    const Row middle = {{"inclination [deg]", bands.inclination},
                        {"spacing [mm]", 1e3 * bands.spacing},
                        {"spacing [d50]", bands.spacing / grain_size},
                        {"void ratio inside [1]", bands.void_ratio},
                        {"void ratio outside [1]", bands.void_ratio_outside},
                        {"largest rotation [rad]", bands.largest_rotation},
                        {"reflections [1]", bands.n_reflections}};
    row.insert(row.end(), middle.begin(), middle.end());
    add_widths("thickness of shear strain", bands.shear_thickness);
    add_widths("thickness of void ratio", bands.void_ratio_thickness);
    row.emplace_back("shear strain inside [1]", bands.shear_strain);
    row.emplace_back("shear strain outside [1]", bands.shear_strain_outside);
    row.emplace_back("angle to minor stress [deg]", angles.to_minor_stress);
    for (const auto &[place, mobilised] :
         {std::make_pair("at peak", angles.at_peak),
          std::make_pair("inside", angles.inside)})
      {
        const std::string end = std::string(" ") + place + " [deg]";
        row.emplace_back("friction" + end, mobilised.friction);
        row.emplace_back("dilatancy" + end, mobilised.dilatancy);
        row.emplace_back("Coulomb angle" + end, coulomb_angle(mobilised));
        row.emplace_back("Roscoe angle" + end, roscoe_angle(mobilised));
        row.emplace_back("Arthur angle" + end, arthur_angle(mobilised));
      }
    return row;
  }



  template struct StepRecord<2>;
  template void
  sum_up_points(const Points::MaterialPoints<2> &,
                const MPI_Comm,
                StepRecord<2> &);
  template void
  add_plates(const std::vector<Equilibrium::Plates<2>::Report> &,
             StepRecord<2> &);
  template double
  energy_error(const StepRecord<2> &);
  template Row
  history_row(const StepRecord<2> &);
  template struct StepRecord<3>;
  template void
  sum_up_points(const Points::MaterialPoints<3> &,
                const MPI_Comm,
                StepRecord<3> &);
  template void
  add_plates(const std::vector<Equilibrium::Plates<3>::Report> &,
             StepRecord<3> &);
  template double
  energy_error(const StepRecord<3> &);
  template Row
  history_row(const StepRecord<3> &);
} // namespace Riedel::Output
