// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/grid/hanging_nodes.h>
#include <riedel/points/box_weights.h>

#include <algorithm>

namespace Riedel::Points
{
  namespace
  {
    template <int dim>
    constexpr unsigned int n_vertices = 1u << dim;
  }



  template <int dim>
  BoxWeights<dim>::BoxWeights(
    const Grid::CellLattice<dim>            &lattice,
    const dealii::AffineConstraints<double> &constraints)
    : lattice(&lattice)
    , constraints(&constraints)
  {
    vertex_dofs.reserve(lattice.leaves().size() * n_vertices<dim>);
    for (const auto &leaf : lattice.leaves())
      for (unsigned int v = 0; v < n_vertices<dim>; ++v)
        vertex_dofs.push_back(leaf.cell->vertex_dof_index(v, 0));
  }



  template <int dim>
  void
  BoxWeights<dim>::add(const dealii::types::global_dof_index node,
                       const double                          weight,
                       const dealii::Tensor<1, dim>         &gradient,
                       std::vector<NodeWeight<dim>>         &nodes) const
  {
    for (auto &known : nodes)
      if (known.node == node)
        {
          known.weight += weight;
          known.gradient += gradient;
          return;
        }
    nodes.push_back({node, weight, gradient});
  }



  template <int dim>
  bool
  BoxWeights<dim>::evaluate(const dealii::Point<dim>     &centre,
                            const dealii::Tensor<1, dim> &half_lengths,
                            std::vector<NodeWeight<dim>> &nodes) const
  {
    nodes.clear();
    leaves.clear();
    const dealii::Point<dim> lower = centre - half_lengths,
                             upper = centre + half_lengths;
    if (!lattice->find(lower, upper, leaves) || leaves.empty())
      return false;

    double volume = 0.0;
    for (const unsigned int number : leaves)
      {
        const auto &leaf = lattice->leaves()[number];

        // the piece of the box in this leaf: its share and its centre
        double             share = 1.0;
        dealii::Point<dim> place; // in the leaf's own coordinates, 0 to 1
        for (unsigned int d = 0; d < dim; ++d)
          {
            const double from = std::max(lower[d], leaf.lower[d]);
            const double to = std::min(upper[d], leaf.lower[d] + leaf.size[d]);
            if (half_lengths[d] > 0.0)
              share *= (to - from) / (2.0 * half_lengths[d]);
            place[d] =
              ((half_lengths[d] > 0.0 ? 0.5 * (from + to) : centre[d]) -
               leaf.lower[d]) /
              leaf.size[d];
          }
        volume += share;

        for (unsigned int v = 0; v < n_vertices<dim>; ++v)
          {
            double                 weight = share;
            dealii::Tensor<1, dim> gradient;
            for (unsigned int d = 0; d < dim; ++d)
              gradient[d] = share;
            for (unsigned int d = 0; d < dim; ++d)
              {
                const bool   far   = (v >> d) & 1u;
                const double value = far ? place[d] : 1.0 - place[d];
                weight *= value;
                for (unsigned int e = 0; e < dim; ++e)
                  gradient[e] *=
                    e == d ? (far ? 1.0 : -1.0) / leaf.size[d] : value;
              }

            Grid::for_masters(*constraints,
                              vertex_dofs[number * n_vertices<dim> + v],
                              [&](const auto node, const double factor) {
                                add(node,
                                    factor * weight,
                                    factor * gradient,
                                    nodes);
                              });
          }
      }

    if (!(volume > 0.0))
      return false;
    for (auto &node : nodes)
      {
        node.weight /= volume;
        node.gradient /= volume;
      }
    std::sort(nodes.begin(), nodes.end(), [](const auto &a, const auto &b) {
      return a.node < b.node;
    });
    return true;
  }



  template class BoxWeights<2>;
  template class BoxWeights<3>;
} // namespace Riedel::Points
