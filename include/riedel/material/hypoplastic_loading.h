// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/continuum/plane_tensor.h>
#include <riedel/material/hypoplastic_rate.h>

#include <array>

namespace Riedel::Material
{
  /// The values of an array of numbers.
  template <typename Number, std::size_t n>
  std::array<Continuum::ValueOf<Number>, n>
  values_of(const std::array<Number, n> &numbers)
  {
    std::array<Continuum::ValueOf<Number>, n> values;
    for (std::size_t i = 0; i < n; ++i)
      values[i] = Continuum::value_of(numbers[i]);
    return values;
  }



  /// What drives a point through a step: d^c dt and k d_50 dt in the fixed
  /// frame, and the spin by which the rotating frame turns.
  /// @tparam axis_3 is d_33 given? Otherwise it is zero.
  template <bool micropolar, typename Number, bool axis_3 = false>
  struct HypoplasticLoading
  {
    Continuum::PlaneTensor<Number> d;
    std::array<Number, 2>          k;
    Number                         spin;
    /// sqrt(d^c:d^c + (k d_50)^2), the same in every frame
    Number length;
    /// d_33 dt, the same in every frame
    std::array<Number, axis_3 ? 1 : 0> d_33;

    /// Components in the frame that has turned for the part @p time of the
    /// step.
    HypoplasticStretching<micropolar, Number, axis_3>
    at(const double time) const
    {
      if (time == 0.)
        return components(d, k);
      const Continuum::PlaneRotation<Number> rotation(spin * time);
      return components(d.to_turned_frame(rotation),
                        micropolar ? to_turned_frame(k, rotation) : k);
    }

    HypoplasticLoading<micropolar, Continuum::ValueOf<Number>, axis_3>
    values() const
    {
      HypoplasticLoading<micropolar, Continuum::ValueOf<Number>, axis_3> result{
        {Continuum::value_of(d.mean),
         Continuum::value_of(d.difference),
         Continuum::value_of(d.shear),
         Continuum::value_of(d.turn)},
        values_of(k),
        Continuum::value_of(spin),
        Continuum::value_of(length),
        {}};
      if constexpr (axis_3)
        result.d_33 = values_of(d_33);
      return result;
    }

  private:
    HypoplasticStretching<micropolar, Number, axis_3>
    components(const Continuum::PlaneTensor<Number> &d,
               const std::array<Number, 2>          &k) const
    {
      const Number d_11 = d.mean + d.difference;
      const Number d_22 = d.mean - d.difference;
      if constexpr (micropolar && axis_3)
        return {{d_11,
                 d_22,
                 d.shear - d.turn,
                 d.shear + d.turn,
                 k[0],
                 k[1],
                 d_33[0]}};
      else if constexpr (micropolar)
        return {{d_11, d_22, d.shear - d.turn, d.shear + d.turn, k[0], k[1]}};
      else if constexpr (axis_3)
        return {{d_11, d_22, d.shear, d.shear, d_33[0]}};
      else
        return {{d_11, d_22, d.shear, d.shear}};
    }
  };
} // namespace Riedel::Material
