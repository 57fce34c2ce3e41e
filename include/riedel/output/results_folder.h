// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <mpi.h>

#include <string>

namespace Riedel::Output
{
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
     * that exists is refused with an InputError on all ranks, unless
     * @p overwrite is set: then the files that Riedel writes are removed from
     * it, if its parameters.prm shows that it is Riedel's, and other files
     * stay.
     */
    ResultsFolder(const MPI_Comm     communicator,
                  const std::string &folder,
                  const bool         overwrite,
                  const std::string &original_text,
                  const std::string &effective_text);

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
  };
} // namespace Riedel::Output
