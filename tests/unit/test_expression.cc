// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/errors.h>
#include <riedel/expression.h>

#include <catch2/catch.hpp>

#include <iostream>
#include <sstream>
#include <stdexcept>

using Riedel::Expression;

TEST_CASE("an expression is a number, a formula or not given", "[unit]")
{
  const dealii::Point<2> x(2.0, 3.0);
  CHECK_FALSE(Expression<2>().given());
  CHECK_FALSE(Expression<2>("").given());
  CHECK_FALSE(Expression<2>("  ").given());

  CHECK(Expression<2>("0").given());
  CHECK(Expression<2>("100e3")(x, 0.5) == 100e3);
  CHECK(Expression<2>(" -2.5 ")(x, 0.5) == -2.5);
  CHECK(Expression<2>("0.005 * s")(x, 0.5) == Approx(0.0025));
  CHECK(Expression<2>("x + 10*y")(x, 0.5) == Approx(32.0));
  CHECK(Expression<2>("sin(pi/2) * s")(x, 0.25) == Approx(0.25));
  CHECK(Expression<2>("if(s < 0.5, 1, 2)")(x, 0.75) == 2.0);
  CHECK(Expression<3>("z*s")(dealii::Point<3>(1, 2, 3), 2.0) == Approx(6.0));
  CHECK(Expression<2>("x + s").text() == "x + s");
}

TEST_CASE("copies of an expression compute the same", "[unit]")
{
  const Expression<2> original("x * s");
  const Expression<2> copy = original;
  CHECK(copy(dealii::Point<2>(2, 0), 3.0) == Approx(6.0));
  CHECK(original(dealii::Point<2>(2, 0), 4.0) == Approx(8.0));
  CHECK(copy(dealii::Point<2>(2, 0), 3.0) == Approx(6.0));
}

TEST_CASE("an unreadable formula says why, and nothing else", "[unit]")
{
  for (const std::string formula : {"2*t",
                                    "y*foo",
                                    "(x",
                                    "x+",
                                    "sin(x) y",
                                    "x;y",
                                    "z",
                                    "S",
                                    "nan",
                                    "100 kPa"})
    {
      std::ostringstream noise;
      std::streambuf    *before = std::cerr.rdbuf(noise.rdbuf());
      std::string        message;
      try
        {
          Expression<2> expression(formula);
        }
      catch (const std::invalid_argument &reason)
        {
          message = reason.what();
        }
      std::cerr.rdbuf(before);

      INFO(formula);
      CHECK_THAT(message, Catch::Contains("\"" + formula + "\""));
      CHECK_THAT(message, Catch::Contains("the initial coordinates x, y [m]"));
      CHECK(noise.str().empty());
    }
  CHECK_THROWS_WITH(Expression<2>("2*t"), Catch::Contains("\"t\""));
}

TEST_CASE("a formula without a finite value stops the computation", "[unit]")
{
  const Expression<2> expression("1/s");
  CHECK(expression(dealii::Point<2>(), 0.5) == Approx(2.0));
  CHECK_THROWS_AS(expression(dealii::Point<2>(), 0.0),
                  Riedel::ComputationError);
  CHECK_THROWS_WITH(expression(dealii::Point<2>(1, 2), 0.0),
                    Catch::Contains("\"1/s\"") &&
                      Catch::Contains("(1, 2) m for s = 0"));
}
