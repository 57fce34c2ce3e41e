// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/errors.h>
#include <riedel/grid/round_boundary.h>

#include <deal.II/base/tensor.h>
#include <deal.II/grid/manifold_lib.h>

#include <cmath>
#include <limits>
#include <map>
#include <sstream>

namespace Riedel::Grid
{
  namespace
  {
    template <int dim>
    using Nodes = std::map<unsigned int, dealii::Point<dim>>;

    template <int dim>
    Nodes<dim>
    nodes_of(const dealii::Triangulation<dim> &tria,
             const dealii::types::boundary_id  boundary)
    {
      Nodes<dim> nodes;
      for (const auto &cell : tria.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && face->boundary_id() == boundary)
            for (const unsigned int v : face->vertex_indices())
              nodes[face->vertex_index(v)] = face->vertex(v);
      return nodes;
    }



    /// The centre of the sphere that is nearest to the nodes in the sense of
    /// |x - c|^2 - R^2; not a number if they are in a plane.
    template <int dim>
    dealii::Point<dim>
    centre_of(const Nodes<dim> &nodes)
    {
      dealii::Tensor<1, dim> mean;
      for (const auto &[index, node] : nodes)
        mean += node / static_cast<double>(nodes.size());

      // With places relative to the mean: sum x x^T 2 c = sum |x|^2 x.
      dealii::Tensor<2, dim> squares;
      dealii::Tensor<1, dim> cubes;
      for (const auto &[index, node] : nodes)
        {
          const dealii::Tensor<1, dim> x = node - mean;
          squares += outer_product(x, x);
          cubes += x.norm_square() * x;
        }
      const double size = std::pow(trace(squares), dim);
      if (!(determinant(squares) > 1e-9 * size))
        return dealii::Point<dim>(dealii::Tensor<1, dim>(
          mean * std::numeric_limits<double>::quiet_NaN()));
      return dealii::Point<dim>(
        dealii::Tensor<1, dim>(mean + 0.5 * (invert(squares) * cubes)));
    }
  } // namespace



  template <int dim>
  void
  make_round(dealii::Triangulation<dim>      &tria,
             const dealii::types::boundary_id boundary,
             const std::string               &name)
  {
    const Nodes<dim>         nodes  = nodes_of(tria, boundary);
    const dealii::Point<dim> centre = centre_of(nodes);
    const double             radius = centre.distance(nodes.begin()->second);
    for (const auto &[index, node] : nodes)
      // also if the centre is not a number
      if (!(std::abs(centre.distance(node) - radius) < 1e-5 * radius))
        {
          std::ostringstream text;
          text << "The boundary '" << name
               << "' of Geometry/Round boundaries is not round: its nodes are "
                  "on no "
               << (dim == 2 ? "circle" : "sphere") << ", see the one at ("
               << node << ") m.";
          throw InputError(text.str());
        }

    // the id of a boundary serves as that of its shape
    tria.set_all_manifold_ids_on_boundary(boundary, boundary);
    tria.set_manifold(boundary, dealii::SphericalManifold<dim>(centre));
  }



  template void
  make_round<2>(dealii::Triangulation<2> &,
                const dealii::types::boundary_id,
                const std::string &);
  template void
  make_round<3>(dealii::Triangulation<3> &,
                const dealii::types::boundary_id,
                const std::string &);
} // namespace Riedel::Grid
