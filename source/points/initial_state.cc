// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/points/initial_state.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/seed_seq.hpp>
#include <boost/random/uniform_01.hpp>

#include <cmath>

namespace Riedel::Points
{
  template <int dim>
  InitialState<dim>::InitialState(const InitialStateParameters<dim> &parameters,
                                  const dealii::BoundingBox<dim>    &body)
    : parameters(&parameters)
    , body(body)
  {}



  template <int dim>
  double
  InitialState<dim>::unit_weight(const double void_ratio) const
  {
    return parameters->grain_unit_weight / (1.0 + void_ratio);
  }



  template <int dim>
  Material::InitialState
  InitialState<dim>::operator()(const dealii::Point<dim> &x) const
  {
    constexpr unsigned int up = dim - 1;

    const double top = body.get_boundary_points().second[up];
    // The weight above a point is that of the uniform void ratio: a column
    // with zones or a random field would not be in equilibrium otherwise.
    const double vertical =
      -(parameters->pressure_at_top +
        unit_weight(parameters->void_ratio) * (top - x[up]));

    Material::InitialState state;
    for (unsigned int d = 0; d < 3; ++d)
      state.stress[d][d] = (d == up ? 1.0 : parameters->K0) * vertical;
    state.void_ratio = void_ratio(x);
    return state;
  }



  template <int dim>
  double
  InitialState<dim>::void_ratio(const dealii::Point<dim> &x) const
  {
    for (auto zone = parameters->zones.rbegin();
         zone != parameters->zones.rend();
         ++zone)
      if (zone->box.point_inside(x))
        return zone->void_ratio;

    const auto &field = parameters->random_field;
    if (field.amplitude == 0.0)
      return parameters->void_ratio;

    std::array<int, dim>      cell;
    const dealii::Point<dim> &origin = body.get_boundary_points().first;
    for (unsigned int d = 0; d < dim; ++d)
      cell[d] =
        static_cast<int>(std::floor((x[d] - origin[d]) / field.cell_size));
    // r in (0.01, 0.99) as in the published study of Tejchman
    const double r = 0.01 + 0.98 * uniform_at<dim>(cell, field.seed);
    return parameters->void_ratio + field.amplitude * r;
  }



  template <int dim>
  double
  uniform_at(const std::array<int, dim> &cell, const unsigned int seed)
  {
    std::vector<unsigned int> words = {seed};
    for (const int index : cell)
      words.push_back(static_cast<unsigned int>(index));
    boost::random::seed_seq sequence(words.begin(), words.end());
    boost::random::mt19937  generator(sequence);
    return boost::random::uniform_01<double>()(generator);
  }



  template class InitialState<2>;
  template double
  uniform_at<2>(const std::array<int, 2> &, const unsigned int);
  template class InitialState<3>;
  template double
  uniform_at<3>(const std::array<int, 3> &, const unsigned int);
} // namespace Riedel::Points
