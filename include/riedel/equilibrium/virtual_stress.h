// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/continuum/generalised.h>
#include <riedel/equilibrium/loads.h>
#include <riedel/equilibrium/parameters.h>

#include <deal.II/base/tensor.h>

#include <vector>

namespace Riedel::Equilibrium
{
  /**
   * Pressures on boundaries as volume terms: a pressure p on a plane boundary
   * with initial normal n is the virtual stress field sigma_bar = -p n x n over
   * the whole body, of which the equations see
   *
   *     P - j sigma_bar f^-T   and   b + div sigma_bar.
   *
   * It needs no detection of the surface and acts wherever the surface is: on
   * the opposite side of the body too, which must be held in this direction.
   * p is read at the present position of a point. A dead load (initial area)
   * scales sigma_bar by initial over present area of the boundary. The tangent
   * has the derivative of j sigma_bar f^-T with respect to f; those of p with
   * position, of the present area and of j div sigma_bar are left out. They
   * vanish for a uniform pressure on the present area.
   */
  template <int dim>
  class VirtualStress
  {
  public:
    VirtualStress(const BoundaryConditionParameters<dim> &parameters);

    bool
    is_empty() const
    {
      return fields.empty();
    }

    /// Takes normals and areas of the loaded boundaries (summed over the
    /// ranks) and the load parameter.
    void
    set(const std::vector<typename Loads<dim>::Surface> &surfaces,
        const double                                     s);

    /// The virtual stress at a point, on the start-of-step configuration.
    struct AtPoint
    {
      /// j sigma_bar f^-T, and zero for t and M [Pa]
      double stresses[Continuum::Generalised<dim>::n_micropolar];
      /// j div sigma_bar [N/m3]
      dealii::Tensor<1, dim> body_force;
    };

    /// Evaluates the field at a point; @p tangent, if not null, is the point's
    /// tangent (n_generalised^2 values), from which the derivative of the
    /// virtual stress is subtracted.
    void
    evaluate(const dealii::Point<dim> &present_position,
             const double             *increments,
             const unsigned int        n_generalised,
             AtPoint                  &result,
             double                   *tangent) const;

  private:
    struct Field
    {
      unsigned int           boundary;
      dealii::Tensor<1, dim> normal;
      double                 scale = 1.0;
    };

    const BoundaryConditionParameters<dim> *parameters;
    std::vector<Field>                      fields;
    double                                  load_parameter = 0.0;
  };
} // namespace Riedel::Equilibrium
