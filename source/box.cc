// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/box.h>
#include <riedel/errors.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <utility>

namespace Riedel
{
  namespace Patterns  = dealii::Patterns;
  namespace Utilities = dealii::Utilities;

  template <int dim>
  std::string
  box_form()
  {
    return dim == 2 ? "x0, y0 : x1, y1" : "x0, y0, z0 : x1, y1, z1";
  }



  template <int dim>
  dealii::BoundingBox<dim>
  read_box(const std::string &text, const std::string &path)
  {
    const std::string form =
      " Write the lower left and the upper right corner [m]: "
      "\"" +
      box_form<dim>() + "\".";
    if (text.empty())
      throw ParameterError(path, "The box is missing." + form);

    std::pair<dealii::Point<dim>, dealii::Point<dim>> corners;
    const auto parts = Utilities::split_string_list(text, ':');
    bool       good  = parts.size() == 2;
    for (unsigned int corner = 0; good && corner < 2; ++corner)
      {
        const auto numbers = Utilities::split_string_list(parts[corner]);
        good               = numbers.size() == dim;
        for (unsigned int d = 0; good && d < dim; ++d)
          {
            good = Patterns::Double().match(numbers[d]);
            if (good)
              (corner == 0 ? corners.first : corners.second)[d] =
                Utilities::string_to_double(numbers[d]);
          }
      }
    if (!good)
      throw ParameterError(path,
                           "The box \"" + text + "\" cannot be read." + form);
    for (unsigned int d = 0; d < dim; ++d)
      if (!(corners.first[d] < corners.second[d]))
        throw ParameterError(path,
                             "The box \"" + text +
                               "\" is empty: each coordinate of the first "
                               "corner must be smaller than that of the "
                               "second." +
                               form);
    return dealii::BoundingBox<dim>(corners);
  }



  template std::string
  box_form<2>();
  template dealii::BoundingBox<2>
  read_box(const std::string &, const std::string &);
  template std::string
  box_form<3>();
  template dealii::BoundingBox<3>
  read_box(const std::string &, const std::string &);
} // namespace Riedel
