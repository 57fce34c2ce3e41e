// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/continuum/generalised.h>
#include <riedel/continuum/moment.h>
#include <riedel/equilibrium/parameters.h>
#include <riedel/grid/body.h>
#include <riedel/grid/space.h>
#include <riedel/points/material_points.h>
#include <riedel/points/supports.h>

#include <deal.II/base/tensor.h>

#include <array>
#include <functional>
#include <vector>

namespace Riedel::Equilibrium
{
  /**
   * What acts on the body besides its supports: weight, body forces and
   * couples, and the loads on boundaries as surface integrals
   * (doc/theory/loads.md). Of a load of the form "virtual stress" only the
   * resultant is computed here; it enters the equations through VirtualStress.
   */
  template <int dim>
  class Loads
  {
  public:
    static constexpr unsigned int n_spin = Continuum::Generalised<dim>::n_spin;

    /// @p body_fills_grid: false if points move through the grid; call
    /// set_extent() in every step then.
    Loads(const BoundaryConditionParameters<dim> &boundaries,
          const LoadingParameters<dim>           &loading,
          const Grid::Body<dim>                  &body,
          const Grid::Space<dim>                 &space,
          const bool                              body_fills_grid);

    /// In the configuration "current" no faces follow the body: its loaded
    /// boundaries are the sides of the smallest box around its points, @p
    /// present at the end of the step. @p initial: before the first step.
    void
    set_extent(const dealii::BoundingBox<dim> &initial,
               const dealii::BoundingBox<dim> &present);

    /// Takes a local stiffness (row-major, n x n) of n dofs by global number.
    using AddMatrix =
      std::function<void(const std::vector<dealii::types::global_dof_index> &,
                         const std::vector<double> &)>;

    /// Adds weight, body forces and body couples of the points.
    void
    add_body_forces(const Points::Supports<dim>       &supports,
                    const Points::MaterialPoints<dim> &points,
                    const double                       s,
                    std::vector<double>               &forces) const;

    /// Adds the surface loads at displacement @p u (relevant dofs by local
    /// number) and, if @p add_matrix is not empty, minus their derivative.
    void
    add_surface_loads(const std::vector<double> &u,
                      const double               s,
                      std::vector<double>       &forces,
                      const AddMatrix           &add_matrix) const;

    /// What acts on this rank's part of a boundary, after add_surface_loads().
    struct Surface
    {
      dealii::Tensor<1, dim> force;  ///< resultant of the loads [N/m in 2D]
      Continuum::Moment<dim> moment; ///< of the loads, about the origin
      dealii::Tensor<1, dim> normal_area;         ///< present area times normal
      dealii::Tensor<1, dim> initial_normal_area; ///< before the first step
    };

    /// In the order of the parameters; zero for a boundary without loads.
    const std::vector<Surface> &
    surfaces() const
    {
      return surface;
    }

  private:
    /// A quadrature point of a loaded face.
    struct FacePoint
    {
      unsigned int       boundary;
      std::size_t        first_dof; ///< in #dofs
      dealii::Point<dim> position;  ///< undeformed [m]
      double             weight;    ///< of the quadrature
      /// undeformed dX/dxi [m] along the coordinates of the face, running so
      /// that their cross product points outwards
      std::array<dealii::Tensor<1, dim>, dim - 1> tangent;
      std::vector<double>                         shape; ///< of displacements
      /// d shape / d xi
      std::array<std::vector<double>, dim - 1> slope;
      std::vector<double>                      rotation_shape;
    };

    void
    add_sides_of_extent(const double s) const;

    const BoundaryConditionParameters<dim> *parameters;
    const LoadingParameters<dim>           *loading;
    const Grid::Body<dim>                  *body;
    const Grid::Space<dim>                 *space;
    bool                                    has_extent = false;
    dealii::BoundingBox<dim>                initial_extent, present_extent;
    std::vector<unsigned int>               dofs;
    std::vector<FacePoint>                  face_points;
    mutable std::vector<Surface>            surface;
  };
} // namespace Riedel::Equilibrium
