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



  namespace
  {
    /// Means of points at nodes, weighted with volume and shape function.
    /// @p values: n_points x (dim + n_spin); relevant dofs by local number,
    /// hanging nodes interpolated, zero at nodes that no point sees.
    template <int dim>
    std::vector<double>
    nodal_means(const Grid::Space<dim>    &space,
                const Supports<dim>       &supports,
                const std::vector<double> &values)
    {
      const unsigned int  n            = space.relevant().n_elements();
      const unsigned int  n_components = space.n_components();
      std::vector<double> sum(n, 0.0), volume(n, 0.0);
      for (const auto &patch : supports.patches)
        for (unsigned int q = 0; q < patch.n_points; ++q)
          {
            const unsigned int p = patch.first_point + q;
            for (unsigned int i = 0; i < patch.n_dofs; ++i)
              {
                const double share =
                  supports.volume[p] *
                  supports.weight[patch.first_weight + q * patch.n_nodes +
                                  i % patch.n_nodes];
                const unsigned int dof = supports.dofs[patch.first_dof + i];
                volume[dof] += share;
                sum[dof] +=
                  share * values[p * n_components + i / patch.n_nodes];
              }
          }
      LinearAlgebra::Vector mean = space.owned_vector(),
                            all  = space.owned_vector();
      space.scatter_add(sum, mean);
      space.scatter_add(volume, all);
      for (unsigned int i = 0; i < space.owned().n_elements(); ++i)
        mean.begin()[i] =
          all.begin()[i] > 0.0 ? mean.begin()[i] / all.begin()[i] : 0.0;
      space.hanging_nodes().distribute(mean);
      space.gather(mean, sum);
      return sum;
    }
  } // namespace



  template <int dim>
  std::vector<double>
  nodal_values(const Grid::Space<dim>    &space,
               const MaterialPoints<dim> &points,
               const Supports<dim>       &supports,
               const unsigned int         n_corrections)
  {
    const unsigned int  n_components = space.n_components();
    std::vector<double> missing(points.n_points() * n_components);
    for (unsigned int p = 0; p < points.n_points(); ++p)
      for (unsigned int c = 0; c < n_components; ++c)
        missing[p * n_components + c] =
          points.row(p)[c < dim ? points.place.displacement + c :
                                  points.place.micro_rotation + c - dim];

    auto result = nodal_means(space, supports, missing);
    auto change = result;
    for (unsigned int k = 0; k < n_corrections; ++k)
      {
        for (const auto &patch : supports.patches)
          for (unsigned int q = 0; q < patch.n_points; ++q)
            for (unsigned int i = 0; i < patch.n_dofs; ++i)
              missing[(patch.first_point + q) * n_components +
                      i / patch.n_nodes] -=
                supports.weight[patch.first_weight + q * patch.n_nodes +
                                i % patch.n_nodes] *
                change[supports.dofs[patch.first_dof + i]];
        change = nodal_means(space, supports, missing);
        for (unsigned int i = 0; i < result.size(); ++i)
          result[i] += change[i];
      }
    return result;
  }



  template dealii::BoundingBox<2>
  extent(const MaterialPoints<2> &, const MPI_Comm);
  template std::vector<double>
  nodal_values(const Grid::Space<2> &,
               const MaterialPoints<2> &,
               const Supports<2> &,
               const unsigned int);
  template dealii::BoundingBox<3>
  extent(const MaterialPoints<3> &, const MPI_Comm);
  template std::vector<double>
  nodal_values(const Grid::Space<3> &,
               const MaterialPoints<3> &,
               const Supports<3> &,
               const unsigned int);
} // namespace Riedel::Points
