// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/output/table.h>

#include <cmath>
#include <filesystem>

namespace Riedel::Output
{
  Table::Table(const std::string &path, const bool writes, const bool append)
    : path(path)
    , writes(writes)
  {
    if (writes)
      file.open(path, append ? std::ios::app : std::ios::out);
    // enough to compare runs at rounding level
    file.precision(12);
  }



  void
  Table::add(const std::vector<std::pair<std::string, double>> &row)
  {
    if (!writes)
      return;
    if (n_rows == 0)
      for (std::size_t i = 0; i < row.size(); ++i)
        file << row[i].first << (i + 1 < row.size() ? "," : "\n");
    ++n_rows;
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



  bool
  Table::resume()
  {
    if (!writes)
      return true;
    // the header and the rows up to here, each a complete line
    std::ifstream  present(path);
    std::string    line;
    std::uint64_t  n_lines = 0;
    std::uintmax_t length  = 0;
    const auto     wanted  = (n_rows == 0 ? 0 : n_rows + 1);
    while (n_lines < wanted && std::getline(present, line) && !present.eof())
      {
        length = static_cast<std::uintmax_t>(present.tellg());
        ++n_lines;
      }
    std::filesystem::resize_file(path, length);
    const bool complete = n_lines == wanted;
    n_rows              = n_lines == 0 ? 0 : n_lines - 1;
    return complete;
  }
} // namespace Riedel::Output
