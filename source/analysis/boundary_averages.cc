// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/analysis/boundary_averages.h>
#include <riedel/grid/hanging_nodes.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <limits>

namespace Riedel::Analysis
{
  template <int dim>
  BoundaryAverages<dim>::BoundaryAverages(const std::vector<std::string> &names,
                                          const Grid::Body<dim>          &body,
                                          const Grid::Space<dim>         &space)
    : n_boundaries(names.size())
    , space(&space)
  {
    const auto               &fe = space.element();
    dealii::FEFaceValues<dim> face_values(
      fe,
      dealii::QGauss<dim - 1>(fe.degree + 1),
      dealii::update_values | dealii::update_JxW_values);
    std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
    for (const auto &cell : space.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        for (const auto &face : cell->face_iterators())
          for (unsigned int b = 0; b < names.size(); ++b)
            if (face->at_boundary() &&
                face->boundary_id() == body.boundary(names[b]))
              {
                face_values.reinit(cell, face);
                cell->get_dof_indices(dofs);
                for (unsigned int i = 0; i < dofs.size(); ++i)
                  if (fe.has_support_on_face(
                        i, cell->face_iterator_to_index(face)))
                    {
                      double weight = 0.0;
                      for (const unsigned int q :
                           face_values.quadrature_point_indices())
                        weight +=
                          face_values.shape_value(i, q) * face_values.JxW(q);
                      const auto c = fe.system_to_component_index(i).first;
                      Grid::for_masters(
                        space.hanging_nodes(),
                        dofs[i],
                        [&](const auto node, const double factor) {
                          terms.push_back(
                            {b, c, space.local(node), factor * weight});
                        });
                    }
              }
  }



  template <int dim>
  std::vector<std::vector<double>>
  BoundaryAverages<dim>::operator()(
    const std::vector<double>       &relevant,
    const std::vector<unsigned int> &unseen_dofs) const
  {
    std::vector<bool> is_unseen(relevant.size(), false);
    for (const unsigned int dof : unseen_dofs)
      is_unseen[dof] = true;

    // integrals of the field, behind them those of 1
    const unsigned int  n = space->n_components(), n_values = n_boundaries * n;
    std::vector<double> here(2 * n_values, 0.0), sums(here.size());
    for (const Term &term : terms)
      if (!is_unseen[term.dof])
        {
          const unsigned int place = term.boundary * n + term.component;
          here[place] += term.weight * relevant[term.dof];
          here[n_values + place] += term.weight;
        }
    dealii::Utilities::MPI::sum(here, space->communicator(), sums);

    std::vector<std::vector<double>> result(n_boundaries);
    for (unsigned int i = 0; i < n_values; ++i)
      result[i / n].push_back(sums[n_values + i] > 0.0 ?
                                sums[i] / sums[n_values + i] :
                                std::numeric_limits<double>::quiet_NaN());
    return result;
  }



  template class BoundaryAverages<2>;
  template class BoundaryAverages<3>;
} // namespace Riedel::Analysis
