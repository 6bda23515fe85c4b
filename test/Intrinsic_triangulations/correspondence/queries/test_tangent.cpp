// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/trace_edge.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/trace_geodesic.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/tracing/tangent_frames.h>

#include "gallery.h"
#include "meshes.h"
#include "subdivision_oracle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Explicit_crossings;
using IT::Integer_coordinates;
using IT::Signposts;
using IT::Surface_point;
using IT::Tangent_frames;
using subdivision_oracle::Mover;
template <class Correspondence>
using Triangulation =
    IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, Correspondence>;

std::vector<std::pair<std::string, meshes::Mesh>> fat_meshes() {
  return {{"grid", meshes::grid(5, 5)},
          {"sheared grid", meshes::sheared_grid(5, 5, 7)},
          {"rough grid", meshes::rough_grid(6, 5)},
          {"box", meshes::box(3, 2, 4)},
          {"sphere", meshes::sphere(2)},
          {"potato", meshes::potato(2, 6)}};
}

using gallery::input;
using subdivision_oracle::input;

double difference(double a, double b, double period) {
  return std::abs(std::remainder(a - b, period));
}

/// Flipped to Delaunay, and then moved at random.
template <class Correspondence, class Input>
Triangulation<Correspondence> moved(const Input& i, int moves) {
  Triangulation<Correspondence> t(input(i));
  flip_to_delaunay(t);
  Mover mover(t, 3);
  for (int k = 0; k < moves; ++k) mover.move(true);
  return t;
}

template <class Function, class T>
void for_each_halfedge_from_the_input(const T& t, Function f) {
  const IT::Intrinsic_view<T> view(t);
  for (const auto d : edges(t.mesh()))
    for (const std::uint32_t h : {2 * t.index(d), 2 * t.index(d) + 1})
      if (!t.correspondence().is_inserted(view.source(h))) f(h);
}

/// Where the input has the direction of an intrinsic halfedge, in the angles at its source.
template <class T>
double cone_angle_on_input(const T& t, const Tangent_frames& frames, std::uint32_t h) {
  const bool is_border = IT::Intrinsic_view<T>(t).is_border(h); // then in the face beside it
  const IT::Tangent_vector along = is_border ? IT::Tangent_vector{{h ^ 1U, {0, 1, 0}}, {-1, 0}}
                                             : IT::Tangent_vector{{h, {1, 0, 0}}, {1, 0}};
  const IT::Tangent_vector v = *IT::tangent_to_input(t, along);
  const auto& input = t.correspondence().input();
  const IT::Geodesic_face face(input, v.point.halfedge);
  const auto corner =
      static_cast<std::size_t>(std::ranges::max_element(v.point.weights) - v.point.weights.begin());
  EXPECT_EQ(v.point.weights[corner], 1);
  const auto& side = face.edge[corner];
  return frames.cone_angle(face.side[corner]) +
         std::arg(std::complex(v.vector[0], v.vector[1]) / std::complex(side[0], side[1]));
}

template <class Correspondence>
void expect_angles_of_signposts(int moves) {
  for (const auto& [name, m] : fat_meshes()) {
    const auto t = moved<Correspondence>(m, moves);
    const auto s = moved<Signposts>(m, moves);
    const Tangent_frames frames(t.correspondence().input());
    for_each_halfedge_from_the_input(t, [&, &n = name](std::uint32_t h) {
      const double a = cone_angle_on_input(t, frames, h);
      EXPECT_LT(difference(a, s.correspondence().angle(h), s.correspondence().fan(h).angle), 1e-9)
          << n << ' ' << h;
    });
  }
}

TEST(Tangent_transfer, Finds_the_directions_that_signposts_store) {
  expect_angles_of_signposts<Integer_coordinates>(0);
  expect_angles_of_signposts<Integer_coordinates>(8);
  expect_angles_of_signposts<Explicit_crossings>(8);
}

/// The angle between successive halfedges is that of the face between them.
template <class Input>
void expect_angles_of_faces(const Input& i, int moves, const std::string& name) {
  const auto t = moved<Integer_coordinates>(i, moves);
  using T = Triangulation<Integer_coordinates>;
  const IT::Intrinsic_view<T> view(t);
  const Integer_coordinates& c = t.correspondence();
  const Tangent_frames frames(c.input());
  for_each_halfedge_from_the_input(t, [&](std::uint32_t h) {
    if (view.is_border(h)) return;
    const std::uint32_t next = next_around_source(view, h);
    const auto& fan = frames.fan(frames.fan_of(c.fans().halfedge(c.roundabout(h))));
    const double turn = cone_angle_on_input(t, frames, next) - cone_angle_on_input(t, frames, h);
    const double error = turn - angle_at_source(view, h);
    EXPECT_LT(fan.is_on_border ? std::abs(error) : difference(error, 0, fan.angle), 1e-9)
        << name << ' ' << h;
  });
}

TEST(Tangent_transfer, Turns_from_halfedge_to_halfedge_by_the_angle_between_them) {
  for (const auto& [name, m] : fat_meshes()) expect_angles_of_faces(m, 8, name);
  for (const gallery::Surface& s : gallery::oriented()) {
    expect_angles_of_faces(s, 0, s.name);
    expect_angles_of_faces(s, 6, s.name);
  }
}

template <class T>
meshes::Point position(const T& t, const meshes::Mesh& m, const Surface_point& p) {
  return meshes::position(t.correspondence().input(), m.points, p);
}

using meshes::distance;

template <class Correspondence>
class Tangent : public testing::Test {};
using Correspondences = testing::Types<Integer_coordinates, Explicit_crossings, Signposts>;
TYPED_TEST_SUITE(Tangent, Correspondences);

/// The angle from a halfedge counterclockwise to a vector in the frame of a face at its source; negative if the
/// face is not there.
template <class View>
double angle_from(const View& view, std::uint32_t h, const IT::Tangent_vector& v) {
  const IT::Geodesic_face face(view, v.point.halfedge);
  double sum = 0;
  std::uint32_t g = h;
  do {
    for (unsigned k = 0; k < 3; ++k)
      if (face.side[k] == g && v.point.weights[k] > 1 - 1e-9) {
        const auto r = face.relative_to(k, v.vector);
        return sum + std::atan2(r[1], r[0]);
      }
    sum += angle_at_source(view, g);
    g = next_around_source(view, g);
  } while (g != h && !view.is_border(g));
  return -10;
}

TYPED_TEST(Tangent, Vectors_at_all_vertices_go_there_and_back) {
  for (const auto& [name, m] : fat_meshes()) {
    const auto t = moved<TypeParam>(m, 8);
    const IT::Intrinsic_view view(t);
    std::size_t count = 0;
    for (const auto d : edges(t.mesh()))
      for (const std::uint32_t h : {2 * t.index(d), 2 * t.index(d) + 1}) {
        if (view.is_border(h)) continue;
        bool is_on_border = false;
        const double all = cone_angle(view, h, is_on_border);
        const double angle = angle_at_source(view, h) / 3;
        const IT::Tangent_vector v{{h, {1, 0, 0}}, {2 * std::cos(angle), 2 * std::sin(angle)}};
        const auto there = IT::tangent_to_input(t, v);
        ASSERT_TRUE(there) << name;
        EXPECT_NEAR(std::hypot(there->vector[0], there->vector[1]), 2, 1e-12) << name;
        const auto back = IT::tangent_to_intrinsic(t, *there);
        ASSERT_TRUE(back) << name;
        EXPECT_NEAR(std::hypot(back->vector[0], back->vector[1]), 2, 1e-12) << name;
        const double found = angle_from(view, h, *back);
        if (is_on_border && found == -10) continue; // to the right of the halfedge
        EXPECT_LT(difference(found, angle, all), 1e-9) << name << ' ' << h;
        ++count;
      }
    EXPECT_GT(count, num_edges(t.mesh()));
  }
}

TYPED_TEST(Tangent, The_direction_of_an_edge_is_that_of_its_path) {
  for (const auto& [name, m] : fat_meshes()) {
    auto t = moved<TypeParam>(m, 8);
    const IT::Intrinsic_view view(t);
    for (const auto e : edges(t.mesh())) {
      const IT::Edge_path path = IT::trace_edge(t, e);
      ASSERT_EQ(path.status, IT::Status::done) << name;
      if (view.is_border(2 * t.index(e))) continue;
      const auto v = IT::tangent_to_input(t, {{2 * t.index(e), {1, 0, 0}}, {1, 0}});
      ASSERT_TRUE(v) << name;
      // a short geodesic in this direction runs along the first part of the path
      const double length = std::sqrt(t.squared_length(e)) * path.points[1].parameter;
      const IT::Geodesic g = IT::trace_geodesic_on_input(t, v->point, v->vector, length);
      EXPECT_LT(distance(position(t, m, g.points.back()), position(t, m, path.points[1].on_input)),
                1e-9)
          << name << ' ' << t.index(e);
    }
  }
}

TEST(Point_queries, Go_from_the_input_to_the_intrinsic_triangulation_and_back) {
  for (const auto& [name, m] : fat_meshes()) {
    auto t = moved<Integer_coordinates>(m, 8);
    const auto s = moved<Signposts>(m, 8);
    const IT::Input& surface = s.correspondence().input();
    std::mt19937 random(5);
    for (int i = 0; i < 300; ++i) {
      const auto f = static_cast<std::uint32_t>(random() % m.triangles.size());
      double a = static_cast<double>(random()) / 0x1p32, b = static_cast<double>(random()) / 0x1p32;
      if (a + b > 1) a = 1 - a, b = 1 - b;
      const Surface_point p{surface.halfedge_of_face(f), {1 - a - b, a, b}};
      const auto q = IT::locate_on_intrinsic(t, p);
      ASSERT_TRUE(q) << name;
      const Surface_point back = *IT::locate_on_input(t, *q);
      EXPECT_LT(distance(position(t, m, back), position(t, m, p)), 1e-9) << name << ' ' << i;
      // signposts lead to the same place on other ways
      const auto other = IT::locate_on_input(s, *q);
      ASSERT_TRUE(other) << name;
      EXPECT_LT(distance(position(s, m, *other), position(t, m, p)), 1e-9) << name << ' ' << i;
    }
  }
}

} // namespace
