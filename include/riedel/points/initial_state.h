// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/material/law.h>
#include <riedel/points/parameters.h>

#include <deal.II/base/bounding_box.h>

namespace Riedel::Points
{
  /**
   * The state in which a scene starts, as a function of position: stress at
   * rest under weight, void ratio with zones and random field (see
   * InitialStateParameters).
   */
  template <int dim>
  class InitialState
  {
  public:
    InitialState(const InitialStateParameters<dim> &parameters,
                 const dealii::BoundingBox<dim>    &body);

    Material::InitialState
    operator()(const dealii::Point<dim> &x) const;

    /// Dry unit weight gamma_s / (1 + e) of a void ratio [N/m3].
    double
    unit_weight(const double void_ratio) const;

  private:
    double
    void_ratio(const dealii::Point<dim> &x) const;

    const InitialStateParameters<dim> *parameters;
    dealii::BoundingBox<dim>           body;
  };

  /**
   * A number uniform in (0, 1) that depends on the seed and the place only:
   * the first draw of a Mersenne twister that both have seeded (Boost, so the
   * same everywhere).
   */
  template <int dim>
  double
  uniform_at(const std::array<int, dim> &cell, const unsigned int seed);
} // namespace Riedel::Points
