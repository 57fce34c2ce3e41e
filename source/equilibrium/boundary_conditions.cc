// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/compat.h>
#include <riedel/equilibrium/boundary_conditions.h>

namespace Riedel::Equilibrium
{
  template <int dim>
  BoundaryConditions<dim>::BoundaryConditions(
    const BoundaryConditionParameters<dim> &parameters,
    const Grid::Body<dim>                  &body,
    const Grid::Space<dim>                 &space)
    : parameters(&parameters)
    , space(&space)
  {
    std::vector<bool> taken(space.relevant().n_elements(), false);
    for (unsigned int b = 0; b < parameters.boundaries.size(); ++b)
      {
        const auto &boundary = parameters.boundaries[b];
        const auto  id       = body.boundary(boundary.name);
        for (unsigned int c = 0; c < space.n_components(); ++c)
          {
            const auto &formula =
              (c < dim ? boundary.displacement[c] : boundary.rotation[c - dim]);
            if (!formula.given())
              continue;
            for (const unsigned int dof : space.boundary_dofs(id, c))
              if (!taken[dof])
                {
                  taken[dof]        = true;
                  const auto global = space.relevant().nth_index_in_set(dof);
                  // a hanging node follows its neighbours, which are prescribed
                  if (!space.hanging_nodes().is_constrained(global))
                    list.push_back(
                      {dof, b, c, space.owned().is_element(global)});
                }
          }
      }
    constraints =
      with_increments(std::vector<double>(space.relevant().n_elements(), 0.0));
  }



  template <int dim>
  double
  BoundaryConditions<dim>::value(const Prescribed &dof, const double s) const
  {
    const auto &boundary = parameters->boundaries[dof.boundary];
    const auto &formula =
      (dof.component < dim ? boundary.displacement[dof.component] :
                             boundary.rotation[dof.component - dim]);
    return formula(space->nodes()[dof.dof], s);
  }



  template <int dim>
  dealii::AffineConstraints<double>
  BoundaryConditions<dim>::with_increments(
    const std::vector<double> &increment) const
  {
    dealii::AffineConstraints<double> result;
    Compat::reinit_constraints(result, space->owned(), space->relevant());
    result.merge(space->hanging_nodes());
    for (const Prescribed &dof : list)
      {
        const auto global = space->relevant().nth_index_in_set(dof.dof);
        result.add_line(global);
        result.set_inhomogeneity(global, increment[dof.dof]);
      }
    result.close();
    return result;
  }



  template class BoundaryConditions<2>;
} // namespace Riedel::Equilibrium
