// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/linear_algebra.h>

#include <deque>
#include <vector>

namespace Riedel::Equilibrium
{
  /**
   * Anderson acceleration (type II) of a fixed-point iteration x <- x + f(x),
   * where f is a preconditioned residual: the last differences of x and f are
   * secant pairs of the inverse Jacobian, and
   *
   *     x_next = x + f - (dX + dF) gamma,   gamma = argmin |f - dF gamma|
   *
   * (Walker and Ni, SIAM J. Numer. Anal. 49, 2011; Fang and Saad, Numer. Linear
   * Algebra Appl. 16, 2009). Pairs live on while the preconditioner stays: they
   * may be carried from load step to load step.
   */
  class AndersonAcceleration
  {
  public:
    /// @p n_pairs secant pairs at most; 0 leaves the iteration as it is.
    /// @p squared_weights: the metric of the minimisation, a positive weight
    /// per entry.
    AndersonAcceleration(const unsigned int           n_pairs,
                         const LinearAlgebra::Vector &squared_weights);

    /// Forgets all pairs: the preconditioner has changed.
    void
    clear();

    /// The next iterate after @p x has jumped, e.g. at a new load step: the
    /// next difference is no secant.
    void
    interrupt();

    /// Replaces @p x by the next iterate; @p f is f(x).
    void
    advance(LinearAlgebra::Vector &x, const LinearAlgebra::Vector &f);

    /// Takes @p x and @p f = f(x) for the next secant; the next iterate is
    /// found by other means, e.g. a line search.
    void
    remember(const LinearAlgebra::Vector &x, const LinearAlgebra::Vector &f);

  private:
    /// A secant pair; only what is needed of it.
    struct Pair
    {
      LinearAlgebra::Vector sum; ///< dx + df
      LinearAlgebra::Vector df;
      LinearAlgebra::Vector weighted; ///< df times the squared weights
      /// products with the pairs that are older, newest of them first
      std::deque<double> products;
    };

    /// The secant from the last iterate to @p x, newest of the pairs.
    void
    add_pair(const LinearAlgebra::Vector &x, const LinearAlgebra::Vector &f);

    /// Of the pairs, newest first.
    std::vector<const LinearAlgebra::Vector *>
    weighted_differences() const;

    /// argmin |f - dF gamma|, newest pair first; 0 for pairs that depend on
    /// newer ones.
    std::vector<double>
    minimise(const std::vector<double> &projections) const;

    const unsigned int           n_pairs;
    const LinearAlgebra::Vector *squared_weights;
    std::deque<Pair>             pairs; ///< newest first
    bool                         has_last = false;
    LinearAlgebra::Vector        last_x, last_f;
  };
} // namespace Riedel::Equilibrium
