// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/errors.h>
#include <riedel/expression.h>

#include <deal.II/base/function_parser.h>
#include <deal.II/base/numbers.h>

#include <cmath>
#include <iostream>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace Riedel
{
  namespace
  {
    template <int dim>
    std::string
    coordinates()
    {
      return dim == 2 ? "x,y" : "x,y,z";
    }

    /// deal.II lets muParser write to std::cerr before it throws: catches that
    /// text, so that the user gets one message, not two.
    class Silence
    {
    public:
      Silence()
        : before(std::cerr.rdbuf(text.rdbuf()))
      {}

      ~Silence()
      {
        std::cerr.rdbuf(before);
      }

      /// muParser's own sentence
      std::string
      reason() const
      {
        std::smatch       match;
        const std::string all = text.str();
        if (std::regex_search(all, match, std::regex("Message:\\s*<(.*)>")))
          return std::regex_replace(match[1].str(),
                                    std::regex(" (found )?at position .*|\\.$"),
                                    "");
        return "";
      }

    private:
      std::ostringstream text;
      std::streambuf    *before;
    };
  } // namespace



  template <int dim>
  Expression<dim>::Expression(const std::string &text)
    : formula(text)
  {
    if (formula.find_first_not_of(" \t") == std::string::npos)
      {
        formula.clear();
        return;
      }

    std::istringstream stream(formula);
    if (stream >> number && (stream >> std::ws).eof())
      {
        if (!std::isfinite(number))
          throw std::invalid_argument("\"" + formula + "\" is not a number.");
        return;
      }

    std::string reason;
    if (formula.find(';') != std::string::npos)
      reason = "Unexpected \";\"";
    else
      {
        Silence silence;
        try
          {
            parser = std::make_shared<dealii::FunctionParser<dim>>(1);
            parser->initialize(coordinates<dim>() + ",s",
                               formula,
                               {{"pi", dealii::numbers::PI}},
                               true);
            parser->value(dealii::Point<dim>());
            return;
          }
        catch (const std::exception &)
          {
            reason = silence.reason();
          }
      }
    parser.reset();
    throw std::invalid_argument(
      "The formula \"" + formula + "\" cannot be read" +
      (reason.empty() ? "" : ": " + reason) +
      ".\nIt may contain numbers, + - * / ^, brackets, functions such as "
      "sin(), exp(), min(), if(), the initial coordinates " +
      (dim == 2 ? "x, y" : "x, y, z") + " [m], the load parameter s and pi.");
  }



  template <int dim>
  double
  Expression<dim>::operator()(const dealii::Point<dim> &x, const double s) const
  {
    if (parser == nullptr)
      return number;
    parser->set_time(s);
    const double value = parser->value(x);
    if (!std::isfinite(value))
      {
        std::ostringstream message;
        message << "The formula \"" << formula << "\" has no finite value at (";
        for (unsigned int d = 0; d < dim; ++d)
          message << (d == 0 ? "" : ", ") << x[d];
        message << ") m for s = " << s << '.';
        throw ComputationError(message.str());
      }
    return value;
  }



  template class Expression<2>;
  template class Expression<3>;
} // namespace Riedel
