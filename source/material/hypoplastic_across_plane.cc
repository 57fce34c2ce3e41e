// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/material/hypoplastic_response.h>

// In a file of its own: beside the functions of plane strain, these would make
// the compiler inline less into them, which costs 3 percent of their time.
namespace Riedel::Material
{
  template <bool micropolar>
  Report
  Hypoplastic<micropolar>::respond_across_plane(const Batch &batch) const
  {
    using WithTangent = Continuum::Forward<micropolar ? 8 : 4>;
    Report report;
    for (unsigned int p = 0; p < batch.n_points; ++p)
      if (batch.tangents == nullptr)
        respond_point<double, true>(batch, p, report);
      else
        respond_point<WithTangent, true>(batch, p, report);
    return report;
  }



  template Report
  Hypoplastic<true>::respond_across_plane(const Batch &) const;
  template Report
  Hypoplastic<false>::respond_across_plane(const Batch &) const;
} // namespace Riedel::Material
