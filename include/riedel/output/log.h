// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <fstream>
#include <string>

namespace Riedel::Output
{
  /**
   * What a run says: every line goes to the terminal and to log.txt; a progress
   * bar with the remaining time to the terminal only, if it is one. Only the
   * rank that speaks (rank 0) writes anything.
   */
  class Log
  {
  public:
    /// @p path of the log file; @p speaks: this rank is the one; @p may_draw:
    /// a progress bar is wanted if the output is a terminal; @p append: the
    /// file goes on.
    Log(const std::string &path,
        const bool         speaks,
        const bool         may_draw,
        const bool         append);

    /// Writes a text and ends the line.
    void
    line(const std::string &text);

    /// Redraws the progress bar: @p fraction of the work is done, @p seconds of
    /// wall time have passed.
    void
    progress(const double fraction, const double seconds);

  private:
    void
    clear_progress();

    const bool    speaks;
    const bool    interactive;
    bool          bar_is_drawn = false;
    std::ofstream file;
  };

  /// "1:02:07", "4:32" or "12 s".
  std::string
  duration(const double seconds);
} // namespace Riedel::Output
