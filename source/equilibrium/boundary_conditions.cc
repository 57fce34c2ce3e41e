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
    , body(&body)
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
    set_unseen({});
  }



  template <int dim>
  void
  BoundaryConditions<dim>::set_unseen(const std::vector<unsigned int> &dofs)
  {
    const unsigned int n = space->relevant().n_elements();
    fixed.assign(n, false);
    for (const Prescribed &dof : list)
      fixed[dof.dof] = true;
    unseen.clear();
    for (const unsigned int dof : dofs)
      if (!fixed[dof])
        {
          fixed[dof] = true;
          unseen.push_back(dof);
        }
    constraints = with_increments(std::vector<double>(n, 0.0));
  }



  template <int dim>
  Grid::Frame<dim>
  BoundaryConditions<dim>::walls(const double s) const
  {
    const auto        &grid   = body->grid_extent();
    Grid::Frame<dim>   result = Grid::Frame<dim>(grid);
    dealii::Point<dim> corners[2];
    for (unsigned int d = 0; d < dim; ++d)
      for (unsigned int end = 0; end < 2; ++end)
        {
          dealii::Point<dim> middle = grid.center();
          middle[d] = end == 0 ? grid.lower_bound(d) : grid.upper_bound(d);
          corners[end][d] = middle[d];
          for (const auto &boundary : parameters->boundaries)
            if (body->boundary(boundary.name) == 2 * d + end &&
                boundary.displacement[d].given())
              corners[end][d] += boundary.displacement[d](middle, s);
        }
    result.move_to(corners[0], corners[1]);
    return result;
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
    for (const unsigned int dof : unseen)
      result.add_line(space->relevant().nth_index_in_set(dof));
    result.close();
    return result;
  }



  template class BoundaryConditions<2>;
  template class BoundaryConditions<3>;
} // namespace Riedel::Equilibrium
