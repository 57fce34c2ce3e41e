// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
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
    /// @p writes: this rank is the one that writes; @p append: the file of an
    /// earlier run goes on, see resume().
    Table(const std::string &path, const bool writes, const bool append);

    /// A row: names (with units) and values, the same names in every row.
    void
    add(const std::vector<std::pair<std::string, double>> &row);

    const std::string &
    file_name() const
    {
      return path;
    }

    /// The state of a run: the number of rows.
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &n_rows;
    }

    /// Removes the rows of the file behind those of the state. Returns false if
    /// it has fewer.
    bool
    resume();

  private:
    const std::string path;
    const bool        writes;
    std::ofstream     file;
    std::uint64_t     n_rows = 0;
  };
} // namespace Riedel::Output
