// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/errors.h>
#include <riedel/nearest_name.h>
#include <riedel/scene/command_line.h>
#include <riedel/version.h>

#include <deal.II/base/config.h>

#include <CLI/CLI.hpp>

#include <map>

namespace Riedel::Scene
{
  CommandLine
  read_command_line(const int argc, const char *const *argv)
  {
    const std::map<std::string, Format> formats = {{"md", Format::markdown},
                                                   {"prm", Format::prm},
                                                   {"json", Format::json}};

    CommandLine command;
    CLI::App app("Riedel computes shear bands in granular bodies.", "riedel");
    app.footer("The exit code is 0 if all went well, 1 if the computation "
               "failed, 2 if the input is wrong.");
    app.add_option("case", command.case_file, "The case file (.prm)");
    app
      .add_option("--set",
                  command.overrides,
                  "\"Section/Parameter=value\": a value that overrides the "
                  "file; may be repeated")
      ->type_name("TEXT")
      ->expected(1)
      ->take_all();
    app.add_flag("--validate",
                 command.validate,
                 "Read and check the case, compute nothing");
    std::string              format;
    const CLI::Option *const print =
      app
        .add_option("--print-parameters",
                    format,
                    "Print all parameters, with a case file their values in "
                    "this case; md if no format is given")
        ->type_name("md|prm|json")
        ->expected(0, 1);
    app.add_flag("--overwrite",
                 command.overwrite,
                 "Replace the results of an earlier run");
    app.add_flag("--resume",
                 command.resume,
                 "Go on from the last checkpoint of an earlier run");
    const CLI::Option *const version =
      app.add_flag("--version", "Print the version and end");
    // not an error of its own: the nearest option is looked up below
    app.allow_extras();

    try
      {
        app.parse(argc, argv);
      }
    catch (const CLI::CallForHelp &)
      {
        command.answer = app.help();
        return command;
      }
    catch (const CLI::ParseError &error)
      {
        throw InputError(std::string(error.what()) +
                         "\n\"riedel --help\" lists the options.");
      }

    if (version->count() > 0)
      {
        command.answer = std::string("Riedel ") + RIEDEL_VERSION +
                         " (deal.II " DEAL_II_PACKAGE_VERSION ")\n";
        return command;
      }

    std::vector<std::string> extras = app.remaining();
    if (print->count() > 0)
      {
        // "--print-parameters case.prm": the option took the file for a format
        if (!format.empty() && formats.count(format) == 0 &&
            command.case_file.empty())
          std::swap(format, command.case_file);
        if (format.empty())
          format = "md";
        const auto found = formats.find(format);
        if (found == formats.end())
          throw InputError("--print-parameters has no format \"" + format +
                           "\"; its formats are md, prm and json.");
        command.print_parameters = found->second;
      }

    if (!extras.empty())
      {
        std::vector<std::string> options;
        for (const CLI::Option *const option : app.get_options())
          if (!option->get_positional())
            options.push_back(option->get_name());
        throw InputError(
          (extras[0][0] == '-' ?
             "There is no option \"" + extras[0] + "\"." +
               did_you_mean(extras[0].substr(0, extras[0].find('=')), options) :
             "\"" + extras[0] + "\" is too much: there is one case file, \"" +
               command.case_file + "\".") +
          "\n\"riedel --help\" lists the options.");
      }
    if (command.resume && command.overwrite)
      throw InputError("--resume goes on with the results of an earlier run, "
                       "--overwrite removes them: give one of the two.");
    if (command.case_file.empty() && !command.print_parameters)
      throw InputError("Which case? Write \"riedel case.prm\"; "
                       "\"riedel --help\" lists the options.");
    return command;
  }
} // namespace Riedel::Scene
