// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/equilibrium/surface_stabilisation.h>
#include <riedel/grid/hanging_nodes.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>

#include <algorithm>

namespace Riedel::Equilibrium
{
  namespace
  {
    /// Nodes of which less than this share of the surroundings is filled make
    /// their cells badly filled: all nodes at a surface, none inside.
    constexpr double well_filled = 0.75;



    /// What the points give to the nodes, by local number of a node's first
    /// dof.
    struct AtNodes
    {
      std::vector<double> filled;    ///< volume over that of a full grid
      std::vector<double> stiffness; ///< mean of the points [Pa]
    };



    template <int dim>
    AtNodes
    average(const Grid::Space<dim>            &space,
            const Points::MaterialPoints<dim> &points,
            const Points::Supports<dim>       &supports)
    {
      const unsigned int  n = space.relevant().n_elements();
      std::vector<double> volume(n, 0.0), stiffness(n, 0.0), full(n, 0.0);
      for (const auto &patch : supports.patches)
        {
          const auto &law = *points.materials().materials[patch.material].law;
          for (unsigned int q = 0; q < patch.n_points; ++q)
            {
              const unsigned int p = patch.first_point + q;
              const double       V = supports.volume[p];
              const double       k = law.stiffness(points.committed(p));
              for (unsigned int a = 0; a < patch.n_nodes; ++a)
                {
                  const double share =
                    V *
                    supports.weight[patch.first_weight + q * patch.n_nodes + a];
                  const unsigned int node = supports.dofs[patch.first_dof + a];
                  volume[node] += share;
                  stiffness[node] += share * k;
                }
            }
        }
      for (const auto &cell : space.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned())
          {
            double share = 1.0 / cell->n_vertices();
            for (unsigned int d = 0; d < dim; ++d)
              share *= cell->extent_in_direction(d) * space.frame().stretch(d);
            for (const unsigned int v : cell->vertex_indices())
              Grid::for_masters(space.hanging_nodes(),
                                cell->vertex_dof_index(v, 0),
                                [&](const auto node, const double factor) {
                                  full[space.local(node)] += factor * share;
                                });
          }

      for (auto *array : {&volume, &stiffness, &full})
        {
          LinearAlgebra::Vector sum = space.owned_vector();
          space.scatter_add(*array, sum);
          space.gather(sum, *array);
        }
      AtNodes result;
      result.filled.assign(n, 0.0);
      result.stiffness.assign(n, 0.0);
      for (unsigned int i = 0; i < n; ++i)
        if (volume[i] > 0.0)
          {
            result.filled[i]    = volume[i] / full[i];
            result.stiffness[i] = stiffness[i] / volume[i];
          }
      return result;
    }
  } // namespace



  template <int dim>
  SurfaceStabilisation<dim>::SurfaceStabilisation(const Grid::Space<dim> &space,
                                                  const double factor,
                                                  const double length)
    : space(&space)
    , factor(factor)
    , length(length)
  {}



  template <int dim>
  void
  SurfaceStabilisation<dim>::rebuild(const Points::MaterialPoints<dim> &points,
                                     const Points::Supports<dim> &supports)
  {
    rows.clear();
    if (factor == 0.0)
      return;
    const AtNodes           at_nodes = average(*space, points, supports);
    const dealii::FE_Q<dim> shape(1);
    const auto              rule = dealii::QGauss<dim - 1>(2);

    using Cell          = typename dealii::DoFHandler<dim>::cell_iterator;
    const auto nodes_of = [this](const Cell &cell) {
      std::vector<std::pair<dealii::types::global_dof_index, double>> list;
      for (const unsigned int v : cell->vertex_indices())
        Grid::for_masters(space->hanging_nodes(),
                          cell->vertex_dof_index(v, 0),
                          [&list](const auto node, const double factor) {
                            list.emplace_back(node, factor);
                          });
      return list;
    };
    std::vector<bool> is_unseen(space->relevant().n_elements(), false);
    for (const unsigned int dof : supports.unseen_dofs)
      is_unseen[dof] = true;
    const auto is_seen = [&](const auto &list) {
      return std::none_of(list.begin(), list.end(), [&](const auto &node) {
        return is_unseen[space->local(node.first)];
      });
    };
    const auto is_badly_filled = [&](const auto &list) {
      return std::any_of(list.begin(), list.end(), [&](const auto &node) {
        return at_nodes.filled[space->local(node.first)] < well_filled;
      });
    };

    for (const auto &cell : space->dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int f : cell->face_indices())
          {
            // Of two cells that share a face, the finer one has it, of equals
            // the one of the lower rank or number.
            if (cell->at_boundary(f) || cell->neighbor(f)->has_children())
              continue;
            const Cell neighbour = cell->neighbor(f);
            if (!cell->neighbor_is_coarser(f) &&
                (neighbour->subdomain_id() < cell->subdomain_id() ||
                 (neighbour->subdomain_id() == cell->subdomain_id() &&
                  neighbour->active_cell_index() < cell->active_cell_index())))
              continue;
            const auto mine = nodes_of(cell), theirs = nodes_of(neighbour);
            if (!is_seen(mine) || !is_seen(theirs) ||
                !(is_badly_filled(mine) || is_badly_filled(theirs)))
              continue;

            const unsigned int normal = f / 2;
            double             area   = 1.0;
            for (unsigned int d = 0; d < dim; ++d)
              if (d != normal)
                area *=
                  cell->extent_in_direction(d) * space->frame().stretch(d);
            const double h = cell->extent_in_direction(normal) *
                             space->frame().stretch(normal);
            double stiffness = 0.0;
            for (const auto &list : {mine, theirs})
              for (const auto &[node, share] : list)
                stiffness += share * at_nodes.stiffness[space->local(node)] /
                             (2.0 * cell->n_vertices());

            for (unsigned int q = 0; q < rule.size(); ++q)
              {
                // the point on the face, in the cell's own coordinates
                dealii::Point<dim> place;
                place[normal] = f % 2;
                for (unsigned int d = 0, e = 0; d < dim; ++d)
                  if (d != normal)
                    place[d] = rule.point(q)[e++];
                dealii::Point<dim> x = cell->vertex(0);
                for (unsigned int d = 0; d < dim; ++d)
                  x[d] += place[d] * cell->extent_in_direction(d);

                Row row;
                row.weight     = factor * stiffness * h * area * rule.weight(q);
                const auto add = [&](const Cell &side, const double sign) {
                  dealii::Point<dim> there;
                  for (unsigned int d = 0; d < dim; ++d)
                    there[d] = (x[d] - side->vertex(0)[d]) /
                               side->extent_in_direction(d);
                  for (const unsigned int v : side->vertex_indices())
                    {
                      const double slope = sign *
                                           shape.shape_grad(v, there)[normal] /
                                           (side->extent_in_direction(normal) *
                                            space->frame().stretch(normal));
                      const auto put = [&row, slope](const auto   node,
                                                     const double factor) {
                        const auto known =
                          std::find(row.nodes.begin(), row.nodes.end(), node);
                        if (known == row.nodes.end())
                          {
                            row.nodes.push_back(node);
                            row.row.push_back(factor * slope);
                          }
                        else
                          row.row[known - row.nodes.begin()] += factor * slope;
                      };
                      Grid::for_masters(space->hanging_nodes(),
                                        side->vertex_dof_index(v, 0),
                                        put);
                    }
                };
                add(cell, 1.0);
                add(neighbour, -1.0);
                rows.push_back(row);
              }
          }
  }



  template <int dim>
  void
  SurfaceStabilisation<dim>::add_forces(const std::vector<double> &du,
                                        std::vector<double>       &forces) const
  {
    for (const Row &row : rows)
      for (unsigned int c = 0; c < space->n_components(); ++c)
        {
          const double scale = c < dim ? 1.0 : length * length;
          double       jump  = 0.0;
          for (unsigned int a = 0; a < row.nodes.size(); ++a)
            jump += row.row[a] * du[space->local(row.nodes[a] + c)];
          for (unsigned int a = 0; a < row.nodes.size(); ++a)
            forces[space->local(row.nodes[a] + c)] +=
              scale * row.weight * jump * row.row[a];
        }
  }



  template <int dim>
  void
  SurfaceStabilisation<dim>::add_stiffness(
    const typename Loads<dim>::AddMatrix &add_matrix) const
  {
    std::vector<dealii::types::global_dof_index> dofs;
    std::vector<double>                          matrix;
    for (const Row &row : rows)
      for (unsigned int c = 0; c < space->n_components(); ++c)
        {
          const double       scale = c < dim ? 1.0 : length * length;
          const unsigned int n     = row.nodes.size();
          dofs.resize(n);
          matrix.resize(n * n);
          for (unsigned int a = 0; a < n; ++a)
            {
              dofs[a] = row.nodes[a] + c;
              for (unsigned int b = 0; b < n; ++b)
                matrix[a * n + b] =
                  scale * row.weight * row.row[a] * row.row[b];
            }
          add_matrix(dofs, matrix);
        }
  }



  template <int dim>
  std::vector<std::vector<dealii::types::global_dof_index>>
  SurfaceStabilisation<dim>::couplings() const
  {
    std::vector<std::vector<dealii::types::global_dof_index>> result;
    for (const Row &row : rows)
      for (unsigned int c = 0; c < space->n_components(); ++c)
        {
          result.push_back(row.nodes);
          for (auto &dof : result.back())
            dof += c;
        }
    return result;
  }



  template class SurfaceStabilisation<2>;
  template class SurfaceStabilisation<3>;
} // namespace Riedel::Equilibrium
