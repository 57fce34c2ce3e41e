// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/points/point_sums.h>

#include <deal.II/base/mpi.h>

#include <limits>

namespace Riedel::Points
{
  template <int dim>
  dealii::BoundingBox<dim>
  extent(const MaterialPoints<dim> &points, const MPI_Comm communicator)
  {
    // the upper bounds with the opposite sign: one communication for both
    std::vector<double> bounds(2 * dim, std::numeric_limits<double>::max());
    for (unsigned int p = 0; p < points.n_points(); ++p)
      {
        const auto x = points.position(p);
        const auto l = points.half_lengths(points.row(p));
        for (unsigned int d = 0; d < dim; ++d)
          {
            bounds[d]       = std::min(bounds[d], x[d] - l[d]);
            bounds[dim + d] = std::min(bounds[dim + d], -(x[d] + l[d]));
          }
      }
    std::vector<double> all(2 * dim);
    dealii::Utilities::MPI::min(bounds, communicator, all);
    dealii::Point<dim> lower, upper;
    for (unsigned int d = 0; d < dim; ++d)
      {
        lower[d] = all[d];
        upper[d] = -all[dim + d];
      }
    return dealii::BoundingBox<dim>(std::make_pair(lower, upper));
  }



  template <int dim>
  std::vector<double>
  nodal_means(const Grid::Space<dim>    &space,
              const MaterialPoints<dim> &points,
              const Supports<dim>       &supports)
  {
    const unsigned int  n = space.relevant().n_elements();
    std::vector<double> sum(n, 0.0), volume(n, 0.0);
    for (const auto &patch : supports.patches)
      for (unsigned int q = 0; q < patch.n_points; ++q)
        {
          const unsigned int p   = patch.first_point + q;
          const double      *row = points.row(p);
          for (unsigned int i = 0; i < patch.n_dofs; ++i)
            {
              const unsigned int c = i / patch.n_nodes;
              const double       share =
                supports.volume[p] *
                supports.weight[patch.first_weight + q * patch.n_nodes +
                                i % patch.n_nodes];
              const unsigned int dof = supports.dofs[patch.first_dof + i];
              volume[dof] += share;
              sum[dof] +=
                share * row[c < dim ? points.place.displacement + c :
                                      points.place.micro_rotation + c - dim];
            }
        }
    for (auto *array : {&sum, &volume})
      {
        LinearAlgebra::Vector all = space.owned_vector();
        space.scatter_add(*array, all);
        space.hanging_nodes().distribute(all);
        space.gather(all, *array);
      }
    for (unsigned int i = 0; i < n; ++i)
      sum[i] = volume[i] > 0.0 ? sum[i] / volume[i] : 0.0;
    return sum;
  }



  template dealii::BoundingBox<2>
  extent(const MaterialPoints<2> &, const MPI_Comm);
  template std::vector<double>
  nodal_means(const Grid::Space<2> &,
              const MaterialPoints<2> &,
              const Supports<2> &);
} // namespace Riedel::Points
