// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/output/log.h>
#include <riedel/output/report.h>
#include <riedel/version.h>

#include <deal.II/base/config.h>
#include <deal.II/base/mpi.h>

#include <cmath>
#include <cstdarg>
#include <cstdio>

#include <sys/resource.h>

namespace Riedel::Output
{
  namespace
  {
    /// printf into a string.
    std::string
    format(const char *pattern, ...)
    {
      char         text[256];
      std::va_list arguments;
      va_start(arguments, pattern);
      std::vsnprintf(text, sizeof text, pattern, arguments);
      va_end(arguments);
      return text;
    }



    /// Peak memory of this process [bytes].
    double
    peak_memory()
    {
      rusage usage;
      getrusage(RUSAGE_SELF, &usage);
      return 1024.0 * static_cast<double>(usage.ru_maxrss);
    }



    std::string
    law_speed(const std::uint64_t points, const double seconds)
    {
      return points == 0 ?
               "not used" :
               format("%.3f us per point", 1e6 * seconds / double(points));
    }
  } // namespace



  std::string
  banner(const std::string &title,
         const std::string &case_file,
         const std::string &folder,
         const MPI_Comm     communicator)
  {
    const unsigned int ranks =
      dealii::Utilities::MPI::n_mpi_processes(communicator);
    std::string text =
      "Riedel " RIEDEL_VERSION ": shear bands in granular bodies (deal.II " +
      std::string(DEAL_II_PACKAGE_VERSION) + ", " + std::to_string(ranks) +
      (ranks == 1 ? " rank)" : " ranks)");
    if (!title.empty())
      text += "\n" + title;
    return text + "\ncase " + case_file + ", results in " + folder + "\n";
  }



  std::string
  step_header(const std::string &watched, const unsigned int dim)
  {
    return (watched.empty() ? std::string() :
                              "P1 is the " + watched + " of the body.\n") +
           "  step      load   " + (dim == 2 ? "P1 [kN/m]" : "  P1 [kN]") +
           "  its  forces  moments  floored  bands";
  }



  template <int dim>
  std::string
  step_line(const StepRecord<dim> &record, const double force)
  {
    const auto &residual = record.outcome.residual;
    return format("%6u  %8.5f  %10.4f  %3u  %.0e   %.0e  %7u  %5zu",
                  record.number,
                  record.load,
                  1e-3 * force,
                  record.outcome.iterations,
                  residual.force / residual.reference,
                  residual.moment / residual.reference,
                  residual.sweep.total.floored,
                  record.n_bands);
  }



  std::string
  number(const double value)
  {
    return format("%.6g", value);
  }



  namespace
  {
    /// What the yield surfaces of the points say about the last step.
    template <int dim>
    std::string
    plasticity_lines(const StepRecord<dim> &record)
    {
      const auto &total = record.outcome.residual.sweep.total;
      std::string text =
        format("In the last step %u points yield, %u of them at the apex.\n",
               total.yielding,
               total.at_apex);
      if (total.unregularised > 0)
        text += format("%u soften so steeply that their couple modulus does "
                       "not exceed |mu_ep|: the width of their bands is that "
                       "of the cells.\n",
                       total.unregularised);
      if (total.without_strength > 0)
        text += format("%u have lost their strength, and with it the couple "
                       "stress that gives bands a width.\n",
                       total.without_strength);
      return text;
    }
  } // namespace



  template <int dim>
  std::string
  summary(const StepRecord<dim>                           &record,
          const std::size_t                                floored,
          const std::size_t                                clamped,
          const unsigned int                               stalled,
          const typename Equilibrium::Assembly<dim>::Cost &law_cost,
          const Timer                                     &timer,
          const double                                     wall_seconds,
          const MPI_Comm                                   communicator)
  {
    const auto sum = [&](const double value) {
      return dealii::Utilities::MPI::sum(value, communicator);
    };
    const double value_seconds   = sum(law_cost.value_seconds);
    const double tangent_seconds = sum(law_cost.tangent_seconds);
    const auto   value_points =
      static_cast<std::uint64_t>(sum(double(law_cost.value_points)));
    const auto tangent_points =
      static_cast<std::uint64_t>(sum(double(law_cost.tangent_points)));
    const double cpu    = sum(Timer::cpu_seconds());
    const double memory = sum(peak_memory());

    std::string text;
    text += format("\n%u steps to s = %g; %u cut steps; ",
                   record.number,
                   record.load,
                   record.cuts);
    text += format("%zu times a point was put to the floor pressure, %zu times "
                   "its density was clamped.\n",
                   floored,
                   clamped);
    if (record.has_plasticity)
      text += plasticity_lines(record);
    if (stalled > 0)
      text += format("%u steps were taken at up to 10 times the allowed "
                     "residual, where the iteration stalled.\n",
                     stalled);
    text += format("%llu residual sweeps, %llu factorisations, %g %% error of "
                   "the energy balance.\n",
                   static_cast<unsigned long long>(record.sweeps),
                   static_cast<unsigned long long>(record.factorisations),
                   100.0 * energy_error(record));
    if (record.linear.solutions > 0)
      {
        const auto n = static_cast<double>(record.linear.solutions);
        text += format("%g linear systems by GMRES with multigrid: %.1f "
                       "iterations on average, at most %g, %g systems left "
                       "unfinished.\n",
                       n,
                       static_cast<double>(record.linear.iterations) / n,
                       static_cast<double>(record.linear.most),
                       static_cast<double>(record.linear.unfinished));
      }
    text += "Laws: value " + law_speed(value_points, value_seconds) +
            ", with tangent " + law_speed(tangent_points, tangent_seconds) +
            ". Peak memory " + format("%.0f MB.\n\n", memory / 1e6);

    text += "  Where the time went                 calls    CPU s   share\n";
    double rest = cpu;
    for (const std::string &name : timer.names())
      {
        const double seconds = sum(timer[name].cpu);
        rest -= seconds;
        text += format("  %-32s %8llu %8.2f %6.1f %%\n",
                       name.c_str(),
                       static_cast<unsigned long long>(timer[name].calls),
                       seconds,
                       100.0 * seconds / cpu);
      }
    text += format("  %-32s %8s %8.2f %6.1f %%\n",
                   "everything else",
                   "",
                   rest,
                   100.0 * rest / cpu);
    text += format("  %-32s %8s %8.2f   in %s\n",
                   "total, all ranks",
                   "",
                   cpu,
                   duration(wall_seconds).c_str());
    return text;
  }



  std::string
  bands_line(const Analysis::ShearBands &bands, const double grain_size)
  {
    if (bands.bands.empty())
      return "no shear bands.";
    const bool  is_polar = !std::isnan(bands.thickness.at_50);
    const auto &widths   = is_polar ? bands.thickness : bands.shear_thickness;
    return format(
      "%zu shear bands: thickness %.2f d50 at 50 %% and %.2f d50 at "
      "10 %% of the %s, inclination %.1f deg, void ratio "
      "%.3f inside and %.3f outside.",
      bands.bands.size(),
      widths.at_50 / grain_size,
      widths.at_10 / grain_size,
      is_polar ? "rotation" : "shear strain",
      bands.inclination,
      bands.void_ratio,
      bands.void_ratio_outside);
  }



  template std::string
  step_line(const StepRecord<2> &, const double);
  template std::string
  summary(const StepRecord<2> &,
          const std::size_t,
          const std::size_t,
          const unsigned int,
          const Equilibrium::Assembly<2>::Cost &,
          const Timer &,
          const double,
          const MPI_Comm);
  template std::string
  step_line(const StepRecord<3> &, const double);
  template std::string
  summary(const StepRecord<3> &,
          const std::size_t,
          const std::size_t,
          const unsigned int,
          const Equilibrium::Assembly<3>::Cost &,
          const Timer &,
          const double,
          const MPI_Comm);
} // namespace Riedel::Output
