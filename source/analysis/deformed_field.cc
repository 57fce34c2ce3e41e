// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/analysis/deformed_field.h>

#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe_q.h>

namespace Riedel::Analysis
{
  namespace
  {
    /// The deformed position of a place in a cell, and its micro-rotation.
    struct Node
    {
      double x, y, rotation;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &x &y &rotation;
      }
    };
  } // namespace



  DeformedField
  collect_deformed_field(const Grid::Space<2>            &space,
                         const std::vector<double>       &solution,
                         const Points::MaterialPoints<2> &points)
  {
    const auto           &fe = space.element();
    const unsigned int    n  = fe.degree;
    const dealii::FE_Q<2> geometry(1);

    // Shape functions at the nodes of the triangles, the same in every cell.
    struct Place
    {
      std::vector<double> vertices, shapes;
    };
    std::vector<Place> places;
    for (unsigned int j = 0; j <= n; ++j)
      for (unsigned int i = 0; i <= n; ++i)
        {
          const dealii::Point<2> at(double(i) / n, double(j) / n);
          places.emplace_back();
          for (const unsigned int v : dealii::GeometryInfo<2>::vertex_indices())
            places.back().vertices.push_back(geometry.shape_value(v, at));
          for (unsigned int k = 0; k < fe.n_dofs_per_cell(); ++k)
            places.back().shapes.push_back(fe.shape_value(k, at));
        }

    std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
    std::vector<Node>                            nodes;
    for (const auto &cell : space.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned() &&
          points.particles().n_particles_in_cell(cell) > 0)
        {
          cell->get_dof_indices(dofs);
          for (const Place &place : places)
            {
              double value[3] = {0.0, 0.0, 0.0};
              for (const unsigned int v : cell->vertex_indices())
                {
                  const auto x = space.frame().to_space(cell->vertex(v));
                  for (unsigned int d = 0; d < 2; ++d)
                    value[d] += place.vertices[v] * x[d];
                }
              for (unsigned int k = 0; k < dofs.size(); ++k)
                {
                  const auto c = fe.system_to_component_index(k).first;
                  if (c == 2 || !points.are_moving())
                    value[c] +=
                      place.shapes[k] * solution[space.local(dofs[k])];
                }
              nodes.push_back({value[0], value[1], value[2]});
            }
        }

    const unsigned int  void_ratio = points.layout().find("void_ratio");
    std::vector<double> samples;
    if (void_ratio != Material::StateLayout::absent)
      for (unsigned int p = 0; p < points.n_points(); ++p)
        {
          const double *row = points.row(p);
          for (unsigned int d = 0; d < 2; ++d)
            samples.push_back(points.position(p)[d]);
          samples.push_back(row[void_ratio]);
        }

    const MPI_Comm communicator = space.communicator();
    const auto     all_nodes =
      dealii::Utilities::MPI::gather(communicator, nodes, 0);
    const auto all_samples =
      dealii::Utilities::MPI::gather(communicator, samples, 0);

    DeformedField field;
    for (const auto &part : all_nodes)
      for (const Node &node : part)
        {
          field.nodes.push_back({{node.x, node.y}});
          field.rotation.push_back(node.rotation);
        }
    const unsigned int per_cell = (n + 1) * (n + 1);
    for (unsigned int first = 0; first + per_cell <= field.nodes.size();
         first += per_cell)
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < n; ++i)
          {
            const unsigned int a = first + j * (n + 1) + i, b = a + 1,
                               c = a + n + 1, d = c + 1;
            // diagonals alternate, so that no direction is preferred
            if ((i + j) % 2 == 0)
              {
                field.triangles.push_back({{a, b, d}});
                field.triangles.push_back({{a, d, c}});
              }
            else
              {
                field.triangles.push_back({{a, b, c}});
                field.triangles.push_back({{b, d, c}});
              }
          }
    for (const auto &part : all_samples)
      for (std::size_t i = 0; i + 2 < part.size(); i += 3)
        {
          field.points.push_back({{part[i], part[i + 1]}});
          field.void_ratio.push_back(part[i + 2]);
        }
    return field;
  }
} // namespace Riedel::Analysis
