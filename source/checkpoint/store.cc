// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/checkpoint/store.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iterator>

#include <fcntl.h>
#include <unistd.h>

namespace Riedel::Checkpoint
{
  namespace
  {
    namespace fs = std::filesystem;

    /// Waits until a file or folder has reached the disk.
    void
    sync(const fs::path &path)
    {
      const int file = open(path.c_str(), O_RDONLY);
      // some file systems cannot do it for folders: EINVAL
      const bool good = file >= 0 && (fsync(file) == 0 || errno == EINVAL);
      const int  code = errno;
      if (file >= 0)
        close(file);
      if (!good)
        throw fs::filesystem_error(
          "sync", path, std::error_code(code, std::generic_category()));
    }



    bool
    is_name(const std::string &text)
    {
      return text.size() >= 6 &&
             text.find_first_not_of("0123456789") == std::string::npos;
    }



    /// By the number of the step: longer names are larger numbers.
    bool
    is_newer(const std::string &a, const std::string &b)
    {
      return a.size() != b.size() ? a.size() > b.size() : a > b;
    }



    std::string
    name_of_step(const unsigned int step)
    {
      const std::string number = std::to_string(step);
      return std::string(6 - std::min<std::size_t>(6, number.size()), '0') +
             number;
    }
  } // namespace



  Store::Store(const fs::path &results)
    : folder(results / "checkpoints")
  {}



  fs::path
  Store::path(const std::string &name) const
  {
    return folder / name;
  }



  fs::path
  Store::begin() const
  {
    const fs::path unfinished = folder / "unfinished";
    fs::remove_all(unfinished);
    fs::create_directories(unfinished);
    return unfinished;
  }



  std::string
  Store::publish(const unsigned int step, const unsigned int keep) const
  {
    const fs::path unfinished = folder / "unfinished";
    for (const auto &file : fs::directory_iterator(unfinished))
      sync(file.path());
    sync(unfinished);

    const std::string name = name_of_step(step);
    fs::rename(unfinished, folder / name);
    sync(folder);
    mark(name);

    std::vector<std::string> old = all();
    old.erase(old.begin(), std::find(old.begin(), old.end(), name));
    for (std::size_t i = keep; i < old.size(); ++i)
      remove(old[i]);
    return name;
  }



  std::vector<std::string>
  Store::candidates() const
  {
    std::vector<std::string> names = all();
    const std::string        last  = marked();
    if (last.empty())
      return names;
    // newer than the marker: it was not finished
    names.erase(std::remove_if(names.begin(),
                               names.end(),
                               [&](const std::string &name) {
                                 return is_newer(name, last);
                               }),
                names.end());
    // somebody removed it: whoever reads it will find out
    if (names.empty() || names.front() != last)
      names.insert(names.begin(), last);
    return names;
  }



  void
  Store::return_to(const std::string &name) const
  {
    if (marked() != name)
      mark(name);
    for (const std::string &other : all())
      if (is_newer(other, name))
        remove(other);
  }



  void
  Store::clear() const
  {
    if (!fs::is_directory(folder))
      return;
    fs::remove(folder / "last");
    fs::remove(folder / "last.new");
    for (const std::string &name : all())
      remove(name);
    fs::remove_all(folder / "unfinished");
    if (fs::is_empty(folder))
      fs::remove(folder);
  }



  std::vector<std::string>
  Store::all() const
  {
    std::vector<std::string> names;
    if (fs::is_directory(folder))
      for (const auto &entry : fs::directory_iterator(folder))
        if (entry.is_directory() && is_name(entry.path().filename().string()))
          names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end(), is_newer);
    return names;
  }



  std::string
  Store::marked() const
  {
    std::ifstream file(folder / "last");
    std::string   name;
    file >> name;
    return is_name(name) ? name : std::string();
  }



  void
  Store::mark(const std::string &name) const
  {
    const fs::path fresh = folder / "last.new";
    std::ofstream(fresh) << name << std::endl;
    sync(fresh);
    fs::rename(fresh, folder / "last");
    sync(folder);
  }



  void
  Store::remove(const std::string &name) const
  {
    // never half a checkpoint under a good name
    const fs::path unfinished = folder / "unfinished";
    fs::remove_all(unfinished);
    fs::rename(folder / name, unfinished);
    fs::remove_all(unfinished);
  }
} // namespace Riedel::Checkpoint
