// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/equilibrium/balance.h>

#include <algorithm>
#include <cmath>

/*
 * The load factor as an unknown, found from a measured opening
 * (doc/theory/solution.md).
 */
namespace Riedel::Equilibrium
{
  namespace
  {
    /// Half the difference of the load factor in central differences: formulas
    /// in it are read to 16 digits, and most are linear.
    double
    difference(const double load)
    {
      return 1e-4 * std::max(1.0, std::abs(load));
    }
  } // namespace



  template <int dim>
  void
  Balance<dim>::aim_at(const double opening_at_end)
  {
    LinearAlgebra::Vector u = space->owned_vector();
    for (unsigned int i = 0; i < start.size(); ++i)
      if (space->owned().is_element(space->relevant().nth_index_in_set(i)))
        u.begin()[space->owned_place(i)] = start[i];
    opening_of_step = opening_at_end - opening->before() - (*opening)(u);
  }



  template <int dim>
  std::vector<double>
  Balance<dim>::prescribed_rates() const
  {
    const double        h = difference(load);
    std::vector<double> rates(start.size(), 0.0);
    for (const auto &dof : conditions.prescribed())
      rates[dof.dof] =
        (conditions.value(dof, load + h) - conditions.value(dof, load - h)) /
        (2.0 * h);
    return rates;
  }



  template <int dim>
  void
  Balance<dim>::add_load_derivative(const LinearAlgebra::Vector &du)
  {
    bool       has_loads = false;
    const auto look      = [&has_loads](const auto &formulas) {
      for (const auto &formula : formulas)
        has_loads = has_loads || formula.given();
    };
    look(loading->body_force);
    look(loading->body_couple);
    for (const auto &boundary : boundary_parameters->boundaries)
      {
        look(boundary.traction);
        look(boundary.couple_traction);
        has_loads = has_loads || boundary.pressure.given();
      }
    if (!has_loads)
      return;

    // du stays, with its prescribed increments: what changes is the loads
    const double          at = load, h = difference(load);
    LinearAlgebra::Vector before = space->owned_vector(),
                          behind = space->owned_vector();
    set_load(at - h);
    residual(du, before);
    set_load(at + h);
    residual(du, behind);
    set_load(at);
    load_derivative.add(-0.5 / h, behind, 0.5 / h, before);
  }



  template <int dim>
  void
  Balance<dim>::close_opening(LinearAlgebra::Vector &delta)
  {
    LinearAlgebra::Vector per_load = space->owned_vector();
    solver->solve(load_derivative, per_load);
    space->set_hanging(per_load);

    const double opening_per_load = (*opening)(per_load);
    // rounding errors are no motion
    if (std::abs(opening_per_load) <= 1e-10 * per_load.linfty_norm())
      throw InputError("Loading/Opening: the load factor, s in the formulas of "
                       "boundary conditions and loads, does not move the "
                       "places From and To apart.");
    corrected_load  = load;
    load_correction = (opening_gap - (*opening)(delta)) / opening_per_load;
    delta.add(load_correction, per_load);
  }



  template <int dim>
  void
  Balance<dim>::advance(const LinearAlgebra::Vector &from,
                        const double                 fraction,
                        const LinearAlgebra::Vector &delta,
                        LinearAlgebra::Vector       &du)
  {
    du = from;
    du.add(fraction, delta);
    if (opening)
      {
        set_load(corrected_load + fraction * load_correction);
        impose(du);
      }
  }



#define INSTANTIATE(dim)                                               \
  template void                Balance<dim>::aim_at(const double);     \
  template std::vector<double> Balance<dim>::prescribed_rates() const; \
  template void                Balance<dim>::add_load_derivative(      \
    const LinearAlgebra::Vector &);                     \
  template void Balance<dim>::close_opening(LinearAlgebra::Vector &);  \
  template void Balance<dim>::advance(const LinearAlgebra::Vector &,   \
                                      const double,                    \
                                      const LinearAlgebra::Vector &,   \
                                      LinearAlgebra::Vector &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Riedel::Equilibrium
