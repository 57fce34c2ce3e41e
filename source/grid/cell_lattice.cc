// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/grid/cell_lattice.h>

#include <algorithm>
#include <cmath>

namespace Riedel::Grid
{
  template <int dim>
  CellLattice<dim>::CellLattice(const dealii::DoFHandler<dim> &dof_handler)
    : n_levels(dof_handler.get_triangulation().n_global_levels())
    , leaf_of_cell(dof_handler.get_triangulation().n_active_cells(),
                   static_cast<unsigned int>(-1))
  {
    const auto         first = dof_handler.begin(0);
    dealii::Point<dim> lower = first->center(), upper = lower;
    for (const auto &cell : dof_handler.cell_iterators_on_level(0))
      for (const unsigned int v : cell->vertex_indices())
        for (unsigned int d = 0; d < dim; ++d)
          {
            lower[d] = std::min(lower[d], cell->vertex(v)[d]);
            upper[d] = std::max(upper[d], cell->vertex(v)[d]);
          }
    grid = dealii::BoundingBox<dim>(std::make_pair(lower, upper));
    for (unsigned int d = 0; d < dim; ++d)
      coarse_cells[d] = static_cast<unsigned int>(
        std::lround(grid.side_length(d) / first->extent_in_direction(d)));

    for (const auto &cell : dof_handler.active_cell_iterators())
      if (!cell->is_artificial())
        {
          Leaf  leaf;
          Index index;
          for (unsigned int d = 0; d < dim; ++d)
            {
              const double n = static_cast<double>(coarse_cells[d]) *
                               (1u << static_cast<unsigned int>(cell->level()));
              leaf.size[d] = grid.side_length(d) / n;
              index[d]     = static_cast<unsigned int>(
                (cell->center()[d] - grid.lower_bound(d)) / leaf.size[d]);
              leaf.lower[d] = grid.lower_bound(d) + index[d] * leaf.size[d];
            }
          leaf.cell                               = cell;
          leaf_of_cell[cell->active_cell_index()] = list.size();
          leaf_at.emplace(key(cell->level(), index), list.size());
          list.push_back(leaf);
        }
  }



  template <int dim>
  std::uint64_t
  CellLattice<dim>::key(const unsigned int level, const Index &index)
  {
    // 20 bits for each axis
    std::uint64_t result = level;
    for (const unsigned int i : index)
      result = (result << 20) | i;
    return result;
  }



  template <int dim>
  bool
  CellLattice<dim>::find(const dealii::Point<dim>  &lower,
                         const dealii::Point<dim>  &upper,
                         std::vector<unsigned int> &found) const
  {
    Index first, last;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const double size = grid.side_length(d) / coarse_cells[d];
        const auto   side = [&](const unsigned int i) {
          return grid.lower_bound(d) + i * size;
        };
        // as find_below() computes the sides, not one beside by rounding
        const auto cell = [&](const double x) {
          auto i = static_cast<unsigned int>(
            std::clamp(std::floor((x - grid.lower_bound(d)) / size),
                       0.0,
                       coarse_cells[d] - 1.0));
          if (i > 0 && x < side(i))
            --i;
          else if (i + 1 < coarse_cells[d] && x >= side(i + 1))
            ++i;
          return i;
        };
        first[d] = cell(lower[d]);
        last[d]  = cell(upper[d]);
      }

    bool  complete = true;
    Index index    = first;
    while (true)
      {
        complete       = find_below(0, index, lower, upper, found) && complete;
        unsigned int d = 0;
        while (d < dim && ++index[d] > last[d])
          {
            index[d] = first[d];
            ++d;
          }
        if (d == dim)
          return complete;
      }
  }



  template <int dim>
  bool
  CellLattice<dim>::find_below(const unsigned int         level,
                               const Index               &index,
                               const dealii::Point<dim>  &lower,
                               const dealii::Point<dim>  &upper,
                               std::vector<unsigned int> &found) const
  {
    for (unsigned int d = 0; d < dim; ++d)
      {
        const unsigned int n    = coarse_cells[d] << level;
        const double       size = grid.side_length(d) / n;
        const double       from = grid.lower_bound(d) + index[d] * size;
        // the same number as the next cell's lower side: no gap between them
        const double to = grid.lower_bound(d) + (index[d] + 1) * size;
        // of two cells that share a face, the upper one has it; a point that
        // rounding has put outside the grid is on its side
        const double slack = 1e-9 * size;
        const bool   is_inside =
          (lower[d] < upper[d] ?
             lower[d] < to && upper[d] > from :
             lower[d] >= from - (index[d] == 0) * slack &&
               (index[d] + 1 == n ? lower[d] <= to + slack : lower[d] < to));
        if (!is_inside)
          return true;
      }
    const auto leaf = leaf_at.find(key(level, index));
    if (leaf != leaf_at.end())
      {
        found.push_back(leaf->second);
        return true;
      }
    if (level + 1 >= n_levels)
      return false;
    bool complete = true;
    for (unsigned int child = 0; child < (1u << dim); ++child)
      {
        Index below;
        for (unsigned int d = 0; d < dim; ++d)
          below[d] = 2 * index[d] + ((child >> d) & 1u);
        complete =
          find_below(level + 1, below, lower, upper, found) && complete;
      }
    return complete;
  }



  template class CellLattice<2>;
  template class CellLattice<3>;
} // namespace Riedel::Grid
