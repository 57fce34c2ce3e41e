// SPDX-License-Identifier: LGPL-2.1-or-later

// Time per material point of every law: for one point alone, as a law without
// batches would have it, and in batches, for stresses alone and with the
// tangent. Random admissible states, increments as in a finite element step.
// "turned": the increment is in a new direction, so that the response bends
// strongly within the step; "continued": the same isochoric increment has been
// taken ten times before. Counters: time per point, substeps per point, share
// of points on the yield surface.

#include <riedel/continuum/generalised.h>
#include <riedel/material/law.h>

#include <deal.II/base/parameter_handler.h>

#include <memory>
#include <random>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

namespace
{
  using Riedel::Material::Batch;
  using Riedel::Material::Law;
  using Riedel::Material::Report;

  template <int dim>
  std::unique_ptr<Law<dim>>
  make_law(const std::string &name)
  {
    std::unique_ptr<Law<dim>> law = Riedel::Material::create_law<dim>(name);
    dealii::ParameterHandler  prm;
    law->declare(prm);
    if (name.find("hypoplastic") != std::string::npos)
      {
        prm.set("Critical friction angle", "30");
        prm.set("Granular hardness", "190e6");
        prm.set("Minimum void ratio", "0.51");
        prm.set("Critical void ratio", "0.82");
        prm.set("Maximum void ratio", "1.3");
        prm.set("Density exponent", "0.3");
        prm.set("Hardness exponent", "0.5");
      }
    else if (name == "Hencky")
      {
        prm.set("Young modulus", "52e6");
        prm.set("Poisson ratio", "0.3");
      }
    else
      {
        prm.set("Lame modulus", "30e6");
        prm.set("Shear modulus", "20e6");
      }
    if (name == "polar hypoplastic")
      prm.set("Mean grain diameter", "0.5e-3");
    else if (name.find("micropolar") != std::string::npos)
      {
        prm.set("Couple modulus", "10e6");
        prm.set("Bending modulus", "20");
      }
    if (name.find("Drucker-Prager") == 0)
      {
        prm.set("Friction angle", "30");
        prm.set("Dilatancy angle", "10");
        prm.set("Cohesion", "10e3");
      }
    if (name.find("von Mises") == 0)
      prm.set("Yield stress", "1e5");
    law->parse(prm);
    return law;
  }



  /// A law with points and what they are asked.
  template <int dim>
  struct Points
  {
    using Order = Riedel::Continuum::Generalised<dim>;

    static constexpr unsigned int size = 2000;

    std::unique_ptr<Law<dim>> law;
    unsigned int              n;
    unsigned int              n_state;
    std::vector<double>       increments, committed, trial, stresses, tangents;

    Points(const std::string &name, const bool continued, const double strain)
      : law(make_law<dim>(name))
      , n(law->n_generalised())
      , n_state(law->layout().size())
      , increments(size * n)
      , committed(size * n_state)
      , trial(committed.size())
      , stresses(increments.size())
      , tangents(increments.size() * n)
    {
      std::mt19937                     generator(1);
      std::uniform_real_distribution<> distribution(-1., 1.);
      const auto uniform = [&]() { return distribution(generator); };
      for (unsigned int p = 0; p < size; ++p)
        {
          const double                   pressure = 2e5 + 1e5 * uniform();
          Riedel::Material::InitialState initial;
          for (unsigned int i = 0; i < 3; ++i)
            initial.stress[i][i] = -pressure * (1. + .3 * uniform());
          initial.stress[0][1] = .2 * pressure * uniform();
          initial.void_ratio   = .7 + .12 * uniform();
          law->initialise(initial, committed.data() + p * n_state);
          double *increment = increments.data() + p * n;
          for (unsigned int i = 0; i < n; ++i)
            increment[i] =
              (i < Order::spin(0) + Order::n_spin ? strain :
                                                    strain / .5e-3 * .2) *
              uniform();
          if (continued)
            for (unsigned int d = 1; d < dim; ++d)
              increment[Order::gradient(d, d)] = d == 1 ? -increment[0] : 0.;
        }
      for (unsigned int step = 0; continued && step < 10; ++step)
        {
          respond(0, size, false);
          committed = trial;
        }
    }

    Report
    respond(const unsigned int first,
            const unsigned int n_points,
            const bool         with_tangent)
    {
      return law->respond(
        {n_points,
         increments.data() + first * n,
         committed.data() + first * n_state,
         trial.data() + first * n_state,
         stresses.data() + first * n,
         with_tangent ? tangents.data() + first * n * n : nullptr});
    }
  };



  enum class Asked
  {
    value_alone,
    value,
    tangent
  };

  template <int dim>
  void
  measure(benchmark::State  &state,
          const std::string &name,
          const bool         continued,
          const double       strain,
          const Asked        asked)
  {
    Points<dim>            points(name, continued, strain);
    constexpr unsigned int n_points = Points<dim>::size;
    Report                 report;
    for (auto _ : state)
      {
        report = Report();
        if (asked == Asked::value_alone)
          for (unsigned int p = 0; p < n_points; ++p)
            {
              const Report one = points.respond(p, 1, false);
              report.substeps += one.substeps;
              report.yielding += one.yielding;
            }
        else
          report = points.respond(0, n_points, asked == Asked::tangent);
      }
    using benchmark::Counter;
    state.counters["per_point"] =
      Counter(n_points, Counter::kIsIterationInvariantRate | Counter::kInvert);
    state.counters["substeps"] = double(report.substeps) / n_points;
    state.counters["yielding"] = double(report.yielding) / n_points;
  }



  template <int dim>
  void
  register_laws()
  {
    for (const std::string &name : Riedel::Material::known_laws<dim>())
      for (const bool continued : {false, true})
        for (const std::string strain : {"1e-4", "3e-4", "1e-3"})
          for (const auto &[what, asked] :
               {std::make_pair("value alone", Asked::value_alone),
                std::make_pair("value", Asked::value),
                std::make_pair("tangent", Asked::tangent)})
            benchmark::RegisterBenchmark(
              ((dim == 2 ? "plane strain/" : "space/") + name +
               (continued ? "/continued/" : "/turned/") + strain + "/" + what)
                .c_str(),
              &measure<dim>,
              name,
              continued,
              std::stod(strain),
              asked)
              ->Unit(benchmark::kMicrosecond);
  }
} // namespace

int
main(int argc, char **argv)
{
  register_laws<2>();
  register_laws<3>();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 2;
  benchmark::RunSpecifiedBenchmarks();
}
