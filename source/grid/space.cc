// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/compat.h>
#include <riedel/grid/space.h>

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q1.h>

namespace Riedel::Grid
{
  namespace
  {
    template <int dim>
    dealii::FESystem<dim>
    make_element(const Parameters &parameters, const bool micropolar)
    {
      const dealii::FE_Q<dim> displacement(parameters.displacement_degree);
      const dealii::FE_Q<dim> rotation(parameters.rotation_degree);
      if (micropolar)
        return dealii::FESystem<dim>(displacement,
                                     dim,
                                     rotation,
                                     Space<dim>::n_spin);
      return dealii::FESystem<dim>(displacement, dim);
    }
  } // namespace



  template <int dim>
  Space<dim>::Space(const dealii::Triangulation<dim> &triangulation,
                    const Parameters                 &parameters,
                    const bool                        micropolar)
    : micropolar(micropolar)
    , reaches_into_ghost_cells(parameters.configuration ==
                               ReferenceConfiguration::current)
    , periodic_axis(parameters.periodic_axis)
    , fe(make_element<dim>(parameters, micropolar))
    , dofs(triangulation)
  {
    for (unsigned int c = 0; c < fe.n_components(); ++c)
      for (unsigned int a = 0;
           a < fe.base_element(c < dim ? 0 : 1).n_dofs_per_cell();
           ++a)
        cell_order.push_back(fe.component_to_system_index(c, a));
    distribute();
  }



  template <int dim>
  void
  Space<dim>::distribute()
  {
    dofs.distribute_dofs(fe);
    owned_dofs = dofs.locally_owned_dofs();
    dealii::DoFTools::extract_locally_relevant_dofs(dofs, relevant_dofs);

    Compat::reinit_constraints(hanging, owned_dofs, relevant_dofs);
    dealii::DoFTools::make_hanging_node_constraints(dofs, hanging);
    if (periodic_axis)
      {
        const unsigned int lower = 2 * *periodic_axis;
        dealii::DoFTools::make_periodicity_constraints(
          dofs, lower, lower + 1, *periodic_axis, hanging);
      }
    if (reaches_into_ghost_cells)
      add_masters_in_ghost_cells();
    hanging.close();
    has_hanging =
      dealii::Utilities::MPI::max(hanging.n_constraints(), communicator()) > 0;

    const unsigned int n_relevant = relevant_dofs.n_elements();
    component_of_dof.assign(n_relevant, 0);
    node_dofs.assign(n_relevant, {});
    std::vector<dealii::types::global_dof_index> cell_dofs(
      fe.n_dofs_per_cell());
    for (const auto &cell : dofs.active_cell_iterators())
      if (!cell->is_artificial())
        {
          cell->get_dof_indices(cell_dofs);
          for (unsigned int i = 0; i < cell_dofs.size(); ++i)
            if (relevant_dofs.is_element(cell_dofs[i]))
              {
                const auto [component, node] = fe.system_to_component_index(i);
                component_of_dof[local(cell_dofs[i])] = component;
                if (component < dim)
                  for (unsigned int d = 0; d < dim; ++d)
                    node_dofs[local(cell_dofs[i])][d] =
                      local(cell_dofs[fe.component_to_system_index(d, node)]);
                // points address a node by its first dof
                AssertThrow(
                  !reaches_into_ghost_cells ||
                    cell_dofs[i] ==
                      cell_dofs[fe.component_to_system_index(0, node)] +
                        component,
                  dealii::ExcMessage(
                    "The dofs of a node do not follow each other."));
              }
        }
    if (reaches_into_ghost_cells)
      for (unsigned int i = 0; i < n_relevant; ++i)
        {
          // all dofs are at vertices, so every rank owns whole nodes
          const unsigned int c =
            relevant_dofs.nth_index_in_set(i) % n_components();
          component_of_dof[i] = c;
          for (unsigned int d = 0; d < dim; ++d)
            node_dofs[i][d] = i - c + d;
        }

    owned_local.clear();
    ghost_local.clear();
    for (unsigned int i = 0; i < n_relevant; ++i)
      {
        const auto dof = relevant_dofs.nth_index_in_set(i);
        if (owned_dofs.is_element(dof))
          owned_local.push_back(i);
        else
          ghost_local.emplace_back(i, dof);
      }

    ghosted.reinit(owned_dofs, relevant_dofs, communicator());
    for (unsigned int i = 0; i < n_relevant; ++i)
      AssertThrow(ghosted.trilinos_partitioner().GID(static_cast<int>(i)) ==
                    static_cast<int>(relevant_dofs.nth_index_in_set(i)),
                  dealii::ExcMessage(
                    "Ghosted vectors are not ordered as the relevant dofs."));

    // Owners tell the others: of masters beyond its ghost cells a rank knows no
    // cell.
    std::map<dealii::types::global_dof_index, dealii::Point<dim>> positions;
    dealii::DoFTools::map_dofs_to_support_points(dealii::MappingQ1<dim>(),
                                                 dofs,
                                                 positions);
    node_positions.assign(n_relevant, dealii::Point<dim>());
    LinearAlgebra::Vector coordinate = owned_vector();
    std::vector<double>   relevant;
    for (unsigned int d = 0; d < dim; ++d)
      {
        for (const auto dof : owned_dofs)
          coordinate(dof) = positions.at(dof)[d];
        coordinate.compress(dealii::VectorOperation::insert);
        gather(coordinate, relevant);
        for (unsigned int i = 0; i < n_relevant; ++i)
          node_positions[i][d] = relevant[i];
      }
  }



  template <int dim>
  void
  Space<dim>::add_masters_in_ghost_cells()
  {
    // A master may hang between larger cells itself: until no rank needs more.
    bool complete = false;
    while (!complete)
      {
        // without an index set: lines that come from other ranks name masters
        // that this rank does not know yet
        dealii::AffineConstraints<double> exchanged;
        for (const auto &line : hanging.get_lines())
          {
            exchanged.add_line(line.index);
            exchanged.add_entries(line.index, line.entries);
          }
        exchanged.make_consistent_in_parallel(owned_dofs,
                                              relevant_dofs,
                                              communicator());
        hanging             = std::move(exchanged);
        const auto n_before = relevant_dofs.n_elements();
        for (const auto &line : hanging.get_lines())
          for (const auto &[master, weight] : line.entries)
            {
              // with all components of the node
              const auto first = master - master % n_components();
              relevant_dofs.add_range(first, first + n_components());
            }
        relevant_dofs.compress();
        complete =
          dealii::Utilities::MPI::sum(relevant_dofs.n_elements() - n_before,
                                      communicator()) == 0;

        dealii::AffineConstraints<double> all;
        Compat::reinit_constraints(all, owned_dofs, relevant_dofs);
        for (const auto &line : hanging.get_lines())
          {
            all.add_line(line.index);
            all.add_entries(line.index, line.entries);
          }
        hanging = std::move(all);
      }
  }



  template <int dim>
  MPI_Comm
  Space<dim>::communicator() const
  {
    return Compat::communicator(dofs);
  }



  template <int dim>
  std::vector<unsigned int>
  Space<dim>::boundary_dofs(const dealii::types::boundary_id id,
                            const unsigned int               component) const
  {
    dealii::ComponentMask mask(fe.n_components(), false);
    mask.set(component, true);
    const dealii::IndexSet on_boundary =
      dealii::DoFTools::extract_boundary_dofs(dofs, mask, {id});
    // Owners tell the others: a master beyond the ghost cells is on a boundary
    // that this rank does not see.
    LinearAlgebra::Vector is_on_boundary = owned_vector();
    for (const auto dof : on_boundary)
      if (owned_dofs.is_element(dof))
        is_on_boundary(dof) = 1.0;
    is_on_boundary.compress(dealii::VectorOperation::insert);
    std::vector<double> relevant;
    gather(is_on_boundary, relevant);
    std::vector<unsigned int> result;
    for (unsigned int i = 0; i < relevant.size(); ++i)
      if (relevant[i] > 0.0)
        result.push_back(i);
    return result;
  }



  template <int dim>
  LinearAlgebra::Vector
  Space<dim>::owned_vector() const
  {
    return LinearAlgebra::Vector(owned_dofs, communicator());
  }



  template <int dim>
  void
  Space<dim>::gather(const LinearAlgebra::Vector &owned,
                     std::vector<double>         &relevant) const
  {
    if (owned.size() == owned_dofs.n_elements())
      {
        // one rank has it all
        relevant.assign(owned.begin(), owned.end());
        return;
      }
    ghosted = owned;
    // end() is behind the owned entries, not behind the ghosts
    relevant.assign(ghosted.begin(),
                    ghosted.begin() + relevant_dofs.n_elements());
  }



  template <int dim>
  void
  Space<dim>::scatter_add(const std::vector<double> &relevant,
                          LinearAlgebra::Vector     &owned) const
  {
    double *values = owned.begin();
    for (unsigned int i = 0; i < owned_local.size(); ++i)
      values[i] += relevant[owned_local[i]];
    for (const auto &[i, dof] : ghost_local)
      if (relevant[i] != 0.0)
        owned(dof) += relevant[i];
    owned.compress(dealii::VectorOperation::add);
  }



  template class Space<2>;
  template class Space<3>;
} // namespace Riedel::Grid
