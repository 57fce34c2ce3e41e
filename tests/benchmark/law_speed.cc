// SPDX-License-Identifier: LGPL-2.1-or-later

// Microseconds per material point of every law, for stresses alone and with
// the tangent: random admissible states, increments as in a finite element
// step, median of repeats. "turned": the increment is in a new direction, so
// that the response bends strongly within the step; "continued": the same
// isochoric increment has been taken ten times before; "yielding": the share of
// points on the yield surface.

#include <riedel/continuum/generalised.h>
#include <riedel/material/law.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <random>
#include <vector>

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

  template <int dim>
  void
  measure_laws()
  {
    using Order                      = Riedel::Continuum::Generalised<dim>;
    constexpr unsigned int n_points  = 2000;
    constexpr unsigned int n_repeats = 51;

    std::printf("%s\n", dim == 2 ? "plane strain" : "space");
    std::printf("%-26s %-10s %9s %12s %12s %10s %10s\n",
                "law",
                "loading",
                "increment",
                "value [us]",
                "tangent [us]",
                "substeps",
                "yielding");
    for (const std::string &name : Riedel::Material::known_laws<dim>())
      for (const bool continued : {false, true})
        for (const double size : {1e-4, 3e-4, 1e-3})
          {
            const std::unique_ptr<Law<dim>> law     = make_law<dim>(name);
            const unsigned int              n       = law->n_generalised();
            const unsigned int              n_state = law->layout().size();

            std::mt19937                     generator(1);
            std::uniform_real_distribution<> uniform(-1., 1.);
            std::vector<double>              increments(n_points * n);
            std::vector<double>              committed(n_points * n_state);
            std::vector<double>              trial(committed.size());
            std::vector<double>              stresses(increments.size());
            std::vector<double>              tangents(increments.size() * n);
            for (unsigned int p = 0; p < n_points; ++p)
              {
                const double pressure = 2e5 + 1e5 * uniform(generator);
                Riedel::Material::InitialState initial;
                for (unsigned int i = 0; i < 3; ++i)
                  initial.stress[i][i] =
                    -pressure * (1. + .3 * uniform(generator));
                initial.stress[0][1] = .2 * pressure * uniform(generator);
                initial.void_ratio   = .7 + .12 * uniform(generator);
                law->initialise(initial, committed.data() + p * n_state);
                for (unsigned int i = 0; i < n; ++i)
                  increments[p * n + i] =
                    (i < Order::spin(0) + Order::n_spin ? size :
                                                          size / .5e-3 * .2) *
                    uniform(generator);
                if (continued)
                  for (unsigned int d = 1; d < dim; ++d)
                    increments[p * n + Order::gradient(d, d)] =
                      d == 1 ? -increments[p * n] : 0.;
              }
            for (unsigned int step = 0; continued && step < 10; ++step)
              {
                law->respond({n_points,
                              increments.data(),
                              committed.data(),
                              trial.data(),
                              stresses.data(),
                              nullptr});
                committed = trial;
              }

            const auto measure = [&](double *tangent_store) {
              const Batch         batch{n_points,
                                increments.data(),
                                committed.data(),
                                trial.data(),
                                stresses.data(),
                                tangent_store};
              std::vector<double> times;
              Report              report;
              for (unsigned int r = 0; r < n_repeats; ++r)
                {
                  const auto begin = std::chrono::steady_clock::now();
                  report           = law->respond(batch);
                  const auto end   = std::chrono::steady_clock::now();
                  times.push_back(
                    std::chrono::duration<double, std::micro>(end - begin)
                      .count());
                }
              std::nth_element(times.begin(),
                               times.begin() + n_repeats / 2,
                               times.end());
              return std::make_pair(times[n_repeats / 2] / n_points, report);
            };
            const auto value   = measure(nullptr);
            const auto tangent = measure(tangents.data());
            std::printf("%-26s %-10s %9.0e %12.3f %12.3f %10.2f %10.2f\n",
                        name.c_str(),
                        continued ? "continued" : "turned",
                        size,
                        value.first,
                        tangent.first,
                        double(value.second.substeps) / n_points,
                        double(value.second.yielding) / n_points);
          }
  }
} // namespace

int
main()
{
  measure_laws<2>();
  measure_laws<3>();
}
