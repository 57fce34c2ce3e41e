// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/adaptation/marking.h>
#include <riedel/compat.h>

#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_tools.h>

#include <cmath>

namespace Riedel::Adaptation
{
  namespace
  {
    /// Fewer cells than this share of the grid are not worth a change that only
    /// makes it coarse.
    constexpr double worth_coarsening = 0.05;

    /// If the grid changes anyway, cells that reach this share of a threshold
    /// are refined, too: they would be the next ones.
    constexpr double foresight = 0.8;



    /// Calls a function with the vertices of a cell and the hanging ones on its
    /// faces, by number.
    template <int dim, typename Function>
    void
    for_vertices(const typename dealii::Triangulation<dim>::cell_iterator &cell,
                 const Function &function)
    {
      for (const unsigned int v : cell->vertex_indices())
        function(cell->vertex_index(v));
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->has_children())
          for (unsigned int c = 0; c < cell->face(f)->n_children(); ++c)
            for (const unsigned int v :
                 cell->face(f)->child(c)->vertex_indices())
              function(cell->face(f)->child(c)->vertex_index(v));
    }



    /// Adds layers of neighbours over edges and corners to a set of cells,
    /// which each rank knows for its own ones.
    template <int dim>
    std::vector<bool>
    widen(
      const dealii::parallel::distributed::Triangulation<dim> &triangulation,
      std::vector<bool>                                        cells,
      const unsigned int                                       layers)
    {
      using Cell = typename dealii::Triangulation<dim>::active_cell_iterator;
      for (unsigned int layer = 0; layer < layers; ++layer)
        {
          dealii::GridTools::exchange_cell_data_to_ghosts<unsigned int>(
            triangulation,
            [&](const Cell &cell) {
              return static_cast<unsigned int>(
                cells[cell->active_cell_index()]);
            },
            [&](const Cell &cell, const unsigned int &value) {
              cells[cell->active_cell_index()] = (value != 0);
            });

          std::vector<bool> vertices(triangulation.n_vertices(), false);
          for (const auto &cell : triangulation.active_cell_iterators())
            if (!cell->is_artificial() && cells[cell->active_cell_index()])
              for_vertices<dim>(cell, [&](const unsigned int v) {
                vertices[v] = true;
              });
          for (const auto &cell : triangulation.active_cell_iterators())
            if (cell->is_locally_owned())
              for_vertices<dim>(cell, [&](const unsigned int v) {
                if (vertices[v])
                  cells[cell->active_cell_index()] = true;
              });
        }
      return cells;
    }
  } // namespace



  template <int dim>
  double
  cell_size(const typename dealii::Triangulation<dim>::cell_iterator &cell)
  {
    return std::pow(cell->measure(), 1.0 / dim);
  }



  template <int dim>
  bool
  mark(dealii::parallel::distributed::Triangulation<dim> &triangulation,
       const std::vector<double>                         &activity,
       const Limits                                      &limits)
  {
    const MPI_Comm communicator = Compat::communicator(triangulation);

    const auto reaching = [&](const double least) {
      std::vector<bool> result(triangulation.n_active_cells(), false);
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned())
          result[cell->active_cell_index()] =
            activity[cell->active_cell_index()] >= least;
      return result;
    };
    // rounding must not divide a cell that has the wanted size
    const auto too_large = [&](const auto &cell) {
      return static_cast<unsigned int>(cell->level()) < limits.finest_level &&
             cell_size<dim>(cell) > (1.0 + 1e-6) * limits.cell_size;
    };

    const std::vector<bool> active   = reaching(1.0);
    unsigned int            n_wanted = 0;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned() && active[cell->active_cell_index()] &&
          too_large(cell))
        ++n_wanted;
    const bool refines =
      dealii::Utilities::MPI::max(n_wanted, communicator) > 0;
    if (!refines && limits.coarsen_below == 0.0)
      return false;

    const std::vector<bool> wide =
      widen(triangulation, reaching(foresight), limits.buffer_layers);
    const std::vector<bool> alive =
      limits.coarsen_below == 0.0 ?
        std::vector<bool>(wide.size(), true) :
        // as many layers of children reach into every cell of a divided buffer:
        // it must not be made coarse at the next look
        widen(triangulation,
              reaching(limits.coarsen_below),
              limits.buffer_layers > 0 ? 2 * limits.buffer_layers - 1 : 0);
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const unsigned int c = cell->active_cell_index();
          if (refines && wide[c] && too_large(cell))
            cell->set_refine_flag();
          else if (!wide[c] && !alive[c] &&
                   static_cast<unsigned int>(cell->level()) >
                     limits.coarsest_level)
            cell->set_coarsen_flag();
        }
    // flags of cells whose siblings or neighbours forbid it are removed here
    triangulation.prepare_coarsening_and_refinement();
    if (refines)
      return true;

    unsigned int n_coarsened = 0;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned() && cell->coarsen_flag_set())
        ++n_coarsened;
    if (dealii::Utilities::MPI::sum(n_coarsened, communicator) >
        worth_coarsening * triangulation.n_global_active_cells())
      return true;
    for (const auto &cell : triangulation.active_cell_iterators())
      {
        cell->clear_refine_flag();
        cell->clear_coarsen_flag();
      }
    return false;
  }



  template bool
  mark(dealii::parallel::distributed::Triangulation<2> &,
       const std::vector<double> &,
       const Limits &);
  template double
  cell_size<2>(const dealii::Triangulation<2>::cell_iterator &);
  template bool
  mark(dealii::parallel::distributed::Triangulation<3> &,
       const std::vector<double> &,
       const Limits &);
  template double
  cell_size<3>(const dealii::Triangulation<3>::cell_iterator &);
} // namespace Riedel::Adaptation
