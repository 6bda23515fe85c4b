// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/measure_quality.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Flip_log.h>

#include "meshes.h"
#include "properties.h"

#include <CGAL/Gmpq.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

// What exact traits hand out is as good as their signs: on surfaces on which doubles that are carried along lose everything.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Exact = IT::Intrinsic_triangulation<>;
using Counted = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                            IT::Integer_coordinates>;
using CGAL::Gmpq;

// a sphere, stretched along an axis that is none of the coordinates
meshes::Mesh stretched(double factor) {
  meshes::Mesh m = meshes::sphere(3);
  const double c = 0.6, s = 0.8;
  for (auto& [x, y, z] : m.points) {
    const double along = factor * (c * x + s * y), across = c * y - s * x;
    x = c * along - s * across, y = s * along + c * across;
  }
  return m;
}

TEST(Exact_values, areas_sum_to_that_of_the_input_on_stretched_spheres) {
  for (const double factor : {1e3, 1e9, 1e15}) {
    Exact t(stretched(factor).input());
    const double before = properties::total_area(t);
    const auto r = IT::flip_to_delaunay(t);
    EXPECT_GT(r.flips, 100U);
    // each of 512 faces to 1e-12, and so their sum
    EXPECT_NEAR(properties::total_area(t) / before, 1, 1e-12);
    EXPECT_EQ(t.metric().statistics().probable_zero, 0U);
  }
}

TEST(Exact_values, areas_sum_to_that_of_the_input_where_one_vertex_is_far_away) {
  meshes::Mesh m = meshes::sphere(2);
  for (double& x : m.points[9]) x *= 1e100;
  for (const bool again : {false, true}) {
    Counted t(m.input());
    const double before = properties::total_area(t);
    if (again) IT::flip_to_delaunay(t);
    EXPECT_NEAR(properties::total_area(t) / before, 1, 1e-12);
    const IT::Quality q = IT::measure_quality(t);
    EXPECT_GE(q.minimum_angle, 0);
  }
}

// Faces of a pyramid over a regular polygon are isosceles: the cotangent at the base is half the base by the height.
TEST(Exact_values, weights_to_the_apex_of_a_steep_pyramid_are_right) {
  const std::uint32_t n = 200;
  const double height = 1e6;
  meshes::Mesh m;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    m.points.push_back({std::cos(angle), std::sin(angle), 0});
    m.triangles.push_back({i, (i + 1) % n, n});
    m.triangles.push_back({(i + 1) % n, i, n + 1});
  }
  m.points.push_back({0, 0, height});
  m.points.push_back({0, 0, -height});
  const Exact t(m.input());
  const auto L = IT::cotangent_laplacian(t);
  const double half = std::sin(std::numbers::pi / n), r = std::cos(std::numbers::pi / n);
  for (std::uint32_t i = 0; i < n; ++i)
    for (const std::uint32_t apex : {n, n + 1})
      // points are off the circle by 2^-53, which the base of length 0.03 sees 1e15 times as large as the weight
      EXPECT_NEAR(L.coeff(i, apex) * -std::hypot(height, r) / half, 1, 1e-11);
}

TEST(Exact_values, weights_are_zero_or_have_the_right_sign_and_repeat) {
  Exact t(stretched(1e9).input());
  IT::flip_to_delaunay(t);
  const auto first = IT::cotangent_laplacian(t), second = IT::cotangent_laplacian(t);
  for (int k = 0; k < first.outerSize(); ++k)
    for (decltype(IT::cotangent_laplacian(t))::InnerIterator i(first, k); i; ++i) {
      EXPECT_TRUE(i.row() == i.col() || i.value() <= 0);
      EXPECT_NEAR(second.coeff(i.row(), i.col()), i.value(), 1e-12 * std::abs(i.value()));
    }
}

// where a vertex is in the plane, by the points and places of inserted vertices alone
template <class T>
std::array<Gmpq, 2> point(const T& t, std::uint32_t v) {
  const auto& points = t.input().metric().points();
  if (v < points.size()) return {points[v][0], points[v][1]};
  const IT::Integer_coordinates& places = *t.places();
  const IT::Surface_point& place = places.location(v);
  const auto weights = IT::representable_weights(place.weights).value_or(place.weights);
  const std::uint32_t h = place.halfedge, next = places.input().next(h);
  const std::array<std::uint32_t, 3> corners{places.input().source(h), places.input().source(next),
                                             places.input().target(next)};
  std::array<Gmpq, 2> sum{0, 0};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 2; ++i) sum[i] += Gmpq(weights[k]) * Gmpq(points[corners[k]][i]);
  return sum;
}

struct Checked {
  std::size_t narrow = 0, wide = 0;
  void operator()(const CGAL::Interval_nt<false>& interval, double value, const Gmpq& exact) {
    EXPECT_TRUE(Gmpq(interval.inf()) <= exact && exact <= Gmpq(interval.sup()));
    EXPECT_LE(CGAL::abs(Gmpq(value) - exact), Gmpq(1e-12) * exact);
    ++(interval.sup() - interval.inf() <= 0x1p-41 * interval.sup() ? narrow : wide);
  }
};

// Asks for all values in scaled units, of a triangulation in the plane.
template <class T>
void check_all(const T& t, Checked& checked) {
  const auto scaled = [&](double x) { return std::ldexp(x, 2 * t.metric().scale_exponent()); };
  const auto& mesh = t.mesh();
  const auto corner = [&](auto h) { return point(t, t.index(target(h, mesh))); };
  for (const auto e : edges(mesh)) {
    const auto p = corner(halfedge(e, mesh)), q = corner(opposite(halfedge(e, mesh), mesh));
    const Gmpq x = p[0] - q[0], y = p[1] - q[1];
    const double value = scaled(t.squared_length(e));
    checked(t.metric().squared_length(t.index(e)), value, x * x + y * y);
  }
  for (const auto f : faces(mesh)) {
    const auto h = halfedge(f, mesh);
    const auto p = corner(h), q = corner(next(h, mesh)), r = corner(next(next(h, mesh), mesh));
    const Gmpq twice = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    const double value = scaled(4 * t.area(f));
    checked(t.metric().quadruple_area(t.index(f)), value, 2 * twice);
  }
}

// Edges that were flipped more than once on average have values in 106 bits that follow flips:
// stored intervals stay narrow, and no query has anything to do.
template <class T>
void check_many_flips() {
  std::mt19937 random(20261129);
  std::uniform_real_distribution<double> shift(-1e-3, 1e-3);
  meshes::Mesh m = meshes::sheared_grid(12, 12, 13);
  for (auto& p : m.points) p = {p[0] + shift(random), p[1] + shift(random), 0};
  T t(m.input());
  EXPECT_GT(IT::flip_to_delaunay(t).flips, 2 * num_edges(t.mesh()));
  Checked checked;
  check_all(t, checked);
  IT::cotangent_laplacian(t);
  EXPECT_TRUE(t.metric().statistics().sharpenings.empty());
  { // flips that are taken back end it
    typename T::Session session(t);
    IT::Flip_log<T> log;
    for (std::uint32_t h = 0; h < t.mesh().number_of_halfedges(); h += 6)
      log.flip_edge(session, typename T::halfedge_descriptor{h});
    EXPECT_GT(log.size(), 30U);
    log.undo(session);
  }
  check_all(t, checked);
  for (int i = 0; i < 3000; ++i)
    t.flip_edge(typename T::halfedge_descriptor{
        static_cast<std::uint32_t>(random() % t.mesh().number_of_halfedges())});
  check_all(t, checked);
  if constexpr (T::has_correspondence) { // which has the place
    t.insert_vertex(halfedge(*faces(t.mesh()).begin(), t.mesh()), {0.25, 0.3, 0.45});
    check_all(t, checked);
  }
  EXPECT_EQ(checked.wide, 0U);
}

TEST(Exact_values, stay_narrow_where_edges_flip_many_times) {
  check_many_flips<Exact>();
  check_many_flips<Counted>();
}

// Values in 106 bits leave weights open in a strip that is 1e8 times as long as wide: queries find
// those in other ways, and values go on following.
TEST(Exact_values, stored_ones_do_not_depend_on_queries) {
  for (const double noise : {0., 1e-12, 1e-6}) {
    meshes::Mesh m = meshes::sheared_grid(12, 12, 13);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> shift(-noise, noise);
    for (auto& p : m.points) {
      const double x = 1e-8 * (p[0] + shift(random));
      p = {x, x, p[1] + shift(random)};
    }
    Exact t(m.input()), queried(m.input());
    IT::flip_to_delaunay(t);
    IT::flip_to_delaunay(queried);
    IT::cotangent_laplacian(queried);
    for (int i = 0; i < 300; ++i) {
      const Exact::halfedge_descriptor h{
          static_cast<std::uint32_t>(random() % t.mesh().number_of_halfedges())};
      EXPECT_EQ(t.flip_edge(h), queried.flip_edge(h));
    }
    for (const auto e : edges(t.mesh())) {
      const auto& x = t.metric().squared_length(t.index(e));
      const auto& y = queried.metric().squared_length(t.index(e));
      EXPECT_EQ(x.inf(), y.inf());
      EXPECT_EQ(x.sup(), y.sup());
    }
  }
}

template <class T>
void check_random_moves(std::size_t insertions) {
  std::mt19937 random(20261124);
  std::uniform_real_distribution<double> shift(-1e-3, 1e-3);
  std::size_t flips = 0, inserted = 0, passes = 0;
  Checked checked;
  for (int round = 0; round < 6; ++round) {
    meshes::Mesh m = meshes::sheared_grid(10, 10, 7);
    if (round > 0)
      for (auto& p : m.points) p = {p[0] + shift(random), p[1] + shift(random), 0};
    T t(m.input());
    for (int part = 0; part < 4; ++part) {
      const auto any = [&] {
        return typename T::halfedge_descriptor{
            static_cast<std::uint32_t>(random() % t.mesh().number_of_halfedges())};
      };
      for (int i = 0; i < 400; ++i) flips += t.flip_edge(any()) == IT::Move_status::done ? 1U : 0U;
      for (std::size_t i = 0; i < insertions; ++i)
        if (const auto h = any(); !CGAL::is_border(h, t.mesh()))
          inserted += t.insert_vertex(h, {0.25, 0.3, 0.45}).status == IT::Move_status::done;
      if (part == 1) flips += IT::flip_to_delaunay(t).flips;
      check_all(t, checked);
    }
    passes += t.metric().statistics().sharpenings.count(106); // before flips are so many
  }
  EXPECT_GT(passes, 0U);
  EXPECT_GT(flips, 3000U);
  EXPECT_EQ(inserted > 0, insertions > 0);
  EXPECT_GT(checked.narrow, 10000U);
  EXPECT_EQ(checked.wide, 0U);
}

TEST(Exact_values, enclosures_hold_rational_values_after_thousands_of_flips) {
  check_random_moves<Exact>(0);
  check_random_moves<Counted>(0);
}

TEST(Exact_values, enclosures_hold_rational_values_after_thousands_of_flips_and_insertions) {
  check_random_moves<Counted>(20);
  check_random_moves<
      IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, IT::Signposts>>(20);
}

} // namespace
