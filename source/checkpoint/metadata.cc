// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/checkpoint/metadata.h>

#include <boost/crc.hpp>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

namespace Riedel::Checkpoint
{
  namespace
  {
    namespace fs = std::filesystem;

    const std::string file_name = "metadata.txt";
    const std::string last_line = "# end";



    Metadata::File
    examine(const fs::path &path)
    {
      std::ifstream      stream(path, std::ios::binary);
      boost::crc_32_type crc;
      std::vector<char>  block(1 << 20);
      Metadata::File     file;
      file.name = path.filename().string();
      while (stream)
        {
          stream.read(block.data(), block.size());
          crc.process_bytes(block.data(), stream.gcount());
          file.size += stream.gcount();
        }
      file.checksum = crc.checksum();
      return file;
    }
  } // namespace



  void
  Metadata::write(const fs::path &folder)
  {
    files.clear();
    for (const auto &entry : fs::directory_iterator(folder))
      files.push_back(examine(entry.path()));
    std::sort(files.begin(), files.end(), [](const File &a, const File &b) {
      return a.name < b.name;
    });

    std::ofstream stream(folder / file_name);
    stream.precision(17);
    stream << "# A checkpoint of Riedel: \"riedel case.prm --resume\" goes on "
              "from here.\n"
           << "format = " << format << "\nversion = " << version
           << "\nwritten = " << written << "\nstep = " << step
           << "\nload = " << load << "\nranks = " << ranks
           << "\ncells = " << cells << "\npoints = " << points
           << "\n\n# Bytes and checksums (CRC-32) of the files\n";
    for (const File &file : files)
      stream << "file " << file.name << " = " << file.size << ' '
             << file.checksum << '\n';
    stream << "\n# All parameters of the run\n";
    for (const auto &[path, value] : parameters)
      stream << "parameter " << path << " = " << value << '\n';
    stream << last_line << '\n';
    if (!stream.flush())
      throw fs::filesystem_error("write",
                                 folder / file_name,
                                 std::make_error_code(std::errc::io_error));
  }



  Metadata
  Metadata::read(const fs::path &folder)
  {
    std::ifstream stream(folder / file_name);
    if (!stream)
      throw std::runtime_error(file_name + " cannot be opened");

    Metadata                           metadata;
    std::map<std::string, std::string> values;
    std::string                        line;
    bool                               complete = false;
    while (std::getline(stream, line))
      {
        const auto equals = line.find(" = ");
        complete          = line == last_line;
        if (line.empty() || line[0] == '#' || equals == std::string::npos)
          continue;
        const std::string name  = line.substr(0, equals);
        const std::string value = line.substr(equals + 3);
        if (name.rfind("file ", 0) == 0)
          {
            File file;
            file.name = name.substr(5);
            std::istringstream(value) >> file.size >> file.checksum;
            metadata.files.push_back(file);
          }
        else if (name.rfind("parameter ", 0) == 0)
          metadata.parameters.emplace_back(name.substr(10), value);
        else
          values[name] = value;
      }
    if (!complete)
      throw std::runtime_error(file_name + " is not complete");

    const auto take = [&values](const std::string &name, auto &number) {
      if (!(std::istringstream(values[name]) >> number))
        throw std::runtime_error(file_name + " has no " + name);
    };
    take("format", metadata.format);
    metadata.version = values["version"];
    metadata.written = values["written"];
    if (metadata.format != present_format)
      throw std::runtime_error("it was written by Riedel " + metadata.version +
                               " in format " + values["format"] +
                               ", this version reads format " +
                               std::to_string(present_format));
    take("step", metadata.step);
    take("load", metadata.load);
    take("ranks", metadata.ranks);
    take("cells", metadata.cells);
    take("points", metadata.points);

    for (const File &file : metadata.files)
      {
        if (!fs::is_regular_file(folder / file.name))
          throw std::runtime_error("the file " + file.name + " is missing");
        const File found = examine(folder / file.name);
        if (found.size != file.size)
          throw std::runtime_error(
            "the file " + file.name + " has " + std::to_string(found.size) +
            " bytes instead of " + std::to_string(file.size));
        if (found.checksum != file.checksum)
          throw std::runtime_error("the file " + file.name +
                                   " has been changed: its checksum is wrong");
      }
    return metadata;
  }
} // namespace Riedel::Checkpoint
