// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/errors.h>
#include <riedel/nearest_name.h>
#include <riedel/scene/input_file.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace Riedel::Scene
{
  namespace
  {
    const std::string blanks = " \t\r\f\v";

    std::string
    trim(const std::string &text)
    {
      const auto first = text.find_first_not_of(blanks);
      if (first == std::string::npos)
        return "";
      return text.substr(first, text.find_last_not_of(blanks) - first + 1);
    }

    /// A name as it is compared: one blank between words.
    std::string
    tidy_name(const std::string &text)
    {
      std::istringstream words(text);
      std::string        name, word;
      while (words >> word)
        name += (name.empty() ? "" : " ") + word;
      return name;
    }

    std::string
    join(const std::vector<std::string> &path)
    {
      std::string text;
      for (const std::string &name : path)
        text += (text.empty() ? "" : "/") + name;
      return text;
    }

    /// Cuts the first word off @p line.
    std::string
    take_word(std::string &line)
    {
      const auto        end = std::min(line.find_first_of(blanks), line.size());
      const std::string word = line.substr(0, end);
      line                   = trim(line.substr(end));
      return word;
    }

    [[noreturn]] void
    fail(const InputFile::Place &place, const std::string &message)
    {
      throw InputError(place.text() + ": " + message);
    }

    /// Files beside @p file whose names are like it.
    std::string
    nearest_file(const std::filesystem::path &file)
    {
      std::error_code             error;
      std::vector<std::string>    names;
      const std::filesystem::path folder =
        file.has_parent_path() ? file.parent_path() : ".";
      if (!std::filesystem::is_directory(folder, error))
        return " There is no folder \"" + folder.string() + "\".";
      for (const auto &beside :
           std::filesystem::directory_iterator(folder, error))
        if (beside.is_regular_file(error))
          names.push_back(beside.path().filename().string());
      std::sort(names.begin(), names.end());
      return did_you_mean(file.filename().string(), names);
    }

    /// Names become paths and take part in messages.
    void
    check_name(const std::string      &name,
               const std::string      &what,
               const InputFile::Place &place)
    {
      if (name.empty())
        fail(place, "the name of the " + what + " is missing.");
      if (name.find('/') != std::string::npos)
        fail(place,
             "the name \"" + name + "\" contains a \"/\", which separates " +
               "sections in messages and in --set. Choose a name without it.");
    }
  } // namespace



  std::string
  InputFile::Place::text() const
  {
    return line == 0 ? file : file + ":" + std::to_string(line);
  }



  InputFile::InputFile(const std::string              &file,
                       const std::vector<std::string> &overrides)
    : file_name(file)
  {
    std::vector<std::string> open_files;
    read(file, Place(), open_files, {}, "");
    read_overrides(overrides);
  }



  void
  InputFile::read(const std::string              &file,
                  const Place                    &included_at,
                  std::vector<std::string>       &open_files,
                  const std::vector<std::string> &outer_path,
                  const std::string              &margin)
  {
    const bool      is_case = open_files.empty();
    std::error_code error;
    std::ifstream   input;
    if (!std::filesystem::is_directory(file, error))
      input.open(file);
    if (!input.is_open())
      {
        const std::string reason = std::filesystem::is_directory(file, error) ?
                                     "it is a folder." :
                                   std::filesystem::exists(file, error) ?
                                     "you may not read it." :
                                     "it does not exist." + nearest_file(file);
        if (is_case)
          throw InputError("Cannot open the file \"" + file + "\": " + reason);
        fail(included_at,
             "cannot open the included file \"" + file + "\": " + reason +
               "\n  Paths are relative to the file that includes.");
      }

    const std::string identity = std::filesystem::canonical(file).string();
    if (const auto same =
          std::find(open_files.begin(), open_files.end(), identity);
        same != open_files.end())
      {
        std::string circle;
        for (auto f = same; f != open_files.end(); ++f)
          circle +=
            std::filesystem::path(*f).filename().string() + " includes ";
        fail(included_at,
             "files include each other in a circle: " + circle +
               std::filesystem::path(identity).filename().string() + ".");
      }
    open_files.push_back(identity);

    struct Open
    {
      Place       place;
      std::size_t indentation;
    };
    std::vector<std::string> path = outer_path;
    std::vector<Open>        open;
    // Users indent: the first `end` that does not stand below its `subsection`
    // shows where one was forgotten, better than the end of the file does.
    std::string suspicion;

    std::string  line;
    unsigned int number = 0;
    while (std::getline(input, line))
      {
        const Place       here{file, ++number};
        const std::size_t indentation =
          std::min(line.find_first_not_of(blanks), line.size());
        std::string given = margin + line + "\n";

        const auto without_comment = [](const std::string &text) {
          return text.substr(0, text.find('#'));
        };
        std::string statement = trim(without_comment(line));
        while (!statement.empty() && statement.back() == '\\')
          {
            statement.pop_back();
            if (!std::getline(input, line))
              fail(here, "the file ends after a line that ends with \"\\\".");
            ++number;
            given += margin + line + "\n";
            statement += trim(without_comment(line));
          }

        const std::string whole   = statement;
        const std::string keyword = take_word(statement);

        if (keyword == "include")
          {
            std::string included = statement;
            if (included.size() > 1 && included.front() == '"' &&
                included.back() == '"')
              included = included.substr(1, included.size() - 2);
            if (included.empty())
              fail(here, "the name of the file to include is missing.");
            const std::filesystem::path target =
              std::filesystem::path(file).parent_path() / included;
            const std::string inner = margin + std::string(indentation, ' ');
            original += inner + "# included from " + included + "\n";
            read(target.lexically_normal().string(),
                 here,
                 open_files,
                 path,
                 inner);
            original += inner + "# end of " + included + "\n";
            continue;
          }
        original += given;

        if (keyword.empty())
          continue;
        else if (keyword == "subsection")
          {
            const std::string name = tidy_name(statement);
            check_name(name, "subsection", here);
            path.push_back(name);
            open.push_back({here, indentation});
            all_sections.push_back({join(path), here});
          }
        else if (keyword == "end")
          {
            if (!statement.empty())
              fail(here,
                   "\"end\" stands alone on its line; \"" + statement +
                     "\" is too much. Comments begin with #.");
            if (open.empty())
              fail(here,
                   "this \"end\" has no \"subsection\": there is one \"end\" "
                   "too many in this file, or a \"subsection\" is missing.");
            if (suspicion.empty() && open.back().indentation > indentation)
              suspicion = "\n  The indentation suggests that it is missing "
                          "before " +
                          here.text() + ", for section " + join(path) +
                          " of line " + std::to_string(open.back().place.line) +
                          ".";
            open.pop_back();
            path.pop_back();
          }
        else if (keyword == "set")
          {
            const auto        equals = statement.find('=');
            const std::string name   = tidy_name(statement.substr(0, equals));
            if (equals == std::string::npos)
              fail(here,
                   "\"" + whole + "\" has no \"=\". A value is given by " +
                     "\"set NAME = VALUE\".");
            check_name(name, "parameter", here);
            path.push_back(name);
            all_entries.push_back(
              {join(path), trim(statement.substr(equals + 1)), here});
            path.pop_back();
          }
        else
          {
            std::string hint =
              did_you_mean(keyword, {"set", "subsection", "end", "include"});
            if (whole.find('=') != std::string::npos &&
                keyword.find("set") != 0)
              hint = " Did you mean \"set " + whole + "\"?";
            fail(here,
                 "cannot read \"" + whole + "\"." + hint +
                   "\n  A line is \"set NAME = VALUE\", \"subsection NAME\", "
                   "\"end\", \"include FILE\" or a # comment.");
          }
      }

    if (!open.empty())
      fail(open.back().place,
           "section " + join(path) +
             " begins here and is never closed: an \"end\" is missing." +
             suspicion);
    open_files.pop_back();
  }



  void
  InputFile::read_overrides(const std::vector<std::string> &overrides)
  {
    for (const std::string &text : overrides)
      {
        const Place here{"--set", 0};
        const auto  equals = text.find('=');
        if (equals == std::string::npos)
          throw InputError("--set \"" + text +
                           "\": there is no \"=\". Write "
                           "--set \"Section/Parameter=value\".");

        std::vector<std::string> path;
        std::istringstream       parts(text.substr(0, equals));
        for (std::string part; std::getline(parts, part, '/');)
          {
            path.push_back(tidy_name(part));
            if (path.back().empty())
              throw InputError("--set \"" + text +
                               "\": a name is missing. Write "
                               "--set \"Section/Parameter=value\".");
          }
        if (path.empty())
          throw InputError("--set \"" + text +
                           "\": the name of the parameter is missing. Write "
                           "--set \"Section/Parameter=value\".");

        const std::string value = trim(text.substr(equals + 1));
        if (value.find_first_of("#\n\\") != std::string::npos)
          throw InputError("--set \"" + text +
                           "\": a value has no \"#\", \"\\\" or line break.");
        all_entries.push_back({join(path), value, here});

        original += "\n# --set on the command line\n";
        for (unsigned int i = 0; i + 1 < path.size(); ++i)
          original += "subsection " + path[i] + "\n";
        original += "set " + path.back() + " = " + value + "\n";
        for (unsigned int i = 0; i + 1 < path.size(); ++i)
          original += "end\n";
      }
  }



  std::vector<std::string>
  InputFile::names_in(const std::string &parent) const
  {
    std::vector<std::string> names;
    const std::string        begin = parent + "/";
    const auto               add   = [&](const std::string &section) {
      if (section.compare(0, begin.size(), begin) != 0)
        return;
      const std::string name =
        section.substr(begin.size(),
                       section.find('/', begin.size()) - begin.size());
      if (std::find(names.begin(), names.end(), name) == names.end())
        names.push_back(name);
    };
    for (const Section &section : all_sections)
      add(section.path);
    // --set opens no section
    for (const Entry &entry : all_entries)
      add(
        entry.path.substr(0,
                          std::min(entry.path.rfind('/'), entry.path.size())));
    return names;
  }



  std::string
  InputFile::value(const std::string &path) const
  {
    for (auto entry = all_entries.rbegin(); entry != all_entries.rend();
         ++entry)
      if (entry->path == path)
        return entry->value;
    return "";
  }



  InputFile::Place
  InputFile::place(const std::string &path) const
  {
    for (auto entry = all_entries.rbegin(); entry != all_entries.rend();
         ++entry)
      if (entry->path == path)
        return entry->place;

    for (std::string section = path; !section.empty();)
      {
        for (const Section &known : all_sections)
          if (known.path == section)
            return known.place;
        // --set opens no section
        for (const Entry &entry : all_entries)
          if (entry.path.compare(0, section.size() + 1, section + "/") == 0)
            return entry.place;
        const auto slash = section.rfind('/');
        section.erase(slash == std::string::npos ? 0 : slash);
      }
    return {file_name, 0};
  }



  std::vector<std::string>
  InputFile::repeated() const
  {
    std::vector<std::string> texts;
    for (auto later = all_entries.begin(); later != all_entries.end(); ++later)
      for (auto first = all_entries.begin(); first != later; ++first)
        if (first->path == later->path && later->place.line != 0 &&
            first->place.file == later->place.file &&
            // a file that is included twice repeats itself
            first->place.line != later->place.line)
          {
            texts.push_back(later->place.text() + ": " + later->path +
                            " is set again; line " +
                            std::to_string(first->place.line) +
                            " set it first. The last value counts.");
            break;
          }
    return texts;
  }
} // namespace Riedel::Scene
