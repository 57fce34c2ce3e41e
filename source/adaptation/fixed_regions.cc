// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/adaptation/fixed_regions.h>

namespace Riedel::Adaptation
{
  template <int dim>
  FixedRegions<dim>::FixedRegions(
    const Parameters<dim>                     &parameters,
    const Points::InitialStateParameters<dim> &initial)
    : everywhere(parameters.random_field_initially &&
                 initial.random_field.amplitude != 0.0)
  {
    if (parameters.has(Criterion::region))
      for (const auto &region : parameters.regions)
        boxes.push_back(region.box);
    if (parameters.zones_initially)
      for (const auto &zone : initial.zones)
        boxes.push_back(zone.box);
  }



  template <int dim>
  bool
  FixedRegions<dim>::meet(
    const typename dealii::Triangulation<dim>::cell_iterator &cell) const
  {
    if (everywhere)
      return true;
    const dealii::BoundingBox<dim> cell_box = cell->bounding_box();
    // cells that share no more than an edge with a box are outside
    const double tolerance = 1e-6 * cell->diameter();
    for (const auto &box : boxes)
      {
        bool inside = true;
        for (unsigned int d = 0; d < dim; ++d)
          inside =
            inside &&
            std::max(box.lower_bound(d), cell_box.lower_bound(d)) + tolerance <
              std::min(box.upper_bound(d), cell_box.upper_bound(d));
        if (inside)
          return true;
      }
    return false;
  }



  template class FixedRegions<2>;
  template class FixedRegions<3>;
} // namespace Riedel::Adaptation
