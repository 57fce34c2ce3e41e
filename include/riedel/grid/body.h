// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/grid/parameters.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/types.h>
#include <deal.II/distributed/tria.h>

#include <string>

namespace Riedel::Grid
{
  /**
   * The body before the first step: its triangulation, distributed over the
   * ranks by p4est, and its named boundaries.
   */
  template <int dim>
  class Body
  {
  public:
    /// Builds the triangulation. Throws InputError if the file of the grid
    /// cannot be read or has boundaries without a name.
    Body(const MPI_Comm            communicator,
         const GeometryParameters &geometry,
         const Parameters         &parameters);

    dealii::parallel::distributed::Triangulation<dim> &
    triangulation()
    {
      return tria;
    }

    const dealii::parallel::distributed::Triangulation<dim> &
    triangulation() const
    {
      return tria;
    }

    /// Id of a named boundary; the name must exist.
    dealii::types::boundary_id
    boundary(const std::string &name) const;

    /// Smallest box around the undeformed body [m], the same on all ranks.
    const dealii::BoundingBox<dim> &
    extent() const
    {
      return box;
    }

    /// Smallest box around the undeformed grid [m]: the body and its margin.
    const dealii::BoundingBox<dim> &
    grid_extent() const
    {
      return grid_box;
    }

  private:
    dealii::parallel::distributed::Triangulation<dim> tria;
    std::map<unsigned int, std::string>               names;
    dealii::BoundingBox<dim>                          box, grid_box;
  };
} // namespace Riedel::Grid
