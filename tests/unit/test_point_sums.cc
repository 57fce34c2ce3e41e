// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/analysis/deformed_field.h>
#include <riedel/analysis/shear_bands.h>
#include <riedel/points/point_sums.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <string>
#include <vector>

#include "moving_body.h"

using namespace Riedel;

namespace
{
  /**
   * The thickness at half of the rotation [m] that is measured on the grid of
   * tests/points/band.prm if its points have the rotation of a sech^2 band of
   * thickness @p width [m] through the middle, inclined by 45 degrees.
   */
  double
  measured_width(const double width, const unsigned int n_corrections)
  {
    MovingBody block(MPI_COMM_SELF, MovingBody::read("points/band.prm"));
    auto      &points = block.points;

    const double scale = 2.0 * std::acosh(std::sqrt(2.0)) / width;
    for (unsigned int p = 0; p < points.n_points(); ++p)
      {
        const auto   x = points.position(p) - block.body.extent().center();
        const double distance = (x[1] - x[0]) / std::sqrt(2.0);
        points.row(p)[points.place.micro_rotation] =
          0.3 / std::pow(std::cosh(scale * distance), 2);
      }
    Analysis::BandMeasureOptions options;
    options.grain_size = 0.5e-3;
    const auto bands   = Analysis::measure_shear_bands(
      Analysis::collect_deformed_field(
        block.space,
        Points::nodal_values(
          block.space, points, block.supports->supports(), n_corrections),
        points),
      options);
    REQUIRE(bands.bands.size() == 1);
    return bands.thickness_50;
  }
} // namespace



TEST_CASE("The field of the points shows a band as thick as it is", "[points]")
{
  const auto ratio = [](const double cells, const unsigned int n_corrections) {
    const double width = cells * 2.5e-3;
    return measured_width(width, n_corrections) / width;
  };
  for (const double cells : {3.0, 4.0, 6.0})
    {
      const double measured = ratio(cells, 1);
      INFO(cells << " cells thick: measured " << measured);
      CHECK(std::abs(measured - 1.0) < 0.02);
    }
  CHECK(std::abs(ratio(2.0, 1) - 1.0) < 0.06);
  // why: means alone are too wide, a full projection overshoots at the ridge
  CHECK(ratio(3.0, 0) > 1.05);
  CHECK(ratio(3.0, 5) < 0.95);
}
