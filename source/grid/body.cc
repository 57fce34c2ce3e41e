// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/compat.h>
#include <riedel/grid/body.h>
#include <riedel/grid/round_boundary.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/grid_tools.h>

#include <fstream>

namespace Riedel::Grid
{
  namespace
  {
    template <int dim>
    dealii::BoundingBox<dim>
    make_box(const GeometryParameters   &geometry,
             const Parameters           &parameters,
             dealii::Triangulation<dim> &tria)
    {
      dealii::Point<dim>        body_lower, body_upper, lower, upper;
      std::vector<unsigned int> cells = parameters.cells;
      for (unsigned int d = 0; d < dim; ++d)
        {
          const double size = geometry.box[d] / parameters.cells[d];
          body_lower[d] = geometry.origin.empty() ? 0.0 : geometry.origin[d];
          body_upper[d] = body_lower[d] + geometry.box[d];
          lower[d]      = body_lower[d];
          upper[d]      = body_upper[d];
          if (!parameters.margin.empty())
            {
              lower[d] -= parameters.margin[2 * d] * size;
              upper[d] += parameters.margin[2 * d + 1] * size;
              cells[d] += parameters.margin[2 * d];
              cells[d] += parameters.margin[2 * d + 1];
            }
        }
      dealii::GridGenerator::subdivided_hyper_rectangle(
        tria, cells, lower, upper, /*colorize=*/true);
      return dealii::BoundingBox<dim>(std::make_pair(body_lower, body_upper));
    }



    template <int dim>
    void
    read_file(const std::string &file, dealii::Triangulation<dim> &tria)
    {
      std::ifstream stream(file);
      if (!stream)
        throw InputError("The grid file '" + file +
                         "' of Geometry/File cannot be opened.");
      dealii::GridIn<dim> reader(tria);
      try
        {
          const std::string ending = file.substr(file.rfind('.') + 1);
          reader.read(stream, dealii::GridIn<dim>::parse_format(ending));
        }
      catch (const dealii::ExceptionBase &exception)
        {
          throw InputError("The grid file '" + file +
                           "' of Geometry/File cannot be read:\n" +
                           exception.what());
        }
    }
  } // namespace



  template <int dim>
  Body<dim>::Body(const MPI_Comm            communicator,
                  const GeometryParameters &geometry,
                  const Parameters         &parameters)
    : tria(communicator)
    , names(geometry.boundary_names)
  {
    if (geometry.file.empty())
      box = make_box(geometry, parameters, tria);
    else
      read_file(geometry.file, tria);

    for (const auto id : tria.get_boundary_ids())
      if (names.count(id) == 0)
        throw InputError("The boundary " + std::to_string(id) +
                         " of the grid has no name: add '" +
                         std::to_string(id) +
                         ": its name' to Geometry/Boundary names.");

    // before refinement: every rank still knows all cells here
    for (const std::string &name : geometry.round_boundaries)
      make_round(tria, boundary(name), name);
    grid_box = dealii::GridTools::compute_bounding_box(tria);
    if (!geometry.file.empty())
      box = grid_box;
    if (parameters.periodic_axis)
      {
        // so that a rank's ghost cells include those across the tie
        const unsigned int axis = *parameters.periodic_axis;
        std::vector<dealii::GridTools::PeriodicFacePair<
          typename dealii::Triangulation<dim>::cell_iterator>>
          pairs;
        dealii::GridTools::collect_periodic_faces(
          tria, 2 * axis, 2 * axis + 1, axis, pairs);
        tria.add_periodicity(pairs);
      }
    tria.refine_global(parameters.refinements);
  }



  template <int dim>
  dealii::types::boundary_id
  Body<dim>::boundary(const std::string &name) const
  {
    for (const auto &[id, its_name] : names)
      if (its_name == name)
        return id;
    throw std::out_of_range("no boundary is called " + name);
  }



  template class Body<2>;
  template class Body<3>;
} // namespace Riedel::Grid
