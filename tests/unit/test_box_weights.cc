// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/grid/cell_lattice.h>
#include <riedel/grid/space.h>
#include <riedel/points/box_weights.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/lac/affine_constraints.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <vector>

#include "tree_tools.h"

using namespace Riedel;
using Points::BoxWeights;
using Points::NodeWeight;
using TreeTools::Box;

namespace
{
  /// A tree and the weights of its nodes.
  template <int dim>
  struct Tree : TreeTools::Tree<dim>
  {
    using TreeTools::Tree<dim>::dofs;

    explicit Tree(const unsigned int seed)
      : TreeTools::Tree<dim>(seed)
    {
      dealii::DoFTools::make_hanging_node_constraints(dofs, hanging);
      hanging.close();
      lattice = std::make_unique<Grid::CellLattice<dim>>(dofs);
      weights = std::make_unique<BoxWeights<dim>>(*lattice, hanging);
      dealii::DoFTools::map_dofs_to_support_points(dealii::MappingQ1<dim>(),
                                                   dofs,
                                                   places);
    }

    std::vector<NodeWeight<dim>>
    operator()(const Box<dim> &box) const
    {
      std::vector<NodeWeight<dim>> nodes;
      REQUIRE(weights->evaluate(box.centre, box.half_lengths, nodes));
      return nodes;
    }

    dealii::AffineConstraints<double>                             hanging;
    std::unique_ptr<Grid::CellLattice<dim>>                       lattice;
    std::unique_ptr<BoxWeights<dim>>                              weights;
    std::map<dealii::types::global_dof_index, dealii::Point<dim>> places;
  };



  /// Centre of the part of a box that lies in the grid.
  template <int dim>
  dealii::Point<dim>
  centre_in_grid(const Tree<dim> &tree, const Box<dim> &box)
  {
    dealii::Point<dim> result;
    for (unsigned int d = 0; d < dim; ++d)
      {
        double lower = 1e300, upper = -1e300;
        for (const auto &[dof, x] : tree.places)
          {
            lower = std::min(lower, x[d]);
            upper = std::max(upper, x[d]);
          }
        result[d] =
          0.5 * (std::max(lower, box.centre[d] - box.half_lengths[d]) +
                 std::min(upper, box.centre[d] + box.half_lengths[d]));
      }
    return result;
  }



  /// Partition of unity, linear reproduction and their gradients.
  template <int dim>
  void
  check_linear(const unsigned int seed, const double largest)
  {
    const Tree<dim> tree(seed);
    CAPTURE(dim, seed, largest, tree.hanging.n_constraints());
    REQUIRE(tree.hanging.n_constraints() > 10);
    double unity = 0.0, reproduction = 0.0, gradient_sum = 0.0, gradient = 0.0,
           least = 0.0;
    for (const auto &box :
         TreeTools::random_boxes(tree.tria, 500, largest, seed))
      {
        double                 sum = 0.0;
        dealii::Point<dim>     place;
        dealii::Tensor<1, dim> zero;
        dealii::Tensor<2, dim> identity;
        double                 size = 0.0;
        for (const auto &node : tree(box))
          {
            REQUIRE_FALSE(tree.hanging.is_constrained(node.node));
            const auto &x = tree.places.at(node.node);
            sum += node.weight;
            place += node.weight * x;
            zero += node.gradient;
            identity += outer_product(x, node.gradient);
            size  = std::max(size, node.gradient.norm());
            least = std::min(least, node.weight);
          }
        for (unsigned int d = 0; d < dim; ++d)
          identity[d][d] -= 1.0;
        unity = std::max(unity, std::abs(sum - 1.0));
        reproduction =
          std::max(reproduction, place.distance(centre_in_grid(tree, box)));
        gradient_sum = std::max(gradient_sum, zero.norm() / size);
        gradient     = std::max(gradient, identity.norm());
      }
    CHECK(unity < 1e-12);
    CHECK(reproduction < 1e-12);
    CHECK(gradient_sum < 1e-12);
    CHECK(gradient < 1e-12 * (largest == 0.0 ? 1.0 : 10.0));
    CHECK(least > -1e-14);
  }



  /// The mean of a random function of the space over a box, without
  /// CellLattice: the box is cut along all sides of the finest cells, every
  /// piece looks through all cells.
  template <int dim>
  struct Reference
  {
    explicit Reference(const Tree<dim> &tree)
      : tree(&tree)
      , values(tree.dofs.n_dofs())
    {
      std::mt19937                           random(7);
      std::uniform_real_distribution<double> uniform(-1.0, 1.0);
      for (double &value : values)
        value = uniform(random);
      tree.hanging.distribute(values);
    }

    /// value and gradient
    std::pair<double, dealii::Tensor<1, dim>>
    at(const dealii::Point<dim> &x) const
    {
      for (const auto &cell : tree->dofs.active_cell_iterators())
        {
          dealii::Point<dim> place;
          bool               inside = true;
          for (unsigned int d = 0; d < dim; ++d)
            {
              place[d] =
                (x[d] - cell->vertex(0)[d]) / cell->extent_in_direction(d);
              inside = inside && place[d] >= 0.0 && place[d] <= 1.0;
            }
          if (!inside)
            continue;
          double                 value = 0.0;
          dealii::Tensor<1, dim> gradient;
          for (const unsigned int v : cell->vertex_indices())
            {
              const double nodal = values[cell->vertex_dof_index(v, 0)];
              value += tree->fe.shape_value(v, place) * nodal;
              const auto slope = tree->fe.shape_grad(v, place);
              for (unsigned int d = 0; d < dim; ++d)
                gradient[d] += slope[d] / cell->extent_in_direction(d) * nodal;
            }
          return {value, gradient};
        }
      return {0.0, dealii::Tensor<1, dim>()}; // outside
    }

    /// ... of a box that lies inside the grid
    std::pair<double, dealii::Tensor<1, dim>>
    mean(const Box<dim> &box) const
    {
      const auto                       first = tree->tria.begin(0);
      std::vector<std::vector<double>> cuts(dim);
      for (unsigned int d = 0; d < dim; ++d)
        {
          const double fine =
            first->extent_in_direction(d) / (1u << (TreeTools::n_levels - 1));
          const double lower = first->vertex(0)[d];
          const double from  = box.centre[d] - box.half_lengths[d],
                       to    = box.centre[d] + box.half_lengths[d];
          cuts[d].push_back(from);
          for (double i = std::floor((from - lower) / fine) + 1;
               lower + i * fine < to;
               ++i)
            cuts[d].push_back(lower + i * fine);
          cuts[d].push_back(to);
        }
      double                        mean_value = 0.0;
      dealii::Tensor<1, dim>        mean_gradient;
      std::array<unsigned int, dim> i{};
      while (true)
        {
          double             share = 1.0;
          dealii::Point<dim> x;
          for (unsigned int d = 0; d < dim; ++d)
            {
              x[d] = 0.5 * (cuts[d][i[d]] + cuts[d][i[d] + 1]);
              share *= (cuts[d][i[d] + 1] - cuts[d][i[d]]) /
                       (2.0 * box.half_lengths[d]);
            }
          const auto [value, gradient] = at(x);
          mean_value += share * value;
          mean_gradient += share * gradient;
          unsigned int d = 0;
          while (d < dim && ++i[d] + 1 == cuts[d].size())
            i[d++] = 0;
          if (d == dim)
            return {mean_value, mean_gradient};
        }
    }

    const Tree<dim>       *tree;
    dealii::Vector<double> values;
  };



  template <int dim>
  void
  check_means(const unsigned int seed, const unsigned int n)
  {
    const Tree<dim>      tree(seed);
    const Reference<dim> reference(tree);
    double               value_error = 0.0, gradient_error = 0.0;
    unsigned int         n_checked = 0;
    for (const auto &box : TreeTools::random_boxes(tree.tria, n, 0.4, seed))
      {
        // only boxes inside: the reference does not clip
        if (centre_in_grid(tree, box).distance(box.centre) > 1e-14)
          continue;
        ++n_checked;
        double                 value = 0.0;
        dealii::Tensor<1, dim> gradient;
        for (const auto &node : tree(box))
          {
            value += node.weight * reference.values[node.node];
            gradient += node.gradient * reference.values[node.node];
          }
        const auto expected = reference.mean(box);
        value_error = std::max(value_error, std::abs(value - expected.first));
        gradient_error = std::max(gradient_error,
                                  (gradient - expected.second).norm() /
                                    std::max(1.0, expected.second.norm()));
      }
    CHECK(n_checked > n / 10);
    CHECK(value_error < 1e-11);
    CHECK(gradient_error < 1e-9);
  }



  double
  weight_of(const std::vector<NodeWeight<2>>     &nodes,
            const dealii::types::global_dof_index node)
  {
    for (const auto &seen : nodes)
      if (seen.node == node)
        return seen.weight;
    return 0.0;
  }



  template <int dim>
  double
  largest_change(const std::vector<NodeWeight<dim>> &a,
                 const std::vector<NodeWeight<dim>> &b,
                 const bool                          of_gradients)
  {
    std::map<dealii::types::global_dof_index, dealii::Tensor<1, dim + 1>> all;
    for (const auto &[list, sign] : {std::make_pair(&a, 1.0), {&b, -1.0}})
      for (const auto &node : *list)
        {
          all[node.node][dim] += sign * node.weight;
          for (unsigned int d = 0; d < dim; ++d)
            all[node.node][d] += sign * node.gradient[d];
        }
    double result = 0.0;
    for (const auto &[node, change] : all)
      for (unsigned int d = of_gradients ? 0 : dim;
           d < (of_gradients ? dim : dim + 1);
           ++d)
        result = std::max(result, std::abs(change[d]));
    return result;
  }
} // namespace



TEST_CASE("Boxes see linear fields exactly on 2:1 trees", "[box weights]")
{
  // half edges up to 0.06 coarse edges (half of the finest cells), larger, and
  // larger than coarse cells
  for (const double largest : {0.06, 0.3, 1.2})
    for (unsigned int seed = 1; seed < 4; ++seed)
      check_linear<2>(seed, largest);
  check_linear<3>(4, 0.06);
  check_linear<3>(5, 0.5);
  check_linear<2>(6, 0.0);
  check_linear<3>(7, 0.0);
}



TEST_CASE("Boxes see the mean of any function of the space", "[box weights]")
{
  check_means<2>(8, 400);
  check_means<3>(9, 60);
}



TEST_CASE("A box without volume sees the shape functions", "[box weights]")
{
  const Tree<2>      tree(10);
  const Reference<2> reference(tree);
  for (const auto &box : TreeTools::random_boxes(tree.tria, 200, 0.0, 10))
    {
      double value = 0.0;
      for (const auto &node : tree(box))
        value += node.weight * reference.values[node.node];
      CHECK(value == Approx(reference.at(box.centre).first).margin(1e-11));
    }
  // on a node it sees this node only, on a hanging one its masters
  for (const auto &[dof, x] : tree.places)
    {
      const auto nodes = tree({x, dealii::Tensor<1, 2>()});
      if (!tree.hanging.is_constrained(dof))
        CHECK(weight_of(nodes, dof) == Approx(1.0).epsilon(1e-12));
      else
        for (const auto &[master, factor] :
             *tree.hanging.get_constraint_entries(dof))
          CHECK(weight_of(nodes, master) == Approx(factor).margin(1e-12));
    }
}



TEST_CASE("A box that fills a cell sees its vertices alike", "[box weights]")
{
  dealii::parallel::distributed::Triangulation<2> tria(MPI_COMM_SELF);
  TreeTools::make_coarse(tria);
  const dealii::FE_Q<2> fe(1);
  dealii::DoFHandler<2> dofs(tria);
  dofs.distribute_dofs(fe);
  dealii::AffineConstraints<double> none;
  none.close();
  const Grid::CellLattice<2> lattice(dofs);
  const BoxWeights<2>        weights(lattice, none);
  for (const auto &cell : dofs.active_cell_iterators())
    {
      std::vector<NodeWeight<2>> nodes;
      const dealii::Tensor<1, 2> half{{0.5 * cell->extent_in_direction(0),
                                       0.5 * cell->extent_in_direction(1)}};
      REQUIRE(weights.evaluate(cell->center(), half, nodes));
      for (const unsigned int v : cell->vertex_indices())
        CHECK(weight_of(nodes, cell->vertex_dof_index(v, 0)) ==
              Approx(0.25).epsilon(1e-12));
    }
}



TEST_CASE("A box outside the grid sees nothing", "[box weights]")
{
  const Tree<2>              tree(11);
  std::vector<NodeWeight<2>> nodes;
  const dealii::Tensor<1, 2> half{{0.1, 0.1}};
  CHECK_FALSE(tree.weights->evaluate({-1.0, 0.8}, half, nodes));
  CHECK_FALSE(tree.weights->evaluate({0.0, 2.0}, half, nodes));
  CHECK_FALSE(
    tree.weights->evaluate({5.0, 5.0}, dealii::Tensor<1, 2>(), nodes));
}



TEST_CASE("Weights change little when a box moves little", "[box weights]")
{
  const Tree<2> tree(12);
  const auto    coarse  = tree.tria.begin(0);
  double        weights = 0.0, gradients = 0.0;
  for (auto box : TreeTools::random_boxes(tree.tria, 1000, 0.1, 12))
    {
      double smallest = 1.0; // half edge over coarse edge
      for (unsigned int d = 0; d < 2; ++d)
        {
          const double edge   = coarse->extent_in_direction(d);
          box.half_lengths[d] = std::max(box.half_lengths[d], 0.02 * edge);
          smallest            = std::min(smallest, box.half_lengths[d] / edge);
        }
      const auto before = tree(box);
      for (unsigned int d = 0; d < 2; ++d)
        for (const double sign : {-1.0, 1.0})
          {
            // the box crosses the side that it touched
            constexpr double shift = 1e-7; // of the coarse edge
            const double     edge  = coarse->extent_in_direction(d);
            auto             moved = box;
            moved.centre[d] += sign * shift * edge;
            if (centre_in_grid(tree, moved).distance(moved.centre) > 1e-14 ||
                centre_in_grid(tree, box).distance(box.centre) > 1e-14)
              continue;
            const auto after = tree(moved);
            // |dN| <= shift |grad N|, of the finest cells at most 8 per edge
            weights =
              std::max(weights, largest_change(before, after, false) / shift);
            // of gradients: the share of the box that changes cells
            gradients = std::max(gradients,
                                 largest_change(before, after, true) * edge *
                                   smallest / shift);
          }
    }
  CHECK(weights > 0.1); // something has moved
  CHECK(weights < 8.0 * 1.01);
  CHECK(gradients < 2.0 * 8.0 * 3.0);
}



TEST_CASE("A part of a grid gives the weights of the whole one",
          "[box weights][mpi]")
{
  // Hanging nodes of ghost cells have masters beyond them: Space brings them.
  Grid::Parameters parameters;
  parameters.configuration       = Grid::ReferenceConfiguration::current;
  parameters.displacement_degree = 1;
  parameters.rotation_degree     = 1;
  for (unsigned int seed = 20; seed < 26; ++seed)
    {
      const Tree<2>                                   whole(seed);
      dealii::parallel::distributed::Triangulation<2> tria(MPI_COMM_WORLD);
      TreeTools::refine_randomly(tria, seed);
      REQUIRE(tria.n_global_active_cells() == whole.tria.n_active_cells());
      const Grid::Space<2>       space(tria, parameters, /*micropolar=*/true);
      const Grid::CellLattice<2> lattice(space.dof_handler());
      const BoxWeights<2>        weights(lattice, space.hanging_nodes());

      // nodes on the boundary, masters beyond the ghost cells too
      const auto                on_boundary = space.boundary_dofs(0, 1);
      std::vector<unsigned int> expected_on_boundary;
      for (unsigned int i = 0; i < space.relevant().n_elements(); ++i)
        {
          const auto &x = space.nodes()[i];
          if (space.components()[i] == 1 &&
              (x[0] < -0.3 + 1e-9 || x[0] > 0.9 - 1e-9 || x[1] < 0.7 + 1e-9 ||
               x[1] > 1.1 - 1e-9))
            expected_on_boundary.push_back(i);
        }
      REQUIRE(on_boundary == expected_on_boundary);

      std::mt19937                           random(seed);
      std::uniform_real_distribution<double> uniform(-1.0, 1.0);
      for (const auto &cell : space.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned())
          for (unsigned int i = 0; i < 10; ++i)
            {
              Box<2> box;
              for (unsigned int d = 0; d < 2; ++d)
                {
                  // reaches half a cell beyond its own, as far as the smallest
                  // neighbour
                  const double h      = 0.499 * cell->extent_in_direction(d);
                  box.centre[d]       = cell->center()[d] + h * uniform(random);
                  box.half_lengths[d] = h * std::abs(uniform(random));
                }
              std::vector<NodeWeight<2>> nodes;
              REQUIRE(weights.evaluate(box.centre, box.half_lengths, nodes));
              const auto expected = whole(box);
              REQUIRE(nodes.size() == expected.size());
              for (const auto &node : nodes)
                {
                  REQUIRE(space.relevant().is_element(node.node + 2));
                  const auto x    = space.nodes()[space.local(node.node)];
                  const auto same = std::find_if(
                    expected.begin(), expected.end(), [&](const auto &other) {
                      return whole.places.at(other.node).distance(x) < 1e-10;
                    });
                  REQUIRE(same != expected.end());
                  CHECK(node.weight == Approx(same->weight).margin(1e-13));
                  CHECK((node.gradient - same->gradient).norm() <
                        1e-12 * (1.0 + same->gradient.norm()));
                }
            }
    }
}
