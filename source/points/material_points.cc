// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/compat.h>
#include <riedel/continuum/rotation.h>
#include <riedel/points/initial_state.h>
#include <riedel/points/material_points.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_tools.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace Riedel::Points
{
  namespace
  {
    /// The slots that every point has, then those of the laws.
    template <int dim>
    Material::StateLayout
    make_layout(const Material::Parameters<dim> &materials,
                const bool                       has_box,
                const Material::StateLayout     &more)
    {
      const std::string        volume_unit = (dim == 2 ? "m2" : "m3");
      const std::string        mass_unit   = (dim == 2 ? "kg/m" : "kg");
      std::vector<std::string> axes;
      for (unsigned int d = 0; d < dim; ++d)
        axes.push_back(std::to_string(d + 1));

      Material::StateLayout layout;
      layout.add("material", "1", "number of the material, from 0");
      layout.add("initial_volume", volume_unit, "volume before the first step");
      layout.add("volume", volume_unit, "present volume");
      layout.add("mass", mass_unit, "mass");
      layout.add("displacement", "m", "displacement since the start", axes);
      if (materials.is_micropolar())
        layout.add("micro_rotation",
                   "rad",
                   dim == 2 ? "micro-rotation since the start" :
                              "rotation vector of the micro-rotation since the "
                              "start",
                   dim == 2 ? std::vector<std::string>{""} : axes);
      if (has_box)
        {
          std::vector<std::string> components;
          for (const std::string &i : axes)
            for (const std::string &j : axes)
              components.push_back(i + j);
          layout.add("half_length", "m", "half edges of the first box", axes);
          layout.add("deformation_gradient",
                     "1",
                     "deformation gradient since the start",
                     components);
        }
      layout.merge(more);
      for (const auto &material : materials.materials)
        layout.merge(material.law->layout());
      return layout;
    }
  } // namespace



  template <int dim>
  MaterialPoints<dim>::MaterialPoints(
    dealii::parallel::distributed::Triangulation<dim> &triangulation,
    const Material::Parameters<dim>                   &materials,
    const MovingPointsParameters                      *moving,
    const Material::StateLayout                       &more)
    : triangulation(&triangulation)
    , laws(&materials)
    , moving(moving)
    , slots(
        make_layout(materials,
                    moving != nullptr && moving->shape == Shape::generalised,
                    more))
    , handler(triangulation, mapping, slots.size())
  {
    if (moving != nullptr)
      grid = dealii::GridTools::compute_bounding_box(triangulation);
    place.material             = slots.find("material");
    place.initial_volume       = slots.find("initial_volume");
    place.volume               = slots.find("volume");
    place.mass                 = slots.find("mass");
    place.displacement         = slots.find("displacement");
    place.micro_rotation       = slots.find("micro_rotation");
    place.half_length          = slots.find("half_length");
    place.deformation_gradient = slots.find("deformation_gradient");
    place.void_ratio           = slots.find("void_ratio");
    for (const auto &slot : more.slots())
      for (unsigned int c = 0; c < slot.size(); ++c)
        more_places.push_back(slots.find(slot.name) + c);

    for (const auto &material : materials.materials)
      {
        law_places.emplace_back();
        for (const auto &slot : material.law->layout().slots())
          for (unsigned int c = 0; c < slot.size(); ++c)
            law_places.back().push_back(slots.find(slot.name) + c);
      }
  }



  template <int dim>
  void
  MaterialPoints<dim>::seed(const dealii::Quadrature<dim>     &quadrature,
                            const InitialStateParameters<dim> &initial,
                            const dealii::BoundingBox<dim>    &body)
  {
    const auto &tria = *triangulation;

    const dealii::FE_Nothing<dim> nothing;
    dealii::FEValues<dim>         cell_values(nothing,
                                      quadrature,
                                      dealii::update_quadrature_points |
                                        dealii::update_JxW_values);

    const auto is_filled = [&body](const auto &cell) {
      return cell->is_locally_owned() && body.point_inside(cell->center());
    };
    const unsigned int per_axis = static_cast<unsigned int>(
      std::lround(std::pow(quadrature.size(), 1.0 / dim)));

    // Ids are consecutive over the ranks.
    std::uint64_t n_here = 0;
    for (const auto &cell : tria.active_cell_iterators())
      if (is_filled(cell))
        n_here += quadrature.size();
    std::uint64_t id  = 0;
    const int     err = MPI_Exscan(
      &n_here, &id, 1, MPI_UINT64_T, MPI_SUM, Compat::communicator(tria));
    AssertThrowMPI(err);

    const InitialState<dim> state_at(initial, body);
    std::vector<double>     row(slots.size());
    std::vector<double>     state;
    for (const auto &cell : tria.active_cell_iterators())
      if (is_filled(cell))
        {
          cell_values.reinit(cell);
          for (unsigned int q = 0; q < quadrature.size(); ++q)
            {
              const dealii::Point<dim> &x = cell_values.quadrature_point(q);
              const double              volume = cell_values.JxW(q);
              const int                 m      = laws->material_at(x);
              if (m < 0)
                {
                  std::ostringstream message;
                  message << "No material claims the point (" << x
                          << ") m. Give one material no Box, so that it fills "
                             "the whole body, or widen a Box.";
                  throw InputError(message.str());
                }

              const Material::InitialState point = state_at(x);
              const Material::Law<dim>    &law   = *laws->materials[m].law;
              state.assign(law.layout().size(), 0.0);
              law.initialise(point, state.data());

              std::fill(row.begin(), row.end(), 0.0);
              row[place.material]       = m;
              row[place.initial_volume] = volume;
              row[place.volume]         = volume;
              row[place.mass] =
                state_at.unit_weight(point.void_ratio) * volume / gravity;
              for (unsigned int i = 0; i < state.size(); ++i)
                row[law_places[m][i]] = state[i];
              if (place.half_length != Material::StateLayout::absent)
                for (unsigned int d = 0; d < dim; ++d)
                  {
                    row[place.half_length + d] =
                      cell->extent_in_direction(d) / (2.0 * per_axis);
                    row[place.deformation_gradient + d * dim + d] = 1.0;
                  }

              insert(cell, quadrature.point(q), x, id++, row.data());
            }
        }
    finish_insertion();
  }



  template <int dim>
  void
  MaterialPoints<dim>::prepare_for_new_grid()
  {
    handler.prepare_for_coarsening_and_refinement();
  }



  template <int dim>
  void
  MaterialPoints<dim>::arrive_on_new_grid()
  {
    handler.unpack_after_coarsening_and_refinement();
    handler.update_cached_numbers();
  }



  template <int dim>
  void
  MaterialPoints<dim>::clear()
  {
    handler.clear();
    set_order({});
  }



  template <int dim>
  void
  MaterialPoints<dim>::insert(
    const typename dealii::Triangulation<dim>::active_cell_iterator &cell,
    const dealii::Point<dim>           &place_in_cell,
    const dealii::Point<dim>           &position,
    const dealii::types::particle_index id,
    const double                       *slots_of_point)
  {
    handler.insert_particle(position,
                            place_in_cell,
                            id,
                            cell,
                            dealii::ArrayView<const double>(slots_of_point,
                                                            slots.size()));
  }



  template <int dim>
  void
  MaterialPoints<dim>::finish_insertion()
  {
    handler.update_cached_numbers();
  }



  template <int dim>
  void
  MaterialPoints<dim>::prepare_to_save()
  {
    handler.prepare_for_serialization();
  }



  template <int dim>
  void
  MaterialPoints<dim>::load()
  {
    handler.deserialize();
    handler.update_cached_numbers();
  }



  template <int dim>
  void
  MaterialPoints<dim>::remove_all()
  {
    handler.clear_particles();
  }



  template <int dim>
  unsigned int
  MaterialPoints<dim>::material(
    const typename dealii::Particles::ParticleHandler<dim>::particle_iterator
      &particle) const
  {
    return static_cast<unsigned int>(
      particle->get_properties()[place.material]);
  }



  template <int dim>
  void
  MaterialPoints<dim>::set_order(
    const std::vector<
      typename dealii::Particles::ParticleHandler<dim>::particle_iterator>
                           &order,
    const Grid::Frame<dim> &frame)
  {
    particle_at = order;
    rows.clear();
    ids.clear();
    positions.clear();
    cells.clear();
    law_ranges.clear();
    state_offset.clear();
    std::size_t offset = 0;
    for (auto particle : order)
      {
        const unsigned int m = material(particle);
        const unsigned int p = rows.size();
        rows.push_back(particle->get_properties().data());
        ids.push_back(particle->get_id());
        positions.push_back(frame.to_space(particle->get_location()));
        cells.push_back(particle->get_surrounding_cell()->active_cell_index());
        if (law_ranges.empty() || law_ranges.back().material != m)
          law_ranges.push_back({m, p, p});
        law_ranges.back().last = p + 1;
        state_offset.push_back(offset);
        offset += law_places[m].size();
      }
    Assert(law_ranges.size() <= laws->materials.size(),
           dealii::ExcMessage("Points of one material must be neighbours."));

    committed_states.resize(offset);
    trial_states.resize(offset);
    copy_states(/*to_rows=*/false);
  }



  template <int dim>
  void
  MaterialPoints<dim>::copy_states(const bool to_rows)
  {
    for (const Range &range : law_ranges)
      for (unsigned int p = range.first; p < range.last; ++p)
        {
          const auto &places = law_places[range.material];
          double     *state  = committed_states.data() + state_offset[p];
          for (unsigned int i = 0; i < places.size(); ++i)
            if (to_rows)
              rows[p][places[i]] = state[i];
            else
              state[i] = rows[p][places[i]];
        }
  }



  template <int dim>
  dealii::Tensor<1, dim>
  MaterialPoints<dim>::half_lengths(const double *row) const
  {
    dealii::Tensor<1, dim> lengths;
    if (place.half_length == Material::StateLayout::absent)
      return lengths;
    dealii::Tensor<2, dim> F;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        F[i][j] = row[place.deformation_gradient + i * dim + j];
    const dealii::Tensor<2, dim> C = transpose(F) * F;
    // the diagonal of U = sqrt(C)
    if constexpr (dim == 2)
      {
        // U = (C + det(F) I) / sqrt(tr C + 2 det F)
        const double J    = determinant(F);
        const double root = std::sqrt(trace(C) + 2.0 * J);
        for (unsigned int d = 0; d < dim; ++d)
          lengths[d] = row[place.half_length + d] * (C[d][d] + J) / root;
      }
    else
      for (const auto &[square, direction] :
           eigenvectors(dealii::symmetrize(C),
                        dealii::SymmetricTensorEigenvectorMethod::jacobi))
        for (unsigned int d = 0; d < dim; ++d)
          lengths[d] += row[place.half_length + d] * std::sqrt(square) *
                        direction[d] * direction[d];
    return lengths;
  }



  template <int dim>
  void
  MaterialPoints<dim>::move(const unsigned int        point,
                            const dealii::Point<dim> &x,
                            const Grid::Frame<dim>   &frame)
  {
    particle_at[point]->set_location(frame.to_grid(x));
  }



  template <int dim>
  void
  MaterialPoints<dim>::turn(
    const unsigned int                                             point,
    const std::array<double, Continuum::Generalised<dim>::n_spin> &theta)
  {
    double *phi = row(point) + place.micro_rotation;
    if constexpr (dim == 2)
      *phi += theta[0];
    else
      {
        const auto turned =
          Continuum::turned_further({{phi[0], phi[1], phi[2]}}, theta);
        std::copy(turned.begin(), turned.end(), phi);
      }
  }



  template <int dim>
  dealii::Point<dim>
  MaterialPoints<dim>::sortable_place(
    const dealii::Point<dim>                                 &X,
    const typename dealii::Triangulation<dim>::cell_iterator &cell) const
  {
    // A face of any cell is one of the finest grid over this cell's corner.
    const double n =
      1u << (triangulation->n_global_levels() - 1 - cell->level());
    dealii::Point<dim> result = X;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const double size  = cell->extent_in_direction(d) / n;
        const double place = (X[d] - cell->vertex(0)[d]) / size;
        // of a cell: more than what rounding does to a place
        const double tolerance =
          1e-12 + 32.0 * std::numeric_limits<double>::epsilon() *
                    (std::abs(X[d]) / size + n);
        if (std::abs(place - std::round(place)) > tolerance)
          continue;
        // towards the inside of the grid, where the cell is
        const double middle = cell->center()[d];
        const double face   = cell->vertex(0)[d] + std::round(place) * size;
        result[d] = face + (face < middle ? 2.0 : -2.0) * tolerance * size;
      }
    return result;
  }



  template <int dim>
  void
  MaterialPoints<dim>::relocate()
  {
    const MPI_Comm     communicator = Compat::communicator(*triangulation);
    std::uint64_t      n_lost       = 0;
    std::ostringstream first;
    const auto         connection = handler.signals.particle_lost.connect(
      [&](const Particle &particle, const auto &cell) {
        if (!grid.point_inside(particle->get_location()) && n_lost++ == 0)
          first << "Point " << particle->get_id()
                << " has left the grid: it is "
                << "at (" << particle->get_location()
                << ") m of the undeformed grid and was in the cell around ("
                << cell->center() << ") m";
      });
    for (auto &particle : handler)
      particle.set_location(sortable_place(particle.get_location(),
                                           particle.get_surrounding_cell()));
    const std::uint64_t n_before = handler.n_global_particles();
    handler.sort_particles_into_subdomains_and_cells();
    connection.disconnect();

    const std::uint64_t all = dealii::Utilities::MPI::sum(n_lost, communicator);
    // What is in cells that the rank does not know, deal.II says to be lost, or
    // drops without a word.
    const std::uint64_t n_dropped =
      n_before - all - handler.n_global_particles();
    if (n_dropped > 0)
      throw ComputationError(
        std::to_string(n_dropped) +
        " points have moved farther in one step than their rank knows the "
        "grid: beyond the neighbours of its cells.\nSet a smaller "
        "Loading/Largest step, or compute on fewer ranks.");
    if (all > 0 && !moving->remove_leaving)
      {
        const auto texts =
          dealii::Utilities::MPI::all_gather(communicator, first.str());
        for (const std::string &text : texts)
          if (!text.empty())
            throw ComputationError(
              text + ".\nGive the grid more Grid/Margin cells there, or \"set "
                     "Leaving points = remove\" in section Material points.");
      }
    removed_count += all;
    held_count += dealii::Utilities::MPI::sum(held_here, communicator);
    held_here = 0;
  }



  template <int dim>
  void
  MaterialPoints<dim>::accept()
  {
    std::swap(committed_states, trial_states);
    copy_states(/*to_rows=*/true);
  }



  template <int dim>
  std::string
  MaterialPoints<dim>::slot_names() const
  {
    std::string names;
    for (const auto &slot : slots.slots())
      names += (names.empty() ? "" : ", ") + slot.name + " " +
               std::to_string(slot.size());
    return names;
  }



  template <int dim>
  void
  MaterialPoints<dim>::check_slots(const std::string &names) const
  {
    if (names != slot_names())
      throw InputError("The run cannot be resumed: another version of Riedel "
                       "wrote its points, with the values\n  " +
                       names + "\ninstead of\n  " + slot_names());
  }



  template class MaterialPoints<2>;
  template class MaterialPoints<3>;
} // namespace Riedel::Points
