// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/continuum/lanes.h>
#include <riedel/material/elastic_tangent.h>
#include <riedel/material/finite_strain_law.h>
#include <riedel/material/prestress.h>
#include <riedel/material/return_mapping.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <type_traits>

namespace Riedel::Material
{
  using Continuum::Forward;
  using Continuum::input;
  using Continuum::value_of;

  namespace
  {
    /// Places in a point's state, in the order of the constructor.
    template <int dim, bool micropolar, bool plastic>
    struct Places
    {
      static constexpr unsigned int n_tensor =
        Continuum::SpaceTensor<dim, double>::n;
      static constexpr unsigned int n_couple =
        micropolar ? Continuum::CurvatureTensor<dim, double>::n : 0;
      static constexpr unsigned int couple_stress = n_tensor;
      static constexpr unsigned int elastic       = couple_stress + n_couple;
      static constexpr unsigned int curvature     = elastic + n_tensor;
      /// total_strain or volume_ratio
      static constexpr unsigned int total = curvature + n_couple;
      static constexpr unsigned int multiplier =
        total + (micropolar ? n_tensor : 1);
      static constexpr unsigned int strength = multiplier + 1;
      static constexpr unsigned int yield    = strength + 1;
      static constexpr unsigned int n        = plastic ? yield + 1 : total;
    };

    template <int dim>
    std::vector<std::string>
    tensor_components()
    {
      std::vector<std::string> names = {"11", "22", "33", "12", "21"};
      if (dim == 3)
        names.insert(names.end(), {"13", "31", "23", "32"});
      return names;
    }



    /// In plane strain the axis of the face alone: the other is 3.
    template <int dim>
    std::vector<std::string>
    couple_components()
    {
      if (dim == 2)
        return {"1", "2"};
      return {"11", "12", "13", "21", "22", "23", "31", "32", "33"};
    }

    template <int dim, bool micropolar, bool plastic>
    StateLayout
    make_layout(const std::string &strength_slot,
                const std::string &strength_meaning)
    {
      const auto  components = tensor_components<dim>();
      const auto  couples    = couple_components<dim>();
      StateLayout layout;
      layout.add("stress",
                 "Pa",
                 "Cauchy stress, tension positive, second index: face normal",
                 components);
      if (micropolar)
        layout.add("couple_stress",
                   "N/m",
                   dim == 2 ?
                     "couple stress m_31, m_32 on faces with normals 1, 2" :
                     "couple stress m_ij, second index: face normal",
                   couples);
      layout.add("elastic_strain",
                 "1",
                 "elastic left stretch minus unit tensor, V^e - I",
                 components);
      if (micropolar)
        layout.add("elastic_curvature",
                   "1/m",
                   dim == 2 ? "elastic left curvature k_31, k_32" :
                              "elastic left curvature k_ij",
                   couples);
      if (plastic)
        {
          if (micropolar)
            layout.add("total_strain",
                       "1",
                       "left stretch minus unit tensor, F Q^T - I, from the "
                       "stress-free state",
                       components);
          else
            layout.add("volume_ratio",
                       "1",
                       "volume over that of the stress-free state, det F");
          layout.add("plastic_multiplier",
                     "1",
                     "hardening variable, the sum of the plastic multipliers");
          layout.add(strength_slot, "Pa", strength_meaning);
          layout.add("yield_function",
                     "Pa",
                     "yield function, negative where the point is elastic");
        }
      return layout;
    }



    /// What a state says of stretch and curvature. @p at gives the number of a
    /// place.
    template <int  dim,
              bool micropolar,
              bool plastic,
              typename Value,
              typename At>
    StretchAndCurvature<dim, Value>
    read_motion(const At &at)
    {
      using Place = Places<dim, micropolar, plastic>;
      StretchAndCurvature<dim, Value> motion;
      for (unsigned int i = 0; i < Place::n_tensor; ++i)
        motion.elastic.components[i] = at(Place::elastic + i);
      motion.curvature.components.fill(Value(0.));
      if constexpr (micropolar)
        for (unsigned int i = 0; i < Place::n_couple; ++i)
          motion.curvature.components[i] = at(Place::curvature + i);
      motion.total = motion.elastic;
      if constexpr (plastic && micropolar)
        for (unsigned int i = 0; i < Place::n_tensor; ++i)
          motion.total.components[i] = at(Place::total + i);
      if constexpr (plastic && !micropolar)
        {
          // any strain of this volume: a classical law asks for no more
          motion.total.components.fill(Value(0.));
          motion.total.components[0] = at(Place::total) - 1.;
        }
      return motion;
    }



    /// Writes what the step has made of a point. @p at as above, to write to.
    template <int  dim,
              bool micropolar,
              bool plastic,
              typename Number,
              typename At>
    void
    write_state(const StretchAndCurvature<dim, Number>        &motion,
                const Continuum::SpaceTensor<dim, Number>     &kirchhoff,
                const Continuum::CurvatureTensor<dim, Number> &kirchhoff_couple,
                const Number                                  &volume,
                const At                                      &at)
    {
      using Place        = Places<dim, micropolar, plastic>;
      const auto inverse = 1. / value_of(volume);
      for (unsigned int i = 0; i < Place::n_tensor; ++i)
        {
          at(i, value_of(kirchhoff.components[i]) * inverse);
          at(Place::elastic + i, value_of(motion.elastic.components[i]));
        }
      if constexpr (micropolar)
        for (unsigned int i = 0; i < Place::n_couple; ++i)
          {
            at(Place::couple_stress + i,
               value_of(kirchhoff_couple.components[i]) * inverse);
            at(Place::curvature + i, value_of(motion.curvature.components[i]));
          }
      if constexpr (plastic && micropolar)
        for (unsigned int i = 0; i < Place::n_tensor; ++i)
          at(Place::total + i, value_of(motion.total.components[i]));
      if constexpr (plastic && !micropolar)
        at(Place::total, value_of(volume));
    }

    /// Was a point so far from the yield surface that it may stay elastic? What
    /// was at the surface will mostly yield again.
    template <typename Value>
    auto
    is_inside(const Value &yield, const Value &strength)
    {
      return yield < -1e-3 * strength;
    }

    constexpr int n_lanes = Continuum::n_native_lanes;
  } // namespace



  template <int dim, bool micropolar, bool plastic>
  FiniteStrainLaw<dim, micropolar, plastic>::FiniteStrainLaw(
    const std::string &strength_slot,
    const std::string &strength_meaning)
    : slots(
        make_layout<dim, micropolar, plastic>(strength_slot, strength_meaning))
  {}



  template <int dim, bool micropolar, bool plastic>
  void
  FiniteStrainLaw<dim, micropolar, plastic>::initialise(
    const InitialState &initial,
    double             *state) const
  {
    using Place = Places<dim, micropolar, plastic>;
    std::fill(state, state + slots.size(), 0.);
    StretchAndCurvature<dim, double> motion;
    motion.elastic.components.fill(0.);
    motion.curvature.components.fill(0.);
    // check_initial() refuses stresses without a strain
    if (const auto strain = strain_of_stress<dim>(elasticity, initial.stress))
      motion.elastic = *strain;
    motion.total        = motion.elastic;
    const double volume = 1. + determinant_minus_one(motion.elastic);
    const ReturnMapping<dim, micropolar> mapping(elasticity, plasticity);
    const auto                           stress = mapping.stress(motion);
    write_state<dim, micropolar, plastic>(motion,
                                          stress.force,
                                          stress.couple,
                                          volume,
                                          [&](const unsigned int place,
                                              const double       value) {
                                            state[place] = value;
                                          });
    if constexpr (plastic)
      {
        const double strength  = plasticity.strength_at(0.);
        state[Place::strength] = strength / strength_factor;
        state[Place::yield] =
          mapping.invariants(stress, volume).function(plasticity, strength);
      }
  }



  template <int dim, bool micropolar, bool plastic>
  void
  FiniteStrainLaw<dim, micropolar, plastic>::stresses_at_rest(
    const double *state,
    double       *stresses) const
  {
    using Place = Places<dim, micropolar, plastic>;
    using Order = Continuum::Generalised<dim>;
    Continuum::SpaceTensor<dim, double> sigma;
    std::copy_n(state, Place::n_tensor, sigma.components.begin());
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        stresses[Order::gradient(i, j)] = sigma(i, j);
    if constexpr (micropolar)
      {
        for (unsigned int k = 0; k < Order::n_spin; ++k)
          {
            const unsigned int i = (k + 1) % 3 % dim, j = (k + 2) % 3 % dim;
            // in plane strain the only axis is 3
            stresses[Order::spin(k)] =
              dim == 2 ? sigma(0, 1) - sigma(1, 0) : sigma(i, j) - sigma(j, i);
          }
        std::copy_n(state + Place::couple_stress,
                    Place::n_couple,
                    stresses + Order::curvature(0, 0));
      }
  }



  template <int dim, bool micropolar, bool plastic>
  void
  FiniteStrainLaw<dim, micropolar, plastic>::count_yielding(
    const double a,
    const double A_p,
    Report      &report) const
  {
    ++report.yielding;
    const double h = plasticity.modulus_at(a);
    // a modulus of zero is that of perfect plasticity
    if (micropolar && h < 0.)
      {
        const double mu    = elasticity.mu;
        const double mu_ep = mu * h / (h + 3. * mu);
        if (!(elasticity.couple_modulus() > std::abs(mu_ep)))
          ++report.unregularised;
      }
    if (plasticity.strength_at(a) - A_p <= 1e-3 * plasticity.strength)
      ++report.without_strength;
  }



  template <int dim, bool micropolar, bool plastic>
  template <typename Number>
  Report::Refusal
  FiniteStrainLaw<dim, micropolar, plastic>::respond_point(
    const double *increment,
    const double  axis_3_strain,
    const double *committed,
    double       *trial,
    double       *stresses,
    double       *tangent,
    Report       &report) const
  {
    using Step               = FiniteStrainStep<dim, micropolar, Number>;
    using Place              = Places<dim, micropolar, plastic>;
    constexpr unsigned int n = Step::n;

    std::array<Number, n> inputs;
    for (unsigned int i = 0; i < n; ++i)
      inputs[i] = input<Number>(increment[i], i);

    Step step(inputs,
              read_motion<dim, micropolar, plastic, double>(
                [&](const unsigned int place) { return committed[place]; }),
              axis_3_strain);
    if (!step.valid)
      return std::isfinite(value_of(step.volume)) ?
               Report::Refusal::inverted_step :
               Report::Refusal::not_finite;

    const ReturnMapping<dim, micropolar> mapping(elasticity, plasticity);
    Return                               where  = Return::elastic;
    double                               a      = 0.;
    auto                                 stress = mapping.stress(step.trial);
    if constexpr (plastic)
      {
        a                = committed[Place::multiplier];
        const auto trial = mapping.invariants(stress, step.volume);
        if (!std::isfinite(trial.q + trial.p))
          return Report::Refusal::not_finite;
        where = mapping(step.trial, step.volume, trial, a);
        if (where == Return::failed)
          return Report::Refusal::no_return;
        if (where != Return::elastic)
          stress = mapping.stress(step.trial);
      }
    const std::array<Number, n> generalised =
      step.generalised(stress.force, stress.couple);

    double sum = value_of(stress.force.components[2]);
    for (const Number &component : generalised)
      sum += value_of(component);
    if (!std::isfinite(sum))
      return Report::Refusal::not_finite;

    write_state<dim, micropolar, plastic>(step.trial,
                                          stress.force,
                                          stress.couple,
                                          step.volume,
                                          [&](const unsigned int place,
                                              const double       value) {
                                            trial[place] = value;
                                          });
    if constexpr (plastic)
      {
        const double strength    = plasticity.strength_at(a);
        const auto   end         = mapping.invariants(stress, step.volume);
        trial[Place::multiplier] = a;
        trial[Place::strength]   = strength / strength_factor;
        trial[Place::yield]      = end.function(plasticity, strength);
        if (where != Return::elastic)
          count_yielding(a, plasticity.friction * end.p, report);
        report.at_apex += where == Return::apex;
      }
    ++report.substeps;

    for (unsigned int i = 0; i < n; ++i)
      stresses[i] = value_of(generalised[i]);
    if constexpr (!std::is_same<Number, double>::value)
      for (unsigned int i = 0; i < n; ++i)
        generalised[i].derivatives.copy_to(tangent + i * n, n);
    else
      (void)tangent;
    return Report::Refusal::none;
  }



  template <int dim, bool micropolar, bool plastic>
  template <typename Number>
  void
  FiniteStrainLaw<dim, micropolar, plastic>::respond_point(const Batch &batch,
                                                           const unsigned int p,
                                                           Report &report) const
  {
    constexpr unsigned int n = FiniteStrainStep<dim, micropolar, Number>::n;
    constexpr unsigned int n_state = Places<dim, micropolar, plastic>::n;

    const Report::Refusal refusal = respond_point<Number>(
      batch.increments + p * n,
      batch.axis_3_strains == nullptr ? 0. : batch.axis_3_strains[p],
      batch.committed + p * n_state,
      batch.trial + p * n_state,
      batch.stresses + p * n,
      batch.tangents == nullptr ? nullptr : batch.tangents + p * n * n,
      report);
    if (refusal == Report::Refusal::none)
      return;
    if (report.refused == 0)
      {
        report.first_refused = p;
        report.reason        = refusal;
      }
    ++report.refused;
  }



  template <int dim, bool micropolar, bool plastic>
  template <typename Number>
  void
  FiniteStrainLaw<dim, micropolar, plastic>::respond_group(
    const Batch       &batch,
    const unsigned int first,
    Report            &report) const
  {
    using Value                    = Continuum::ValueOf<Number>;
    using Step                     = FiniteStrainStep<dim, micropolar, Number>;
    using Place                    = Places<dim, micropolar, plastic>;
    constexpr unsigned int n       = Step::n;
    constexpr unsigned int n_state = Place::n;
    constexpr bool         with_tangent = !std::is_same<Number, Value>::value;

    // where the batch ends inside the group, its last point fills the lanes
    const unsigned int n_points =
      std::min<unsigned int>(n_lanes, batch.n_points - first);
    std::array<Number, n>      inputs;
    std::array<Value, n_state> state;
    Continuum::read_rows(batch.increments + first * n, n_points, inputs);
    Continuum::read_rows(batch.committed + first * n_state, n_points, state);

    const Step               step(inputs,
                    read_motion<dim, micropolar, plastic, Value>(
                      [&](const unsigned int place) { return state[place]; }));
    Continuum::Mask<n_lanes> usual = step.valid;
    if constexpr (plastic)
      usual =
        usual && is_inside(state[Place::yield],
                           Value(strength_factor * state[Place::strength]));
    std::array<Number, n> generalised{};
    if (any(usual))
      {
        const ReturnMapping<dim, micropolar> mapping(elasticity, plasticity);
        const auto stress = mapping.stress(step.trial);
        generalised       = step.generalised(stress.force, stress.couple);
        write_state<dim, micropolar, plastic>(step.trial,
                                              stress.force,
                                              stress.couple,
                                              step.volume,
                                              [&](const unsigned int place,
                                                  const Value       &value) {
                                                state[place] = value;
                                              });
        Value sum = value_of(stress.force.components[2]);
        for (const Number &component : generalised)
          sum += value_of(component);
        usual = usual && is_finite(sum);
        if constexpr (plastic)
          {
            const auto  trial    = mapping.invariants(stress, step.volume);
            const Value strength = strength_factor * state[Place::strength];
            state[Place::yield]  = trial.function(plasticity, strength);
            usual                = usual && mapping.is_elastic(trial, strength);
          }
      }
    for (unsigned int lane = 0; lane < n_points; ++lane)
      {
        const unsigned int p = first + lane;
        if (usual[lane])
          {
            for (unsigned int i = 0; i < n_state; ++i)
              batch.trial[p * n_state + i] = state[i][lane];
            Continuum::write_row(generalised,
                                 lane,
                                 batch.stresses + p * n,
                                 with_tangent ? batch.tangents + p * n * n :
                                                nullptr);
            ++report.substeps;
          }
        else
          respond_point<NumberOfPoint<with_tangent>>(batch, p, report);
      }
  }



  template <int dim, bool micropolar, bool plastic>
  bool
  FiniteStrainLaw<dim, micropolar, plastic>::respond_elastic(
    [[maybe_unused]] const Batch       &batch,
    [[maybe_unused]] const unsigned int p,
    [[maybe_unused]] Report            &report) const
  {
    if constexpr (dim == 3)
      {
        using Place                    = Places<dim, micropolar, plastic>;
        constexpr unsigned int n_state = Place::n;
        constexpr unsigned int n = FiniteStrainStep<dim, micropolar, double>::n;

        const double *committed = batch.committed + p * n_state;
        if constexpr (plastic)
          if (!is_inside(committed[Place::yield],
                         strength_factor * committed[Place::strength]))
            return false;
        Report one;
        respond_point<double>(batch, p, one);
        if (one.refused > 0 || one.yielding > 0)
          return false;
        elastic_tangent_in_space<micropolar>(
          elasticity,
          batch.increments + p * n,
          read_motion<dim, micropolar, plastic, double>(
            [&](const unsigned int place) { return committed[place]; }),
          batch.tangents + p * n * n);
        report.substeps += one.substeps;
        return true;
      }
    else
      return false;
  }



  template <int dim, bool micropolar, bool plastic>
  Report
  FiniteStrainLaw<dim, micropolar, plastic>::respond(const Batch &batch) const
  {
    const bool with_tangent = batch.tangents != nullptr;
    Report     report;
    if constexpr (dim == 2)
      if (batch.axis_3_strains == nullptr)
        {
          using Value = Continuum::Lanes<n_lanes>;
          using WithTangent =
            Forward<FiniteStrainStep<dim, micropolar, Value>::n, Value>;
          for (unsigned int p = 0; p < batch.n_points; p += n_lanes)
            if (with_tangent)
              respond_group<WithTangent>(batch, p, report);
            else
              respond_group<Value>(batch, p, report);
          return report;
        }
    for (unsigned int p = 0; p < batch.n_points; ++p)
      if (!with_tangent)
        respond_point<NumberOfPoint<false>>(batch, p, report);
      else if (!respond_elastic(batch, p, report))
        respond_point<NumberOfPoint<true>>(batch, p, report);
    return report;
  }



  template <int dim, bool micropolar, bool plastic>
  void
  FiniteStrainLaw<dim, micropolar, plastic>::declare_elasticity(
    dealii::ParameterHandler &prm) const
  {
    using dealii::Patterns::Double;

    prm.declare_entry(
      "Lame modulus", "0", Double(), "First Lame modulus lambda. Pa.", true);
    prm.declare_entry(
      "Shear modulus", "0", Double(), "Shear modulus mu. Pa.", true);
    // The classical laws know the polar constants, too, and ignore them: to
    // compare, one changes only the law.
    const std::string ignored =
      micropolar ? "" : " The classical law ignores it.";
    const std::string measures =
      micropolar ? "" :
                   " The classical law takes from it no stress, only the "
                   "length L in which bands are measured and grids refined.";
    prm.declare_entry("Couple modulus",
                      "0",
                      Double(),
                      "Modulus mu_c of the skew part: sigma_12 - sigma_21 = 2 "
                      "mu_c (eps_12 - eps_21) for small strains. Pa." +
                        ignored,
                      micropolar);
    prm.declare_entry("Bending modulus",
                      "0",
                      Double(),
                      "Modulus gamma of the couple stress: m_i = gamma w,i in "
                      "plane strain for small strains. N." +
                        measures,
                      micropolar);
    prm.declare_entry("Curvature modulus beta",
                      "0",
                      Double(),
                      "Modulus beta of the transposed curvature. In plane "
                      "strain it enters the length L = sqrt((beta + gamma)/(2 "
                      "mu)) alone. N." +
                        ignored);
    prm.declare_entry("Curvature modulus alpha",
                      "0",
                      Double(),
                      "Modulus alpha of the trace of the curvature, which is "
                      "zero in plane strain. N." +
                        ignored);
  }



  template <int dim, bool micropolar, bool plastic>
  void
  FiniteStrainLaw<dim, micropolar, plastic>::parse_elasticity(
    dealii::ParameterHandler &prm)
  {
    elasticity                 = NeoHookeanElasticity();
    elasticity.lambda          = prm.get_double("Lame modulus");
    elasticity.mu              = prm.get_double("Shear modulus");
    NeoHookeanElasticity polar = elasticity;
    polar.kappa                = 2. * prm.get_double("Couple modulus");
    polar.gamma                = prm.get_double("Bending modulus");
    polar.beta                 = prm.get_double("Curvature modulus beta");
    polar.alpha                = prm.get_double("Curvature modulus alpha");
    // what check() refuses is no length
    const double length = polar.length();
    length_of_bands     = std::isfinite(length) ? length : 0.;
    if (micropolar)
      elasticity = polar;
  }



  template <int dim, bool micropolar, bool plastic>
  void
  FiniteStrainLaw<dim, micropolar, plastic>::check_elasticity(
    const std::string &path,
    Problems          &problems) const
  {
    const auto require = [&](const bool         holds,
                             const std::string &entry,
                             const double       read,
                             const std::string &allowed) {
      if (holds)
        return;
      std::ostringstream text;
      text << entry << " is " << read
           << ", but elastic energy is positive only if " << allowed << ".";
      problems.error(path + "/" + entry, text.str());
    };
    const auto &e = elasticity;
    require(e.mu > 0., "Shear modulus", e.mu, "mu > 0");
    require(3. * e.lambda + 2. * e.mu > 0.,
            "Lame modulus",
            e.lambda,
            "3 lambda + 2 mu > 0");
    if (micropolar)
      {
        require(e.kappa >= 0.,
                "Couple modulus",
                e.couple_modulus(),
                "mu_c >= 0");
        require(e.gamma > 0., "Bending modulus", e.gamma, "gamma > 0");
        if (e.gamma > 0.)
          require(e.gamma > std::abs(e.beta),
                  "Curvature modulus beta",
                  e.beta,
                  "gamma > |beta|");
        if (e.gamma > std::abs(e.beta))
          require(3. * e.alpha + e.beta + e.gamma > 0.,
                  "Curvature modulus alpha",
                  e.alpha,
                  "3 alpha + beta + gamma > 0");
      }
  }



  template <int dim, bool micropolar, bool plastic>
  void
  FiniteStrainLaw<dim, micropolar, plastic>::check_initial(
    const InitialState &initial,
    const std::string  &path,
    Problems           &problems) const
  {
    if (!(elasticity.mu > 0.) || !(elasticity.bulk_modulus() > 0.))
      return; // check() has said so
    const auto strain = strain_of_stress<dim>(elasticity, initial.stress);
    std::ostringstream text;
    text << "The initial stress (11: " << initial.stress[0][0]
         << ", 22: " << initial.stress[1][1] << ", 33: " << initial.stress[2][2]
         << ", 12: " << initial.stress[0][1] << " Pa) ";
    if (!strain)
      {
        text << "belongs to no elastic strain of this law.";
        problems.error(path, text.str());
        return;
      }
    if constexpr (plastic)
      {
        std::vector<double> state(slots.size());
        initialise(initial, state.data());
        const double f = state[Places<dim, micropolar, plastic>::yield];
        if (f > 1e-9 * (plasticity.strength + initial.stress.norm()))
          {
            text << "lies outside the yield surface: q + A p - c = " << f
                 << " Pa. Choose a K0 nearer to 1 or a larger strength.";
            problems.error(path, text.str());
          }
      }
  }



  template <int dim, bool micropolar>
  std::string
  NeoHookean<dim, micropolar>::name() const
  {
    return micropolar ? "neo-Hookean micropolar" : "neo-Hookean";
  }



  template <int dim, bool micropolar>
  void
  NeoHookean<dim, micropolar>::declare(dealii::ParameterHandler &prm) const
  {
    this->declare_elasticity(prm);
  }



  template <int dim, bool micropolar>
  void
  NeoHookean<dim, micropolar>::parse(dealii::ParameterHandler &prm)
  {
    this->parse_elasticity(prm);
  }



  template <int dim, bool micropolar>
  void
  NeoHookean<dim, micropolar>::check(const std::string &path,
                                     Problems          &problems) const
  {
    this->check_elasticity(path, problems);
  }



  template class FiniteStrainLaw<2, false, false>;
  template class FiniteStrainLaw<2, false, true>;
  template class FiniteStrainLaw<2, true, false>;
  template class FiniteStrainLaw<2, true, true>;
  template class FiniteStrainLaw<3, false, false>;
  template class FiniteStrainLaw<3, false, true>;
  template class FiniteStrainLaw<3, true, false>;
  template class FiniteStrainLaw<3, true, true>;
  template class NeoHookean<2, false>;
  template class NeoHookean<2, true>;
  template class NeoHookean<3, false>;
  template class NeoHookean<3, true>;
} // namespace Riedel::Material
