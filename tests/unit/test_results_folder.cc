// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/errors.h>
#include <riedel/output/results_folder.h>

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>

using Catch::Contains;
using Riedel::InputError;
using Riedel::Output::Existing;
using Riedel::Output::ResultsFolder;
namespace fs = std::filesystem;

namespace
{
  ResultsFolder
  make(const fs::path &path, const bool overwrite)
  {
    return ResultsFolder(MPI_COMM_WORLD,
                         path.string(),
                         overwrite ? Existing::replace : Existing::refuse,
                         "set A = 1\n",
                         "set A = 2\n");
  }

  std::string
  content(const fs::path &path)
  {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
  }
} // namespace

TEST_CASE("a results folder tells its story and is not lost", "[unit]")
{
  const fs::path base = fs::temp_directory_path() / "riedel_results";
  fs::remove_all(base);
  const fs::path path = base / "deep" / "biaxial";

  const ResultsFolder folder = make(path, false);
  CHECK(folder.path("log.txt") == (path / "log.txt").string());
  CHECK(content(path / "original.prm") == "set A = 1\n");
  CHECK_THAT(content(path / "parameters.prm"),
             Catch::StartsWith("# Riedel ") && Contains("set A = 2\n"));

  std::ofstream(path / "history.csv") << "old";
  CHECK_THROWS_AS(make(path, false), InputError);
  CHECK_THROWS_WITH(make(path, false), Contains("--overwrite"));
  CHECK(fs::exists(path / "history.csv"));

  // only what Riedel writes is replaced
  std::ofstream(path / "notes.odt") << "mine";
  make(path, true);
  CHECK_FALSE(fs::exists(path / "history.csv"));
  CHECK(fs::exists(path / "notes.odt"));
  CHECK(fs::exists(path / "original.prm"));

  // a folder of somebody else
  fs::remove(path / "parameters.prm");
  std::ofstream(path / "thesis.csv") << "mine";
  CHECK_THROWS_WITH(make(path, true), Contains("not overwritten"));
  CHECK(fs::exists(path / "thesis.csv"));

  std::ofstream(base / "file") << "a file";
  CHECK_THROWS_WITH(make(base / "file", true), Contains("is not a folder"));
  CHECK_THROWS_WITH(make(base / "file" / "below", false),
                    Contains("cannot write into"));
  fs::remove_all(base);
}
