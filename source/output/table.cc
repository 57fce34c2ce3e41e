// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/output/table.h>

#include <cmath>

namespace Riedel::Output
{
  Table::Table(const std::string &path, const bool writes)
    : writes(writes)
  {
    if (writes)
      file.open(path);
    // enough to compare runs at rounding level
    file.precision(12);
  }



  void
  Table::add(const std::vector<std::pair<std::string, double>> &row)
  {
    if (!writes)
      return;
    if (!has_header)
      for (std::size_t i = 0; i < row.size(); ++i)
        file << row[i].first << (i + 1 < row.size() ? "," : "\n");
    has_header = true;
    for (std::size_t i = 0; i < row.size(); ++i)
      {
        if (std::isnan(row[i].second))
          file << "nan";
        else
          file << row[i].second;
        file << (i + 1 < row.size() ? "," : "\n");
      }
    file.flush();
  }
} // namespace Riedel::Output
