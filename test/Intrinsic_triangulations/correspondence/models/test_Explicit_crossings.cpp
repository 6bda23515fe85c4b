// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/trace_edge.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include "gallery.h"
#include "meshes.h"
#include "subdivision_oracle.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Edge_crossings;
using IT::Explicit_crossings;
using IT::Integer_coordinates;
using subdivision_oracle::input;
using subdivision_oracle::Mover;
using Lists = std::vector<std::vector<std::uint32_t>>;

template <class C>
using Exact = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, C>;
template <class C, class Mesh>
using Rounded = IT::Intrinsic_triangulation<Mesh, IT::Euclidean_traits<double>, C>;
static_assert(IT::IntrinsicCorrespondence<Explicit_crossings, Exact<Explicit_crossings>>);
static_assert(std::copyable<Explicit_crossings>);

Lists lists_of(const Explicit_crossings& c) {
  Lists lists;
  for (std::uint32_t e = 0; e < c.number_of_edges(); ++e) {
    lists.push_back(c.entered_on(e));
  }
  return lists;
}

std::vector<std::pair<std::string, meshes::Mesh>> all_meshes() {
  return {{"grid", meshes::grid(5, 5)},
          {"sheared grid", meshes::sheared_grid(5, 5, 7)},
          {"random planar", meshes::random_planar(60, 1000, 1)},
          {"parabola", meshes::parabola_fan(20)},
          {"terrain", meshes::integer_terrain(50, 50, 4)},
          {"rough grid", meshes::rough_grid(6, 5)},
          {"box", meshes::box(3, 2, 4)},
          {"sphere", meshes::sphere(2)},
          {"potato", meshes::potato(2, 6)},
          {"walls", meshes::walls({{0, 0}, {3, 0}, {1, 2}}, 4)},
          {"l shape", meshes::l_shape(4)},
          {"stairs", meshes::stairs(6, 4, 3)},
          {"folded lattice", meshes::folded_lattice(4, 6, 3)}};
}

/// The curves are followed with integer coordinates; the lists must say the same.
template <class T, class U>
void expect_same_lists(const T& explicit_one, const U& integer_one, const std::string& name) {
  const Explicit_crossings& c = explicit_one.correspondence();
  const Integer_coordinates& d = integer_one.correspondence();
  ASSERT_EQ(c.number_of_edges(), d.number_of_edges()) << name;
  const Edge_crossings traced = edge_crossings(integer_one, d),
                       read = edge_crossings(explicit_one, c);
  for (std::uint32_t e = 0; e < c.number_of_edges(); ++e) {
    ASSERT_EQ(c.normal_coordinate(e), d.normal_coordinate(e)) << name;
    ASSERT_EQ(c.roundabout(2 * e), d.roundabout(2 * e)) << name;
    ASSERT_EQ(c.roundabout(2 * e + 1), d.roundabout(2 * e + 1)) << name;
    ASSERT_TRUE(std::ranges::equal(c.entered_on(e), traced.entered_on(e))) << name << ' ' << e;
  }
  ASSERT_EQ(read.begin, traced.begin) << name;
  ASSERT_EQ(read.entered, traced.entered) << name;
  ASSERT_EQ(read.curve_begin, traced.curve_begin) << name;
  ASSERT_EQ(read.on_curve, traced.on_curve) << name;
}

template <class T, class U>
void expect_same_paths(const T& t, const U& u, const std::string& name) {
  for (const auto e : edges(t.mesh())) {
    const auto a = trace_edge(t, e).points, b = trace_edge(u, {t.index(e)}).points;
    ASSERT_EQ(a.size(), b.size()) << name;
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(a[i].on_input.halfedge, b[i].on_input.halfedge) << name;
      EXPECT_EQ(a[i].on_input.weights, b[i].on_input.weights) << name;
      EXPECT_EQ(a[i].parameter, b[i].parameter) << name;
    }
  }
}

template <class T, class U>
void expect_same_subdivisions(const T& t, const U& u, const std::string& name) {
  const IT::Common_subdivision a = IT::common_subdivision(t), b = IT::common_subdivision(u);
  EXPECT_EQ(a.corner, b.corner) << name;
  EXPECT_EQ(a.face_begin, b.face_begin) << name;
  EXPECT_EQ(a.input_face, b.input_face) << name;
  EXPECT_EQ(a.intrinsic_face, b.intrinsic_face) << name;
  for (std::size_t i = 0; i < a.crossings.size(); ++i) {
    EXPECT_EQ(a.crossings[i].on_input.parameter, b.crossings[i].on_input.parameter) << name;
    EXPECT_EQ(a.crossings[i].on_intrinsic.parameter, b.crossings[i].on_intrinsic.parameter) << name;
  }
}

/// Triangulations that differ in the correspondence only and make the same random moves.
struct Twins {
  Exact<Explicit_crossings> t;
  Exact<Integer_coordinates> u;
  Mover<Exact<Explicit_crossings>> move_t;
  Mover<Exact<Integer_coordinates>> move_u;

  Twins(const IT::Intrinsic_input& in, unsigned seed)
      : t(in), u(in), move_t(t, seed), move_u(u, seed) {}

  // Every other point has simple weights: on lattices, many of those lie on input edges in faces.
  void move(int i) {
    move(t, move_t, i % 2 == 0);
    move(u, move_u, i % 2 == 0);
  }
  template <class T>
  void move(T& x, Mover<T>& mover, bool is_simple) {
    mover.move(
        true,
        [&](std::uint32_t h, auto w) {
          if (is_simple) w = w[2] == 0 ? std::array{0.5, 0.5, 0.} : std::array{0.25, 0.25, 0.5};
          const auto n = x.insert_vertex({h}, w);
          if (n.status == IT::Move_status::done && w[2] != 0)
            on_curves += x.correspondence().location(x.index(n.vertex)).weights[2] == 0 ? 1 : 0;
          return n;
        },
        [&](IT::Gluing_map::Vertex v, std::uint32_t h, const auto& w) {
          return x.reposition_vertex(v, {h}, w);
        });
  }
  void expect_same(const std::string& name) const {
    ASSERT_EQ(move_t.statuses, move_u.statuses) << name;
    ASSERT_EQ(move_t.inserted, move_u.inserted) << name;
    expect_same_lists(t, u, name);
  }
  int on_curves = 0; // vertices that were inserted in faces, on input edges
};

TEST(Explicit_crossings, Are_those_that_integer_coordinates_trace_after_the_same_moves) {
  int on_curves = 0;
  for (const auto& [name, m] : all_meshes())
    for (const unsigned seed : {1U, 2U}) {
      Twins twins(input(m), seed);
      flip_to_delaunay(twins.t);
      flip_to_delaunay(twins.u);
      for (int i = 0; i < 160; ++i) {
        twins.move(i);
        if (i % 8 == 0) twins.expect_same(name + " move " + std::to_string(i));
        if (HasFatalFailure()) return;
      }
      EXPECT_GT(3 * twins.move_t.statuses[0], twins.move_t.moves) << name;
      twins.expect_same(name);
      expect_same_paths(twins.t, twins.u, name);
      expect_same_subdivisions(twins.t, twins.u, name);
      on_curves += twins.on_curves;
    }
  EXPECT_GT(on_curves, 20);
}

TEST(Explicit_crossings, Are_right_on_complexes_that_are_not_simplicial) {
  for (const gallery::Surface& s : gallery::oriented())
    for (const unsigned seed : {1U, 2U, 3U}) {
      Twins twins(gallery::input(s), seed);
      for (int i = 0; i < 60; ++i) {
        twins.move(i);
        twins.expect_same(s.name + " seed " + std::to_string(seed) + " move " + std::to_string(i));
        if (HasFatalFailure()) return;
      }
      expect_same_subdivisions(twins.t, twins.u, s.name);
    }
}

template <class T>
void expect_restored_by_flips(T& t, int flips, const std::string& name) {
  const Lists before = lists_of(t.correspondence());
  std::mt19937 random(7);
  std::vector<IT::Gluing_map::Halfedge> flipped;
  for (int i = 0; i < flips; ++i) {
    const IT::Gluing_map::Halfedge h{
        static_cast<std::uint32_t>(random() % t.mesh().number_of_halfedges())};
    if (t.flip_edge(h) == IT::Move_status::done) flipped.push_back(h);
  }
  std::reverse(flipped.begin(), flipped.end());
  for (const IT::Gluing_map::Halfedge h : flipped)
    for (int i = 0; i < 3; ++i) ASSERT_EQ(t.flip_edge(h), IT::Move_status::done) << name;
  EXPECT_EQ(lists_of(t.correspondence()), before) << name;
}

TEST(Explicit_crossings, Are_restored_by_flipping_back) {
  for (const auto& [name, m] : all_meshes()) {
    Exact<Explicit_crossings> t(input(m));
    flip_to_delaunay(t);
    expect_restored_by_flips(t, 40, name);
    Exact<Integer_coordinates> u(input(m));
    flip_to_delaunay(u);
    expect_same_lists(t, u, name);
  }
  for (const gallery::Surface& s : gallery::oriented()) {
    Exact<Explicit_crossings> t(gallery::input(s));
    expect_restored_by_flips(t, 10, s.name);
  }
}

TEST(Explicit_crossings, Are_restored_by_removal) {
  for (const auto& [name, m] : all_meshes()) {
    Exact<Explicit_crossings> t(input(m));
    flip_to_delaunay(t);
    const Lists before = lists_of(t.correspondence());
    for (const auto h : halfedges(t.mesh())) {
      if (t.mesh().face(h).index == IT::Gluing::none) continue;
      const auto n = t.insert_vertex(h, {0.25, 0.625, 0.125});
      ASSERT_EQ(n.status, IT::Move_status::done);
      ASSERT_EQ(t.remove_vertex(n.vertex), IT::Move_status::done);
      if (t.mesh().face(IT::Gluing_map::opposite(h)).index == IT::Gluing::none) {
        const auto p = t.split_edge(h, 0.25);
        ASSERT_EQ(p.status, IT::Move_status::done);
        ASSERT_EQ(t.remove_vertex(p.vertex), IT::Move_status::done);
      }
      Lists after = lists_of(t.correspondence());
      for (std::size_t e = before.size(); e < after.size(); ++e) ASSERT_TRUE(after[e].empty());
      after.resize(before.size());
      ASSERT_EQ(after, before) << name;
    }
  }
}

TEST(Explicit_crossings, Of_a_surface_mesh_are_the_same) {
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  const meshes::Mesh m = meshes::rough_grid(8, 3);
  Rounded<Explicit_crossings, Mesh> t(input(m));
  Rounded<Integer_coordinates, IT::Gluing_map> u(input(m));
  flip_to_delaunay(t);
  flip_to_delaunay(u);
  expect_same_lists(t, u, "surface mesh");
  expect_same_subdivisions(t, u, "surface mesh");
}

TEST(Explicit_crossings, Are_copied_and_moved) {
  const meshes::Mesh m = meshes::integer_terrain(50, 50, 4);
  Exact<Explicit_crossings> t(input(m));
  flip_to_delaunay(t);
  const Lists before = lists_of(t.correspondence());
  Exact<Explicit_crossings> copy(t);
  Mover mover(copy, 5);
  for (int i = 0; i < 50; ++i) mover.move(true);
  EXPECT_EQ(lists_of(t.correspondence()), before);
  const Lists after = lists_of(copy.correspondence());
  EXPECT_NE(after, before);
  t = std::move(copy);
  EXPECT_EQ(lists_of(t.correspondence()), after);
}

TEST(Explicit_crossings, Name_the_input_edge_that_an_edge_runs_along) {
  const meshes::Mesh m = meshes::grid(1, 1);
  Exact<Explicit_crossings> t(input(m));
  const Explicit_crossings& c = t.correspondence();
  for (std::uint32_t h = 0; h < t.mesh().number_of_halfedges(); ++h) EXPECT_EQ(c.along(h), h);
  for (const auto h : halfedges(t.mesh())) {
    if (t.flip_edge(h) != IT::Move_status::done) continue;
    // halfedge h turned clockwise, thus its old opposite crosses it from left to right
    EXPECT_EQ(c.along(h.index), IT::Gluing::none);
    EXPECT_EQ(c.entered_on(h.index / 2), std::vector<std::uint32_t>{h.index | 1U});
    return;
  }
  FAIL();
}

} // namespace
