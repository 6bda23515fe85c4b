// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/correspondence/curves/Unfolded_face.h>

#include "gallery.h"
#include "meshes.h"
#include "places.h"
#include "subdivision_oracle.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Crossing_run.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Triangle_strips.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>
#include <CGAL/Intrinsic_triangulations/exact/Input_face_intervals.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <random>
#include <utility>
#include <vector>

// Where points of faces are on the input: in the plane by rational numbers, elsewhere by signposts, which find the
// way over the input by angles.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using CGAL::Gmpq;
using places::Position;
using subdivision_oracle::Mover;
using subdivision_oracle::Plane;
using Interval = CGAL::Interval_nt<false>;
using Weights = std::array<double, 3>;

template <class Correspondence>
using Exact =
    IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, Correspondence>;

/// Faces unfolded in intervals, whose rounding mode must be set.
template <class T>
class Unfolder {
public:
  explicit Unfolder(const T& t) : t_(t), view_(t), values_(faces_.of(t.input().metric())) {}

  using Face = IT::Unfolded_face<Interval>;

  const Face& operator()(std::uint32_t h) {
    const IT::Input& input = t_.correspondence().input();
    face_.unfold(view_, t_.correspondence(), h, [&](std::uint32_t x) {
      const IT::Face_side s = IT::input_side(input, x);
      const auto& [l, area] = values_(s.face);
      return IT::Face_values<Interval>{{l[s.slot], l[(s.slot + 1) % 3], l[(s.slot + 2) % 3]}, area};
    });
    return face_;
  }

  IT::Corner_coordinates curves(std::uint32_t h) const {
    return IT::corner_coordinates(view_, t_.correspondence(), h);
  }

private:
  const T& t_;
  IT::Intrinsic_view<T> view_;
  IT::Input_face_intervals<Interval> faces_;
  decltype(faces_.of(std::declval<const IT::Input_metric&>())) values_;
  Face face_;
};

Gmpq cross(const Position& u, const Position& v) { return u[0] * v[1] - u[1] * v[0]; }
Gmpq squared_length(const Position& u) { return u[0] * u[0] + u[1] * u[1]; }
Position difference(const Position& p, const Position& q) { return {p[0] - q[0], p[1] - q[1]}; }

bool contains(const Interval& x, const Gmpq& value) {
  return Gmpq(x.inf()) <= value && value <= Gmpq(x.sup());
}

/// A triangulation in the plane that has been moved at random, and its faces.
template <class T>
class Moved_plane {
public:
  Moved_plane(const meshes::Mesh& m, unsigned seed) : plane(m), mover(plane.t, seed) {
    for (int i = 0; i < 60; ++i) plane.t.flip_edge({mover.halfedge(false)});
    for (int i = 0; i < 60; ++i)
      mover.move(
          false, [&](std::uint32_t h, const Weights& w) { return plane.insert(h, w); },
          [&](IT::Gluing_map::Vertex v, std::uint32_t h, const Weights& w) {
            return plane.reposition(v, h, w);
          });
    for (int i = 0; i < 200; ++i) plane.t.flip_edge({mover.halfedge(false)});
    find_sides();
  }
  /// flips the edges from vertex 0 to the vertices `first` to `last`, one after the other.
  Moved_plane(const meshes::Mesh& m, std::uint32_t first, std::uint32_t last)
      : plane(m), mover(plane.t, 1) {
    for (std::uint32_t v = first; v <= last; ++v) {
      const std::uint32_t h = plane.view().find_halfedge([&](std::uint32_t x) {
        return plane.view().source(x) == 0 && plane.view().target(x) == v;
      });
      EXPECT_TRUE(plane.t.flip_edge({h}) == IT::Move_status::done) << v;
    }
    find_sides();
  }
  void find_sides() {
    for (std::uint32_t h : places::halfedges_of_faces(plane.t))
      for (unsigned k = 0; k < 3; ++k, h = plane.view().next(h)) sides.push_back(h);
  }

  std::array<Position, 3> corners(std::uint32_t h) const {
    std::array<Position, 3> result;
    for (Position& p : result) {
      p = plane.position[plane.view().source(h)];
      h = plane.view().next(h);
    }
    return result;
  }

  Position at(const IT::Surface_point& p) const {
    return places::combination(plane.t.correspondence().input(), p.halfedge, p.weights,
                               plane.position);
  }

  // compares a place with what the plane says of the point there
  template <class Place, class Values>
  void check(std::uint32_t h, const IT::Corner_coordinates& curves, const Place& place,
             const Values& values) {
    ASSERT_TRUE(places::is_exact(place.location));
    const Position p = at(place.location);
    const std::array<Position, 3> to = corners(h);
    // crossings of the segments from the corners: nothing but the place is known here
    const auto normal = IT::inserted_normal_coordinates(curves, place.region);
    const int exponent = plane.t.metric().scale_exponent();
    const Gmpq unit(std::ldexp(1.0, 2 * exponent));
    for (unsigned k = 0; k < 3; ++k) {
      EXPECT_EQ(normal[k], plane.count(to[k], p));
      const Position u = difference(to[k], p), v = difference(to[(k + 1) % 3], p);
      EXPECT_TRUE(contains(values.squared_lengths[k], squared_length(u) * unit));
      EXPECT_TRUE(contains(values.quadruple_areas[k], 2 * cross(u, v) * unit));
      // unfolding takes some dozen operations on numbers up to 100
      EXPECT_LT(values.squared_lengths[k].sup() - values.squared_lengths[k].inf(), 1e-9);
      EXPECT_LT(values.quadruple_areas[k].sup() - values.quadruple_areas[k].inf(), 1e-9);
    }
    on_curves += place.region.is_on_curve ? 1 : 0;
    EXPECT_EQ(place.region.is_on_curve, place.location.weights[2] == 0);
  }

  // compares the direction of the farthest corner of a face from a place with that in the plane
  template <class Face, class Place>
  void check_direction(std::uint32_t h, const Face& face, const Place& place) {
    const IT::Input& input = plane.t.correspondence().input();
    const IT::Seen_corner seen = face.farthest_corner(input, place);
    const std::uint32_t x = place.location.halfedge;
    const Position p = at(place.location), to = difference(corners(h)[seen.corner], p),
                   axis =
                       difference(plane.position[input.target(x)], plane.position[input.source(x)]);
    const double angle = std::atan2(CGAL::to_double(cross(axis, to)),
                                    CGAL::to_double(axis[0] * to[0] + axis[1] * to[1]));
    EXPECT_LT(std::abs(std::remainder(angle - seen.angle, 2 * std::numbers::pi)), 0x1p-40);
    for (const Position& other : corners(h))
      EXPECT_GT(CGAL::to_double(squared_length(to)) * (1 + 0x1p-30),
                CGAL::to_double(squared_length(difference(other, p))));
  }

  // Places a point of a face at random, and checks all of it. `within`: the distance by rounding
  template <class Face>
  void place_a_point(std::uint32_t h, const IT::Corner_coordinates& curves, const Face& face,
                     double within) {
    const Weights w = mover.weights(false);
    const auto place = face.place(w);
    ASSERT_TRUE(place);
    check(h, curves, *place, face.values(*place));
    check_direction(h, face, *place);
    const Position asked = places::combination(plane.view(), h, w, plane.position);
    EXPECT_LT(places::distance(at(place->location), asked), within);
  }

  Plane<T> plane;
  Mover<T> mover;
  std::vector<std::uint32_t> sides; // all halfedges with a face
  int on_curves = 0;
};

std::vector<meshes::Mesh> planar() {
  return {meshes::grid(3, 3), meshes::sheared_grid(3, 4, 2), meshes::random_planar(20, 60, 3),
          meshes::random_planar(12, 12, 8)};
}

template <class Correspondence>
class Unfolded_face : public testing::Test {};
using Correspondences = testing::Types<IT::Integer_coordinates, IT::Explicit_crossings>;
TYPED_TEST_SUITE(Unfolded_face, Correspondences);

TYPED_TEST(Unfolded_face, places_points_of_the_plane_within_rounding_and_knows_their_values) {
  using T = Exact<TypeParam>;
  int fans = 0, corners = 0, strips = 0;
  for (unsigned seed = 1; seed <= 2; ++seed)
    for (const meshes::Mesh& m : planar()) {
      Moved_plane<T> moved(m, seed);
      const CGAL::Protect_FPU_rounding<true> upwards;
      Unfolder<T> unfold(moved.plane.t);
      for (const std::uint32_t h : moved.sides) {
        const auto curves = unfold.curves(h);
        moved.place_a_point(h, curves, unfold(h), 0x1p-34);
        if (::testing::Test::HasFatalFailure()) return;
        const auto [a, b, c] = curves.cutting;
        fans += curves.fan_corner() < 3 && curves.emanating[curves.fan_corner()] > 1 ? 1 : 0;
        corners += (a > 0) + (b > 0) + (c > 0) > 1 ? 1 : 0;
        strips += a + b + c > 4 ? 1 : 0;
        if (::testing::Test::HasFailure()) return;
      }
    }
  EXPECT_GT(fans, 20);
  EXPECT_GT(corners, 20);
  EXPECT_GT(strips, 20);
}

// A fan around vertex 0: n points of a circle, all around or, if a border goes through the vertex,
// on a half.
meshes::Mesh wheel(std::uint32_t n, bool is_half) {
  meshes::Mesh m;
  m.points.push_back({0, 0, 0});
  for (std::uint32_t k = 0; k < n; ++k) {
    const double angle = (is_half ? 1 : 2) * std::numbers::pi * k / n;
    m.points.push_back(
        {std::round(0x1p17 * std::cos(angle)), std::round(0x1p17 * std::sin(angle)), 0});
    if (k + 1 < n || !is_half) m.triangles.push_back({0, k + 1, k + 1 < n ? k + 2 : 1});
  }
  return m;
}

TYPED_TEST(Unfolded_face, turns_about_a_vertex_of_many_edges) {
  // faces cross up to 46 of them; the fan begins somewhere among them, or on the border
  using T = Exact<TypeParam>;
  int long_turns = 0;
  for (const std::uint32_t first : {2U, 40U, 0U}) {
    const bool is_half = first == 0;
    Moved_plane<T> moved(wheel(is_half ? 60 : 96, is_half), std::max(first, 5U),
                         std::max(first, 5U) + 45);
    const CGAL::Protect_FPU_rounding<true> upwards;
    Unfolder<T> unfold(moved.plane.t);
    for (const std::uint32_t h : moved.sides) {
      const auto curves = unfold.curves(h);
      const auto [a, b, c] = curves.cutting;
      if (std::max({a, b, c}) < 34) continue;
      ++long_turns;
      for (int i = 0; i < 3; ++i) { // the last two times with a tree of products
        moved.place_a_point(h, curves, unfold(h), 0x1p-16);
        if (::testing::Test::HasFailure()) return;
      }
    }
  }
  EXPECT_GT(long_turns, 50);
}

// barycentric coordinates of a point in a triangle
Weights weights_of(const Position& p, const std::array<Position, 3>& t) {
  const Gmpq whole = cross(difference(t[1], t[0]), difference(t[2], t[0]));
  Weights w{};
  for (unsigned k = 0; k < 3; ++k)
    w[k] = CGAL::to_double(
        Gmpq(cross(difference(t[(k + 1) % 3], p), difference(t[(k + 2) % 3], p)) / whole));
  return w;
}

TYPED_TEST(Unfolded_face, puts_points_of_curves_on_them) {
  using T = Exact<TypeParam>;
  int points = 0, in_fans = 0;
  for (const meshes::Mesh& m : planar()) {
    Moved_plane<T> moved(m, 5);
    const IT::Input& input = moved.plane.t.input();
    const CGAL::Protect_FPU_rounding<true> upwards;
    Unfolder<T> unfold(moved.plane.t);
    for (const std::uint32_t h : moved.sides) {
      const std::array<Position, 3> t = moved.corners(h);
      for (std::uint32_t x = 0; x < input.number_of_halfedges(); x += 2)
        for (const double s : {0.25, 0.40625, 0.8125}) {
          const Position &a = moved.plane.position[input.source(x)],
                         &b = moved.plane.position[input.target(x)];
          const Position p{a[0] + Gmpq(s) * (b[0] - a[0]), a[1] + Gmpq(s) * (b[1] - a[1])};
          const Weights w = weights_of(p, t);
          if (*std::min_element(w.begin(), w.end()) < 1e-6) continue; // not inside
          const auto curves = unfold.curves(h);
          const auto& face = unfold(h);
          const auto place = face.place(w);
          ASSERT_TRUE(place);
          ASSERT_TRUE(place->region.is_on_curve);
          EXPECT_EQ(place->location.halfedge / 2, x / 2);
          EXPECT_LT(places::distance(moved.at(place->location), p), 1e-10);
          moved.check(h, curves, *place, face.values(*place));
          moved.check_direction(h, face, *place);
          ++points;
          in_fans += place->region.corner == place->region.fan_corner ? 1 : 0;
          if (::testing::Test::HasFailure()) return;
        }
    }
    EXPECT_GT(moved.on_curves, 0);
  }
  EXPECT_GT(points, 100);
  EXPECT_GT(in_fans, 10);
}

TYPED_TEST(Unfolded_face, puts_no_point_on_a_corner) {
  using T = Exact<TypeParam>;
  Moved_plane<T> moved(meshes::sheared_grid(3, 4, 2), 9);
  const CGAL::Protect_FPU_rounding<true> upwards;
  Unfolder<T> unfold(moved.plane.t);
  int refused = 0;
  for (const std::uint32_t h : moved.sides)
    for (const double tiny : {0., 0x1p-60, 0x1p-51}) {
      const auto curves = unfold.curves(h);
      const auto& face = unfold(h);
      const auto place = face.place({1 - 2 * tiny, tiny, tiny});
      refused += place ? 0 : 1;
      if (!place) continue;
      const auto v = face.values(*place);
      bool is_proven = true;
      for (unsigned k = 0; k < 3; ++k)
        is_proven = is_proven && v.quadruple_areas[k].inf() > 0 && v.squared_lengths[k].inf() > 0;
      // what is proven to be in the face is there
      if (is_proven) moved.check(h, curves, *place, v);
    }
  EXPECT_GT(refused, 0);
}

TYPED_TEST(Unfolded_face, places_points_of_surfaces_where_signposts_find_them) {
  for (const meshes::Mesh& m : {meshes::rough_grid(5, 1), meshes::box(2, 3, 2),
                                meshes::integer_terrain(40, 20, 3), meshes::potato(2, 3)}) {
    using T = Exact<TypeParam>;
    T t(subdivision_oracle::input(m));
    Exact<IT::Signposts> other(subdivision_oracle::input(m));
    Mover<T> mover(t, 4);
    for (int i = 0; i < 200; ++i) {
      const std::uint32_t h = mover.halfedge(false);
      ASSERT_EQ(t.flip_edge({h}), other.flip_edge({h}));
    }
    const IT::Intrinsic_view<T> view(t);
    for (const std::uint32_t h : places::halfedges_of_faces(t)) {
      const Weights w = mover.weights(false);
      const auto expected = IT::locate_on_input(other, {h, w});
      ASSERT_TRUE(expected);
      const auto located = IT::locate_on_input(t, {h, w});
      ASSERT_TRUE(located);
      const CGAL::Protect_FPU_rounding<true> upwards;
      Unfolder<T> unfold(t);
      const auto& face = unfold(h);
      const auto place = face.place(w);
      ASSERT_TRUE(place && places::is_exact(place->location));
      const meshes::Point p = meshes::position(t.input(), m.points, *expected);
      for (const meshes::Point& q : {meshes::position(t.input(), m.points, place->location),
                                     meshes::position(t.input(), m.points, *located)})
        for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(p[k], q[k], 1e-7);
      // shares of the area, by the requested weights
      const auto v = face.values(*place);
      const double area = t.metric().approximate_quadruple_area(view.face(h));
      for (unsigned k = 0; k < 3; ++k)
        EXPECT_NEAR(CGAL::to_double(v.quadruple_areas[k]), w[(k + 2) % 3] * area, 1e-9);
    }
  }
}

// the directions of the sides of an input face from the first one
std::array<double, 3> directions_of_sides(const IT::Input& input, std::uint32_t h) {
  const auto [ij, jk, ki] = IT::squared_lengths_of_face(input, h);
  const double at_source = std::acos((ij + ki - jk) / (2 * std::sqrt(ij * ki))),
               at_target = std::acos((ij + jk - ki) / (2 * std::sqrt(ij * jk)));
  return {0, std::numbers::pi - at_target, std::numbers::pi + at_source};
}

// Points near a curve are put on it, where they are seen from its halfedge, and beside it, where they are seen from
// the first side of their triangle.
TYPED_TEST(Unfolded_face, tells_the_sides_of_an_edge_apart_that_one_triangle_has_both_of) {
  using T = Exact<TypeParam>;
  gallery::Surface s = gallery::doubled_self_folded_cone();
  for (const std::size_t base : {0U, 3U}) s.squared_length_of_side[base] = 3.6;
  T t(gallery::input(s));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> weight;
  int glued = 0;
  for (int round = 0; round < 40; ++round) {
    t.flip_edge({2 * static_cast<std::uint32_t>(random() % t.mesh().number_of_edges())});
    const IT::Input& input = t.correspondence().input();
    const IT::Intrinsic_view<T> view(t);
    for (std::uint32_t h = 0; h < 2 * t.mesh().number_of_edges(); ++h) {
      IT::Unfolded_face<double> face;
      face.unfold(view, t.correspondence(), h, IT::approximate_values(input));
      for (int i = 0; i < 100; ++i) {
        const double a = weight(random), b = weight(random), c = weight(random), sum = a + b + c;
        const Weights w{a / sum, b / sum, c / sum};
        const auto on = face.place(w, 0.02), beside = face.place(w);
        if (!on || !on->region.is_on_curve || !beside || beside->region.is_on_curve) continue;
        const IT::Seen_corner seen = face.farthest_corner(input, *on),
                              expected = face.farthest_corner(input, *beside);
        if (on->triangle != beside->triangle || seen.corner != expected.corner) continue;
        const std::uint32_t first = beside->location.halfedge;
        std::uint32_t side = first;
        std::size_t k = 0;
        for (; on->weights[(k + 2) % 3] != 0; ++k) side = input.next(side);
        const double turn = directions_of_sides(input, first)[k] +
                            (side == on->location.halfedge ? 0 : std::numbers::pi);
        EXPECT_LT(
            std::abs(std::remainder(seen.angle + turn - expected.angle, 2 * std::numbers::pi)),
            0.15);
        glued += side / 2 == input.next(side) / 2 || side / 2 == input.next(input.next(side)) / 2;
      }
    }
  }
  EXPECT_GT(glued, 100);
}

std::uint32_t side_of(const IT::Input& input, std::uint32_t h, unsigned k) {
  return k == 0 ? h : side_of(input, input.next(h), k - 1);
}

// Leaves a triangle over a side, and goes on: mostly about one vertex, many times around it.
std::vector<std::uint32_t> random_strip(const IT::Input& input, std::uint32_t exit,
                                        std::mt19937& random) {
  std::vector<std::uint32_t> entered;
  while (!input.is_border(exit ^ 1U) && entered.size() < 150) {
    entered.push_back(exit ^ 1U);
    const unsigned way = entered.size() < 75 ? 1 : 2;
    exit = side_of(input, exit ^ 1U, random() % 32 != 0 ? way : 3 - way);
  }
  return entered;
}

void expect_same_triangles(const IT::Triangle_strips& strips, const IT::Development<>& steps) {
  ASSERT_EQ(strips.size(), steps.size());
  for (std::uint32_t n = 0; n < steps.size(); ++n) {
    ASSERT_EQ(strips.side(n), steps[n].side);
    ASSERT_EQ(strips.points(n), steps[n].point);
    if (n > 0) {
      ASSERT_EQ(strips.parent(n), steps[n].parent());
      ASSERT_EQ(strips.exit_to(n), steps.exit_to(n));
    }
    for (unsigned k = 0; k < 3; ++k) ASSERT_EQ(strips.entered_over(n, k), steps[n].beyond[k]);
    for (unsigned k = 0; k < 2; ++k) {
      std::uint32_t end = n + 1;
      while (end < steps.size() && steps[end].parent() == end - 1 &&
             steps[end].point[k] == steps[n].point[k])
        ++end;
      ASSERT_EQ(strips.end_of_turn(n, k), end);
    }
  }
}

// Runs say which halfedges are entered; those of the way back are as few.
std::vector<IT::Crossing_run> runs_of(const IT::Vertex_fans& fans,
                                      const std::vector<std::uint32_t>& entered) {
  std::vector<IT::Crossing_run> runs, back;
  for (const std::uint32_t x : entered) IT::append_run(fans, runs, {x, 1});
  std::vector<std::uint32_t> all;
  for (const IT::Crossing_run& run : runs)
    for (std::uint32_t i = 0; i < run.count(); ++i) all.push_back(run(fans, i));
  EXPECT_EQ(all, entered);
  std::reverse(all.begin(), all.end());
  const auto count = static_cast<std::uint32_t>(all.size());
  std::vector<std::uint32_t> seen;
  // in two parts, of which the second one may go on with the last run of the first
  for (const auto& [from, to] : {std::pair{0U, count / 3}, std::pair{count / 3, count}})
    IT::for_each_run(fans, runs, true, from, to, [&](const IT::Crossing_run& run) {
      for (std::uint32_t i = 0; i < run.count(); ++i) seen.push_back(run(fans, i) ^ 1U);
      IT::append_run(fans, back, run);
    });
  EXPECT_EQ(seen, all);
  EXPECT_EQ(back.size(), runs.size());
  return runs;
}

// Strips leave the first triangle over any side, then turn to both sides, in turns of many faces.
TEST(Triangle_strips, are_what_single_steps_add) {
  std::mt19937 random(11);
  std::size_t stored = 0, all = 0;
  for (const meshes::Mesh& m : {meshes::rough_grid(5, 1), meshes::potato(2, 3)}) {
    const Exact<IT::Integer_coordinates> t(subdivision_oracle::input(m));
    const IT::Input& input = t.input();
    const IT::Vertex_fans fans(input);
    for (int round = 0; round < 60; ++round) {
      const std::uint32_t h =
          input.halfedge_of_face(static_cast<std::uint32_t>(random() % input.number_of_faces()));
      IT::Development<> steps;
      IT::Triangle_strips strips;
      steps.start(h);
      strips.start(h);
      std::uint32_t from = 0;
      for (int strip = 0; strip < 2; ++strip) {
        const auto exit = static_cast<unsigned>(random() % 3);
        if (steps[from].beyond[exit] != IT::Development<>::none) continue;
        const auto entered = random_strip(input, side_of(input, steps[from].side, exit), random);
        std::uint32_t last = from;
        for (const std::uint32_t x : entered) last = steps.enter(input, last, x);
        const std::vector<IT::Crossing_run> runs = runs_of(fans, entered);
        strips.enter(input, fans, from, runs);
        stored += runs.size();
        all += entered.size();
        from = static_cast<std::uint32_t>(random() % steps.size());
      }
      expect_same_triangles(strips, steps);
    }
  }
  EXPECT_GT(all, 8 * stored);
}

} // namespace
