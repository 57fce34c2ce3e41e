// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/grid/cell_lattice.h>
#include <riedel/points/motion.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace Riedel::Points
{
  template <int dim>
  double
  largest_move(const Grid::Space<dim>          &space,
               const Grid::Frame<dim>          &next,
               const std::vector<double>       &du,
               const std::vector<unsigned int> &unseen_dofs)
  {
    // all coarsest cells are equal, and every rank knows them
    const auto  &triangulation = space.dof_handler().get_triangulation();
    const auto   coarse        = triangulation.begin(0);
    const double divisions     = 1u << (triangulation.n_global_levels() - 1);

    std::vector<bool> is_unseen(du.size(), false);
    for (const unsigned int dof : unseen_dofs)
      is_unseen[dof] = true;
    double largest = 0.0;
    for (unsigned int i = 0; i < du.size(); ++i)
      {
        const unsigned int d = space.components()[i];
        if (d >= dim || is_unseen[i])
          continue;
        const auto        &X = space.nodes()[i];
        dealii::Point<dim> x = space.frame().to_space(X);
        x[d] += du[i];
        largest = std::max(largest,
                           std::abs(next.to_grid(x)[d] - X[d]) * divisions /
                             coarse->extent_in_direction(d));
      }
    return dealii::Utilities::MPI::max(largest, space.communicator());
  }



  template <int dim>
  std::uint64_t
  n_out_of_reach(const Grid::Space<dim>    &space,
                 const Grid::Frame<dim>    &next,
                 const std::vector<double> &du,
                 const MaterialPoints<dim> &points,
                 const Supports<dim>       &supports)
  {
    const Grid::CellLattice<dim> lattice(space.dof_handler());
    std::vector<unsigned int>    found;
    std::uint64_t                here = 0;
    for (const auto &patch : supports.patches)
      for (unsigned int q = 0; q < patch.n_points; ++q)
        {
          dealii::Point<dim> x = points.position(patch.first_point + q);
          for (unsigned int d = 0; d < dim; ++d)
            for (unsigned int a = 0; a < patch.n_nodes; ++a)
              x[d] +=
                supports.weight[patch.first_weight + q * patch.n_nodes + a] *
                du[supports.dofs[patch.first_dof + d * patch.n_nodes + a]];
          if (!next.grid().point_inside(x))
            continue; // that is another matter
          const auto X = next.to_grid(x);
          found.clear();
          if (!lattice.find(X, X, found))
            ++here;
        }
    return dealii::Utilities::MPI::sum(here, space.communicator());
  }



  template std::uint64_t
  n_out_of_reach(const Grid::Space<2> &,
                 const Grid::Frame<2> &,
                 const std::vector<double> &,
                 const MaterialPoints<2> &,
                 const Supports<2> &);
  template double
  largest_move(const Grid::Space<2> &,
               const Grid::Frame<2> &,
               const std::vector<double> &,
               const std::vector<unsigned int> &);
  template std::uint64_t
  n_out_of_reach(const Grid::Space<3> &,
                 const Grid::Frame<3> &,
                 const std::vector<double> &,
                 const MaterialPoints<3> &,
                 const Supports<3> &);
  template double
  largest_move(const Grid::Space<3> &,
               const Grid::Frame<3> &,
               const std::vector<double> &,
               const std::vector<unsigned int> &);
} // namespace Riedel::Points
