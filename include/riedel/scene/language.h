// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/scene/declared_parameters.h>

#include <set>
#include <string>
#include <vector>

namespace Riedel::Scene
{
  /**
   * The sections and parameters that an input file may contain. It explains to
   * users what a name that is not among them could have been.
   */
  class Language
  {
  public:
    /// @p more_sections: sections without parameters of their own
    Language(const std::vector<DeclaredParameter> &parameters,
             const std::vector<std::string>       &more_sections);

    bool
    has_section(const std::string &path) const
    {
      return sections.count(path) > 0;
    }

    /// The parameter of this path, or nullptr.
    const DeclaredParameter *
    find(const std::string &path) const;

    /// A message about a section that does not exist, in a section that does.
    std::string
    explain_section(const std::string &path) const;

    /// A message about a parameter that does not exist, in a section that
    /// does.
    std::string
    explain_parameter(const std::string &path) const;

    /// A message about a value that the parameter's pattern refuses.
    static std::string
    explain_value(const DeclaredParameter &parameter, const std::string &value);

    /// What is allowed and what it means, for the end of a message.
    static std::string
    explain(const DeclaredParameter &parameter);

  private:
    std::vector<std::string>
    parameters_in(const std::string &section) const;

    std::vector<std::string>
    sections_in(const std::string &section) const;

    std::vector<DeclaredParameter> parameters;
    std::set<std::string>          sections;
  };

  /// "Initial state" of "Initial state/K0", "" of "Results"
  std::string
  parent_of(const std::string &path);

  /// "K0" of "Initial state/K0"
  std::string
  name_of(const std::string &path);
} // namespace Riedel::Scene
