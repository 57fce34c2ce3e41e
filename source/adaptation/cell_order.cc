// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/adaptation/cell_order.h>

#include <algorithm>
#include <utility>

namespace Riedel::Adaptation
{
  template <int dim>
  std::vector<typename dealii::Triangulation<dim>::active_cell_iterator>
  cells_along_curve(
    const dealii::parallel::distributed::Triangulation<dim> &triangulation)
  {
    using Cell = typename dealii::Triangulation<dim>::active_cell_iterator;
    const auto &tree =
      triangulation.get_coarse_cell_to_p4est_tree_permutation();

    // tree, then the numbers of the children on the way down
    using Key = std::vector<std::size_t>;
    std::vector<std::pair<Key, Cell>> keyed;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const dealii::CellId id = cell->id();
          Key key = {static_cast<std::size_t>(tree[id.get_coarse_cell_id()])};
          for (const auto child : id.get_child_indices())
            key.push_back(child);
          keyed.emplace_back(std::move(key), cell);
        }
    std::sort(keyed.begin(), keyed.end(), [](const auto &a, const auto &b) {
      return a.first < b.first;
    });

    std::vector<Cell> result;
    for (const auto &[key, cell] : keyed)
      result.push_back(cell);
    return result;
  }



  template std::vector<dealii::Triangulation<2>::active_cell_iterator>
  cells_along_curve(const dealii::parallel::distributed::Triangulation<2> &);
  template std::vector<dealii::Triangulation<3>::active_cell_iterator>
  cells_along_curve(const dealii::parallel::distributed::Triangulation<3> &);
} // namespace Riedel::Adaptation
