// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/equilibrium/balance.h>
#include <riedel/points/point_sums.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

#include <cmath>
#include <limits>

namespace Riedel::Equilibrium
{
  namespace
  {
    /// Surfaces of all ranks: their plain numbers are added up.
    template <int dim>
    std::vector<typename Loads<dim>::Surface>
    sum_over_ranks(const std::vector<typename Loads<dim>::Surface> &surfaces,
                   const MPI_Comm communicator)
    {
      std::vector<double> numbers;
      for (const auto &surface : surfaces)
        {
          for (const auto *vector : {&surface.force,
                                     &surface.normal_area,
                                     &surface.initial_normal_area})
            numbers.insert(numbers.end(),
                           vector->begin_raw(),
                           vector->end_raw());
          for (unsigned int k = 0; k < surface.moment.dimension; ++k)
            numbers.push_back(surface.moment[k]);
        }
      std::vector<double> sums(numbers.size());
      dealii::Utilities::MPI::sum(numbers, communicator, sums);

      auto result = surfaces;
      auto number = sums.begin();
      for (auto &surface : result)
        {
          for (auto *vector : {&surface.force,
                               &surface.normal_area,
                               &surface.initial_normal_area})
            for (unsigned int d = 0; d < dim; ++d)
              (*vector)[d] = *number++;
          for (unsigned int k = 0; k < surface.moment.dimension; ++k)
            surface.moment[k] = *number++;
        }
      return result;
    }
  } // namespace



  template <int dim>
  Balance<dim>::Balance(
    const BoundaryConditionParameters<dim> &boundary_parameters,
    const PlatesParameters<dim>            &plate_parameters,
    const LoadingParameters<dim>           &loading,
    const SolverParameters                 &solver_parameters,
    const Grid::Body<dim>                  &body,
    const Grid::Space<dim>                 &space,
    Points::MaterialPoints<dim>            &points,
    const Points::Supports<dim>            &supports,
    Timer                                  &timer,
    const double                            load)
    : boundary_parameters(&boundary_parameters)
    , loading(&loading)
    , parameters(&solver_parameters)
    , body(&body)
    , space(&space)
    , points(&points)
    , supports(&supports)
    , timer(&timer)
    , conditions(boundary_parameters, body, space)
    , loads(boundary_parameters, loading, body, space, !points.are_moving())
    , virtual_stress(boundary_parameters)
    , plates(plate_parameters, space, points)
    , assembly(points, supports, virtual_stress)
    , length(0.0)
    , load(load)
  {
    for (const auto &material : points.materials().materials)
      length = std::max(length, material.law->length());
    if (length == 0.0)
      length = 1.0; // no rotations, or a law without bending stiffness
    if (points.are_moving())
      stabilisation = std::make_unique<SurfaceStabilisation<dim>>(
        space, points.moving_parameters().surface_stabilisation, length);

    external        = space.owned_vector();
    reaction        = space.owned_vector();
    squared_lengths = space.owned_vector();
    is_rotation.assign(space.owned().n_elements(), false);
    for (unsigned int i = 0; i < is_rotation.size(); ++i)
      {
        const unsigned int local =
          space.local(space.owned().nth_index_in_set(i));
        is_rotation[i]             = space.components()[local] >= dim;
        squared_lengths.begin()[i] = is_rotation[i] ? length * length : 1.0;
      }
    if (loading.opening.controls && !points.are_moving())
      opening = std::make_unique<Opening<dim>>(loading.opening, space);
    supports_changed();
    accepted_plates = plates.reports();
  }



  template <int dim>
  bool
  Balance<dim>::supports_changed()
  {
    const std::vector<bool> fixed_before = conditions.is_fixed();
    has_matrix                           = false;
    assembly.resize();
    conditions.set_unseen(supports->unseen_dofs);
    if (stabilisation)
      stabilisation->rebuild(*points, *supports);
    plates.rebuild(load);
    if (loading->opening.controls && points->are_moving())
      opening = std::make_unique<Opening<dim>>(loading->opening,
                                               *space,
                                               *points,
                                               *supports);
    is_prescribed.assign(space->owned().n_elements(), false);
    for (unsigned int i = 0; i < conditions.is_fixed().size(); ++i)
      {
        const auto dof = space->relevant().nth_index_in_set(i);
        // points see the masters of hanging nodes only, whose rows are empty
        const bool is_fixed = conditions.is_fixed()[i] ||
                              space->hanging_nodes().is_constrained(dof);
        if (is_fixed && space->owned().is_element(dof))
          is_prescribed[space->owned_place(i)] = true;
      }
    return dealii::Utilities::MPI::sum(fixed_before == conditions.is_fixed() ?
                                         0 :
                                         1,
                                       space->communicator()) > 0;
  }



  template <int dim>
  void
  Balance<dim>::make_matrix()
  {
    // Collected on this side and not by Epetra, which takes longer: moving
    // points have a new pattern in every step. Dofs of prescribed values keep
    // their diagonal entry.
    dealii::DynamicSparsityPattern pattern(space->dof_handler().n_dofs(),
                                           space->dof_handler().n_dofs(),
                                           space->relevant());
    const auto                     couple =
      [&](const std::vector<dealii::types::global_dof_index> &dofs) {
        conditions.homogeneous().add_entries_local_to_global(dofs,
                                                             pattern,
                                                             false);
      };
    std::vector<dealii::types::global_dof_index> dofs;
    for (const auto &patch : supports->patches)
      {
        dofs.assign(supports->global_dofs.begin() + patch.first_dof,
                    supports->global_dofs.begin() + patch.first_dof +
                      patch.n_dofs);
        couple(dofs);
      }
    if (stabilisation)
      for (const auto &coupled : stabilisation->couplings())
        couple(coupled);
    for (const auto &coupled : plates.couplings())
      couple(coupled);
    // Fixed dofs that no point sees have no other entry, nor have hanging ones
    // of points that move.
    for (const auto dof : space->owned())
      if (conditions.homogeneous().is_constrained(dof))
        pattern.add(dof, dof);
    dealii::SparsityTools::distribute_sparsity_pattern(pattern,
                                                       space->owned(),
                                                       space->communicator(),
                                                       space->relevant());
    earlier_linear_counts = linear_counts();
    solver.reset();
    matrix.reinit(space->owned(),
                  space->owned(),
                  pattern,
                  space->communicator());
    make_solver();
    has_matrix = true;
  }



  template <int dim>
  void
  Balance<dim>::begin_step(const std::vector<double> &u,
                           const double               from,
                           const double               to,
                           const double               release)
  {
    start = u;
    assembly.begin_step(loading->strain_33_at(to) -
                        loading->strain_33_at(from));
    held.clear();
    step_from       = from;
    opening_of_step = 0.0;
    if (points->are_moving() && release < 1.0)
      {
        set_load(from);
        const LinearAlgebra::Vector zero      = space->owned_vector();
        LinearAlgebra::Vector       imbalance = space->owned_vector();
        residual(zero, imbalance);
        imbalance *= 1.0 - release;
        held = imbalance;
      }

    set_load(to);
  }



  template <int dim>
  void
  Balance<dim>::set_load(const double s)
  {
    load = s;
    plates.move(step_from, s);
    body_forces.assign(start.size(), 0.0);
    loads.add_body_forces(*supports, *points, load, body_forces);
    if (points->are_moving())
      find_extent();
    prescribed.assign(start.size(), 0.0);
    for (const auto &dof : conditions.prescribed())
      prescribed[dof.dof] =
        conditions.value(dof, s) - (points->are_moving() ?
                                      conditions.value(dof, step_from) :
                                      start[dof.dof]);
  }



  template <int dim>
  void
  Balance<dim>::find_extent()
  {
    const auto present = Points::extent(*points, space->communicator());
    const auto [a, b]  = present.get_boundary_points();
    // between walls the body is where they will be at the end of the step
    const auto frame = conditions.walls(load);
    loads.set_extent(body->extent(),
                     dealii::BoundingBox<dim>(std::make_pair(
                       frame.to_space(space->frame().to_grid(a)),
                       frame.to_space(space->frame().to_grid(b)))));
  }



  template <int dim>
  void
  Balance<dim>::impose(LinearAlgebra::Vector &du) const
  {
    double *values = du.begin();
    for (const auto &dof : conditions.prescribed())
      if (dof.owned)
        values[space->owned_place(dof.dof)] = prescribed[dof.dof];
    space->set_hanging(du);
  }



  template <int dim>
  double
  Balance<dim>::mismatch(const LinearAlgebra::Vector &du) const
  {
    double        difference = 0.0, largest = 0.0;
    const double *values = du.begin();
    for (const auto &dof : conditions.prescribed())
      if (dof.owned)
        {
          const double scale = dof.component < dim ? 1.0 : length;
          const double here  = prescribed[dof.dof];
          difference =
            std::max(difference,
                     scale *
                       std::abs(here - values[space->owned_place(dof.dof)]));
          largest = std::max(largest, scale * std::abs(here));
        }
    difference = dealii::Utilities::MPI::max(difference, space->communicator());
    largest    = dealii::Utilities::MPI::max(largest, space->communicator());
    const double walls =
      largest > 0.0 ? difference / largest : (difference > 0.0 ? 1.0 : 0.0);
    return std::max(walls, plates.kink());
  }



  template <int dim>
  Residual
  Balance<dim>::residual(const LinearAlgebra::Vector &du,
                         LinearAlgebra::Vector       &r)
  {
    const Timer::Scope scope(*timer, "residual sweeps");
    ++n_sweeps;
    return evaluate(du, r, nullptr, nullptr);
  }



  template <int dim>
  Residual
  Balance<dim>::linearise(const LinearAlgebra::Vector &du,
                          LinearAlgebra::Vector       &r)
  {
    if (!opening)
      {
        LinearAlgebra::Vector unused = space->owned_vector();
        return factorise_at(du, conditions.homogeneous(), r, unused);
      }
    load_derivative   = space->owned_vector();
    const auto result = factorise_at(
      du, conditions.with_increments(prescribed_rates()), r, load_derivative);
    if (!result.refused)
      add_load_derivative(du);
    return result;
  }



  template <int dim>
  Residual
  Balance<dim>::factorise_at(
    const LinearAlgebra::Vector             &du,
    const dealii::AffineConstraints<double> &constraints,
    LinearAlgebra::Vector                   &r,
    LinearAlgebra::Vector                   &right_hand_side)
  {
    Residual result;
    {
      const Timer::Scope scope(*timer, "assembly of the stiffness");
      if (!has_matrix)
        make_matrix();
      matrix          = 0.0;
      right_hand_side = 0.0;
      result          = evaluate(du, r, &constraints, &right_hand_side);
      matrix.compress(dealii::VectorOperation::add);
      set_missing_diagonal();
      right_hand_side.compress(dealii::VectorOperation::add);
    }
    if (!result.refused)
      {
        double sum = 0.0;
        for (unsigned int i = 0; i < is_rotation.size(); ++i)
          if (!is_rotation[i] && !is_prescribed[i])
            sum +=
              std::pow(matrix.diag_element(space->owned().nth_index_in_set(i)),
                       2);
        stiffness_norm =
          std::sqrt(dealii::Utilities::MPI::sum(sum, space->communicator()));

        const Timer::Scope scope(*timer, "factorisation");
        solver->factorise();
        ++n_factorisations;
        factorised = true;
      }
    return result;
  }



  template <int dim>
  void
  Balance<dim>::set_missing_diagonal()
  {
    // As stiff as the stiffest dof: if points see the node while this factor is
    // in use, it must not give it large corrections.
    std::vector<double> largest(2, 0.0), all(2);
    for (unsigned int i = 0; i < is_rotation.size(); ++i)
      largest[is_rotation[i]] =
        std::max(largest[is_rotation[i]],
                 matrix.diag_element(space->owned().nth_index_in_set(i)));
    dealii::Utilities::MPI::max(largest, space->communicator(), all);
    for (unsigned int i = 0; i < is_prescribed.size(); ++i)
      {
        const auto dof = space->owned().nth_index_in_set(i);
        if (conditions.homogeneous().is_constrained(dof) &&
            matrix.diag_element(dof) == 0.0)
          matrix.set(dof, dof, all[is_rotation[i]]);
      }
    matrix.compress(dealii::VectorOperation::insert);
  }



  template <int dim>
  void
  Balance<dim>::correction(const LinearAlgebra::Vector &r,
                           LinearAlgebra::Vector       &delta)
  {
    const Timer::Scope scope(*timer, "solution with factors");
    solver->solve(r, delta);
    delta *= -1.0;
    space->set_hanging(delta);
    if (opening)
      close_opening(delta);
  }



  template <int dim>
  Residual
  Balance<dim>::predict_with_tangent(LinearAlgebra::Vector &du)
  {
    LinearAlgebra::Vector r          = space->owned_vector();
    LinearAlgebra::Vector right_side = space->owned_vector();
    du                               = 0.0;
    plates.set_sticking(true);
    const Residual result =
      factorise_at(du, conditions.with_increments(prescribed), r, right_side);
    plates.set_sticking(false);
    if (result.refused)
      return result;
    // r is zero at prescribed dofs, where the right side has their value
    right_side -= r;
    const Timer::Scope scope(*timer, "solution with factors");
    solver->solve(right_side, du);
    impose(du);
    return result;
  }



  template <int dim>
  Residual
  Balance<dim>::evaluate(const LinearAlgebra::Vector             &du,
                         LinearAlgebra::Vector                   &r,
                         const dealii::AffineConstraints<double> *constraints,
                         LinearAlgebra::Vector *right_hand_side)
  {
    const MPI_Comm communicator = space->communicator();
    const bool     with_matrix  = (constraints != nullptr);

    space->gather(du, increment);
    applied = body_forces;

    typename Loads<dim>::AddMatrix add_matrix;
    dealii::FullMatrix<double>     local_matrix;
    dealii::Vector<double>         zero;
    if (with_matrix)
      add_matrix = [&](const std::vector<dealii::types::global_dof_index> &dofs,
                       const std::vector<double> &values) {
        local_matrix.reinit(dofs.size(), dofs.size());
        std::copy(values.begin(), values.end(), &local_matrix(0, 0));
        zero.reinit(dofs.size());
        constraints->distribute_local_to_global(
          local_matrix, zero, dofs, matrix, *right_hand_side, true);
      };
    present = start;
    for (unsigned int i = 0; i < present.size(); ++i)
      present[i] += increment[i];
    loads.add_surface_loads(present, load, applied, add_matrix);
    plate_forces.assign(increment.size(), 0.0);
    plates.add_forces(increment, plate_forces, add_matrix);
    surfaces = sum_over_ranks<dim>(loads.surfaces(), communicator);
    virtual_stress.set(surfaces, load);

    internal.assign(increment.size(), 0.0);
    virtual_forces.assign(increment.size(), 0.0);
    Residual result;
    result.sweep = with_matrix ?
                     assembly.forces_and_stiffness(increment,
                                                   *constraints,
                                                   internal,
                                                   virtual_forces,
                                                   matrix,
                                                   *right_hand_side) :
                     assembly.forces(increment, internal, virtual_forces);

    if (opening_of_step != 0.0)
      {
        opening_gap    = opening_of_step - (*opening)(du);
        result.opening = std::abs(opening_gap / opening_of_step);
      }

    if (stabilisation)
      {
        stabilisation->add_forces(increment, internal);
        if (with_matrix)
          stabilisation->add_stiffness(add_matrix);
      }

    // Forces at hanging nodes go to their masters.
    for (const auto &line : space->hanging_nodes().get_lines())
      for (auto *forces : {&internal, &applied, &plate_forces, &virtual_forces})
        {
          double &force = (*forces)[space->local(line.index)];
          for (const auto &[master, weight] : line.entries)
            (*forces)[space->local(master)] += weight * force;
          force = 0.0;
        }

    // reaction = internal - applied: what a virtual stress does to walls is
    // not a force there
    r = 0.0;
    space->scatter_add(internal, r);
    external = 0.0;
    space->scatter_add(applied, external);
    LinearAlgebra::Vector plate_vector = space->owned_vector();
    space->scatter_add(plate_forces, plate_vector);
    external += plate_vector;
    reaction = r;
    reaction -= external;
    LinearAlgebra::Vector virtual_vector = space->owned_vector();
    if (!virtual_stress.is_empty())
      {
        space->scatter_add(virtual_forces, virtual_vector);
        external += virtual_vector;
      }

    double       *out            = external.begin();
    double       *r_out          = r.begin();
    double       *reaction_out   = reaction.begin();
    const double *held_imbalance = held.size() > 0 ? held.begin() : nullptr;
    // squares: free forces, free moments, reactions, loads; counts of points
    std::vector<double> sums(13, 0.0);
    for (unsigned int i = 0; i < is_prescribed.size(); ++i)
      {
        const double scale = is_rotation[i] ? 1.0 / (length * length) : 1.0;
        sums[3] += scale * out[i] * out[i];
        if (is_prescribed[i])
          {
            sums[2] += scale * reaction_out[i] * reaction_out[i];
            out[i]   = r_out[i];
            r_out[i] = 0.0;
          }
        else
          {
            r_out[i] -= out[i];
            if (held_imbalance != nullptr)
              r_out[i] -= held_imbalance[i];
            reaction_out[i] = 0.0;
            sums[is_rotation[i] ? 1 : 0] += scale * r_out[i] * r_out[i];
          }
      }
    external -= plate_vector; // their work is not done at the nodes
    const auto &report = result.sweep.total;
    sums[4]            = report.refused;
    sums[5]            = report.floored;
    sums[6]            = report.clamped;
    sums[7]            = report.null_deviator;
    sums[8]            = static_cast<double>(report.substeps);
    sums[9]            = report.yielding;
    sums[10]           = report.at_apex;
    sums[11]           = report.unregularised;
    sums[12]           = report.without_strength;
    std::vector<double> all(sums.size());
    dealii::Utilities::MPI::sum(sums, communicator, all);

    result.force                     = std::sqrt(all[0]);
    result.moment                    = std::sqrt(all[1]);
    result.reference                 = std::sqrt(std::max(all[2], all[3]));
    result.refused                   = all[4] > 0;
    result.sweep.total.refused       = static_cast<unsigned int>(all[4]);
    result.sweep.total.floored       = static_cast<unsigned int>(all[5]);
    result.sweep.total.clamped       = static_cast<unsigned int>(all[6]);
    result.sweep.total.null_deviator = static_cast<unsigned int>(all[7]);
    result.sweep.total.substeps      = static_cast<unsigned long long>(all[8]);
    result.sweep.total.yielding      = static_cast<unsigned int>(all[9]);
    result.sweep.total.at_apex       = static_cast<unsigned int>(all[10]);
    result.sweep.total.unregularised = static_cast<unsigned int>(all[11]);
    result.sweep.total.without_strength = static_cast<unsigned int>(all[12]);
    // A body without stress has no forces to compare with but rounding errors,
    // which grow with stiffness and displacement.
    double largest = std::numeric_limits<double>::min();
    for (const double value : present)
      largest = std::max(largest, std::abs(value));
    const double rounding = 1e-14 * stiffness_norm *
                            dealii::Utilities::MPI::max(largest, communicator);
    result.reference = std::max({result.reference,
                                 rounding / parameters->residual,
                                 std::numeric_limits<double>::min()});
    return result;
  }



  template class Balance<2>;
  template class Balance<3>;
} // namespace Riedel::Equilibrium
