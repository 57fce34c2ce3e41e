// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/grid/cell_lattice.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <vector>

#include "tree_tools.h"

using namespace Riedel::Grid;
using TreeTools::Tree;

namespace
{
  template <int dim>
  void
  check_leaves(const unsigned int seed)
  {
    const Tree<dim>        tree(seed);
    const CellLattice<dim> lattice(tree.dofs);
    REQUIRE(lattice.leaves().size() == tree.tria.n_active_cells());
    for (const auto &cell : tree.dofs.active_cell_iterators())
      {
        const auto &leaf =
          lattice.leaves()[lattice.leaf_of(cell->active_cell_index())];
        CHECK(leaf.cell == cell);
        CHECK(leaf.lower.distance(cell->vertex(0)) < 1e-14);
        for (unsigned int d = 0; d < dim; ++d)
          CHECK(leaf.size[d] ==
                Approx(cell->extent_in_direction(d)).epsilon(1e-13));
      }
  }



  /// Against a look at all cells; a touch of less than 1e-12 does not decide.
  template <int dim>
  void
  check_find(const unsigned int seed, const double largest)
  {
    const Tree<dim>           tree(seed);
    const CellLattice<dim>    lattice(tree.dofs);
    std::vector<unsigned int> found;
    for (const auto &box :
         TreeTools::random_boxes(tree.tria, 300, largest, seed))
      {
        found.clear();
        const auto lower = box.centre - box.half_lengths,
                   upper = box.centre + box.half_lengths;
        REQUIRE(lattice.find(lower, upper, found));
        std::sort(found.begin(), found.end());
        REQUIRE(std::adjacent_find(found.begin(), found.end()) == found.end());
        for (unsigned int i = 0; i < lattice.leaves().size(); ++i)
          {
            const auto &leaf    = lattice.leaves()[i];
            double      overlap = 1.0;
            for (unsigned int d = 0; d < dim; ++d)
              overlap =
                std::min(overlap,
                         std::min(upper[d], leaf.lower[d] + leaf.size[d]) -
                           std::max(lower[d], leaf.lower[d]));
            const bool is_found =
              std::binary_search(found.begin(), found.end(), i);
            if (overlap > 1e-12)
              CHECK(is_found);
            if (overlap < -1e-12)
              CHECK_FALSE(is_found);
          }
      }
  }
} // namespace



TEST_CASE("The lattice knows place and size of every leaf", "[lattice]")
{
  check_leaves<2>(1);
  check_leaves<3>(2);
}



TEST_CASE("The lattice finds the leaves that a box touches", "[lattice]")
{
  check_find<2>(3, 0.2);
  check_find<2>(4, 1.5);
  check_find<3>(5, 0.3);
}



TEST_CASE("A point belongs to one leaf, on faces too", "[lattice]")
{
  const Tree<2>             tree(6);
  const CellLattice<2>      lattice(tree.dofs);
  std::vector<unsigned int> found;
  for (const auto &cell : tree.dofs.active_cell_iterators())
    for (const auto &x : {cell->center(),
                          cell->vertex(0),
                          cell->vertex(3),
                          cell->face(1)->center()})
      {
        // exactly on the side, as the lattice computes it
        found.clear();
        CHECK(lattice.find(x, x, found));
        REQUIRE(found.size() == 1);
        const auto &leaf = lattice.leaves()[found.front()];
        for (unsigned int d = 0; d < 2; ++d)
          {
            CHECK(x[d] > leaf.lower[d] - 1e-12);
            CHECK(x[d] < leaf.lower[d] + leaf.size[d] + 1e-12);
          }
      }
}



TEST_CASE("A box outside the grid touches no leaf", "[lattice]")
{
  const Tree<2>             tree(7);
  const CellLattice<2>      lattice(tree.dofs);
  std::vector<unsigned int> found;
  CHECK(lattice.find(dealii::Point<2>(-5.0, 0.8),
                     dealii::Point<2>(-4.0, 0.9),
                     found));
  CHECK(found.empty());
  // one that ends on the grid's side does not reach into it
  CHECK(lattice.find(dealii::Point<2>(-0.5, 0.8),
                     dealii::Point<2>(-0.3, 0.9),
                     found));
  CHECK(found.empty());
}
