// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/nearest_name.h>
#include <riedel/scene/language.h>

#include <algorithm>
#include <regex>

namespace Riedel::Scene
{
  std::string
  parent_of(const std::string &path)
  {
    const auto slash = path.rfind('/');
    return slash == std::string::npos ? "" : path.substr(0, slash);
  }



  std::string
  name_of(const std::string &path)
  {
    const auto slash = path.rfind('/');
    return slash == std::string::npos ? path : path.substr(slash + 1);
  }



  namespace
  {
    bool
    contains(const std::vector<std::string> &names, const std::string &name)
    {
      return std::find(names.begin(), names.end(), name) != names.end();
    }

    /// A hint if a name stands in the wrong section.
    template <typename Paths>
    std::string
    belongs(const std::string &name, const Paths &paths)
    {
      std::vector<std::string> places;
      for (const std::string &path : paths)
        if (name_of(path) == name)
          places.push_back(parent_of(path).empty() ?
                             "outside all sections" :
                             "in section " + parent_of(path));
      if (places.empty() || places.size() > 3)
        return "";
      return "\n\"" + name + "\" belongs " + enumerate(places) + ".";
    }

    /// Frequent slips in a number.
    std::string
    number_hint(const std::string &value, const std::string &pattern)
    {
      if (pattern.find("[Double") == std::string::npos &&
          pattern.find("[Integer") == std::string::npos)
        return "";
      static const std::regex decimal_comma("[-+]?\\d+,\\d+");
      if (std::regex_match(value, decimal_comma) &&
          describe_pattern(pattern).find("separated") == std::string::npos)
        return " Write decimals with a point.";
      static const std::regex with_unit(
        "[-+]?[\\d.]+([eE][-+]?\\d+)?\\s*[A-DF-Za-df-z].*");
      if (std::regex_match(value, with_unit))
        return " Write the number without a unit; a comment may name it.";
      return "";
    }
  } // namespace



  Language::Language(const std::vector<DeclaredParameter> &parameters,
                     const std::vector<std::string>       &more_sections)
    : parameters(parameters)
  {
    sections.insert("");
    const auto add = [this](std::string section) {
      for (; !section.empty(); section = parent_of(section))
        sections.insert(section);
    };
    for (const DeclaredParameter &parameter : parameters)
      add(parameter.section());
    for (const std::string &section : more_sections)
      add(section);
  }



  const DeclaredParameter *
  Language::find(const std::string &path) const
  {
    const auto found =
      std::find_if(parameters.begin(), parameters.end(), [&](const auto &p) {
        return p.path == path;
      });
    return found == parameters.end() ? nullptr : &*found;
  }



  std::vector<std::string>
  Language::parameters_in(const std::string &section) const
  {
    std::vector<std::string> names;
    for (const DeclaredParameter &parameter : parameters)
      if (parameter.section() == section)
        names.push_back(parameter.name());
    return names;
  }



  std::vector<std::string>
  Language::sections_in(const std::string &section) const
  {
    std::vector<std::string> names;
    for (const std::string &path : sections)
      if (!path.empty() && parent_of(path) == section)
        names.push_back(name_of(path));
    return names;
  }



  std::string
  Language::explain_section(const std::string &path) const
  {
    const std::string name   = name_of(path);
    const std::string parent = parent_of(path);
    const std::string where  = parent.empty() ? "" : " in section " + parent;
    const auto        known  = sections_in(parent);

    std::string message = "There is no section \"" + name + "\"" + where + "." +
                          did_you_mean(name, known);
    if (contains(parameters_in(parent), name))
      message += "\nIt is a parameter: \"set " + name + " = ...\".";
    else if (known.empty())
      message += " This section has no subsections.";
    else
      message += "\nSections" + where + ": " + enumerate(known) + ".";
    return message + belongs(name, sections);
  }



  std::string
  Language::explain_parameter(const std::string &path) const
  {
    const std::string name    = name_of(path);
    const std::string section = parent_of(path);
    const std::string where =
      section.empty() ? "outside all sections" : "in section " + section;
    const auto known = parameters_in(section);

    std::string message = "There is no parameter \"" + name + "\" " + where;
    // what a material knows depends on its law
    if (parent_of(section) == "Materials")
      if (const DeclaredParameter *const law = find(section + "/Law"))
        message += " with the law \"" + law->value + "\"";
    message += "." + did_you_mean(name, known);

    if (contains(sections_in(section), name))
      message += "\nIt is a section: \"subsection " + name + "\".";
    if (!known.empty())
      message += "\nParameters " + where + ": " + enumerate(known) + ".";
    else
      message += "\nThis section has subsections only.";

    std::vector<std::string> paths;
    for (const DeclaredParameter &parameter : parameters)
      paths.push_back(parameter.path);
    return message + belongs(name, paths);
  }



  std::string
  Language::explain_value(const DeclaredParameter &parameter,
                          const std::string       &value)
  {
    return "The value \"" + value + "\" is not allowed." +
           did_you_mean(value, choices(parameter.pattern)) +
           number_hint(value, parameter.pattern) + explain(parameter);
  }



  std::string
  Language::explain(const DeclaredParameter &parameter)
  {
    return "\nAllowed: " + describe_pattern(parameter.pattern) +
           ".\nMeaning: " + parameter.documentation;
  }
} // namespace Riedel::Scene
