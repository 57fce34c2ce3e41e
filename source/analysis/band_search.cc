// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/analysis/band_search.h>
#include <riedel/analysis/nodal_means.h>
#include <riedel/analysis/statistics.h>
#include <riedel/analysis/triangle_sampler.h>

#include <algorithm>
#include <cmath>

namespace Riedel::Analysis
{
  namespace
  {
    /// Bands make up at least this share of the length of all ridges.
    constexpr double least_share_of_bands = 0.6;



    /// Distance of raster points: half a grain, but a bounded number of them.
    double
    raster_spacing(const TriangleSearch &search, const double grain_size)
    {
      const double most_points = 3e5;
      const Point  size        = vector_between(search.lower(), search.upper());
      return std::max(0.5 * grain_size,
                      std::sqrt(size[0] * size[1] / most_points));
    }



    /// Length of the edges [m] of triangles with values above @p level:
    /// median over their area.
    double
    edge_length(const DeformedField       &field,
                const std::vector<double> &indicator,
                const double               level)
    {
      std::vector<std::array<double, 2>> length_and_area;
      double                             total = 0.;
      for (const auto &[a, b, c] : field.triangles)
        {
          if (std::abs(indicator[a]) < level &&
              std::abs(indicator[b]) < level && std::abs(indicator[c]) < level)
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
  } // namespace



  std::vector<double>
  band_indicator(const DeformedField &field, const TriangleSearch &search)
  {
    if (!field.rotation.empty() || field.shear_strain.empty())
      return field.rotation;

    const double        background = quantile(field.shear_strain, 0.2);
    std::vector<double> values;
    for (std::size_t p = 0; p < field.points.size(); ++p)
      {
        const double excess = std::max(field.shear_strain[p] - background, 0.);
        values.push_back(
          std::copysign(std::min(excess, 4. * std::abs(field.spin[p])),
                        field.spin[p]));
      }
    return nodal_means(field, search, values);
  }



  FoundBands
  find_bands(const DeformedField       &field,
             const TriangleSearch      &search,
             const std::vector<double> &indicator,
             const double               least,
             const BandMeasureOptions  &options)
  {
    const double          d50 = options.grain_size;
    const TriangleSampler sampler(search, indicator);
    const Raster raster = rasterise(sampler, raster_spacing(search, d50));
    std::vector<double> magnitudes;
    for (std::size_t k = 0; k < raster.values.size(); ++k)
      if (raster.inside[k])
        magnitudes.push_back(std::abs(raster.values[k]));
    FoundBands result;
    result.reference =
      quantile(std::move(magnitudes), options.percentile / 100.);
    const double level = std::max(options.threshold * result.reference, least);

    // enough smoothing to remove kinks between triangles and ripples on the
    // back of wide bands, not more: it serves to find the ridges, widths are
    // taken from the field itself
    const double kinks   = 0.5 * edge_length(field, indicator, level);
    const double ripples = 0.12 * typical_width(raster, level);
    result.smoothing     = std::max({d50, kinks, ripples, raster.spacing});

    result.smooth                    = smoothed(raster, result.smoothing);
    const RidgeOptions ridge_options = {d50, level, raster.spacing};
    auto              &ridges        = result.ridges;
    ridges = join_collinear(trace_ridges(result.smooth, ridge_options),
                            result.smooth,
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
    std::sort(ridges.begin(), ridges.end(), [](const Ridge &a, const Ridge &b) {
      return length(a) > length(b);
    });
    return result;
  }
} // namespace Riedel::Analysis
