// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace Riedel::Material
{
  /**
   * The substeps of a step as binary fractions of it. Because a substep does
   * not depend continuously on the increment, the derivative of the accepted
   * sequence is the derivative of the algorithm, except where the sequence
   * jumps.
   */
  class BinarySubsteps
  {
  public:
    /// The largest power of two that is not above @p largest_number.
    static unsigned int
    subdivision(const unsigned int largest_number)
    {
      unsigned int n = 1;
      while (n <= largest_number / 2)
        n *= 2;
      return n;
    }

    /**
     * @param n_units smallest substeps in a step, a power of two
     * @param first wanted length of the first substep, as part of the step
     */
    BinarySubsteps(const unsigned int n_units, const double first)
      : n_units(n_units)
      , width(n_units)
    {
      shrink_to(first);
    }

    bool
    done() const
    {
      return position == n_units;
    }

    /// length of the present substep, as part of the step
    double
    length() const
    {
      return static_cast<double>(width) / n_units;
    }

    /// start of the present substep in pseudo-time [0, 1]
    double
    begin() const
    {
      return static_cast<double>(position) / n_units;
    }

    bool
    is_smallest() const
    {
      return width == 1;
    }

    /// To be repeated with at most half the length, @p wanted if known.
    void
    reject(const double wanted = 1.)
    {
      width /= 2;
      shrink_to(wanted);
    }

    /// Goes on behind the present substep with about the length @p wanted.
    void
    accept(const double wanted)
    {
      position += width;
      shrink_to(wanted);
      // a longer one only where it starts at a multiple of itself
      while (2. * width <= wanted * n_units && position % (2 * width) == 0 &&
             position + 2 * width <= n_units)
        width *= 2;
    }

  private:
    void
    shrink_to(const double wanted)
    {
      while (width > 1 && width > wanted * n_units)
        width /= 2;
    }

    unsigned int n_units;
    unsigned int position = 0;
    unsigned int width;
  };



  /**
   * Embedded pair of orders 3 and 2 by Bogacki and Shampine (Appl. Math. Lett.
   * 2, 1989): stages at 0, 1/2, 3/4 and 1; the last one, needed for the error
   * only, is the first of the next substep.
   */
  struct BogackiShampine
  {
    static constexpr double advance[3] = {2. / 9, 1. / 3, 4. / 9};
    static constexpr double error[4]   = {-5. / 72, 1. / 12, 1. / 9, -1. / 8};

    /// Length of the substep whose error would just be tolerated, in units of
    /// the present one; not less than a tenth, for the estimate means little
    /// far away. @p error is the present error over its tolerance.
    template <typename Value>
    static Value
    suggested_length(const Value &error)
    {
      using std::cbrt;
      using std::max;
      return max(Value(.1), Value(.9 / cbrt(max(error, Value(1e-30)))));
    }
  };
} // namespace Riedel::Material
