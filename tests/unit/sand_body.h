// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/grid/body.h>
#include <riedel/grid/space.h>
#include <riedel/points/initial_supports.h>

#include <vector>

/// A body of sand under 100 kPa, 80 mm x 40 mm, fitted by finite elements of
/// 5 mm.
struct SandBody
{
  static Riedel::Grid::GeometryParameters
  box()
  {
    Riedel::Grid::GeometryParameters geometry;
    geometry.box            = {0.08, 0.04};
    geometry.boundary_names = {{0, "left"},
                               {1, "right"},
                               {2, "bottom"},
                               {3, "top"}};
    return geometry;
  }

  static Riedel::Grid::Parameters
  cells(const unsigned int nx, const unsigned int ny)
  {
    Riedel::Grid::Parameters grid;
    grid.cells = {nx, ny};
    return grid;
  }

  static Riedel::Material::Parameters<2>
  sand()
  {
    Riedel::Material::Parameters<2> result;
    result.materials.push_back(
      {"sand", Riedel::Material::create_law<2>("polar hypoplastic"), true, {}});
    return result;
  }

  static Riedel::Points::InitialStateParameters<2>
  pressed()
  {
    Riedel::Points::InitialStateParameters<2> initial;
    initial.void_ratio      = 0.6;
    initial.pressure_at_top = 1e5;
    return initial;
  }

  Riedel::Grid::GeometryParameters          geometry = box();
  Riedel::Grid::Parameters                  grid     = cells(16, 8);
  Riedel::Grid::Body<2>                     body;
  Riedel::Material::Parameters<2>           materials = sand();
  Riedel::Points::InitialStateParameters<2> initial;
  Riedel::Grid::Space<2>                    space;
  Riedel::Points::MaterialPoints<2>         points;
  Riedel::Points::InitialSupports<2>        supports;

  explicit SandBody(
    const MPI_Comm                                   communicator,
    const Riedel::Points::InitialStateParameters<2> &initial = pressed())
    : body(communicator, geometry, grid)
    , initial(initial)
    , space(body.triangulation(), grid, true)
    , points(body.triangulation(), materials)
    , supports(space, grid, true)
  {
    points.seed(supports.quadrature(), initial, body.extent());
    supports.rebuild(std::vector<double>(space.relevant().n_elements(), 0.0),
                     points);
  }
};
