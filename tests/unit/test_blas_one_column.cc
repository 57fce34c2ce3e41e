// SPDX-License-Identifier: LGPL-2.1-or-later
// source/blas/one_column.cc: one column must give what the library gives for
// the same column beside another one.
#include <riedel/blas/one_column.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

namespace
{
  std::vector<double>
  random_numbers(const std::size_t n)
  {
    static std::mt19937                    engine(5489);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    std::vector<double>                    numbers(n);
    std::generate(numbers.begin(), numbers.end(), [&] {
      return uniform(engine);
    });
    return numbers;
  }
} // namespace



TEST_CASE("Products with one column are those of the library", "[blas]")
{
  const int ld = 50;
  for (const char *transposed : {"N", "T", "n", "t"})
    for (const double beta : {0.0, 1.0, 0.5})
      for (const int m : {0, 1, 2, 3, 4, 7, 16, 41})
        for (const int k : {0, 1, 3, 4, 5, 8, 33})
          {
            const double alpha = -0.75;
            const auto   a     = random_numbers(ld * ld);
            const auto   b     = random_numbers(ld * 2);
            auto         one = random_numbers(ld * 2), two = one;
            const auto   before = one;

            for (const auto &[n, c] : {std::make_pair(1, &one), {2, &two}})
              dgemm_(transposed,
                     "N",
                     &m,
                     &n,
                     &k,
                     &alpha,
                     a.data(),
                     &ld,
                     b.data(),
                     &ld,
                     &beta,
                     c->data(),
                     &ld);
            for (int i = 0; i < 2 * ld; ++i)
              REQUIRE(one[i] ==
                      Approx(i < m ? two[i] : before[i]).margin(1e-14));
          }
}



TEST_CASE("Triangles with one column are those of the library", "[blas]")
{
  const int    ld    = 45;
  const double alpha = 1.0;
  for (const char *uplo : {"U", "L"})
    for (const char *transposed : {"N", "T"})
      for (const char *diagonal : {"U", "N"})
        for (const int m : {0, 1, 2, 5, 16, 41})
          {
            auto a = random_numbers(ld * ld);
            for (double &entry : a)
              entry *= 0.2;
            for (int i = 0; i < m; ++i)
              a[i * ld + i] += 2.0;
            auto       one = random_numbers(ld * 2), two = one;
            const auto before = one;

            for (const auto &[n, b] : {std::make_pair(1, &one), {2, &two}})
              dtrsm_("L",
                     uplo,
                     transposed,
                     diagonal,
                     &m,
                     &n,
                     &alpha,
                     a.data(),
                     &ld,
                     b->data(),
                     &ld);
            for (int i = 0; i < 2 * ld; ++i)
              REQUIRE(one[i] ==
                      Approx(i < m ? two[i] : before[i]).margin(1e-13));
          }
}
