// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/analysis/band_meter.h>
#include <riedel/analysis/crossings.h>
#include <riedel/analysis/statistics.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Riedel::Analysis
{
  BandMeter::BandMeter(const BandMeasureOptions &options,
                       const TriangleSampler    &sampler,
                       const Raster             &raster,
                       const std::vector<Ridge> &ridges,
                       const double              maximum_reach)
    : options(options)
    , sampler(sampler)
    , raster(raster)
    , clearance(options.cut_clearance * options.grain_size)
    , crossings(find_crossings(ridges, clearance))
    , maximum_reach(maximum_reach)
  {}



  std::vector<unsigned char>
  BandMeter::undisturbed(const Ridge &ridge) const
  {
    std::vector<unsigned char> result;
    for (const RidgePoint &point : ridge.points)
      {
        bool good = !point.bridged;
        for (const Point &crossing : crossings)
          good = good && distance(point.position, crossing) >= clearance;
        good = good && raster.distance_to_outside(point.position, clearance) >=
                         clearance;
        result.push_back(good);
      }
    return result;
  }



  Line
  BandMeter::axis(const Ridge &ridge) const
  {
    const std::size_t                enough = 10;
    const std::vector<unsigned char> usable = undisturbed(ridge);

    std::vector<Point> good, all;
    for (std::size_t k = 0; k < ridge.points.size(); ++k)
      {
        if (usable[k])
          good.push_back(ridge.points[k].position);
        all.push_back(ridge.points[k].position);
      }
    return fit_line(good.size() >= enough ? good : all);
  }



  Point
  BandMeter::direction(const Ridge                      &ridge,
                       const std::vector<unsigned char> &usable,
                       const std::size_t                 k) const
  {
    const double      reach  = 15. * options.grain_size;
    const std::size_t enough = 5;

    std::vector<Point> near;
    for (std::size_t i = 0; i < ridge.points.size(); ++i)
      if (usable[i] &&
          distance(ridge.points[i].position, ridge.points[k].position) <= reach)
        near.push_back(ridge.points[i].position);
    return near.size() >= enough ? fit_line(near).direction :
                                   axis(ridge).direction;
  }



  ShearBand
  BandMeter::measure(const Ridge &ridge) const
  {
    ShearBand band;
    band.sign       = ridge.sign;
    band.length     = length(ridge);
    band.n_cuts     = 0;
    const Line line = axis(ridge);
    double     degree =
      std::atan2(line.direction[1], line.direction[0]) * 180. / M_PI;
    if (degree <= -90.)
      degree += 180.;
    if (degree > 90.)
      degree -= 180.;
    band.inclination = degree;

    std::vector<double> rotations;
    for (const RidgePoint &point : ridge.points)
      if (!point.bridged)
        if (const auto rotation = sampler.value(point.position))
          rotations.push_back(*rotation);
    band.rotation = median(rotations);

    double passed = 0.;
    band.centre   = ridge.points.back().position;
    for (std::size_t k = 1; k < ridge.points.size(); ++k)
      {
        passed +=
          distance(ridge.points[k - 1].position, ridge.points[k].position);
        if (passed >= 0.5 * band.length)
          {
            band.centre = ridge.points[k].position;
            break;
          }
      }
    return band;
  }



  std::vector<Cut>
  BandMeter::cuts(const Ridge &ridge) const
  {
    const std::vector<unsigned char> usable = undisturbed(ridge);

    std::vector<Cut> result;
    const double     cut_step = options.cut_spacing * options.grain_size;
    double           s        = 0.;
    double           next_cut = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < ridge.points.size(); ++k)
      {
        const Point &position = ridge.points[k].position;
        if (k > 0)
          s += distance(ridge.points[k - 1].position, position);
        if (!usable[k] || s < next_cut)
          continue;
        next_cut = s + (1. - 1e-6) * cut_step;
        result.push_back({position, normal_to(direction(ridge, usable, k))});
      }
    return result;
  }



  BandMeter::Widths
  BandMeter::widths(const std::vector<Cut> &cuts,
                    const TriangleSampler  &field,
                    const double            background,
                    const double            sign,
                    const double            half_length) const
  {
    const double        d50 = options.grain_size;
    std::vector<double> widths_50, widths_10;
    for (const Cut &cut : cuts)
      {
        const auto profile = [&](const double s) {
          auto value = mean_along(field,
                                  advance(cut.centre, s, cut.normal),
                                  normal_to(cut.normal),
                                  half_length,
                                  d50);
          if (value)
            *value = sign * (*value - background);
          return value;
        };
        const Thickness widths = cut_band(profile, maximum_reach, d50 / 8.);
        widths_50.push_back(widths.at_50);
        widths_10.push_back(widths.at_10);
      }
    const auto n = std::count_if(widths_50.begin(),
                                 widths_50.end(),
                                 [](const double w) { return !std::isnan(w); });
    return {{median(widths_50), median(widths_10)},
            static_cast<unsigned int>(n)};
  }
} // namespace Riedel::Analysis
