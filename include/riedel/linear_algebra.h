// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

namespace Riedel
{
  /// The linear algebra types of the whole program: distributed by rows over
  /// the ranks (Epetra underneath).
  namespace LinearAlgebra
  {
    using Vector       = dealii::TrilinosWrappers::MPI::Vector;
    using SparseMatrix = dealii::TrilinosWrappers::SparseMatrix;
  } // namespace LinearAlgebra
} // namespace Riedel
