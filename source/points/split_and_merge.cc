// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/compat.h>
#include <riedel/points/joint_box.h>
#include <riedel/points/material_points.h>

#include <deal.II/base/mpi.h>

#include <cmath>

/*
 * How MaterialPoints become more and fewer.
 */
namespace Riedel::Points
{
  namespace
  {
    /// Euclidean distance of the values of a slot, and the larger one's size.
    struct Distance
    {
      double difference = 0.0, size = 0.0;

      Distance(const double *a, const double *b, const unsigned int n)
      {
        double square = 0.0, square_a = 0.0, square_b = 0.0;
        for (unsigned int i = 0; i < n; ++i)
          {
            square += (a[i] - b[i]) * (a[i] - b[i]);
            square_a += a[i] * a[i];
            square_b += b[i] * b[i];
          }
        difference = std::sqrt(square);
        size       = std::sqrt(std::max(square_a, square_b));
      }
    };



    /// Slots of laws that are volume-weighted means of merged points: stresses,
    /// so that their sums are kept, and the strains that give elastic ones; the
    /// volume and the multiplier of a plastic law, which belong to them.
    bool
    is_mean(const std::string &slot)
    {
      return slot == "stress" || slot == "couple_stress" ||
             slot == "logarithmic_strain" || slot == "elastic_strain" ||
             slot == "elastic_curvature" || slot == "total_strain" ||
             slot == "volume_ratio" || slot == "plastic_multiplier";
    }
  } // namespace



  template <int dim>
  void
  MaterialPoints<dim>::add(const double *row,
                           const double  factor,
                           Sums         &sums) const
  {
    sums.volume += factor * row[place.volume];
    sums.mass += factor * row[place.mass];
    if (place.void_ratio != Material::StateLayout::absent)
      sums.solids += factor * row[place.volume] / (1.0 + row[place.void_ratio]);
  }



  template <int dim>
  void
  MaterialPoints<dim>::add_to_history(const std::uint64_t n_here,
                                      const Sums         &drift_here,
                                      std::uint64_t      &count)
  {
    const MPI_Comm communicator    = Compat::communicator(*triangulation);
    const std::vector<double> here = {drift_here.volume,
                                      drift_here.solids,
                                      drift_here.mass};
    std::vector<double>       all(here.size());
    dealii::Utilities::MPI::sum(here, communicator, all);
    drift_of_sums.volume += all[0];
    drift_of_sums.solids += all[1];
    drift_of_sums.mass += all[2];
    count += dealii::Utilities::MPI::sum(n_here, communicator);
  }



  template <int dim>
  dealii::Tensor<1, dim>
  MaterialPoints<dim>::displacement_over(const double       distance,
                                         const unsigned int axis,
                                         const double      *row) const
  {
    dealii::Tensor<2, dim> F;
    for (unsigned int i = 0; i < dim * dim; ++i)
      F[i / dim][i % dim] = row[place.deformation_gradient + i];
    dealii::Tensor<1, dim> offset;
    offset[axis] = distance;
    return offset - invert(F) * offset;
  }



  template <int dim>
  void
  MaterialPoints<dim>::split(const std::vector<Halving> &halvings,
                             const Grid::Frame<dim>     &frame)
  {
    // new ids are consecutive over the ranks
    const std::uint64_t n_here = halvings.size();
    std::uint64_t       before = 0;
    const int           code   = MPI_Exscan(&n_here,
                                &before,
                                1,
                                MPI_UINT64_T,
                                MPI_SUM,
                                Compat::communicator(*triangulation));
    AssertThrowMPI(code);
    auto id = handler.get_next_free_particle_index() + before;

    // Insertion invalidates iterators: first all changes, then all new points.
    struct NewPoint
    {
      dealii::Point<dim>                                        X;
      std::vector<double>                                       row;
      typename dealii::Triangulation<dim>::active_cell_iterator cell;
    };
    std::vector<NewPoint> new_points;
    Sums                  drift_here;
    for (auto [point, axis] : halvings)
      {
        const auto   row    = point->get_properties();
        const auto   cell   = point->get_surrounding_cell();
        const double offset = 0.5 * half_lengths(row.data())[axis];
        const auto   apart  = displacement_over(offset, axis, row.data());
        add(row.data(), -1.0, drift_here);
        for (const unsigned int halved : {place.initial_volume,
                                          place.volume,
                                          place.mass,
                                          place.half_length + axis})
          row[halved] *= 0.5;
        add(row.data(), 2.0, drift_here);

        dealii::Point<dim> x = frame.to_space(point->get_location());
        x[axis] += offset;
        for (unsigned int d = 0; d < dim; ++d)
          row[place.displacement + d] += apart[d];
        new_points.push_back({frame.to_grid(x),
                              std::vector<double>(row.begin(), row.end()),
                              cell});
        x[axis] -= 2.0 * offset;
        for (unsigned int d = 0; d < dim; ++d)
          row[place.displacement + d] -= 2.0 * apart[d];
        point->set_location(frame.to_grid(x));
      }
    for (const NewPoint &point : new_points)
      handler.insert_particle(point.X,
                              dealii::Point<dim>(),
                              id++,
                              point.cell,
                              dealii::ArrayView<const double>(point.row));
    handler.update_cached_numbers();
    add_to_history(n_here, drift_here, split_count);
  }



  template <int dim>
  bool
  MaterialPoints<dim>::are_near(const double *row,
                                const double *other,
                                const double  tolerance) const
  {
    if (row[place.material] != other[place.material])
      return false;
    for (const unsigned int i : more_places)
      if (row[i] != other[i])
        return false;

    const auto &law =
      *laws->materials[static_cast<unsigned int>(row[place.material])].law;
    double stress_size = 0.0;
    for (const auto &slot : law.layout().slots())
      {
        const unsigned int first = slots.find(slot.name);
        const Distance     distance(row + first, other + first, slot.size());
        if (slot.name == "stress")
          {
            stress_size = distance.size;
            if (distance.difference > tolerance * distance.size)
              return false;
          }
        else if (slot.name == "couple_stress")
          {
            // as a stress: by itself it may be no more than noise
            if (distance.difference > tolerance * stress_size * law.length())
              return false;
          }
        else if (slot.name == "void_ratio" || slot.name == "cohesion" ||
                 slot.name == "yield_stress")
          {
            if (distance.difference > tolerance * distance.size)
              return false;
          }
      }
    return true;
  }



  template <int dim>
  void
  MaterialPoints<dim>::merge_rows(double *row, const double *other) const
  {
    const double V = row[place.volume], V_other = other[place.volume];
    const double share   = V / (V + V_other);
    const auto   average = [&](const unsigned int i) {
      row[i] = share * row[i] + (1.0 - share) * other[i];
    };
    const auto &law =
      *laws->materials[static_cast<unsigned int>(row[place.material])].law;

    for (const auto &slot : law.layout().slots())
      {
        const unsigned int first = slots.find(slot.name);
        for (unsigned int i = first; i < first + slot.size(); ++i)
          if (slot.name == "void_ratio")
            row[i] = (V + V_other) /
                       (V / (1.0 + row[i]) + V_other / (1.0 + other[i])) -
                     1.0;
          else if (is_mean(slot.name))
            average(i);
          else if (V_other > V)
            row[i] = other[i];
      }
    for (unsigned int d = 0; d < dim; ++d)
      average(place.displacement + d);
    if (place.micro_rotation != Material::StateLayout::absent)
      for (unsigned int k = 0; k < (dim == 2 ? 1 : dim); ++k)
        average(place.micro_rotation + k);
    if (V_other > V)
      for (unsigned int i = 0; i < dim * dim; ++i)
        row[place.deformation_gradient + i] =
          other[place.deformation_gradient + i];
    for (const unsigned int i :
         {place.initial_volume, place.volume, place.mass})
      row[i] += other[i];
  }



  template <int dim>
  void
  MaterialPoints<dim>::set_half_lengths(
    const dealii::Tensor<1, dim> &half_lengths,
    double                       *row) const
  {
    dealii::Tensor<2, dim> F;
    for (unsigned int i = 0; i < dim * dim; ++i)
      F[i / dim][i % dim] = row[place.deformation_gradient + i];
    const double scale =
      std::pow(row[place.volume] / row[place.initial_volume] / determinant(F),
               1.0 / dim);
    for (unsigned int i = 0; i < dim * dim; ++i)
      row[place.deformation_gradient + i] *= scale;

    for (unsigned int d = 0; d < dim; ++d)
      row[place.half_length + d] = 1.0;
    const auto stretch = this->half_lengths(row);
    for (unsigned int d = 0; d < dim; ++d)
      row[place.half_length + d] = half_lengths[d] / stretch[d];
  }



  template <int dim>
  void
  MaterialPoints<dim>::merge(const std::vector<Pair> &pairs,
                             const Grid::Frame<dim>  &frame)
  {
    // Removal invalidates iterators: first all changes.
    std::vector<Particle> gone;
    Sums                  drift_here;
    for (auto [point, other] : pairs)
      {
        double       *row       = point->get_properties().data();
        const double *other_row = other->get_properties().data();
        const double  V         = row[place.volume];
        const double  share     = V / (V + other_row[place.volume]);
        const auto    box       = joint_box<dim>(
          {frame.to_space(point->get_location()), half_lengths(row)},
          {frame.to_space(other->get_location()), half_lengths(other_row)},
          share);
        Assert(box, dealii::ExcMessage("The points' boxes form no box."));

        add(row, -1.0, drift_here);
        add(other_row, -1.0, drift_here);
        merge_rows(row, other_row);
        set_half_lengths(box->half_lengths, row);
        add(row, 1.0, drift_here);

        // in coordinates of the grid: back and forth would round twice
        const dealii::Point<dim> X =
          point->get_location() +
          (1.0 - share) * (other->get_location() - point->get_location());
        point->set_location(X);
        gone.push_back(other);
      }
    handler.remove_particles(gone);
    handler.update_cached_numbers();
    add_to_history(gone.size(), drift_here, merged_count);
  }



  template void
  MaterialPoints<2>::split(const std::vector<Halving> &,
                           const Grid::Frame<2> &);
  template void
  MaterialPoints<2>::merge(const std::vector<Pair> &, const Grid::Frame<2> &);
  template bool
  MaterialPoints<2>::are_near(const double *,
                              const double *,
                              const double) const;
  template void
  MaterialPoints<3>::split(const std::vector<Halving> &,
                           const Grid::Frame<3> &);
  template void
  MaterialPoints<3>::merge(const std::vector<Pair> &, const Grid::Frame<3> &);
  template bool
  MaterialPoints<3>::are_near(const double *,
                              const double *,
                              const double) const;
} // namespace Riedel::Points
