// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/adaptation/cell_order.h>
#include <riedel/adaptation/initial_point_transfer.h>
#include <riedel/compat.h>

#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>

#include <cstring>
#include <limits>
#include <map>

namespace Riedel::Adaptation
{
  namespace
  {
    /// Place in a list of points (X, then a row of @p width - dim values) of
    /// the one nearest to @p x. Of equally near ones the first.
    template <int dim>
    std::size_t
    nearest(const std::vector<double> &list,
            const std::size_t          width,
            const dealii::Point<dim>  &x)
    {
      std::size_t best    = 0;
      double      closest = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < list.size(); i += width)
        {
          double square = 0.0;
          for (unsigned int d = 0; d < dim; ++d)
            square += (list[i + d] - x[d]) * (list[i + d] - x[d]);
          // rounding must not decide between equally near points
          if (square < (1.0 - 1e-9) * closest)
            {
              closest = square;
              best    = i;
            }
        }
      return best;
    }
  } // namespace



  template <int dim>
  InitialPointTransfer<dim>::InitialPointTransfer(
    dealii::parallel::distributed::Triangulation<dim> &triangulation,
    Points::MaterialPoints<dim>                       &points,
    const dealii::Quadrature<dim>                     &quadrature)
    : triangulation(&triangulation)
    , points(&points)
    , quadrature(quadrature)
  {}



  template <int dim>
  void
  InitialPointTransfer<dim>::prepare()
  {
    old_points.assign(triangulation->n_active_cells(), {});
    for (const auto &cell : triangulation->active_cell_iterators())
      if (cell->is_locally_owned())
        for (const auto &particle : points->particles().particles_in_cell(cell))
          {
            auto      &list = old_points[cell->active_cell_index()];
            const auto row  = particle.get_properties();
            for (unsigned int d = 0; d < dim; ++d)
              list.push_back(particle.get_location()[d]);
            list.insert(list.end(), row.begin(), row.end());
          }
    // the points travel with the cells' data, not with the particle handler
    points->clear();

    using Status = typename dealii::Triangulation<dim>::CellStatus;
    handle       = triangulation->register_data_attach(
      [this](const Cell &cell, const Status status) {
        std::vector<double> all;
        if (status == dealii::Triangulation<dim>::CELL_COARSEN)
          for (unsigned int c = 0; c < cell->n_children(); ++c)
            {
              const auto &list =
                old_points[cell->child(c)->active_cell_index()];
              all.insert(all.end(), list.begin(), list.end());
            }
        else
          all = old_points[cell->active_cell_index()];
        std::vector<char> bytes(all.size() * sizeof(double));
        std::memcpy(bytes.data(), all.data(), bytes.size());
        return bytes;
      },
      /*returns_variable_size_data=*/true);
  }



  template <int dim>
  unsigned int
  InitialPointTransfer<dim>::weight(
    const Cell &,
    const typename dealii::Triangulation<dim>::CellStatus) const
  {
    return quadrature.size();
  }



  template <int dim>
  void
  InitialPointTransfer<dim>::finish()
  {
    old_points.clear();
    const std::size_t n_slots = points->layout().size();
    const std::size_t width   = dim + n_slots;
    const auto        place   = points->place;

    const dealii::FE_Nothing<dim> nothing;
    dealii::FEValues<dim>         values(nothing,
                                 quadrature,
                                 dealii::update_quadrature_points |
                                   dealii::update_JxW_values);

    // by active cell index: rows of the new points
    std::map<unsigned int, std::vector<double>> new_points;

    const auto replace = [&](const std::vector<Cell>   &cells,
                             const std::vector<double> &old) {
      double old_mass = 0.0, new_mass = 0.0;
      for (std::size_t i = 0; i < old.size(); i += width)
        old_mass += old[i + dim + place.mass];
      for (const Cell &cell : cells)
        {
          values.reinit(cell);
          auto &rows = new_points[cell->active_cell_index()];
          for (unsigned int q = 0; q < quadrature.size(); ++q)
            {
              const std::size_t from =
                nearest<dim>(old, width, values.quadrature_point(q)) + dim;
              const std::size_t to = rows.size();
              rows.insert(rows.end(),
                          old.begin() + from,
                          old.begin() + from + n_slots);
              const double V_0   = values.JxW(q);
              const double share = V_0 / rows[to + place.initial_volume];
              rows[to + place.initial_volume] = V_0;
              rows[to + place.volume] *= share;
              rows[to + place.mass] *= share;
              new_mass += rows[to + place.mass];
            }
        }
      if (new_mass > 0.0)
        for (const Cell &cell : cells)
          {
            auto &rows = new_points[cell->active_cell_index()];
            for (std::size_t i = 0; i < rows.size(); i += n_slots)
              rows[i + place.mass] *= old_mass / new_mass;
          }
    };

    using Status = typename dealii::Triangulation<dim>::CellStatus;
    using Bytes  = boost::iterator_range<std::vector<char>::const_iterator>;
    triangulation->notify_ready_to_unpack(
      handle, [&](const Cell &cell, const Status status, const Bytes &bytes) {
        std::vector<double> old(bytes.size() / sizeof(double));
        if (!old.empty())
          std::memcpy(old.data(), &*bytes.begin(), bytes.size());
        std::vector<Cell> cells = {cell};
        if (status == dealii::Triangulation<dim>::CELL_REFINE)
          {
            cells.clear();
            for (unsigned int c = 0; c < cell->n_children(); ++c)
              cells.push_back(cell->child(c));
          }
        // in a cell that stays, a point is the nearest to itself
        replace(cells, old);
      });

    const auto    cells  = cells_along_curve(*triangulation);
    std::uint64_t n_here = cells.size() * quadrature.size(), id = 0;
    const int     code = MPI_Exscan(&n_here,
                                &id,
                                1,
                                MPI_UINT64_T,
                                MPI_SUM,
                                Compat::communicator(*triangulation));
    AssertThrowMPI(code);
    for (const auto &cell : cells)
      {
        values.reinit(
          static_cast<typename dealii::Triangulation<dim>::cell_iterator>(
            cell));
        const auto &rows = new_points.at(cell->active_cell_index());
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          points->insert(cell,
                         quadrature.point(q),
                         values.quadrature_point(q),
                         id++,
                         rows.data() + q * n_slots);
      }
    points->finish_insertion();
  }



  template class InitialPointTransfer<2>;
  template class InitialPointTransfer<3>;
} // namespace Riedel::Adaptation
