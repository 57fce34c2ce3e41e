// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/equilibrium/balance.h>
#include <riedel/grid/body.h>
#include <riedel/points/current_supports.h>
#include <riedel/scene/scene.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

/// A scene of tests/ whose points move, up to the supports at its start. Tests
/// then put the points where they want them.
struct MovingBody
{
  using Triangulation = dealii::parallel::distributed::Triangulation<2>;
  using Settings      = std::vector<std::string>;

  Riedel::Scene::Scene<2>                             scene;
  Riedel::Grid::Body<2>                               body;
  Riedel::Grid::Space<2>                              space;
  Riedel::Points::MaterialPoints<2>                   points;
  std::unique_ptr<Riedel::Points::CurrentSupports<2>> supports;
  /// of the last make_balance()
  std::unique_ptr<Riedel::Equilibrium::Balance<2>> balance;
  /// displacements at the relevant dofs
  std::vector<double> zero;
  Riedel::Timer       timer;

  static Riedel::Scene::Scene<2>
  read(const std::string &file, const Settings &settings = {})
  {
    return Riedel::Scene::read_scene<2>(std::string(RIEDEL_TEST_DIR) + "/" +
                                          file,
                                        settings);
  }

  /// @param refine refines the coarse grid
  MovingBody(
    const MPI_Comm                              communicator,
    Riedel::Scene::Scene<2>                     given,
    const std::function<void(Triangulation &)> &refine = [](Triangulation &) {})
    : scene(std::move(given))
    , body(communicator, scene.geometry, scene.grid)
    , space((refine(body.triangulation()), body.triangulation()),
            scene.grid,
            scene.materials.is_micropolar())
    , points(body.triangulation(), scene.materials, &scene.moving_points)
    , zero(space.relevant().n_elements(), 0.0)
  {
    space.set_frame(Riedel::Grid::Frame<2>(body.grid_extent()));
    make_supports();
    points.seed(supports->quadrature(), scene.initial_state, body.extent());
    supports->rebuild(zero, points);
  }

  /// With the present scene.moving_points.
  /// @param walls sides of the grid that hold points
  void
  make_supports(const std::vector<bool> &walls = std::vector<bool>(4, false))
  {
    supports = std::make_unique<Riedel::Points::CurrentSupports<2>>(
      space,
      scene.grid,
      scene.moving_points,
      walls,
      !scene.materials.materials.front().law->is_geometrically_linear());
  }

  /// After points have been moved.
  void
  update()
  {
    points.relocate();
    supports->rebuild(zero, points);
  }

  void
  make_balance()
  {
    balance = std::make_unique<Riedel::Equilibrium::Balance<2>>(
      scene.boundary_conditions,
      scene.plates,
      scene.loading,
      scene.solver,
      body,
      space,
      points,
      supports->supports(),
      timer);
  }
};



/// For MovingBody: refines once the cells whose centre a condition holds of.
inline std::function<void(MovingBody::Triangulation &)>
refine_where(const std::function<bool(const dealii::Point<2> &)> &condition)
{
  return [condition](MovingBody::Triangulation &triangulation) {
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned() && condition(cell->center()))
        cell->set_refine_flag();
    triangulation.execute_coarsening_and_refinement();
  };
}
