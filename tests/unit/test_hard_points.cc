// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/equilibrium/scheme.h>
#include <riedel/equilibrium/unseen_dofs.h>

#include <deal.II/base/mpi.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "moving_body.h"

using namespace Riedel;

/*
 * Points in places that have no inside and outside, and points that others do
 * not hold.
 */
namespace
{
  using Settings = MovingBody::Settings;



  Scene::Scene<2>
  read_removing(const std::string &file, const Settings &settings)
  {
    auto scene                         = MovingBody::read(file, settings);
    scene.moving_points.remove_leaving = true;
    return scene;
  }



  /// A body without those of its points that the test takes away.
  struct Moving : MovingBody
  {
    Moving(
      const std::string                                   &file,
      const Settings                                      &settings,
      const std::function<bool(const dealii::Point<2> &)> &is_finer =
        [](const dealii::Point<2> &) { return false; })
      : MovingBody(MPI_COMM_WORLD,
                   read_removing(file, settings),
                   refine_where(is_finer))
    {}

    /// Takes the points away of which a condition holds.
    void
    remove_where(const std::function<bool(const dealii::Point<2> &)> &condition)
    {
      for (unsigned int p = 0; p < points.n_points(); ++p)
        if (condition(points.position(p)))
          points.move(p, dealii::Point<2>(1e3, 1e3), space.frame());
      update();
    }

    /// Moves the nearest point of all ranks to each place; places by the ids
    /// of these points.
    std::map<dealii::types::particle_index, dealii::Point<2>>
    move_nearest_to(const std::vector<dealii::Point<2>> &places)
    {
      std::map<dealii::types::particle_index, dealii::Point<2>> result;
      for (const auto &place : places)
        {
          // of equally near ones the first
          using Candidate = std::pair<long long, dealii::types::particle_index>;
          Candidate nearest(std::numeric_limits<long long>::max(), 0);
          for (unsigned int p = 0; p < points.n_points(); ++p)
            if (result.count(points.id(p)) == 0)
              nearest =
                std::min(nearest,
                         Candidate(std::llround(
                                     1e9 * points.position(p).distance(place)),
                                   points.id(p)));
          for (const auto &other :
               dealii::Utilities::MPI::all_gather(MPI_COMM_WORLD, nearest))
            nearest = std::min(nearest, other);
          result[nearest.second] = place;
        }
      for (unsigned int p = 0; p < points.n_points(); ++p)
        if (result.count(points.id(p)) > 0)
          points.move(p, result.at(points.id(p)), space.frame());
      return result;
    }

    /// Solves a step from 0 to @p s and lets the points take it.
    Equilibrium::Outcome
    step(const double s)
    {
      make_balance();
      LinearAlgebra::Vector du = space.owned_vector();
      balance->begin_step(zero, 0.0, s);
      Equilibrium::Outcome outcome;
      outcome.residual = balance->predict_with_tangent(du);
      const auto scheme =
        Equilibrium::Scheme<2>::create(scene.solver, *balance);
      outcome = scheme->solve(*balance, du, true);
      if (outcome.converged)
        {
          std::vector<double> nodal;
          Equilibrium::continue_to_unseen(space,
                                          supports->supports().unseen_dofs,
                                          balance->prescribed_dofs(),
                                          balance->walls(s),
                                          du);
          space.gather(du, nodal);
          space.set_frame(balance->walls(s));
          supports->accept(zero, nodal, balance->point_increments(), points);
        }
      return outcome;
    }

    unsigned int
    n_points() const
    {
      return dealii::Utilities::MPI::sum(points.n_points(), MPI_COMM_WORLD);
    }

    /// Largest difference of the sum of a point's weights from 1, and of the
    /// mean of the nodes' places from the point's.
    struct Errors
    {
      double unity = 0.0, place = 0.0;
    };

    Errors
    weight_errors() const
    {
      Errors      errors;
      const auto &s = supports->supports();
      for (const auto &patch : s.patches)
        for (unsigned int q = 0; q < patch.n_points; ++q)
          {
            const double *weight =
              &s.weight[patch.first_weight + q * patch.n_nodes];
            double           sum = 0.0;
            dealii::Point<2> x;
            for (unsigned int a = 0; a < patch.n_nodes; ++a)
              {
                sum += weight[a];
                x += weight[a] * space.nodes()[s.dofs[patch.first_dof + a]];
              }
            errors.unity = std::max(errors.unity, std::abs(sum - 1.0));
            errors.place =
              std::max(errors.place,
                       x.distance(points.position(patch.first_point + q)));
          }
      return errors;
    }
  };
} // namespace



TEST_CASE("Points may lie on faces, edges, vertices and hanging nodes",
          "[points][hard][ranks]")
{
  const std::string shape    = GENERATE("generalised", "point");
  const std::string per_axis = GENERATE("1", "2");
  Moving            m("points/rotation_sand.prm",
           {"Material points/Shape=" + shape,
                       "Material points/Per axis=" + per_axis},
           [](const auto &x) { return x[0] > 0.0 && x[1] < 0.0; });
  // boxes of one point per cell are halved at once
  const unsigned int n_seeded = m.n_points() - m.points.n_split();
  // cells of 5 mm, of 2.5 mm at the right below
  const std::vector<dealii::Point<2>> places = {
    {0.0, 0.0},        // vertex of cells of both sizes
    {0.005, 0.005},    // vertex of coarse cells
    {0.0075, -0.0075}, // vertex of fine cells
    {0.0025, 0.0},     // hanging node
    {0.0, -0.0025},    // hanging node
    {0.0, -0.001},     // face between cells of both sizes
    {0.001, 0.0},      // the same
    {0.005, 0.0012},   // face of coarse cells
    {0.005, -0.0012},  // face of fine cells
    {-0.0025, 0.0025}, // centre of a coarse cell
    {0.0, std::nextafter(0.0, 1.0)},
    {std::nextafter(0.005, 0.0), 0.005},
    {std::nextafter(0.005, 1.0), std::nextafter(0.005, 0.0)}};
  const auto place_of = m.move_nearest_to(places);
  m.update();
  CHECK(m.points.n_removed() == 0);
  CHECK(m.n_points() == n_seeded + m.points.n_split() - m.points.n_merged());
  const auto errors = m.weight_errors();
  CHECK(errors.unity < 1e-14);
  CHECK(errors.place < 1e-14);

  // and from there on, by a linear field to another place, and back exactly
  m.make_balance();
  std::vector<double> nodal(m.zero.size());
  for (const double sign : {1.0, -1.0})
    {
      for (unsigned int i = 0; i < nodal.size(); ++i)
        nodal[i] = m.space.components()[i] < 2 ? sign * 0.0025 : 0.0;
      LinearAlgebra::Vector du = m.space.owned_vector(), r = du;
      for (const auto dof : m.space.owned())
        du(dof) = nodal[m.space.local(dof)];
      du.compress(dealii::VectorOperation::insert);
      m.balance->begin_step(m.zero, 0.0, 0.0);
      REQUIRE_FALSE(m.balance->residual(du, r).refused);
      m.supports->accept(m.zero,
                         nodal,
                         m.balance->point_increments(),
                         m.points);
      m.balance->supports_changed();
    }
  CHECK(m.points.n_removed() == 0);
  for (unsigned int p = 0; p < m.points.n_points(); ++p)
    if (place_of.count(m.points.id(p)) > 0 &&
        m.points.n_split() + m.points.n_merged() == 0)
      CHECK(m.points.position(p).distance(place_of.at(m.points.id(p))) < 1e-11);
}



TEST_CASE("Points may lie on the sides and corners of the grid",
          "[points][hard]")
{
  Moving             m("points/rotation_sand.prm", {});
  const unsigned int n = m.n_points();
  // the grid ends at 0.02 m
  const std::vector<dealii::Point<2>> places = {{0.02, 0.0011},
                                                {-0.02, 0.0011},
                                                {0.0011, 0.02},
                                                {0.0011, -0.02},
                                                {0.02, 0.005},
                                                {-0.005, -0.02},
                                                {0.02, 0.02},
                                                {-0.02, -0.02},
                                                {0.02, -0.02},
                                                {-0.02, 0.02}};
  for (unsigned int i = 0; i < places.size(); ++i)
    for (unsigned int p = 0; p < m.points.n_points(); ++p)
      if (m.points.id(p) == i)
        m.points.move(p, places[i], m.space.frame());
  m.update();
  CHECK(m.points.n_removed() == 0);
  CHECK(m.n_points() == n);
  CHECK(m.weight_errors().unity < 1e-14);
}



TEST_CASE("Halves of a long box at a wall stay before it", "[points][hard]")
{
  Moving m("points/rotation_sand.prm", {});
  m.make_supports(std::vector<bool>(4, true));
  const unsigned int n = m.n_points();
  // its box is 9 times as long as the cells are wide and held at the left end
  // of the grid, -0.02 m
  m.points.row(0)[m.points.place.deformation_gradient] = 18.0;
  m.points.move(0, dealii::Point<2>(-0.02 + 1e-5, 0.0011), m.space.frame());
  m.update();
  CHECK(m.points.n_split() > 1);
  CHECK(m.points.n_removed() == 0);
  CHECK(m.n_points() == n + m.points.n_split());
  for (unsigned int p = 0; p < m.points.n_points(); ++p)
    CHECK(m.points.position(p)[0] > -0.02);
}



namespace
{
  /// In the plane, of the points above a height [Pa].
  double
  largest_stress(const Moving &m, const double height = -1.0)
  {
    const unsigned int s       = m.points.layout().find("stress");
    double             largest = 0.0;
    for (unsigned int p = 0; p < m.points.n_points(); ++p)
      for (unsigned int i = 0; m.points.position(p)[1] > height && i < 5; ++i)
        if (i != 2) // 33
          largest = std::max(largest, std::abs(m.points.row(p)[s + i]));
    return dealii::Utilities::MPI::max(largest, MPI_COMM_WORLD);
  }
} // namespace



TEST_CASE("Two separate bodies do not feel each other", "[points][hard][ranks]")
{
  Moving m("hard/block.prm", {});
  m.remove_where([](const auto &x) { return std::abs(x[1]) < 0.005; });
  REQUIRE(m.n_points() == 32);
  const auto outcome = m.step(1.0);
  CAPTURE(outcome.failure);
  REQUIRE(outcome.converged);
  for (unsigned int p = 0; p < m.points.n_points(); ++p)
    {
      const double u = m.points.row(p)[m.points.place.displacement + 1];
      CHECK(u ==
            Approx(m.points.position(p)[1] > 0.0 ? -0.001 : 0.0).margin(1e-11));
    }
  CHECK(largest_stress(m) < 1e-8 * 1e6);
}



TEST_CASE("An isolated point is left alone, or the step is not solved",
          "[points][hard][ranks]")
{
  const std::string pressure = GENERATE("0", "1e3", "100e3"); // Pa
  Moving            m("hard/block.prm",
           {"Initial state/Vertical pressure at top=" + pressure});
  m.remove_where([](const auto &x) {
    return x[1] > -0.005 &&
           x.distance(dealii::Point<2>(0.00125, 0.00625)) > 1e-4;
  });
  REQUIRE(m.n_points() == 17);
  const auto outcome = m.step(1.0);
  INFO("pressure " << pressure << ": "
                   << (outcome.converged ? "solved" : outcome.failure)
                   << ", largest stress " << largest_stress(m, 0.0));
  // the body's foot is held and keeps some
  if (outcome.converged)
    CHECK(largest_stress(m, 0.0) < 1e-8 * 1e6);
  else
    {
      // nothing holds a point whose stress wants to expand it
      CHECK(pressure != "0");
      CHECK_FALSE(outcome.failure.empty());
    }
}



#ifndef DEBUG // deal.II's debug library ends the program by its own assertion
TEST_CASE("Points that a rank cannot send on are not lost silently",
          "[points][hard][ranks]")
{
  Moving m("points/rotation_sand.prm", {});
  // every point to the other end of the block
  for (unsigned int p = 0; p < m.points.n_points(); ++p)
    m.points.move(p, -1.0 * m.points.position(p), m.space.frame());
  const unsigned int n = m.n_points();
  if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1)
    {
      m.update();
      CHECK(m.n_points() == n);
    }
  else
    CHECK_THROWS_WITH(m.points.relocate(),
                      Catch::Contains("points have moved farther in one step"));
}
#endif
