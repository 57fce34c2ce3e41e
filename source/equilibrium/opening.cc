// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/equilibrium/opening.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>
#include <deal.II/fe/mapping_q1.h>

#include <limits>
#include <sstream>

namespace Riedel::Equilibrium
{
  namespace
  {
    /// A locally owned cell that contains a place, and where in it.
    template <int dim>
    std::pair<typename dealii::DoFHandler<dim>::active_cell_iterator,
              dealii::Point<dim>>
    find_cell(const dealii::DoFHandler<dim> &dofs,
              const dealii::Point<dim>      &place)
    {
      constexpr double             tolerance = 1e-8; // of a cell
      const dealii::MappingQ1<dim> mapping;
      for (const auto &cell : dofs.active_cell_iterators())
        if (cell->is_locally_owned() &&
            place.distance(cell->center()) <= cell->diameter())
          {
            try
              {
                const auto unit =
                  mapping.transform_real_to_unit_cell(cell, place);
                if (dealii::GeometryInfo<dim>::is_inside_unit_cell(unit,
                                                                   tolerance))
                  return {cell, unit};
              }
            catch (
              const typename dealii::Mapping<dim>::ExcTransformationFailed &)
              {
                // far outside of a distorted cell
              }
          }
      return {dofs.end(), place};
    }



    template <int dim>
    dealii::Point<dim>
    as_point(const std::vector<double> &place)
    {
      dealii::Point<dim> x;
      for (unsigned int d = 0; d < dim; ++d)
        x[d] = place[d];
      return x;
    }



    /// The first of the ranks that say so; their number if none does.
    /// Collective.
    unsigned int
    first_rank(const bool is_here, const MPI_Comm communicator)
    {
      return dealii::Utilities::MPI::min(
        is_here ? dealii::Utilities::MPI::this_mpi_process(communicator) :
                  dealii::Utilities::MPI::n_mpi_processes(communicator),
        communicator);
    }
  } // namespace



  template <int dim>
  Opening<dim>::Opening(const OpeningParameters<dim> &parameters,
                        const Grid::Space<dim>       &space)
    : weights(space.owned_vector())
  {
    add(parameters.to, parameters.component, 1.0, "To", space);
    add(parameters.from, parameters.component, -1.0, "From", space);
  }



  template <int dim>
  void
  Opening<dim>::add(const std::vector<double> &place,
                    const unsigned int         component,
                    const double               factor,
                    const std::string         &parameter,
                    const Grid::Space<dim>    &space)
  {
    const auto x            = as_point<dim>(place);
    const auto [cell, unit] = find_cell(space.dof_handler(), x);

    // a place on a face between ranks counts once
    const MPI_Comm     communicator = space.communicator();
    const unsigned int first =
      first_rank(cell != space.dof_handler().end(), communicator);
    if (first == dealii::Utilities::MPI::n_mpi_processes(communicator))
      {
        std::ostringstream text;
        text << "Loading/Opening/" << parameter << ": the place (" << x
             << ") m is not in the body.";
        throw InputError(text.str());
      }

    std::vector<double> shares(space.relevant().n_elements(), 0.0);
    if (first == dealii::Utilities::MPI::this_mpi_process(communicator))
      {
        std::vector<dealii::types::global_dof_index> dofs(
          space.element().n_dofs_per_cell());
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          if (space.element().system_to_component_index(i).first == component)
            shares[space.local(dofs[i])] +=
              factor * space.element().shape_value(i, unit);
      }
    space.scatter_add(shares, weights);
  }



  template <int dim>
  Opening<dim>::Opening(const OpeningParameters<dim>      &parameters,
                        const Grid::Space<dim>            &space,
                        const Points::MaterialPoints<dim> &points,
                        const Points::Supports<dim>       &supports)
    : weights(space.owned_vector())
  {
    add(parameters.to, parameters.component, 1.0, space, points, supports);
    add(parameters.from, parameters.component, -1.0, space, points, supports);
  }



  template <int dim>
  void
  Opening<dim>::add(const std::vector<double>         &place,
                    const unsigned int                 component,
                    const double                       factor,
                    const Grid::Space<dim>            &space,
                    const Points::MaterialPoints<dim> &points,
                    const Points::Supports<dim>       &supports)
  {
    const auto   x       = as_point<dim>(place);
    double       closest = std::numeric_limits<double>::infinity();
    unsigned int nearest = 0;
    for (unsigned int p = 0; p < points.n_points(); ++p)
      {
        const double distance = points.initial_position(p).distance(x);
        // rounding must not decide between equally near points
        if (distance < (1.0 - 1e-9) * closest)
          {
            closest = distance;
            nearest = p;
          }
      }
    const MPI_Comm communicator = space.communicator();
    const double   everywhere =
      dealii::Utilities::MPI::min(closest, communicator);
    const unsigned int first =
      first_rank(closest <= everywhere * (1.0 + 1e-9), communicator);

    double              moved = 0.0;
    std::vector<double> shares(space.relevant().n_elements(), 0.0);
    if (first == dealii::Utilities::MPI::this_mpi_process(communicator))
      {
        moved = points.position(nearest)[component] -
                points.initial_position(nearest)[component];
        for (const auto &patch : supports.patches)
          if (nearest >= patch.first_point &&
              nearest < patch.first_point + patch.n_points)
            {
              const unsigned int q = nearest - patch.first_point;
              for (unsigned int i = 0; i < patch.n_nodes; ++i)
                shares[supports.dofs[patch.first_dof +
                                     component * patch.n_nodes + i]] +=
                  factor *
                  supports.weight[patch.first_weight + q * patch.n_nodes + i];
            }
      }
    space.scatter_add(shares, weights);
    opening_before += factor * dealii::Utilities::MPI::sum(moved, communicator);
  }



  template class Opening<2>;
  template class Opening<3>;
} // namespace Riedel::Equilibrium
