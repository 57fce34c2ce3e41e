// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/adaptation/grain_size.h>
#include <riedel/nearest_name.h>
#include <riedel/scene/scene.h>

#include <algorithm>
#include <set>

namespace Riedel::Scene
{
  namespace
  {
    /// The body's box, for the rules that need to know where it is; only if
    /// its own rules hold.
    template <int dim>
    bool
    body_box(const Grid::GeometryParameters &geometry,
             dealii::BoundingBox<dim>       &box)
    {
      if (geometry.box.size() != dim || geometry.origin.size() != dim)
        return false;
      std::pair<dealii::Point<dim>, dealii::Point<dim>> corners;
      for (unsigned int d = 0; d < dim; ++d)
        {
          if (!(geometry.box[d] > 0.0))
            return false;
          corners.first[d]  = geometry.origin[d];
          corners.second[d] = geometry.origin[d] + geometry.box[d];
        }
      box = dealii::BoundingBox<dim>(corners);
      return true;
    }

    template <int dim>
    bool
    overlap(const dealii::BoundingBox<dim> &a,
            const dealii::BoundingBox<dim> &b)
    {
      for (unsigned int d = 0; d < dim; ++d)
        if (!(std::max(a.lower_bound(d), b.lower_bound(d)) <
              std::min(a.upper_bound(d), b.upper_bound(d))))
          return false;
      return true;
    }

    /// Zones and materials outside the body are slips of the pen.
    template <int dim>
    void
    check_places(const Scene<dim>               &scene,
                 const dealii::BoundingBox<dim> &body,
                 Problems                       &problems)
    {
      for (const auto &zone : scene.initial_state.zones)
        if (!overlap(zone.box, body))
          problems.error("Initial state/Zones/" + zone.name + "/Box",
                         "The zone lies outside the body.");
      for (const auto &region : scene.adaptation.regions)
        if (!overlap(region.box, body))
          problems.error("Adaptation/Regions/" + region.name + "/Box",
                         "The region lies outside the body.");
      for (const auto &material : scene.materials.materials)
        if (!material.everywhere && !overlap(material.box, body))
          problems.error("Materials/" + material.name + "/Box",
                         "The material lies outside the body.");
    }

    /// The last axis points upwards.
    template <int dim>
    Material::InitialState
    initial_state(const double vertical_pressure,
                  const double K0,
                  const double void_ratio)
    {
      Material::InitialState state;
      // no minus sign in front: it would make a zero a negative one
      const double vertical = 0.0 - vertical_pressure;
      for (unsigned int d = 0; d < 3; ++d)
        state.stress[d][d] = (d == dim - 1 ? 1.0 : K0) * vertical;
      state.void_ratio = void_ratio;
      return state;
    }

    /// Lets every law look at the states in which its points begin, at the
    /// highest and the lowest place it has.
    template <int dim>
    void
    check_initial_states(const Scene<dim>               &scene,
                         const dealii::BoundingBox<dim> *body,
                         Problems                       &problems)
    {
      const auto &initial = scene.initial_state;
      if (!(initial.void_ratio > 0.0) || !(initial.K0 > 0.0))
        return;
      const double unit_weight =
        initial.grain_unit_weight / (1.0 + initial.void_ratio);

      for (const auto &material : scene.materials.materials)
        {
          // depths below the top, where the stress is extreme
          std::vector<double> depths = {0.0};
          if (body != nullptr)
            {
              const double top = body->upper_bound(dim - 1);
              depths           = {0.0, top - body->lower_bound(dim - 1)};
              if (!material.everywhere)
                for (unsigned int end = 0; end < 2; ++end)
                  depths[end] =
                    std::clamp(top - (end == 0 ?
                                        material.box.upper_bound(dim - 1) :
                                        material.box.lower_bound(dim - 1)),
                               0.0,
                               top - body->lower_bound(dim - 1));
            }

          std::set<double> void_ratios = {initial.void_ratio};
          for (const auto &zone : initial.zones)
            if (material.everywhere || overlap(zone.box, material.box))
              void_ratios.insert(zone.void_ratio);
          if (initial.random_field.amplitude != 0.0)
            for (const double random : {0.01, 0.99})
              void_ratios.insert(initial.void_ratio +
                                 initial.random_field.amplitude * random);

          for (const double depth : depths)
            for (const double void_ratio : void_ratios)
              {
                material.law->check_initial(
                  initial_state<dim>(initial.pressure_at_top +
                                       unit_weight * depth,
                                     initial.K0,
                                     void_ratio),
                  "Initial state",
                  problems);
              }
        }
    }

    /// An element test needs one material and knows its own initial state.
    template <int dim>
    void
    check_element_test(const Scene<dim> &scene, Problems &problems)
    {
      const auto &test      = scene.element_test;
      const auto &materials = scene.materials.materials;
      test.check(problems);
      if (materials.size() > 1)
        problems.error("Materials",
                       "An element test needs exactly one material; there "
                       "are " +
                         std::to_string(materials.size()) + ".");
      if (materials.size() != 1)
        return;

      if (!test.material.empty() && test.material != materials[0].name)
        problems.error("Element test/Material",
                       "There is no material \"" + test.material +
                         "\"; the one of this file is \"" + materials[0].name +
                         "\".");
      if constexpr (dim == 2)
        test.check_law(*materials[0].law, problems);
      else
        problems.error("Simulation type",
                       "Element tests are for the laws of plane strain: set "
                       "Dimension = 2.");
      materials[0].law->check_initial(initial_state<dim>(test.vertical_pressure,
                                                         test.K0,
                                                         test.void_ratio),
                                      "Element test",
                                      problems);
    }

    /// A displacement across a side of the box and a pressure on it
    /// contradict each other.
    template <int dim>
    void
    check_pressures(const Scene<dim> &scene, Problems &problems)
    {
      const auto &names = scene.geometry.boundary_names;
      for (const auto &boundary : scene.boundary_conditions.boundaries)
        for (const auto &[id, name] : names)
          if (name == boundary.name && boundary.pressure.given() &&
              boundary.displacement[id / 2].given())
            problems.error("Boundary conditions/" + name + "/Pressure",
                           "It has no effect: Displacement " +
                             std::to_string(id / 2 + 1) +
                             " prescribes the motion across this boundary. "
                             "Remove one of the two.");
    }

    /// Plates push points that move and have boxes, from outside the body.
    template <int dim>
    void
    check_plates(const Scene<dim>               &scene,
                 const dealii::BoundingBox<dim> &body,
                 Problems                       &problems)
    {
      const auto &plates = scene.plates.plates;
      if (plates.empty())
        return;
      if (dim == 3)
        problems.error("Plates",
                       "Plates are for plane strain: set Dimension = 2, or "
                       "move a boundary of the body instead.");
      else if (scene.grid.configuration !=
               Grid::ReferenceConfiguration::current)
        problems.error("Plates",
                       "Plates push material points: \"set Reference "
                       "configuration = current\" in section Grid.");
      else if (scene.moving_points.shape != Points::Shape::generalised)
        problems.error("Plates",
                       "Plates touch the boxes of points: \"set Shape = "
                       "generalised\" in section Material points.");
      else if (!scene.materials.materials.empty() &&
               scene.materials.materials.front().law->is_geometrically_linear())
        problems.error("Plates",
                       "The points of a geometrically linear law do not move: "
                       "a plate would never meet them.");
      for (const auto &plate : plates)
        {
          const std::string section = "Plates/" + plate.name;
          if (overlap(plate.box, body))
            problems.error(section + "/Box",
                           "The plate lies in the body. It may touch it.");
        }
    }

    /// What the sides of a body cannot have when its points move through the
    /// grid.
    template <int dim>
    void
    check_sides_of_moving_points(const Scene<dim> &scene, Problems &problems)
    {
      if (scene.grid.configuration != Grid::ReferenceConfiguration::current ||
          scene.materials.materials.empty() ||
          scene.materials.materials.front().law->is_geometrically_linear())
        return;
      for (const auto &boundary : scene.boundary_conditions.boundaries)
        {
          const std::string path = "Boundary conditions/" + boundary.name;
          if (boundary.pressure.given() &&
              boundary.form == Equilibrium::LoadForm::surface_integral)
            problems.error(path + "/Load form",
                           "Points that move through the grid have no faces "
                           "to integrate over. Write \"virtual stress\".");
          for (const auto &[id, name] : scene.geometry.boundary_names)
            if (name == boundary.name && id < 2 * dim &&
                scene.grid.margin.size() == 2 * dim &&
                !scene.grid.ends_at(id) &&
                boundary.displacement[id / 2].given())
              problems.warning(
                path + "/Displacement " + std::to_string(id / 2 + 1),
                "The body does not reach this side of the grid: "
                "Grid/Margin cells has " +
                  std::to_string(scene.grid.margin[id]) +
                  " cells there. Set them to 0, or push the body "
                  "with one of the Plates.");
        }
    }



    /// A strain across the plane needs laws that know of it, and points whose
    /// boxes stay in the plane.
    template <int dim>
    void
    check_strain_33(const Scene<dim> &scene, Problems &problems)
    {
      if (!scene.loading.strain_33.given())
        return;
      if (scene.grid.configuration != Grid::ReferenceConfiguration::initial)
        problems.error("Loading/Strain 33",
                       "It is for finite elements: \"set Reference "
                       "configuration = initial\" in section Grid.");
      for (const auto &material : scene.materials.materials)
        if (!material.law->can_stretch_axis_3())
          problems.error("Loading/Strain 33",
                         "The law \"" + material.law->name() + "\" of \"" +
                           material.name + "\" is for plane strain only.");
    }



    template <int dim>
    void
    check_periodic(const Scene<dim> &scene, Problems &problems)
    {
      for (const auto &boundary : scene.boundary_conditions.boundaries)
        for (const auto &[id, name] : scene.geometry.boundary_names)
          if (name == boundary.name && scene.grid.is_periodic(id))
            problems.error("Boundary conditions/" + name,
                           "By Grid/Periodic this side is tied to the opposite "
                           "one and has no conditions of its own. Remove one "
                           "of the two.");
      if (scene.grid.periodic_axis && !scene.adaptation.criteria.empty())
        problems.error("Adaptation/Criteria",
                       "A periodic grid (Grid/Periodic) does not change. "
                       "Remove one of the two.");
    }
  } // namespace



  namespace
  {
    /// A measured opening controls the load in Newton's method.
    template <int dim>
    void
    check_opening(const Scene<dim> &scene, Problems &problems)
    {
      if (!scene.loading.opening.controls)
        return;
      if (scene.solver.scheme != Equilibrium::SchemeName::newton)
        problems.error("Loading/Control",
                       "The load factor of a measured opening is an unknown of "
                       "Newton's method: \"set Scheme = newton\" in section "
                       "Solver.");
      if (scene.loading.strain_33.given())
        problems.error("Loading/Strain 33",
                       "It must be known before the load factor is: not with "
                       "Control = opening.");
    }
  } // namespace



  template <int dim>
  void
  Scene<dim>::check(Problems &problems) const
  {
    general.check(problems);
    materials.check(problems);

    if (general.type == SimulationType::element_test)
      {
        check_element_test(*this, problems);
        return;
      }

    const bool micropolar = materials.is_micropolar();
    geometry.check(problems);
    grid.check(geometry, problems);
    initial_state.check(problems);
    boundary_conditions.check(geometry.names(), micropolar, problems);
    loading.check(micropolar, problems);
    check_strain_33(*this, problems);
    solver.check(problems);
    check_opening(*this, problems);
    output.check(problems);
    if (solver.linear_solver == Equilibrium::LinearSolverName::iterative &&
        micropolar && grid.displacement_degree != grid.rotation_degree)
      problems.error("Solver/Linear solver",
                     "The iterative solver needs nodes with all unknowns: give "
                     "displacement and rotation the same degree, or take "
                     "\"direct\".");
    adaptation.check(micropolar,
                     std::any_of(materials.materials.begin(),
                                 materials.materials.end(),
                                 [](const auto &material) {
                                   return material.law->layout().find(
                                            "void_ratio") !=
                                          Material::StateLayout::absent;
                                 }),
                     Adaptation::smallest_grain_size(materials),
                     /*points_move=*/grid.configuration !=
                       Grid::ReferenceConfiguration::initial,
                     problems);

    plates.check(geometry.names(), problems);

    auto watchable = geometry.names();
    for (const auto &plate : plates.plates)
      watchable.push_back(plate.name);
    if (!output.watch.empty() &&
        std::find(watchable.begin(), watchable.end(), output.watch) ==
          watchable.end())
      problems.error("Output/Watch",
                     "The body has no boundary" +
                       std::string(plates.plates.empty() ? "" : " or plate") +
                       " \"" + output.watch + "\"." +
                       did_you_mean(output.watch, watchable) +
                       (plates.plates.empty() ? "\nIts boundaries are: " :
                                                "\nThere are: ") +
                       enumerate(watchable) + ".");

    dealii::BoundingBox<dim> body;
    const bool               is_box = body_box(geometry, body);
    if (is_box)
      {
        check_places(*this, body, problems);
        check_pressures(*this, problems);
        check_sides_of_moving_points(*this, problems);
        check_periodic(*this, problems);
        check_plates(*this, body, problems);
      }
    if (is_box || !geometry.file.empty())
      check_initial_states(*this, is_box ? &body : nullptr, problems);
  }



  template void
  Scene<2>::check(Problems &) const;
  template void
  Scene<3>::check(Problems &) const;
} // namespace Riedel::Scene
