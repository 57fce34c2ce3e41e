// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/continuum/generalised.h>
#include <riedel/points/strain_operator.h>

#include <algorithm>
#include <type_traits>

namespace Riedel::Points
{
  namespace
  {
    /// Calls @p function with the number of nodes as a constant if it is that
    /// of a common element: its loops are unrolled then.
    template <typename Function>
    void
    with_constant(const unsigned int n, const Function &function)
    {
      if (n == 9)
        function(std::integral_constant<unsigned int, 9>());
      else if (n == 4)
        function(std::integral_constant<unsigned int, 4>());
      else
        function(n);
    }



    template <typename Size>
    double
    dot(const Size n, const double *a, const double *b)
    {
      double sum = 0.0;
      for (unsigned int i = 0; i < n; ++i)
        sum += a[i] * b[i];
      return sum;
    }



    template <typename Size>
    void
    add(const Size   n,
        const double factor,
        const double *__restrict a,
        double *__restrict sum)
    {
      for (unsigned int i = 0; i < n; ++i)
        sum[i] += factor * a[i];
    }
  } // namespace



  template <int dim>
  StrainOperator<dim>::StrainOperator(
    const Supports<dim>                 &supports,
    const typename Supports<dim>::Patch &patch,
    const unsigned int                   index_in_patch)
    : n_nodes(patch.n_nodes)
    , n_rotation_nodes(patch.n_rotation_nodes)
  {
    const std::size_t u = patch.first_weight + index_in_patch * n_nodes;
    const std::size_t w =
      patch.first_rotation_weight + index_in_patch * n_rotation_nodes;
    gradient           = supports.gradient.data() + dim * u;
    dilatation         = supports.dilatation.empty() ?
                           nullptr :
                           supports.dilatation.data() + dim * u;
    spin_weight        = supports.spin_weight.data() + w;
    curvature_gradient = supports.curvature_gradient.data() + dim * w;
  }



  template <int dim>
  void
  StrainOperator<dim>::increments(const double *values,
                                  double       *increments) const
  {
    using Order = Continuum::Generalised<dim>;
    with_constant(n_nodes, [&](const auto n) {
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          increments[Order::gradient(i, j)] =
            dot(n, values + i * n, gradient + j * n);
    });

    if (dilatation != nullptr)
      {
        double extra = 0.0;
        for (unsigned int i = 0; i < dim; ++i)
          extra += dot(n_nodes, values + i * n_nodes, dilatation + i * n_nodes);
        for (unsigned int i = 0; i < dim; ++i)
          increments[Order::gradient(i, i)] += extra / dim;
      }

    if (n_rotation_nodes > 0)
      with_constant(n_rotation_nodes, [&](const auto n) {
        for (unsigned int k = 0; k < Order::n_spin; ++k)
          {
            const double *rotation     = values + dim * n_nodes + k * n;
            increments[Order::spin(k)] = dot(n, rotation, spin_weight);
            for (unsigned int j = 0; j < dim; ++j)
              increments[Order::curvature(k, j)] =
                dot(n, rotation, curvature_gradient + j * n);
          }
      });
  }



  template <int dim>
  void
  StrainOperator<dim>::add_forces(const double *stresses,
                                  const double  volume,
                                  double       *values) const
  {
    using Order = Continuum::Generalised<dim>;
    with_constant(n_nodes, [&](const auto n) {
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          add(n,
              volume * stresses[Order::gradient(i, j)],
              gradient + j * n,
              values + i * n);
    });

    if (dilatation != nullptr)
      {
        double mean = 0.0;
        for (unsigned int i = 0; i < dim; ++i)
          mean += stresses[Order::gradient(i, i)] / dim;
        for (unsigned int i = 0; i < dim; ++i)
          add(n_nodes,
              volume * mean,
              dilatation + i * n_nodes,
              values + i * n_nodes);
      }

    if (n_rotation_nodes > 0)
      with_constant(n_rotation_nodes, [&](const auto n) {
        for (unsigned int k = 0; k < Order::n_spin; ++k)
          {
            double *rotation = values + dim * n_nodes + k * n;
            add(n, volume * stresses[Order::spin(k)], spin_weight, rotation);
            for (unsigned int j = 0; j < dim; ++j)
              add(n,
                  volume * stresses[Order::curvature(k, j)],
                  curvature_gradient + j * n,
                  rotation);
          }
      });
  }



  template <int dim>
  std::pair<unsigned int, unsigned int>
  StrainOperator<dim>::nonzero_range(const unsigned int row) const
  {
    using Order = Continuum::Generalised<dim>;
    if (row < Order::n_gradient)
      {
        // the volume part of mean dilatation depends on all displacements
        if (dilatation != nullptr)
          return {0, dim * n_nodes};
        const unsigned int i = row / dim;
        return {i * n_nodes, (i + 1) * n_nodes};
      }
    const unsigned int k     = row < Order::n_gradient + Order::n_spin ?
                                 row - Order::n_gradient :
                                 (row - Order::n_gradient - Order::n_spin) / dim;
    const unsigned int first = dim * n_nodes + k * n_rotation_nodes;
    return {first, first + n_rotation_nodes};
  }



  template <int dim>
  void
  StrainOperator<dim>::fill(double *B, const unsigned int stride) const
  {
    using Order = Continuum::Generalised<dim>;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        {
          double *row = B + Order::gradient(i, j) * stride;
          if (dilatation != nullptr)
            std::fill_n(row, dim * n_nodes, 0.0);
          std::copy_n(gradient + j * n_nodes, n_nodes, row + i * n_nodes);
          if (dilatation != nullptr && i == j)
            add(dim * n_nodes, 1.0 / dim, dilatation, row);
        }

    if (n_rotation_nodes > 0)
      for (unsigned int k = 0; k < Order::n_spin; ++k)
        {
          const unsigned int first = dim * n_nodes + k * n_rotation_nodes;
          std::copy_n(spin_weight,
                      n_rotation_nodes,
                      B + Order::spin(k) * stride + first);
          for (unsigned int j = 0; j < dim; ++j)
            std::copy_n(curvature_gradient + j * n_rotation_nodes,
                        n_rotation_nodes,
                        B + Order::curvature(k, j) * stride + first);
        }
  }



  template class StrainOperator<2>;
  template class StrainOperator<3>;
} // namespace Riedel::Points
