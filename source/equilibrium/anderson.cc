// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/equilibrium/anderson.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <iterator>
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



  namespace
  {
    /// Sum of a_i b_i. Several partial sums, so that additions need not wait
    /// for each other.
    double
    scalar_product(const std::size_t n,
                   const double *__restrict a,
                   const double *__restrict b)
    {
      constexpr std::size_t n_sums       = 16;
      double                sums[n_sums] = {};
      const std::size_t     whole        = n / n_sums * n_sums;
      for (std::size_t i = 0; i < whole; i += n_sums)
        for (std::size_t k = 0; k < n_sums; ++k)
          sums[k] += a[i + k] * b[i + k];
      double sum = 0.0;
      for (const double part : sums)
        sum += part;
      for (std::size_t i = whole; i < n; ++i)
        sum += a[i] * b[i];
      return sum;
    }



    /// Scalar products of @p a with several vectors, in one communication.
    std::vector<double>
    products(const LinearAlgebra::Vector                      &a,
             const std::vector<const LinearAlgebra::Vector *> &others)
    {
      const std::size_t   n = a.end() - a.begin();
      std::vector<double> here, all(others.size());
      for (const auto *other : others)
        here.push_back(scalar_product(n, a.begin(), other->begin()));
      dealii::Utilities::MPI::sum(here, a.get_mpi_communicator(), all);
      return all;
    }
  } // namespace



  std::vector<double>
  AndersonAcceleration::minimise(const std::vector<double> &projections) const
  {
    // Cholesky factors of the normal equations, newest pair first. A pair of
    // which less than this share (squared) is new is left out: the products
    // have no more digits.
    constexpr double                 least_new_share = 1e-10;
    std::vector<std::vector<double>> factor;
    std::vector<double>              solution;
    std::vector<unsigned int>        used;
    for (unsigned int k = 0; k < pairs.size(); ++k)
      {
        std::vector<double> row;
        double              rest = pairs[k].products.front();
        const double        all  = rest;
        for (unsigned int j = 0; j < used.size(); ++j)
          {
            double entry = pairs[used[j]].products[k - used[j]];
            for (unsigned int i = 0; i < j; ++i)
              entry -= row[i] * factor[j][i];
            row.push_back(entry / factor[j][j]);
            rest -= row.back() * row.back();
          }
        if (!(rest > least_new_share * all))
          continue;
        row.push_back(std::sqrt(rest));
        double value = projections[k];
        for (unsigned int i = 0; i < used.size(); ++i)
          value -= row[i] * solution[i];
        solution.push_back(value / row.back());
        factor.push_back(std::move(row));
        used.push_back(k);
      }

    std::vector<double> gamma(pairs.size(), 0.0);
    for (int j = static_cast<int>(used.size()) - 1; j >= 0; --j)
      {
        double value = solution[j];
        for (unsigned int i = j + 1; i < used.size(); ++i)
          value -= factor[i][j] * gamma[used[i]];
        gamma[used[j]] = value / factor[j][j];
      }
    return gamma;
  }



  void
  AndersonAcceleration::add_pair(const LinearAlgebra::Vector &x,
                                 const LinearAlgebra::Vector &f)
  {
    Pair pair{x, f, f, {}};
    pair.df -= last_f;
    pair.sum -= last_x;
    pair.sum += pair.df;
    pair.weighted = pair.df;
    pair.weighted.scale(*squared_weights);
    pairs.push_front(std::move(pair));
    if (pairs.size() > n_pairs)
      {
        pairs.pop_back();
        for (auto newer = std::next(pairs.begin()); newer != pairs.end();
             ++newer)
          newer->products.pop_back();
      }

    const auto with_older = products(pairs.front().df, weighted_differences());
    pairs.front().products.assign(with_older.begin(), with_older.end());
  }



  std::vector<const LinearAlgebra::Vector *>
  AndersonAcceleration::weighted_differences() const
  {
    std::vector<const LinearAlgebra::Vector *> differences;
    for (const Pair &pair : pairs)
      differences.push_back(&pair.weighted);
    return differences;
  }



  void
  AndersonAcceleration::remember(const LinearAlgebra::Vector &x,
                                 const LinearAlgebra::Vector &f)
  {
    if (n_pairs == 0)
      return;
    if (has_last)
      add_pair(x, f);
    last_x   = x;
    last_f   = f;
    has_last = true;
  }



  void
  AndersonAcceleration::advance(LinearAlgebra::Vector       &x,
                                const LinearAlgebra::Vector &f)
  {
    remember(x, f);
    const std::vector<double> gamma =
      minimise(products(f, weighted_differences()));

    x += f;
    for (unsigned int k = 0; k < pairs.size(); ++k)
      if (gamma[k] != 0.0)
        x.add(-gamma[k], pairs[k].sum);
  }
} // namespace Riedel::Equilibrium
