// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/grid/parameters.h>
#include <riedel/nearest_name.h>
#include <riedel/pattern.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace Riedel::Grid
{
  using dealii::ParameterHandler;
  namespace Patterns  = dealii::Patterns;
  namespace Utilities = dealii::Utilities;

  void
  GeometryParameters::declare(ParameterHandler &prm)
  {
    prm.enter_subsection("Geometry");
    prm.declare_entry(
      "Box",
      "",
      Patterns::List(Patterns::Double(0), 0, 3),
      "Edge lengths of a rectangular body, \"width, height\" or \"width, "
      "depth, height\" [m]. Its boundaries are called left, right, (front, "
      "back,) bottom and top.");
    prm.declare_entry("Origin",
                      "",
                      Patterns::List(Patterns::Double(), 0, 3),
                      "Lower left corner of the box [m]; without it, the "
                      "origin of the coordinates.");
    prm.declare_entry("File",
                      "",
                      FormPattern("the name of a .msh, .inp or .vtk file"),
                      "A grid file instead of a box: Gmsh (.msh), UCD (.inp) "
                      "or VTK (.vtk), relative to the working directory.");
    prm.declare_entry("Boundary names",
                      "",
                      FormPattern("0: bottom, 1: right and so on"),
                      "Names of the boundaries of a grid file by their "
                      "numbers in it.");
    prm.declare_entry("Round boundaries",
                      "",
                      FormPattern("names of boundaries, separated by \",\""),
                      "Boundaries of a grid file that are arcs of a circle, or "
                      "parts of a sphere: nodes of finer cells are put on it.");
    prm.leave_subsection();
  }



  void
  GeometryParameters::parse(ParameterHandler &prm, const unsigned int dim)
  {
    dimension = dim;
    prm.enter_subsection("Geometry");
    box =
      Utilities::string_to_double(Utilities::split_string_list(prm.get("Box")));
    origin = Utilities::string_to_double(
      Utilities::split_string_list(prm.get("Origin")));
    if (origin.empty())
      origin.assign(dim, 0.0);
    file = prm.get("File");

    boundary_names.clear();
    for (const std::string &item :
         Utilities::split_string_list(prm.get("Boundary names")))
      {
        const auto parts = Utilities::split_string_list(item, ':');
        if (parts.size() != 2 || parts[1].empty() ||
            !Patterns::Integer(0).match(parts[0]))
          throw ParameterError("Geometry/Boundary names",
                               "\"" + item +
                                 "\" is not a number and a name; write "
                                 "\"0: bottom, 1: right\".");
        if (!boundary_names
               .emplace(Utilities::string_to_int(parts[0]), parts[1])
               .second)
          throw ParameterError("Geometry/Boundary names",
                               "The boundary " + parts[0] + " has two names.");
      }
    round_boundaries =
      Utilities::split_string_list(prm.get("Round boundaries"));
    prm.leave_subsection();

    if (!box.empty() && boundary_names.empty())
      {
        // the order in which deal.II numbers the sides of a box
        const std::vector<std::string> sides =
          dim == 2 ?
            std::vector<std::string>{"left", "right", "bottom", "top"} :
            std::vector<std::string>{
              "left", "right", "front", "back", "bottom", "top"};
        for (unsigned int side = 0; side < sides.size(); ++side)
          boundary_names[side] = sides[side];
      }
  }



  void
  GeometryParameters::check(Problems &problems) const
  {
    const std::string entries = std::to_string(dimension) + " entries";
    if (box.empty() && file.empty())
      {
        problems.error("Geometry/Box",
                       "The body has no shape. Give its edge lengths, for "
                       "example \"set Box = 0.10, 0.05\", or a grid with "
                       "\"set File = ...\".");
        return;
      }
    if (!box.empty() && !file.empty())
      {
        problems.error("Geometry/File",
                       "The body has both a Box and a File. Remove one.");
        return;
      }

    if (file.empty())
      {
        if (box.size() != dimension)
          problems.error("Geometry/Box",
                         "The box has " + std::to_string(box.size()) +
                           " edge lengths; in " + std::to_string(dimension) +
                           "D it needs " + entries + ".");
        for (const double length : box)
          if (!(length > 0.0))
            {
              problems.error("Geometry/Box",
                             "Every edge length must be larger than 0 m.");
              break;
            }
        if (origin.size() != dimension)
          problems.error("Geometry/Origin",
                         "The corner has " + std::to_string(origin.size()) +
                           " coordinates; in " + std::to_string(dimension) +
                           "D it needs " + entries + ".");
        if (!round_boundaries.empty())
          problems.error("Geometry/Round boundaries",
                         "They are for grid files only; the boundaries of a "
                         "box are plane.");
        if (boundary_names.size() != 2 * dimension)
          problems.error("Geometry/Boundary names",
                         "They are for grid files only; the boundaries of a "
                         "box have names already.");
        return;
      }

    if (!std::filesystem::exists(file))
      problems.error("Geometry/File",
                     "There is no file \"" + file +
                       "\" (relative to the working directory).");
    const std::string type = std::filesystem::path(file).extension().string();
    if (type != ".msh" && type != ".inp" && type != ".vtk")
      problems.error("Geometry/File",
                     "\"" + file +
                       "\" has an unknown type; its name must end with .msh "
                       "(Gmsh), .inp (UCD) or .vtk (VTK).");
    if (boundary_names.empty())
      problems.error("Geometry/Boundary names",
                     "The boundaries of a grid file need names: "
                     "\"set Boundary names = 0: bottom, 1: right\".");
    std::set<std::string> seen;
    for (const auto &[id, name] : boundary_names)
      if (!seen.insert(name).second)
        problems.error("Geometry/Boundary names",
                       "Two boundaries are called \"" + name + "\".");
    for (const std::string &name : round_boundaries)
      if (seen.count(name) == 0)
        problems.error("Geometry/Round boundaries",
                       "There is no boundary \"" + name + "\"." +
                         did_you_mean(name, names()));
  }



  std::vector<std::string>
  GeometryParameters::names() const
  {
    std::vector<std::string> names;
    for (const auto &[id, name] : boundary_names)
      names.push_back(name);
    return names;
  }



  void
  Parameters::declare(ParameterHandler &prm)
  {
    prm.enter_subsection("Grid");
    prm.declare_entry("Cells",
                      "",
                      Patterns::List(Patterns::Integer(1), 0, 3),
                      "Number of cells of the box along each axis.");
    prm.declare_entry("Refinements",
                      "0",
                      Patterns::Integer(0, 12),
                      "How often every cell is halved along each axis.");
    prm.declare_entry("Reference configuration",
                      "initial",
                      Patterns::Selection("initial|current"),
                      "Where the shape functions of a step live: \"initial\" "
                      "is the undeformed grid, finite elements; \"current\" "
                      "is a grid that is put back after every step while the "
                      "points move through it, the material point method.");
    prm.declare_entry("Margin cells",
                      "",
                      Patterns::List(Patterns::Integer(0, 100000), 0, 6),
                      "Cells of the grid beyond the body, into which it can "
                      "move: \"left, right, (front, back,) bottom, top\"; "
                      "for the configuration current.");
    prm.declare_entry("Periodic",
                      "no",
                      Patterns::Selection("no|left and right|front and "
                                          "back|bottom and top"),
                      "Two sides of a box that are tied: displacements and "
                      "rotations are the same at opposite places, as if the "
                      "body repeated itself without end; for the configuration "
                      "initial.");
    prm.declare_entry("Displacement degree",
                      "automatic",
                      Patterns::Selection("1|2|automatic"),
                      "Polynomial degree of the displacements; automatic is "
                      "2, and 1 in space and in the configuration current.");
    prm.declare_entry("Rotation degree",
                      "automatic",
                      Patterns::Selection("1|2|automatic"),
                      "Polynomial degree of the micro-rotations; automatic is "
                      "the displacement degree.");
    prm.declare_entry(
      "Strain sampling",
      "automatic",
      Patterns::Selection("automatic|full|mean dilatation|assumed"),
      "How the strains of a point are sampled: \"full\" at the point itself; "
      "\"mean dilatation\" takes the volume change from the cell's mean; "
      "\"assumed\" interpolates from fewer points of the cell, without "
      "locking; automatic is assumed for equal degrees, else full.");
    prm.declare_entry("Own strain fraction",
                      "0.1",
                      Patterns::Double(0, 1),
                      "Share of the point's own strain under assumed sampling; "
                      "more than 0 keeps hourglass modes out.");
    prm.leave_subsection();
  }



  void
  Parameters::parse(ParameterHandler &prm, const unsigned int dim)
  {
    prm.enter_subsection("Grid");
    cells.clear();
    for (const std::string &number :
         Utilities::split_string_list(prm.get("Cells")))
      cells.push_back(Utilities::string_to_int(number));
    margin.clear();
    for (const std::string &number :
         Utilities::split_string_list(prm.get("Margin cells")))
      margin.push_back(Utilities::string_to_int(number));
    refinements   = prm.get_integer("Refinements");
    configuration = prm.get("Reference configuration") == "current" ?
                      ReferenceConfiguration::current :
                      ReferenceConfiguration::initial;

    const std::string periodic = prm.get("Periodic");
    periodic_axis.reset();
    if (periodic != "no")
      periodic_axis = periodic == "left and right" ? 0 :
                      periodic == "front and back" ? 1 :
                                                     dim - 1;
    if (periodic == "front and back" && dim == 2)
      throw ParameterError("Grid/Periodic",
                           "The body has no sides \"front\" and \"back\": "
                           "they are for Dimension = 3.");

    const auto degree = [&prm](const std::string &name,
                               const unsigned int automatic) {
      const std::string text = prm.get(name);
      return text == "automatic" ?
               automatic :
               static_cast<unsigned int>(Utilities::string_to_int(text));
    };
    displacement_degree =
      degree("Displacement degree",
             configuration == ReferenceConfiguration::current || dim == 3 ? 1 :
                                                                            2);
    rotation_degree = degree("Rotation degree", displacement_degree);

    const std::string text = prm.get("Strain sampling");
    if (text == "automatic")
      sampling =
        (displacement_degree == rotation_degree ? StrainSampling::assumed :
                                                  StrainSampling::full);
    else
      sampling = (text == "full"            ? StrainSampling::full :
                  text == "mean dilatation" ? StrainSampling::mean_dilatation :
                                              StrainSampling::assumed);
    own_strain_fraction = prm.get_double("Own strain fraction");
    prm.leave_subsection();
  }



  void
  Parameters::check(const GeometryParameters &geometry,
                    Problems                 &problems) const
  {
    if (!geometry.file.empty() && !cells.empty())
      problems.error("Grid/Cells",
                     "Only a box is divided into Cells; the grid of a file is "
                     "made finer by Refinements.");
    else if (geometry.file.empty() && cells.empty())
      problems.error("Grid/Cells",
                     "The numbers of cells of the box are missing, for example "
                     "\"set Cells = 40, 20\".");
    else if (geometry.file.empty() && cells.size() != geometry.dimension)
      problems.error("Grid/Cells",
                     "There are " + std::to_string(cells.size()) +
                       " numbers of cells; in " +
                       std::to_string(geometry.dimension) + "D it needs " +
                       std::to_string(geometry.dimension) + " entries.");

    if (!margin.empty() && margin.size() != 2 * geometry.dimension)
      problems.error("Grid/Margin cells",
                     "There are " + std::to_string(margin.size()) +
                       " numbers; it needs " +
                       std::to_string(2 * geometry.dimension) +
                       ", one for each side of the body.");
    if (configuration == ReferenceConfiguration::current)
      {
        if (!geometry.file.empty())
          problems.error("Geometry/File",
                         "The configuration current needs a grid of equal "
                         "rectangles: give a Box.");
        if (displacement_degree != 1 || rotation_degree != 1)
          problems.error(
            "Grid/Displacement degree",
            "The configuration current needs degree 1 for displacement and "
            "rotation: quadratic shape functions change their sign, and points "
            "that move through them lose their stiffness.");
      }
    else if (std::any_of(margin.begin(),
                         margin.end(),
                         [](const unsigned int n) { return n > 0; }))
      problems.error("Grid/Margin cells",
                     "Finite elements end where the body ends. Remove it, or "
                     "\"set Reference configuration = current\".");

    if (periodic_axis && !geometry.file.empty())
      problems.error("Grid/Periodic",
                     "Only the sides of a Box can be tied; this body comes "
                     "from a File.");
    if (periodic_axis && configuration == ReferenceConfiguration::current)
      problems.error("Grid/Periodic",
                     "Points that move cannot leave at one side and come back "
                     "at the other. Remove it, or \"set Reference "
                     "configuration = initial\".");

    if (sampling == StrainSampling::assumed &&
        displacement_degree != rotation_degree)
      problems.error("Grid/Strain sampling",
                     "\"assumed\" needs equal degrees of displacement and "
                     "rotation; here they are " +
                       std::to_string(displacement_degree) + " and " +
                       std::to_string(rotation_degree) +
                       ". Take \"full\" or change a degree.");
  }
} // namespace Riedel::Grid
