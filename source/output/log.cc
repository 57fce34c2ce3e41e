// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/output/log.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>

#include <unistd.h>

namespace Riedel::Output
{
  Log::Log(const std::string &path,
           const bool         speaks,
           const bool         may_draw,
           const bool         append)
    : speaks(speaks)
    , interactive(speaks && may_draw && isatty(STDOUT_FILENO) == 1)
  {
    if (speaks)
      file.open(path, append ? std::ios::app : std::ios::out);
  }



  void
  Log::line(const std::string &text)
  {
    if (!speaks)
      return;
    clear_progress();
    std::cout << text << std::endl;
    file << text << std::endl;
  }



  void
  Log::progress(const double fraction, const double seconds)
  {
    if (!interactive)
      return;
    constexpr unsigned int width  = 40;
    const auto             filled = static_cast<unsigned int>(fraction * width);
    clear_progress();
    std::cout << '[' << std::string(filled, '=')
              << std::string(width - std::min(filled, width), ' ') << "] "
              << static_cast<int>(100.0 * fraction) << " %";
    if (fraction > 0.0)
      std::cout << ", about " << duration(seconds * (1.0 - fraction) / fraction)
                << " left";
    std::cout << std::flush;
    bar_is_drawn = true;
  }



  void
  Log::clear_progress()
  {
    if (bar_is_drawn)
      std::cout << "\r\033[K" << std::flush;
    bar_is_drawn = false;
  }



  std::string
  duration(const double seconds)
  {
    const auto whole = static_cast<long>(std::lround(seconds));
    char       text[32];
    if (whole < 60)
      std::snprintf(text, sizeof text, "%ld s", whole);
    else if (whole < 3600)
      std::snprintf(text, sizeof text, "%ld:%02ld", whole / 60, whole % 60);
    else
      std::snprintf(text,
                    sizeof text,
                    "%ld:%02ld:%02ld",
                    whole / 3600,
                    whole / 60 % 60,
                    whole % 60);
    return text;
  }
} // namespace Riedel::Output
