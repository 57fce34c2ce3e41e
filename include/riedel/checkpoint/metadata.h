// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace Riedel::Checkpoint
{
  /**
   * metadata.txt of a checkpoint, for people and for --resume: what it is the
   * state of, the sizes and checksums of its files, and all parameters of the
   * run.
   */
  struct Metadata
  {
    /// the format of the files; another one cannot be read
    static constexpr unsigned int present_format = 5;

    struct File
    {
      std::string   name;
      std::uint64_t size     = 0; ///< bytes
      std::uint32_t checksum = 0; ///< CRC-32
    };

    unsigned int  format = present_format;
    std::string   version; ///< of Riedel
    std::string   written; ///< local time
    unsigned int  step  = 0;
    double        load  = 0.0;
    unsigned int  ranks = 0;
    std::uint64_t cells = 0, points = 0;

    std::vector<File> files;
    /// paths and values
    std::vector<std::pair<std::string, std::string>> parameters;

    /// Notes the files in @p folder with their sizes and checksums and writes
    /// the file there.
    void
    write(const std::filesystem::path &folder);

    /// Reads it and compares the files with what it says. Throws
    /// std::runtime_error that says in a clause what is wrong.
    static Metadata
    read(const std::filesystem::path &folder);
  };
} // namespace Riedel::Checkpoint
