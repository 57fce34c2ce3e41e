// SPDX-License-Identifier: LGPL-2.1-or-later
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "moving_body.h"

using namespace Riedel;

namespace
{
  /// What a rigid motion has changed that it may not.
  struct Drift
  {
    double        stress = 0.0; ///< from the rotated one, relative to 100 kPa
    double        volume = 0.0; ///< relative
    double        place  = 0.0; ///< from the rotated one, relative to the block
    double        half_length = 0.0; ///< present from first, relative
    double        mass        = 0.0; ///< of the block, relative
    std::uint64_t n_split = 0, n_merged = 0;
  };



  /**
   * Turns the block of tests/points/rotation*.prm about its middle by @p angle
   * in @p n_steps steps and moves it back and forth through the grid at the
   * same time. The increments at the nodes are prescribed, nothing is solved:
   * what is tested is how points take them. @p finer: the right half of the
   * grid has cells of half the size, so that points go through hanging nodes,
   * are split there and merged behind.
   */
  Drift
  turn(const std::string &case_file,
       const std::string &sampling,
       const double       angle,
       const unsigned int n_steps,
       const bool         finer = false)
  {
    MovingBody block(MPI_COMM_SELF,
                     MovingBody::read("points/" + case_file,
                                      {"Grid/Strain sampling=" + sampling}),
                     refine_where([finer](const dealii::Point<2> &x) {
                       return finer && x[0] > 0.0;
                     }));
    block.make_balance();
    auto       &points     = block.points;
    auto       &supports   = *block.supports;
    auto       &balance    = *block.balance;
    const auto &space      = block.space;
    const auto &zero       = block.zero;
    double      whole_mass = 0.0;
    for (const auto &particle : points.particles())
      whole_mass += particle.get_properties()[points.place.mass];

    const double step = angle / n_steps;
    // the middle of the block goes along a circle of half a cell
    const auto middle = [&](const unsigned int n) {
      const double a = 2.0 * M_PI * n / n_steps;
      return dealii::Point<2>(0.0025 * std::sin(a),
                              0.0025 * (1.0 - std::cos(a)));
    };
    const auto rotation = [](const double a) {
      dealii::Tensor<2, 2> R;
      R[0][0] = R[1][1] = std::cos(a);
      R[1][0]           = std::sin(a);
      R[0][1]           = -R[1][0];
      return R;
    };
    const dealii::Tensor<2, 2> R  = rotation(step);
    LinearAlgebra::Vector      du = space.owned_vector(), r = du;
    std::vector<double>        nodal(zero.size());
    for (unsigned int n = 0; n < n_steps; ++n)
      {
        for (unsigned int i = 0; i < nodal.size(); ++i)
          {
            const auto         x = space.nodes()[i];
            const unsigned int c = space.components()[i];
            nodal[i] =
              c == 2 ? step : (middle(n + 1) + R * (x - middle(n)) - x)[c];
          }
        std::copy(nodal.begin(), nodal.end(), du.begin());
        balance.begin_step(zero, 0.0, 0.0);
        REQUIRE_FALSE(balance.residual(du, r).refused);
        supports.accept(zero, nodal, balance.point_increments(), points);
        balance.supports_changed();
      }

    dealii::Tensor<2, 2> sigma;
    sigma[0][0]          = -40e3;
    sigma[1][1]          = -100e3;
    const auto turned    = rotation(angle);
    sigma                = turned * sigma * transpose(turned);
    const unsigned int s = points.layout().find("stress");
    const unsigned int n_s =
      block.scene.materials.is_micropolar() ? 5 : 4; // 11, 22, 33, 12, 21
    Drift drift;
    drift.n_split  = points.n_split();
    drift.n_merged = points.n_merged();
    double mass    = 0.0;
    for (unsigned int p = 0; p < points.n_points(); ++p)
      {
        const double *row     = points.row(p);
        const double  exact[] = {
           sigma[0][0], sigma[1][1], -40e3, sigma[0][1], sigma[1][0]};
        for (unsigned int i = 0; i < n_s; ++i)
          drift.stress =
            std::max(drift.stress, std::abs(row[s + i] - exact[i]) / 100e3);
        const auto &place = points.place;
        drift.volume =
          std::max(drift.volume,
                   std::abs(row[place.volume] / row[place.initial_volume] -
                            1.0));
        mass += row[place.mass] / whole_mass;
        const auto             X = points.initial_position(p);
        const dealii::Point<2> x = middle(n_steps) + turned * (X - middle(0));
        drift.place =
          std::max(drift.place, x.distance(points.position(p)) / 0.02);
        for (unsigned int d = 0; d < 2; ++d)
          drift.half_length = std::max(drift.half_length,
                                       std::abs(points.half_lengths(row)[d] /
                                                  row[place.half_length + d] -
                                                1.0));
      }
    drift.mass = std::abs(mass - 1.0);
    return drift;
  }
} // namespace



TEST_CASE("A stressed block that turns only turns its stress", "[points]")
{
  for (const std::string file : {"rotation_hencky.prm", "rotation_sand.prm"})
    for (const std::string sampling : {"full", "mean dilatation", "assumed"})
      for (const unsigned int n_steps : {100, 1000})
        {
          const auto drift = turn(file, sampling, M_PI / 2.0, n_steps);
          INFO(file << ", " << sampling << ", " << n_steps << " steps: stress "
                    << drift.stress << ", volume " << drift.volume << ", place "
                    << drift.place << ", half edges " << drift.half_length);
          // rounding of H times stiffness over pressure, 10 and 1000
          const double stiffness = file == "rotation_sand.prm" ? 1e3 : 10.0;
          CHECK(drift.stress < 1e-15 * stiffness * n_steps);
          CHECK(drift.volume < 1e-14 * n_steps);
          CHECK(drift.place < 1e-14 * n_steps);
          CHECK(drift.half_length < 1e-14 * n_steps);
        }
}



TEST_CASE("A stressed block turns and moves through hanging nodes",
          "[points][hard]")
{
  for (const std::string file : {"rotation_hencky.prm", "rotation_sand.prm"})
    for (const std::string sampling : {"full", "assumed"})
      {
        const auto drift = turn(file, sampling, M_PI / 2.0, 1000, true);
        INFO(file << ", " << sampling << ": " << drift.n_split << " splits, "
                  << drift.n_merged << " merged; stress " << drift.stress
                  << ", volume " << drift.volume << ", place " << drift.place
                  << ", half edges " << drift.half_length << ", mass "
                  << drift.mass);
        const double stiffness = file == "rotation_sand.prm" ? 1e3 : 10.0;
        CHECK(drift.stress < 1e-15 * stiffness * 1000);
        CHECK(drift.volume < 1e-11);
        CHECK(drift.place < 1e-11);
        CHECK(drift.half_length < 1e-11);
        // Hencky's material has no weight
        CHECK((drift.mass < 1e-12 || std::isnan(drift.mass)));
        CHECK(drift.n_split > 0);
      }
}
