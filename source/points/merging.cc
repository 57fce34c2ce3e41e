// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/points/joint_box.h>
#include <riedel/points/merging.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace Riedel::Points
{
  template <int dim>
  Merging<dim>::Merging(const Grid::Space<dim>       &space,
                        const Grid::CellLattice<dim> &lattice,
                        const MaterialPoints<dim>    &points,
                        const MovingPointsParameters &parameters)
    : space(&space)
    , lattice(&lattice)
    , parameters(&parameters)
  {
    if (parameters.merge_above == 0 ||
        points.place.half_length == Material::StateLayout::absent)
      return;
    for (const auto &leaf : lattice.leaves())
      if (leaf.cell->is_locally_owned() &&
          points.particles().n_particles_in_cell(leaf.cell) >
            parameters.merge_above)
        full.push_back(leaf.cell);
  }



  template <int dim>
  void
  Merging<dim>::run(MaterialPoints<dim> &points) const
  {
    while (true)
      {
        std::vector<Pair> pairs;
        for (const Cell &cell : full)
          add_pairs(cell, points, pairs);
        if (dealii::Utilities::MPI::sum(pairs.size(), space->communicator()) ==
            0)
          return;
        points.merge(pairs, space->frame());
      }
  }



  template <int dim>
  void
  Merging<dim>::add_pairs(const Cell                &cell,
                          const MaterialPoints<dim> &points,
                          std::vector<Pair>         &pairs) const
  {
    std::vector<Candidate> candidates;
    dealii::Tensor<1, dim> edges; // sums, in cells
    const auto             here = points.particles().particles_in_cell(cell);
    for (auto particle = here.begin(); particle != here.end(); ++particle)
      {
        Candidate candidate;
        candidate.particle = particle;
        candidate.X        = particle->get_location();
        candidate.half_lengths =
          points.half_lengths(particle->get_properties().data());
        for (unsigned int d = 0; d < dim; ++d)
          {
            candidate.half_lengths[d] /= space->frame().stretch(d);
            edges[d] +=
              candidate.half_lengths[d] / cell->extent_in_direction(d);
          }
        candidates.push_back(candidate);
      }

    // where boxes are shortest, so that they stay compact; of equal axes the
    // first
    std::vector<unsigned int> axes;
    for (unsigned int d = 0; d < dim; ++d)
      axes.push_back(d);
    std::stable_sort(axes.begin(), axes.end(), [&](const auto a, const auto b) {
      return edges[a] < (1.0 - 1e-6) * edges[b];
    });
    const std::size_t n_before = pairs.size();
    for (const unsigned int axis : axes)
      {
        add_pairs_along(axis, cell, points, candidates, pairs);
        if (pairs.size() > n_before)
          return;
      }
  }



  template <int dim>
  void
  Merging<dim>::add_pairs_along(const unsigned int         axis,
                                const Cell                &cell,
                                const MaterialPoints<dim> &points,
                                std::vector<Candidate>    &candidates,
                                std::vector<Pair>         &pairs) const
  {
    // by places, not by numbers: alike on every number of ranks
    std::sort(candidates.begin(),
              candidates.end(),
              [axis](const Candidate &a, const Candidate &b) {
                return a.X[axis] < b.X[axis];
              });
    for (auto a = candidates.begin(); a != candidates.end(); ++a)
      {
        if (a->is_taken)
          continue;
        auto   best     = candidates.end();
        double distance = 0.0;
        for (auto b = a + 1; b != candidates.end(); ++b)
          {
            const auto along = b->X - a->X;
            // along another axis it is another pair
            if (b->is_taken ||
                std::abs(along[axis]) <
                  0.5 * (a->half_lengths[axis] + b->half_lengths[axis]))
              continue;
            if ((best == candidates.end() || along.norm() < distance) &&
                is_pair(*a, *b, cell, points))
              {
                best     = b;
                distance = along.norm();
              }
          }
        if (best == candidates.end())
          continue;
        a->is_taken = best->is_taken = true;
        pairs.push_back({a->particle, best->particle});
      }
  }



  template <int dim>
  bool
  Merging<dim>::is_pair(const Candidate           &a,
                        const Candidate           &b,
                        const Cell                &cell,
                        const MaterialPoints<dim> &points) const
  {
    const double *row_a = a.particle->get_properties().data();
    const double *row_b = b.particle->get_properties().data();
    const double  V_a   = row_a[points.place.volume];
    const double  V_b   = row_b[points.place.volume];
    // the stretch of the frame changes no ratio
    const auto box = joint_box<dim>({a.X, a.half_lengths},
                                    {b.X, b.half_lengths},
                                    V_a / (V_a + V_b));
    if (!box)
      return false;

    // the share of the cell of a first box, and some rounding and stretch;
    // clearly less than what is halved
    const double largest_share =
      std::min(1.1 / std::pow(parameters->per_axis, dim), 0.5);
    constexpr double largest_edge = 0.8; // of the smallest cell it touches
    double           share        = 1.0;
    for (unsigned int d = 0; d < dim; ++d)
      share *= 2.0 * box->half_lengths[d] / cell->extent_in_direction(d);
    if (share > largest_share)
      return false;
    touched.clear();
    if (!lattice->find(box->centre - box->half_lengths,
                       box->centre + box->half_lengths,
                       touched))
      return false;
    for (const unsigned int leaf : touched)
      for (unsigned int d = 0; d < dim; ++d)
        if (2.0 * box->half_lengths[d] >
            largest_edge * lattice->leaves()[leaf].size[d])
          return false;
    return points.are_near(row_a, row_b, parameters->merge_tolerance);
  }



  template class Merging<2>;
  template class Merging<3>;
} // namespace Riedel::Points
