// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <ctime>
#include <map>
#include <string>
#include <vector>

namespace Riedel
{
  /**
   * Where the time of a run goes: CPU and wall seconds by named section, of
   * this rank.
   */
  class Timer
  {
  public:
    struct Section
    {
      double        cpu   = 0.0;
      double        wall  = 0.0;
      std::uint64_t calls = 0;
    };

    /// Adds the time from its construction to its destruction to a section.
    class Scope
    {
    public:
      Scope(Timer &timer, const std::string &name)
        : section(timer.find(name))
        , cpu_start(cpu_seconds())
        , wall_start(std::chrono::steady_clock::now())
      {}

      Scope(const Scope &) = delete;

      ~Scope()
      {
        section.cpu += cpu_seconds() - cpu_start;
        section.wall += std::chrono::duration<double>(
                          std::chrono::steady_clock::now() - wall_start)
                          .count();
        ++section.calls;
      }

    private:
      Section                                    &section;
      const double                                cpu_start;
      const std::chrono::steady_clock::time_point wall_start;
    };

    /// Sections in the order of their first use.
    const std::vector<std::string> &
    names() const
    {
      return order;
    }

    const Section &
    operator[](const std::string &name) const
    {
      return sections.at(name);
    }

    /// CPU seconds of this process.
    static double
    cpu_seconds()
    {
      return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
    }

  private:
    Section &
    find(const std::string &name)
    {
      const auto [place, is_new] = sections.try_emplace(name);
      if (is_new)
        order.push_back(name);
      return place->second;
    }

    std::map<std::string, Section> sections;
    std::vector<std::string>       order;
  };
} // namespace Riedel
