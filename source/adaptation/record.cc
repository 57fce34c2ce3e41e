// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/adaptation/record.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace Riedel::Adaptation
{
  template <int dim>
  std::vector<double>
  summed_stress(const Points::MaterialPoints<dim> &points,
                const MPI_Comm                     communicator)
  {
    std::vector<double> sums, all;
    for (const auto &slot : points.layout().slots())
      if (slot.name == "stress")
        {
          sums.assign(slot.size(), 0.0);
          for (unsigned int p = 0; p < points.n_points(); ++p)
            for (unsigned int c = 0; c < slot.size(); ++c)
              sums[c] += points.row(p)[points.place.volume] *
                         points.row(p)[slot.first + c];
        }
    all.resize(sums.size());
    dealii::Utilities::MPI::sum(sums, communicator, all);
    return all;
  }



  double
  relative_change(const std::vector<double> &before,
                  const std::vector<double> &after)
  {
    double change = 0.0, size = 0.0;
    for (std::size_t c = 0; c < before.size(); ++c)
      {
        change += std::pow(after[c] - before[c], 2);
        size += std::pow(before[c], 2);
      }
    return size == 0.0 ? 0.0 : std::sqrt(change / size);
  }



  template std::vector<double>
  summed_stress(const Points::MaterialPoints<2> &, const MPI_Comm);
  template std::vector<double>
  summed_stress(const Points::MaterialPoints<3> &, const MPI_Comm);
} // namespace Riedel::Adaptation
