// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/equilibrium/virtual_stress.h>
#include <riedel/errors.h>

#include <cmath>

namespace Riedel::Equilibrium
{
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
    static_assert(dim == 2, "the cofactor of f is written for 2D");
    using Order                = Continuum::Generalised<dim>;
    constexpr unsigned int a11 = Order::gradient(0, 0),
                           a12 = Order::gradient(0, 1),
                           a21 = Order::gradient(1, 0),
                           a22 = Order::gradient(1, 1);
    const double f11 = 1.0 + increments[a11], f12 = increments[a12],
                 f21 = increments[a21], f22 = 1.0 + increments[a22];

    result = AtPoint();
    for (const Field &field : fields)
      {
        const auto  &pressure = parameters->boundaries[field.boundary].pressure;
        const auto  &n        = field.normal;
        const double p =
          field.scale * pressure(present_position, load_parameter);

        // j f^-T is the cofactor of f: linear in H in the plane
        const double n_cofactor[2] = {n[0] * f22 - n[1] * f12,
                                      n[1] * f11 - n[0] * f21};
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int A = 0; A < dim; ++A)
            result.stresses[Order::gradient(i, A)] -= p * n[i] * n_cofactor[A];

        if (tangent != nullptr)
          for (unsigned int i = 0; i < dim; ++i)
            {
              double *row_1 = tangent + Order::gradient(i, 0) * n_generalised;
              double *row_2 = tangent + Order::gradient(i, 1) * n_generalised;
              row_1[a22] += p * n[i] * n[0];
              row_1[a12] -= p * n[i] * n[1];
              row_2[a21] -= p * n[i] * n[0];
              row_2[a11] += p * n[i] * n[1];
            }

        // central difference: the formula is smooth and given by the user
        constexpr double h = 1e-6;
        const double     slope =
          (pressure(present_position + h * n, load_parameter) -
           pressure(present_position - h * n, load_parameter)) /
          (2.0 * h);
        result.body_force -= (f11 * f22 - f12 * f21) * field.scale * slope * n;
      }
  }



  template class VirtualStress<2>;
} // namespace Riedel::Equilibrium
