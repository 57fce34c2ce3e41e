// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/analysis/band_meter.h>
#include <riedel/analysis/crossings.h>
#include <riedel/analysis/raster.h>
#include <riedel/analysis/ridge.h>
#include <riedel/analysis/shear_bands.h>
#include <riedel/analysis/statistics.h>
#include <riedel/analysis/triangle_sampler.h>
#include <riedel/analysis/void_ratio_samples.h>

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

    /// Bands make up at least this share of the length of all ridges.
    constexpr double least_share_of_bands = 0.6;

    /// Distance of raster points: half a grain, but a bounded number of them.
    double
    raster_spacing(const TriangleSampler &sampler, const double grain_size)
    {
      const double most_points = 3e5;
      const Point  size = vector_between(sampler.lower(), sampler.upper());
      return std::max(0.5 * grain_size,
                      std::sqrt(size[0] * size[1] / most_points));
    }



    /// Length of the edges [m] of triangles with rotations above @p level:
    /// median over their area.
    double
    edge_length(const DeformedField &field, const double level)
    {
      std::vector<std::array<double, 2>> length_and_area;
      double                             total = 0.;
      for (const auto &[a, b, c] : field.triangles)
        {
          if (std::abs(field.rotation[a]) < level &&
              std::abs(field.rotation[b]) < level &&
              std::abs(field.rotation[c]) < level)
            continue;
          const double area =
            0.5 *
            std::abs(cross(vector_between(field.nodes[a], field.nodes[b]),
                           vector_between(field.nodes[a], field.nodes[c])));
          length_and_area.push_back({{std::sqrt(2. * area), area}});
          total += area;
        }
      std::sort(length_and_area.begin(), length_and_area.end());
      double sum = 0.;
      for (const auto &[length, area] : length_and_area)
        if ((sum += area) >= 0.5 * total)
          return length;
      return 0.;
    }



    /// Is more of the line on the ridge than on bridges?
    bool
    is_mostly_ridge(const Ridge &ridge)
    {
      const auto bridged =
        std::count_if(ridge.points.begin(),
                      ridge.points.end(),
                      [](const RidgePoint &point) { return point.bridged; });
      return 2 * static_cast<std::size_t>(bridged) < ridge.points.size();
    }



    double
    total_length(const std::vector<Ridge> &ridges)
    {
      double sum = 0.;
      for (const Ridge &ridge : ridges)
        sum += length(ridge);
      return sum;
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



    /// Void ratios at the material points nearest to the ridges.
    void
    measure_void_ratio_inside(ShearBands               &result,
                              const std::vector<Ridge> &ridges,
                              const DeformedField      &field,
                              const double              grain_size)
    {
      const VoidRatioSamples samples(field, 2. * grain_size);
      std::set<std::size_t>  on_any;
      for (std::size_t b = 0; b < ridges.size(); ++b)
        {
          // points further off would show the flank, not the ridge
          const double limit =
            std::fmax(2. * grain_size, 0.25 * result.bands[b].thickness_50);
          std::set<std::size_t> on_band;
          for (const RidgePoint &point : ridges[b].points)
            if (!point.bridged)
              if (const auto k = samples.nearest(point.position, limit))
                on_band.insert(*k);
          std::vector<double> values;
          for (const std::size_t k : on_band)
            values.push_back(field.void_ratio[k]);
          result.bands[b].void_ratio = median(values);
          on_any.insert(on_band.begin(), on_band.end());
        }
      std::vector<double> values;
      for (const std::size_t k : on_any)
        values.push_back(field.void_ratio[k]);
      result.void_ratio_inside = median(values);
    }



    double
    measure_void_ratio_outside(const DeformedField   &field,
                               const TriangleSampler &sampler,
                               const double           most_rotation)
    {
      std::vector<double> values;
      for (std::size_t k = 0; k < field.points.size(); ++k)
        {
          const auto rotation = sampler.value(field.points[k]);
          if (rotation && std::abs(*rotation) < most_rotation)
            values.push_back(field.void_ratio[k]);
        }
      return median(values);
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
  } // namespace



  ShearBands
  measure_shear_bands(const DeformedField      &field,
                      const BandMeasureOptions &options)
  {
    if (!(options.grain_size > 0.))
      throw std::logic_error("measure_shear_bands: the grain size is not set");
    if (field.rotation.size() != field.nodes.size() ||
        (!field.void_ratio.empty() &&
         field.void_ratio.size() != field.points.size()))
      throw std::logic_error(
        "measure_shear_bands: positions and values differ in number");

    ShearBands result;
    result.thickness_50 = result.thickness_10 = nan;
    result.inclination = result.spacing = nan;
    result.void_ratio_inside            = nan;
    result.void_ratio_outside           = median(field.void_ratio);
    result.largest_rotation             = 0.;
    for (const double rotation : field.rotation)
      result.largest_rotation =
        std::max(result.largest_rotation, std::abs(rotation));
    if (field.triangles.empty() ||
        result.largest_rotation < options.least_rotation)
      return result;

    const double          d50 = options.grain_size;
    const TriangleSampler sampler(field);
    const Raster raster = rasterise(sampler, raster_spacing(sampler, d50));
    std::vector<double> magnitudes;
    for (std::size_t k = 0; k < raster.values.size(); ++k)
      if (raster.inside[k])
        magnitudes.push_back(std::abs(raster.values[k]));
    const double reference =
      quantile(std::move(magnitudes), options.percentile / 100.);
    const double level =
      std::max(options.threshold * reference, options.least_rotation);

    // enough smoothing to remove kinks between triangles and ripples on the
    // back of wide bands, not more: it serves to find the ridges, widths are
    // taken from the field itself
    const double kinks     = 0.5 * edge_length(field, level);
    const double ripples   = 0.12 * typical_width(raster, level);
    const double smoothing = std::max({d50, kinks, ripples, raster.spacing});

    const Raster       smooth        = smoothed(raster, smoothing);
    const RidgeOptions ridge_options = {d50, level, raster.spacing};
    std::vector<Ridge> ridges =
      join_collinear(trace_ridges(smooth, ridge_options),
                     smooth,
                     ridge_options);

    const double shortest      = std::max(options.shortest, 20. * d50);
    const double length_of_all = total_length(ridges);
    ridges.erase(std::remove_if(ridges.begin(),
                                ridges.end(),
                                [&](const Ridge &ridge) {
                                  return length(ridge) < shortest ||
                                         !is_mostly_ridge(ridge);
                                }),
                 ridges.end());
    // in noise a few of very many ridges are long by chance
    if (total_length(ridges) < least_share_of_bands * length_of_all)
      ridges.clear();
    if (ridges.empty())
      return result;
    std::sort(ridges.begin(), ridges.end(), [](const Ridge &a, const Ridge &b) {
      return length(a) > length(b);
    });

    const BandMeter   meter(options, sampler, smooth, ridges, smoothing);
    std::vector<Line> axes;
    for (const Ridge &ridge : ridges)
      {
        result.bands.push_back(meter.measure(ridge));
        axes.push_back(meter.axis(ridge));
      }
    measure_spacings(result.bands, ridges, axes, d50);
    if (!field.void_ratio.empty())
      {
        measure_void_ratio_inside(result, ridges, field, d50);
        result.void_ratio_outside =
          measure_void_ratio_outside(field, sampler, 0.05 * reference);
      }

    const auto over_bands = [&](const auto &measure) {
      return median_over(result.bands, measure);
    };
    result.thickness_50 =
      over_bands([](const ShearBand &band) { return band.thickness_50; });
    result.thickness_10 =
      over_bands([](const ShearBand &band) { return band.thickness_10; });
    result.inclination = over_bands(
      [](const ShearBand &band) { return std::abs(band.inclination); });
    result.spacing =
      over_bands([](const ShearBand &band) { return band.spacing; });
    return result;
  }
} // namespace Riedel::Analysis
