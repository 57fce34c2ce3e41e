// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/continuum/forward.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace Riedel::Continuum
{
  /// Smallest number of derivatives that Forward has for @p n inputs.
  constexpr int
  n_derivatives(const int n)
  {
    return n <= 4 ? 4 : (n + 7) / 8 * 8;
  }

  /**
   * Solves A x = b by elimination with pivots: A has a row of derivatives per
   * equation, b becomes x. Rhs is a number or a vector of derivatives. False if
   * A is singular.
   */
  template <int n, std::size_t m, typename Rhs>
  bool
  solve(std::array<DerivativeVector<n>, m> &A, std::array<Rhs, m> &b)
  {
    for (unsigned int c = 0; c < m; ++c)
      {
        unsigned int pivot = c;
        for (unsigned int r = c + 1; r < m; ++r)
          if (std::abs(A[r][c]) > std::abs(A[pivot][c]))
            pivot = r;
        const double largest = A[pivot][c];
        if (!(std::abs(largest) > 0.) || !std::isfinite(largest))
          return false;
        if (pivot != c)
          {
            std::swap(A[c], A[pivot]);
            std::swap(b[c], b[pivot]);
          }
        const double inverse = 1. / largest;
        A[c]                 = A[c] * inverse;
        b[c]                 = b[c] * inverse;
        for (unsigned int r = 0; r < m; ++r)
          if (r != c)
            {
              const double factor = A[r][c];
              A[r]                = A[r] - A[c] * factor;
              b[r]                = b[r] - b[c] * factor;
            }
      }
    return true;
  }

  /// The largest absolute value of numbers; infinite if one is not finite.
  template <typename Number, std::size_t m>
  double
  largest_value(const std::array<Number, m> &x)
  {
    double largest = 0.;
    for (const Number &component : x)
      {
        const double size = std::abs(value_of(component));
        if (!std::isfinite(size))
          return INFINITY;
        largest = std::max(largest, size);
      }
    return largest;
  }

  /**
   * Newton's method with a line search for a small system r(y) = 0.
   *
   * @param residual callable: residual(y) for an array of Forward, m values
   *        with derivatives; all are of the same kind (strains)
   * @param size callable: {size, floor}, after residual(): what the residual
   *        is compared with, and what it is by rounding
   * @param y start and solution
   * @param trace the residuals of all iterations, for tests; may be null
   * @return has it been solved?
   */
  template <std::size_t m, typename Residual, typename Size>
  bool
  newton(const Residual        &residual,
         const Size            &size,
         std::array<double, m> &y,
         std::vector<double>   *trace = nullptr)
  {
    constexpr int n = n_derivatives(m);
    using Number    = Forward<n>;

    std::array<double, m>              step, best = y;
    std::array<DerivativeVector<n>, m> rows;
    double                             before = INFINITY, share = 1.;
    for (unsigned int iteration = 0; iteration < 60; ++iteration)
      {
        std::array<Number, m> unknowns;
        for (unsigned int i = 0; i < m; ++i)
          unknowns[i] = Number::input(y[i], i);
        const std::array<Number, m> r    = residual(unknowns);
        const double                norm = largest_value(r);
        if (norm <= before * (1. - 1e-4 * share) || before == INFINITY)
          {
            if (!std::isfinite(norm))
              return false;
            if (trace != nullptr)
              trace->push_back(norm);
            const auto [scale, floor] = size();
            if (norm <= floor)
              return true;
            for (unsigned int i = 0; i < m; ++i)
              {
                rows[i] = r[i].derivatives;
                step[i] = -r[i].value;
              }
            if (!solve(rows, step))
              return false;
            best = y;
            // Where the last step has squared the error the next one does, too.
            const bool last = norm <= 1e-8 * scale && norm <= 1e-2 * before;
            before          = norm;
            share           = 1.;
            if (last)
              {
                for (unsigned int i = 0; i < m; ++i)
                  y[i] += step[i];
                return true;
              }
          }
        else
          {
            // nothing better near by: rounding, or no solution
            const auto [scale, floor] = size();
            if (share < 1e-3)
              {
                y = best;
                return before <= std::max(1e3 * floor, 1e-10 * scale);
              }
            share *= .4;
          }
        for (unsigned int i = 0; i < m; ++i)
          y[i] = best[i] + share * step[i];
      }
    return false;
  }

  /**
   * The solution of r(y, x) = 0 with its derivatives with respect to x, by the
   * theorem of implicit functions: dy = -(dr/dy)^-1 dr/dx.
   *
   * @param y the solution
   * @param residual residual(y, x) with Forward y; @p residual_x with Forward x
   */
  template <int nx, std::size_t m, typename Residual, typename ResidualX>
  bool
  differentiate_solution(const std::array<double, m> &y,
                         const Residual              &residual,
                         const ResidualX             &residual_x,
                         std::array<Forward<nx>, m>  &solution)
  {
    constexpr int             n = n_derivatives(m);
    std::array<Forward<n>, m> unknowns;
    for (unsigned int i = 0; i < m; ++i)
      unknowns[i] = Forward<n>::input(y[i], i);
    const auto                          r   = residual(unknowns);
    const auto                          r_x = residual_x(y);
    std::array<DerivativeVector<n>, m>  rows;
    std::array<DerivativeVector<nx>, m> derivatives;
    for (unsigned int i = 0; i < m; ++i)
      {
        rows[i]        = r[i].derivatives;
        derivatives[i] = -r_x[i].derivatives;
      }
    if (!solve(rows, derivatives))
      return false;
    for (unsigned int i = 0; i < m; ++i)
      solution[i] = {y[i], derivatives[i]};
    return true;
  }
} // namespace Riedel::Continuum
