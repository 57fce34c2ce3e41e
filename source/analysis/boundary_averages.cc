// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/analysis/boundary_averages.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

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
    std::vector<double>                          area(names.size(), 0.0);
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
                      terms.push_back({b,
                                       fe.system_to_component_index(i).first,
                                       space.local(dofs[i]),
                                       weight});
                    }
                for (const unsigned int q :
                     face_values.quadrature_point_indices())
                  area[b] += face_values.JxW(q);
              }
    std::vector<double> total(area.size());
    dealii::Utilities::MPI::sum(area, space.communicator(), total);
    for (Term &term : terms)
      term.weight /= total[term.boundary];
  }



  template <int dim>
  std::vector<std::vector<double>>
  BoundaryAverages<dim>::operator()(const std::vector<double> &relevant) const
  {
    const unsigned int  n = space->n_components();
    std::vector<double> here(n_boundaries * n, 0.0), sums(n_boundaries * n);
    for (const Term &term : terms)
      here[term.boundary * n + term.component] +=
        term.weight * relevant[term.dof];
    dealii::Utilities::MPI::sum(here, space->communicator(), sums);

    std::vector<std::vector<double>> result;
    for (std::size_t b = 0; b < n_boundaries; ++b)
      result.emplace_back(sums.begin() + b * n, sums.begin() + (b + 1) * n);
    return result;
  }



  template class BoundaryAverages<2>;
} // namespace Riedel::Analysis
