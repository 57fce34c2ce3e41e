// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/points/current_supports.h>
#include <riedel/points/initial_supports.h>

namespace Riedel::Points
{
  template <int dim>
  std::unique_ptr<SupportBuilder<dim>>
  SupportBuilder<dim>::create(const Grid::Space<dim>       &space,
                              const Grid::Parameters       &grid,
                              const MovingPointsParameters &moving,
                              const std::vector<bool>      &is_wall,
                              const bool                    follow_deformation)
  {
    if (grid.configuration == Grid::ReferenceConfiguration::current)
      return std::make_unique<CurrentSupports<dim>>(
        space, grid, moving, is_wall, follow_deformation);
    return std::make_unique<InitialSupports<dim>>(space,
                                                  grid,
                                                  follow_deformation);
  }



  template class SupportBuilder<2>;
  template class SupportBuilder<3>;
} // namespace Riedel::Points
