// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/analysis/band_meter.h>
#include <riedel/analysis/crossings.h>
#include <riedel/analysis/cuts.h>
#include <riedel/analysis/statistics.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Riedel::Analysis
{
  namespace
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  }



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
    band.spacing    = nan;
    band.void_ratio = nan;
    const Line line = axis(ridge);
    double     degree =
      std::atan2(line.direction[1], line.direction[0]) * 180. / M_PI;
    if (degree <= -90.)
      degree += 180.;
    if (degree > 90.)
      degree -= 180.;
    band.inclination = degree;

    const std::vector<unsigned char> usable = undisturbed(ridge);

    std::vector<double> rotations, widths_50, widths_10;
    const double        cut_step = options.cut_spacing * options.grain_size;
    double              s        = 0.;
    double              next_cut = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < ridge.points.size(); ++k)
      {
        const Point &position = ridge.points[k].position;
        if (k > 0)
          s += distance(ridge.points[k - 1].position, position);
        if (ridge.points[k].bridged)
          continue;
        if (const auto rotation = sampler.value(position))
          rotations.push_back(*rotation);
        if (!usable[k] || s < next_cut)
          continue;

        next_cut = s + (1. - 1e-6) * cut_step;
        const CutWidths widths =
          cut_band(sampler,
                   position,
                   normal_to(direction(ridge, usable, k)),
                   ridge.sign,
                   maximum_reach,
                   options.grain_size / 8.);
        widths_50.push_back(widths.at_50);
        widths_10.push_back(widths.at_10);
      }
    band.rotation     = median(rotations);
    band.thickness_50 = median(widths_50);
    band.thickness_10 = median(widths_10);
    band.n_cuts       = std::count_if(widths_50.begin(),
                                widths_50.end(),
                                [](const double w) { return !std::isnan(w); });

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
} // namespace Riedel::Analysis
