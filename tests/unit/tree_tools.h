// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/grid/grid_generator.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

/// Random 2:1 trees and boxes for the tests of CellLattice and BoxWeights.
namespace TreeTools
{
  constexpr unsigned int n_levels = 4;

  /// A box of unequal edges whose cells are anisotropic, away from the origin.
  template <int dim>
  void
  make_coarse(dealii::Triangulation<dim> &tria)
  {
    const double              lower[] = {-0.3, 0.7, 2.0};
    const double              upper[] = {0.9, 1.1, 2.5};
    const unsigned int        cells[] = {3, 2, 1};
    std::vector<unsigned int> repetitions(cells, cells + dim);
    dealii::Point<dim>        a, b;
    for (unsigned int d = 0; d < dim; ++d)
      {
        a[d] = lower[d];
        b[d] = upper[d];
      }
    dealii::GridGenerator::subdivided_hyper_rectangle(tria, repetitions, a, b);
  }



  /// A number in [0, 1) that depends on the place only: trees are the same on
  /// every number of ranks.
  template <int dim>
  double
  number_at(const dealii::Point<dim> &x, const unsigned int seed)
  {
    std::uint64_t hash = seed;
    for (unsigned int d = 0; d < dim; ++d)
      hash = (hash ^ static_cast<std::uint64_t>(std::llround(x[d] * 1e7))) *
             6364136223846793005ull;
    hash ^= hash >> 29;
    return (hash * 2862933555777941757ull >> 11) * 0x1.0p-53;
  }



  /// Refines a random third of the cells n_levels - 1 times, and at first the
  /// cell in the lower corner.
  template <int dim>
  void
  refine_randomly(dealii::parallel::distributed::Triangulation<dim> &tria,
                  const unsigned int                                 seed)
  {
    make_coarse(tria);
    for (unsigned int level = 1; level < n_levels; ++level)
      {
        for (const auto &cell : tria.active_cell_iterators())
          if (cell->is_locally_owned() &&
              (number_at(cell->center(), seed) < 0.3 ||
               (level == 1 &&
                cell->vertex(0).distance(tria.begin(0)->vertex(0)) == 0.0)))
            cell->set_refine_flag();
        tria.execute_coarsening_and_refinement();
      }
  }



  /// A random tree on this process alone, with linear elements.
  template <int dim>
  struct Tree
  {
    explicit Tree(const unsigned int seed)
      : tria(MPI_COMM_SELF)
      , fe(1)
      , dofs(tria)
    {
      refine_randomly(tria, seed);
      dofs.distribute_dofs(fe);
    }

    dealii::parallel::distributed::Triangulation<dim> tria;
    dealii::FE_Q<dim>                                 fe;
    dealii::DoFHandler<dim>                           dofs;
  };



  template <int dim>
  struct Box
  {
    dealii::Point<dim>     centre;
    dealii::Tensor<1, dim> half_lengths;
  };



  /// Boxes of which many have a side on a face, an edge, a vertex or the
  /// grid's boundary: sides are random, or at cell sides of any level. Half
  /// edges are @p largest times the coarse cell's edges at most.
  template <int dim>
  std::vector<Box<dim>>
  random_boxes(const dealii::Triangulation<dim> &tria,
               const unsigned int                n,
               const double                      largest,
               const unsigned int                seed)
  {
    std::mt19937                           random(seed);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    const auto                             first = tria.begin(0);
    dealii::Point<dim>                     lower = first->vertex(0), upper;
    for (const auto &cell : tria.cell_iterators_on_level(0))
      for (unsigned int d = 0; d < dim; ++d)
        {
          lower[d] = std::min(lower[d], cell->vertex(0)[d]);
          upper[d] =
            std::max(upper[d], cell->vertex(cell->n_vertices() - 1)[d]);
        }

    std::vector<Box<dim>> boxes(n);
    for (Box<dim> &box : boxes)
      for (unsigned int d = 0; d < dim; ++d)
        {
          const double coarse = first->extent_in_direction(d);
          const double fine   = coarse / (1u << (n_levels - 1));
          box.half_lengths[d] = largest * coarse * uniform(random);
          box.centre[d] = lower[d] + (upper[d] - lower[d]) * uniform(random);
          const double choice = uniform(random);
          const auto   snap   = [&](const double x) {
            return lower[d] + fine * std::round((x - lower[d]) / fine);
          };
          if (choice < 0.2) // centre on a side
            box.centre[d] = snap(box.centre[d]);
          else if (choice < 0.4) // lower side of the box on one
            box.centre[d] =
              snap(box.centre[d] - box.half_lengths[d]) + box.half_lengths[d];
          else if (choice < 0.6) // upper side
            box.centre[d] =
              snap(box.centre[d] + box.half_lengths[d]) - box.half_lengths[d];
          box.centre[d] = std::min(std::max(box.centre[d], lower[d]), upper[d]);
        }
    return boxes;
  }
} // namespace TreeTools
