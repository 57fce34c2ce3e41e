// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/adaptation/parameters.h>
#include <riedel/box.h>
#include <riedel/pattern.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <map>

namespace Riedel::Adaptation
{
  using dealii::ParameterHandler;
  namespace Patterns  = dealii::Patterns;
  namespace Utilities = dealii::Utilities;

  namespace
  {
    const std::map<std::string, Criterion> criterion_names = {
      {"rotation rate", Criterion::rotation_rate},
      {"shear rate", Criterion::shear_rate},
      {"void ratio change", Criterion::void_ratio_change},
      {"gradient jump", Criterion::gradient_jump},
      {"region", Criterion::region},
      {"points per cell", Criterion::points_per_cell}};

    const std::string zones = "zones", random_field = "random field";
  } // namespace



  template <int dim>
  void
  Parameters<dim>::declare(ParameterHandler               &prm,
                           const std::vector<std::string> &region_names)
  {
    prm.enter_subsection("Adaptation");
    prm.declare_entry(
      "Criteria",
      "",
      Patterns::List(Patterns::Selection(
                       "rotation rate|shear rate|void ratio change|"
                       "gradient jump|region|points per cell"),
                     0,
                     criterion_names.size()),
      "A cell where one of these holds is refined. Empty: the grid stays as it "
      "is.");
    prm.declare_entry(
      "Levels",
      "1",
      Patterns::Integer(0, 8),
      "How often a cell of the grid may be halved along each axis.");
    prm.declare_entry("Cell size",
                      "2.5",
                      Patterns::Double(0),
                      "Cells where a criterion holds are divided until their "
                      "edges are not longer than this [d50]; 0: as far as "
                      "Levels allows.");
    prm.declare_entry("Every steps",
                      "2",
                      Patterns::Integer(1),
                      "Steps between two looks at the criteria.");
    prm.declare_entry("Buffer layers",
                      "1",
                      Patterns::Integer(0, 10),
                      "Layers of cells that are refined around those where a "
                      "criterion holds.");
    prm.declare_entry(
      "Coarsen below",
      "0",
      Patterns::Double(0, 1),
      "The cells that were one become one again when no criterion reaches "
      "this share of its threshold in or next to them; 0: "
      "never.");
    prm.declare_entry("Coarsen every steps",
                      "20",
                      Patterns::Integer(1),
                      "Steps between two looks for cells that can become "
                      "coarse: it is never urgent, and each change costs.");
    prm.declare_entry(
      "Refine initially",
      "zones, random field",
      Patterns::List(Patterns::Selection(zones + "|" + random_field), 0, 2),
      "What is refined before the first step, and stays so: "
      "the zones of another void ratio; the whole body if it "
      "has a random field.");

    prm.enter_subsection("Thresholds");
    prm.declare_entry("Rotation rate",
                      "1.5",
                      Patterns::Double(0),
                      "Twice the rate of micro-rotation of a point, in "
                      "multiples of the nominal rate: the mean rate of shear "
                      "of the body.");
    prm.declare_entry("Shear rate",
                      "1.5",
                      Patterns::Double(0),
                      "Rate of shear of a point, in multiples of the nominal "
                      "rate.");
    prm.declare_entry("Void ratio change",
                      "0.02",
                      Patterns::Double(0),
                      "Change of a cell's void ratio since the start, of "
                      "either sign.");
    prm.declare_entry("Gradient jump",
                      "0.3",
                      Patterns::Double(0),
                      "Kelly's indicator of the rate of micro-rotation: how "
                      "much its slope jumps between a cell and its neighbours "
                      "over the size of the cell, in multiples of the nominal "
                      "rate.");
    prm.declare_entry("Points per cell",
                      "9",
                      Patterns::Integer(1),
                      "A cell with more material points is refined.");
    prm.leave_subsection();

    prm.enter_subsection("Regions");
    for (const std::string &name : region_names)
      {
        prm.enter_subsection(name);
        prm.declare_entry("Box",
                          "",
                          FormPattern(box_form<dim>()),
                          "Lower left and upper right corner, before the first "
                          "step [m]. Must be given.");
        prm.leave_subsection();
      }
    prm.leave_subsection();
    prm.leave_subsection();
  }



  template <int dim>
  void
  Parameters<dim>::parse(ParameterHandler               &prm,
                         const std::vector<std::string> &region_names)
  {
    prm.enter_subsection("Adaptation");
    criteria.clear();
    for (const auto &name : Utilities::split_string_list(prm.get("Criteria")))
      criteria.insert(criterion_names.at(name));
    levels          = prm.get_integer("Levels");
    cell_size       = prm.get_double("Cell size");
    every_steps     = prm.get_integer("Every steps");
    buffer_layers   = prm.get_integer("Buffer layers");
    coarsen_below   = prm.get_double("Coarsen below");
    coarsen_every   = prm.get_integer("Coarsen every steps");
    zones_initially = random_field_initially = false;
    for (const auto &name :
         Utilities::split_string_list(prm.get("Refine initially")))
      (name == zones ? zones_initially : random_field_initially) = true;

    prm.enter_subsection("Thresholds");
    thresholds.rotation_rate     = prm.get_double("Rotation rate");
    thresholds.shear_rate        = prm.get_double("Shear rate");
    thresholds.void_ratio_change = prm.get_double("Void ratio change");
    thresholds.gradient_jump     = prm.get_double("Gradient jump");
    thresholds.points_per_cell   = prm.get_integer("Points per cell");
    prm.leave_subsection();

    regions.clear();
    prm.enter_subsection("Regions");
    for (const std::string &name : region_names)
      {
        prm.enter_subsection(name);
        regions.push_back(
          {name,
           read_box<dim>(prm.get("Box"),
                         "Adaptation/Regions/" + name + "/Box")});
        prm.leave_subsection();
      }
    prm.leave_subsection();
    prm.leave_subsection();
  }



  template <int dim>
  void
  Parameters<dim>::check(const bool   micropolar,
                         const bool   has_void_ratio,
                         const double length,
                         const bool   points_move,
                         Problems    &problems) const
  {
    const std::string section = "Adaptation/";
    if (!regions.empty() && !has(Criterion::region))
      problems.error(section + "Criteria",
                     "There are Regions, but \"region\" is not among the "
                     "criteria.");
    if (!is_on())
      return;

    const auto refuse = [&](const std::string &why) {
      problems.error(section + "Criteria", why);
    };
    if (has(Criterion::region) && regions.empty())
      refuse("\"region\" needs a subsection of Adaptation/Regions with a "
             "Box.");
    if (!micropolar && has(Criterion::rotation_rate))
      refuse("\"rotation rate\" needs a law with micro-rotations.");
    if (!micropolar && has(Criterion::gradient_jump))
      refuse("\"gradient jump\" needs a law with micro-rotations.");
    if (!has_void_ratio && has(Criterion::void_ratio_change))
      refuse("\"void ratio change\" needs a law with a void ratio.");
    if (!points_move && has(Criterion::points_per_cell))
      refuse("\"points per cell\" has no effect on finite elements: all cells "
             "have the same number of points.");

    if (levels == 0)
      problems.error(section + "Levels",
                     "There are criteria, but no cell may be divided. Take 1 "
                     "or more, or leave Criteria empty.");
    if (cell_size > 0.0 && length == 0.0)
      problems.error(section + "Cell size",
                     "It is a multiple of d50, but no law of the scene has a "
                     "length. With \"set Cell size = 0\" cells are divided as "
                     "far as Levels allows.");

    const std::vector<std::pair<Criterion, std::pair<std::string, double>>>
      values = {{Criterion::rotation_rate,
                 {"Rotation rate", thresholds.rotation_rate}},
                {Criterion::shear_rate, {"Shear rate", thresholds.shear_rate}},
                {Criterion::void_ratio_change,
                 {"Void ratio change", thresholds.void_ratio_change}},
                {Criterion::gradient_jump,
                 {"Gradient jump", thresholds.gradient_jump}}};
    for (const auto &[criterion, threshold] : values)
      if (has(criterion) && !(threshold.second > 0.0))
        problems.error(section + "Thresholds/" + threshold.first,
                       "It must be larger than 0: the criterion would hold in "
                       "every cell.");
  }



  template struct Parameters<2>;
  template struct Parameters<3>;
} // namespace Riedel::Adaptation
