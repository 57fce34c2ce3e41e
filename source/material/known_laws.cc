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
    struct KnownLaw
    {
      std::string                              name;
      std::function<std::unique_ptr<Law<2>>()> create;
    };

    /// A new law is one line here.
    const std::vector<KnownLaw> &
    plane_strain_laws()
    {
      static const std::vector<KnownLaw> laws = {
        {"polar hypoplastic", std::make_unique<PolarHypoplastic>},
        {"hypoplastic", std::make_unique<ClassicalHypoplastic>},
        {"linear elastic micropolar",
         std::make_unique<LinearElasticMicropolar>},
        {"linear elastic", std::make_unique<LinearElasticClassical>},
        {"Hencky", std::make_unique<Hencky>},
        {"neo-Hookean micropolar", std::make_unique<NeoHookean<true>>},
        {"neo-Hookean", std::make_unique<NeoHookean<false>>},
        {"Drucker-Prager micropolar", std::make_unique<DruckerPrager<true>>},
        {"Drucker-Prager", std::make_unique<DruckerPrager<false>>},
        {"von Mises micropolar", std::make_unique<VonMises<true>>},
        {"von Mises", std::make_unique<VonMises<false>>}};
      return laws;
    }
  } // namespace



  std::vector<std::string>
  known_laws()
  {
    std::vector<std::string> names;
    for (const KnownLaw &law : plane_strain_laws())
      names.push_back(law.name);
    return names;
  }



  template <>
  std::unique_ptr<Law<2>>
  create_law<2>(const std::string &name)
  {
    for (const KnownLaw &law : plane_strain_laws())
      if (law.name == name)
        return law.create();
    throw std::out_of_range("there is no law '" + name + "'");
  }
} // namespace Riedel::Material
