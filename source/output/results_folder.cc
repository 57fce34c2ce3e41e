// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/checkpoint/store.h>
#include <riedel/errors.h>
#include <riedel/output/results_folder.h>
#include <riedel/version.h>

#include <deal.II/base/mpi.h>

#include <filesystem>
#include <fstream>
#include <set>

namespace Riedel::Output
{
  namespace
  {
    namespace fs = std::filesystem;

    /// The first words of parameters.prm, by which a folder is known again.
    const std::string mark = "# Riedel ";

    bool
    is_ours(const fs::path &folder)
    {
      std::ifstream file(folder / "parameters.prm");
      std::string   line;
      return std::getline(file, line) &&
             line.compare(0, mark.size(), mark) == 0;
    }

    /// Removes the files of an earlier run, except the one by which the folder
    /// is known; whatever a user put beside them stays.
    void
    remove_results(const fs::path &folder)
    {
      const std::set<std::string> types = {
        ".vtu", ".pvtu", ".pvd", ".h5", ".xdmf", ".csv", ".prm"};
      std::vector<fs::path> files;
      for (const auto &file : fs::directory_iterator(folder))
        if (file.is_regular_file() &&
            file.path().filename() != "parameters.prm" &&
            (types.count(file.path().extension().string()) > 0 ||
             file.path().filename() == "log.txt"))
          files.push_back(file.path());
      for (const fs::path &file : files)
        fs::remove(file);
      Checkpoint::Store(folder).clear();
    }

    /// A file of an earlier run is replaced at once or not at all.
    void
    write(const fs::path &path, const std::string &text)
    {
      const fs::path fresh = path.string() + ".new";
      std::ofstream  file(fresh);
      file << text;
      std::error_code code;
      if (file.flush())
        fs::rename(fresh, path, code);
      if (!file || code)
        throw InputError("Cannot write the file \"" + path.string() + "\".");
    }

    void
    create(const fs::path &folder, const bool overwrite)
    {
      const std::string quoted = "\"" + folder.string() + "\"";
      if (fs::exists(folder))
        {
          if (!fs::is_directory(folder))
            throw InputError("Results: " + quoted +
                             " exists and is not a folder. Choose another "
                             "name, for example with --set "
                             "\"Results=name\".");
          if (!overwrite)
            throw InputError("Results: the folder " + quoted +
                             " exists. Run with --overwrite to replace the "
                             "results in it, or choose another one with --set "
                             "\"Results=name\".");
          if (!fs::is_empty(folder) && !is_ours(folder))
            throw InputError("Results: the folder " + quoted +
                             " has no parameters.prm of Riedel in it, so it "
                             "is not overwritten. Remove it yourself, or "
                             "choose another one with --set \"Results=name\".");
          remove_results(folder);
        }
      fs::create_directories(folder);
    }

    void
    check_resumed(const fs::path &folder)
    {
      if (!is_ours(folder))
        throw InputError("Results: there is nothing to resume: \"" +
                         folder.string() +
                         "\" has no results of Riedel. A run begins without "
                         "--resume.");
    }
  } // namespace



  ResultsFolder::ResultsFolder(const MPI_Comm     communicator,
                               const std::string &folder,
                               const Existing     existing,
                               const std::string &original_text,
                               const std::string &effective_text)
    : folder(folder)
    , existing(existing)
    , original_text(original_text)
    , effective_text(effective_text)
  {
    // All ranks must fail together, or those that do not would wait forever.
    std::string error;
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      try
        {
          if (is_resumed())
            check_resumed(folder);
          else
            {
              create(folder, existing == Existing::replace);
              write_inputs();
            }
        }
      catch (const InputError &reason)
        {
          error = reason.what();
        }
      catch (const fs::filesystem_error &reason)
        {
          error = "Results: cannot write into the folder \"" + folder +
                  "\": " + reason.code().message() + ".";
        }
    error = dealii::Utilities::MPI::broadcast(communicator, error, 0);
    if (!error.empty())
      throw InputError(error);
  }



  void
  ResultsFolder::write_inputs() const
  {
    // first the one by which the folder is known
    write(path("parameters.prm"),
          mark + RIEDEL_VERSION + ": all parameters of this run\n\n" +
            effective_text);
    write(path("original.prm"), original_text);
  }



  std::string
  ResultsFolder::path(const std::string &file_name) const
  {
    return (fs::path(folder) / file_name).string();
  }
} // namespace Riedel::Output
