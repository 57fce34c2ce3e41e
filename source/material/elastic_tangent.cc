// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/continuum/generalised.h>
#include <riedel/continuum/turn_in_space.h>
#include <riedel/material/elastic_tangent.h>

#include <algorithm>
#include <array>

namespace Riedel::Material
{
  namespace
  {
    using Order = Continuum::Generalised<3>;

    /// Three numbers of a row, in a vector of the processor.
    typedef double Row __attribute__((vector_size(4 * sizeof(double))));

    constexpr Row units[3] = {{1., 0., 0., 0.},
                              {0., 1., 0., 0.},
                              {0., 0., 1., 0.}};

    struct Matrix
    {
      Row rows[3];

      const Row &
      operator[](const unsigned int i) const
      {
        return rows[i];
      }
    };

    Row
    row_of(const double a, const double b, const double c)
    {
      return Row{a, b, c, 0.};
    }

    Matrix
    operator+(const Matrix &a, const Matrix &b)
    {
      return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}};
    }

    Matrix
    operator-(const Matrix &a, const Matrix &b)
    {
      return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}};
    }

    Matrix
    operator*(const double factor, const Matrix &a)
    {
      return {{factor * a[0], factor * a[1], factor * a[2]}};
    }

    /// x^T a
    Row
    operator*(const Row &x, const Matrix &a)
    {
      return x[0] * a[0] + x[1] * a[1] + x[2] * a[2];
    }

    Matrix
    operator*(const Matrix &a, const Matrix &b)
    {
      return {{a[0] * b, a[1] * b, a[2] * b}};
    }

    Matrix
    transpose(const Matrix &a)
    {
      return {{row_of(a[0][0], a[1][0], a[2][0]),
               row_of(a[0][1], a[1][1], a[2][1]),
               row_of(a[0][2], a[1][2], a[2][2])}};
    }

    /// factor I
    Matrix
    diagonal(const double factor)
    {
      return {{factor * units[0], factor * units[1], factor * units[2]}};
    }

    Row
    cross(const Row &a, const Row &b)
    {
      return row_of(a[1] * b[2] - a[2] * b[1],
                    a[2] * b[0] - a[0] * b[2],
                    a[0] * b[1] - a[1] * b[0]);
    }

    Matrix
    cofactor(const Matrix &a)
    {
      return {{cross(a[1], a[2]), cross(a[2], a[0]), cross(a[0], a[1])}};
    }

    double
    sum(const Row &a)
    {
      return a[0] + a[1] + a[2];
    }

    double
    determinant(const Matrix &a, const Matrix &cofactor)
    {
      return sum(a[0] * cofactor[0]);
    }

    /// From numbers in the order 11, 12, 13, 21, ...
    Matrix
    matrix_of(const double *numbers)
    {
      return {{row_of(numbers[0], numbers[1], numbers[2]),
               row_of(numbers[3], numbers[4], numbers[5]),
               row_of(numbers[6], numbers[7], numbers[8])}};
    }

    /// I + E
    Matrix
    one_plus(const Continuum::SpaceTensor<3, double> &E)
    {
      return diagonal(1.) + Matrix{{row_of(E(0, 0), E(0, 1), E(0, 2)),
                                    row_of(E(1, 0), E(1, 1), E(1, 2)),
                                    row_of(E(2, 0), E(2, 1), E(2, 2))}};
    }

    /// dQ^T and T of a rotation vector (TurnInSpace), with derivatives.
    struct Turn
    {
      Matrix R, T;
      /// with respect to the three components of theta
      Matrix dR[3], dT[3];

      explicit Turn(const double *theta)
      {
        const Row                    t = row_of(theta[0], theta[1], theta[2]);
        const double                 q = sum(t * t);
        const Continuum::TurnFactors at(q);
        const auto &[s, c, d]    = at.factors;
        const auto &[ds, dc, dd] = at.slopes;
        const Matrix A           = skew(t);
        const Matrix square      = {{t[0] * t - q * units[0],
                                     t[1] * t - q * units[1],
                                     t[2] * t - q * units[2]}};
        R                        = diagonal(1.) - s * A + c * square;
        T                        = diagonal(1.) + c * A + d * square;
        for (unsigned int m = 0; m < 3; ++m)
          {
            // of A and A^2
            const Matrix unit     = skew(units[m]);
            Matrix       d_square = {{t[0] * units[m] - 2. * t[m] * units[0],
                                      t[1] * units[m] - 2. * t[m] * units[1],
                                      t[2] * units[m] - 2. * t[m] * units[2]}};
            d_square.rows[m]      = d_square.rows[m] + t;
            const double two_t    = 2. * t[m];
            dR[m] = (two_t * dc) * square - (two_t * ds) * A + c * d_square -
                    s * unit;
            dT[m] = (two_t * dd) * square + (two_t * dc) * A + d * d_square +
                    c * unit;
          }
      }

    private:
      static Matrix
      skew(const Row &t)
      {
        return {{row_of(0., -t[2], t[1]),
                 row_of(t[2], 0., -t[0]),
                 row_of(-t[1], t[0], 0.)}};
      }
    };



    /**
     * The rows of forces and spins: d(P, t) for dH and, if micropolar, dtheta.
     *
     * @param W (I + E) R at the start
     * @param turn the rotation, if micropolar
     */
    template <bool micropolar>
    void
    write_forces(const NeoHookeanElasticity &elasticity,
                 const Matrix               &f,
                 const Matrix               &elastic,
                 const Matrix               &W,
                 const Turn                 *turn,
                 const double                inverse_volume,
                 double                     *tangent)
    {
      constexpr unsigned int n =
        micropolar ? Order::n_micropolar : Order::n_classical;
      const double lambda = elasticity.lambda, mu = elasticity.mu;
      const double half_kappa = .5 * elasticity.kappa;
      const Matrix V          = f * W;
      const Matrix cofactor_f = cofactor(f);
      const Matrix f_inverse_transposed =
        (1. / determinant(f, cofactor_f)) * cofactor_f;
      const Matrix C          = inverse_volume * f_inverse_transposed;
      const Matrix cofactor_V = cofactor(V);
      const double J          = determinant(V, cofactor_V);
      const Matrix Vt         = transpose(V);
      const Matrix skew       = V - Vt;
      const Matrix P          = ((mu * V + half_kappa * skew) * Vt +
                        diagonal(.5 * lambda * (J * J - 1.) - mu)) *
                       C;

      // the column c: change of P, and of the Kirchhoff stress
      const auto write_column =
        [&](const Matrix &dP, const Matrix &change, const unsigned int c) {
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int j = 0; j < 3; ++j)
              tangent[Order::gradient(i, j) * n + c] = dP[i][j];
          if constexpr (micropolar)
            for (unsigned int k = 0; k < 3; ++k)
              {
                const unsigned int i = (k + 1) % 3, j = (k + 2) % 3;
                tangent[Order::spin(k) * n + c] =
                  inverse_volume * (change[i][j] - change[j][i]);
              }
        };

      // df = e_k e_l^T: dV has one row, the row l of W in place k
      const Matrix WVt = W * Vt, W_skewt = W * (Vt - V),
                   W_cofactort = W * transpose(cofactor_V);
      for (unsigned int l = 0; l < 3; ++l)
        {
          const Row column = mu * WVt[l] + half_kappa * W_skewt[l];
          const Row row    = (mu + half_kappa) * WVt[l];
          for (unsigned int k = 0; k < 3; ++k)
            {
              const double volumetric = lambda * J * W_cofactort[l][k];
              const Row    minus      = -half_kappa * Vt[k];
              Matrix       change     = {
                          {W[l][0] * minus + column[0] * units[k] + volumetric * units[0],
                           W[l][1] * minus + column[1] * units[k] + volumetric * units[1],
                           W[l][2] * minus + column[2] * units[k] +
                             volumetric * units[2]}};
              change.rows[k]  = change.rows[k] + row;
              const Row    Ck = f_inverse_transposed[k];
              const Matrix dP =
                change * C - Matrix{{P[0][l] * Ck, P[1][l] * Ck, P[2][l] * Ck}};
              write_column(dP, change, Order::gradient(k, l));
            }
        }
      if constexpr (micropolar)
        for (unsigned int m = 0; m < 3; ++m)
          {
            const Matrix dV    = f * (elastic * turn->dR[m]);
            const Matrix dVt   = transpose(dV);
            const Matrix dV_Vt = dV * Vt;
            const double dJ =
              sum(cofactor_V[0] * dV[0] + cofactor_V[1] * dV[1] +
                  cofactor_V[2] * dV[2]);
            const Matrix change = mu * (dV_Vt + transpose(dV_Vt)) +
                                  half_kappa * ((dV - dVt) * Vt + skew * dVt) +
                                  diagonal(lambda * J * dJ);
            write_column(change * C, change, Order::spin(m));
          }
    }



    /// The rows of couples: dM for dtheta and dGamma.
    void
    write_couples(const NeoHookeanElasticity           &elasticity,
                  const double                         *increments,
                  const StretchAndCurvature<3, double> &start,
                  const Matrix                         &total,
                  const Turn                           &turn,
                  const double                          inverse_volume,
                  double                               *tangent)
    {
      constexpr unsigned int n         = Order::n_micropolar;
      const auto             conjugate = [&](const Matrix &k) {
        return elasticity.gamma * k + elasticity.beta * transpose(k) +
               diagonal(elasticity.alpha * (k[0][0] + k[1][1] + k[2][2]));
      };
      const Matrix W_t     = transpose(total * turn.R);
      const Matrix B       = inverse_volume * W_t;
      const Matrix k_start = matrix_of(start.curvature.components.data());
      const Matrix S = matrix_of(increments + Order::curvature(0, 0)) * total;
      const Matrix before      = transpose(turn.R) * k_start + turn.T * S;
      const Matrix conjugate_k = conjugate(before * turn.R);
      for (unsigned int m = 0; m < 3; ++m)
        {
          const Matrix dk =
            (transpose(turn.dR[m]) * k_start + turn.dT[m] * S) * turn.R +
            before * turn.dR[m];
          const Matrix dB = inverse_volume * transpose(total * turn.dR[m]);
          const Matrix dM = conjugate(dk) * B + conjugate_k * dB;
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int j = 0; j < 3; ++j)
              tangent[Order::curvature(i, j) * n + Order::spin(m)] = dM[i][j];
        }
      // dGamma = e_a e_b^T: dk = t w^T with the column a of T, the row b of
      // W_total
      const Matrix Bt     = transpose(B);
      const Matrix Tt_B_t = Bt * turn.T; // j, a
      const Matrix B_t_W  = Bt * W_t;    // j, b
      const Matrix tw     = transpose(turn.T) * W_t;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          {
            double *numbers =
              tangent + Order::curvature(i, j) * n + Order::curvature(0, 0);
            for (unsigned int a = 0; a < 3; ++a)
              {
                const Row x = (elasticity.gamma * turn.T[i][a]) * B_t_W[j] +
                              (elasticity.beta * Tt_B_t[j][a]) * W_t[i] +
                              (elasticity.alpha * B[i][j]) * tw[a];
                for (unsigned int b = 0; b < 3; ++b)
                  numbers[3 * a + b] = x[b];
              }
          }
    }
  } // namespace



  template <bool micropolar>
  void
  elastic_tangent_in_space(const NeoHookeanElasticity           &elasticity,
                           const double                         *increments,
                           const StretchAndCurvature<3, double> &start,
                           double                               *tangent)
  {
    const Matrix f              = diagonal(1.) + matrix_of(increments);
    const Matrix elastic        = one_plus(start.elastic);
    const Matrix total          = one_plus(start.total);
    const double inverse_volume = 1. / determinant(total, cofactor(total));
    if constexpr (micropolar)
      {
        constexpr unsigned int n         = Order::n_micropolar;
        constexpr unsigned int curvature = Order::curvature(0, 0);
        // forces do not know Gamma, and couples do not know H
        for (unsigned int i = 0; i < curvature; ++i)
          std::fill_n(tangent + i * n + curvature, n - curvature, 0.);
        for (unsigned int i = curvature; i < n; ++i)
          std::fill_n(tangent + i * n, Order::n_gradient, 0.);

        const Turn turn(increments + Order::spin(0));
        write_forces<true>(elasticity,
                           f,
                           elastic,
                           elastic * turn.R,
                           &turn,
                           inverse_volume,
                           tangent);
        write_couples(
          elasticity, increments, start, total, turn, inverse_volume, tangent);
      }
    else
      // stresses do not know the rotation in the stretch
      write_forces<false>(
        elasticity, f, elastic, elastic, nullptr, inverse_volume, tangent);
  }



  template void
  elastic_tangent_in_space<false>(const NeoHookeanElasticity &,
                                  const double *,
                                  const StretchAndCurvature<3, double> &,
                                  double *);
  template void
  elastic_tangent_in_space<true>(const NeoHookeanElasticity &,
                                 const double *,
                                 const StretchAndCurvature<3, double> &,
                                 double *);
} // namespace Riedel::Material
