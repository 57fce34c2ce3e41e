// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace Riedel::Output
{
  /**
   * A CSV file that grows row by row, with a header of column names and units
   * ("load [1]"). Rows reach the disk at once, so that an interrupted run keeps
   * what it had.
   */
  class Table
  {
  public:
    /// @p writes: this rank is the one that writes.
    Table(const std::string &path, const bool writes);

    /// A row: names (with units) and values, the same names in every row.
    void
    add(const std::vector<std::pair<std::string, double>> &row);

  private:
    std::ofstream file;
    const bool    writes;
    bool          has_header = false;
  };
} // namespace Riedel::Output
