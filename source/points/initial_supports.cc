// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/points/initial_supports.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>

#include <algorithm>
#include <map>

namespace Riedel::Points
{
  namespace
  {
    /// result += factor * vector. The arrays do not overlap: the compiler may
    /// compute several entries at once.
    inline void
    add(const std::size_t n,
        const double      factor,
        const double *__restrict vector,
        double *__restrict result)
    {
      for (std::size_t i = 0; i < n; ++i)
        result[i] += factor * vector[i];
    }



    /// F = I + sum_a U_a x grad N_a from a patch's displacements.
    template <int dim>
    dealii::Tensor<2, dim>
    deformation_gradient(const unsigned int n_nodes,
                         const double      *displacement,
                         const double      *gradient)
    {
      dealii::Tensor<2, dim> F;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          {
            F[i][j] = (i == j ? 1.0 : 0.0);
            for (unsigned int a = 0; a < n_nodes; ++a)
              F[i][j] +=
                displacement[i * n_nodes + a] * gradient[j * n_nodes + a];
          }
      return F;
    }



    /// grad_n N = F^-T grad_X N for all nodes.
    template <int dim>
    void
    push_forward(const dealii::Tensor<2, dim> &F,
                 const unsigned int            n_nodes,
                 const double *__restrict undeformed,
                 double *__restrict gradient)
    {
      const dealii::Tensor<2, dim> inverse = invert(F);
      std::fill_n(gradient, dim * n_nodes, 0.0);
      for (unsigned int j = 0; j < dim; ++j)
        for (unsigned int k = 0; k < dim; ++k)
          add(n_nodes,
              inverse[k][j],
              undeformed + k * n_nodes,
              gradient + j * n_nodes);
    }



    /// result = (1 - share) * other + share * result
    void
    blend(const std::size_t n,
          const double      share,
          const double *__restrict other,
          double *__restrict result)
    {
      for (std::size_t i = 0; i < n; ++i)
        result[i] = (1.0 - share) * other[i] + share * result[i];
    }
  } // namespace



  template <int dim>
  InitialSupports<dim>::InitialSupports(const Grid::Space<dim> &space,
                                        const Grid::Parameters &parameters,
                                        const bool follow_deformation)
    : space(&space)
    , parameters(parameters)
    , follow_deformation(follow_deformation)
    , sampling(dealii::QGauss<dim>(2))
  {}



  template <int dim>
  dealii::Quadrature<dim>
  InitialSupports<dim>::quadrature() const
  {
    const unsigned int degree =
      space->is_micropolar() ?
        std::min(parameters.displacement_degree, parameters.rotation_degree) :
        parameters.displacement_degree;
    // Q2/Q1 converges with 2x2 points; a biquadratic rotation needs 3x3, or it
    // has an hourglass mode (doc/theory/elements.md).
    return dealii::QGauss<dim>(degree + 1);
  }



  template <int dim>
  void
  InitialSupports<dim>::evaluate_shapes(
    const typename dealii::DoFHandler<dim>::active_cell_iterator &cell,
    const std::vector<dealii::Point<dim>>                        &places,
    Shapes                                                       &shapes) const
  {
    static const dealii::FE_Q<dim> geometry(1);
    for (const auto &place : places)
      {
        dealii::Tensor<2, dim> jacobian;
        for (const unsigned int v : cell->vertex_indices())
          jacobian +=
            outer_product(cell->vertex(v), geometry.shape_grad(v, place));
        const dealii::Tensor<2, dim> to_cell = transpose(invert(jacobian));

        for (unsigned int base = 0; base < space->element().n_base_elements();
             ++base)
          {
            const auto        &element = space->element().base_element(base);
            const unsigned int n       = element.n_dofs_per_cell();
            auto &weight = (base == 0 ? shapes.weight : shapes.rotation_weight);
            auto &gradient =
              (base == 0 ? shapes.gradient : shapes.rotation_gradient);

            const std::size_t first = gradient.size();
            gradient.resize(first + dim * n);
            for (unsigned int a = 0; a < n; ++a)
              {
                weight.push_back(element.shape_value(a, place));
                const dealii::Tensor<1, dim> grad =
                  to_cell * element.shape_grad(a, place);
                for (unsigned int j = 0; j < dim; ++j)
                  gradient[first + j * n + a] = grad[j];
              }
          }
      }
  }



  template <int dim>
  void
  InitialSupports<dim>::rebuild(const std::vector<double> &solution,
                                MaterialPoints<dim>       &points)
  {
    using ParticleIterator =
      typename dealii::Particles::ParticleHandler<dim>::particle_iterator;
    using CellIterator = typename dealii::DoFHandler<dim>::active_cell_iterator;

    struct Group
    {
      CellIterator                  cell;
      unsigned int                  cell_number;
      std::vector<ParticleIterator> points;
    };
    std::map<unsigned int, std::vector<Group>> groups_of_material;

    cells.clear();
    sampled               = Shapes();
    std::size_t n_sampled = 0;
    for (const auto &cell : space->dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          std::map<unsigned int, std::vector<ParticleIterator>> by_material;
          const auto here = points.particles().particles_in_cell(cell);
          for (auto particle = here.begin(); particle != here.end(); ++particle)
            by_material[points.material(particle)].push_back(particle);
          for (auto &[material, list] : by_material)
            groups_of_material[material].push_back(
              {cell, static_cast<unsigned int>(cells.size()), list});

          cells.push_back({{}, n_sampled});
          if (parameters.sampling == Grid::StrainSampling::assumed)
            {
              evaluate_shapes(cell, sampling.get_points(), sampled);
              n_sampled += sampling.size();
            }
        }

    result = Supports<dim>();
    own    = Shapes();
    interpolation.clear();
    std::vector<ParticleIterator>                order;
    std::vector<dealii::types::global_dof_index> cell_dofs(
      space->element().n_dofs_per_cell());
    const dealii::QGauss<1> line(2);

    for (const auto &[material, groups] : groups_of_material)
      for (const Group &group : groups)
        {
          typename Supports<dim>::Patch patch;
          patch.material    = material;
          patch.first_point = order.size();
          patch.n_points    = group.points.size();
          patch.n_nodes = space->element().base_element(0).n_dofs_per_cell();
          patch.n_rotation_nodes =
            space->is_micropolar() ?
              space->element().base_element(1).n_dofs_per_cell() :
              0;
          patch.n_dofs                = space->order_by_component().size();
          patch.first_dof             = result.dofs.size();
          patch.first_weight          = own.weight.size();
          patch.first_rotation_weight = own.rotation_weight.size();

          group.cell->get_dof_indices(cell_dofs);
          for (const unsigned int i : space->order_by_component())
            {
              result.global_dofs.push_back(cell_dofs[i]);
              result.dofs.push_back(space->local(cell_dofs[i]));
            }

          std::vector<dealii::Point<dim>> places;
          for (const auto &particle : group.points)
            {
              order.push_back(particle);
              places.push_back(particle->get_reference_location());
              for (unsigned int s = 0; s < sampling.size(); ++s)
                {
                  double weight = 1.0;
                  for (unsigned int d = 0; d < dim; ++d)
                    {
                      const double here = places.back()[d];
                      const double a    = line.point(0)[0];
                      const double b    = line.point(1)[0];
                      const bool   left = std::abs(sampling.point(s)[d] - a) <
                                        std::abs(sampling.point(s)[d] - b);
                      weight *= (left ? (b - here) : (here - a)) / (b - a);
                    }
                  interpolation.push_back(weight);
                }
            }
          evaluate_shapes(group.cell, places, own);

          cells[group.cell_number].patches.push_back(result.patches.size());
          result.patches.push_back(patch);
        }
    points.set_order(order);

    result.weight             = own.weight;
    result.spin_weight        = own.rotation_weight;
    result.gradient           = own.gradient;
    result.curvature_gradient = own.rotation_gradient;
    result.volume.resize(order.size());
    if (parameters.sampling == Grid::StrainSampling::mean_dilatation)
      result.dilatation.resize(own.gradient.size());
    update(solution, points);
  }



  template <int dim>
  void
  InitialSupports<dim>::accept(const std::vector<double> &solution,
                               const std::vector<double> &du,
                               const std::vector<double> & /*increments*/,
                               MaterialPoints<dim> &points)
  {
    points.accept();
    if constexpr (dim == 3)
      turn(du, points);
    update(solution, points);
  }



  template <int dim>
  void
  InitialSupports<dim>::update(const std::vector<double> &solution,
                               MaterialPoints<dim>       &points)
  {
    for (const CellData &cell : cells)
      update_cell(cell, solution, points);
    interpolate(solution, points);
  }



  namespace
  {
    /// sum_a weight_a values[dofs_a]
    double
    interpolated(const unsigned int         n,
                 const double              *weight,
                 const unsigned int        *dofs,
                 const std::vector<double> &values)
    {
      double sum = 0.0;
      for (unsigned int a = 0; a < n; ++a)
        sum += weight[a] * values[dofs[a]];
      return sum;
    }
  } // namespace



  template <int dim>
  void
  InitialSupports<dim>::interpolate(const std::vector<double> &solution,
                                    MaterialPoints<dim>       &points) const
  {
    for (const auto &patch : result.patches)
      for (unsigned int q = 0; q < patch.n_points; ++q)
        {
          double       *row = points.row(patch.first_point + q);
          const double *weight =
            own.weight.data() + patch.first_weight + q * patch.n_nodes;
          for (unsigned int d = 0; d < dim; ++d)
            row[points.place.displacement + d] =
              interpolated(patch.n_nodes,
                           weight,
                           &result.dofs[patch.first_dof + d * patch.n_nodes],
                           solution);
          // in the plane rotations add up
          if constexpr (dim == 2)
            if (patch.n_rotation_nodes > 0)
              row[points.place.micro_rotation] = interpolated(
                patch.n_rotation_nodes,
                own.rotation_weight.data() + patch.first_rotation_weight +
                  q * patch.n_rotation_nodes,
                &result.dofs[patch.first_dof + dim * patch.n_nodes],
                solution);
        }
  }



  template <int dim>
  void
  InitialSupports<dim>::turn(const std::vector<double> &du,
                             MaterialPoints<dim>       &points) const
  {
    for (const auto &patch : result.patches)
      for (unsigned int q = 0; q < patch.n_points; ++q)
        {
          const unsigned int n = patch.n_rotation_nodes;
          if (n == 0)
            continue;
          const double *weight =
            own.rotation_weight.data() + patch.first_rotation_weight + q * n;
          std::array<double, Supports<dim>::n_spin> theta;
          for (unsigned int k = 0; k < theta.size(); ++k)
            theta[k] = interpolated(
              n,
              weight,
              &result.dofs[patch.first_dof + dim * patch.n_nodes + k * n],
              du);
          points.turn(patch.first_point + q, theta);
        }
  }



  template <int dim>
  void
  InitialSupports<dim>::update_cell(const CellData            &cell,
                                    const std::vector<double> &solution,
                                    MaterialPoints<dim>       &points)
  {
    if (cell.patches.empty())
      return;
    const auto        &some = result.patches[cell.patches.front()];
    const unsigned int n    = some.n_nodes;
    const unsigned int nw   = some.n_rotation_nodes;

    std::vector<double> nodal(dim * n, 0.0);
    if (follow_deformation)
      for (unsigned int i = 0; i < dim * n; ++i)
        nodal[i] = solution[result.dofs[some.first_dof + i]];

    const bool at_samples =
      parameters.sampling == Grid::StrainSampling::assumed &&
      parameters.displacement_degree == 2;
    const bool means_needed =
      !at_samples && parameters.sampling != Grid::StrainSampling::full;

    // The points' own rows, their volumes, and the mean of the rows (later: the
    // sampled rows of a point).
    double              cell_volume = 0.0;
    std::vector<double> mean(dim * n, 0.0), mean_weight(nw, 0.0);
    for (const unsigned int k : cell.patches)
      {
        const auto &patch = result.patches[k];
        for (unsigned int q = 0; q < patch.n_points; ++q)
          {
            const std::size_t  u = dim * (patch.first_weight + q * n);
            const std::size_t  w = patch.first_rotation_weight + q * nw;
            const unsigned int p = patch.first_point + q;

            const dealii::Tensor<2, dim> F =
              deformation_gradient<dim>(n, nodal.data(), &own.gradient[u]);
            push_forward(F, n, &own.gradient[u], &result.gradient[u]);
            if (nw == n) // of equal degree: the same shape functions
              std::copy_n(&result.gradient[u],
                          dim * n,
                          &result.curvature_gradient[dim * w]);
            else if (nw > 0)
              push_forward(F,
                           nw,
                           &own.rotation_gradient[dim * w],
                           &result.curvature_gradient[dim * w]);

            double      *row = points.row(p);
            const double V = row[points.place.initial_volume] * determinant(F);
            result.volume[p]         = V;
            row[points.place.volume] = V;

            cell_volume += V;
            if (means_needed)
              {
                add(dim * n, V, &result.gradient[u], mean.data());
                add(nw, V, own.rotation_weight.data() + w, mean_weight.data());
              }
          }
      }
    if (parameters.sampling == Grid::StrainSampling::full)
      return;
    for (double &value : mean)
      value /= cell_volume;
    for (double &value : mean_weight)
      value /= cell_volume;

    // Rows at the sampling points of a biquadratic cell.
    std::vector<double> sample_gradient;
    if (at_samples)
      {
        sample_gradient.resize(sampling.size() * dim * n);
        for (unsigned int s = 0; s < sampling.size(); ++s)
          {
            const double *undeformed =
              &sampled.gradient[dim * n * (cell.first_sample + s)];
            push_forward(deformation_gradient<dim>(n, nodal.data(), undeformed),
                         n,
                         undeformed,
                         &sample_gradient[s * dim * n]);
          }
      }

    for (const unsigned int k : cell.patches)
      {
        const auto &patch = result.patches[k];
        for (unsigned int q = 0; q < patch.n_points; ++q)
          {
            const std::size_t u = dim * (patch.first_weight + q * n);
            const std::size_t w = patch.first_rotation_weight + q * nw;

            if (parameters.sampling == Grid::StrainSampling::mean_dilatation)
              {
                for (unsigned int i = 0; i < dim * n; ++i)
                  result.dilatation[u + i] = mean[i] - result.gradient[u + i];
                continue;
              }

            if (at_samples)
              {
                std::fill(mean.begin(), mean.end(), 0.0);
                std::fill(mean_weight.begin(), mean_weight.end(), 0.0);
                for (unsigned int s = 0; s < sampling.size(); ++s)
                  {
                    const double share =
                      interpolation[(patch.first_point + q) * sampling.size() +
                                    s];
                    add(dim * n,
                        share,
                        &sample_gradient[s * dim * n],
                        mean.data());
                    add(nw,
                        share,
                        sampled.rotation_weight.data() +
                          nw * (cell.first_sample + s),
                        mean_weight.data());
                  }
              }
            const double share = parameters.own_strain_fraction;
            blend(dim * n, share, mean.data(), &result.gradient[u]);
            std::copy_n(own.rotation_weight.data() + w,
                        nw,
                        result.spin_weight.data() + w);
            blend(nw, share, mean_weight.data(), result.spin_weight.data() + w);
          }
      }
  }



  template class InitialSupports<2>;
  template class InitialSupports<3>;
} // namespace Riedel::Points
