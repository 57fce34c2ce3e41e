// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/checkpoint/archive.h>
#include <riedel/checkpoint/checkpoints.h>
#include <riedel/errors.h>
#include <riedel/grid/body.h>
#include <riedel/points/initial_supports.h>
#include <riedel/scene/scene.h>

#include <deal.II/base/mpi.h>

#include <catch2/catch.hpp>

#include <algorithm>
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
  namespace Ranks = dealii::Utilities::MPI;

  /// A body with all that a checkpoint keeps of it.
  struct State
  {
    State(const MPI_Comm communicator, const Riedel::Scene::Scene<2> &scene)
      : body(communicator, scene.geometry, scene.grid)
      , space(body.triangulation(), scene.grid, scene.materials.is_micropolar())
      , points(body.triangulation(), scene.materials)
      , supports(space, scene.grid, true)
    {}

    Checkpoints<2>::Bodies
    bodies()
    {
      return {body.triangulation(), space, points, {&solution, &other}};
    }

    /// Refines the cell around a place.
    void
    refine(const dealii::Point<2> &place)
    {
      for (const auto &cell : body.triangulation().active_cell_iterators())
        if (cell->is_locally_owned() &&
            cell->bounding_box().point_inside(place))
          cell->set_refine_flag();
      body.triangulation().execute_coarsening_and_refinement();
    }

    /// Id, place and slots of the points of this rank, in their order.
    std::vector<std::vector<double>>
    all_points()
    {
      supports.rebuild(std::vector<double>(space.relevant().n_elements()),
                       points);
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

    /// A field that no two dofs have in common.
    double
    field(const dealii::types::global_dof_index dof) const
    {
      const unsigned int i = space.local(dof);
      return 1.0 / 3.0 + space.nodes()[i][0] + 10.0 * space.nodes()[i][1] +
             100.0 * space.components()[i];
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
      if (cell->is_locally_owned())
        ids.push_back(cell->id().to_string());
    return ids;
  }

  std::vector<double>
  values(const Vector &vector)
  {
    return {vector.begin(), vector.end()};
  }

  /// Do the dofs of this rank have the values of State::field()?
  void
  check_solution(const State &state)
  {
    double largest_error = 0.0;
    for (const auto dof : state.space.owned())
      largest_error =
        std::max(largest_error,
                 std::abs(state.solution(dof) - state.field(dof)));
    CHECK(largest_error < 1e-13);
    CHECK(state.other.size() == state.solution.size());
    CHECK(state.other.l2_norm() == 0.0);
  }

  /// All points of all ranks by their numbers, on rank 0.
  std::vector<std::vector<double>>
  gathered(const std::vector<std::vector<double>> &here,
           const MPI_Comm                          communicator)
  {
    std::vector<std::vector<double>> all;
    for (const auto &rows : Ranks::gather(communicator, here))
      all.insert(all.end(), rows.begin(), rows.end());
    std::sort(all.begin(), all.end());
    return all;
  }
} // namespace

// On several ranks, too: tests/CMakeLists.txt.
TEST_CASE("a checkpoint keeps an adapted grid, its dofs and points",
          "[unit][ranks]")
{
  const MPI_Comm world         = MPI_COMM_WORLD;
  const bool     is_first_rank = Ranks::this_mpi_process(world) == 0;
  const unsigned n_ranks       = Ranks::n_mpi_processes(world);
  const fs::path results       = fs::temp_directory_path() /
                           ("riedel_checkpoints_" + std::to_string(n_ranks));
  if (is_first_rank)
    fs::remove_all(results);
  const auto scene =
    Riedel::Scene::read_scene<2>(RIEDEL_TEST_DIR "/specimen/case.prm",
                                 {"Grid/Cells=4,2", "Grid/Refinements=1"});

  State first(world, scene);
  first.refine({0.030, 0.021});
  first.refine({0.071, 0.041});
  first.refine({0.030, 0.021});
  // a hole in the levels: its places are used again
  for (const auto &cell :
       first.body.triangulation().active_cell_iterators_on_level(2))
    if (cell->is_locally_owned() && cell->center()[0] > 0.05)
      cell->set_coarsen_flag();
  first.body.triangulation().execute_coarsening_and_refinement();
  first.refine({0.011, 0.011});
  REQUIRE(first.body.triangulation().n_global_levels() == 4);
  REQUIRE(first.body.triangulation().n_global_active_cells() == 50);

  first.space.distribute();
  first.points.seed(first.supports.quadrature(),
                    scene.initial_state,
                    first.body.extent());
  first.solution = first.space.owned_vector();
  for (const auto dof : first.space.owned())
    first.solution(dof) = first.field(dof);
  first.solution.compress(dealii::VectorOperation::insert);
  const auto saved_points = first.all_points();

  const std::vector<Setting> settings = {{"Grid/Cells", "4,2", "1"}};
  Parameters                 parameters;
  parameters.every_steps   = 3;
  parameters.every_minutes = 0.0;
  Checkpoints<2> writer(world, results.string(), parameters, settings);
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

  const auto read = [&](State &state, const Checkpoints<2> &reader) {
    const auto found = reader.find();
    CHECK(found.load == 0.25);
    CHECK(found.ranks == n_ranks);
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

  // into a body as a new run has it
  const Checkpoints<2> reader(world, results.string(), parameters, settings);
  State                second(world, scene);
  CHECK(read(second, reader).step == 6);
  check_solution(second);
  const auto loaded_points = second.all_points();
  CHECK(gathered(loaded_points, world) == gathered(saved_points, world));

  // the run that goes on reads it, too, and is then the same in every number
  // and every order
  read(first, writer);
  CHECK(active_cells(first) == active_cells(second));
  CHECK(values(first.solution) == values(second.solution));
  CHECK(first.all_points() == loaded_points);

  // on one rank, by every rank
  const Checkpoints<2> lonely_reader(MPI_COMM_SELF,
                                     results.string(),
                                     parameters,
                                     settings);
  State                alone(MPI_COMM_SELF, scene);
  read(alone, lonely_reader);
  check_solution(alone);
  const auto expected = gathered(saved_points, world);
  const auto ours     = gathered(alone.all_points(), MPI_COMM_SELF);
  if (is_first_rank)
    CHECK(ours == expected);

  // a damaged one is passed over
  MPI_Barrier(world);
  if (is_first_rank)
    fs::resize_file(results / "checkpoints" / "000006" / "grid", 100);
  const auto found = read(second, reader);
  CHECK(found.step == 3);
  REQUIRE(found.warnings.size() == 1);
  CHECK_THAT(found.warnings[0], Contains("grid has 100 bytes"));
  CHECK(second.all_points() == loaded_points);

  const Checkpoints<2> other(world,
                             results.string(),
                             parameters,
                             {{"Grid/Cells", "8,4", "1"}});
  CHECK_THROWS_WITH(other.find(),
                    Contains("Grid/Cells: \"4,2\" in the checkpoint, \"8,4\""));

  if (is_first_rank)
    fs::remove(results / "checkpoints" / "000003" / "state");
  CHECK_THROWS_AS(reader.find(), Riedel::InputError);
  CHECK_THROWS_WITH(reader.find(),
                    Contains("no checkpoint") && Contains("--overwrite") &&
                      Contains("state is missing"));
  if (is_first_rank)
    fs::remove_all(results);
}
