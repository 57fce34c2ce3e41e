// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

/// Routines of BLAS that source/blas/one_column.cc answers for one right-hand
/// side; arguments as in BLAS (Dongarra et al. 1990).
extern "C"
{
  /// C = alpha op(A) op(B) + beta C
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
         const int    *ldc);

  /// Solves op(A) X = alpha B or X op(A) = alpha B with a triangle A.
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
         const int    *ldb);
}
