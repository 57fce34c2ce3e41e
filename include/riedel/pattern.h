// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/patterns.h>

#include <memory>
#include <string>

namespace Riedel
{
  /**
   * The pattern of a value with a form of its own, such as a formula or a box:
   * it tells users what to write and leaves the check to parse().
   */
  class FormPattern : public dealii::Patterns::PatternBase
  {
  public:
    /// @p form goes on the words "Allowed: ".
    explicit FormPattern(const std::string &form)
      : form(form)
    {}

    bool
    match(const std::string &) const override
    {
      return true;
    }

    std::string
    description(const OutputStyle) const override
    {
      return "[" + form + "]";
    }

    std::unique_ptr<PatternBase>
    clone() const override
    {
      return std::make_unique<FormPattern>(form);
    }

  private:
    const std::string form;
  };
} // namespace Riedel
