// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/grid/space.h>
#include <riedel/output/parameters.h>
#include <riedel/output/point_fields.h>
#include <riedel/output/results_folder.h>
#include <riedel/points/material_points.h>

#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <string>
#include <utility>
#include <vector>

namespace Riedel::Output
{
  /**
   * Fields as files, a numbered set per output time: grid-NNNN.vtu (or .pvtu)
   * with displacement and micro-rotation at nodes and the points' fields as
   * volume means of cells, on the deformed grid; points-NNNN.vtu and
   * points-NNNN.h5 with every field of every point at its present position.
   * grid.pvd and points.pvd list them over the load parameter.
   */
  template <int dim>
  class Fields
  {
  public:
    Fields(const ResultsFolder &folder, const Parameters &parameters);

    /// Writes the next set; collective. @p solution: displacements and
    /// rotations at relevant dofs, by local number; of moving points
    /// Points::nodal_means().
    void
    write(const double                       load,
          const Grid::Space<dim>            &space,
          const std::vector<double>         &solution,
          const Points::MaterialPoints<dim> &points);

    /// The state of a run: the lists of files.
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &grid_files &point_files;
    }

    /// Removes the sets that are newer than the lists, and writes the lists.
    /// For rank 0.
    void
    resume() const;

  private:
    void
    write_grid(const std::string                 &name,
               const Grid::Space<dim>            &space,
               const std::vector<double>         &solution,
               const Points::MaterialPoints<dim> &points) const;

    void
    write_points(const std::string                 &name,
                 const double                       load,
                 const MPI_Comm                     communicator,
                 const Points::MaterialPoints<dim> &points) const;

    const ResultsFolder                        *folder;
    const Parameters                            parameters;
    std::vector<std::pair<double, std::string>> grid_files, point_files;
  };
} // namespace Riedel::Output
