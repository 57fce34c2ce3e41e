// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/box.h>
#include <riedel/material/parameters.h>
#include <riedel/pattern.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <string>
#include <vector>

namespace Riedel::Material
{
  namespace
  {
    template <int dim>
    bool
    is_known(const std::string &law)
    {
      const std::vector<std::string> laws = known_laws<dim>();
      return std::find(laws.begin(), laws.end(), law) != laws.end();
    }



    template <int dim>
    std::string
    list_of_laws(const std::string &separator)
    {
      std::string list;
      for (const std::string &law : known_laws<dim>())
        list += (list.empty() ? "" : separator) + law;
      return list;
    }
  } // namespace



  template <int dim>
  void
  Parameters<dim>::declare(
    dealii::ParameterHandler                               &prm,
    const std::vector<std::pair<std::string, std::string>> &names)
  {
    prm.enter_subsection("Materials");
    for (const auto &[name, law] : names)
      {
        prm.enter_subsection(name);
        prm.declare_entry("Law",
                          known_laws<dim>().front(),
                          dealii::Patterns::Selection(list_of_laws<dim>("|")),
                          "The constitutive law. It decides which other "
                          "parameters this section has.",
                          true);
        prm.declare_entry("Box",
                          "",
                          FormPattern(box_form<dim>() + ", or nothing"),
                          "The part of the body that is of this material: its "
                          "lower left and upper right corner [m]. Empty: the "
                          "whole body. Where several materials claim a point, "
                          "the one named last gets it.");
        if (is_known<dim>(law))
          create_law<dim>(law)->declare(prm);
        prm.leave_subsection();
      }
    prm.leave_subsection();
  }



  template <int dim>
  void
  Parameters<dim>::parse(
    dealii::ParameterHandler                               &prm,
    const std::vector<std::pair<std::string, std::string>> &names)
  {
    materials.clear();
    prm.enter_subsection("Materials");
    for (const auto &[name, law] : names)
      {
        if (!is_known<dim>(law))
          throw ParameterError("Materials/" + name + "/Law",
                               "There is no law \"" + law + "\". Known laws: " +
                                 list_of_laws<dim>(", ") + ".");
        prm.enter_subsection(name);
        Entry entry;
        entry.name = name;
        entry.law  = create_law<dim>(law);
        entry.law->parse(prm);

        const std::string box = prm.get("Box");
        entry.everywhere      = box.empty();
        if (!entry.everywhere)
          entry.box = read_box<dim>(box, "Materials/" + name + "/Box");
        prm.leave_subsection();
        materials.push_back(entry);
      }
    prm.leave_subsection();
  }



  template <int dim>
  void
  Parameters<dim>::check(Problems &problems) const
  {
    if (materials.empty())
      {
        problems.error("Materials",
                       "No material is given. Add a subsection with a name of "
                       "your own and its \"Law\".");
        return;
      }

    for (const Entry &entry : materials)
      {
        const std::string path = "Materials/" + entry.name;
        entry.law->check(path, problems);

        const Entry &first = materials.front();
        if (entry.law->is_micropolar() != first.law->is_micropolar())
          {
            const auto describe_law = [](const Entry &e) {
              return "\"" + e.name + "\" (" + e.law->name() + ") is " +
                     (e.law->is_micropolar() ? "micropolar" : "classical");
            };
            problems.error(path + "/Law",
                           "The laws of a scene must be all micropolar or all "
                           "classical, but " +
                             describe_law(first) + " and " +
                             describe_law(entry) + ".");
          }
        if (entry.law->is_geometrically_linear() !=
            first.law->is_geometrically_linear())
          problems.error(path,
                         "The laws of a scene must be all of small strain or "
                         "all of finite strain, but those of \"" +
                           first.name + "\" and \"" + entry.name +
                           "\" differ.");
      }
  }



  template <int dim>
  bool
  Parameters<dim>::is_micropolar() const
  {
    return std::any_of(materials.begin(),
                       materials.end(),
                       [](const Entry &entry) {
                         return entry.law->is_micropolar();
                       });
  }



  template <int dim>
  int
  Parameters<dim>::material_at(const dealii::Point<dim> &x) const
  {
    for (std::size_t i = materials.size(); i-- > 0;)
      if (materials[i].everywhere || materials[i].box.point_inside(x))
        return static_cast<int>(i);
    return -1;
  }



  template struct Parameters<2>;
  template struct Parameters<3>;
} // namespace Riedel::Material
