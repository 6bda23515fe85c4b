// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "planar_bezier.h"

#include <CGAL/Intrinsic_geodesics/bezier/make_bezier_curve.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_curve.h>
#include <CGAL/Intrinsic_geodesics/shortening/certify_geodesic.h>
#include <CGAL/Intrinsic_geodesics/shortening/is_geodesic.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

using Exact = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                          IT::Integer_coordinates>;
using Curve = IT::Bezier_curve<Exact>;
using meshes::Point;
using planar_bezier::distance;
using planar_bezier::planar;
using planar_bezier::vertex_at;

// Lengths up to 20 have relative errors of 1e-12, and so have midpoints.
constexpr double midpoint_error = 2e-11;

template <class T>
IT::Bezier_curve<T> curve_of(T& t, const std::vector<std::uint32_t>& control, unsigned rounds) {
  std::vector<typename T::vertex_descriptor> v;
  for (const std::uint32_t i : control) v.push_back(IT::vertex_of_row(t, i));
  return IT::make_bezier_curve(t, v, IT::parameters::maximum_rounds(rounds));
}

// the places of the control points, in order
std::vector<Point> places(const Exact& t, const meshes::Mesh& m, const Curve& c) {
  std::vector<Point> result;
  std::size_t next = 0;
  const auto reach = [&](Exact::vertex_descriptor v, const Point& p) {
    for (; next < c.control_points.size() && c.control_points[next] == v; ++next)
      result.push_back(p);
  };
  for (const auto h : c.halfedges) {
    const IT::Traced_curve edge = IT::trace_curve(t, std::vector{h});
    reach(source(h, t.mesh()), IT::point_in_space(t, edge.points.front(), m.points));
    reach(target(h, t.mesh()), IT::point_in_space(t, edge.points.back(), m.points));
  }
  return result;
}

void expect_certified(Exact& t, const Curve& c) {
  ASSERT_EQ(c.status, IT::Status::done);
  IT::Curve_network<Exact> network(t);
  for (const auto& vertices : {c.control_points, c.crossings})
    for (const auto v : vertices) network.fix(v);
  network.add_path(c.halfedges);
  EXPECT_TRUE(IT::is_geodesic(network).is_geodesic());
  EXPECT_TRUE(IT::certify_geodesic(network).is_geodesic());
  for (const auto& j : IT::is_geodesic(network).joints) EXPECT_TRUE(j.is_fixed || j.is_straight());
}

/// Compares every control point on the curve with a curve by its parameter.
template <class Place>
void expect_curve(const Exact& t, const meshes::Mesh& m, const Curve& c, const Place& place,
                  double error) {
  const std::vector<Point> at = places(t, m, c);
  ASSERT_EQ(at.size(), c.control_points.size());
  ASSERT_EQ(at.size(), c.degree * (std::size_t{1} << c.rounds) + 1);
  for (std::size_t k = 0; k < at.size(); k += c.degree)
    EXPECT_LT(distance(at[k], place(static_cast<double>(k) / static_cast<double>(at.size() - 1))),
              error)
        << "point " << k;
}

/// So many different vertices, and their points.
std::vector<std::uint32_t> random_control(const meshes::Mesh& m, std::size_t n,
                                          std::mt19937& random, std::vector<Point>& points) {
  std::vector<std::uint32_t> control(m.points.size());
  std::iota(control.begin(), control.end(), 0U);
  std::shuffle(control.begin(), control.end(), random);
  control.resize(n);
  for (const std::uint32_t i : control) points.push_back(m.points[i]);
  return control;
}

const std::vector<std::array<double, 2>> cubic{{0, 0}, {2, 7}, {9, 8}, {10, 1}};

std::vector<std::uint32_t> numbers(const meshes::Mesh& m,
                                   const std::vector<std::array<double, 2>>& points) {
  std::vector<std::uint32_t> n;
  for (const auto& p : points) n.push_back(vertex_at(m, p[0], p[1]));
  return n;
}

} // namespace

TEST(Make_bezier_curve, is_the_planar_curve_in_a_plane) {
  const meshes::Mesh m = meshes::grid(10, 10);
  for (const auto& control : {cubic,
                              {{0, 0}, {5, 10}, {10, 0}},
                              {{0, 0}, {3, 7}},
                              {{0, 3}, {1, 10}, {6, 9}, {8, 2}, {10, 6}}}) {
    std::vector<Point> points;
    for (const auto& p : control) points.push_back({p[0], p[1], 0});
    Exact t(m.input());
    const Curve c = curve_of(t, numbers(m, control), 4);
    expect_certified(t, c);
    EXPECT_EQ(c.degree, control.size() - 1);
    expect_curve(
        t, m, c, [&](double x) { return planar(points, x); }, midpoint_error);
  }
}

// Whatever the triangulation, and whether the control polygon crosses itself: all geodesics of a
// convex part of a plane are unique.
TEST(Make_bezier_curve, is_the_planar_curve_on_every_triangulation_of_a_square) {
  std::size_t crossings = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const meshes::Mesh m = planar_bezier::random_square(10 + seed, random);
    std::vector<Point> points;
    Exact t(m.input());
    const Curve c = curve_of(t, random_control(m, 3 + seed % 4, random, points), seed % 5);
    expect_certified(t, c);
    crossings += c.crossings.size();
    // a vertex beside an edge is 2^-40 of the height of a face off it, up to 15 times one after the
    // other
    expect_curve(
        t, m, c, [&](double x) { return planar(points, x); }, 1e-10);
  }
  EXPECT_GT(crossings, 0U);
}

// Length of the control polygon of a planar curve after rounds of halving its parameter.
double length_after(const std::vector<Point>& b, unsigned rounds) {
  double length = 0;
  if (rounds == 0) {
    for (std::size_t i = 0; i + 1 < b.size(); ++i) length += distance(b[i], b[i + 1]);
    return length;
  }
  std::vector<Point> left, right;
  for (std::size_t i = 0; i < b.size(); ++i) {
    left.push_back(planar({b.begin(), b.begin() + static_cast<std::ptrdiff_t>(i) + 1}, 0.5));
    right.push_back(planar({b.begin() + static_cast<std::ptrdiff_t>(i), b.end()}, 0.5));
  }
  return length_after(left, rounds - 1) + length_after(right, rounds - 1);
}

namespace {

// Makes curves in doubles in flat squares with vertices on lattice lines, one for each seed.
void expect_planar_curves(std::initializer_list<unsigned> seeds, double tolerance) {
  using Double = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>,
                                             IT::Integer_coordinates>;
  for (const unsigned seed : seeds) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const meshes::Mesh m = planar_bezier::random_square(6 + seed % 50, random, 3 + seed % 14);
    std::vector<Point> points;
    Double t(m.input());
    const auto c = curve_of(t, random_control(m, 3 + seed % 4, random, points), seed % 6);
    ASSERT_EQ(c.status, IT::Status::done);
    EXPECT_NEAR(c.length, length_after(points, seed % 6), tolerance);
  }
}

} // namespace

// On a lattice many midpoints are vertices, up to rounding. All of these failed while the ends of
// halves were beside such vertices.
TEST(Make_bezier_curve, passes_vertices_that_are_midpoints_up_to_rounding) {
  expect_planar_curves({73U, 392U, 448U, 535U, 580U, 643U, 691U, 812U, 931U}, 1e-10);
}

// Midpoints that lie in thin faces are moved by rounding, here by up to 2^-12 of a side of the
// curve: sides end there still.
TEST(Make_bezier_curve, ends_short_sides_at_vertices_that_rounding_moved) {
  expect_planar_curves({995U, 1331U}, 1e-6);
}

// Many vertices are on one line: at a joint there, rounding makes both angles less than pi.
TEST(Make_bezier_curve, is_the_planar_curve_in_doubles_where_vertices_are_collinear) {
  using Rounded = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>,
                                              IT::Integer_coordinates>;
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const meshes::Mesh square = planar_bezier::random_square(10 + seed, random);
    std::vector<Point> points;
    const std::vector<std::uint32_t> control = random_control(square, 3 + seed % 4, random, points);
    const meshes::Mesh m = meshes::subdivided(square);
    Rounded t(m.input());
    const auto c = curve_of(t, control, seed % 6);
    ASSERT_EQ(c.status, IT::Status::done);
    // the bound of the points in the test above, for a length below 10
    EXPECT_NEAR(c.length, length_after(points, c.rounds), 1e-9);
  }
}

// de Casteljau's algorithm on great circles of the unit sphere
Point spherical(std::vector<Point> b, double t) {
  for (; b.size() > 1; b.pop_back())
    for (std::size_t i = 0; i + 1 < b.size(); ++i) {
      const double angle = 2 * std::asin(distance(b[i], b[i + 1]) / 2);
      if (angle == 0) continue;
      const double x = std::sin((1 - t) * angle) / std::sin(angle),
                   y = std::sin(t * angle) / std::sin(angle);
      for (std::size_t c = 0; c < 3; ++c) b[i][c] = x * b[i][c] + y * b[i + 1][c];
    }
  return b.front();
}

// So the curve depends continuously on its control points, as far as the mesh is round: angles at
// its vertices lack 0.02.
TEST(Make_bezier_curve, is_near_the_curve_of_great_circles_on_half_a_sphere) {
  const meshes::Mesh m = meshes::sphere(4);
  std::vector<std::uint32_t> upper;
  for (std::uint32_t i = 0; i < m.points.size(); ++i)
    if (m.points[i][2] > 0.1) upper.push_back(i);
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::shuffle(upper.begin(), upper.end(), random);
    const std::vector<std::uint32_t> control(upper.begin(), upper.begin() + 3 + seed % 3);
    std::vector<Point> points;
    for (const std::uint32_t i : control) points.push_back(m.points[i]);
    Exact t(m.input());
    const Curve c = curve_of(t, control, 3);
    expect_certified(t, c);
    expect_curve(
        t, m, c, [&](double x) { return spherical(points, x); }, 0.06);
  }
}

TEST(Make_bezier_curve, converges_with_the_square_of_the_step) {
  const meshes::Mesh m = meshes::grid(10, 10);
  std::vector<Point> points;
  for (const auto& p : cubic) points.push_back({p[0], p[1], 0});
  double length = 0;
  Point before = points.front();
  for (int i = 1; i <= 100000; ++i) {
    const Point p = planar(points, i / 100000.);
    length += distance(before, p);
    before = p;
  }
  std::vector<double> errors;
  for (const unsigned rounds : {2U, 3U, 4U, 5U}) {
    Exact t(m.input());
    errors.push_back(curve_of(t, numbers(m, cubic), rounds).length - length);
  }
  for (std::size_t i = 1; i < errors.size(); ++i) {
    EXPECT_GT(errors[i - 1] / errors[i], 3.5);
    EXPECT_LT(errors[i - 1] / errors[i], 4.5);
  }
}

TEST(Make_bezier_curve, is_certified_on_surfaces_and_shorter_in_every_round) {
  for (const meshes::Mesh& m : {meshes::potato(3, 2), meshes::rough_grid(10, 1),
                                meshes::box(3, 4, 5), meshes::integer_height_field(9, 4, 3)}) {
    const auto n = static_cast<std::uint32_t>(m.points.size());
    double before = 1e300;
    for (const unsigned rounds : {0U, 1U, 2U, 3U}) {
      Exact t(m.input());
      const Curve c = curve_of(t, {0, n / 3, n / 2, n - 1}, rounds);
      expect_certified(t, c);
      EXPECT_LT(c.length, before);
      before = c.length;
      EXPECT_EQ(c.control_points.front(), IT::vertex_of_row(t, 0));
      EXPECT_EQ(c.control_points.back(), IT::vertex_of_row(t, n - 1));
    }
  }
}

TEST(Make_bezier_curve, starts_and_ends_in_the_direction_of_its_control_polygon) {
  // the first side is halved in every round, and stays where it is
  const meshes::Mesh m = meshes::potato(3, 2);
  Exact t(m.input()), u(m.input());
  const auto n = static_cast<std::uint32_t>(m.points.size());
  const std::vector<std::uint32_t> control{0, n / 3, n / 2, n - 1};
  const Curve c = curve_of(t, control, 0), d = curve_of(u, control, 3);
  const auto first = [&](const Exact& s, const Curve& x, bool is_last) {
    const IT::Traced_curve way = IT::trace_curve(s, x.halfedges);
    const auto& p = way.points;
    const Point from = IT::point_in_space(s, is_last ? p[p.size() - 1] : p[0], m.points);
    const Point to = IT::point_in_space(s, is_last ? p[p.size() - 2] : p[1], m.points);
    const double l = distance(from, to);
    return Point{(to[0] - from[0]) / l, (to[1] - from[1]) / l, (to[2] - from[2]) / l};
  };
  for (const bool is_last : {false, true})
    EXPECT_LT(distance(first(t, c, is_last), first(u, d, is_last)), 1e-9);
}

TEST(Make_bezier_curve, is_moved_by_interior_control_points) {
  const meshes::Mesh m = meshes::grid(10, 10);
  Exact t(m.input()), u(m.input());
  const Curve c = curve_of(t, numbers(m, cubic), 3);
  const Curve d = curve_of(u, numbers(m, {cubic[0], {2, 3}, cubic[2], cubic[3]}), 3);
  const Point a = places(t, m, c)[12], b = places(u, m, d)[12];
  EXPECT_NEAR(distance(a, b), 4 * 3 / 8., midpoint_error);
}

TEST(Make_bezier_curve, does_not_depend_on_the_triangulation_of_the_input) {
  const meshes::Mesh m = meshes::potato(2, 2), fine = meshes::subdivided(m);
  Exact t(m.input()), u(fine.input());
  const auto n = static_cast<std::uint32_t>(m.points.size());
  const std::vector<std::uint32_t> control{0, n / 3, n / 2, n - 1};
  const Curve c = curve_of(t, control, 2), d = curve_of(u, control, 2);
  const std::vector<Point> a = places(t, m, c), b = places(u, fine, d);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_LT(distance(a[i], b[i]), 1e-9) << i;
}

TEST(Make_bezier_curve, does_not_jump_across_a_bump) {
  // a spike between the lines of control points on both sides: one step in space follows each step along the curve
  meshes::Mesh m = meshes::grid(10, 10);
  m.points[vertex_at(m, 5, 5)][2] = 12;
  Exact t(m.input());
  const Curve c = curve_of(t, numbers(m, {{0, 5}, {4, 8}, {6, 2}, {10, 5}}), 5);
  expect_certified(t, c);
  const std::vector<Point> at = places(t, m, c);
  const double step = c.length / static_cast<double>(at.size() - 1);
  for (std::size_t i = 1; i < at.size(); ++i) EXPECT_LT(distance(at[i - 1], at[i]), 4 * step);
}

TEST(Make_bezier_curve, stops_at_a_tolerance_and_takes_coinciding_control_points) {
  const meshes::Mesh m = meshes::grid(10, 10);
  Exact t(m.input());
  std::vector<Exact::vertex_descriptor> v;
  for (const std::uint32_t i : numbers(m, cubic)) v.push_back(IT::vertex_of_row(t, i));
  const Curve c = IT::make_bezier_curve(t, v, IT::parameters::tolerance(0.1).maximum_rounds(20U));
  EXPECT_EQ(c.status, IT::Status::done);
  EXPECT_LT(c.rounds, 6U);
  Exact u(m.input());
  const Curve d = curve_of(u, numbers(m, {{0, 0}, {5, 5}, {5, 5}, {9, 1}}), 3);
  expect_certified(u, d);
  const std::vector<Point> at = places(u, m, d);
  EXPECT_LT(distance(at[12], planar({{0, 0, 0}, {5, 5, 0}, {5, 5, 0}, {9, 1, 0}}, 0.5)),
            midpoint_error);
  EXPECT_THROW(curve_of(u, {0}, 3), std::invalid_argument);
}
