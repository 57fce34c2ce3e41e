// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/continuum/generalised.h>
#include <riedel/grid/frame.h>
#include <riedel/grid/parameters.h>
#include <riedel/linear_algebra.h>

#include <deal.II/base/index_set.h>
#include <deal.II/base/point.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/lac/affine_constraints.h>

#include <array>
#include <map>
#include <optional>
#include <vector>

namespace Riedel::Grid
{
  /**
   * The unknowns on the grid: displacement components first, then (only if a
   * law is micropolar) micro-rotations, each with its own degree.
   *
   * A rank numbers the dofs it needs (the locally relevant ones) from zero, in
   * ascending order of their global numbers. Work on points uses these local
   * numbers and plain arrays.
   *
   * In the configuration "current" the dofs of a node follow each other, first
   * component first, and a rank also needs the masters of hanging nodes of its
   * ghost cells, into which a point may reach.
   */
  template <int dim>
  class Space
  {
  public:
    static constexpr unsigned int n_spin = Continuum::Generalised<dim>::n_spin;

    Space(const dealii::Triangulation<dim> &triangulation,
          const Parameters                 &parameters,
          const bool                        micropolar);

    /// (Re)numbers the dofs after the grid has changed.
    void
    distribute();

    bool
    is_micropolar() const
    {
      return micropolar;
    }

    /// displacement components plus rotation components
    unsigned int
    n_components() const
    {
      return fe.n_components();
    }

    /// Does every node have all components, one after another? It does if
    /// displacements and rotations are of equal degree.
    bool
    has_whole_nodes() const
    {
      return !micropolar ||
             fe.base_element(0).degree == fe.base_element(1).degree;
    }

    const dealii::FiniteElement<dim> &
    element() const
    {
      return fe;
    }

    const dealii::DoFHandler<dim> &
    dof_handler() const
    {
      return dofs;
    }

    MPI_Comm
    communicator() const;

    const dealii::IndexSet &
    owned() const
    {
      return owned_dofs;
    }

    const dealii::IndexSet &
    relevant() const
    {
      return relevant_dofs;
    }

    /// Number of a relevant dof on this rank.
    unsigned int
    local(const dealii::types::global_dof_index dof) const
    {
      return static_cast<unsigned int>(relevant_dofs.index_within_set(dof));
    }

    /// Place of an owned dof, given by its local number, in owned_vector().
    unsigned int
    owned_place(const unsigned int local_number) const
    {
      return static_cast<unsigned int>(owned_dofs.index_within_set(
        relevant_dofs.nth_index_in_set(local_number)));
    }

    /// A cell's dofs ordered by component: all nodes of the first component,
    /// all of the second, and so on; as numbers within the cell.
    const std::vector<unsigned int> &
    order_by_component() const
    {
      return cell_order;
    }

    /// Hanging nodes, and nodes that are tied to the opposite side.
    const dealii::AffineConstraints<double> &
    hanging_nodes() const
    {
      return hanging;
    }

    /// Gives hanging (and tied) nodes the values that follow from their
    /// masters'. Costs nothing where no rank has such nodes.
    void
    set_hanging(LinearAlgebra::Vector &values) const
    {
      if (has_hanging)
        hanging.distribute(values);
    }

    /// Component of every relevant dof, by local number.
    const std::vector<unsigned char> &
    components() const
    {
      return component_of_dof;
    }

    /// Undeformed position of every relevant dof's node, by local number [m].
    const std::vector<dealii::Point<dim>> &
    nodes() const
    {
      return node_positions;
    }

    /// Where the grid is at the start of the step: itself in the configuration
    /// "initial".
    const Frame<dim> &
    frame() const
    {
      return frame_of_grid;
    }

    void
    set_frame(const Frame<dim> &frame)
    {
      frame_of_grid = frame;
    }

    /// Deformed position of the node of a displacement dof [m]; @p solution:
    /// displacements from the frame, relevant dofs.
    dealii::Point<dim>
    deformed_node(const unsigned int         local_number,
                  const std::vector<double> &solution) const
    {
      dealii::Point<dim> x =
        frame_of_grid.to_space(node_positions[local_number]);
      for (unsigned int d = 0; d < dim; ++d)
        x[d] += solution[node_dofs[local_number][d]];
      return x;
    }

    /// Relevant dofs of one component on a boundary, as local numbers.
    std::vector<unsigned int>
    boundary_dofs(const dealii::types::boundary_id id,
                  const unsigned int               component) const;

    /// A vector of the owned dofs, zero.
    LinearAlgebra::Vector
    owned_vector() const;

    /// Copies owned values to an array over the relevant dofs.
    void
    gather(const LinearAlgebra::Vector &owned,
           std::vector<double>         &relevant) const;

    /// Adds an array over the relevant dofs, summed over the ranks.
    void
    scatter_add(const std::vector<double> &relevant,
                LinearAlgebra::Vector     &owned) const;

  private:
    void
    add_masters_in_ghost_cells();

    const bool                        micropolar;
    const bool                        reaches_into_ghost_cells;
    const std::optional<unsigned int> periodic_axis;
    Frame<dim>                        frame_of_grid;
    dealii::FESystem<dim>             fe;
    dealii::DoFHandler<dim>           dofs;
    dealii::IndexSet                  owned_dofs;
    dealii::IndexSet                  relevant_dofs;
    dealii::AffineConstraints<double> hanging;
    bool                              has_hanging = false; ///< on any rank
    std::vector<unsigned int>         cell_order;
    std::vector<unsigned char>        component_of_dof;
    std::vector<dealii::Point<dim>>   node_positions;
    /// the displacement dofs of the node of every displacement dof
    std::vector<std::array<unsigned int, dim>> node_dofs;
    /// local numbers of the owned dofs; of the others, with global numbers
    std::vector<unsigned int> owned_local;
    std::vector<std::pair<unsigned int, dealii::types::global_dof_index>>
                                  ghost_local;
    mutable LinearAlgebra::Vector ghosted;
  };
} // namespace Riedel::Grid
