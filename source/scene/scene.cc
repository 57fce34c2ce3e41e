// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/nearest_name.h>
#include <riedel/scene/input_file.h>
#include <riedel/scene/language.h>
#include <riedel/scene/scene.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <regex>
#include <set>

namespace Riedel::Scene
{
  namespace
  {
    /// The sections whose subsections have names that users choose.
    const std::string materials_section  = "Materials";
    const std::string zones_section      = "Initial state/Zones";
    const std::string regions_section    = "Adaptation/Regions";
    const std::string boundaries_section = "Boundary conditions";
    const std::string plates_section     = "Plates";

    /// @p path is @p section or something in it.
    bool
    is_within(const std::string &path, const std::string &section)
    {
      return path == section ||
             path.compare(0, section.size() + 1, section + "/") == 0;
    }

    /// Collects what is wrong and makes one text of it.
    class Report
    {
    public:
      explicit Report(const InputFile &input)
        : input(input)
      {}

      void
      add(const InputFile::Place &place,
          const std::string      &path,
          const std::string      &message)
      {
        const std::string text = format(place, path, message);
        if (std::find(texts.begin(), texts.end(), text) == texts.end())
          texts.push_back(text);
      }

      void
      add(const std::string &path, const std::string &message)
      {
        add(input.place(path), path, message);
      }

      static std::string
      format(const InputFile::Place &place,
             const std::string      &path,
             const std::string      &message)
      {
        return place.text() + ": " + path + "\n  " +
               std::regex_replace(message, std::regex("\n"), "\n  ");
      }

      /// Ends the reading if anything is wrong.
      void
      throw_if_wrong() const
      {
        if (texts.empty())
          return;
        // more than these are consequences of the first ones, mostly
        const std::size_t most = 8;
        std::string       all;
        for (std::size_t i = 0; i < std::min(most, texts.size()); ++i)
          all += (i == 0 ? "" : "\n\n") + texts[i];
        if (texts.size() > 1)
          all += "\n\n" + std::to_string(texts.size()) +
                 " mistakes in the input" +
                 (texts.size() > most ?
                    ", the first " + std::to_string(most) + " are shown." :
                    ".");
        throw InputError(all);
      }

    private:
      const InputFile         &input;
      std::vector<std::string> texts;
    };



    /// Goes down to a section of the handler and comes back at the end.
    class EnteredSection
    {
    public:
      EnteredSection(dealii::ParameterHandler &prm, std::string path)
        : prm(prm)
      {
        while (!path.empty())
          {
            const auto slash = std::min(path.find('/'), path.size());
            prm.enter_subsection(path.substr(0, slash));
            path.erase(0, slash + 1);
            ++depth;
          }
      }

      ~EnteredSection()
      {
        for (; depth > 0; --depth)
          prm.leave_subsection();
      }

    private:
      dealii::ParameterHandler &prm;
      unsigned int              depth = 0;
    };



    Names
    find_names(const InputFile &input)
    {
      Names names;
      for (const std::string &name : input.names_in(materials_section))
        names.materials.emplace_back(name,
                                     input.value(materials_section + "/" +
                                                 name + "/Law"));
      names.zones      = input.names_in(zones_section);
      names.regions    = input.names_in(regions_section);
      names.boundaries = input.names_in(boundaries_section);
      names.plates     = input.names_in(plates_section);
      return names;
    }

    /// The user's names that the file itself does not have: --set may change a
    /// material or a zone, but one that it invents is a slip of the pen.
    void
    check_overridden_names(const InputFile       &input,
                           Report                &report,
                           std::set<std::string> &wrong)
    {
      for (const std::string &parent :
           {materials_section, zones_section, regions_section, plates_section})
        {
          std::vector<std::string> given, invented;
          for (const std::string &name : input.names_in(parent))
            {
              const std::string path = parent + "/" + name;
              const bool        known =
                std::any_of(input.sections().begin(),
                            input.sections().end(),
                            [&](const auto &s) { return s.path == path; });
              (known ? given : invented).push_back(name);
            }
          for (const std::string &name : invented)
            {
              const std::string path = parent + "/" + name;
              wrong.insert(path);
              report.add({"--set", 0},
                         path,
                         "There is no section \"" + name + "\" in " +
                           input.name() + "." + did_you_mean(name, given) +
                           (given.empty() ? "" :
                                            "\nSection " + parent + " has: " +
                                              enumerate(given) + "."));
            }
        }
    }

    template <int dim>
    void
    check_laws(const Names &names, Report &report, std::set<std::string> &wrong)
    {
      const auto laws = Material::known_laws<dim>();
      for (const auto &[name, law] : names.materials)
        {
          const std::string path = materials_section + "/" + name;
          if (wrong.count(path) > 0 ||
              std::find(laws.begin(), laws.end(), law) != laws.end())
            continue;
          wrong.insert(path);
          const auto others = Material::known_laws<(dim == 2 ? 3 : 2)>();
          const bool is_of_other_dimension =
            std::find(others.begin(), others.end(), law) != others.end();
          report.add(path + "/Law",
                     (law.empty() ?
                        "The material needs a law: \"set Law = ...\"." :
                      is_of_other_dimension ?
                        "There is no law \"" + law +
                          "\" with Dimension = " + std::to_string(dim) + "." :
                        "There is no law \"" + law + "\"." +
                          did_you_mean(law, laws)) +
                       "\nThe laws are: " + enumerate(laws) + ".");
        }
    }

    /// Declares everything; each material knows its law from then on.
    template <int dim>
    void
    declare_with_laws(dealii::ParameterHandler &prm, const Names &names)
    {
      Scene<dim>::declare(prm, names);
      const auto laws = Material::known_laws<dim>();
      for (const auto &[name, law] : names.materials)
        if (std::find(laws.begin(), laws.end(), law) != laws.end())
          {
            const EnteredSection entered(prm, materials_section + "/" + name);
            prm.set("Law", law);
          }
    }

    /// Finds unknown sections and parameters, and hands all known values to
    /// the handler. What is in the sections @p wrong is left out.
    void
    take_values(const InputFile             &input,
                const std::set<std::string> &wrong,
                dealii::ParameterHandler    &prm,
                Report                      &report)
    {
      // these may have no parameters
      std::vector<std::string> named_sections;
      for (const std::string &parent : {materials_section,
                                        zones_section,
                                        regions_section,
                                        boundaries_section,
                                        plates_section})
        {
          named_sections.push_back(parent);
          for (const std::string &name : input.names_in(parent))
            named_sections.push_back(parent + "/" + name);
        }
      const Language language(declared_parameters(prm), named_sections);

      std::set<std::string> skipped    = wrong;
      const auto            is_skipped = [&skipped](const std::string &path) {
        return std::any_of(skipped.begin(),
                           skipped.end(),
                           [&path](const std::string &section) {
                             return is_within(path, section);
                           });
      };
      const auto refuse_section = [&](const InputFile::Place &place,
                                      std::string             path) {
        // the first step of the path that is unknown
        while (!language.has_section(parent_of(path)))
          path = parent_of(path);
        skipped.insert(path);
        report.add(place, path, language.explain_section(path));
      };

      for (const InputFile::Section &section : input.sections())
        if (!is_skipped(section.path) && !language.has_section(section.path))
          refuse_section(section.place, section.path);

      for (const InputFile::Entry &entry : input.entries())
        {
          if (is_skipped(entry.path))
            continue;
          const std::string        section   = parent_of(entry.path);
          const DeclaredParameter *parameter = language.find(entry.path);
          if (!language.has_section(section))
            refuse_section(entry.place, section);
          else if (parameter == nullptr)
            report.add(entry.place,
                       entry.path,
                       language.explain_parameter(entry.path));
          else
            try
              {
                const EnteredSection entered(prm, section);
                prm.set(parameter->name(), entry.value);
              }
            catch (
              const dealii::ParameterHandler::ExcValueDoesNotMatchPattern &)
              {
                report.add(entry.place,
                           entry.path,
                           Language::explain_value(*parameter, entry.value));
              }
        }

      for (const std::string &path : missing_parameters(prm))
        if (!is_skipped(path) &&
            std::none_of(input.entries().begin(),
                         input.entries().end(),
                         [&path](const auto &e) { return e.path == path; }))
          report.add(path,
                     "The value is missing: \"set " + name_of(path) +
                       " = ...\"." + Language::explain(*language.find(path)));
    }
  } // namespace



  template <int dim>
  void
  Scene<dim>::declare(dealii::ParameterHandler &prm, const Names &names)
  {
    GeneralParameters::declare(prm);
    Grid::GeometryParameters::declare(prm);
    Grid::Parameters::declare(prm);
    Material::Parameters<dim>::declare(prm, names.materials);
    Points::MovingPointsParameters::declare(prm);
    Points::InitialStateParameters<dim>::declare(prm, names.zones);
    Equilibrium::BoundaryConditionParameters<dim>::declare(prm,
                                                           names.boundaries);
    Equilibrium::PlatesParameters<dim>::declare(prm, names.plates);
    Equilibrium::LoadingParameters<dim>::declare(prm);
    Equilibrium::SolverParameters::declare(prm);
    Adaptation::Parameters<dim>::declare(prm, names.regions);
    Output::Parameters::declare(prm);
    Checkpoint::Parameters::declare(prm);
    ElementTest::Parameters::declare(prm);
  }



  template <int dim>
  void
  Scene<dim>::parse(dealii::ParameterHandler &prm, const Names &names)
  {
    general.parse(prm);
    geometry.parse(prm, dim);
    grid.parse(prm, dim);
    materials.parse(prm, names.materials);
    moving_points.parse(prm);
    initial_state.parse(prm, names.zones);
    boundary_conditions.parse(prm, names.boundaries);
    boundary_conditions.choose_form(grid.configuration ==
                                        Grid::ReferenceConfiguration::current ?
                                      Equilibrium::LoadForm::virtual_stress :
                                      Equilibrium::LoadForm::surface_integral);
    plates.parse(prm, names.plates);
    loading.parse(prm);
    solver.parse(prm);
    adaptation.parse(prm, names.regions);
    output.parse(prm);
    checkpoint.parse(prm);
    element_test.parse(prm);
  }



  unsigned int
  dimension_of(const std::string              &file,
               const std::vector<std::string> &overrides)
  {
    return InputFile(file, overrides).value("Dimension") == "3" ? 3 : 2;
  }



  template <int dim>
  Scene<dim>
  read_scene(const std::string &file, const std::vector<std::string> &overrides)
  {
    const InputFile input(file, overrides);
    const Names     names = find_names(input);
    Report          report(input);

    // Mistakes in the names come first: with a wrong one, everything after it
    // would only be a consequence.
    std::set<std::string> wrong;
    check_overridden_names(input, report, wrong);
    check_laws<dim>(names, report, wrong);

    dealii::ParameterHandler prm;
    declare_with_laws<dim>(prm, names);
    take_values(input, wrong, prm, report);
    report.throw_if_wrong();

    Scene<dim> scene;
    try
      {
        scene.parse(prm, names);
      }
    catch (const ParameterError &error)
      {
        report.add(error.path, error.message);
        report.throw_if_wrong();
      }

    Problems problems;
    scene.check(problems);
    for (const Problems::Item &problem : problems.errors)
      report.add(problem.path, problem.message);
    report.throw_if_wrong();

    scene.file          = file;
    scene.original_text = input.original_text();
    scene.parameters    = declared_parameters(prm);
    scene.warnings      = input.repeated();
    for (const Problems::Item &problem : problems.warnings)
      {
        const std::string text = Report::format(input.place(problem.path),
                                                problem.path,
                                                problem.message);
        if (std::find(scene.warnings.begin(), scene.warnings.end(), text) ==
            scene.warnings.end())
          scene.warnings.push_back(text);
      }
    return scene;
  }



  std::vector<DeclaredParameter>
  all_parameters()
  {
    Names names;
    for (const std::string &law : Material::known_laws<2>())
      names.materials.emplace_back(law, law);
    names.zones      = {"weak spot"};
    names.regions    = {"corner"};
    names.boundaries = {"left"};
    names.plates     = {"footing"};

    dealii::ParameterHandler prm;
    declare_with_laws<2>(prm, names);
    return declared_parameters(prm);
  }



  template struct Scene<2>;
  template Scene<2>
  read_scene<2>(const std::string &, const std::vector<std::string> &);
  template struct Scene<3>;
  template Scene<3>
  read_scene<3>(const std::string &, const std::vector<std::string> &);
} // namespace Riedel::Scene
