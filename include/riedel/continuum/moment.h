// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/continuum/generalised.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

namespace Riedel::Continuum
{
  /// A moment or a couple [N m, N in plane strain]: about axis 3 in plane
  /// strain, about the three axes in space.
  template <int dim>
  using Moment = dealii::Tensor<1, static_cast<int>(Generalised<dim>::n_spin)>;

  /// The moment about the origin of a force at @p x.
  template <int dim>
  Moment<dim>
  moment_of(const dealii::Point<dim> &x, const dealii::Tensor<1, dim> &force)
  {
    Moment<dim> moment;
    if constexpr (dim == 2)
      moment[0] = x[0] * force[1] - x[1] * force[0];
    else
      moment = cross_product_3d(x, force);
    return moment;
  }
} // namespace Riedel::Continuum
