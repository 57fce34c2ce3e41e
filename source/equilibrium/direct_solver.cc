// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/equilibrium/direct_solver.h>
#include <riedel/errors.h>

#include <Amesos_Mumps.h>
#include <Epetra_CrsMatrix.h>
#include <Epetra_LinearProblem.h>

#include <cmath>
#include <string>
#include <vector>

#include <suitesparse/umfpack.h>

namespace Riedel::Equilibrium
{
  namespace
  {
    [[noreturn]] void
    fail(const std::string &what, const int code)
    {
      throw ComputationError(
        what + " of the stiffness matrix failed (code " + std::to_string(code) +
        "). Most often it is singular: a part of the body can move freely, or "
        "a material has no stiffness. Check the boundary conditions.");
    }



    /// MUMPS through Amesos: in parallel, symbolic phase separate.
    class Mumps : public LinearSolver
    {
    public:
      explicit Mumps(const LinearAlgebra::SparseMatrix &matrix)
        : right_hand_side(matrix.trilinos_matrix().RangeMap())
        , solution(matrix.trilinos_matrix().DomainMap())
      {
        // Amesos takes non-const operators; it does not change the values.
        problem.SetOperator(
          const_cast<Epetra_CrsMatrix *>(&matrix.trilinos_matrix()));
        problem.SetRHS(&right_hand_side);
        problem.SetLHS(&solution);
        solver = std::make_unique<Amesos_Mumps>(problem);
        // scaling by the diagonal: the iterated scaling that MUMPS would choose
        // takes a good part of a factorisation and gains nothing here
        solver->SetICNTL(8, 1);
      }

      void
      factorise() override
      {
        int code = try_to_factorise();
        // Pivots that the analysis could not foresee need more room.
        while (code != 0 && needs_room() && extra_room < 1000)
          {
            extra_room *= 2;
            analysed = false;
            code     = try_to_factorise();
          }
        if (code != 0)
          fail("The factorisation", code);
      }

      void
      solve(const LinearAlgebra::Vector &b, LinearAlgebra::Vector &x) override
      {
        right_hand_side.Update(1.0, b.trilinos_vector(), 0.0);
        const int code = solver->Solve();
        if (code != 0)
          fail("The solution with the factors", code);
        x.trilinos_vector().Update(1.0, solution, 0.0);
      }

    private:
      int
      try_to_factorise()
      {
        if (!analysed)
          {
            solver->SetICNTL(14, extra_room);
            const int code = solver->SymbolicFactorization();
            if (code != 0)
              fail("The analysis", code);
            analysed = true;
          }
        return solver->NumericFactorization();
      }

      /// Did MUMPS say that its work space was too small?
      bool
      needs_room() const
      {
        const int info = solver->GetINFOG()[0];
        return info == -8 || info == -9;
      }

      Epetra_LinearProblem          problem;
      Epetra_Vector                 right_hand_side;
      Epetra_Vector                 solution;
      std::unique_ptr<Amesos_Mumps> solver;
      bool                          analysed   = false;
      int                           extra_room = 50; ///< per cent
    };



    /// UMFPACK through its C interface, for one rank. Epetra's compressed rows
    /// are the compressed columns of the transpose.
    class Umfpack : public LinearSolver
    {
    public:
      explicit Umfpack(const LinearAlgebra::SparseMatrix &matrix)
        : n(matrix.trilinos_matrix().NumMyRows())
      {
        if (matrix.trilinos_matrix().Comm().NumProc() > 1)
          throw InputError(
            "Solver/Direct solver = umfpack works on one rank only: use mumps, "
            "or run without mpirun.");
        const int code =
          matrix.trilinos_matrix().ExtractCrsDataPointers(row_start,
                                                          columns,
                                                          values);
        if (code != 0)
          throw std::logic_error("the matrix is not in compressed storage");
        umfpack_di_defaults(control);
        // the nonlinear iteration corrects what rounding spoils
        control[UMFPACK_IRSTEP] = 0;
      }

      ~Umfpack() override
      {
        umfpack_di_free_numeric(&numeric);
        umfpack_di_free_symbolic(&symbolic);
      }

      void
      factorise() override
      {
        if (symbolic == nullptr)
          {
            const int code = umfpack_di_symbolic(
              n, n, row_start, columns, values, &symbolic, control, nullptr);
            if (code != UMFPACK_OK)
              fail("The analysis", code);
          }
        umfpack_di_free_numeric(&numeric);
        const int code = umfpack_di_numeric(
          row_start, columns, values, symbolic, &numeric, control, nullptr);
        if (code != UMFPACK_OK)
          fail("The factorisation", code);
      }

      void
      solve(const LinearAlgebra::Vector &b, LinearAlgebra::Vector &x) override
      {
        const int code = umfpack_di_solve(UMFPACK_At,
                                          row_start,
                                          columns,
                                          values,
                                          x.begin(),
                                          b.begin(),
                                          numeric,
                                          control,
                                          nullptr);
        if (code != UMFPACK_OK)
          fail("The solution with the factors", code);
      }

    private:
      const int n;
      int      *row_start = nullptr;
      int      *columns   = nullptr;
      double   *values    = nullptr;
      void     *symbolic  = nullptr;
      void     *numeric   = nullptr;
      double    control[UMFPACK_CONTROL];
    };
  } // namespace



  std::unique_ptr<LinearSolver>
  make_direct_solver(const DirectSolverName             name,
                     const LinearAlgebra::SparseMatrix &matrix)
  {
    if (name == DirectSolverName::umfpack)
      return std::make_unique<Umfpack>(matrix);
    return std::make_unique<Mumps>(matrix);
  }
} // namespace Riedel::Equilibrium
