// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/material/law.h>

#include <deal.II/base/parameter_handler.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace LawTools
{
  using namespace Riedel;

  using Settings = std::map<std::string, std::string>;

  /// A law with the constants of Karlsruhe sand, or a soft elastic body.
  template <int dim = 2>
  std::unique_ptr<Material::Law<dim>>
  make_law(const std::string &name, const Settings &changes = {})
  {
    std::unique_ptr<Material::Law<dim>> law = Material::create_law<dim>(name);
    dealii::ParameterHandler            prm;
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
        if (name == "polar hypoplastic")
          prm.set("Mean grain diameter", "0.5e-3");
      }
    else if (name == "Hencky")
      {
        prm.set("Young modulus", "1000");
        prm.set("Poisson ratio", "0.25");
      }
    else
      {
        prm.set("Lame modulus", "1000");
        prm.set("Shear modulus", "2000");
        if (name.find("micropolar") != std::string::npos)
          {
            prm.set("Couple modulus", "500");
            prm.set("Bending modulus", "40");
          }
        if (name.find("Drucker-Prager") == 0)
          {
            prm.set("Friction angle", "30");
            prm.set("Dilatancy angle", "10");
            prm.set("Cohesion", "20");
          }
        if (name.find("von Mises") == 0)
          prm.set("Yield stress", "50");
      }
    for (const auto &[entry, value] : changes)
      prm.set(entry, value);
    law->parse(prm);
    return law;
  }



  /// Trial state, stresses and tangent of one point.
  struct Answer
  {
    std::vector<double> state;
    std::vector<double> stresses;
    std::vector<double> tangent;
    Material::Report    report;
  };

  template <int dim>
  Answer
  respond(const Material::Law<dim>  &law,
          const std::vector<double> &state,
          const std::vector<double> &increments,
          const bool                 with_tangent = false)
  {
    const unsigned int n = law.n_generalised();
    REQUIRE(increments.size() == n);
    Answer answer;
    answer.state.resize(law.layout().size());
    answer.stresses.resize(n);
    if (with_tangent)
      answer.tangent.resize(n * n);
    answer.report =
      law.respond({1,
                   increments.data(),
                   state.data(),
                   answer.state.data(),
                   answer.stresses.data(),
                   with_tangent ? answer.tangent.data() : nullptr});
    return answer;
  }



  inline bool
  is_finite(const Answer &answer)
  {
    const auto finite = [](const std::vector<double> &values) {
      return std::all_of(values.begin(), values.end(), [](const double x) {
        return std::isfinite(x);
      });
    };
    return finite(answer.state) && finite(answer.stresses) &&
           finite(answer.tangent);
  }



  /// Increments of a rigid rotation [rad].
  inline std::vector<double>
  rotation(const double angle, const unsigned int n)
  {
    std::vector<double> increments(n, 0.);
    const double        s = std::sin(angle);
    const double        c = -2. * std::pow(std::sin(angle / 2), 2);
    increments[0]         = c;
    increments[1]         = -s;
    increments[2]         = s;
    increments[3]         = c;
    if (n == 7)
      increments[4] = angle;
    return increments;
  }



  /// State with stresses 11, 22, 33, 12, 21 [Pa], couple stresses [N/m].
  inline std::vector<double>
  make_state(const Material::Law<2>    &law,
             const std::vector<double> &stress,
             const std::vector<double> &couple_stress,
             const double               void_ratio)
  {
    std::vector<double>    state(law.layout().size());
    Material::InitialState initial;
    initial.void_ratio = void_ratio;
    law.initialise(initial, state.data());
    const unsigned int s = law.layout().find("stress");
    std::copy(stress.begin(), stress.end(), state.begin() + s);
    if (law.is_micropolar())
      {
        const unsigned int m = law.layout().find("couple_stress");
        std::copy(couple_stress.begin(),
                  couple_stress.end(),
                  state.begin() + m);
      }
    return state;
  }



  /// A file of comma separated values with one header line and # comments.
  struct Table
  {
    std::vector<std::string>              columns;
    std::vector<std::vector<std::string>> rows;

    explicit Table(const std::string &name)
    {
      std::ifstream file(std::string(RIEDEL_TEST_DIR) + "/reference/" + name);
      INFO("reference file " << name);
      REQUIRE(file.good());
      for (std::string line; std::getline(file, line);)
        {
          if (line.empty() || line[0] == '#')
            continue;
          std::vector<std::string> words;
          std::istringstream       stream(line);
          for (std::string word; std::getline(stream, word, ',');)
            words.push_back(word);
          if (columns.empty())
            columns = words;
          else
            rows.push_back(words);
        }
      REQUIRE(rows.size() > 0);
    }

    std::string
    text(const unsigned int row, const std::string &column) const
    {
      for (unsigned int c = 0; c < columns.size(); ++c)
        if (columns[c] == column)
          return rows[row].at(c);
      FAIL("no column " << column);
      return "";
    }

    double
    number(const unsigned int row, const std::string &column) const
    {
      return std::stod(text(row, column));
    }
  };
} // namespace LawTools
