// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/adaptation/grid_change.h>

#include <deal.II/distributed/solution_transfer.h>

namespace Riedel::Adaptation
{
  template <int dim>
  void
  change_grid(dealii::parallel::distributed::Triangulation<dim> &triangulation,
              Grid::Space<dim>                                  &space,
              PointTransfer<dim>                                &points,
              const std::vector<LinearAlgebra::Vector *>        &vectors)
  {
    const boost::signals2::scoped_connection weights =
      triangulation.signals.weight.connect(
        [&points](const auto &cell, const auto status) {
          return points.weight(cell, status);
        });

    std::vector<LinearAlgebra::Vector>         ghosted(vectors.size());
    std::vector<const LinearAlgebra::Vector *> old;
    for (std::size_t v = 0; v < vectors.size(); ++v)
      {
        ghosted[v].reinit(space.owned(),
                          space.relevant(),
                          space.communicator());
        ghosted[v] = *vectors[v];
        old.push_back(&ghosted[v]);
      }
    dealii::parallel::distributed::SolutionTransfer<dim, LinearAlgebra::Vector>
      transfer(space.dof_handler());

    triangulation.prepare_coarsening_and_refinement();
    transfer.prepare_for_coarsening_and_refinement(old);
    points.prepare();
    triangulation.execute_coarsening_and_refinement();

    space.distribute();
    for (LinearAlgebra::Vector *vector : vectors)
      *vector = space.owned_vector();
    std::vector<LinearAlgebra::Vector *> results = vectors;
    transfer.interpolate(results);
    for (LinearAlgebra::Vector *vector : vectors)
      space.hanging_nodes().distribute(*vector);
    points.finish();
  }



  template void
  change_grid(dealii::parallel::distributed::Triangulation<2> &,
              Grid::Space<2> &,
              PointTransfer<2> &,
              const std::vector<LinearAlgebra::Vector *> &);
  template void
  change_grid(dealii::parallel::distributed::Triangulation<3> &,
              Grid::Space<3> &,
              PointTransfer<3> &,
              const std::vector<LinearAlgebra::Vector *> &);
} // namespace Riedel::Adaptation
