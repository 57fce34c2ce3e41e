// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/equilibrium/balance.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <sstream>

/*
 * What a Balance tells of a step: reactions, work, and where it went wrong.
 */
namespace Riedel::Equilibrium
{
  template <int dim>
  std::vector<typename Balance<dim>::Reaction>
  Balance<dim>::reactions() const
  {
    const unsigned int     n         = boundary_parameters->boundaries.size();
    constexpr unsigned int n_numbers = dim + Grid::Space<dim>::n_spin;
    std::vector<double>    numbers(n * n_numbers, 0.0);
    for (const auto &dof : conditions.prescribed())
      if (dof.owned)
        {
          const double force = reaction.begin()[space->owned_place(dof.dof)];
          double      *here  = &numbers[dof.boundary * n_numbers];
          here[dof.component] += force;
          if (dof.component < dim)
            {
              // lever arms end at the present place of the node
              dealii::Tensor<1, dim> vector;
              vector[dof.component] = force;
              const auto moment =
                Continuum::moment_of(space->deformed_node(dof.dof, present),
                                     vector);
              for (unsigned int k = 0; k < Grid::Space<dim>::n_spin; ++k)
                here[dim + k] += moment[k];
            }
        }
    std::vector<double> sums(numbers.size());
    dealii::Utilities::MPI::sum(numbers, space->communicator(), sums);

    std::vector<Reaction> result(n);
    for (unsigned int b = 0; b < n; ++b)
      {
        for (unsigned int d = 0; d < dim; ++d)
          result[b].force[d] = sums[b * n_numbers + d] + surfaces[b].force[d];
        for (unsigned int k = 0; k < Grid::Space<dim>::n_spin; ++k)
          result[b].moment[k] =
            sums[b * n_numbers + dim + k] + surfaces[b].moment[k];
      }
    for (const auto &plate : accepted_plates)
      result.push_back({plate.force, plate.moment});
    return result;
  }



  template <int dim>
  double
  Balance<dim>::stress_work() const
  {
    return dealii::Utilities::MPI::sum(assembly.stress_work(),
                                       space->communicator());
  }



  template <int dim>
  double
  Balance<dim>::plate_work() const
  {
    return plates.work();
  }



  template <int dim>
  std::string
  Balance<dim>::describe_worst(const LinearAlgebra::Vector &r) const
  {
    double       largest = 0.0;
    unsigned int place   = 0;
    for (unsigned int i = 0; i < is_prescribed.size(); ++i)
      {
        const double value =
          std::abs(r.begin()[i]) / (is_rotation[i] ? length : 1.0);
        if (value > largest)
          {
            largest = value;
            place   = i;
          }
      }
    const MPI_Comm communicator = space->communicator();
    const auto     over_ranks =
      dealii::Utilities::MPI::min_max_avg(largest, communicator);
    std::string text;
    if (dealii::Utilities::MPI::this_mpi_process(communicator) ==
          over_ranks.max_index &&
        largest > 0.0)
      {
        const unsigned int local =
          space->local(space->owned().nth_index_in_set(place));
        const unsigned int component = space->components()[local];
        std::ostringstream stream;
        stream << "the largest is "
               << (component < dim ? "force " + std::to_string(component + 1) :
                                     std::string("moment"))
               << " at the node (" << space->nodes()[local] << ") m";
        text = stream.str();
      }
    return dealii::Utilities::MPI::broadcast(communicator,
                                             text,
                                             over_ranks.max_index);
  }



  template <int dim>
  std::string
  Balance<dim>::describe_refusal(const Residual &residual) const
  {
    const MPI_Comm communicator = space->communicator();
    std::string    text;
    const bool     mine =
      residual.sweep.total.reason != Material::Report::Refusal::none;
    if (mine)
      {
        const unsigned int p = residual.sweep.first_refused;
        std::ostringstream stream;
        stream << "point " << points->id(p) << " (initially at "
               << points->initial_position(p)
               << " m): " << Material::describe(residual.sweep.total.reason);
        text = stream.str();
      }
    const unsigned int rank =
      dealii::Utilities::MPI::this_mpi_process(communicator);
    const unsigned int n =
      dealii::Utilities::MPI::n_mpi_processes(communicator);
    const unsigned int first =
      dealii::Utilities::MPI::min(mine ? rank : n, communicator);
    return first == n ?
             std::string() :
             dealii::Utilities::MPI::broadcast(communicator, text, first);
  }



  template std::vector<Balance<2>::Reaction>
  Balance<2>::reactions() const;
  template double
  Balance<2>::stress_work() const;
  template double
  Balance<2>::plate_work() const;
  template std::string
  Balance<2>::describe_worst(const LinearAlgebra::Vector &) const;
  template std::string
  Balance<2>::describe_refusal(const Residual &) const;
  template std::vector<Balance<3>::Reaction>
  Balance<3>::reactions() const;
  template double
  Balance<3>::stress_work() const;
  template double
  Balance<3>::plate_work() const;
  template std::string
  Balance<3>::describe_worst(const LinearAlgebra::Vector &) const;
  template std::string
  Balance<3>::describe_refusal(const Residual &) const;
} // namespace Riedel::Equilibrium
