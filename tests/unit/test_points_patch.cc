// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/equilibrium/scheme.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "moving_body.h"

using namespace Riedel;

/*
 * The patch tests T1 and T2 (tests/points/patch.prm) with points whose boxes
 * lie anyhow in the grid.
 */
namespace
{
  struct Tile
  {
    dealii::Point<2>     centre;
    dealii::Tensor<1, 2> half_lengths;
  };



  /// Cuts between @p lower and @p upper at random distances, of which the
  /// largest is at most three times the smallest.
  std::vector<double>
  cuts(const double       lower,
       const double       upper,
       const unsigned int n,
       std::mt19937      &random)
  {
    std::uniform_real_distribution<double> width(1.0, 3.0);
    std::vector<double>                    result = {0.0};
    for (unsigned int i = 0; i < n; ++i)
      result.push_back(result.back() + width(random));
    for (double &cut : result)
      cut = lower + (upper - lower) * cut / result.back();
    // not beside it by rounding
    result.front() = lower;
    result.back()  = upper;
    return result;
  }



  /// @p n boxes that tile a body: columns of random width, each cut at random
  /// heights of its own.
  std::vector<Tile>
  tile(const dealii::BoundingBox<2> &body,
       const unsigned int            n,
       const unsigned int            seed)
  {
    const auto n_columns =
      static_cast<unsigned int>(std::lround(std::sqrt(1.7 * n)));
    std::mt19937      random(seed);
    std::vector<Tile> tiles;
    const auto        x =
      cuts(body.lower_bound(0), body.upper_bound(0), n_columns, random);
    for (unsigned int i = 0; i < n_columns; ++i)
      {
        const unsigned int here = n / n_columns + (i < n % n_columns);
        const auto         y =
          cuts(body.lower_bound(1), body.upper_bound(1), here, random);
        for (unsigned int j = 0; j < here; ++j)
          tiles.push_back(
            {dealii::Point<2>(0.5 * (x[i] + x[i + 1]), 0.5 * (y[j] + y[j + 1])),
             dealii::Tensor<1, 2>(
               {0.5 * (x[i + 1] - x[i]), 0.5 * (y[j + 1] - y[j])})});
      }
    return tiles;
  }



  /// What a patch test with given boxes differs from the exact solution.
  struct Errors
  {
    double stress = 0.0; ///< relative to 4 Pa
    double nodes  = 0.0; ///< relative to 1e-4 m and 1e-3 rad
    double volume = 0.0; ///< of the boxes, relative to the body
  };



  Errors
  run(const unsigned int test,
      const std::string &sampling,
      const bool         refine,
      const double       shift,
      const unsigned int seed)
  {
    std::vector<std::string> settings = {"Grid/Strain sampling=" + sampling};
    if (test == 2)
      {
        settings.push_back("Loading/Body couple=s");
        for (const std::string side : {"left", "right", "bottom", "top"})
          settings.push_back("Boundary conditions/" + side +
                             "/Rotation=0.75e-3 * s");
      }
    const auto refine_randomly = [&](MovingBody::Triangulation &triangulation) {
      std::mt19937 random(seed);
      for (unsigned int level = 0; refine && level < 2; ++level)
        refine_where([&](const dealii::Point<2> &) {
          return random() % 3 == 0;
        })(triangulation);
    };
    MovingBody  patch(MPI_COMM_SELF,
                     MovingBody::read("points/patch.prm", settings),
                     refine_randomly);
    auto       &points   = patch.points;
    const auto &body     = patch.body;
    const auto &space    = patch.space;
    const auto &solution = patch.zero;
    REQUIRE((space.hanging_nodes().n_constraints() > 0) == refine);

    // Points take the tiles in the order of their places.
    auto tiles = tile(body.extent(), points.n_points(), seed);
    REQUIRE(tiles.size() == points.n_points());
    std::vector<unsigned int> order(points.n_points());
    for (unsigned int p = 0; p < order.size(); ++p)
      order[p] = p;
    std::sort(order.begin(), order.end(), [&](const auto a, const auto b) {
      const auto x = points.position(a), y = points.position(b);
      return std::abs(x[0] - y[0]) > 1e-9 ? x[0] < y[0] : x[1] < y[1];
    });
    Errors errors;
    errors.volume = -1.0;
    for (unsigned int i = 0; i < order.size(); ++i)
      {
        double *row = points.row(order[i]);
        tiles[i].centre[0] += shift;
        const auto  &half         = tiles[i].half_lengths;
        const double area         = 4.0 * half[0] * half[1];
        const auto  &place        = points.place;
        row[place.initial_volume] = row[place.volume] = area;
        for (unsigned int d = 0; d < 2; ++d)
          row[place.half_length + d] = half[d];
        points.move(order[i], tiles[i].centre, space.frame());
        errors.volume += area / (0.24 * 0.12);
      }
    patch.update();
    REQUIRE(points.n_removed() == 0);

    patch.make_balance();
    auto &balance = *patch.balance;
    balance.begin_step(solution, 0.0, 1.0);
    LinearAlgebra::Vector du = space.owned_vector();
    balance.predict_with_tangent(du);
    const auto scheme =
      Equilibrium::Scheme<2>::create(patch.scene.solver, balance);
    REQUIRE(scheme->solve(balance, du, true).converged);

    std::vector<double> nodal;
    space.gather(du, nodal);
    const double rotation = test == 1 ? 0.25e-3 : 0.75e-3;
    for (unsigned int i = 0; i < nodal.size(); ++i)
      {
        const auto        &x       = space.nodes()[i];
        const double       value[] = {1e-3 * (x[0] + x[1] / 2),
                                      1e-3 * (x[0] + x[1]),
                                      rotation};
        const unsigned int c       = space.components()[i];
        errors.nodes =
          std::max(errors.nodes,
                   std::abs(nodal[i] - value[c]) / (c < 2 ? 1e-4 : 1e-3));
      }
    patch.supports->accept(solution, nodal, balance.point_increments(), points);
    const unsigned int stress      = points.layout().find("stress");
    const double       shear[2][2] = {{1.5, 1.5}, {2.0, 1.0}};
    for (unsigned int p = 0; p < points.n_points(); ++p)
      {
        const double *s = points.row(p) + stress;
        // 11, 22, 33, 12, 21
        errors.stress = std::max({errors.stress,
                                  std::abs(s[0] - 4.0) / 4.0,
                                  std::abs(s[1] - 4.0) / 4.0,
                                  std::abs(s[3] - shear[test - 1][0]) / 4.0,
                                  std::abs(s[4] - shear[test - 1][1]) / 4.0});
      }
    return errors;
  }
} // namespace



TEST_CASE("Patch tests are met by any boxes that tile the body", "[points]")
{
  for (const std::string sampling : {"full", "mean dilatation", "assumed"})
    for (const unsigned int test : {1, 2})
      for (const bool refine : {false, true})
        for (unsigned int seed = 1; seed < 4; ++seed)
          {
            const auto errors = run(test, sampling, refine, 0.0, seed);
            CAPTURE(sampling, test, refine, seed);
            CHECK(errors.stress < 1e-10);
            CHECK(errors.nodes < 1e-10);
            CHECK(std::abs(errors.volume) < 1e-12);
          }
}



TEST_CASE("Patch tests are not met by boxes that leave a gap", "[points]")
{
  // 1 mm of the outermost boxes lie outside the grid, on the other side
  // nothing is
  const auto errors = run(1, "full", false, 1e-3, 1);
  CHECK(errors.nodes > 1e-6);
}
