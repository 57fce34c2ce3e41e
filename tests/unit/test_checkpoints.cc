// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/checkpoint/archive.h>
#include <riedel/checkpoint/checkpoints.h>
#include <riedel/errors.h>
#include <riedel/grid/body.h>
#include <riedel/points/initial_supports.h>
#include <riedel/scene/scene.h>

#include <catch2/catch.hpp>

#include <filesystem>
#include <limits>

using Catch::Contains;
using Riedel::Checkpoint::Checkpoints;
using Riedel::Checkpoint::Parameters;
using Riedel::Checkpoint::Setting;
using Riedel::LinearAlgebra::Vector;
namespace fs = std::filesystem;

namespace
{
  /// A body with all that a checkpoint keeps of it.
  struct State
  {
    explicit State(const Riedel::Scene::Scene<2> &scene)
      : body(MPI_COMM_WORLD, scene.geometry, scene.grid)
      , space(body.triangulation(), scene.grid, scene.materials.is_micropolar())
      , points(body.triangulation(), scene.materials)
      , supports(space, scene.grid, true)
    {}

    Checkpoints<2>::Bodies
    bodies()
    {
      return {body.triangulation(), space, points, {&solution, &other}};
    }

    void
    refine_near(const dealii::Point<2> &place)
    {
      double                                         least = 1e300;
      dealii::Triangulation<2>::active_cell_iterator nearest;
      for (const auto &cell : body.triangulation().active_cell_iterators())
        if (cell->center().distance(place) < least)
          {
            least   = cell->center().distance(place);
            nearest = cell;
          }
      nearest->set_refine_flag();
      body.triangulation().execute_coarsening_and_refinement();
    }

    /// Id, place and slots of the points, in their order.
    std::vector<std::vector<double>>
    all_points()
    {
      supports.rebuild(points);
      std::vector<std::vector<double>> rows;
      for (unsigned int p = 0; p < points.n_points(); ++p)
        {
          rows.push_back({static_cast<double>(points.id(p)),
                          points.initial_position(p)[0],
                          points.initial_position(p)[1]});
          rows.back().insert(rows.back().end(),
                             points.row(p),
                             points.row(p) + points.layout().size());
        }
      return rows;
    }

    Riedel::Grid::Body<2>              body;
    Riedel::Grid::Space<2>             space;
    Riedel::Points::MaterialPoints<2>  points;
    Riedel::Points::InitialSupports<2> supports;
    Vector                             solution, other;
  };

  std::vector<std::string>
  active_cells(const State &state)
  {
    std::vector<std::string> ids;
    for (const auto &cell : state.space.dof_handler().active_cell_iterators())
      ids.push_back(cell->id().to_string());
    return ids;
  }

  std::vector<double>
  values(const Vector &vector)
  {
    return {vector.begin(), vector.end()};
  }
} // namespace

TEST_CASE("a checkpoint keeps an adapted grid, its dofs and points", "[unit]")
{
  const fs::path results = fs::temp_directory_path() / "riedel_checkpoints";
  fs::remove_all(results);
  const auto scene =
    Riedel::Scene::read_scene<2>(RIEDEL_TEST_DIR "/specimen/case.prm",
                                 {"Grid/Cells=4,2", "Grid/Refinements=1"});

  State first(scene);
  first.refine_near({0.03, 0.02});
  first.refine_near({0.07, 0.04});
  first.refine_near({0.03, 0.02});
  // a hole in the levels: its places are used again
  for (const auto &cell :
       first.body.triangulation().active_cell_iterators_on_level(2))
    if (cell->center()[0] > 0.05)
      cell->set_coarsen_flag();
  first.body.triangulation().execute_coarsening_and_refinement();
  first.refine_near({0.01, 0.01});
  REQUIRE(first.body.triangulation().n_levels() == 4);

  first.space.distribute();
  first.points.seed(first.supports.quadrature(),
                    scene.initial_state,
                    first.body.extent());
  first.solution = first.space.owned_vector();
  for (unsigned int i = 0; i < first.space.nodes().size(); ++i)
    first.solution.begin()[i] = 1.0 / 3.0 + first.space.nodes()[i][0] +
                                10.0 * first.space.nodes()[i][1] +
                                100.0 * first.space.components()[i];
  const auto saved_points = first.all_points();

  const std::vector<Setting> settings = {{"Grid/Cells", "4,2", "1"}};
  Parameters                 parameters;
  parameters.every_steps   = 3;
  parameters.every_minutes = 0.0;
  Checkpoints<2> writer(MPI_COMM_WORLD, results.string(), parameters, settings);
  CHECK_FALSE(writer.is_due(0));
  CHECK_FALSE(writer.is_due(2));
  CHECK(writer.is_due(3));
  CHECK_FALSE(writer.is_due_at_end(2, true));
  CHECK(writer.is_due_at_end(2, false));

  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  const auto   write        = [&](const unsigned int step) {
    const std::string state = Riedel::Checkpoint::pack(
      [&](auto &archive) { archive << first.points << not_a_number << step; });
    CHECK(writer.write(step, 0.25, state, first.bodies()).empty());
  };
  write(3);
  CHECK_FALSE(writer.is_due(3));
  CHECK(writer.is_due_at_end(4, true));
  write(6);

  // into a body as a new run has it
  const auto read = [&](State &state, const Checkpoints<2> &reader) {
    const auto found = reader.find();
    CHECK(found.load == 0.25);
    CHECK(found.ranks == 1);
    double       number = 0.0;
    unsigned int step   = 0;
    Riedel::Checkpoint::unpack(reader.read_state(found.name),
                               [&](auto &archive) {
                                 archive >> state.points >> number >> step;
                               });
    CHECK(number != number);
    CHECK(step == found.step);
    reader.read_bodies(found.name, state.bodies());
    return found;
  };
  const Checkpoints<2> reader(MPI_COMM_WORLD,
                              results.string(),
                              parameters,
                              settings);
  State                second(scene);
  CHECK(read(second, reader).step == 6);
  CHECK(second.space.dof_handler().n_dofs() ==
        first.space.dof_handler().n_dofs());
  double largest_error = 0.0;
  for (unsigned int i = 0; i < second.space.nodes().size(); ++i)
    largest_error = std::max(largest_error,
                             std::abs(second.solution.begin()[i] - 1.0 / 3.0 -
                                      second.space.nodes()[i][0] -
                                      10.0 * second.space.nodes()[i][1] -
                                      100.0 * second.space.components()[i]));
  CHECK(largest_error < 1e-13);
  CHECK(second.other.size() == second.solution.size());
  CHECK(second.other.l2_norm() == 0.0);
  auto loaded_points = second.all_points();
  CHECK(loaded_points.size() == saved_points.size());

  // the run that goes on reads it, too, and is then the same in every number
  // and every order
  read(first, writer);
  CHECK(active_cells(first) == active_cells(second));
  CHECK(values(first.solution) == values(second.solution));
  CHECK(first.all_points() == loaded_points);
  std::sort(loaded_points.begin(), loaded_points.end());
  auto sorted = saved_points;
  std::sort(sorted.begin(), sorted.end());
  CHECK(loaded_points == sorted);

  // a damaged one is passed over
  fs::resize_file(results / "checkpoints" / "000006" / "grid", 100);
  const auto found = read(second, reader);
  CHECK(found.step == 3);
  REQUIRE(found.warnings.size() == 1);
  CHECK_THAT(found.warnings[0], Contains("grid has 100 bytes"));
  CHECK(second.all_points() == first.all_points());

  const Checkpoints<2> other(MPI_COMM_WORLD,
                             results.string(),
                             parameters,
                             {{"Grid/Cells", "8,4", "1"}});
  CHECK_THROWS_WITH(other.find(),
                    Contains("Grid/Cells: \"4,2\" in the checkpoint, \"8,4\""));

  fs::remove(results / "checkpoints" / "000003" / "state");
  CHECK_THROWS_AS(reader.find(), Riedel::InputError);
  CHECK_THROWS_WITH(reader.find(),
                    Contains("no checkpoint") && Contains("--overwrite") &&
                      Contains("state is missing"));
  fs::remove_all(results);
}
