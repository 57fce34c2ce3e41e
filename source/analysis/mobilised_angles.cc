// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/analysis/mobilised_angles.h>
#include <riedel/analysis/statistics.h>
#include <riedel/continuum/generalised.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace Riedel::Analysis
{
  namespace
  {
    constexpr double degrees = 180. / M_PI;



    /// Sums up over the ranks and divides by the last value, the volume.
    template <std::size_t n>
    std::array<double, n>
    mean(const std::array<double, n + 1> &sums, const MPI_Comm communicator)
    {
      std::vector<double> here(sums.begin(), sums.end()), all(n + 1);
      dealii::Utilities::MPI::sum(here, communicator, all);
      std::array<double, n> result;
      for (std::size_t i = 0; i < n; ++i)
        result[i] = all[i] / all[n];
      return result;
    }
  } // namespace



  double
  coulomb_angle(const MobilisedAngles &angles)
  {
    return 45. + angles.friction / 2.;
  }



  double
  roscoe_angle(const MobilisedAngles &angles)
  {
    return 45. + angles.dilatancy / 2.;
  }



  double
  arthur_angle(const MobilisedAngles &angles)
  {
    return 45. + (angles.friction + angles.dilatancy) / 4.;
  }



  double
  dilatancy_angle(const double volume_increment, const double shear_increment)
  {
    if (!(shear_increment > 0.))
      return std::numeric_limits<double>::quiet_NaN();
    return std::asin(std::clamp(volume_increment / shear_increment, -1., 1.)) *
           degrees;
  }



  double
  dilatancy_angle(const std::array<double, 4> &H)
  {
    return dilatancy_angle(H[0] + H[3], std::hypot(H[0] - H[3], H[1] + H[2]));
  }



  double
  dilatancy_inside(const ShearBands &before, const ShearBands &now)
  {
    if (before.bands.empty() || now.bands.empty())
      return std::numeric_limits<double>::quiet_NaN();
    return dilatancy_angle(now.volume_strain - before.volume_strain,
                           now.shear_strain - before.shear_strain);
  }



  std::array<double, 4>
  mean_gradient(const Points::MaterialPoints<2> &points,
                const std::vector<double>       &increments,
                const MPI_Comm                   communicator)
  {
    using Order = Continuum::Generalised<2>;
    const unsigned int n =
      points.materials().materials.front().law->n_generalised();
    std::array<double, 5> sums = {};
    for (unsigned int p = 0; p < points.n_points(); ++p)
      {
        const double volume = points.row(p)[points.place.volume];
        for (unsigned int i = 0; i < 2; ++i)
          for (unsigned int j = 0; j < 2; ++j)
            sums[2 * i + j] +=
              volume * increments[p * n + Order::gradient(i, j)];
        sums[4] += volume;
      }
    return mean<4>(sums, communicator);
  }



  std::array<double, 5>
  mean_stress(const Points::MaterialPoints<2> &points,
              const MPI_Comm                   communicator)
  {
    const unsigned int    stress = points.layout().find("stress");
    std::array<double, 6> sums   = {};
    for (unsigned int p = 0; p < points.n_points(); ++p)
      {
        const double *row    = points.row(p);
        const double  volume = row[points.place.volume];
        for (unsigned int i = 0; i < 5; ++i)
          sums[i] += volume * row[stress + i];
        sums[5] += volume;
      }
    return mean<5>(sums, communicator);
  }



  double
  angle_to_minor_stress(const ShearBands            &bands,
                        const std::array<double, 5> &stress)
  {
    // tension is positive: the minor compressive stress is the largest one
    const double direction =
      0.5 * std::atan2(stress[3] + stress[4], stress[0] - stress[1]) * degrees;
    std::vector<double> angles;
    for (const ShearBand &band : bands.bands)
      {
        const double angle =
          std::fmod(std::abs(band.inclination - direction), 180.);
        angles.push_back(std::min(angle, 180. - angle));
      }
    return median(angles);
  }
} // namespace Riedel::Analysis
