// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/equilibrium/unseen_dofs.h>
#include <riedel/points/motion.h>

#include <algorithm>

namespace Riedel::Equilibrium
{
  namespace
  {
    /// Sums over the cells around a node of the mean of a cell's known nodes.
    struct Neighbours
    {
      std::vector<double> sum, count;
    };



    template <int dim>
    Neighbours
    sum_of_neighbours(const Grid::Space<dim>    &space,
                      const std::vector<double> &known,
                      const std::vector<double> &values)
    {
      Neighbours around;
      around.sum.resize(known.size());
      around.count.resize(known.size());
      for (const auto &cell : space.dof_handler().active_cell_iterators())
        if (!cell->is_artificial())
          for (unsigned int c = 0; c < space.n_components(); ++c)
            {
              double       mean    = 0.0;
              unsigned int n_known = 0;
              for (const unsigned int v : cell->vertex_indices())
                {
                  const unsigned int dof =
                    space.local(cell->vertex_dof_index(v, 0) + c);
                  if (known[dof] > 0.0)
                    {
                      mean += values[dof];
                      ++n_known;
                    }
                }
              if (n_known > 0)
                for (const unsigned int v : cell->vertex_indices())
                  {
                    const unsigned int dof =
                      space.local(cell->vertex_dof_index(v, 0) + c);
                    around.sum[dof] += mean / n_known;
                    around.count[dof] += 1.0;
                  }
            }
      return around;
    }
  } // namespace



  template <int dim>
  void
  continue_to_unseen(
    const Grid::Space<dim>          &space,
    const std::vector<unsigned int> &unseen_dofs,
    const std::vector<typename BoundaryConditions<dim>::Prescribed> &prescribed,
    const Grid::Frame<dim>                                          &next,
    LinearAlgebra::Vector                                           &du)
  {
    LinearAlgebra::Vector is_known = space.owned_vector();
    std::vector<double>   values, known(space.relevant().n_elements(), 1.0);
    for (const unsigned int dof : unseen_dofs)
      known[dof] = 0.0;
    for (const auto &dof : prescribed)
      known[dof.dof] = 1.0;
    const auto is_owned = [&space](const unsigned int dof) {
      return space.owned().is_element(space.relevant().nth_index_in_set(dof));
    };
    for (unsigned int dof = 0; dof < known.size(); ++dof)
      if (is_owned(dof))
        is_known.begin()[space.owned_place(dof)] = known[dof];

    space.gather(du, values);
    const double move = Points::largest_move(space, next, values, unseen_dofs);
    const double layers = 1.0 + std::min(move, 50.0);
    for (unsigned int layer = 0; layer < layers; ++layer)
      {
        const auto around = sum_of_neighbours(space, known, values);
        for (unsigned int dof = 0; dof < known.size(); ++dof)
          if (known[dof] == 0.0 && around.count[dof] > 0.0 && is_owned(dof))
            {
              du.begin()[space.owned_place(dof)] =
                around.sum[dof] / around.count[dof];
              is_known.begin()[space.owned_place(dof)] = 1.0;
            }
        space.gather(du, values);
        space.gather(is_known, known);
      }
    // others would keep what was extrapolated for them, more in every step
    for (unsigned int dof = 0; dof < known.size(); ++dof)
      if (known[dof] == 0.0 && is_owned(dof))
        du.begin()[space.owned_place(dof)] = 0.0;
  }



  template void
  continue_to_unseen(const Grid::Space<2> &,
                     const std::vector<unsigned int> &,
                     const std::vector<BoundaryConditions<2>::Prescribed> &,
                     const Grid::Frame<2> &,
                     LinearAlgebra::Vector &);
  template void
  continue_to_unseen(const Grid::Space<3> &,
                     const std::vector<unsigned int> &,
                     const std::vector<BoundaryConditions<3>::Prescribed> &,
                     const Grid::Frame<3> &,
                     LinearAlgebra::Vector &);
} // namespace Riedel::Equilibrium
