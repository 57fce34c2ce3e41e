// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/equilibrium/plates.h>
#include <riedel/grid/body.h>
#include <riedel/points/support_builder.h>
#include <riedel/scene/scene.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <map>

using namespace Riedel;

namespace
{
  /// The points of tests/contact/sliding.prm and their plate.
  struct Block
  {
    explicit Block(const std::vector<std::string> &settings = {})
      : scene(Scene::read_scene<2>(RIEDEL_TEST_DIR "/contact/sliding.prm",
                                   settings))
      , body(MPI_COMM_WORLD, scene.geometry, scene.grid)
      , space(body.triangulation(), scene.grid, false)
      , points(body.triangulation(),
               scene.materials,
               &scene.moving_points,
               Equilibrium::Plates<2>::slots(scene.plates))
      , supports(Points::SupportBuilder<2>::create(space,
                                                   scene.grid,
                                                   scene.moving_points,
                                                   std::vector<bool>(4, false),
                                                   true))
    {
      space.set_frame(Grid::Frame<2>(body.grid_extent()));
      points.seed(supports->quadrature(), scene.initial_state, body.extent());
      supports->rebuild(zeros(), points);
    }

    std::vector<double>
    zeros() const
    {
      return std::vector<double>(space.relevant().n_elements(), 0.0);
    }

    /// A motion of the nodes that is different everywhere and at most
    /// @p scale [m].
    std::vector<double>
    some_motion(const double scale) const
    {
      auto du = zeros();
      for (unsigned int i = 0; i < du.size(); ++i)
        du[i] = scale * std::sin(37.0 * i + 0.3 * i * i);
      return du;
    }

    Scene::Scene<2>                            scene;
    Grid::Body<2>                              body;
    Grid::Space<2>                             space;
    Points::MaterialPoints<2>                  points;
    std::unique_ptr<Points::SupportBuilder<2>> supports;
  };
} // namespace



TEST_CASE("The tangent of contact is the derivative of its forces")
{
  Block                  block({"Plates/stamp/Displacement 1=2e-4 * s",
                                "Plates/stamp/Displacement 2=-3e-4 * s"});
  Equilibrium::Plates<2> plates(block.scene.plates, block.space, block.points);

  // a first step with all points in contact gives them tractions
  plates.rebuild(0.0);
  plates.move(0.0, 0.5);
  auto forces = block.zeros();
  plates.add_forces(block.zeros(), forces, {});
  plates.accept();
  REQUIRE(plates.reports()[0].n_contacts == 10);

  plates.rebuild(0.5);
  plates.move(0.5, 0.4); // it goes back: some points lose contact
  const auto du = block.some_motion(1.5e-4);

  std::map<std::pair<unsigned int, unsigned int>, double> matrix;
  plates.add_forces(
    du, forces, [&](const auto &dofs, const std::vector<double> &values) {
      for (unsigned int i = 0; i < dofs.size(); ++i)
        for (unsigned int j = 0; j < dofs.size(); ++j)
          matrix[{block.space.local(dofs[i]), block.space.local(dofs[j])}] +=
            values[i * dofs.size() + j];
    });
  const auto report = plates.reports()[0];
  INFO(report.n_contacts << " in contact, " << report.n_sliding << " slide");
  CHECK(report.n_contacts < 10);
  CHECK(report.n_sliding > 0);
  CHECK(report.n_sliding < report.n_contacts);

  double largest = 0.0, error = 0.0, asymmetry = 0.0;
  for (const auto &[place, value] : matrix)
    {
      largest = std::max(largest, std::abs(value));
      asymmetry =
        std::max(asymmetry,
                 std::abs(value - matrix[{place.second, place.first}]));
    }
  constexpr double step = 1e-9;
  for (unsigned int j = 0; j < du.size(); ++j)
    {
      auto ahead = du, behind = du, f_ahead = block.zeros(),
           f_behind = block.zeros();
      ahead[j] += step;
      behind[j] -= step;
      plates.add_forces(ahead, f_ahead, {});
      plates.add_forces(behind, f_behind, {});
      for (unsigned int i = 0; i < du.size(); ++i)
        {
          const auto   entry    = matrix.find({i, j});
          const double expected = entry == matrix.end() ? 0.0 : entry->second;
          error                 = std::max(error,
                           std::abs(-(f_ahead[i] - f_behind[i]) / (2 * step) -
                                    expected));
        }
    }
  CHECK(error < 1e-6 * largest);
  CHECK(asymmetry > 1e-2 * largest); // of sliding
}



TEST_CASE("A plate gives the points its force and moment")
{
  Block block(
    {"Plates/stamp/Displacement 1=0", "Plates/stamp/Displacement 2=-1e-4 * s"});
  Equilibrium::Plates<2> plates(block.scene.plates, block.space, block.points);
  plates.rebuild(0.0);
  plates.move(0.0, 1.0);
  auto forces = block.zeros();
  plates.add_forces(block.zeros(), forces, {});
  const auto report = plates.reports()[0];

  // k = 10 * 2 mu / (0.01 m), 2 mu = 0.8e6 Pa
  const double force = -10 * 0.8e6 / 0.01 * 1e-4 * 0.1;
  CHECK(report.force[1] == Approx(force));
  CHECK(report.force[0] == Approx(0.0).margin(1e-9));
  CHECK(report.moment[0] == Approx(0.05 * force));
  double sum = 0.0, moment = 0.0;
  for (unsigned int i = 0; i < forces.size(); ++i)
    if (block.space.components()[i] == 1)
      {
        sum += forces[i];
        moment += forces[i] * block.space.nodes()[i][0];
      }
  CHECK(sum == Approx(force));
  CHECK(moment == Approx(report.moment[0]));
}



TEST_CASE("A point meets the nearest face of a plate")
{
  // a narrow block beside, above or far from the body of 0.1 m x 0.1 m
  const auto report = [](const std::string &box, const std::string &motion) {
    Block                  block({"Plates/stamp/Box=" + box,
                                  "Plates/stamp/Displacement 1=" + motion + " * s",
                                  "Plates/stamp/Displacement 2=0",
                                  "Plates/stamp/Friction angle=0"});
    Equilibrium::Plates<2> plates(block.scene.plates,
                                  block.space,
                                  block.points);
    plates.rebuild(0.0);
    plates.move(0.0, 1.0);
    auto forces = block.zeros();
    plates.add_forces(block.zeros(), forces, {});
    return plates.reports()[0];
  };
  const auto from_right = report("0.1, 0.03 : 0.12, 0.07", "-1e-4");
  CHECK(from_right.n_contacts == 4);
  CHECK(from_right.force[0] < 0.0);
  CHECK(from_right.force[1] == 0.0);
  const auto from_left = report("-0.02, 0.03 : 0, 0.07", "1e-4");
  CHECK(from_left.force[0] == Approx(-from_right.force[0]));
  // half of a box is covered: half of its force
  const auto half = report("0.1, 0.035 : 0.12, 0.07", "-1e-4");
  CHECK(half.n_contacts == 4);
  CHECK(half.force[0] == Approx(3.5 / 4.0 * from_right.force[0]));
  CHECK(report("0.101, 0.03 : 0.12, 0.07", "-1e-4").n_contacts == 0);
  CHECK(report("0.1, 0.03 : 0.12, 0.07", "1e-4").n_contacts == 0);
}
