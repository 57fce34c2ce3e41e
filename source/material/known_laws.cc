// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/material/drucker_prager.h>
#include <riedel/material/finite_strain_law.h>
#include <riedel/material/hencky.h>
#include <riedel/material/law.h>
#include <riedel/material/linear_elastic_micropolar.h>
#include <riedel/material/polar_hypoplastic.h>

#include <functional>
#include <stdexcept>

namespace Riedel::Material
{
  namespace
  {
    template <int dim>
    struct KnownLaw
    {
      std::string                                name;
      std::function<std::unique_ptr<Law<dim>>()> create;
    };

    /// A new law is one line here, or in laws<2>() if it is one of plane strain
    /// only.
    template <int dim>
    std::vector<KnownLaw<dim>>
    finite_strain_laws()
    {
      return {{"neo-Hookean micropolar",
               std::make_unique<NeoHookean<dim, true>>},
              {"neo-Hookean", std::make_unique<NeoHookean<dim, false>>},
              {"Drucker-Prager micropolar",
               std::make_unique<DruckerPrager<dim, true>>},
              {"Drucker-Prager", std::make_unique<DruckerPrager<dim, false>>},
              {"von Mises micropolar", std::make_unique<VonMises<dim, true>>},
              {"von Mises", std::make_unique<VonMises<dim, false>>}};
    }

    template <int dim>
    const std::vector<KnownLaw<dim>> &
    laws();

    template <>
    const std::vector<KnownLaw<2>> &
    laws<2>()
    {
      static const std::vector<KnownLaw<2>> laws = []() {
        std::vector<KnownLaw<2>> result = {
          {"polar hypoplastic", std::make_unique<PolarHypoplastic>},
          {"hypoplastic", std::make_unique<ClassicalHypoplastic>},
          {"linear elastic micropolar",
           std::make_unique<LinearElasticMicropolar>},
          {"linear elastic", std::make_unique<LinearElasticClassical>},
          {"Hencky", std::make_unique<Hencky>}};
        for (const auto &law : finite_strain_laws<2>())
          result.push_back(law);
        return result;
      }();
      return laws;
    }

    template <>
    const std::vector<KnownLaw<3>> &
    laws<3>()
    {
      static const std::vector<KnownLaw<3>> laws = finite_strain_laws<3>();
      return laws;
    }
  } // namespace



  template <int dim>
  std::vector<std::string>
  known_laws()
  {
    std::vector<std::string> names;
    for (const KnownLaw<dim> &law : laws<dim>())
      names.push_back(law.name);
    return names;
  }



  template <int dim>
  std::unique_ptr<Law<dim>>
  create_law(const std::string &name)
  {
    for (const KnownLaw<dim> &law : laws<dim>())
      if (law.name == name)
        return law.create();
    throw std::out_of_range("there is no law '" + name + "'");
  }



  template std::vector<std::string>
  known_laws<2>();
  template std::vector<std::string>
  known_laws<3>();
  template std::unique_ptr<Law<2>>
  create_law<2>(const std::string &);
  template std::unique_ptr<Law<3>>
  create_law<3>(const std::string &);
} // namespace Riedel::Material
