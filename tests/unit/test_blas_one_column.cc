// SPDX-License-Identifier: LGPL-2.1-or-later
// source/blas/one_column.cc: one column must give what the library gives for
// the same column beside another one.
#include <catch2/catch.hpp>

#include <algorithm>
#include <random>
#include <vector>

extern "C"
{
  void
  dgemm_(const char *,
         const char *,
         const int *,
         const int *,
         const int *,
         const double *,
         const double *,
         const int *,
         const double *,
         const int *,
         const double *,
         double *,
         const int *);
  void
  dtrsm_(const char *,
         const char *,
         const char *,
         const char *,
         const int *,
         const int *,
         const double *,
         const double *,
         const int *,
         double *,
         const int *);
}

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

            const int n1 = 1, n2 = 2;
            dgemm_(transposed,
                   "N",
                   &m,
                   &n1,
                   &k,
                   &alpha,
                   a.data(),
                   &ld,
                   b.data(),
                   &ld,
                   &beta,
                   one.data(),
                   &ld);
            dgemm_(transposed,
                   "N",
                   &m,
                   &n2,
                   &k,
                   &alpha,
                   a.data(),
                   &ld,
                   b.data(),
                   &ld,
                   &beta,
                   two.data(),
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

            const int n1 = 1, n2 = 2;
            dtrsm_("L",
                   uplo,
                   transposed,
                   diagonal,
                   &m,
                   &n1,
                   &alpha,
                   a.data(),
                   &ld,
                   one.data(),
                   &ld);
            dtrsm_("L",
                   uplo,
                   transposed,
                   diagonal,
                   &m,
                   &n2,
                   &alpha,
                   a.data(),
                   &ld,
                   two.data(),
                   &ld);
            for (int i = 0; i < 2 * ld; ++i)
              REQUIRE(one[i] ==
                      Approx(i < m ? two[i] : before[i]).margin(1e-13));
          }
}
