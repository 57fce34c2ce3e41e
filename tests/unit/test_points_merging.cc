// SPDX-License-Identifier: LGPL-2.1-or-later
#include <riedel/points/joint_box.h>

#include <deal.II/base/mpi.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "moving_body.h"

using namespace Riedel;

/*
 * Splitting and merging of the points of the stressed block of
 * tests/points/rotation_sand.prm: 4 x 4 cells of 5 mm.
 */
namespace
{
  using Row = std::vector<double>;



  Scene::Scene<2>
  read_without_merging(const unsigned int per_axis)
  {
    auto scene = MovingBody::read("points/rotation_sand.prm",
                                  {"Material points/Per axis=" +
                                   std::to_string(per_axis)});
    scene.moving_points.merge_above = 0;
    return scene;
  }



  struct Block : MovingBody
  {
    /// @p seeded points per axis of a cell, where @p wanted are at the start of
    /// a run.
    Block(const unsigned int seeded, const unsigned int wanted)
      : MovingBody(MPI_COMM_WORLD, read_without_merging(seeded))
      , moving(scene.moving_points)
    {
      moving.per_axis    = wanted;
      moving.merge_above = 12;
      make_supports();
    }

    Points::MovingPointsParameters &moving;

    /// Merges, and splits what is too large.
    void
    rebuild()
    {
      supports->rebuild(zero, points);
    }

    unsigned int
    slot(const std::string &name) const
    {
      return points.layout().find(name);
    }

    /// Random values in all slots: near ones where @p spread is small.
    void
    disturb(const double spread, const bool same_density)
    {
      const auto                            &place = points.place;
      std::mt19937                           random(7);
      std::uniform_real_distribution<double> uniform(-spread, spread);
      for (unsigned int p = 0; p < points.n_points(); ++p)
        {
          double      *row  = points.row(p);
          const double half = points.half_lengths(row)[0];
          for (unsigned int d = 0; d < 2; ++d)
            row[place.displacement + d] = 1e-3 * uniform(random);
          row[place.micro_rotation] = uniform(random);
          for (unsigned int i = 0; i < 4; ++i)
            row[place.deformation_gradient + i] += uniform(random);
          const double *F = row + place.deformation_gradient;
          row[place.volume] =
            (F[0] * F[3] - F[1] * F[2]) * row[place.initial_volume];
          for (unsigned int i = 0; i < 5; ++i)
            row[slot("stress") + i] += 1e5 * uniform(random);
          for (unsigned int i = 0; i < 2; ++i)
            row[slot("couple_stress") + i] += 50.0 * uniform(random);
          if (!same_density)
            row[slot("void_ratio")] *= 1.0 + uniform(random);
          row[place.mass] =
            2650.0 * row[place.volume] / (1.0 + row[slot("void_ratio")]);
          row[slot("substep")] = random() % 1000;
          auto x               = points.position(p);
          for (unsigned int d = 0; d < 2; ++d)
            x[d] += half * uniform(random);
          points.move(p, x, space.frame());
        }
      points.relocate();
      set_order();
    }

    /// After points have been changed, without merging.
    void
    set_order()
    {
      const unsigned int above = moving.merge_above;
      moving.merge_above       = 0;
      make_supports();
      rebuild();
      moving.merge_above = above;
      make_supports();
    }

    /// What splitting and merging have to keep, over all ranks.
    std::map<std::string, Row>
    sums() const
    {
      const auto                &place = points.place;
      std::map<std::string, Row> here;
      here["volume"] = here["mass"] = here["solids"] = here["V_0"] = {0.0};
      here["volume moment"] = here["mass moment"] = {0.0, 0.0};
      here["displacement"]                        = {0.0, 0.0, 0.0};
      here["stress"]                              = Row(7, 0.0);
      for (unsigned int p = 0; p < points.n_points(); ++p)
        {
          const double *row = points.row(p);
          const double  V = row[place.volume], m = row[place.mass];
          here["volume"][0] += V;
          here["mass"][0] += m;
          here["solids"][0] += V / (1.0 + row[slot("void_ratio")]);
          here["V_0"][0] += row[place.initial_volume];
          for (unsigned int d = 0; d < 2; ++d)
            {
              // about a place outside, so that no moment is nearly zero
              const double x = points.position(p)[d] + 0.1;
              here["volume moment"][d] += V * x;
              here["mass moment"][d] += m * x;
              here["displacement"][d] +=
                V * (row[place.displacement + d] + 1.0);
            }
          here["displacement"][2] += V * (row[place.micro_rotation] + 1.0);
          for (unsigned int i = 0; i < 7; ++i)
            here["stress"][i] +=
              V * (i < 5 ? row[slot("stress") + i] + 1e6 :
                           row[slot("couple_stress") + i - 5] + 1e3);
        }
      for (auto &[name, values] : here)
        {
          Row all(values.size());
          dealii::Utilities::MPI::sum(values, MPI_COMM_WORLD, all);
          values = all;
        }
      return here;
    }

    unsigned int
    n_points() const
    {
      return dealii::Utilities::MPI::sum(points.n_points(), MPI_COMM_WORLD);
    }

    /// Smallest and largest half edge, and the largest difference of det F and
    /// V/V_0.
    struct Extremes
    {
      double smallest = 1e300, largest = 0.0, determinant = 0.0;
    };

    Extremes
    extremes() const
    {
      Extremes result;
      for (unsigned int p = 0; p < points.n_points(); ++p)
        {
          const double *row = points.row(p);
          const double *F   = row + points.place.deformation_gradient;
          const auto    l   = points.half_lengths(row);
          for (unsigned int d = 0; d < 2; ++d)
            {
              result.smallest = std::min(result.smallest, l[d]);
              result.largest  = std::max(result.largest, l[d]);
            }
          result.determinant =
            std::max(result.determinant,
                     std::abs(F[0] * F[3] - F[1] * F[2] -
                              row[points.place.volume] /
                                row[points.place.initial_volume]));
        }
      namespace Mpi      = dealii::Utilities::MPI;
      result.smallest    = Mpi::min(result.smallest, MPI_COMM_WORLD);
      result.largest     = Mpi::max(result.largest, MPI_COMM_WORLD);
      result.determinant = Mpi::max(result.determinant, MPI_COMM_WORLD);
      return result;
    }
  };



  void
  check_same(const std::map<std::string, Row> &before,
             const std::map<std::string, Row> &after,
             const std::vector<std::string>   &except = {})
  {
    for (const auto &[name, values] : before)
      if (std::find(except.begin(), except.end(), name) == except.end())
        for (unsigned int i = 0; i < values.size(); ++i)
          {
            CAPTURE(name, i);
            CHECK(after.at(name)[i] == Approx(values[i]).epsilon(1e-12));
          }
  }



  void
  check_drift(const Points::MaterialPoints<2>  &points,
              const std::map<std::string, Row> &sums)
  {
    INFO("drift " << points.drift().volume / sums.at("volume")[0] << " "
                  << points.drift().solids / sums.at("solids")[0] << " "
                  << points.drift().mass / sums.at("mass")[0]);
    CHECK(std::abs(points.drift().volume) < 1e-13 * sums.at("volume")[0]);
    CHECK(std::abs(points.drift().solids) < 1e-13 * sums.at("solids")[0]);
    CHECK(std::abs(points.drift().mass) < 1e-13 * sums.at("mass")[0]);
  }
} // namespace



TEST_CASE("Merging keeps volume, mass, solid volume and first moments",
          "[points][ranks]")
{
  const bool same_density = GENERATE(true, false);
  Block      block(4, 2);
  REQUIRE(block.n_points() == 256);
  block.disturb(0.01, same_density);
  const auto before = block.sums();
  block.rebuild();
  CHECK(block.n_points() == 64);
  CHECK(block.points.n_merged() == 192);
  CHECK(block.points.n_split() == 0);
  // the centre of mass can stay besides that of the volume only if the
  // densities are the same
  check_same(before,
             block.sums(),
             same_density ? std::vector<std::string>() :
                            std::vector<std::string>{"mass moment"});
  check_drift(block.points, before);
  for (unsigned int d = 0; d < 2; ++d)
    CHECK(block.sums()["mass moment"][d] ==
          Approx(before.at("mass moment")[d]).epsilon(1e-5));

  const auto extremes = block.extremes();
  CHECK(extremes.determinant < 1e-13);
  CHECK(extremes.smallest > 0.99 * 1.25e-3);
  CHECK(extremes.largest < 1.05 * 1.25e-3);

  // what is merged stays so, and is not split
  block.rebuild();
  CHECK(block.n_points() == 64);
  CHECK(block.points.n_split() == 0);
}



TEST_CASE("Undisturbed siblings merge to the points that they came from",
          "[points]")
{
  Block block(4, 2), coarse(2, 2);
  block.rebuild();
  REQUIRE(block.points.n_points() == coarse.points.n_points());
  const auto places = [](const Block &b) {
    std::vector<std::array<double, 4>> result;
    for (unsigned int p = 0; p < b.points.n_points(); ++p)
      {
        const auto x = b.points.position(p);
        const auto l = b.points.half_lengths(b.points.row(p));
        result.push_back({{1e-9 * std::round(1e9 * x[0]),
                           1e-9 * std::round(1e9 * x[1]),
                           1e-9 * std::round(1e9 * l[0]),
                           1e-9 * std::round(1e9 * l[1])}});
      }
    std::sort(result.begin(), result.end());
    return result;
  };
  const auto ours = places(block), expected = places(coarse);
  for (unsigned int p = 0; p < ours.size(); ++p)
    for (unsigned int i = 0; i < 4; ++i)
      REQUIRE(ours[p][i] == Approx(expected[p][i]).margin(2e-9));
}



TEST_CASE("A merged point has the history of the larger one", "[points]")
{
  Block          block(4, 2);
  const unsigned substep = block.slot("substep"), s = block.slot("stress");
  for (unsigned int p = 0; p < block.points.n_points(); ++p)
    {
      double    *row   = block.points.row(p);
      const bool large = block.points.position(p)[0] > 0.0;
      row[substep]     = large ? 2.0 : 1.0;
      row[s]           = large ? -41e3 : -40e3;
    }
  // two neighbours, by hand
  const auto                                   cell = block.points.cell(0);
  std::vector<Points::MaterialPoints<2>::Pair> pairs(1);
  unsigned int                                 n = 0;
  for (const auto &c : block.body.triangulation().active_cell_iterators())
    if (c->active_cell_index() == cell)
      {
        const auto here = block.points.particles().particles_in_cell(c);
        for (auto particle = here.begin(); particle != here.end(); ++particle)
          {
            auto row = particle->get_properties();
            if (n == 0)
              pairs[0].first = particle;
            if (n == 1)
              {
                pairs[0].other = particle;
                row[substep]   = 7.0;
                row[block.points.place.volume] *= 1.03;
                row[block.points.place.initial_volume] *= 1.03;
              }
            ++n;
          }
      }
  const auto id = pairs[0].first->get_id();
  block.points.merge(pairs, block.space.frame());
  block.set_order();
  for (unsigned int p = 0; p < block.points.n_points(); ++p)
    if (block.points.id(p) == id)
      CHECK(block.points.row(p)[substep] == 7.0);
}



TEST_CASE("Points in different states are not merged", "[points]")
{
  const std::string name   = GENERATE("stress", "couple_stress", "void_ratio");
  const bool        is_far = GENERATE(true, false);
  Block             block(4, 2);
  const auto       &law = *block.scene.materials.materials[0].law;
  const double      scale =
    name == "void_ratio" ? 0.6 :
         name == "stress"     ? std::sqrt(1.0 + 2.0 * 0.16) * 1e5 :
                                std::sqrt(1.0 + 2.0 * 0.16) * 1e5 * law.length();
  for (unsigned int p = 0; p < block.points.n_points(); ++p)
    {
      const auto x = block.points.position(p);
      const auto i = std::lround(std::floor(x[0] / 1.25e-3)),
                 j = std::lround(std::floor(x[1] / 1.25e-3));
      if ((i + j) % 2 != 0)
        block.points.row(p)[block.slot(name)] += (is_far ? 0.06 : 0.04) * scale;
    }
  block.rebuild();
  CAPTURE(name, is_far);
  CHECK(block.points.n_points() == (is_far ? 256 : 64));
}



TEST_CASE("Points are merged in cells with too many of them only", "[points]")
{
  const unsigned int above = GENERATE(0u, 15u, 16u);
  Block              block(4, 2);
  block.moving.merge_above = above;
  block.make_supports();
  block.rebuild();
  CHECK(block.points.n_points() == (above == 15 ? 64 : 256));

  // not below the number of a cell at the start, however many there are
  Block fine(4, 4);
  fine.rebuild();
  CHECK(fine.points.n_points() == 256);
}



TEST_CASE("Splitting keeps volume, mass, solid volume and first moments",
          "[points][ranks]")
{
  Block block(2, 2);
  block.disturb(0.05, false);
  const auto                                      before = block.sums();
  std::map<dealii::types::particle_index, Row>    rows;
  std::vector<Points::MaterialPoints<2>::Halving> halvings;
  unsigned int                                    n = 0;
  for (const auto &cell : block.body.triangulation().active_cell_iterators())
    if (cell->is_locally_owned())
      {
        const auto here = block.points.particles().particles_in_cell(cell);
        for (auto particle = here.begin(); particle != here.end(); ++particle)
          {
            const auto row           = particle->get_properties();
            rows[particle->get_id()] = Row(row.begin(), row.end());
            halvings.push_back({particle, n++ % 2});
          }
      }
  block.points.split(halvings, block.space.frame());
  block.points.relocate();
  block.set_order();
  CHECK(block.n_points() == 128);
  CHECK(block.points.n_split() == 64);
  check_same(before, block.sums());
  check_drift(block.points, before);

  // both halves have the state of the whole to the last bit, but for the
  // displacement: they have been side by side before the first step
  const auto       &place = block.points.place;
  std::vector<bool> may_differ(block.points.layout().size(), false);
  for (const unsigned int i : {place.initial_volume,
                               place.volume,
                               place.mass,
                               place.half_length,
                               place.half_length + 1,
                               place.displacement,
                               place.displacement + 1})
    may_differ[i] = true;
  std::vector<Row> all_rows;
  for (const auto &one :
       dealii::Utilities::MPI::all_gather(MPI_COMM_WORLD, rows))
    for (const auto &[id, row] : one)
      all_rows.push_back(row);
  for (unsigned int p = 0; p < block.points.n_points(); ++p)
    {
      const double *row = block.points.row(p);
      const bool    is_copy =
        std::any_of(all_rows.begin(), all_rows.end(), [&](const Row &whole) {
          for (unsigned int i = 0; i < whole.size(); ++i)
            if (!may_differ[i] && row[i] != whole[i])
              return false;
          return row[place.volume] == 0.5 * whole[place.volume];
        });
      REQUIRE(is_copy);
    }
}



TEST_CASE("A joint box covers both boxes, and only neighbours have one",
          "[points]")
{
  using Box    = Points::PointBox<2>;
  const Box  a = {dealii::Point<2>(1.0, 2.0), dealii::Tensor<1, 2>({1.0, 0.5})};
  const auto moved = [&](const double x, const double y, const double l_x) {
    return Box{dealii::Point<2>(1.0 + x, 2.0 + y),
               dealii::Tensor<1, 2>({l_x, 0.5})};
  };
  for (const auto &b : {moved(2.0, 0.0, 1.0),
                        moved(2.1, 0.05, 1.0),
                        moved(-1.9, -0.05, 1.0),
                        moved(1.5, 0.0, 0.5),
                        moved(0.1, 1.0, 1.05)})
    {
      const double share =
        a.half_lengths[0] / (a.half_lengths[0] + b.half_lengths[0]);
      const auto box = Points::joint_box(a, b, share);
      REQUIRE(box);
      for (unsigned int d = 0; d < 2; ++d)
        {
          CHECK(box->centre[d] ==
                Approx(share * a.centre[d] + (1.0 - share) * b.centre[d]));
          for (const auto &one : {a, b})
            {
              CHECK(box->centre[d] - box->half_lengths[d] <=
                    one.centre[d] - one.half_lengths[d] + 1e-15);
              CHECK(box->centre[d] + box->half_lengths[d] >=
                    one.centre[d] + one.half_lengths[d] - 1e-15);
            }
        }
      // and little else
      CHECK(box->half_lengths[0] * box->half_lengths[1] <
            1.25 * 0.5 * (a.half_lengths[0] + b.half_lengths[0]));
    }
  for (const auto &b : {moved(2.3, 0.0, 1.0),
                        moved(1.7, 0.0, 1.0),
                        moved(2.0, 0.15, 1.0),
                        moved(0.0, 0.0, 1.0),
                        moved(2.0, 1.0, 1.0),
                        moved(0.0, 1.0, 1.2)})
    CHECK_FALSE(Points::joint_box(a, b, 0.5));
}
