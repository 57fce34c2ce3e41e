// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <mpi.h>

#include <string>

namespace Riedel::Output
{
  /// What to do with a results folder that exists.
  enum class Existing
  {
    refuse,  ///< it is an error
    replace, ///< its results are removed
    resume   ///< the run in it goes on
  };



  /**
   * The folder into which a run writes. It holds the input as it was given
   * (original.prm) and all parameters with their effective values
   * (parameters.prm) from the beginning.
   */
  class ResultsFolder
  {
  public:
    /**
     * Creates the folder and the two files, on rank 0; collective. A folder
     * that exists is refused with an InputError on all ranks, or the files
     * that Riedel writes are removed from it, if its parameters.prm shows that
     * it is Riedel's, and other files stay. A folder whose run goes on must
     * exist, and is left as it is until write_inputs().
     */
    ResultsFolder(const MPI_Comm     communicator,
                  const std::string &folder,
                  const Existing     existing,
                  const std::string &original_text,
                  const std::string &effective_text);

    /// Writes the two files; for one rank.
    void
    write_inputs() const;

    /// Does the run in it go on?
    bool
    is_resumed() const
    {
      return existing == Existing::resume;
    }

    /// Path of a file in the folder.
    std::string
    path(const std::string &file_name) const;

    /// The folder itself.
    const std::string &
    name() const
    {
      return folder;
    }

  private:
    std::string folder;
    Existing    existing;
    std::string original_text, effective_text;
  };
} // namespace Riedel::Output
