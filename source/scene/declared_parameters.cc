// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/nearest_name.h>
#include <riedel/scene/declared_parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <algorithm>
#include <map>
#include <regex>
#include <sstream>

namespace Riedel::Scene
{
  namespace
  {
    /// ParameterHandler writes "Void ratio" as "Void_20ratio".
    std::string
    demangle(const std::string &text)
    {
      std::string plain;
      for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] == '_' && i + 2 < text.size())
          {
            plain += static_cast<char>(std::stoi(text.substr(i + 1, 2), 0, 16));
            i += 2;
          }
        else
          plain += text[i];
      return plain;
    }

    void
    collect(const boost::property_tree::ptree &tree,
            const std::string                 &section,
            std::vector<DeclaredParameter>    &parameters)
    {
      for (const auto &[key, node] : tree)
        {
          const std::string path =
            section + (section.empty() ? "" : "/") + demangle(key);
          if (node.get_child_optional("pattern_description"))
            parameters.push_back({path,
                                  node.get<std::string>("value"),
                                  node.get<std::string>("default_value"),
                                  node.get<std::string>("pattern_description"),
                                  node.get<std::string>("documentation")});
          else
            collect(node, path, parameters);
        }
    }
  } // namespace



  std::string
  DeclaredParameter::section() const
  {
    const auto slash = path.rfind('/');
    return slash == std::string::npos ? "" : path.substr(0, slash);
  }



  std::string
  DeclaredParameter::name() const
  {
    const auto slash = path.rfind('/');
    return slash == std::string::npos ? path : path.substr(slash + 1);
  }



  std::vector<DeclaredParameter>
  declared_parameters(const dealii::ParameterHandler &prm)
  {
    // XML is the only output of ParameterHandler that keeps names with dots
    // apart from sections.
    std::stringstream xml;
    prm.print_parameters(xml,
                         dealii::ParameterHandler::XML |
                           dealii::ParameterHandler::KeepDeclarationOrder);
    boost::property_tree::ptree tree;
    boost::property_tree::read_xml(xml, tree);

    std::vector<DeclaredParameter> parameters;
    collect(tree.get_child("ParameterHandler"), "", parameters);
    // A section begins with its own parameters, subsections follow.
    std::vector<DeclaredParameter> sorted;
    std::vector<std::string>       sections;
    for (const DeclaredParameter &parameter : parameters)
      if (std::find(sections.begin(), sections.end(), parameter.section()) ==
          sections.end())
        sections.push_back(parameter.section());
    for (const std::string &section : sections)
      for (const DeclaredParameter &parameter : parameters)
        if (parameter.section() == section)
          sorted.push_back(parameter);
    return sorted;
  }



  std::vector<std::string>
  missing_parameters(const dealii::ParameterHandler &prm)
  {
    std::vector<std::string> paths;
    for (std::string path : prm.get_entries_wrongly_not_set())
      {
        std::replace(path.begin(), path.end(), '.', '/');
        paths.push_back(demangle(path));
      }
    return paths;
  }



  std::vector<std::string>
  choices(const std::string &pattern)
  {
    std::vector<std::string> words;
    const std::string        begin = "[Selection ";
    if (pattern.compare(0, begin.size(), begin) != 0)
      return words;
    std::istringstream list(
      pattern.substr(begin.size(), pattern.rfind(']') - begin.size()));
    for (std::string word; std::getline(list, word, '|');)
      words.push_back(word.substr(0, word.find_last_not_of(' ') + 1));
    return words;
  }



  std::string
  describe_pattern(const std::string &pattern)
  {
    if (const auto words = choices(pattern); !words.empty())
      return (words.size() > 1 ? "one of " : "only ") + enumerate(words);
    if (pattern == "[Bool]")
      return "true or false";
    if (pattern == "[Anything]")
      return "any text";

    std::smatch match;
    if (std::regex_match(
          pattern,
          match,
          std::regex(
            "\\[(Double|Integer)( range)?( (.*)\\.\\.\\.(\\S*).*)?\\]")))
      {
        std::string text = match[1] == "Double" ? "a number" : "a whole number";
        const std::string least = match[4], most = match[5];
        const bool        from =
          !least.empty() && least != "-MAX_DOUBLE" && least != "-2147483648";
        const bool to =
          !most.empty() && most != "MAX_DOUBLE" && most != "2147483647";
        if (from && to)
          return text + " from " + least + " to " + most;
        return text + (from ? " >= " + least : to ? " <= " + most : "");
      }
    if (std::regex_match(pattern,
                         match,
                         std::regex("\\[List of <(.*)> of length "
                                    "(\\d+)\\.\\.\\.(\\d+) \\(inclusive\\)"
                                    "( separated by <(.*)>)?\\]")))
      {
        const std::string least = match[2], most = match[3];
        std::string       item = describe_pattern(match[1]);
        // a list of at most one is something that may be left out
        if (most == "1")
          return item;
        item =
          std::regex_replace(item, std::regex("^an? (.*?)number"), "$1numbers");
        item = std::regex_replace(item, std::regex("^one of "), "of ");
        return (most.size() > 3 ? "any number" :
                least == most   ? least :
                                  (least == "0" ? "up to" : least + " to") +
                                  (" " + most)) +
               " " + item + ", separated by \"" +
               (match[5].length() > 0 ? match[5].str() : ",") + "\"";
      }
    // the form of a FormPattern
    return pattern.size() > 2 ? pattern.substr(1, pattern.size() - 2) : pattern;
  }



  namespace
  {
    /// What a page for people says about a section, by the first names of its
    /// path.
    const std::map<std::string, std::string> introductions = {
      {"", "Parameters outside all sections."},
      {"Geometry", "The body before the first step."},
      {"Grid", "The grid and its shape functions."},
      {"Materials",
       "One subsection per material, with a name of your choice. Its `Law` "
       "decides which other parameters it has."},
      {"Material points",
       "Points that move through the grid: only read in the configuration "
       "current."},
      {"Initial state",
       "The vertical stress is sigma_22 = -(p + gamma_d (h - x_2)) with the "
       "pressure p at the top h of the body and gamma_d = gamma_s / (1 + e), "
       "the horizontal ones are K0 sigma_22."},
      {"Initial state/Zones",
       "One subsection per zone with another void ratio, with a name of your "
       "choice."},
      {"Initial state/Random field",
       "Random void ratios, in square cells. Zones overrule them."},
      {"Boundary conditions",
       "One subsection per boundary, with the name of a boundary of the body. "
       "What is not given is free. Where two boundaries meet and both "
       "prescribe a component, the one named first counts. In space there are "
       "also `Displacement 3` and `Traction 3`, and `Rotation 1` to `Rotation "
       "3` in the place of `Rotation`, likewise for couples: what is prescribed "
       "is the sum of the turns about the fixed axes."},
      {"Plates",
       "One subsection per rigid plate, with a name of your choice: a "
       "rectangular block that pushes the material points of the configuration "
       "current and does not fit the grid."},
      {"Loading",
       "The load parameter s runs from 0 to `Stop` in steps that adapt "
       "themselves."},
      {"Loading/Opening",
       "For `Control = opening`: the displacement between two places that "
       "grows from step to step (theory/solution.md)."},
      {"Solver", "How a step is solved."},
      {"Adaptation",
       "The grid is refined while the body is loaded (adaptation.md)."},
      {"Adaptation/Thresholds",
       "Where a criterion begins to hold. The rates are those of the last "
       "step; a cell has the largest value of its points."},
      {"Adaptation/Regions",
       "For the criterion \"region\": one subsection per part of the body that "
       "is refined before the first step and stays so, with a name of your "
       "choice."},
      {"Output", "What is written into the results folder."},
      {"Element test",
       "The path of one material point, for `Simulation type = element "
       "test`."}};

    std::vector<std::string>
    split(const std::string &path)
    {
      std::vector<std::string> names;
      std::istringstream       stream(path);
      for (std::string name; std::getline(stream, name, '/');)
        names.push_back(name);
      return names;
    }

    std::string
    for_table(const std::string &text)
    {
      return std::regex_replace(text, std::regex("\\|"), "\\|");
    }

    std::string
    as_markdown(const std::vector<DeclaredParameter> &parameters)
    {
      std::string              text    = "# Parameters\n\nWritten by `riedel "
                                         "--print-parameters md`.\n";
      std::string              section = "none";
      std::vector<std::string> introduced;
      for (const DeclaredParameter &parameter : parameters)
        {
          if (parameter.section() != section)
            {
              section = parameter.section();
              // headings of all sections on the way, once
              std::string path;
              auto        names = split(section);
              if (names.empty())
                names = {""};
              for (unsigned int level = 0; level < names.size(); ++level)
                {
                  path += (level == 0 ? "" : "/") + names[level];
                  if (std::find(introduced.begin(), introduced.end(), path) !=
                      introduced.end())
                    continue;
                  introduced.push_back(path);
                  text += "\n" + std::string(level + 2, '#') + " " +
                          (path.empty() ? "General" : path) + "\n";
                  if (const auto found = introductions.find(path);
                      found != introductions.end())
                    text += "\n" + found->second + "\n";
                }
              text += "\n| parameter | value | allowed | meaning |\n"
                      "|---|---|---|---|\n";
            }
          const bool changed = parameter.value != parameter.default_value;
          text +=
            "| `" + parameter.name() + "` | " +
            (parameter.value.empty() ? "" :
                                       "`" + for_table(parameter.value) + "`") +
            (!changed || parameter.default_value.empty() ?
               "" :
               " (default `" + for_table(parameter.default_value) + "`)") +
            " | " + for_table(describe_pattern(parameter.pattern)) + " | " +
            for_table(parameter.documentation) + " |\n";
        }
      return text;
    }

    /// Breaks a text into comment lines.
    std::string
    comment(const std::string &text, const std::string &margin)
    {
      std::istringstream words(text);
      std::string        lines, line, word;
      while (words >> word)
        {
          if (!line.empty() && margin.size() + line.size() + word.size() > 76)
            {
              lines += margin + "#" + line + "\n";
              line.clear();
            }
          line += " " + word;
        }
      return line.empty() ? lines : lines + margin + "#" + line + "\n";
    }

    std::string
    as_prm(const std::vector<DeclaredParameter> &parameters,
           const bool                            with_meaning)
    {
      std::string              text;
      std::vector<std::string> open;
      const auto change_to = [&](const std::vector<std::string> &wanted) {
        std::size_t common = 0;
        while (common < std::min(open.size(), wanted.size()) &&
               open[common] == wanted[common])
          ++common;
        while (open.size() > common)
          {
            open.pop_back();
            text += std::string(2 * open.size(), ' ') + "end\n";
            if (open.empty())
              text += "\n";
          }
        while (open.size() < wanted.size())
          {
            text += std::string(2 * open.size(), ' ') + "subsection " +
                    wanted[open.size()] + "\n";
            open.push_back(wanted[open.size()]);
          }
      };

      for (std::size_t i = 0; i < parameters.size(); ++i)
        {
          const DeclaredParameter &parameter = parameters[i];
          const std::string        section   = parameter.section();
          if (i > 0 && parameters[i - 1].section().empty() && !section.empty())
            text += "\n";
          change_to(split(section));

          std::size_t width = 0;
          for (const DeclaredParameter &other : parameters)
            if (other.section() == section && !with_meaning)
              width = std::max(width, other.name().size());
          std::string name = parameter.name();
          name.resize(std::max(width, name.size()), ' ');
          const std::string margin(2 * open.size(), ' ');
          if (with_meaning)
            text += comment(parameter.documentation + " Allowed: " +
                              describe_pattern(parameter.pattern) + ".",
                            margin);
          text += margin + "set " + name + " =" +
                  (parameter.value.empty() ? "" : " " + parameter.value) + "\n";
        }
      change_to({});
      return text;
    }

    std::string
    quote(const std::string &text)
    {
      std::string quoted = "\"";
      for (const char c : text)
        if (c == '"' || c == '\\')
          quoted += std::string("\\") + c;
        else if (c == '\n')
          quoted += "\\n";
        else if (c == '\t')
          quoted += "\\t";
        else
          quoted += c;
      return quoted + "\"";
    }

    std::string
    as_json(const std::vector<DeclaredParameter> &parameters)
    {
      std::string text = "[";
      for (std::size_t i = 0; i < parameters.size(); ++i)
        {
          const DeclaredParameter &parameter = parameters[i];
          text +=
            std::string(i == 0 ? "" : ",") +
            "\n  {\"path\": " + quote(parameter.path) +
            ",\n   \"value\": " + quote(parameter.value) +
            ",\n   \"default\": " + quote(parameter.default_value) +
            ",\n   \"allowed\": " + quote(describe_pattern(parameter.pattern)) +
            ",\n   \"meaning\": " + quote(parameter.documentation) + "}";
        }
      return text + "\n]\n";
    }
  } // namespace



  std::string
  print(const std::vector<DeclaredParameter> &parameters, const Format format)
  {
    switch (format)
      {
        case Format::markdown:
          return as_markdown(parameters);
        case Format::prm:
          return as_prm(parameters, true);
        case Format::short_prm:
          return as_prm(parameters, false);
        case Format::json:
          return as_json(parameters);
      }
    return "";
  }
} // namespace Riedel::Scene
