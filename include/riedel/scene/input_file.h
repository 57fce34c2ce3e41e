// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace Riedel::Scene
{
  /**
   * The text of a .prm file with everything it includes: a flat list of values
   * in the order in which they are set, each with its place. It knows the
   * grammar only, not which parameters exist:
   *
   *     set NAME = VALUE        # a comment
   *     subsection NAME
   *       include FILE          # relative to the file that includes
   *     end
   *
   * A line that ends with a backslash goes on in the next one. Blanks around
   * names and values do not count, several blanks within a name count as one.
   * The first violation of the grammar throws an InputError with its place.
   */
  class InputFile
  {
  public:
    /// Where something is said. Line 0 stands for the whole file.
    struct Place
    {
      std::string  file;
      unsigned int line = 0;

      /// `case.prm:12`, or `case.prm` for the whole file
      std::string
      text() const;
    };

    /// One `set` line, or one --set of the command line.
    struct Entry
    {
      std::string path; ///< sections and parameter, separated by '/'
      std::string value;
      Place       place;
    };

    /// One `subsection` line.
    struct Section
    {
      std::string path;
      Place       place;
    };

    /// Reads @p file; @p overrides are texts "Section/Parameter=value", set
    /// after everything else, with "--set" as their file.
    InputFile(const std::string              &file,
              const std::vector<std::string> &overrides);

    const std::string &
    name() const
    {
      return file_name;
    }

    /// All values in the order in which they are set: the last one counts.
    const std::vector<Entry> &
    entries() const
    {
      return all_entries;
    }

    /// All sections in the order in which they are opened.
    const std::vector<Section> &
    sections() const
    {
      return all_sections;
    }

    /// Names of the subsections of @p parent in the order in which they first
    /// appear.
    std::vector<std::string>
    names_in(const std::string &parent) const;

    /// The value of a parameter, or an empty text if it is not set.
    std::string
    value(const std::string &path) const;

    /// Where a parameter is set or, if it is not, where the innermost of its
    /// sections begins or, if there is none, the file.
    Place
    place(const std::string &path) const;

    /// Values that are set twice in the same file: ready texts for the user.
    std::vector<std::string>
    repeated() const;

    /// The text as it was given, included files in their place, --set at the
    /// end: a file that can be computed without all others.
    const std::string &
    original_text() const
    {
      return original;
    }

  private:
    void
    read(const std::string              &file,
         const Place                    &included_at,
         std::vector<std::string>       &open_files,
         const std::vector<std::string> &outer_path,
         const std::string              &margin);

    void
    read_overrides(const std::vector<std::string> &overrides);

    std::string          file_name;
    std::vector<Entry>   all_entries;
    std::vector<Section> all_sections;
    std::string          original;
  };
} // namespace Riedel::Scene
