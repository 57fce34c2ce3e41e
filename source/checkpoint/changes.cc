// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/checkpoint/changes.h>

#include <algorithm>
#include <cstdlib>
#include <map>

namespace Riedel::Checkpoint
{
  namespace
  {
    /// Parameters and, with a slash at the end, sections that may change.
    const std::vector<std::string> free_parameters = {
      "Title",
      "Results",
      "Loading/Stop",
      "Loading/Initial step",
      "Loading/Largest step",
      "Loading/Smallest step",
      "Loading/Fixed steps",
      "Material points/Leaving points",
      "Material points/Merge above points per cell",
      "Material points/Merge tolerance",
      "Solver/",
      "Output/",
      "Checkpoint/",
      "Element test/"};



    /// Words and separators of a value; blanks only separate.
    std::vector<std::string>
    words(const std::string &value)
    {
      const std::string        separators = ",:;()";
      std::vector<std::string> result(1);
      for (const char c : value)
        if (c == ' ' || c == '\t')
          result.emplace_back();
        else if (separators.find(c) != std::string::npos)
          {
            result.emplace_back(1, c);
            result.emplace_back();
          }
        else
          result.back() += c;
      result.erase(std::remove(result.begin(), result.end(), std::string()),
                   result.end());
      return result;
    }



    bool
    same_word(const std::string &a, const std::string &b)
    {
      if (a == b)
        return true;
      char        *end_a = nullptr, *end_b = nullptr;
      const double x = std::strtod(a.c_str(), &end_a);
      const double y = std::strtod(b.c_str(), &end_b);
      return end_a != a.c_str() && *end_a == '\0' && end_b != b.c_str() &&
             *end_b == '\0' && x == y;
    }



    bool
    same_value(const std::string &a, const std::string &b)
    {
      const auto in_a = words(a), in_b = words(b);
      return std::equal(
        in_a.begin(), in_a.end(), in_b.begin(), in_b.end(), same_word);
    }



    std::string
    quoted(const std::string &value)
    {
      return value.empty() ? "nothing" : "\"" + value + "\"";
    }
  } // namespace



  bool
  may_change(const std::string &path)
  {
    return std::any_of(free_parameters.begin(),
                       free_parameters.end(),
                       [&path](const std::string &free) {
                         return free.back() == '/' ? path.rfind(free, 0) == 0 :
                                                     path == free;
                       });
  }



  std::vector<std::string>
  forbidden_changes(
    const std::vector<std::pair<std::string, std::string>> &saved,
    const std::vector<Setting>                             &present)
  {
    std::map<std::string, std::string> old(saved.begin(), saved.end());
    std::vector<std::string>           changes;
    for (const Setting &setting : present)
      {
        const auto before = old.find(setting.path);
        // a parameter that the older version did not have yet
        const std::string value =
          before != old.end() ? before->second : setting.default_value;
        if (!may_change(setting.path) && !same_value(value, setting.value))
          changes.push_back(setting.path + ": " + quoted(value) +
                            " in the checkpoint, " + quoted(setting.value) +
                            " now");
        if (before != old.end())
          old.erase(before);
      }
    for (const auto &[path, value] : old)
      if (!may_change(path))
        changes.push_back(path + ": " + quoted(value) +
                          " in the checkpoint, not there now");
    return changes;
  }
} // namespace Riedel::Checkpoint
