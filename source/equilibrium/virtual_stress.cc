// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/equilibrium/virtual_stress.h>
#include <riedel/errors.h>

#include <deal.II/base/symmetric_tensor.h>

#include <cmath>

namespace Riedel::Equilibrium
{
  namespace
  {
    template <int dim>
    dealii::Tensor<2, dim>
    cofactor(const dealii::Tensor<2, dim> &f)
    {
      dealii::Tensor<2, dim> result;
      for (unsigned int k = 0; k < dim; ++k)
        for (unsigned int A = 0; A < dim; ++A)
          if constexpr (dim == 2)
            result[k][A] = (k == A ? 1.0 : -1.0) * f[1 - k][1 - A];
          else
            result[k][A] =
              f[(k + 1) % 3][(A + 1) % 3] * f[(k + 2) % 3][(A + 2) % 3] -
              f[(k + 1) % 3][(A + 2) % 3] * f[(k + 2) % 3][(A + 1) % 3];
      return result;
    }



    /// Calls @p use(k, A, l, B, d cofactor_kA / d f_lB) for all that are not
    /// zero.
    template <int dim, typename Use>
    void
    for_cofactor_derivatives(const dealii::Tensor<2, dim> &f, const Use &use)
    {
      for (unsigned int k = 0; k < dim; ++k)
        for (unsigned int A = 0; A < dim; ++A)
          if constexpr (dim == 2)
            {
              (void)f;
              use(k, A, 1 - k, 1 - A, k == A ? 1.0 : -1.0);
            }
          else
            for (unsigned int r = 1; r <= 2; ++r)
              for (unsigned int c = 1; c <= 2; ++c)
                use(k,
                    A,
                    (k + r) % 3,
                    (A + c) % 3,
                    (r == c ? 1.0 : -1.0) *
                      f[(k + 3 - r) % 3][(A + 3 - c) % 3]);
    }
  } // namespace



  template <int dim>
  VirtualStress<dim>::VirtualStress(
    const BoundaryConditionParameters<dim> &parameters)
    : parameters(&parameters)
  {
    for (unsigned int b = 0; b < parameters.boundaries.size(); ++b)
      if (parameters.boundaries[b].pressure.given() &&
          parameters.boundaries[b].form == LoadForm::virtual_stress)
        fields.push_back({b, dealii::Tensor<1, dim>(), 1.0});
  }



  template <int dim>
  void
  VirtualStress<dim>::set(
    const std::vector<typename Loads<dim>::Surface> &surfaces,
    const double                                     s)
  {
    load_parameter = s;
    for (Field &field : fields)
      {
        const auto  &surface  = surfaces[field.boundary];
        const auto  &boundary = parameters->boundaries[field.boundary];
        const double initial  = surface.initial_normal_area.norm();
        field.normal          = surface.initial_normal_area / initial;
        // what counts is the area that faces the initial normal
        field.scale = (boundary.area == LoadArea::initial ?
                         initial / (surface.normal_area * field.normal) :
                         1.0);
      }
    for (const Field &field : fields)
      for (const Field &other : fields)
        if (&field != &other && std::abs(field.normal * other.normal) > 0.5)
          throw InputError(
            "Boundary conditions/" +
            parameters->boundaries[field.boundary].name + " and " +
            parameters->boundaries[other.boundary].name +
            ": a virtual stress loads both sides of the body, so that two of "
            "the same direction would add up. Give one of the two \"Load form "
            "= surface integral\".");
  }



  template <int dim>
  void
  VirtualStress<dim>::evaluate(const dealii::Point<dim> &present_position,
                               const double             *increments,
                               const unsigned int        n_generalised,
                               AtPoint                  &result,
                               double                   *tangent) const
  {
    using Order              = Continuum::Generalised<dim>;
    dealii::Tensor<2, dim> f = dealii::unit_symmetric_tensor<dim>();
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int A = 0; A < dim; ++A)
        f[i][A] += increments[Order::gradient(i, A)];

    result = AtPoint();
    for (const Field &field : fields)
      {
        const auto  &pressure = parameters->boundaries[field.boundary].pressure;
        const auto  &n        = field.normal;
        const double p =
          field.scale * pressure(present_position, load_parameter);

        // j f^-T is the cofactor of f
        const dealii::Tensor<1, dim> n_cofactor = n * cofactor(f);
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int A = 0; A < dim; ++A)
            result.stresses[Order::gradient(i, A)] -= p * n[i] * n_cofactor[A];

        if (tangent != nullptr)
          for_cofactor_derivatives(
            f,
            [&](const unsigned int k,
                const unsigned int A,
                const unsigned int l,
                const unsigned int B,
                const double       derivative) {
              for (unsigned int i = 0; i < dim; ++i)
                tangent[Order::gradient(i, A) * n_generalised +
                        Order::gradient(l, B)] += p * n[i] * n[k] * derivative;
            });

        // central difference: the formula is smooth and given by the user
        constexpr double h = 1e-6;
        const double     slope =
          (pressure(present_position + h * n, load_parameter) -
           pressure(present_position - h * n, load_parameter)) /
          (2.0 * h);
        result.body_force -= determinant(f) * field.scale * slope * n;
      }
  }



  template class VirtualStress<2>;
  template class VirtualStress<3>;
} // namespace Riedel::Equilibrium
