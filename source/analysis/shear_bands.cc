// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/analysis/band_meter.h>
#include <riedel/analysis/band_search.h>
#include <riedel/analysis/crossings.h>
#include <riedel/analysis/nodal_means.h>
#include <riedel/analysis/point_search.h>
#include <riedel/analysis/reflections.h>
#include <riedel/analysis/shear_bands.h>
#include <riedel/analysis/statistics.h>
#include <riedel/analysis/triangle_sampler.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

namespace Riedel::Analysis
{
  namespace
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();



    void
    check(const DeformedField &field, const BandMeasureOptions &options)
    {
      if (!(options.grain_size > 0.))
        throw std::logic_error(
          "measure_shear_bands: the grain size is not set");
      const auto fits = [](const std::vector<double> &values,
                           const std::size_t          n) {
        return values.empty() || values.size() == n;
      };
      const std::size_t n = field.points.size();
      if (!fits(field.rotation, field.nodes.size()) || !fits(field.volume, n) ||
          !fits(field.void_ratio, n) || !fits(field.void_ratio_change, n) ||
          !fits(field.volume_strain, n) || !fits(field.shear_strain, n) ||
          field.spin.size() != field.shear_strain.size() ||
          !fits(field.friction, n))
        throw std::logic_error(
          "measure_shear_bands: positions and values differ in number");
      if (field.volume.empty() &&
          !(field.shear_strain.empty() && field.void_ratio_change.empty()))
        throw std::logic_error("measure_shear_bands: points have no volume");
    }



    /// Sets the distances of parallel bands of one sign. Lines closer than 4
    /// d50 are pieces of one band.
    void
    measure_spacings(std::vector<ShearBand>   &bands,
                     const std::vector<Ridge> &ridges,
                     const std::vector<Line>  &axes,
                     const double              grain_size)
    {
      const double least_cosine = std::cos(10. * M_PI / 180.);
      for (std::size_t a = 0; a < bands.size(); ++a)
        for (std::size_t b = 0; b < bands.size(); ++b)
          {
            if (a == b || bands[a].sign != bands[b].sign ||
                std::abs(dot(axes[a].direction, axes[b].direction)) <
                  least_cosine)
              continue;
            const double spacing =
              normal_distance(ridges[a], axes[a], ridges[b]);
            if (spacing > 4. * grain_size)
              bands[a].spacing = std::fmin(bands[a].spacing, spacing);
          }
    }



    using Indices = std::set<std::size_t>;



    double
    median_at(const std::vector<double> &values, const Indices &indices)
    {
      std::vector<double> chosen;
      for (const std::size_t k : indices)
        if (!values.empty())
          chosen.push_back(values[k]);
      return median(chosen);
    }



    /// Medians over material points.
    void
    measure_points(const DeformedField &field,
                   const Indices       &points,
                   BandMeasures        &result)
    {
      result.void_ratio    = median_at(field.void_ratio, points);
      result.shear_strain  = median_at(field.shear_strain, points);
      result.volume_strain = median_at(field.volume_strain, points);
      result.friction      = median_at(field.friction, points);
    }



    /// The material points nearest to a ridge.
    Indices
    points_on(const Ridge       &ridge,
              const double       thickness,
              const PointSearch &search,
              const double       grain_size)
    {
      // points further off would show the flank, not the ridge
      const double limit = std::fmax(2. * grain_size, 0.25 * thickness);
      Indices      result;
      for (const RidgePoint &point : ridge.points)
        if (!point.bridged)
          if (const auto k = search.nearest(point.position, limit))
            result.insert(*k);
      return result;
    }



    /// Points where the @p indicator is small.
    Indices
    points_outside(const DeformedField   &field,
                   const TriangleSampler &indicator,
                   const double           most)
    {
      Indices result;
      for (std::size_t k = 0; k < field.points.size(); ++k)
        {
          const auto value = indicator.value(field.points[k]);
          if (value && std::abs(*value) < most)
            result.insert(k);
        }
      return result;
    }



    /// Sets the widths in a field of the points.
    void
    measure_thickness(const DeformedField       &field,
                      const TriangleSearch      &search,
                      const std::vector<double> &values,
                      const double               background,
                      const std::vector<Ridge>  &ridges,
                      const BandMeter           &meter,
                      const double               half_length,
                      Thickness BandMeasures::*member,
                      std::vector<ShearBand>  &bands)
    {
      if (values.empty())
        return;
      const auto            nodal = nodal_means(field, search, values);
      const TriangleSampler sampler(search, nodal);
      for (std::size_t b = 0; b < ridges.size(); ++b)
        {
          const auto          cuts = meter.cuts(ridges[b]);
          std::vector<double> excess;
          for (const Cut &cut : cuts)
            if (const auto value = sampler.value(cut.centre))
              excess.push_back(*value - background);
          const double sign = median(excess) < 0. ? -1. : 1.;
          bands[b].*member =
            meter.widths(cuts, sampler, background, sign, half_length)
              .thickness;
        }
    }



    /// Median of one measure over the bands.
    template <typename Measure>
    double
    median_over(const std::vector<ShearBand> &bands, const Measure &measure)
    {
      std::vector<double> values;
      for (const ShearBand &band : bands)
        values.push_back(measure(band));
      return median(values);
    }



    void
    take_medians(ShearBands &result)
    {
      const auto over_bands = [&](const auto &measure) {
        return median_over(result.bands, measure);
      };
      for (Thickness BandMeasures::*member :
           {&BandMeasures::thickness,
            &BandMeasures::shear_thickness,
            &BandMeasures::void_ratio_thickness})
        {
          (result.*member).at_50 = over_bands(
            [member](const ShearBand &band) { return (band.*member).at_50; });
          (result.*member).at_10 = over_bands(
            [member](const ShearBand &band) { return (band.*member).at_10; });
        }
      result.inclination = over_bands(
        [](const ShearBand &band) { return std::abs(band.inclination); });
      result.spacing =
        over_bands([](const ShearBand &band) { return band.spacing; });
    }
  } // namespace



  double
  shear_strain(const std::array<double, 4> &F)
  {
    const double J = F[0] * F[3] - F[1] * F[2];
    return std::sqrt(
      std::max((F[0] * F[0] + F[1] * F[1] + F[2] * F[2] + F[3] * F[3]) / J - 2.,
               0.));
  }



  double
  polar_rotation(const std::array<double, 4> &F)
  {
    return std::atan2(F[2] - F[1], F[0] + F[3]);
  }



  BandMeasures::BandMeasures()
    : thickness{nan, nan}
    , shear_thickness{nan, nan}
    , void_ratio_thickness{nan, nan}
    , inclination(nan)
    , spacing(nan)
    , void_ratio(nan)
    , shear_strain(nan)
    , volume_strain(nan)
    , friction(nan)
  {}



  ShearBands::ShearBands()
    : void_ratio_outside(nan)
    , shear_strain_outside(nan)
    , largest_rotation(nan)
  {}



  ShearBands
  measure_shear_bands(const DeformedField      &field,
                      const BandMeasureOptions &options)
  {
    check(field, options);

    ShearBands result;
    result.void_ratio_outside   = median(field.void_ratio);
    result.shear_strain_outside = median(field.shear_strain);
    for (const double rotation : field.rotation)
      result.largest_rotation =
        std::fmax(result.largest_rotation, std::abs(rotation));
    if (field.triangles.empty())
      return result;

    const TriangleSearch search(field);
    const auto           indicator = band_indicator(field, search);
    const bool           is_polar  = !field.rotation.empty();
    const double         least = (is_polar ? 1. : 2.) * options.least_rotation;
    double               largest = 0.;
    for (const double value : indicator)
      largest = std::max(largest, std::abs(value));
    if (largest < least)
      return result;

    const FoundBands found =
      find_bands(field, search, indicator, least, options);
    const auto &ridges = found.ridges;
    if (ridges.empty())
      return result;

    const double          d50 = options.grain_size;
    const TriangleSampler sampler(search, indicator);
    const BandMeter       meter(
      options, sampler, found.smooth, ridges, found.smoothing);
    auto             &bands = result.bands;
    std::vector<Line> axes;
    for (const Ridge &ridge : ridges)
      {
        bands.push_back(meter.measure(ridge));
        axes.push_back(meter.axis(ridge));
        const auto widths =
          meter.widths(meter.cuts(ridge), sampler, 0., ridge.sign, 0.);
        bands.back().n_cuts = widths.n_cuts;
        if (is_polar)
          bands.back().thickness = widths.thickness;
      }
    measure_spacings(bands, ridges, axes, d50);

    const double  half_length = options.mean_length * d50;
    const Indices outside =
      points_outside(field, sampler, 0.05 * found.reference);
    result.void_ratio_outside   = median_at(field.void_ratio, outside);
    result.shear_strain_outside = median_at(field.shear_strain, outside);
    measure_thickness(field,
                      search,
                      field.shear_strain,
                      result.shear_strain_outside,
                      ridges,
                      meter,
                      half_length,
                      &BandMeasures::shear_thickness,
                      bands);
    measure_thickness(field,
                      search,
                      field.void_ratio_change,
                      median_at(field.void_ratio_change, outside),
                      ridges,
                      meter,
                      half_length,
                      &BandMeasures::void_ratio_thickness,
                      bands);

    const PointSearch point_search(field, 2. * d50);
    Indices           on_any;
    for (std::size_t b = 0; b < ridges.size(); ++b)
      {
        const Indices on_band =
          points_on(ridges[b],
                    is_polar ? bands[b].thickness.at_50 :
                               bands[b].shear_thickness.at_50,
                    point_search,
                    d50);
        measure_points(field, on_band, bands[b]);
        on_any.insert(on_band.begin(), on_band.end());
      }
    measure_points(field, on_any, result);
    take_medians(result);

    const double thickness =
      is_polar ? result.thickness.at_50 : result.shear_thickness.at_50;
    result.n_reflections = count_reflections(
      ridges, search, d50, 10. * d50 + std::fmax(thickness, 0.));
    return result;
  }
} // namespace Riedel::Analysis
