// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <riedel/errors.h>
#include <riedel/material/law.h>

#include <deal.II/base/bounding_box.h>

#include <memory>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Riedel::Material
{
  /**
   * Section "Materials": one subsection per named material. Its "Law" decides
   * which other parameters the subsection has. "Box" limits it to a part of
   * the body ("x0, y0 : x1, y1" in m); without it, it fills the whole body.
   * The material named last claims a point that several boxes contain.
   */
  template <int dim>
  struct Parameters
  {
    struct Entry
    {
      std::string               name;
      std::shared_ptr<Law<dim>> law;
      bool                      everywhere = true;
      dealii::BoundingBox<dim>  box;
    };

    /// in the order of the file
    std::vector<Entry> materials;

    /// Declares one subsection per (name, law) pair found in the file; the law
    /// may be unknown or empty: then only "Law" and "Box" are declared.
    static void
    declare(dealii::ParameterHandler                               &prm,
            const std::vector<std::pair<std::string, std::string>> &names);
    void
    parse(dealii::ParameterHandler                               &prm,
          const std::vector<std::pair<std::string, std::string>> &names);
    void
    check(Problems &problems) const;

    /// Does the scene need rotation dofs?
    bool
    is_micropolar() const;

    /// Number of the material that claims a point, or -1.
    int
    material_at(const dealii::Point<dim> &x) const;
  };
} // namespace Riedel::Material
