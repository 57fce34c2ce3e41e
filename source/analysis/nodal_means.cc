// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/analysis/nodal_means.h>

#include <cstddef>

namespace Riedel::Analysis
{
  namespace
  {
    using Places = std::vector<std::optional<TriangleWeights>>;



    std::vector<double>
    weighted_means(const DeformedField       &field,
                   const Places              &places,
                   const std::vector<double> &values)
    {
      std::vector<double> sum(field.nodes.size(), 0.), weight = sum;
      for (std::size_t p = 0; p < places.size(); ++p)
        if (places[p])
          for (unsigned int k = 0; k < 3; ++k)
            {
              const double share = field.volume[p] * places[p]->weights[k];
              sum[places[p]->nodes[k]] += share * values[p];
              weight[places[p]->nodes[k]] += share;
            }

      // of a point on an edge the opposite node may have a weight of rounding
      double total = 0.;
      for (const double w : weight)
        total += w;
      const double least = 1e-9 * total / static_cast<double>(weight.size());
      std::vector<unsigned char> is_seen(weight.size(), 0);
      for (std::size_t i = 0; i < weight.size(); ++i)
        if (weight[i] > least)
          {
            sum[i] /= weight[i];
            is_seen[i] = 1;
          }
        else
          sum[i] = weight[i] = 0.;

      for (const auto &triangle : field.triangles)
        for (const unsigned int i : triangle)
          if (!is_seen[i])
            for (const unsigned int j : triangle)
              if (is_seen[j])
                {
                  sum[i] += sum[j];
                  weight[i] += 1.;
                }
      for (std::size_t i = 0; i < weight.size(); ++i)
        if (!is_seen[i] && weight[i] > 0.)
          sum[i] /= weight[i];
      return sum;
    }
  } // namespace



  std::vector<double>
  nodal_means(const DeformedField       &field,
              const TriangleSearch      &search,
              const std::vector<double> &values)
  {
    Places places;
    for (const auto &point : field.points)
      places.push_back(search.locate(point));

    auto                result  = weighted_means(field, places, values);
    std::vector<double> missing = values;
    for (std::size_t p = 0; p < places.size(); ++p)
      if (places[p])
        for (unsigned int k = 0; k < 3; ++k)
          missing[p] -= places[p]->weights[k] * result[places[p]->nodes[k]];
    const auto change = weighted_means(field, places, missing);
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] += change[i];
    return result;
  }
} // namespace Riedel::Analysis
