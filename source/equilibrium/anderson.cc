// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/equilibrium/anderson.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <vector>

namespace Riedel::Equilibrium
{
  AndersonAcceleration::AndersonAcceleration(
    const unsigned int           n_pairs,
    const LinearAlgebra::Vector &squared_weights)
    : n_pairs(n_pairs)
    , squared_weights(&squared_weights)
  {}



  void
  AndersonAcceleration::clear()
  {
    pairs.clear();
    interrupt();
  }



  void
  AndersonAcceleration::interrupt()
  {
    has_last = false;
  }



  double
  AndersonAcceleration::product(const LinearAlgebra::Vector &a,
                                const LinearAlgebra::Vector &b) const
  {
    const double     *pa  = a.begin();
    const double     *pb  = b.begin();
    const double     *pw  = squared_weights->begin();
    const std::size_t n   = a.end() - a.begin();
    double            sum = 0.0;
    for (std::size_t i = 0; i < n; ++i)
      sum += pw[i] * pa[i] * pb[i];
    return dealii::Utilities::MPI::sum(sum, a.get_mpi_communicator());
  }



  void
  AndersonAcceleration::advance(LinearAlgebra::Vector       &x,
                                const LinearAlgebra::Vector &f)
  {
    if (n_pairs == 0)
      {
        x += f;
        return;
      }

    if (has_last)
      {
        Pair pair{x, f};
        pair.dx -= last_x;
        pair.df -= last_f;
        pairs.push_front(std::move(pair));
        if (pairs.size() > n_pairs)
          pairs.pop_back();
      }
    last_x   = x;
    last_f   = f;
    has_last = true;

    // Modified Gram-Schmidt, newest pair first; a pair that depends on newer
    // ones is left out. What remains of f is the minimised residual.
    LinearAlgebra::Vector              rest = f;
    std::vector<LinearAlgebra::Vector> basis;
    std::vector<std::vector<double>>   triangle; // R, by columns
    std::vector<double>                projection;
    std::vector<const Pair *>          used;
    for (const Pair &pair : pairs)
      {
        LinearAlgebra::Vector column = pair.df;
        const double          before = std::sqrt(product(column, column));
        std::vector<double>   entries;
        for (const auto &direction : basis)
          {
            entries.push_back(product(direction, column));
            column.add(-entries.back(), direction);
          }
        const double norm = std::sqrt(product(column, column));
        if (!(norm > 1e-6 * before))
          continue;
        column /= norm;
        entries.push_back(norm);
        projection.push_back(product(column, rest));
        rest.add(-projection.back(), column);
        basis.push_back(std::move(column));
        triangle.push_back(std::move(entries));
        used.push_back(&pair);
      }

    x += f;
    std::vector<double> gamma(projection);
    for (int i = static_cast<int>(gamma.size()) - 1; i >= 0; --i)
      {
        for (unsigned int j = i + 1; j < gamma.size(); ++j)
          gamma[i] -= triangle[j][i] * gamma[j];
        gamma[i] /= triangle[i][i];
        x.add(-gamma[i], used[i]->dx, -gamma[i], used[i]->df);
      }
  }
} // namespace Riedel::Equilibrium
