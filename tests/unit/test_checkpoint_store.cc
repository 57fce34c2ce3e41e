// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/checkpoint/metadata.h>
#include <riedel/checkpoint/store.h>

#include <catch2/catch.hpp>

#include <fstream>
#include <iterator>

using Catch::Contains;
using Riedel::Checkpoint::Metadata;
using Riedel::Checkpoint::Store;
namespace fs = std::filesystem;

using Names = std::vector<std::string>;

namespace
{
  fs::path
  empty_folder(const std::string &name)
  {
    const fs::path path = fs::temp_directory_path() / name;
    fs::remove_all(path);
    fs::create_directories(path);
    return path;
  }

  std::string
  content(const fs::path &path)
  {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  std::string
  write(const Store       &store,
        const unsigned int step,
        const unsigned int keep,
        const std::string &text = "state")
  {
    std::ofstream(store.begin() / "state") << text;
    return store.publish(step, keep);
  }
} // namespace

TEST_CASE("checkpoints rotate behind a marker", "[unit]")
{
  const fs::path results = empty_folder("riedel_store");
  const fs::path folder  = results / "checkpoints";
  const Store    store(results);
  CHECK(store.candidates().empty());
  CHECK_FALSE(fs::exists(folder));

  CHECK(write(store, 5, 2) == "000005");
  CHECK(content(folder / "last") == "000005\n");
  write(store, 10, 2);
  write(store, 15, 2);
  CHECK(store.candidates() == Names{"000015", "000010"});
  CHECK_FALSE(fs::exists(store.path("000005")));
  CHECK_FALSE(fs::exists(folder / "unfinished"));

  // numbers of steps are compared, not texts
  CHECK(write(store, 1000000, 2) == "1000000");
  CHECK(store.candidates() == Names{"1000000", "000015"});

  // fewer are kept than before
  CHECK(write(store, 1000001, 1) == "1000001");
  CHECK(store.candidates() == Names{"1000001"});
  fs::remove_all(results);
}

TEST_CASE("what a killed program leaves does no harm", "[unit]")
{
  const fs::path results = empty_folder("riedel_store_killed");
  const fs::path folder  = results / "checkpoints";
  const Store    store(results);
  write(store, 1, 3);
  write(store, 2, 3);

  // while it was written: the next one begins anew
  std::ofstream(store.begin() / "half") << "half";
  CHECK(store.candidates() == Names{"000002", "000001"});
  CHECK(fs::is_empty(store.begin()));

  // after it was renamed, before it was marked
  fs::rename(folder / "unfinished", folder / "000003");
  CHECK(store.candidates() == Names{"000002", "000001"});
  std::ofstream(folder / "last.new") << "0000";
  store.return_to("000002");
  CHECK_FALSE(fs::exists(folder / "000003"));
  write(store, 3, 3, "new");
  CHECK(content(store.path("000003") / "state") == "new");

  // an older one was resumed
  store.return_to("000001");
  CHECK(store.candidates() == Names{"000001"});
  CHECK(content(folder / "last") == "000001\n");

  // somebody removed the marker
  write(store, 7, 3);
  fs::remove(folder / "last");
  CHECK(store.candidates() == Names{"000007", "000001"});

  // ... or the last one itself: it is missed
  write(store, 9, 3);
  fs::remove_all(store.path("000009"));
  CHECK(store.candidates() == Names{"000009", "000007", "000001"});
  store.return_to("000007");
  CHECK(store.candidates() == Names{"000007", "000001"});

  // other files are not ours
  std::ofstream(folder / "notes.txt") << "mine";
  fs::create_directories(folder / "backup");
  store.clear();
  CHECK(store.candidates().empty());
  CHECK(fs::exists(folder / "notes.txt"));
  CHECK(fs::exists(folder / "backup"));
  fs::remove_all(folder / "backup");
  fs::remove(folder / "notes.txt");
  store.clear();
  CHECK_FALSE(fs::exists(folder));
  fs::remove_all(results);
}

TEST_CASE("metadata know a damaged checkpoint", "[unit]")
{
  const fs::path folder = empty_folder("riedel_metadata");
  std::ofstream(folder / "state") << "some bytes";
  Metadata metadata;
  metadata.version    = "1.2.3";
  metadata.written    = "2030-01-31 12:00:00";
  metadata.step       = 120;
  metadata.load       = 0.1 + 0.2;
  metadata.ranks      = 3;
  metadata.cells      = 200;
  metadata.points     = 1800;
  metadata.parameters = {{"Title", ""}, {"Materials/a/Law", "some = thing"}};
  metadata.write(folder);

  const Metadata read = Metadata::read(folder);
  CHECK(read.version == "1.2.3");
  CHECK(read.written == "2030-01-31 12:00:00");
  CHECK(read.step == 120);
  CHECK(read.load == 0.1 + 0.2);
  CHECK(read.ranks == 3);
  CHECK(read.cells == 200);
  CHECK(read.points == 1800);
  CHECK(read.parameters == metadata.parameters);
  REQUIRE(read.files.size() == 1);
  CHECK(read.files[0].size == 10);

  std::ofstream(folder / "state") << "some bites";
  CHECK_THROWS_WITH(Metadata::read(folder), Contains("checksum"));
  std::ofstream(folder / "state") << "some";
  CHECK_THROWS_WITH(Metadata::read(folder),
                    Contains("state has 4 bytes instead of 10"));
  fs::remove(folder / "state");
  CHECK_THROWS_WITH(Metadata::read(folder), Contains("state is missing"));

  std::string text = content(folder / "metadata.txt");
  std::ofstream(folder / "metadata.txt") << text.substr(0, text.size() / 2);
  CHECK_THROWS_WITH(Metadata::read(folder), Contains("not complete"));
  const std::string format =
    "format = " + std::to_string(Metadata::present_format);
  text.replace(text.find(format), format.size(), "format = 9");
  std::ofstream(folder / "metadata.txt") << text;
  CHECK_THROWS_WITH(Metadata::read(folder), Contains("Riedel 1.2.3 in format"));
  fs::remove(folder / "metadata.txt");
  CHECK_THROWS_WITH(Metadata::read(folder), Contains("cannot be opened"));
  fs::remove_all(folder);
}
