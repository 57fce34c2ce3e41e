// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/analysis/geometry.h>
#include <riedel/analysis/shear_bands.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

using namespace Riedel::Analysis;

namespace
{
  const double grain_size = 0.5e-3; // [m]

  /// A straight band of known profile through the whole body.
  struct SyntheticBand
  {
    Point  through;     ///< [m]
    double inclination; ///< [deg]
    double rotation;    ///< largest rotation with sign [rad]
    double width;       ///< full width at half of the maximum [m]
    bool   sech;        ///< sech^2, otherwise a Gaussian
  };

  double
  profile(const SyntheticBand &band, const double distance)
  {
    if (band.sech)
      {
        const double x = distance / band.width * 2. * std::acosh(std::sqrt(2.));
        return band.rotation / std::pow(std::cosh(x), 2);
      }
    const double x = distance / band.width;
    return band.rotation * std::exp(-4. * std::log(2.) * x * x);
  }

  /// Full width at 10 % of the maximum [m].
  double
  width_10(const SyntheticBand &band)
  {
    if (band.sech)
      return band.width * std::acosh(std::sqrt(10.)) /
             std::acosh(std::sqrt(2.));
    return band.width * std::sqrt(std::log(10.) / std::log(2.));
  }

  double
  rotation_at(const std::vector<SyntheticBand> &bands, const Point &point)
  {
    double sum = 0.;
    for (const SyntheticBand &band : bands)
      sum += profile(band,
                     cross(unit_vector(band.inclination * M_PI / 180.),
                           vector_between(band.through, point)));
    return sum;
  }

  /// A body of @p width x @p height [m], square cells of @p cell [m] with four
  /// triangles each; the nodes moved by @p deform.
  template <typename Rotation, typename Deform>
  DeformedField
  make_field(const double    width,
             const double    height,
             const double    cell,
             const Rotation &rotation,
             const Deform   &deform)
  {
    const unsigned int nx = std::lround(width / cell);
    const unsigned int ny = std::lround(height / cell);
    DeformedField      field;
    const auto         add = [&](const double x, const double y) {
      field.nodes.push_back(deform(Point{{x * width / nx, y * height / ny}}));
      field.rotation.push_back(rotation(field.nodes.back()));
    };
    for (unsigned int j = 0; j <= ny; ++j)
      for (unsigned int i = 0; i <= nx; ++i)
        add(i, j);
    for (unsigned int j = 0; j < ny; ++j)
      for (unsigned int i = 0; i < nx; ++i)
        {
          const unsigned int middle = field.nodes.size();
          add(i + 0.5, j + 0.5);
          const unsigned int a = j * (nx + 1) + i, b = a + 1;
          const unsigned int c = b + nx + 1, d = a + nx + 1;
          for (const auto &[p, q] : {std::make_pair(a, b),
                                     std::make_pair(b, c),
                                     std::make_pair(c, d),
                                     std::make_pair(d, a)})
            field.triangles.push_back({{p, q, middle}});
        }
    return field;
  }

  Point
  undeformed(const Point &point)
  {
    return point;
  }

  ShearBands
  measure(const DeformedField &field)
  {
    BandMeasureOptions options;
    options.grain_size = grain_size;
    return measure_shear_bands(field, options);
  }

  /// Bands in a body of 100 x 60 mm.
  ShearBands
  measure(const std::vector<SyntheticBand> &bands, const double cell)
  {
    return measure(make_field(
      0.1,
      0.06,
      cell,
      [&](const Point &point) { return rotation_at(bands, point); },
      undeformed));
  }

  /**
   * Two bands from a weak spot at the left, half way up a body of 100 x 50 mm,
   * and their reflections at top and bottom, which cross.
   */
  std::vector<SyntheticBand>
  reflected_bands(const double inclination, const double width)
  {
    const double x = 0.025 / std::tan(inclination * M_PI / 180.);
    return {{{{0., 0.025}}, inclination, 0.30, width, false},
            {{{0., 0.025}}, -inclination, -0.30, width, false},
            {{{x, 0.}}, inclination, 0.25, width, false},
            {{{x, 0.05}}, -inclination, -0.25, width, false}};
  }

  DeformedField
  reflected_field(const std::vector<SyntheticBand> &bands, const double cell)
  {
    return make_field(
      0.1,
      0.05,
      cell,
      [&](const Point &point) { return rotation_at(bands, point); },
      undeformed);
  }

  /// Relative error is below @p limit.
  void
  check_close(const double value, const double expected, const double limit)
  {
    CAPTURE(value, expected);
    CHECK(std::abs(value - expected) < limit * std::abs(expected));
  }
} // namespace



TEST_CASE("width and inclination of one band", "[unit]")
{
  const bool   sech  = GENERATE(false, true);
  const double angle = GENERATE(-78., -45., -13., 0., 30., 52., 63.4, 90.);

  struct Resolution
  {
    double width, cell;
  };
  const auto resolution = GENERATE(Resolution{2.25e-3, 0.5e-3},
                                   Resolution{6e-3, 1.25e-3},
                                   Resolution{12.5e-3, 2.5e-3});
  CAPTURE(sech, angle, resolution.width, resolution.cell);

  const SyntheticBand band = {
    {{0.05, 0.031}}, angle, -0.2, resolution.width, sech};
  const ShearBands result = measure({band}, resolution.cell);
  REQUIRE(result.bands.size() == 1);

  const ShearBand &found = result.bands[0];
  CHECK(found.sign == -1.);
  CHECK(std::abs(found.inclination - angle) < 0.2);
  check_close(found.thickness.at_50, band.width, 0.02);
  check_close(found.thickness.at_10, width_10(band), 0.02);
  check_close(found.rotation, -0.2, 0.03);
  CHECK(found.n_cuts > 20);
  CHECK(std::isnan(found.spacing));

  // from boundary to boundary, but for what ends oblique ridges early
  const double radians = angle * M_PI / 180.;
  const double chord   = std::min(0.1 / std::abs(std::cos(radians)),
                                0.06 / std::abs(std::sin(radians)));
  CHECK(found.length > 0.9 * chord - 4. * grain_size);
  CHECK(found.length < 1.05 * chord);

  CHECK(result.thickness.at_50 == found.thickness.at_50);
  CHECK(result.thickness.at_10 == found.thickness.at_10);
  CHECK(result.inclination == std::abs(found.inclination));
}



TEST_CASE("width on a deformed triangulation", "[unit]")
{
  const SyntheticBand band = {{{0.05, 0.031}}, 55., 0.3, 5e-3, false};

  std::mt19937                           generator(3);
  std::uniform_real_distribution<double> random(-1., 1.);
  const auto                             deform = [&](const Point &point) {
    // barrelled, compressed towards the right, and shaken by up to 25 % of a
    // cell
    const double x = point[0] / 0.1, y = point[1] / 0.06 - 0.5;
    return Point{{0.1 * x * (1.2 - 0.3 * x) + 0.25e-3 * random(generator),
                  0.03 + 0.06 * y * (1. + 0.3 * x * (1. - x)) +
                    0.25e-3 * random(generator)}};
  };
  const ShearBands result = measure(make_field(
    0.1,
    0.06,
    1e-3,
    [&](const Point &point) { return rotation_at({band}, point); },
    deform));

  REQUIRE(result.bands.size() == 1);
  check_close(result.thickness.at_50, band.width, 0.02);
  check_close(result.thickness.at_10, width_10(band), 0.02);
  CHECK(std::abs(result.inclination - 55.) < 0.3);
}



TEST_CASE("slits between triangles do no harm", "[unit]")
{
  const SyntheticBand band  = {{{0.05, 0.031}}, 55., 0.3, 5e-3, false};
  const DeformedField whole = make_field(
    0.1,
    0.06,
    1.25e-3,
    [&](const Point &point) { return rotation_at({band}, point); },
    undeformed);

  // every triangle with nodes of its own, shrunk by 1 %
  DeformedField slit;
  for (const auto &triangle : whole.triangles)
    {
      Point centre = {{0., 0.}};
      for (const unsigned int node : triangle)
        centre = advance(centre, 1. / 3., whole.nodes[node]);
      const unsigned int first = slit.nodes.size();
      for (const unsigned int node : triangle)
        {
          slit.nodes.push_back(
            advance(centre, 0.99, vector_between(centre, whole.nodes[node])));
          slit.rotation.push_back(whole.rotation[node]);
        }
      slit.triangles.push_back({{first, first + 1, first + 2}});
    }

  const ShearBands result = measure(slit), expected = measure(whole);
  REQUIRE(result.bands.size() == 1);
  check_close(result.thickness.at_50, expected.thickness.at_50, 0.01);
  check_close(result.thickness.at_10, expected.thickness.at_10, 0.01);
  CHECK(result.bands[0].n_cuts + 5 > expected.bands[0].n_cuts);
}



TEST_CASE("four bands that cross and are reflected", "[unit]")
{
  const double angle = GENERATE(45., 50., 55.);
  const double width = GENERATE(2.25e-3, 4.5e-3, 6e-3);
  CAPTURE(angle, width);

  const auto       bands = reflected_bands(angle, width);
  const ShearBands result =
    measure(reflected_field(bands, width < 4e-3 ? 0.5e-3 : 1.25e-3));

  REQUIRE(result.bands.size() == 4);
  check_close(result.thickness.at_50, width, 0.02);
  check_close(result.thickness.at_10, width_10(bands[0]), 0.02);
  CHECK(std::abs(result.inclination - angle) < 0.5);

  // the lines of one sign are one height over tan(angle) apart, horizontally
  check_close(result.spacing, 0.05 * std::cos(angle * M_PI / 180.), 0.02);

  for (unsigned int b = 0; b < 4; ++b)
    {
      const ShearBand &band = result.bands[b];
      CAPTURE(b, band.length);
      // sign and inclination belong together
      CHECK(band.sign * band.inclination > 0.);
      CHECK(std::abs(std::abs(band.inclination) - angle) < 0.6);
      check_close(band.thickness.at_50, width, 0.025);
      check_close(band.rotation, band.sign * (b < 2 ? 0.25 : 0.30), 0.07);
      // a crossing does not cut a band: the crossed ones span the height
      const double chord =
        (b < 2 ? 0.05 : 0.025) / std::sin(angle * M_PI / 180.);
      CHECK(band.length < 1.05 * chord);
      CHECK(band.length > chord - 1.2 * width - 4. * grain_size);
    }
  CHECK(result.bands[0].sign == -result.bands[1].sign);
  CHECK(result.bands[2].sign == -result.bands[3].sign);
}



TEST_CASE("four bands on a grid as coarse as the bands", "[unit]")
{
  const double width = GENERATE(4.5e-3, 7e-3);
  const double angle = GENERATE(46., 50., 54.);
  CAPTURE(width, angle);

  const ShearBands result =
    measure(reflected_field(reflected_bands(angle, width), 5e-3));
  REQUIRE(result.bands.size() == 4);
  // linear interpolation itself widens bands narrower than a cell
  check_close(result.thickness.at_50, width, width < 5e-3 ? 0.3 : 0.1);
  CHECK(std::abs(result.inclination - angle) < 3.);
}



TEST_CASE("four wide bands", "[unit]")
{
  const double     cell  = GENERATE(1.25e-3, 2.5e-3, 5e-3);
  const double     width = 12.5e-3;
  const ShearBands result =
    measure(reflected_field(reflected_bands(45., width), cell));
  REQUIRE(result.bands.size() == 4);
  // where four bands overlap as much as this, each is thinner than alone
  check_close(result.thickness.at_50, width, 0.05);
  for (const ShearBand &band : result.bands)
    CHECK(band.n_cuts > 10);
}



TEST_CASE("bands of one sign that cross stay two", "[unit]")
{
  const double width = GENERATE(3e-3, 6e-3);
  CAPTURE(width);

  const ShearBands result = measure({{{{0.05, 0.03}}, 50., 0.2, width, false},
                                     {{{0.05, 0.03}}, -40., 0.2, width, false}},
                                    0.625e-3);
  REQUIRE(result.bands.size() == 2);
  for (const ShearBand &band : result.bands)
    {
      check_close(band.thickness.at_50, width, 0.02);
      check_close(band.rotation, 0.2, 0.02);
      CHECK(std::isnan(band.spacing));
    }
  // longest first
  CHECK(result.bands[0].inclination == Approx(-40.).margin(0.3));
  CHECK(result.bands[1].inclination == Approx(50.).margin(0.3));
}



TEST_CASE("spacing of parallel bands", "[unit]")
{
  const double distance = GENERATE(8e-3, 15e-3);
  const double angle    = GENERATE(-30., 48., 90.);
  CAPTURE(distance, angle);

  const Point      normal   = normal_to(unit_vector(angle * M_PI / 180.));
  const Point      centre   = {{0.05, 0.03}};
  const Point      beside   = advance(centre, distance, normal);
  const Point      opposite = advance(centre, -6e-3, normal);
  const ShearBands result   = measure({{centre, angle, 0.2, 3e-3, false},
                                       {beside, angle, 0.2, 3e-3, false},
                                       {opposite, angle, -0.2, 3e-3, false}},
                                    0.625e-3);
  REQUIRE(result.bands.size() == 3);
  unsigned int n_parallel = 0;
  for (const ShearBand &band : result.bands)
    if (band.sign > 0.)
      {
        check_close(band.spacing, distance, 0.02);
        ++n_parallel;
      }
    else
      CHECK(std::isnan(band.spacing));
  CHECK(n_parallel == 2);
  check_close(result.spacing, distance, 0.02);
}



TEST_CASE("a cut ends where the next band begins", "[unit]")
{
  // between the two the rotation falls to 42 %
  const double     width  = 4e-3;
  const ShearBands result = measure({{{{0.047, 0.03}}, 90., 0.2, width, false},
                                     {{{0.053, 0.03}}, 90., 0.2, width, false}},
                                    0.5e-3);
  REQUIRE(result.bands.size() == 2);
  for (const ShearBand &band : result.bands)
    {
      CHECK(band.n_cuts > 10);
      check_close(band.thickness.at_50, width, 0.1);
      CHECK(std::isnan(band.thickness.at_10));
    }
  CHECK(std::isnan(result.thickness.at_10));
}



TEST_CASE("cuts keep their distance from the boundary", "[unit]")
{
  const ShearBands result =
    measure({{{{0.05, 0.03}}, 90., 0.2, 3e-3, false}}, 0.625e-3);
  REQUIRE(result.bands.size() == 1);
  // 60 mm of height without 5 mm at both ends, every 1 mm
  CHECK(result.bands[0].n_cuts >= 50);
  CHECK(result.bands[0].n_cuts <= 51);
}



TEST_CASE("weak ridges do not count", "[unit]")
{
  const auto field =
    reflected_field({{{{0.03, 0.025}}, 50., 0.3, 4e-3, false},
                     {{{0.07, 0.025}}, 50., 0.09, 4e-3, false}},
                    1e-3);
  BandMeasureOptions options;
  options.grain_size = grain_size;
  CHECK(measure_shear_bands(field, options).bands.size() == 1);
  options.threshold = 0.2;
  CHECK(measure_shear_bands(field, options).bands.size() == 2);
  options.shortest = 0.08;
  CHECK(measure_shear_bands(field, options).bands.empty());
}



TEST_CASE("no band where there is none", "[unit]")
{
  const auto check_none = [](const double cell, const auto &rotation) {
    DeformedField field     = make_field(0.1, 0.05, cell, rotation, undeformed);
    field.points            = {{{0.02, 0.02}}, {{0.05, 0.02}}, {{0.07, 0.04}}};
    field.void_ratio        = {0.5, 0.6, 0.8};
    const ShearBands result = measure(field);
    CHECK(result.bands.empty());
    CHECK(std::isnan(result.thickness.at_50));
    CHECK(std::isnan(result.thickness.at_10));
    CHECK(std::isnan(result.inclination));
    CHECK(std::isnan(result.spacing));
    CHECK(std::isnan(result.void_ratio));
    CHECK(result.void_ratio_outside == 0.6);
    return result.largest_rotation;
  };

  SECTION("nothing rotates")
  {
    CHECK(check_none(2.5e-3, [](const Point &) { return 0.; }) == 0.);
  }
  SECTION("all rotates alike")
  {
    CHECK(check_none(1e-3, [](const Point &) { return -0.1; }) == 0.1);
  }
  SECTION("rotation grows towards one side")
  {
    check_none(1e-3, [](const Point &point) { return 3. * point[0]; });
  }
  SECTION("a band of rotations too small to mean anything")
  {
    const SyntheticBand band = {{{0.05, 0.03}}, 50., 9e-4, 4e-3, false};
    check_none(1e-3,
               [&](const Point &point) { return rotation_at({band}, point); });
  }
  SECTION("noise")
  {
    for (const double cell : {0.5e-3, 1.25e-3, 2.5e-3, 5e-3})
      {
        CAPTURE(cell);
        std::mt19937                     generator(5);
        std::normal_distribution<double> random(0., 0.1);
        check_none(cell, [&](const Point &) { return random(generator); });
      }
  }
}



TEST_CASE("bands in noise", "[unit]")
{
  // noise puts several ridges on the back of a wide band
  const double width = GENERATE(4.5e-3, 10e-3);
  CAPTURE(width);

  std::mt19937                           generator(7);
  std::uniform_real_distribution<double> noise(-0.03, 0.03);
  const auto                             bands  = reflected_bands(45., width);
  const ShearBands                       result = measure(make_field(
    0.1,
    0.05,
    1.25e-3,
    [&](const Point &point) {
      return rotation_at(bands, point) + noise(generator);
    },
    undeformed));
  REQUIRE(result.bands.size() == 4);
  check_close(result.thickness.at_50, width, 0.07);
  check_close(result.thickness.at_10, width_10(bands[0]), 0.07);
}



TEST_CASE("void ratio in and outside the bands", "[unit]")
{
  const double  spacing = GENERATE(0.6e-3, 1.25e-3, 2.5e-3);
  const auto    bands   = reflected_bands(50., 5e-3);
  DeformedField field   = reflected_field(bands, 1.25e-3);
  // only where most points are in bands, or the median over all would do
  for (double x = 0.5 * spacing; x < 0.042; x += spacing)
    for (double y = 0.5 * spacing; y < 0.05; y += spacing)
      {
        const double w = std::abs(rotation_at(bands, {{x, y}}));
        field.points.push_back({{x, y}});
        field.void_ratio.push_back(0.596 + 0.144 * std::min(1., w / 0.10));
      }
  // far from any point of interest, outside the body
  field.points.push_back({{-1., -1.}});
  field.void_ratio.push_back(99.);

  const ShearBands result = measure(field);
  REQUIRE(result.bands.size() == 4);
  CHECK(result.void_ratio == Approx(0.740).margin(0.001));
  CHECK(result.void_ratio_outside == Approx(0.596).margin(0.001));
  for (const ShearBand &band : result.bands)
    CHECK(band.void_ratio == Approx(0.740).margin(0.001));
}



namespace
{
  /// Material points like those of cells of @p cell [m], with the fields of
  /// bands of shear strain and, of another width, of the void ratio's change.
  void
  add_points(DeformedField                    &field,
             const std::vector<SyntheticBand> &shear,
             const std::vector<SyntheticBand> &change,
             const double                      height,
             const double                      cell,
             const unsigned int                per_axis)
  {
    // Gauss points are no lattice, nor are these
    const double distance = cell / per_axis;
    const auto   place    = [&](const unsigned int k) {
      return distance * (k + 0.5 + (k % per_axis ? -0.08 : 0.08));
    };
    const unsigned int nx = std::lround(0.1 / distance);
    const unsigned int ny = std::lround(height / distance);
    for (unsigned int j = 0; j < ny; ++j)
      for (unsigned int i = 0; i < nx; ++i)
        {
          const Point  point = {{place(i), place(j)}};
          const double gamma = rotation_at(shear, point);
          field.points.push_back(point);
          field.volume.push_back(distance * distance);
          // all the body is compressed before the bands form
          field.shear_strain.push_back(0.05 + std::abs(gamma));
          field.spin.push_back(0.5 * gamma);
          field.void_ratio_change.push_back(0.01 + rotation_at(change, point));
          field.void_ratio.push_back(0.6 + field.void_ratio_change.back());
          field.volume_strain.push_back(
            std::log1p(field.void_ratio_change.back() / 1.6));
          field.friction.push_back(40. - 20. * std::abs(gamma));
        }
  }
} // namespace



TEST_CASE("thickness of shear strain and void ratio", "[unit]")
{
  const bool         is_polar = GENERATE(true, false);
  const bool         sech     = GENERATE(false, true);
  const double       angle    = GENERATE(-78., -45., 13., 52., 90.);
  const unsigned int per_axis = GENERATE(2u, 3u);
  const double       cell     = 1.25e-3;
  CAPTURE(is_polar, sech, angle, per_axis);

  // that of the void ratio is wider, and of a sign of its own
  const double        dilates = GENERATE(1., -1.);
  const Point         through = {{0.05, 0.031}};
  const SyntheticBand shear   = {through, angle, -0.6, 6e-3, sech};
  const SyntheticBand change  = {through, angle, 0.1 * dilates, 8e-3, sech};
  const SyntheticBand turn    = {through, angle, -0.3, 5e-3, sech};

  DeformedField field = make_field(
    0.1,
    0.06,
    cell,
    [&](const Point &point) { return rotation_at({turn}, point); },
    undeformed);
  add_points(field, {shear}, {change}, 0.06, cell, per_axis);
  if (!is_polar)
    field.rotation.clear();
  const ShearBands result = measure(field);

  REQUIRE(result.bands.size() == 1);
  CHECK(result.bands[0].sign == -1.);
  CHECK(std::abs(result.bands[0].inclination - angle) < 0.2);
  check_close(result.shear_thickness.at_50, shear.width, 0.02);
  check_close(result.shear_thickness.at_10, width_10(shear), 0.02);
  check_close(result.void_ratio_thickness.at_50, change.width, 0.02);
  check_close(result.void_ratio_thickness.at_10, width_10(change), 0.02);
  CHECK(result.shear_strain_outside == Approx(0.05).margin(0.001));
  // of the points nearest to the ridge
  CHECK(result.shear_strain == Approx(0.65).margin(0.02));
  CHECK(result.friction == Approx(28.).margin(0.4));
  CHECK(result.volume_strain ==
        Approx(std::log1p((0.01 + 0.1 * dilates) / 1.6)).margin(0.002));
  CHECK(result.n_reflections == 0);
  if (is_polar)
    check_close(result.thickness.at_50, turn.width, 0.02);
  else
    {
      CHECK(std::isnan(result.thickness.at_50));
      CHECK(std::isnan(result.largest_rotation));
    }
}



TEST_CASE("four bands of a classical continuum", "[unit]")
{
  const double  angle = GENERATE(45., 55.);
  const auto    bands = reflected_bands(angle, 5e-3);
  DeformedField field = reflected_field(bands, 1.25e-3);
  field.rotation.clear();
  add_points(field, bands, bands, 0.05, 1.25e-3, 3);
  const ShearBands result = measure(field);

  REQUIRE(result.bands.size() == 4);
  check_close(result.shear_thickness.at_50, 5e-3, 0.02);
  CHECK(std::abs(result.inclination - angle) < 0.6);
  check_close(result.spacing, 0.05 * std::cos(angle * M_PI / 180.), 0.02);
  CHECK(result.n_reflections == 3);
}



TEST_CASE("homogeneous shear without rotation is no band", "[unit]")
{
  DeformedField field = make_field(
    0.1, 0.06, 2.5e-3, [](const Point &) { return 0.; }, undeformed);
  field.rotation.clear();
  add_points(field, {}, {}, 0.06, 2.5e-3, 2);
  // a zone that is stretched more than the rest
  for (std::size_t p = 0; p < field.points.size(); ++p)
    if (std::abs(field.points[p][0] - 0.05) < 0.01)
      field.shear_strain[p] = 0.3;
  const ShearBands result = measure(field);
  CHECK(result.bands.empty());
  CHECK(result.void_ratio_outside == Approx(0.61));
  CHECK(std::isnan(result.shear_thickness.at_50));
}



TEST_CASE("reflections of bands", "[unit]")
{
  const double angle = GENERATE(45., 55.);
  const double width = GENERATE(2.25e-3, 6e-3);
  const double cell  = width < 4e-3 ? 0.5e-3 : 1.25e-3;
  const auto   all   = reflected_bands(angle, width);
  // at the weak spot, at the top and at the bottom
  CHECK(measure(reflected_field(all, cell)).n_reflections == 3);
  // the band downwards from the weak spot, and its reflection
  CHECK(measure(reflected_field({all[1], all[2]}, cell)).n_reflections == 1);
  // bands of one sign do not reflect each other, nor do those that end apart
  CHECK(measure(reflected_field({all[0], all[2]}, cell)).n_reflections == 0);
  auto apart = all[2];
  apart.through[0] += 0.02;
  CHECK(measure(reflected_field({all[1], apart}, cell)).n_reflections == 0);
}



TEST_CASE("shear and rotation of a deformation gradient", "[unit]")
{
  // simple shear by 0.8 in a direction of 25 degrees, expanded, then rotated
  const double gamma = 0.8, turn = 0.7, factor = 1.3;
  const auto   product = [](const std::array<double, 4> &a,
                          const std::array<double, 4> &b) {
    return std::array<double, 4>{{a[0] * b[0] + a[1] * b[2],
                                  a[0] * b[1] + a[1] * b[3],
                                  a[2] * b[0] + a[3] * b[2],
                                  a[2] * b[1] + a[3] * b[3]}};
  };
  const Point                 m     = unit_vector(25. * M_PI / 180.);
  const std::array<double, 4> shear = {{factor * (1. - gamma * m[0] * m[1]),
                                        factor * gamma * m[0] * m[0],
                                        -factor * gamma * m[1] * m[1],
                                        factor * (1. + gamma * m[0] * m[1])}};
  const std::array<double, 4> R     = {
        {std::cos(turn), -std::sin(turn), std::sin(turn), std::cos(turn)}};
  CHECK(shear_strain(product(R, shear)) == Approx(gamma).epsilon(1e-12));
  CHECK(polar_rotation(product(R, shear)) ==
        Approx(turn - std::atan(gamma / 2.)).epsilon(1e-12));
  // small strains: their difference
  CHECK(shear_strain({{1.0001, 0., 0., 0.9998}}) == Approx(3e-4).epsilon(1e-3));
  CHECK(shear_strain(R) == Approx(0.).margin(1e-7));
}



TEST_CASE("bands need a grain size and complete fields", "[unit]")
{
  DeformedField field = reflected_field(reflected_bands(50., 5e-3), 5e-3);
  CHECK_THROWS_AS(measure_shear_bands(field, BandMeasureOptions()),
                  std::logic_error);

  // points without void ratios are no error, some without are
  field.points = {{{0.02, 0.02}}, {{0.05, 0.02}}};
  CHECK(std::isnan(measure(field).void_ratio_outside));
  field.void_ratio = {0.6};
  CHECK_THROWS_AS(measure(field), std::logic_error);

  field.void_ratio   = {0.6, 0.6};
  field.shear_strain = field.spin = {0.1, 0.1};
  CHECK_THROWS_AS(measure(field), std::logic_error); // no volumes
  field.shear_strain.clear();
  field.spin.clear();

  field.rotation.pop_back();
  CHECK_THROWS_AS(measure(field), std::logic_error);

  CHECK(measure(DeformedField()).bands.empty());
}
