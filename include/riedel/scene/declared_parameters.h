// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Riedel::Scene
{
  /// What a ParameterHandler knows about one parameter.
  struct DeclaredParameter
  {
    std::string path;          ///< sections and parameter, separated by '/'
    std::string value;         ///< present value
    std::string default_value; ///< value if it is not given
    std::string pattern;       ///< deal.II's description of what is allowed
    std::string documentation; ///< meaning and unit

    /// "Initial state" of "Initial state/K0", "" of "Results"
    std::string
    section() const;

    /// "K0" of "Initial state/K0"
    std::string
    name() const;
  };

  /// Everything that is declared, in the order of declaration.
  std::vector<DeclaredParameter>
  declared_parameters(const dealii::ParameterHandler &prm);

  /// Paths of the parameters that must be given and are not.
  std::vector<std::string>
  missing_parameters(const dealii::ParameterHandler &prm);

  /// What is allowed, in words: `a number >= 0`.
  std::string
  describe_pattern(const std::string &pattern);

  /// The words a selection allows; empty if it is not a selection.
  std::vector<std::string>
  choices(const std::string &pattern);

  enum class Format
  {
    markdown,  ///< a page for people
    prm,       ///< an input file, with what the parameters mean
    short_prm, ///< an input file, values only
    json       ///< for other programs
  };

  /// The parameters as a text in one of the formats.
  std::string
  print(const std::vector<DeclaredParameter> &parameters, const Format format);
} // namespace Riedel::Scene
