// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/continuum/generalised.h>
#include <riedel/continuum/newton.h>
#include <riedel/continuum/space_tensor.h>
#include <riedel/continuum/turn_in_space.h>
#include <riedel/material/neo_hookean_elasticity.h>

#include <array>
#include <cmath>
#include <type_traits>

namespace Riedel::Material
{
  /// What a point of a finite-strain micropolar law remembers of its motion.
  template <int dim, typename Number>
  struct StretchAndCurvature
  {
    /// V^e - I, elastic
    Continuum::SpaceTensor<dim, Number> elastic;
    /// k^e, elastic left curvature [1/m]
    Continuum::CurvatureTensor<dim, Number> curvature;
    /// F Q^T - I, of the whole deformation from the stress-free state
    Continuum::SpaceTensor<dim, Number> total;
  };

  /**
   * The kinematics of a step (doc/theory/elastoplasticity.md, section 2): with
   * f = I + H, dQ = exp(theta) and T(theta) the tangent of the exponential map,
   *
   *     V_trial = f V dQ^T    k_trial = (dQ k + T Gamma Vtot) dQ^T
   *
   * and the way back to generalised stresses. A classical continuum has no
   * rotation of its own: its dQ is a constant chosen so that V_trial is
   * symmetric, which changes no stress because kappa = 0. Number is that of one
   * point, with derivatives or without, or Lanes.
   */
  template <int dim, bool micropolar, typename Number>
  struct FiniteStrainStep
  {
    using Order = Continuum::Generalised<dim>;
    using Value = Continuum::ValueOf<Number>;
    using Start = StretchAndCurvature<dim, Value>;

    /// number of generalised components
    static constexpr unsigned int n =
      micropolar ? Order::n_micropolar : Order::n_classical;

    /// f - I
    Continuum::SpaceTensor<dim, Number> H;
    /// of the elastic trial state and of the whole deformation
    StretchAndCurvature<dim, Number> trial;
    /// det F at the start and at the end
    Value  initial_volume;
    Number volume;
    /// f does not turn the point inside out; for Lanes also: theta is small
    Continuum::ConditionOf<Number> valid;

    /// @param axis_3_strain logarithmic strain of axis 3, zero in plane strain
    FiniteStrainStep(const std::array<Number, n> &increments,
                     const Start                 &start,
                     const double                 axis_3_strain = 0.)
    {
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          H(i, j) = increments[Order::gradient(i, j)];
      if constexpr (dim == 2)
        H(2, 2) = Number(std::expm1(axis_3_strain));

      initial_volume = 1. + Continuum::determinant_minus_one(start.total);
      const Number j = 1. + Continuum::determinant_minus_one(H);
      volume         = initial_volume * j;
      valid          = Continuum::value_of(j) > 0.;
      if (!Continuum::any(valid))
        return;

      // f V - I
      const auto stretched = [&](const auto &E) { return H + E + H * E; };
      const auto moved     = stretched(start.elastic);

      // dQ^T - I and, in space, T - I
      Continuum::SpaceTensor<dim, Number>                  turned;
      [[maybe_unused]] Continuum::SpaceTensor<dim, Number> tangent;
      if constexpr (micropolar && dim == 3)
        {
          const Continuum::TurnInSpace<Number> turn(increments.data() +
                                                    Order::spin(0));
          turned  = Continuum::transpose(turn.rotation);
          tangent = turn.tangent;
        }
      else if constexpr (micropolar)
        turned = turn(increments[Order::spin(0)]);
      else
        turned = turn_to_symmetry(moved);

      trial.elastic = moved + turned + moved * turned;
      if (was_elastic(start))
        trial.total = trial.elastic;
      else
        {
          const auto all = stretched(start.total);
          trial.total    = all + turned + all * turned;
        }
      if constexpr (micropolar)
        {
          Continuum::CurvatureTensor<dim, Number> gradient;
          for (unsigned int i = 0; i < gradient.n; ++i)
            gradient.components[i] = increments[Order::curvature(0, 0) + i];
          auto sum = Continuum::times_one_plus(gradient, start.total);
          if constexpr (dim == 3)
            sum = with_turned_rotation(tangent, sum, start.curvature, turned);
          else
            for (unsigned int i = 0; i < sum.n; ++i)
              sum.components[i] += start.curvature.components[i];
          trial.curvature = Continuum::times_one_plus(sum, turned);
        }
      else
        trial.curvature.components.fill(Number(0.));
    }

    /// P = j sigma f^-T, t_k = j e_kij sigma_ij, M = j m f^-T from J sigma and
    /// J m, J = j J_n
    std::array<Number, n>
    generalised(
      const Continuum::SpaceTensor<dim, Number>     &kirchhoff,
      const Continuum::CurvatureTensor<dim, Number> &kirchhoff_couple) const
    {
      // j in the plane only where axis 3 is stretched, too
      Value inverse_volume = 1. / initial_volume;
      if constexpr (dim == 2)
        inverse_volume = inverse_volume / (1. + Continuum::value_of(H(2, 2)));
      auto cofactor = Continuum::inverse_transposed(H);
      for (Number &component : cofactor.components)
        component = component * inverse_volume;

      std::array<Number, n> result;
      const auto            P = kirchhoff * cofactor;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          result[Order::gradient(i, j)] = P(i, j);
      if constexpr (micropolar)
        {
          if constexpr (dim == 2)
            result[Order::spin(0)] =
              (kirchhoff(0, 1) - kirchhoff(1, 0)) * inverse_volume;
          else
            for (unsigned int k = 0; k < 3; ++k)
              {
                const unsigned int i = (k + 1) % 3, j = (k + 2) % 3;
                result[Order::spin(k)] =
                  (kirchhoff(i, j) - kirchhoff(j, i)) * inverse_volume;
              }
          const auto M = kirchhoff_couple * cofactor;
          for (unsigned int i = 0; i < M.n; ++i)
            result[Order::curvature(0, 0) + i] = M.components[i];
        }
      return result;
    }

  private:
    /// Has all deformation been elastic so far? For Lanes it is not asked.
    static bool
    was_elastic(const Start &start)
    {
      if constexpr (std::is_same<Value, double>::value)
        return start.total.components == start.elastic.components;
      else
        return false;
    }

    /// exp(theta)^T - I in the plane
    Continuum::SpaceTensor<2, Number>
    turn(const Number &theta)
    {
      Continuum::SpaceTensor<2, Number> turned;
      const Value                       angle = Continuum::value_of(theta);
      if constexpr (Continuum::IsLanes<Number>::value)
        valid = valid && Continuum::abs(angle) <
                           Continuum::Turn<Value>::largest_small_angle;
      const Continuum::Turn<Value> rotation = Continuum::turn(angle);
      // cos - 1 without cancellation for small angles
      const Value less =
        Continuum::select(rotation.cosine > Value(0.),
                          Value(-(rotation.sine * rotation.sine) /
                                (1. + rotation.cosine)),
                          Value(rotation.cosine - 1.));
      const Number cosine = Continuum::chain_rule(theta, less, -rotation.sine);
      const Number sine =
        Continuum::chain_rule(theta, rotation.sine, rotation.cosine);
      turned(0, 0) = turned(1, 1) = cosine;
      turned(0, 1)                = sine;
      turned(1, 0)                = -sine;
      turned(2, 2)                = Number(0.);
      return turned;
    }

    /// The rotation R - I that makes V R symmetric, as a constant; in space by
    /// Newton's method for the polar decomposition, X <- (X + X^-T)/2 (Higham,
    /// 1986), which converges for every invertible tensor.
    static Continuum::SpaceTensor<dim, Number>
    turn_to_symmetry(const Continuum::SpaceTensor<dim, Number> &moved)
    {
      using std::sqrt;
      if constexpr (dim == 3)
        {
          Continuum::SpaceTensor<3, Value> X;
          for (unsigned int i = 0; i < X.n; ++i)
            X.components[i] = Continuum::value_of(moved.components[i]);
          double change = 1.;
          for (unsigned int k = 0; k < 50 && change > 1e-15; ++k)
            {
              auto difference = .5 * (Continuum::inverse_transposed(X) - X);
              Continuum::add_to_diagonal(difference, -.5);
              X      = X + difference;
              change = Continuum::largest_value(difference.components);
            }
          Continuum::SpaceTensor<3, Number> turned;
          for (unsigned int i = 0; i < X.n; ++i)
            turned.components[i] = Number(X.components[X.transposed_place(i)]);
          return turned;
        }
      else
        {
          const Value x = 2. + Continuum::value_of(moved(0, 0)) +
                          Continuum::value_of(moved(1, 1));
          const Value y =
            Continuum::value_of(moved(1, 0)) - Continuum::value_of(moved(0, 1));
          const Value length2 = x * x + y * y;
          const Value length  = sqrt(length2);
          const Value sine    = y / length;
          const Value less =
            Continuum::select(x > Value(0.),
                              Value(-(y * y) / (length * (length + x))),
                              Value((x - length) / length));
          Continuum::SpaceTensor<dim, Number> turned;
          turned(0, 0) = turned(1, 1) = Number(less);
          turned(0, 1)                = Number(sine);
          turned(1, 0)                = Number(-sine);
          turned(2, 2)                = Number(0.);
          return turned;
        }
    }

    /// dQ k + T(theta) sum, in space; @p tangent is T - I
    static Continuum::CurvatureTensor<3, Number>
    with_turned_rotation(const Continuum::SpaceTensor<3, Number>     &tangent,
                         const Continuum::CurvatureTensor<3, Number> &sum,
                         const Continuum::CurvatureTensor<3, Value>  &k,
                         const Continuum::SpaceTensor<3, Number>     &turned)
    {
      Continuum::CurvatureTensor<3, Number> result = sum;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          {
            result.components[3 * i + j] += k.components[3 * i + j];
            for (unsigned int l = 0; l < 3; ++l)
              result.components[3 * i + j] +=
                tangent(i, l) * sum.components[3 * l + j] +
                turned(l, i) * k.components[3 * l + j];
          }
      return result;
    }
  };
} // namespace Riedel::Material
