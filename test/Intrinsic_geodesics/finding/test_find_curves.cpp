// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "planar_bezier.h"
#include "refusals.h"
#include "soups.h"

#include <CGAL/Intrinsic_geodesics/finding/Repeated_curve_finder.h>
#include <CGAL/Intrinsic_geodesics/finding/find_curves.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <vector>

// Curves through places of a user. Oracles: straight lines in a square, and in two pages of a book
// laid flat.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Gluing_map;
using Exact =
    IT::Intrinsic_triangulation<Gluing_map, IT::Exact_euclidean_traits, IT::Integer_coordinates>;
using Double =
    IT::Intrinsic_triangulation<Gluing_map, IT::Euclidean_traits<double>, IT::Integer_coordinates>;

template <class T>
class FindCurves : public ::testing::Test {};
using Triangulations = ::testing::Types<Exact, Double>;
TYPED_TEST_SUITE(FindCurves, Triangulations);

/// A place, and where it is.
struct Placed {
  IT::Place place;
  std::array<double, 3> point;
};

template <class Random>
Placed random_place(const meshes::Mesh& m, Random& random) {
  if (random() % 2 == 0) {
    const auto v = static_cast<std::uint32_t>(random() % m.points.size());
    return {IT::Place::at_vertex(v), m.points[v]};
  }
  const auto f = static_cast<std::uint32_t>(random() % m.triangles.size());
  const double a = 0.1 + 0.3 * (static_cast<double>(random()) / 0x1p32), b = 0.2;
  const std::array<double, 3> weights{a, b, 1 - a - b};
  std::array<double, 3> point{};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 3; ++i) point[i] += weights[k] * m.points[m.triangles[f][k]][i];
  return {IT::Place::in_face(f, weights), point};
}

// A path or loop, and its length and that before.
template <class Random>
IT::Wanted_curve random_curve(const meshes::Mesh& m, Random& random, double& length,
                              double& initial) {
  IT::Wanted_curve curve{{}, random() % 3 == 0, random() % 2 == 0};
  std::vector<Placed> placed;
  for (std::size_t i = 0, n = (curve.is_loop ? 3 : 2) + random() % 3; i < n; ++i) {
    placed.push_back(random_place(m, random));
    for (std::size_t k = 0; k < i; ++k) // each once
      if (planar_bezier::distance(placed[k].point, placed.back().point) < 1e-6) {
        placed.pop_back();
        --i;
        break;
      }
  }
  for (const Placed& p : placed) curve.places.push_back(p.place);
  initial = 0;
  for (std::size_t i = 0; i + (curve.is_loop ? 0 : 1) < placed.size(); ++i)
    initial += planar_bezier::distance(placed[i].point, placed[(i + 1) % placed.size()].point);
  length = curve.stays_at_places ? initial
           : curve.is_loop       ? 0
                           : planar_bezier::distance(placed.front().point, placed.back().point);
  return curve;
}

TYPED_TEST(FindCurves, are_straight_in_a_square_and_loops_contract) {
  std::size_t contracted = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const meshes::Mesh m = planar_bezier::random_square(10 + seed, random);
    TypeParam t(m.input());
    IT::flip_to_delaunay(t);
    std::vector<IT::Wanted_curve> wanted;
    std::vector<double> lengths, initial;
    for (unsigned i = 0; i < 1 + seed % 3; ++i) {
      double length = 0, before = 0;
      wanted.push_back(random_curve(m, random, length, before));
      lengths.push_back(length);
      initial.push_back(before);
    }
    IT::Find_curves_options options;
    options.keeps_initial = true;
    const auto found = IT::find_curves(t, wanted, options);
    ASSERT_EQ(found.curves.size(), wanted.size());
    EXPECT_EQ(found.shortening.status, IT::Status::done);
    EXPECT_TRUE(found.is_certified || !TypeParam::Metric::is_exact);
    double sum = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const IT::Found_curve& c = found.curves[i];
      EXPECT_NEAR(c.way.length, lengths[i], 1e-9);
      EXPECT_NEAR(c.initial_length, initial[i], 1e-9);
      EXPECT_EQ(c.is_loop, wanted[i].is_loop);
      EXPECT_FALSE(c.initial.points.empty());
      EXPECT_EQ(c.way.points.size(), c.way.faces.size() + 1);
      if (lengths[i] == 0) ++contracted;
      EXPECT_EQ(c.way.status == IT::Status::contracted, lengths[i] == 0);
      sum += c.way.length;
    }
    EXPECT_NEAR(found.length, sum, 1e-12 * sum);
    for (const IT::Polyline& line : IT::polylines(t, found, m.points)) {
      double length = 0;
      const std::size_t n = line.points.size();
      for (std::size_t i = 0; i < line.number_of_segments(); ++i)
        length += planar_bezier::distance(line.points[i], line.points[(i + 1) % n]);
      EXPECT_NEAR(length, lengths[static_cast<std::size_t>(line.label)], 1e-9);
    }
  }
  EXPECT_GT(contracted, 5U);
}

// The labels are those of the edges along each curve, so their lengths sum to its length where no
// curves share edges.
TYPED_TEST(FindCurves, label_the_edges_along_them) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    const meshes::Mesh m = planar_bezier::random_square(20 + seed, random);
    TypeParam t(m.input());
    IT::flip_to_delaunay(t);
    const Placed a = random_place(m, random), b = random_place(m, random);
    if (planar_bezier::distance(a.point, b.point) < 1e-6) continue;
    const auto found = IT::find_curves(t, {{{a.place, b.place}}});
    double length = 0;
    for (const auto e : edges(t.mesh()))
      if (get(found.labels, e) == 1) length += t.length(e);
    EXPECT_NEAR(length, planar_bezier::distance(a.point, b.point), 1e-9);
  }
}

TYPED_TEST(FindCurves, make_trees_to_all_vertices) {
  std::mt19937 random(7);
  const meshes::Mesh m = planar_bezier::random_square(30, random);
  TypeParam t(m.input());
  IT::flip_to_delaunay(t);
  const auto found =
      IT::find_curves(t, {{{IT::Place::at_vertex(3)}, false, false, IT::Curve_kind::tree}});
  // Each has the last two edges of the way to a vertex: in a square one, if no vertex is between.
  EXPECT_EQ(found.curves.size(), m.points.size() - 1);
  EXPECT_TRUE(found.is_certified);
  std::vector<double> lengths, expected;
  for (const IT::Found_curve& c : found.curves) lengths.push_back(c.way.length);
  for (std::size_t v = 0; v < m.points.size(); ++v)
    if (v != 3) expected.push_back(planar_bezier::distance(m.points[3], m.points[v]));
  std::ranges::sort(lengths);
  std::ranges::sort(expected);
  double shorter = 0; // where a path leads through a vertex
  for (std::size_t i = 0; i < lengths.size(); ++i) shorter += expected[i] - lengths[i];
  EXPECT_NEAR(shorter, 0, 1e-9);
}

// A parabola, whose polygon after 5 rounds of bisection is longer by about 4^-5 of what that of the
// control points is.
TYPED_TEST(FindCurves, bend_as_bezier_curves) {
  std::mt19937 random(5);
  const meshes::Mesh m = planar_bezier::random_square(20, random);
  TypeParam t(m.input());
  IT::flip_to_delaunay(t);
  const std::array<std::uint32_t, 3> n{0, 5, 9};
  const auto found = IT::find_curves(
      t, {{{IT::Place::at_vertex(n[0]), IT::Place::at_vertex(n[1]), IT::Place::at_vertex(n[2])},
           false,
           false,
           IT::Curve_kind::bezier}});
  const auto speed = [&](double u) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double x = 2 * (1 - u) * (m.points[n[1]][i] - m.points[n[0]][i]) +
                       2 * u * (m.points[n[2]][i] - m.points[n[1]][i]);
      sum += x * x;
    }
    return std::sqrt(sum);
  };
  double exact = 0;
  for (int i = 0; i < 10000; ++i) exact += speed((i + 0.5) / 10000) / 10000;
  EXPECT_NEAR(found.length, exact, 1e-3 * exact);
  EXPECT_GE(found.length, exact * (1 - 1e-9));
}

TYPED_TEST(FindCurves, add_chains_of_marked_edges_first) {
  std::mt19937 random(11);
  const meshes::Mesh m = planar_bezier::random_square(20, random);
  TypeParam t(m.input());
  IT::flip_to_delaunay(t);
  const auto is_border = [](const TypeParam& on) {
    IT::Marked_edges<TypeParam> marks(on);
    for (const auto e : edges(on.mesh())) put(marks, e, CGAL::is_border(e, on.mesh()));
    return marks;
  };
  const auto found =
      IT::find_curves(t, {{{IT::Place::at_vertex(0), IT::Place::at_vertex(9)}}}, {}, is_border);
  ASSERT_EQ(found.curves.size(), 2U);
  EXPECT_TRUE(found.curves[0].is_loop);
  double border = 0;
  for (const auto e : edges(t.mesh()))
    if (CGAL::is_border(e, t.mesh())) border += t.length(e);
  // the chain is shortened as others are: at the corners of the square, into it
  EXPECT_NEAR(found.curves[0].initial_length, border, 1e-12 * border);
  EXPECT_LT(found.curves[0].way.length, border);
  EXPECT_NEAR(found.curves[1].way.length, planar_bezier::distance(m.points[0], m.points[9]), 1e-9);
}

// Whatever was found, inserted, refused or cancelled before: each call finds the curve that is
// found on a triangulation of its own.
TYPED_TEST(FindCurves, are_found_repeatedly_as_for_the_first_time) {
  for (unsigned seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const meshes::Mesh m = planar_bezier::random_square(30 + seed, random);
    TypeParam t(m.input());
    IT::flip_to_delaunay(t);
    IT::Repeated_curve_finder<TypeParam> find(t);
    for (unsigned call = 0; call < 12; ++call) {
      double length = 0, initial = 0;
      const std::vector<IT::Wanted_curve> wanted{random_curve(m, random, length, initial)};
      IT::Find_curves_options options;
      options.is_along_edges = call % 3 == 1; // then a curve may have to go around its own ends
      unsigned steps = 0;
      if (call % 6 == 2) options.progress = [&](auto, std::uint64_t) { return ++steps < 3; };
      IT::Found_curves found, alone;
      const std::string refused = refusals::refusal([&] { found = find(wanted, options); });
      steps = 0;
      TypeParam copy = t;
      EXPECT_EQ(refused,
                refusals::refusal([&] { alone = IT::find_curves(copy, wanted, options); }));
      ASSERT_EQ(found.curves.size(), alone.curves.size());
      EXPECT_EQ(found.shortening.flips, alone.shortening.flips);
      for (std::size_t i = 0; i < found.curves.size(); ++i) {
        const IT::Found_curve& c = found.curves[i];
        if (!options.is_along_edges) {
          EXPECT_NEAR(c.way.length, length, 1e-9);
        }
        // to what stored lengths promise: those that follow flips are closer
        EXPECT_NEAR(c.way.length, alone.curves[i].way.length, 0x1p-41 * c.way.length);
        EXPECT_EQ(c.way.points.size(), alone.curves[i].way.points.size());
        EXPECT_EQ(c.way.faces, alone.curves[i].way.faces);
      }
    }
  }
}

// Pages at an edge: a path from one to another is straight when both are laid flat, and is on the
// faces unless it is to be edges.
TEST(FindCurvesOnPages, are_on_faces_or_edges) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 10; ++trial) {
    IT::Triangle_soup soup;
    soup.points = {{0, 0, 0}, {0, 0, 1}};
    for (int page = 0; page < 3; ++page) {
      const double angle = 2 * std::numbers::pi * page / 3;
      soup.points.push_back({std::cos(angle), std::sin(angle), 0.5});
      soup.triangles.push_back({0, 1, static_cast<std::uint32_t>(2 + page)});
    }
    const auto i = static_cast<std::uint32_t>(random() % 3), j = (i + 1) % 3;
    for (const bool are_edges : {false, true}) {
      Exact t(IT::make_domain(soup).input);
      IT::flip_to_delaunay(t);
      IT::Find_curves_options options;
      options.are_edges = are_edges;
      const auto found = IT::find_curves(
          t, {{{IT::Place::at_vertex(2 + i), IT::Place::at_vertex(2 + j)}}}, options);
      ASSERT_EQ(found.curves.size(), 1U);
      EXPECT_NEAR(found.length, 2, 1e-12);
      EXPECT_EQ(found.curves[0].is_on_faces, !are_edges);
      EXPECT_TRUE(found.is_certified) << found.obstacle;
    }
  }
}

TYPED_TEST(FindCurves, name_what_cannot_be_found) {
  std::mt19937 random(2);
  const meshes::Mesh m = planar_bezier::random_square(20, random);
  const auto find = [&](std::vector<IT::Wanted_curve> wanted, bool is_along_edges = false) {
    TypeParam t(m.input());
    IT::flip_to_delaunay(t);
    IT::Find_curves_options options;
    options.is_along_edges = is_along_edges;
    return refusals::refusal([&] { IT::find_curves(t, wanted, options); });
  };
  const auto at = [](std::uint32_t v) { return IT::Place::at_vertex(v); };
  EXPECT_EQ(
      find({{{at(3), at(3)}, false, false, IT::Curve_kind::geodesic, "line 7"}}),
      "line 7: vertex 3 is both ends of a curve; give another end, or points between, through "
      "which it leads");
  EXPECT_EQ(find({{{at(1), at(3), at(3)}, false, false, IT::Curve_kind::geodesic, "line 8"}}),
            "line 8: vertex 3 follows itself on a curve; give it once");
  const auto n = static_cast<std::uint32_t>(m.points.size());
  EXPECT_NE(find({{{at(3), at(n)}}}), "");
  // paths along the diagonals of the square cross
  EXPECT_NE(find({{{at(0), at(2)}}, {{at(1), at(3)}}}, true).find("crosses another or itself"),
            std::string::npos);
}

TYPED_TEST(FindCurves, end_when_they_are_told_to) {
  std::mt19937 random(4);
  const meshes::Mesh m = planar_bezier::random_square(40, random);
  for (const IT::Curve_stage last :
       {IT::Curve_stage::paths, IT::Curve_stage::shortening, IT::Curve_stage::certificate}) {
    TypeParam t(m.input());
    IT::flip_to_delaunay(t);
    IT::Find_curves_options options;
    options.progress = [&](IT::Curve_stage stage, std::uint64_t) { return stage != last; };
    const auto found =
        IT::find_curves(t, {{{IT::Place::at_vertex(0), IT::Place::at_vertex(9)}}}, options);
    EXPECT_EQ(found.shortening.status, IT::Status::cancelled);
    EXPECT_TRUE(found.curves.empty());
  }
}

} // namespace
