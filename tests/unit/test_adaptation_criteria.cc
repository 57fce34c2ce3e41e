// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/adaptation/activity.h>
#include <riedel/points/current_supports.h>
#include <riedel/scene/scene.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <string>
#include <vector>

#include "sand_body.h"

using namespace Riedel;

/*
 * The measures of the criteria over their thresholds, cell by cell
 * (doc/adaptation.md), where they are known.
 */
namespace
{
  struct Sand : SandBody
  {
    Adaptation::Parameters<2> parameters;

    Sand()
      : SandBody(MPI_COMM_SELF)
    {}

    /// Activities by cell, under increments of simple shear of angle @p shear
    /// and a rotation that is a function of the place.
    template <typename Rotation>
    std::vector<double>
    activity(const double shear, const Rotation &rotation) const
    {
      std::vector<double> increment;
      for (unsigned int i = 0; i < space.relevant().n_elements(); ++i)
        {
          const auto        &x = space.nodes()[i];
          const unsigned int c = space.components()[i];
          increment.push_back(c == 0 ? shear * x[1] :
                              c == 1 ? 0.0 :
                                       rotation(x));
        }
      return Adaptation::activity(parameters,
                                  Adaptation::FixedRegions<2>(parameters,
                                                              initial),
                                  space,
                                  points,
                                  supports.supports(),
                                  increment);
    }
  };
} // namespace



TEST_CASE("Kelly's criterion measures a kink of the rotation", "[adaptation]")
{
  Sand sand;
  sand.parameters.criteria = {Adaptation::Criterion::gradient_jump};
  const double threshold = sand.parameters.thresholds.gradient_jump = 0.3;
  const double shear = 1e-3, slope = 0.2, kink = 0.04, h = 0.005;
  const auto   activity = sand.activity(shear, [&](const auto &x) {
    return slope * std::abs(x[0] - kink);
  });
  // The slope jumps by 2 slope over one edge of the cells beside the kink:
  // eta^2 = D/24 (2 slope)^2 h, D the diagonal.
  const double eta = 2.0 * slope * std::sqrt(std::sqrt(2.0) * h / 24.0 * h);
  for (const auto &cell : sand.body.triangulation().active_cell_iterators())
    {
      const bool   is_beside = std::abs(cell->center()[0] - kink) < h;
      const double expected  = is_beside ? 2.0 * eta / shear / threshold : 0.0;
      CHECK(activity[cell->active_cell_index()] ==
            Approx(expected).epsilon(1e-5).margin(1e-6));
    }

  // a linear rotation has no kink, however steep
  for (const double value :
       sand.activity(shear, [&](const auto &x) { return 10.0 * slope * x[0]; }))
    CHECK(value < 1e-4);
}



TEST_CASE("The void ratio's criterion measures the change of a cell's volume",
          "[adaptation]")
{
  Sand sand;
  sand.parameters.criteria = {Adaptation::Criterion::void_ratio_change};
  double &threshold        = sand.parameters.thresholds.void_ratio_change;
  threshold                = 0.02;
  const unsigned int e     = sand.points.layout().find("void_ratio");
  // one cell dilates, another one contracts, a third changes its shape: half
  // of its points dilate as much as the others contract
  const unsigned int        dilating = 17, contracting = 40, mixed = 60;
  std::vector<unsigned int> n_seen(sand.body.triangulation().n_active_cells());
  const auto                set = [&](double *row, const double void_ratio) {
    // the grains keep their volume
    row[sand.points.place.volume] =
      row[sand.points.place.initial_volume] * (1.0 + void_ratio) / 1.6;
    row[e] = void_ratio;
  };
  for (unsigned int p = 0; p < sand.points.n_points(); ++p)
    {
      const unsigned int c = sand.points.cell(p);
      if (c == dilating)
        set(sand.points.row(p), 0.63);
      else if (c == contracting)
        set(sand.points.row(p), 0.59);
      else if (c == mixed)
        {
          // 2 x 2 or 3 x 3 points: opposite ones of equal volume
          const auto x = sand.points.initial_position(p);
          const auto d = x[0] - 0.005 * (std::floor(x[0] / 0.005) + 0.5);
          set(sand.points.row(p),
              0.6 + (std::abs(d) < 1e-9 ? 0.0 : std::copysign(0.05, d)));
        }
    }
  const auto activity =
    sand.activity(1e-3, [](const dealii::Point<2> &) { return 0.0; });
  for (unsigned int c = 0; c < activity.size(); ++c)
    {
      CAPTURE(c);
      CHECK(activity[c] == Approx(c == dilating    ? 0.03 / threshold :
                                  c == contracting ? 0.01 / threshold :
                                                     0.0)
                             .margin(1e-9));
    }
}



TEST_CASE("A cell is refined if it has more points than allowed",
          "[adaptation]")
{
  const unsigned int per_axis = GENERATE(3u, 4u);
  const auto         scene    = Scene::read_scene<2>(
    std::string(RIEDEL_TEST_DIR) + "/points/rotation_sand.prm",
    {"Material points/Per axis=" + std::to_string(per_axis),
                "Material points/Merge above points per cell=0"});
  Grid::Body<2>              body(MPI_COMM_SELF, scene.geometry, scene.grid);
  const Grid::Space<2>       space(body.triangulation(), scene.grid, true);
  Points::MaterialPoints<2>  points(body.triangulation(),
                                   scene.materials,
                                   &scene.moving_points);
  Points::CurrentSupports<2> supports(
    space, scene.grid, scene.moving_points, std::vector<bool>(4, false), true);
  const std::vector<double> zero(space.relevant().n_elements(), 0.0);
  points.seed(supports.quadrature(), scene.initial_state, body.extent());
  supports.rebuild(zero, points);

  Adaptation::Parameters<2> parameters;
  parameters.criteria = {Adaptation::Criterion::points_per_cell};
  parameters.thresholds.points_per_cell = 9;
  const auto activity =
    Adaptation::activity(parameters,
                         Adaptation::FixedRegions<2>(parameters,
                                                     scene.initial_state),
                         space,
                         points,
                         supports.supports(),
                         zero);
  unsigned int n_filled = 0, n_active = 0;
  for (const auto &cell : body.triangulation().active_cell_iterators())
    {
      const double here      = activity[cell->active_cell_index()];
      const bool   is_filled = body.extent().point_inside(cell->center());
      n_filled += is_filled;
      n_active += here >= 1.0;
      CHECK(here == Approx(is_filled ? per_axis * per_axis / 10.0 : 0.0));
    }
  CHECK(n_filled == 16);
  CHECK(n_active == (per_axis == 4 ? 16 : 0));
}
