// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/analysis/mobilised_angles.h>
#include <riedel/continuum/mobilised_friction.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace Riedel::Analysis;

TEST_CASE("predicted angles of shear bands", "[unit]")
{
  const MobilisedAngles angles = {48., 16.};
  CHECK(coulomb_angle(angles) == 69.);
  CHECK(roscoe_angle(angles) == 53.);
  CHECK(arthur_angle(angles) == 61.);
  CHECK(std::isnan(roscoe_angle(MobilisedAngles())));
}



TEST_CASE("mobilised friction and dilatancy", "[unit]")
{
  // principal stresses 1 : 3 in any direction, and a skew part
  const double mean = -200., radius = 100.;
  for (const double angle : {0., 0.3, 1.2})
    {
      const double stress[5] = {mean + radius * std::cos(2. * angle),
                                mean - radius * std::cos(2. * angle),
                                -250.,
                                radius * std::sin(2. * angle) + 7.,
                                radius * std::sin(2. * angle) - 7.};
      CHECK(Riedel::Continuum::mobilised_friction(stress) == Approx(30.));
    }

  // a shear band that opens: tan psi = opening over slip
  CHECK(dilatancy_angle({{0., 0.4, 0., 0.4 * std::tan(0.2)}}) ==
        Approx(0.2 * 180. / M_PI));
  // plane strain compression; densification is negative
  CHECK(dilatancy_angle({{-1., 0., 0., 2.}}) ==
        Approx(std::asin(1. / 3.) * 180. / M_PI));
  CHECK(dilatancy_angle({{-2., 0., 0., 1.}}) ==
        Approx(-std::asin(1. / 3.) * 180. / M_PI));
  CHECK(std::isnan(dilatancy_angle(0., 0.)));
  CHECK(dilatancy_angle(1., 0.5) == Approx(90.));
}



TEST_CASE("dilatancy between two measurements", "[unit]")
{
  ShearBands before, now;
  before.volume_strain = 0.02;
  before.shear_strain  = 0.1;
  now.volume_strain    = 0.07;
  now.shear_strain     = 0.3;
  CHECK(std::isnan(dilatancy_inside(before, now)));
  now.bands.resize(1);
  CHECK(std::isnan(dilatancy_inside(before, now)));
  before.bands.resize(4);
  CHECK(dilatancy_inside(before, now) == Approx(std::asin(0.25) * 180. / M_PI));
}



TEST_CASE("angle of bands to the minor stress", "[unit]")
{
  ShearBands bands;
  bands.bands.resize(2);
  bands.bands[0].inclination = 35.;
  bands.bands[1].inclination = -35.;
  // compressed along axis 1: the minor stress acts along axis 2
  const std::array<double, 5> horizontal = {{-500., -100., -300., 0., 0.}};
  CHECK(angle_to_minor_stress(bands, horizontal) == Approx(55.));
  // compressed along axis 2
  const std::array<double, 5> vertical = {{-100., -500., -300., 0., 0.}};
  CHECK(angle_to_minor_stress(bands, vertical) == Approx(35.));
  // along a direction of 45 degrees: 10 and 80
  bands.bands.pop_back();
  const std::array<double, 5> oblique = {{-300., -300., -300., 100., 100.}};
  CHECK(angle_to_minor_stress(bands, oblique) == Approx(10.));
  bands.bands[0].inclination = -35.;
  CHECK(angle_to_minor_stress(bands, oblique) == Approx(80.));
}
