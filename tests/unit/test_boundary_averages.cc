// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/analysis/boundary_averages.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace Riedel;

namespace
{
  /// A grid of 8 x 4 cells of 1 m; that at (4.5, 3.5) m, at the top, is
  /// divided.
  struct Parameters
  {
    Grid::GeometryParameters geometry;
    Grid::Parameters         grid;

    Parameters()
    {
      geometry.box             = {8.0, 4.0};
      geometry.boundary_names  = {{0, "left"},
                                  {1, "right"},
                                  {2, "bottom"},
                                  {3, "top"}};
      grid.cells               = {8, 4};
      grid.displacement_degree = grid.rotation_degree = 1;
      grid.configuration = Grid::ReferenceConfiguration::current;
    }
  };



  struct Fixture : Parameters
  {
    Grid::Body<2>                 body;
    Grid::Space<2>                space;
    Analysis::BoundaryAverages<2> averages;

    Fixture()
      : body(MPI_COMM_WORLD, geometry, grid)
      , space(refine(body.triangulation()), grid, true)
      , averages(geometry.names(), body, space)
    {}

    static dealii::Triangulation<2> &
    refine(dealii::parallel::distributed::Triangulation<2> &tria)
    {
      for (const auto &cell : tria.active_cell_iterators())
        if (cell->is_locally_owned() &&
            cell->center().distance(dealii::Point<2>(4.5, 3.5)) < 0.1)
          cell->set_refine_flag();
      tria.execute_coarsening_and_refinement();
      return tria;
    }

    /// Values at the relevant dofs from component and place.
    template <typename Function>
    std::vector<double>
    field(const Function &function) const
    {
      std::vector<double> result;
      for (unsigned int i = 0; i < space.relevant().n_elements(); ++i)
        result.push_back(function(space.components()[i], space.nodes()[i]));
      return result;
    }

    /// Dofs of the nodes of which a condition holds.
    template <typename Condition>
    std::vector<unsigned int>
    nodes_where(const Condition &condition) const
    {
      std::vector<unsigned int> result;
      for (unsigned int i = 0; i < space.relevant().n_elements(); ++i)
        if (condition(space.nodes()[i]))
          result.push_back(i);
      return result;
    }

    unsigned int
    number(const std::string &name) const
    {
      const auto names = geometry.names();
      return std::find(names.begin(), names.end(), name) - names.begin();
    }
  };
} // namespace



TEST_CASE("Means over whole boundaries are those of linear fields",
          "[boundary averages][ranks]")
{
  const Fixture f;
  const auto    means =
    f.averages(f.field([](const unsigned int c, const auto &x) {
      return c + x[0] + 10.0 * x[1];
    }));
  for (unsigned int c = 0; c < 3; ++c)
    {
      CHECK(means[f.number("left")][c] == Approx(c + 20.0));
      CHECK(means[f.number("right")][c] == Approx(c + 28.0));
      CHECK(means[f.number("bottom")][c] == Approx(c + 4.0));
      CHECK(means[f.number("top")][c] == Approx(c + 44.0));
    }
}



TEST_CASE("Means over boundaries leave out nodes that material does not see",
          "[boundary averages][ranks]")
{
  const Fixture f;
  // the body fills the left half; what is beyond is anything
  const auto unseen = f.nodes_where([](const auto &x) { return x[0] > 5.01; });
  const auto means =
    f.averages(f.field([](const unsigned int c, const auto &x) {
      return x[0] > 5.01 ? 1e30 : c + x[0];
    }),
               unseen);
  for (unsigned int c = 0; c < 3; ++c)
    {
      CHECK(means[f.number("left")][c] == Approx(c));
      // nodes 0 to 5, the first with half of a cell's side
      CHECK(means[f.number("bottom")][c] == Approx(c + 15.0 / 5.5));
      // the same on top, where one side is divided
      CHECK(means[f.number("top")][c] == Approx(c + 15.0 / 5.5));
      // nobody sees the right side
      CHECK(std::isnan(means[f.number("right")][c]));
    }
}
