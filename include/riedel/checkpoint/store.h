// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace Riedel::Checkpoint
{
  /**
   * The checkpoints of a results folder on the disk:
   *
   *     checkpoints/000120/     a checkpoint: the state after step 120
   *     checkpoints/last        the name of the last good one
   *     checkpoints/unfinished/ one that is being written or removed
   *
   * A checkpoint is written as `unfinished`, brought to the disk and renamed;
   * then `last` is replaced by renaming, too, and only then older ones are
   * removed. So at any moment, also if the program is killed or the power
   * fails, `last` names a complete checkpoint or does not exist yet.
   *
   * For one rank. All functions throw std::filesystem::filesystem_error if the
   * disk refuses.
   */
  class Store
  {
  public:
    explicit Store(const std::filesystem::path &results);

    /// Where a checkpoint of this name is.
    std::filesystem::path
    path(const std::string &name) const;

    /// An empty folder for the files of the next checkpoint.
    std::filesystem::path
    begin() const;

    /// The files in the folder of begin() become the checkpoint after
    /// @p step and the last good one; the newest @p keep stay. Returns its
    /// name.
    std::string
    publish(const unsigned int step, const unsigned int keep) const;

    /// Checkpoints to resume from, best first: the one that `last` names, even
    /// if it is missing, then older ones; without `last` all, the newest first.
    std::vector<std::string>
    candidates() const;

    /// The run goes on from @p name: it is the last good one again, newer ones
    /// are removed.
    void
    return_to(const std::string &name) const;

    /// Removes all checkpoints; what else is in the folder stays.
    void
    clear() const;

  private:
    /// All of them, newest first.
    std::vector<std::string>
    all() const;

    /// What `last` says, or nothing.
    std::string
    marked() const;

    void
    mark(const std::string &name) const;

    void
    remove(const std::string &name) const;

    const std::filesystem::path folder;
  };
} // namespace Riedel::Checkpoint
