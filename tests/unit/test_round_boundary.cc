// SPDX-License-Identifier: LGPL-2.1-or-later
// Nodes that refinement adds to a round boundary are on its circle or sphere.
#include <riedel/errors.h>
#include <riedel/grid/round_boundary.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>

#include <catch2/catch.hpp>

using namespace Riedel;

namespace
{
  /// Largest distance of a node of a boundary from the sphere.
  template <int dim>
  double
  largest_distance(const dealii::Triangulation<dim> &tria,
                   const dealii::Point<dim>         &centre,
                   const double                      radius)
  {
    double distance = 0.0;
    for (const auto &cell : tria.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
          for (const unsigned int v : face->vertex_indices())
            distance =
              std::max(distance,
                       std::abs(centre.distance(face->vertex(v)) - radius));
    return distance;
  }



  template <int dim>
  void
  refine_ball()
  {
    dealii::Point<dim> centre;
    for (unsigned int d = 0; d < dim; ++d)
      centre[d] = 3.0 + d;
    dealii::Triangulation<dim> tria;
    dealii::GridGenerator::hyper_ball(tria, centre, 0.5);
    // without the shape that deal.II's generator has given to it
    tria.reset_all_manifolds();
    tria.set_all_manifold_ids(dealii::numbers::flat_manifold_id);
    Grid::make_round(tria, 0, "rim");
    tria.refine_global(3);
    REQUIRE(largest_distance(tria, centre, 0.5) < 1e-12);
  }
} // namespace



TEST_CASE("Round boundaries stay round in refinement", "[grid]")
{
  refine_ball<2>();
  refine_ball<3>();
}



TEST_CASE("Boundaries that are not round are refused", "[grid]")
{
  dealii::Triangulation<2> flat, slit;
  dealii::GridGenerator::subdivided_hyper_rectangle(
    flat, {3, 2}, dealii::Point<2>(), dealii::Point<2>(3.0, 2.0), true);
  // one straight side: its nodes are on no circle; all sides: nor are they
  REQUIRE_THROWS_AS(Grid::make_round(flat, 0, "left"), InputError);
  dealii::GridGenerator::subdivided_hyper_rectangle(
    slit, {3, 2}, dealii::Point<2>(), dealii::Point<2>(3.0, 2.0), false);
  REQUIRE_THROWS_AS(Grid::make_round(slit, 0, "edge"), InputError);
}
