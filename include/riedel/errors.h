// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace Riedel
{
  /**
   * The input is wrong: the program ends with exit code 2 and this text, once,
   * also under MPI. The text is complete: place, what was read, what is
   * allowed, what to do.
   */
  class InputError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /**
   * The value of one parameter cannot be used. Thrown by parse() functions,
   * which know the path of the parameter ("Grid/Cells") but not its place in
   * the file: the scene reader adds that.
   */
  class ParameterError : public InputError
  {
  public:
    ParameterError(const std::string &path, const std::string &message)
      : InputError(path + ": " + message)
      , path(path)
      , message(message)
    {}

    const std::string path;    ///< as in Problems::Item
    const std::string message; ///< what was read, what is allowed, what to do
  };

  /**
   * The computation could not go on: exit code 1. Results so far are kept.
   * The text says what failed and where.
   */
  class ComputationError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /**
   * What check() functions find: violated rules and warnings, each with the
   * path of the parameter it concerns ("Materials/sand/Initial state/K0").
   * The scene reader adds file and line of that parameter.
   */
  class Problems
  {
  public:
    struct Item
    {
      std::string path;    ///< sections and parameter, separated by '/'
      std::string message; ///< what was read, what is allowed, what to do
    };

    void
    error(const std::string &path, const std::string &message)
    {
      errors.push_back({path, message});
    }

    void
    warning(const std::string &path, const std::string &message)
    {
      warnings.push_back({path, message});
    }

    std::vector<Item> errors;
    std::vector<Item> warnings;
  };
} // namespace Riedel
