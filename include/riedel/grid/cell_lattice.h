// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/bounding_box.h>
#include <deal.II/dofs/dof_handler.h>

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace Riedel::Grid
{
  /**
   * Finds the active cells that a box touches, on the tree of a box-shaped
   * grid: all cells of a level are equal, so that a place tells the cell. Knows
   * this rank's own and ghost cells. Coordinates are those of the undeformed
   * grid [m].
   */
  template <int dim>
  class CellLattice
  {
  public:
    /// An active cell.
    struct Leaf
    {
      dealii::Point<dim>     lower; ///< its lower left corner
      dealii::Tensor<1, dim> size;  ///< edge lengths
      /// the cell itself
      typename dealii::DoFHandler<dim>::active_cell_iterator cell;
    };

    /// The coarsest cells of the grid must be equal, axis-parallel, and fill a
    /// box.
    explicit CellLattice(const dealii::DoFHandler<dim> &dof_handler);

    /// Own and ghost cells.
    const std::vector<Leaf> &
    leaves() const
    {
      return list;
    }

    /// Number of the leaf of an active own or ghost cell.
    unsigned int
    leaf_of(const unsigned int active_cell_index) const
    {
      return leaf_of_cell[active_cell_index];
    }

    /// Appends the numbers of all leaves whose inside meets the box (a box
    /// without volume: those that contain its point, one of them on a face).
    /// False if a part of the box within the grid belongs to no own or ghost
    /// cell.
    bool
    find(const dealii::Point<dim>  &lower,
         const dealii::Point<dim>  &upper,
         std::vector<unsigned int> &found) const;

  private:
    using Index = std::array<unsigned int, dim>;

    static std::uint64_t
    key(const unsigned int level, const Index &index);

    bool
    find_below(const unsigned int         level,
               const Index               &index,
               const dealii::Point<dim>  &lower,
               const dealii::Point<dim>  &upper,
               std::vector<unsigned int> &found) const;

    dealii::BoundingBox<dim>                        grid;
    std::array<unsigned int, dim>                   coarse_cells;
    unsigned int                                    n_levels;
    std::vector<Leaf>                               list;
    std::vector<unsigned int>                       leaf_of_cell;
    std::unordered_map<std::uint64_t, unsigned int> leaf_at;
  };
} // namespace Riedel::Grid
