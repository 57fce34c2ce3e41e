// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/continuum/generalised.h>
#include <riedel/equilibrium/assembly.h>
#include <riedel/points/strain_operator.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <chrono>

namespace Riedel::Equilibrium
{
  namespace
  {
    /// Points whose tangents are kept at a time: they should stay in the cache.
    constexpr unsigned int chunk_size = 512;



    double
    seconds_since(const std::chrono::steady_clock::time_point start)
    {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() -
                                           start)
        .count();
    }



    void
    add(SweepReport            &sum,
        const Material::Report &report,
        const unsigned int      first_point)
    {
      if (sum.total.refused == 0 && report.refused > 0)
        {
          sum.first_refused = first_point + report.first_refused;
          sum.total.reason  = report.reason;
        }
      Material::add_counts(sum.total, report);
    }



    /// Rows of matrices are padded to whole blocks of this many numbers, which
    /// the compiler turns into vector instructions.
    constexpr std::size_t block = 8;



    constexpr std::size_t
    padded(const std::size_t n)
    {
      return (n + block - 1) / block * block;
    }



    /// sum += factor * row, both of whole blocks; they must not overlap, or the
    /// compiler could not use vector instructions.
    inline void
    add_row(const std::size_t n_blocks,
            const double      factor,
            const double *__restrict row,
            double *__restrict sum)
    {
      for (std::size_t j = 0; j < n_blocks * block; ++j)
        sum[j] += factor * row[j];
    }



    /// The stiffness of a patch: K += volume B^T D B with all rows padded.
    class PatchStiffness
    {
    public:
      void
      reinit(const unsigned int n_generalised, const unsigned int n_dofs)
      {
        n        = n_generalised;
        size     = n_dofs;
        n_blocks = padded(n_dofs) / block;
        B.assign(n * n_blocks * block, 0.0);
        K.assign(n_dofs * n_blocks * block, 0.0);
      }

      template <int dim>
      void
      add(const Points::StrainOperator<dim> &rows,
          const double                       volume,
          const double                      *D)
      {
        const std::size_t stride = n_blocks * block;
        rows.fill(B.data(), stride);
        for (unsigned int a = 0; a < n; ++a)
          {
            row_of_DB.assign(stride, 0.0);
            for (unsigned int b = 0; b < n; ++b)
              add_row(n_blocks,
                      volume * D[a * n + b],
                      &B[b * stride],
                      row_of_DB.data());
            const auto [first, last] = rows.nonzero_range(a);
            for (unsigned int i = first; i < last; ++i)
              add_row(n_blocks,
                      B[a * stride + i],
                      row_of_DB.data(),
                      &K[i * stride]);
          }
      }

      void
      copy_to(dealii::FullMatrix<double> &matrix) const
      {
        matrix.reinit(size, size);
        for (unsigned int i = 0; i < size; ++i)
          std::copy_n(&K[i * n_blocks * block], size, &matrix(i, 0));
      }

    private:
      unsigned int        n = 0, size = 0;
      std::size_t         n_blocks = 0;
      std::vector<double> B, K, row_of_DB;
    };
  } // namespace



  template <int dim>
  Assembly<dim>::Assembly(Points::MaterialPoints<dim> &points,
                          const Points::Supports<dim> &supports,
                          const VirtualStress<dim>    &virtual_stress)
    : points(&points)
    , supports(&supports)
    , virtual_stress(&virtual_stress)
    , n_generalised(points.materials().materials.front().law->n_generalised())
  {
    resize();
  }



  template <int dim>
  void
  Assembly<dim>::resize()
  {
    increments.assign(points->n_points() * n_generalised, 0.0);
    stresses_before.assign(increments.size(), 0.0);
    stresses.assign(increments.size(), 0.0);
  }



  template <int dim>
  void
  Assembly<dim>::begin_step(const double strain_33)
  {
    if (strain_33 == 0.0)
      axis_3_strains.clear();
    else
      axis_3_strains.assign(points->n_points(), strain_33);
    for (const auto &range : points->ranges())
      {
        const auto &law = *points->materials().materials[range.material].law;
        for (unsigned int p = range.first; p < range.last; ++p)
          law.stresses_at_rest(points->committed(p),
                               &stresses_before[p * n_generalised]);
      }
  }



  template <int dim>
  SweepReport
  Assembly<dim>::forces(const std::vector<double> &du,
                        std::vector<double>       &forces,
                        std::vector<double>       &virtual_forces)
  {
    return sweep(du, forces, virtual_forces, nullptr, nullptr, nullptr);
  }



  template <int dim>
  SweepReport
  Assembly<dim>::forces_and_stiffness(
    const std::vector<double>               &du,
    const dealii::AffineConstraints<double> &constraints,
    std::vector<double>                     &forces,
    std::vector<double>                     &virtual_forces,
    LinearAlgebra::SparseMatrix             &matrix,
    LinearAlgebra::Vector                   &right_hand_side)
  {
    return sweep(
      du, forces, virtual_forces, &constraints, &matrix, &right_hand_side);
  }



  template <int dim>
  SweepReport
  Assembly<dim>::sweep(const std::vector<double>               &du,
                       std::vector<double>                     &forces,
                       std::vector<double>                     &virtual_forces,
                       const dealii::AffineConstraints<double> *constraints,
                       LinearAlgebra::SparseMatrix             *matrix,
                       LinearAlgebra::Vector                   *right_hand_side)
  {
    using Patch                       = typename Points::Supports<dim>::Patch;
    const unsigned int n              = n_generalised;
    const bool         with_stiffness = (matrix != nullptr);
    const auto        &patches        = supports->patches;

    SweepReport                          report;
    std::vector<double>                  values, local_forces, local_virtual;
    PatchStiffness                       stiffness;
    typename VirtualStress<dim>::AtPoint field;
    dealii::FullMatrix<double>           K;
    dealii::Vector<double>               zero;
    std::vector<dealii::types::global_dof_index> global;

    for (std::size_t first = 0; first < patches.size();)
      {
        // A chunk: neighbouring patches of one material.
        std::size_t  last     = first;
        unsigned int n_points = 0;
        while (
          last < patches.size() &&
          patches[last].material == patches[first].material &&
          (last == first || n_points + patches[last].n_points <= chunk_size))
          n_points += patches[last++].n_points;
        const unsigned int first_point = patches[first].first_point;
        const auto        &law =
          *points->materials().materials[patches[first].material].law;

        for (std::size_t k = first; k < last; ++k)
          {
            const Patch &patch = patches[k];
            values.resize(patch.n_dofs);
            for (unsigned int i = 0; i < patch.n_dofs; ++i)
              values[i] = du[supports->dofs[patch.first_dof + i]];
            for (unsigned int q = 0; q < patch.n_points; ++q)
              Points::StrainOperator<dim>(*supports, patch, q)
                .increments(values.data(),
                            &increments[(patch.first_point + q) * n]);
          }

        if (with_stiffness)
          tangents.resize(n_points * n * n);
        Material::Batch batch;
        batch.n_points   = n_points;
        batch.increments = &increments[first_point * n];
        batch.committed  = points->committed(first_point);
        batch.trial      = points->trial(first_point);
        batch.stresses   = &stresses[first_point * n];
        batch.tangents   = with_stiffness ? tangents.data() : nullptr;
        if (!axis_3_strains.empty())
          batch.axis_3_strains = &axis_3_strains[first_point];
        const auto start = std::chrono::steady_clock::now();
        add(report, law.respond(batch), first_point);
        const double seconds = seconds_since(start);
        (with_stiffness ? law_cost.tangent_seconds : law_cost.value_seconds) +=
          seconds;
        (with_stiffness ? law_cost.tangent_points : law_cost.value_points) +=
          n_points;
        if (report.total.refused > 0)
          {
            first = last;
            continue;
          }

        for (std::size_t k = first; k < last; ++k)
          {
            const Patch        &patch = patches[k];
            const unsigned int *dofs  = &supports->dofs[patch.first_dof];
            local_forces.assign(patch.n_dofs, 0.0);
            local_virtual.assign(patch.n_dofs, 0.0);
            if (with_stiffness)
              stiffness.reinit(n, patch.n_dofs);

            for (unsigned int q = 0; q < patch.n_points; ++q)
              {
                const unsigned int                p = patch.first_point + q;
                const double                      V = supports->volume[p];
                const Points::StrainOperator<dim> rows(*supports, patch, q);
                const double                     *stress = &stresses[p * n];
                double                           *D      = with_stiffness ?
                                                             &tangents[(p - first_point) * n * n] :
                                                             nullptr;

                if (!virtual_stress->is_empty())
                  {
                    const double *weight =
                      &supports->weight[patch.first_weight + q * patch.n_nodes];
                    dealii::Point<dim> x = points->position(p);
                    for (unsigned int d = 0; d < dim; ++d)
                      for (unsigned int a = 0; a < patch.n_nodes; ++a)
                        {
                          const unsigned int dof = dofs[d * patch.n_nodes + a];
                          x[d] += weight[a] * du[dof];
                        }
                    virtual_stress->evaluate(
                      x, &increments[p * n], n, field, D);
                    rows.add_forces(field.stresses, V, local_virtual.data());
                    for (unsigned int d = 0; d < dim; ++d)
                      for (unsigned int a = 0; a < patch.n_nodes; ++a)
                        local_virtual[d * patch.n_nodes + a] +=
                          V * field.body_force[d] * weight[a];
                  }

                rows.add_forces(stress, V, local_forces.data());
                if (with_stiffness)
                  stiffness.add(rows, V, D);
              }

            for (unsigned int i = 0; i < patch.n_dofs; ++i)
              {
                forces[dofs[i]] += local_forces[i];
                virtual_forces[dofs[i]] += local_virtual[i];
              }
            if (with_stiffness)
              {
                stiffness.copy_to(K);
                zero.reinit(patch.n_dofs);
                global.assign(&supports->global_dofs[patch.first_dof],
                              &supports->global_dofs[patch.first_dof] +
                                patch.n_dofs);
                constraints->distribute_local_to_global(
                  K, zero, global, *matrix, *right_hand_side, true);
              }
          }
        first = last;
      }
    return report;
  }



  template <int dim>
  double
  Assembly<dim>::stress_work() const
  {
    double work = 0.0;
    for (unsigned int p = 0; p < points->n_points(); ++p)
      for (unsigned int a = 0; a < n_generalised; ++a)
        {
          const unsigned int i = p * n_generalised + a;
          work += 0.5 * supports->volume[p] *
                  (stresses_before[i] + stresses[i]) * increments[i];
        }
    return work;
  }



  template class Assembly<2>;
  template class Assembly<3>;
} // namespace Riedel::Equilibrium
