// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <cstdint>

namespace Riedel::Equilibrium
{
  /// How much work an iterative linear solver had; all zero for a direct one.
  struct LinearCounts
  {
    std::uint64_t solutions  = 0; ///< systems that were solved
    std::uint64_t iterations = 0; ///< of all of them
    std::uint64_t most       = 0; ///< of one of them
    std::uint64_t unfinished = 0; ///< systems left at a larger residual

    LinearCounts &
    operator+=(const LinearCounts &other)
    {
      solutions += other.solutions;
      iterations += other.iterations;
      most = std::max(most, other.most);
      unfinished += other.unfinished;
      return *this;
    }

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &solutions &iterations &most &unfinished;
    }
  };
} // namespace Riedel::Equilibrium
