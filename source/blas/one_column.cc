// SPDX-License-Identifier: LGPL-2.1-or-later
//
// BLAS' dgemm and dtrsm for one right-hand side.
//
// MUMPS solves with its factors by calls of dgemm and dtrsm also when there is
// one right-hand side (Debian compiles it without MUMPS_USE_BLAS2). OpenBLAS
// 0.3.21 then copies every block of the factors into its packed format, which
// costs several times the product itself: a third of the time of a solution.
// The two routines below are found before those of the library (so are all
// symbols of an executable); they do the case of one column themselves and hand
// everything else on.
#include <riedel/blas/one_column.h>

#include <cstring>

#include <dlfcn.h>

namespace
{
  /// The routine of the library that this file's routine hides.
  template <class Routine>
  Routine
  of_library(const char *name)
  {
    void   *symbol = dlsym(RTLD_NEXT, name);
    Routine routine;
    static_assert(sizeof(routine) == sizeof(symbol));
    std::memcpy(&routine, &symbol, sizeof(symbol));
    return routine;
  }



  bool
  is(const char *option, const char upper)
  {
    return *option == upper || *option == upper - 'A' + 'a';
  }



  /// c += A b for the columns of A, four at a time.
  void
  add_product(const int     m,
              const int     k,
              const double  alpha,
              const double *a,
              const long    lda,
              const double *b,
              double       *c)
  {
    int j = 0;
    for (; j + 3 < k; j += 4)
      {
        const double *a0 = a + j * lda, *a1 = a0 + lda, *a2 = a1 + lda,
                     *a3 = a2 + lda;
        const double b0 = alpha * b[j], b1 = alpha * b[j + 1],
                     b2 = alpha * b[j + 2], b3 = alpha * b[j + 3];
#pragma omp simd
        for (int i = 0; i < m; ++i)
          c[i] += a0[i] * b0 + a1[i] * b1 + a2[i] * b2 + a3[i] * b3;
      }
    for (; j < k; ++j)
      {
        const double *a0 = a + j * lda;
        const double  b0 = alpha * b[j];
#pragma omp simd
        for (int i = 0; i < m; ++i)
          c[i] += a0[i] * b0;
      }
  }



  double
  dot(const int n, const double *a, const double *b)
  {
    double sum = 0.0;
#pragma omp simd reduction(+ : sum)
    for (int i = 0; i < n; ++i)
      sum += a[i] * b[i];
    return sum;
  }



  /// c += A^T b, four columns of A at a time.
  void
  add_transposed_product(const int     m,
                         const int     k,
                         const double  alpha,
                         const double *a,
                         const long    lda,
                         const double *b,
                         double       *c)
  {
    int i = 0;
    for (; i + 3 < m; i += 4)
      {
        const double *a0 = a + i * lda, *a1 = a0 + lda, *a2 = a1 + lda,
                     *a3 = a2 + lda;
        double s0 = 0.0, s1 = 0.0, s2 = 0.0, s3 = 0.0;
#pragma omp simd reduction(+ : s0, s1, s2, s3)
        for (int j = 0; j < k; ++j)
          {
            s0 += a0[j] * b[j];
            s1 += a1[j] * b[j];
            s2 += a2[j] * b[j];
            s3 += a3[j] * b[j];
          }
        c[i] += alpha * s0;
        c[i + 1] += alpha * s1;
        c[i + 2] += alpha * s2;
        c[i + 3] += alpha * s3;
      }
    for (; i < m; ++i)
      c[i] += alpha * dot(k, a + i * lda, b);
  }



  /// Solves with a triangle, column by column: x_j first, then its share of the
  /// entries that wait for it.
  void
  solve_by_columns(const bool    upper,
                   const bool    unit,
                   const int     m,
                   const double *a,
                   const long    lda,
                   double       *b)
  {
    for (int count = 0; count < m; ++count)
      {
        const int     j      = upper ? m - 1 - count : count;
        const double *column = a + j * lda;
        if (!unit)
          b[j] /= column[j];
        const double x    = b[j];
        const int    from = upper ? 0 : j + 1;
        const int    to   = upper ? j : m;
#pragma omp simd
        for (int i = from; i < to; ++i)
          b[i] -= x * column[i];
      }
  }



  /// Solves with the transpose of a triangle: the known entries' share first.
  void
  solve_transposed(const bool    upper,
                   const bool    unit,
                   const int     m,
                   const double *a,
                   const long    lda,
                   double       *b)
  {
    for (int count = 0; count < m; ++count)
      {
        const int     j      = upper ? count : m - 1 - count;
        const double *column = a + j * lda;
        const int     from   = upper ? 0 : j + 1;
        const int     n      = upper ? j : m - 1 - j;
        b[j] -= dot(n, column + from, b + from);
        if (!unit)
          b[j] /= column[j];
      }
  }
} // namespace



extern "C"
{
  void
  dgemm_(const char   *trans_a,
         const char   *trans_b,
         const int    *m,
         const int    *n,
         const int    *k,
         const double *alpha,
         const double *a,
         const int    *lda,
         const double *b,
         const int    *ldb,
         const double *beta,
         double       *c,
         const int    *ldc)
  {
    static const auto library = of_library<decltype(&dgemm_)>("dgemm_");
    if (*n != 1 || !is(trans_b, 'N'))
      return library(
        trans_a, trans_b, m, n, k, alpha, a, lda, b, ldb, beta, c, ldc);

    if (*beta == 0.0)
      std::memset(c, 0, *m * sizeof(double));
    else if (*beta != 1.0)
      for (int i = 0; i < *m; ++i)
        c[i] *= *beta;
    if (is(trans_a, 'N'))
      add_product(*m, *k, *alpha, a, *lda, b, c);
    else
      add_transposed_product(*m, *k, *alpha, a, *lda, b, c);
  }



  void
  dtrsm_(const char   *side,
         const char   *uplo,
         const char   *trans_a,
         const char   *diag,
         const int    *m,
         const int    *n,
         const double *alpha,
         const double *a,
         const int    *lda,
         double       *b,
         const int    *ldb)
  {
    static const auto library = of_library<decltype(&dtrsm_)>("dtrsm_");
    if (*n != 1 || !is(side, 'L') || *alpha != 1.0)
      return library(side, uplo, trans_a, diag, m, n, alpha, a, lda, b, ldb);

    if (is(trans_a, 'N'))
      solve_by_columns(is(uplo, 'U'), is(diag, 'U'), *m, a, *lda, b);
    else
      solve_transposed(is(uplo, 'U'), is(diag, 'U'), *m, a, *lda, b);
  }
}
