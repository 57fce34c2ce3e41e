// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/continuum/generalised.h>
#include <riedel/errors.h>
#include <riedel/points/current_supports.h>
#include <riedel/points/merging.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <sstream>

namespace Riedel::Points
{
  template <int dim>
  CurrentSupports<dim>::CurrentSupports(const Grid::Space<dim>       &space,
                                        const Grid::Parameters       &grid,
                                        const MovingPointsParameters &moving,
                                        const std::vector<bool>      &is_wall,
                                        const bool follow_deformation)
    : space(&space)
    , parameters(grid)
    , moving(moving)
    , is_wall(is_wall)
    , follow_deformation(follow_deformation)
  {}



  template <int dim>
  dealii::Quadrature<dim>
  CurrentSupports<dim>::quadrature() const
  {
    // in the middle of equal boxes that fill the cell
    return dealii::QIterated<dim>(dealii::QMidpoint<1>(), moving.per_axis);
  }



  template <int dim>
  void
  CurrentSupports<dim>::rebuild(const std::vector<double> & /*solution*/,
                                MaterialPoints<dim> &points)
  {
    const Grid::CellLattice<dim> lattice(space->dof_handler());
    while (follow_deformation && split_large_boxes(lattice, points))
      points.relocate();
    if (follow_deformation)
      Merging<dim>(*space, lattice, points, moving).run(points);

    const BoxWeights<dim> weights(lattice, space->hanging_nodes());

    std::vector<CellPoints> cells;
    for (const auto &cell : space->dof_handler().active_cell_iterators())
      if (cell->is_locally_owned() &&
          points.particles().n_particles_in_cell(cell) > 0)
        cells.push_back(look_from(cell, weights, points));

    result = Supports<dim>();
    std::vector<Particle> order;
    for (unsigned int m = 0; m < points.materials().materials.size(); ++m)
      for (const CellPoints &cell : cells)
        add_patches(cell, m, points, order);
    points.set_order(order, space->frame());
    find_unseen_nodes();
  }



  template <int dim>
  typename CurrentSupports<dim>::CellPoints
  CurrentSupports<dim>::look_from(
    const typename dealii::DoFHandler<dim>::active_cell_iterator &cell,
    const BoxWeights<dim>                                        &weights,
    const MaterialPoints<dim>                                    &points) const
  {
    const auto &frame = space->frame();
    CellPoints  result;
    const auto  here = points.particles().particles_in_cell(cell);
    for (auto particle = here.begin(); particle != here.end(); ++particle)
      {
        const double          *row = particle->get_properties().data();
        dealii::Tensor<1, dim> half_lengths;
        if (points.place.half_length != Material::StateLayout::absent)
          half_lengths = points.half_lengths(row);
        for (unsigned int d = 0; d < dim; ++d)
          half_lengths[d] /= frame.stretch(d);

        std::vector<NodeWeight<dim>> seen;
        if (!weights.evaluate(particle->get_location(), half_lengths, seen))
          {
            std::ostringstream text;
            text << "The box of point " << particle->get_id() << " at ("
                 << frame.to_space(particle->get_location())
                 << ") m reaches beyond the neighbours of its cell: it is "
                 << "stretched to half edges of (" << half_lengths
                 << ") m on the undeformed grid.";
            throw ComputationError(text.str());
          }
        for (auto &node : seen)
          {
            for (unsigned int d = 0; d < dim; ++d)
              node.gradient[d] /= frame.stretch(d);
            result.nodes.push_back(node.node);
          }
        result.particles.push_back(particle);
        result.volume.push_back(row[points.place.volume]);
        result.seen.push_back(std::move(seen));
      }
    std::sort(result.nodes.begin(), result.nodes.end());
    result.nodes.erase(std::unique(result.nodes.begin(), result.nodes.end()),
                       result.nodes.end());
    return result;
  }



  template <int dim>
  void
  CurrentSupports<dim>::add_patches(const CellPoints          &cell,
                                    const unsigned int         material,
                                    const MaterialPoints<dim> &points,
                                    std::vector<Particle>     &order)
  {
    std::vector<unsigned int> mine;
    for (unsigned int q = 0; q < cell.particles.size(); ++q)
      if (points.material(cell.particles[q]) == material)
        mine.push_back(q);
    if (mine.empty())
      return;

    const unsigned int n = cell.nodes.size();
    const auto place_of  = [&cell](const dealii::types::global_dof_index node) {
      return static_cast<unsigned int>(
        std::lower_bound(cell.nodes.begin(), cell.nodes.end(), node) -
        cell.nodes.begin());
    };

    const bool         is_micropolar = space->is_micropolar();
    const unsigned int n_spin = is_micropolar ? Supports<dim>::n_spin : 0;
    typename Supports<dim>::Patch patch;
    patch.material              = material;
    patch.first_point           = order.size();
    patch.n_points              = mine.size();
    patch.n_nodes               = n;
    patch.n_rotation_nodes      = is_micropolar ? n : 0;
    patch.n_dofs                = (dim + n_spin) * n;
    patch.first_dof             = result.dofs.size();
    patch.first_weight          = result.weight.size();
    patch.first_rotation_weight = result.spin_weight.size();
    result.patches.push_back(patch);
    for (unsigned int c = 0; c < dim + n_spin; ++c)
      for (const auto node : cell.nodes)
        {
          result.global_dofs.push_back(node + c);
          result.dofs.push_back(space->local(node + c));
        }

    // rows sampled from the cell: the mean of all its points
    const bool has_mean = parameters.sampling != Grid::StrainSampling::full;
    std::vector<double> mean_weight(n, 0.0), mean(dim * n, 0.0);
    if (has_mean)
      {
        double volume = 0.0;
        for (unsigned int q = 0; q < cell.seen.size(); ++q)
          {
            volume += cell.volume[q];
            for (const auto &node : cell.seen[q])
              {
                const unsigned int a = place_of(node.node);
                mean_weight[a] += cell.volume[q] * node.weight;
                for (unsigned int d = 0; d < dim; ++d)
                  mean[d * n + a] += cell.volume[q] * node.gradient[d];
              }
          }
        for (double &value : mean_weight)
          value /= volume;
        for (double &value : mean)
          value /= volume;
      }

    std::vector<double> weight(n), gradient(dim * n);
    const auto          append = [](std::vector<double>       &array,
                           const std::vector<double> &values) {
      array.insert(array.end(), values.begin(), values.end());
    };
    const auto blend = [this](const std::vector<double> &others,
                              std::vector<double>        own) {
      const double share = parameters.own_strain_fraction;
      for (unsigned int i = 0; i < own.size(); ++i)
        own[i] = (1.0 - share) * others[i] + share * own[i];
      return own;
    };
    for (const unsigned int q : mine)
      {
        std::fill(weight.begin(), weight.end(), 0.0);
        std::fill(gradient.begin(), gradient.end(), 0.0);
        for (const auto &node : cell.seen[q])
          {
            const unsigned int a = place_of(node.node);
            weight[a]            = node.weight;
            for (unsigned int d = 0; d < dim; ++d)
              gradient[d * n + a] = node.gradient[d];
          }
        const bool is_assumed =
          parameters.sampling == Grid::StrainSampling::assumed;
        append(result.weight, weight);
        append(result.gradient, is_assumed ? blend(mean, gradient) : gradient);
        if (parameters.sampling == Grid::StrainSampling::mean_dilatation)
          for (unsigned int i = 0; i < dim * n; ++i)
            result.dilatation.push_back(mean[i] - gradient[i]);
        if (is_micropolar)
          {
            append(result.spin_weight,
                   is_assumed ? blend(mean_weight, weight) : weight);
            append(result.curvature_gradient, gradient);
          }
        result.volume.push_back(cell.volume[q]);
        order.push_back(cell.particles[q]);
      }
  }



  template <int dim>
  void
  CurrentSupports<dim>::find_unseen_nodes()
  {
    std::vector<double> weight(space->relevant().n_elements(), 0.0);
    for (const auto &patch : result.patches)
      for (unsigned int q = 0; q < patch.n_points; ++q)
        for (unsigned int i = 0; i < patch.n_dofs; ++i)
          weight[result.dofs[patch.first_dof + i]] +=
            result.weight[patch.first_weight + q * patch.n_nodes +
                          i % patch.n_nodes];
    LinearAlgebra::Vector sum = space->owned_vector();
    space->scatter_add(weight, sum);
    space->gather(sum, weight);

    // pieces of boxes that are no more than rounding do not count
    constexpr double least_weight = 1e-12;
    for (unsigned int i = 0; i < weight.size(); ++i)
      if (weight[i] < least_weight && !space->hanging_nodes().is_constrained(
                                        space->relevant().nth_index_in_set(i)))
        result.unseen_dofs.push_back(i);
  }



  template <int dim>
  void
  CurrentSupports<dim>::accept(const std::vector<double> &solution,
                               const std::vector<double> &du,
                               const std::vector<double> &increments,
                               MaterialPoints<dim>       &points)
  {
    points.accept();
    advance(du, increments, points);
    if (!follow_deformation)
      return;
    points.relocate();
    rebuild(solution, points);
  }



  template <int dim>
  bool
  CurrentSupports<dim>::split_large_boxes(const Grid::CellLattice<dim> &lattice,
                                          MaterialPoints<dim> &points) const
  {
    if (points.place.half_length == Material::StateLayout::absent)
      return false;
    constexpr double largest_share = 0.55; // of the cell's volume

    const auto                                        &frame = space->frame();
    std::vector<typename MaterialPoints<dim>::Halving> halvings;
    std::vector<unsigned int>                          touched;
    for (const auto &cell : space->dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const auto  here = points.particles().particles_in_cell(cell);
          const auto &own =
            lattice.leaves()[lattice.leaf_of(cell->active_cell_index())];
          for (auto particle = here.begin(); particle != here.end(); ++particle)
            {
              auto l = points.half_lengths(particle->get_properties().data());
              for (unsigned int d = 0; d < dim; ++d)
                l[d] /= frame.stretch(d);

              touched.clear();
              lattice.find(particle->get_location() - l,
                           particle->get_location() + l,
                           touched);
              unsigned int axis  = 0; // the longest, measured by the cell
              double       share = 1.0;
              for (unsigned int d = 0; d < dim; ++d)
                {
                  share *= 2.0 * l[d] / own.size[d];
                  if (l[d] / own.size[d] > l[axis] / own.size[axis])
                    axis = d;
                }
              double smallest = own.size[axis];
              for (const unsigned int leaf : touched)
                smallest =
                  std::min(smallest, lattice.leaves()[leaf].size[axis]);
              if (2.0 * l[axis] > smallest * (1.0 + 1e-9) ||
                  share > largest_share)
                halvings.push_back({particle, axis});
            }
        }
    if (dealii::Utilities::MPI::sum(halvings.size(), space->communicator()) ==
        0)
      return false;
    points.split(halvings, frame);
    hold_before_walls(points);
    return true;
  }



  template <int dim>
  void
  CurrentSupports<dim>::hold_before_walls(MaterialPoints<dim> &points) const
  {
    const auto &frame = space->frame();
    for (auto &particle : points.particles())
      {
        const auto x = frame.to_space(particle.get_location());
        const auto held =
          before_walls(x,
                       points.half_lengths(particle.get_properties().data()));
        if (held.distance(x) > 0.0)
          {
            points.count_held();
            particle.set_location(frame.to_grid(held));
          }
      }
  }



  template <int dim>
  void
  CurrentSupports<dim>::advance(const std::vector<double> &du,
                                const std::vector<double> &increments,
                                MaterialPoints<dim>       &points) const
  {
    using Order = Continuum::Generalised<dim>;
    const unsigned int n_generalised =
      space->is_micropolar() ? Order::n_micropolar : Order::n_gradient;
    for (const auto &patch : result.patches)
      for (unsigned int q = 0; q < patch.n_points; ++q)
        {
          const unsigned int p   = patch.first_point + q;
          double            *row = points.row(p);
          const double      *weight =
            &result.weight[patch.first_weight + q * patch.n_nodes];
          const unsigned int *dofs = &result.dofs[patch.first_dof];
          const auto          mean = [&](const unsigned int component) {
            double sum = 0.0;
            for (unsigned int a = 0; a < patch.n_nodes; ++a)
              sum += weight[a] * du[dofs[component * patch.n_nodes + a]];
            return sum;
          };

          dealii::Point<dim> x = points.position(p);
          for (unsigned int d = 0; d < dim; ++d)
            {
              const double u = mean(d);
              x[d] += u;
              row[points.place.displacement + d] += u;
            }
          if (patch.n_rotation_nodes > 0)
            {
              std::array<double, Supports<dim>::n_spin> theta;
              for (unsigned int k = 0; k < theta.size(); ++k)
                theta[k] = mean(dim + k);
              points.turn(p, theta);
            }
          if (!follow_deformation)
            continue;

          // the increments that the law has seen, so that 1 + e stays
          // proportional to the volume
          dealii::Tensor<2, dim> f;
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int j = 0; j < dim; ++j)
              f[i][j] = (i == j ? 1.0 : 0.0) +
                        increments[p * n_generalised + Order::gradient(i, j)];
          row[points.place.volume] *= determinant(f);
          if (points.place.deformation_gradient !=
              Material::StateLayout::absent)
            {
              dealii::Tensor<2, dim> F;
              double *F_row = row + points.place.deformation_gradient;
              for (unsigned int i = 0; i < dim; ++i)
                for (unsigned int j = 0; j < dim; ++j)
                  F[i][j] = F_row[i * dim + j];
              F = f * F;
              for (unsigned int i = 0; i < dim; ++i)
                for (unsigned int j = 0; j < dim; ++j)
                  F_row[i * dim + j] = F[i][j];
            }
          const auto held = before_walls(x, points.half_lengths(row));
          if (held.distance(x) > 0.0)
            points.count_held();
          points.move(p, held, space->frame());
        }
  }



  template <int dim>
  dealii::Point<dim>
  CurrentSupports<dim>::before_walls(
    const dealii::Point<dim>     &x,
    const dealii::Tensor<1, dim> &half_lengths) const
  {
    constexpr double   least_distance = 0.01; // of the half length
    const auto        &grid           = space->frame().grid();
    dealii::Point<dim> held           = x;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const double distance = least_distance * half_lengths[d];
        if (is_wall[2 * d])
          held[d] = std::max(held[d], grid.lower_bound(d) + distance);
        if (is_wall[2 * d + 1])
          held[d] = std::min(held[d], grid.upper_bound(d) - distance);
      }
    return held;
  }



  template class CurrentSupports<2>;
  template class CurrentSupports<3>;
} // namespace Riedel::Points
