// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <deal.II/base/point.h>

#include <memory>
#include <string>

namespace dealii
{
  template <int>
  class FunctionParser;
}

namespace Riedel
{
  /**
   * A formula of the input file: a number or an expression in the initial
   * coordinates x, y (, z) [m], the load parameter s and pi. Copies share the
   * compiled formula.
   */
  template <int dim>
  class Expression
  {
  public:
    /// An expression that is not given; given() is false.
    Expression() = default;

    /// Compiles @p text; an empty one gives an Expression that is not given.
    /// Throws std::invalid_argument with a readable reason.
    explicit Expression(const std::string &text);

    bool
    given() const
    {
      return !formula.empty();
    }

    /// Value at an initial position [m] and a load parameter. Throws
    /// ComputationError where the formula has no finite value.
    double
    operator()(const dealii::Point<dim> &x, const double s) const;

    const std::string &
    text() const
    {
      return formula;
    }

  private:
    std::string formula;
    /// its value if it is a plain number; then there is no parser
    double                                       number = 0.0;
    std::shared_ptr<dealii::FunctionParser<dim>> parser;
  };
} // namespace Riedel
