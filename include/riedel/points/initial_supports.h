// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/grid/parameters.h>
#include <riedel/grid/space.h>
#include <riedel/points/support_builder.h>

#include <deal.II/base/quadrature.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace Riedel::Points
{
  /**
   * Supports of the reference configuration "initial" (finite elements): shape
   * functions live on the undeformed grid; gradients are pushed forward with
   * F_n = I + grad_X U_n of the grid's displacement at the place where they are
   * taken, and V_n = V_0 det F_n at the point (doc/theory/formulation.md).
   *
   * The strain sampling of a cell is an interpolation of rows: the row that
   * gives H and theta at a point is a weighted sum of rows at the cell's
   * sampling points plus a fraction of its own (doc/theory/elements.md).
   */
  template <int dim>
  class InitialSupports : public SupportBuilder<dim>
  {
  public:
    /// @p follow_deformation: false if all laws are geometrically linear: then
    /// F_n = I always.
    InitialSupports(const Grid::Space<dim> &space,
                    const Grid::Parameters &parameters,
                    const bool              follow_deformation);

    dealii::Quadrature<dim>
    quadrature() const override;

    void
    rebuild(const std::vector<double> &solution,
            MaterialPoints<dim>       &points) override;

    void
    accept(const std::vector<double> &solution,
           const std::vector<double> &du,
           const std::vector<double> &increments,
           MaterialPoints<dim>       &points) override;

  private:
    using SupportBuilder<dim>::result;

    /// The supports of the next step, from the displacements at its start.
    /// Writes the points' volumes and displacements, and in the plane their
    /// rotations.
    void
    update(const std::vector<double> &solution, MaterialPoints<dim> &points);

    /// Shape functions of a cell at some places, on the undeformed grid:
    /// gradients [place][axis][node], values [place][node].
    struct Shapes
    {
      std::vector<double> gradient, weight, rotation_gradient, rotation_weight;
    };

    /// What a cell needs every step.
    struct CellData
    {
      /// a patch per material that the cell has points of
      std::vector<unsigned int> patches;
      /// number of its first sampling point in #sampled
      std::size_t first_sample;
    };

    void
    evaluate_shapes(
      const typename dealii::DoFHandler<dim>::active_cell_iterator &cell,
      const std::vector<dealii::Point<dim>>                        &places,
      Shapes &shapes) const;

    void
    interpolate(const std::vector<double> &solution,
                MaterialPoints<dim>       &points) const;

    /// Turns the points by a step's increments, in space.
    void
    turn(const std::vector<double> &du, MaterialPoints<dim> &points) const;

    void
    update_cell(const CellData            &cell,
                const std::vector<double> &solution,
                MaterialPoints<dim>       &points);

    const Grid::Space<dim> *space;
    Grid::Parameters        parameters;
    bool                    follow_deformation;

    dealii::Quadrature<dim> sampling;

    std::vector<CellData> cells;
    /// on the undeformed grid: at all points, in the supports' layout
    Shapes own;
    /// on the undeformed grid: at all sampling points
    Shapes sampled;
    /// interpolation from sampling points to a point [point][sample]
    std::vector<double> interpolation;
  };
} // namespace Riedel::Points
