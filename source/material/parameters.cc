// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/material/parameters.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <string>
#include <vector>

namespace Riedel::Material
{
  namespace
  {
    bool
    is_known(const std::string &law)
    {
      const std::vector<std::string> laws = known_laws();
      return std::find(laws.begin(), laws.end(), law) != laws.end();
    }



    std::string
    list_of_laws(const std::string &separator)
    {
      std::string list;
      for (const std::string &law : known_laws())
        list += (list.empty() ? "" : separator) + law;
      return list;
    }



    /// "x0, y0 : x1, y1"; throws std::exception if it is something else.
    template <int dim>
    std::pair<dealii::Point<dim>, dealii::Point<dim>>
    parse_box(const std::string &text)
    {
      namespace Utilities = dealii::Utilities;
      const std::vector<std::string> corners =
        Utilities::split_string_list(text, ':');
      std::pair<dealii::Point<dim>, dealii::Point<dim>> box;
      if (corners.size() != 2)
        throw std::invalid_argument("a box has two corners");
      for (unsigned int c = 0; c < 2; ++c)
        {
          const std::vector<double> coordinates = Utilities::string_to_double(
            Utilities::split_string_list(corners[c], ','));
          if (coordinates.size() != dim)
            throw std::invalid_argument("a corner has dim coordinates");
          for (unsigned int d = 0; d < dim; ++d)
            (c == 0 ? box.first : box.second)[d] = coordinates[d];
        }
      return box;
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
                          known_laws().front(),
                          dealii::Patterns::Selection(list_of_laws("|")),
                          "The constitutive law. It decides which other "
                          "parameters this section has.",
                          true);
        prm.declare_entry("Box",
                          "",
                          dealii::Patterns::Anything(),
                          "The part of the body that is of this material: two "
                          "opposite corners `x0, y0 : x1, y1', the lower left "
                          "one first. Empty: the whole body. Where several "
                          "materials claim a point, the one named last gets "
                          "it. m.");
        if (is_known(law))
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
        if (!is_known(law))
          throw InputError("Materials/" + name + "/Law is `" + law +
                           "', but it must be one of `" + list_of_laws("', `") +
                           "'.");
        prm.enter_subsection(name);
        Entry entry;
        entry.name = name;
        entry.law  = create_law<dim>(law);
        entry.law->parse(prm);

        const std::string box = prm.get("Box");
        entry.everywhere      = box.empty();
        if (!entry.everywhere)
          try
            {
              // not by the constructor, which asserts what check() reports
              entry.box.get_boundary_points() = parse_box<dim>(box);
            }
          catch (const std::exception &)
            {
              throw InputError("Materials/" + name + "/Box is `" + box +
                               "', but it must be two corners in m, for "
                               "instance `0, 0 : 0.1, 0.05', or empty for the "
                               "whole body.");
            }
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
                       "your own and its `Law'.");
        return;
      }

    for (const Entry &entry : materials)
      {
        const std::string path = "Materials/" + entry.name;
        entry.law->check(path, problems);

        if (!entry.everywhere)
          {
            const auto &corners = entry.box.get_boundary_points();
            for (unsigned int d = 0; d < dim; ++d)
              if (!(corners.first[d] < corners.second[d]))
                {
                  problems.error(path + "/Box",
                                 "The first corner of the box must lie below "
                                 "the second one in every coordinate, but "
                                 "coordinate " +
                                   std::to_string(d + 1) + " is " +
                                   std::to_string(corners.first[d]) + " and " +
                                   std::to_string(corners.second[d]) + " m.");
                  break;
                }
          }

        const Entry &first = materials.front();
        if (entry.law->is_micropolar() != first.law->is_micropolar())
          {
            const auto describe_law = [](const Entry &e) {
              return "`" + e.name + "' (" + e.law->name() + ") is " +
                     (e.law->is_micropolar() ? "micropolar" : "classical");
            };
            problems.error(path + "/Law",
                           "The laws of a scene must be all micropolar or all "
                           "classical, but " +
                             describe_law(first) + " and " +
                             describe_law(entry) + ".");
          }
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
} // namespace Riedel::Material
