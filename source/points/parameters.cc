// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/box.h>
#include <riedel/pattern.h>
#include <riedel/points/parameters.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <string>
#include <utility>
#include <vector>

namespace Riedel::Points
{
  using dealii::ParameterHandler;
  namespace Patterns  = dealii::Patterns;
  namespace Utilities = dealii::Utilities;

  void
  MovingPointsParameters::declare(ParameterHandler &prm)
  {
    prm.enter_subsection("Material points");
    prm.declare_entry("Shape",
                      "generalised",
                      Patterns::Selection("generalised|point"),
                      "What a point sees of the grid: \"generalised\" means "
                      "of the shape functions over a box that follows the "
                      "point's stretch (GIMP), \"point\" their values at its "
                      "place, for teaching and comparison. This section is for "
                      "the configuration current.");
    prm.declare_entry("Per axis",
                      "2",
                      Patterns::Integer(1, 20),
                      "Points of a cell along each axis at the start.");
    prm.declare_entry("Surface stabilisation",
                      "0.1",
                      Patterns::Double(0),
                      "Factor of the penalty on jumps of the gradient between "
                      "badly filled cells at the surface and their "
                      "neighbours, relative to the points' stiffness.");
    prm.declare_entry("Leaving points",
                      "stop",
                      Patterns::Selection("stop|remove"),
                      "What happens if a point leaves the grid: the run stops, "
                      "or the point is removed and counted.");
    prm.declare_entry("Merge above points per cell",
                      "12",
                      Patterns::Integer(0),
                      "In a cell with more points, neighbours whose boxes form "
                      "one box and whose states are near become one point, no "
                      "larger than the first points of such a cell; 0: never.");
    prm.declare_entry("Merge tolerance",
                      "0.05",
                      Patterns::Double(0, 1),
                      "States are near if their stresses, couple stresses over "
                      "the law's length, and void ratios differ by less than "
                      "this share of the stress and the void ratio.");
    prm.leave_subsection();
  }



  void
  MovingPointsParameters::parse(ParameterHandler &prm)
  {
    prm.enter_subsection("Material points");
    shape    = prm.get("Shape") == "point" ? Shape::point : Shape::generalised;
    per_axis = prm.get_integer("Per axis");
    surface_stabilisation = prm.get_double("Surface stabilisation");
    remove_leaving        = prm.get("Leaving points") == "remove";
    merge_above           = prm.get_integer("Merge above points per cell");
    merge_tolerance       = prm.get_double("Merge tolerance");
    prm.leave_subsection();
  }



  template <int dim>
  void
  InitialStateParameters<dim>::declare(
    ParameterHandler               &prm,
    const std::vector<std::string> &zone_names)
  {
    prm.enter_subsection("Initial state");
    prm.declare_entry("Void ratio",
                      "",
                      Patterns::List(Patterns::Double(0), 0, 1),
                      "Volume of the pores over volume of the grains, e.g. "
                      "0.60. Must be given.");
    prm.declare_entry("Vertical pressure at top",
                      "0",
                      Patterns::Double(0),
                      "Vertical stress at the top of the body, compression "
                      "positive [Pa].");
    prm.declare_entry("Grain unit weight",
                      "0",
                      Patterns::Double(0),
                      "Weight of the grains per volume of grains [N/m3]; 0: "
                      "no gravity.");
    prm.declare_entry("K0",
                      "1",
                      Patterns::Double(0),
                      "Horizontal over vertical stress, both horizontal "
                      "directions alike.");

    prm.enter_subsection("Zones");
    for (const std::string &name : zone_names)
      {
        prm.enter_subsection(name);
        prm.declare_entry("Box",
                          "",
                          FormPattern(box_form<dim>()),
                          "Lower left and upper right corner of the zone "
                          "[m]. Must be given.");
        prm.declare_entry("Void ratio",
                          "",
                          Patterns::List(Patterns::Double(0), 0, 1),
                          "Void ratio of the zone. The last of overlapping "
                          "zones counts. Must be given.");
        prm.leave_subsection();
      }
    prm.leave_subsection();

    prm.enter_subsection("Random field");
    prm.declare_entry("Amplitude",
                      "0",
                      Patterns::Double(),
                      "Added to the void ratio times a random number between "
                      "0.01 and 0.99; 0: no random field.");
    prm.declare_entry("Cell size",
                      "0",
                      Patterns::Double(0),
                      "Edge of the square cells of one random number each "
                      "[m]. They do not depend on the grid.");
    prm.declare_entry("Seed",
                      "1",
                      Patterns::Integer(0),
                      "Another number gives another field; the same number "
                      "the same field on every grid and number of ranks.");
    prm.leave_subsection();
    prm.leave_subsection();
  }



  namespace
  {
    /// A number that may be missing, then it is 0.
    double
    number(const std::string &text)
    {
      return text.empty() ? 0.0 : Utilities::string_to_double(text);
    }
  } // namespace



  template <int dim>
  void
  InitialStateParameters<dim>::parse(ParameterHandler               &prm,
                                     const std::vector<std::string> &zone_names)
  {
    prm.enter_subsection("Initial state");
    void_ratio        = number(prm.get("Void ratio"));
    pressure_at_top   = prm.get_double("Vertical pressure at top");
    grain_unit_weight = prm.get_double("Grain unit weight");
    K0                = prm.get_double("K0");

    zones.clear();
    prm.enter_subsection("Zones");
    for (const std::string &name : zone_names)
      {
        prm.enter_subsection(name);
        zones.push_back({name,
                         read_box<dim>(prm.get("Box"),
                                       "Initial state/Zones/" + name + "/Box"),
                         number(prm.get("Void ratio"))});
        prm.leave_subsection();
      }
    prm.leave_subsection();

    prm.enter_subsection("Random field");
    random_field.amplitude = prm.get_double("Amplitude");
    random_field.cell_size = prm.get_double("Cell size");
    random_field.seed      = prm.get_integer("Seed");
    prm.leave_subsection();
    prm.leave_subsection();
  }



  template <int dim>
  void
  InitialStateParameters<dim>::check(Problems &problems) const
  {
    const std::string section = "Initial state/";
    if (!(void_ratio > 0.0))
      problems.error(section + "Void ratio",
                     "A void ratio larger than 0 must be given, for example "
                     "\"set Void ratio = 0.60\".");
    if (!(K0 > 0.0))
      problems.error(section + "K0", "K0 must be larger than 0.");
    for (const Zone &zone : zones)
      if (!(zone.void_ratio > 0.0))
        problems.error(section + "Zones/" + zone.name + "/Void ratio",
                       "A zone needs a void ratio larger than 0.");

    const std::string field = section + "Random field/";
    if (random_field.amplitude != 0.0 && !(random_field.cell_size > 0.0))
      problems.error(field + "Cell size",
                     "A random field needs a cell size larger than 0 m.");
    if (void_ratio > 0.0 && void_ratio + random_field.amplitude <= 0.0)
      problems.error(field + "Amplitude",
                     "It is so negative that void ratios become negative.");
  }



  template struct InitialStateParameters<2>;
  template struct InitialStateParameters<3>;
} // namespace Riedel::Points
