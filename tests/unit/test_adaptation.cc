// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/adaptation/activity.h>
#include <riedel/adaptation/cell_order.h>
#include <riedel/adaptation/fixed_regions.h>
#include <riedel/adaptation/grid_change.h>
#include <riedel/adaptation/initial_point_transfer.h>
#include <riedel/adaptation/marking.h>
#include <riedel/adaptation/record.h>

#include <deal.II/base/quadrature_lib.h>

#include <catch2/catch.hpp>

#include <functional>
#include <set>

#include "sand_body.h"

using namespace Riedel;

namespace
{
  using Cell = dealii::Triangulation<2>::cell_iterator;

  /// Activity by active cell index from a function of the cell's centre.
  std::vector<double>
  activity_of(const dealii::Triangulation<2>                        &tria,
              const std::function<double(const dealii::Point<2> &)> &function)
  {
    std::vector<double> result;
    for (const auto &cell : tria.active_cell_iterators())
      result.push_back(function(cell->center()));
    return result;
  }

  bool
  is_near(const dealii::Point<2> &x, const dealii::Point<2> &y)
  {
    return x.distance(y) < 1e-3;
  }

  /// Cells of 5 mm; one of them is active.
  const dealii::Point<2> active_cell(0.0375, 0.0175);

  double
  one_active(const dealii::Point<2> &x)
  {
    return is_near(x, active_cell) ? 2.0 : 0.0;
  }
} // namespace



TEST_CASE("An active cell and its buffer are refined by one level",
          "[adaptation]")
{
  Grid::Body<2> body(MPI_COMM_WORLD, SandBody::box(), SandBody::cells(16, 8));
  auto         &tria = body.triangulation();

  Adaptation::Limits limits;
  limits.finest_level  = 1;
  limits.buffer_layers = GENERATE(0u, 1u, 2u);
  REQUIRE(Adaptation::mark(tria, activity_of(tria, one_active), limits));
  tria.execute_coarsening_and_refinement();
  const unsigned int width = 2 * limits.buffer_layers + 1;
  CHECK(tria.n_active_cells() == 128 + 3 * width * width);

  // the buffer alone gives no reason for another change
  const auto children_active = [](const dealii::Point<2> &x) {
    return x.distance(active_cell) < 0.0025 ? 2.0 : 0.0;
  };
  CHECK_FALSE(
    Adaptation::mark(tria, activity_of(tria, children_active), limits));
}



TEST_CASE("Cells of the wanted size are not refined", "[adaptation]")
{
  Grid::Body<2> body(MPI_COMM_WORLD, SandBody::box(), SandBody::cells(16, 8));
  Adaptation::Limits limits;
  limits.finest_level = 3;
  limits.cell_size    = 0.005;
  auto &tria          = body.triangulation();
  CHECK_FALSE(Adaptation::mark(tria, activity_of(tria, one_active), limits));
  limits.cell_size = 0.0049;
  CHECK(Adaptation::mark(tria, activity_of(tria, one_active), limits));
}



TEST_CASE("Nearly active cells are refined with active ones only",
          "[adaptation]")
{
  Grid::Body<2> body(MPI_COMM_WORLD, SandBody::box(), SandBody::cells(16, 8));
  Adaptation::Limits limits;
  limits.finest_level  = 1;
  limits.buffer_layers = 0;
  auto      &tria      = body.triangulation();
  const auto row       = [&](const double most) {
    return activity_of(tria, [most](const auto &x) {
      return is_near(x, active_cell) ? most : (x[1] < 0.005 ? 0.9 : 0.0);
    });
  };
  CHECK_FALSE(Adaptation::mark(tria, row(0.9), limits));
  REQUIRE(Adaptation::mark(tria, row(1.1), limits));
  tria.execute_coarsening_and_refinement();
  CHECK(tria.n_active_cells() == 128 + 3 * 17);
}



TEST_CASE("Cells at rest become coarse again, with hysteresis", "[adaptation]")
{
  Grid::Body<2> body(MPI_COMM_WORLD, SandBody::box(), SandBody::cells(16, 8));
  auto         &tria = body.triangulation();
  Adaptation::Limits limits;
  limits.finest_level  = 1;
  limits.coarsen_below = 0.5;
  const auto all       = [&](const double value) {
    return activity_of(tria, [value](const auto &) { return value; });
  };
  REQUIRE(Adaptation::mark(tria, all(1.0), limits));
  tria.execute_coarsening_and_refinement();
  REQUIRE(tria.n_active_cells() == 512);

  CHECK_FALSE(Adaptation::mark(tria, all(0.6), limits));
  CHECK(Adaptation::mark(tria, all(0.4), limits));
  tria.execute_coarsening_and_refinement();
  CHECK(tria.n_active_cells() == 128);
  CHECK_FALSE(Adaptation::mark(tria, all(0.4), limits)); // not below the grid
}



TEST_CASE("A buffer does not become coarse at the next look", "[adaptation]")
{
  Grid::Body<2> body(MPI_COMM_WORLD, SandBody::box(), SandBody::cells(16, 8));
  auto         &tria = body.triangulation();
  Adaptation::Limits limits;
  limits.finest_level  = 1;
  limits.buffer_layers = GENERATE(1u, 2u);
  limits.coarsen_below = 1.0;
  REQUIRE(Adaptation::mark(tria, activity_of(tria, one_active), limits));
  tria.execute_coarsening_and_refinement();
  const auto children_active = [](const dealii::Point<2> &x) {
    return std::abs(x[0] - active_cell[0]) < 0.0025 &&
               std::abs(x[1] - active_cell[1]) < 0.0025 ?
             1.0 :
             0.0;
  };
  CHECK_FALSE(
    Adaptation::mark(tria, activity_of(tria, children_active), limits));
}



TEST_CASE("Regions meet the cells they overlap, not their neighbours",
          "[adaptation]")
{
  Grid::Body<2> body(MPI_COMM_WORLD, SandBody::box(), SandBody::cells(16, 8));
  Adaptation::Parameters<2> parameters;
  parameters.criteria = {Adaptation::Criterion::region};
  parameters.regions  = {
     {"two cells",
      dealii::BoundingBox<2>(
       {dealii::Point<2>(0.01, 0.01), dealii::Point<2>(0.02, 0.015)})}};
  parameters.zones_initially = true;
  Points::InitialStateParameters<2> initial;
  initial.zones    = {{"one cell",
                       dealii::BoundingBox<2>({dealii::Point<2>(0.0, 0.0),
                                               dealii::Point<2>(0.001, 0.001)}),
                       0.9}};
  const auto count = [&](const Adaptation::FixedRegions<2> &regions) {
    unsigned int n = 0;
    for (const auto &cell : body.triangulation().active_cell_iterators())
      n += regions.meet(cell);
    return n;
  };
  CHECK(count({parameters, initial}) == 3);
  parameters.zones_initially = false;
  CHECK(count({parameters, initial}) == 2);
  parameters.random_field_initially = true;
  initial.random_field.amplitude    = 0.05;
  CHECK(count({parameters, initial}) == 128);
}



TEST_CASE("Shear of simple shear is its angle, of a volume change little",
          "[adaptation]")
{
  const double shear[] = {0.0, 0.02, 0.0, 0.0};
  CHECK(Adaptation::shear_of<2>(shear) == Approx(0.02));
  const double turn[] = {0.0, 0.02, -0.02, 0.0};
  CHECK(Adaptation::shear_of<2>(turn) == Approx(0.0).margin(1e-15));
  // pure shear: e = diag(a, -a, 0)
  const double pure[] = {0.01, 0.0, 0.0, -0.01};
  CHECK(Adaptation::shear_of<2>(pure) == Approx(0.02));
}



namespace
{
  Points::InitialStateParameters<2>
  varied()
  {
    auto initial              = SandBody::pressed();
    initial.grain_unit_weight = 26e3;
    initial.random_field      = {0.1, 0.003, 7};
    return initial;
  }



  /// A body of sand with points whose states vary from place to place.
  struct Sand : SandBody
  {
    LinearAlgebra::Vector solution;
    std::vector<double>   relevant;

    Sand()
      : SandBody(MPI_COMM_WORLD, varied())
    {
      solution = space.owned_vector();
      for (const auto dof : space.owned())
        {
          const unsigned int i = space.local(dof);
          const auto        &x = space.nodes()[i];
          // quadratic: the element and its children have it exactly
          solution(dof) = 1e-2 * (1.0 + space.components()[i]) *
                          (x[0] - 3.0 * x[0] * x[1] + 2.0 * x[1] * x[1]);
        }
      solution.compress(dealii::VectorOperation::insert);
      update();
    }

    void
    update()
    {
      space.gather(solution, relevant);
      supports.rebuild(relevant, points);
    }

    void
    change()
    {
      Adaptation::InitialPointTransfer<2> transfer(body.triangulation(),
                                                   points,
                                                   supports.quadrature());
      Adaptation::change_grid(body.triangulation(),
                              space,
                              transfer,
                              {&solution});
      update();
    }

    double
    sum(const unsigned int slot) const
    {
      double result = 0.0;
      for (unsigned int p = 0; p < points.n_points(); ++p)
        result += points.row(p)[slot];
      return result;
    }

    /// Mass of the points in a box of the undeformed body.
    double
    mass_in(const dealii::Point<2> &lower, const dealii::Point<2> &upper) const
    {
      double result = 0.0;
      for (unsigned int p = 0; p < points.n_points(); ++p)
        {
          const auto &x = points.initial_position(p);
          if (x[0] > lower[0] && x[0] < upper[0] && x[1] > lower[1] &&
              x[1] < upper[1])
            result += points.row(p)[points.place.mass];
        }
      return result;
    }
  };
} // namespace



TEST_CASE("A change of grid keeps volume, mass and displacement",
          "[adaptation]")
{
  Sand         sand;
  const auto   place  = sand.points.place;
  const double mass   = sand.sum(place.mass);
  const double V_0    = sand.sum(place.initial_volume);
  const double V      = sand.sum(place.volume);
  const auto   stress = Adaptation::summed_stress(sand.points, MPI_COMM_WORLD);
  const double cell_mass = sand.mass_in({0.035, 0.015}, {0.04, 0.02});

  auto              &tria = sand.body.triangulation();
  Adaptation::Limits limits;
  limits.finest_level = 2;
  for (unsigned int round = 0; round < 2; ++round)
    {
      Adaptation::mark(tria,
                       activity_of(tria,
                                   [](const auto &x) {
                                     return x.distance(active_cell) < 0.003 ?
                                              2.0 :
                                              0.0;
                                   }),
                       limits);
      sand.change();
    }
  REQUIRE(tria.n_global_levels() == 3);
  CHECK(sand.points.n_points() == 9 * tria.n_active_cells());
  CHECK(sand.sum(place.mass) == Approx(mass).epsilon(1e-13));
  CHECK(sand.mass_in({0.035, 0.015}, {0.04, 0.02}) ==
        Approx(cell_mass).epsilon(1e-13));
  CHECK(sand.sum(place.initial_volume) == Approx(V_0).epsilon(1e-13));
  CHECK(sand.sum(place.volume) == Approx(V).epsilon(1e-12));
  CHECK(Adaptation::relative_change(
          stress, Adaptation::summed_stress(sand.points, MPI_COMM_WORLD)) <
        1e-4);
  for (unsigned int p = 0; p < sand.points.n_points(); ++p)
    {
      const auto  &x     = sand.points.initial_position(p);
      const double shape = x[0] - 3.0 * x[0] * x[1] + 2.0 * x[1] * x[1];
      REQUIRE(sand.points.row(p)[place.displacement] ==
              Approx(1e-2 * shape).epsilon(1e-10).margin(1e-16));
      REQUIRE(sand.points.row(p)[place.micro_rotation] ==
              Approx(3e-2 * shape).epsilon(1e-10).margin(1e-16));
    }

  // ids are unique
  std::set<dealii::types::particle_index> ids;
  for (unsigned int p = 0; p < sand.points.n_points(); ++p)
    ids.insert(sand.points.id(p));
  CHECK(ids.size() == sand.points.n_points());
  CHECK(*ids.rbegin() + 1 == sand.points.n_points());

  // and back
  limits.coarsen_below = 1.0;
  for (unsigned int round = 0; round < 2; ++round)
    {
      REQUIRE(Adaptation::mark(
        tria, activity_of(tria, [](const auto &) { return 0.0; }), limits));
      sand.change();
    }
  CHECK(tria.n_active_cells() == 128);
  CHECK(sand.sum(place.mass) == Approx(mass).epsilon(1e-13));
  CHECK(sand.mass_in({0.035, 0.015}, {0.04, 0.02}) ==
        Approx(cell_mass).epsilon(1e-13));
  CHECK(sand.sum(place.initial_volume) == Approx(V_0).epsilon(1e-13));
  CHECK(sand.sum(place.volume) == Approx(V).epsilon(1e-12));
}



TEST_CASE("New points have the state of the nearest old one", "[adaptation]")
{
  Sand               sand;
  const unsigned int e = sand.points.layout().find("void_ratio");
  std::vector<std::pair<dealii::Point<2>, double>> before;
  for (unsigned int p = 0; p < sand.points.n_points(); ++p)
    before.emplace_back(sand.points.initial_position(p), sand.points.row(p)[e]);

  auto              &tria = sand.body.triangulation();
  Adaptation::Limits limits;
  limits.finest_level  = 1;
  limits.buffer_layers = 0;
  Adaptation::mark(tria, activity_of(tria, one_active), limits);
  sand.change();
  for (unsigned int p = 0; p < sand.points.n_points(); ++p)
    {
      const auto &x       = sand.points.initial_position(p);
      double      closest = 1.0, value = 0.0;
      // of the same old cell
      for (const auto &[y, its_value] : before)
        if (std::floor(x[0] / 0.005) == std::floor(y[0] / 0.005) &&
            std::floor(x[1] / 0.005) == std::floor(y[1] / 0.005) &&
            x.distance(y) < closest - 1e-9)
          {
            closest = x.distance(y);
            value   = its_value;
          }
      REQUIRE(sand.points.row(p)[e] == value);
    }
}
