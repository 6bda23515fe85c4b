// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gallery.h"
#include "meshes.h"

#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_geodesics/single_source/flip_to_geodesic_tree.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

template <class Traits>
using Traced = IT::Intrinsic_triangulation<IT::Gluing_map, Traits, IT::Integer_coordinates>;
using Exact = Traced<IT::Exact_euclidean_traits>;
using Double = Traced<IT::Euclidean_traits<double>>;
constexpr double infinity = std::numeric_limits<double>::infinity();

template <class T>
std::vector<double> lengths(const T& t, const IT::Geodesic_tree<T>& tree) {
  std::vector<double> l(num_vertices(t.mesh()));
  for (const auto v : vertices(t.mesh())) l[t.input_vertex(v)] = tree.length(v);
  return l;
}

// Bellman and Ford, on the edges of a triangulation
std::vector<double> lengths_along_edges(const Exact& t, std::uint32_t from) {
  std::vector<double> d(num_vertices(t.mesh()), infinity);
  d[from] = 0;
  for (bool changes = true; changes;) {
    changes = false;
    for (const auto h : halfedges(t.mesh())) {
      const double x = d[t.input_vertex(source(h, t.mesh()))] + t.length(edge(h, t.mesh()));
      double& y = d[t.input_vertex(target(h, t.mesh()))];
      if (x < y) {
        y = x;
        changes = true;
      }
    }
  }
  return d;
}

bool has_border_between(const Exact& t, Exact::halfedge_descriptor in,
                        Exact::halfedge_descriptor out) {
  for (;; in = opposite(next(in, t.mesh()), t.mesh())) {
    if (CGAL::is_border(in, t.mesh())) return true;
    if (next(in, t.mesh()) == out) return false;
  }
}

// every path consists of edges one after the other, and no joint can be made shorter, exactly
void expect_geodesics(const Exact& t, const IT::Geodesic_tree<Exact>& tree,
                      Exact::vertex_descriptor from) {
  const Exact::Const_session session(t);
  for (const auto v : vertices(t.mesh())) {
    const auto path = tree.path_to(v);
    EXPECT_EQ(path.empty(), v == from || tree.length(v) == infinity);
    if (path.empty()) continue;
    EXPECT_EQ(source(path.front(), t.mesh()), from);
    EXPECT_EQ(target(path.back(), t.mesh()), v);
    double length = 0;
    for (const auto h : path) length += t.length(edge(h, t.mesh()));
    EXPECT_NEAR(length, tree.length(v), 1e-9 * (length + 1));
    if (path.size() < 2) continue;
    const auto in = path[path.size() - 2], out = path.back();
    ASSERT_EQ(target(in, t.mesh()), source(out, t.mesh()));
    const auto back_out = opposite(out, t.mesh()), back_in = opposite(in, t.mesh());
    EXPECT_TRUE(has_border_between(t, in, out) ||
                session.compare_angle_to_pi(in, out) != CGAL::SMALLER);
    EXPECT_TRUE(has_border_between(t, back_out, back_in) ||
                session.compare_angle_to_pi(back_out, back_in) != CGAL::SMALLER);
  }
}

std::vector<double> tree_lengths(Exact& t, std::uint32_t from) {
  const std::vector<double> along_edges = lengths_along_edges(t, from);
  const auto s = IT::vertex_of_row(t, from);
  const auto tree = IT::flip_to_geodesic_tree(t, s);
  EXPECT_EQ(tree.shortening().status, IT::Status::done);
  EXPECT_EQ(tree.shortening().refused_flips, 0U);
  expect_geodesics(t, tree, s);
  const std::vector<double> l = lengths(t, tree);
  for (std::size_t i = 0; i < l.size(); ++i) {
    EXPECT_EQ(std::isinf(l[i]), std::isinf(along_edges[i]));
    if (!std::isinf(l[i])) {
      EXPECT_LE(l[i], along_edges[i] * (1 + 1e-12));
    }
  }
  return l;
}

} // namespace

TEST(Flip_to_geodesic_tree, has_shortest_paths) {
  std::size_t n = 0;
  for (const meshes::Mesh& m :
       {meshes::box(2, 3, 1), meshes::rough_grid(12, 1), meshes::potato(3, 2), meshes::potato(4, 5),
        meshes::integer_height_field(9, 4, 3), meshes::l_shape(3), meshes::stairs(4, 3),
        meshes::random_planar(60, 32, 3)})
    for (const std::uint32_t from : {0U, 5U}) {
      Exact t(m.input());
      const std::vector<double> s =
          IT::Polyhedral_distance(t, IT::vertex_of_row(t, from)).distances();
      const std::vector<double> l = tree_lengths(t, from);
      for (std::size_t i = 0; i < l.size(); ++i) {
        if (i == from || s[i] == infinity) continue;
        EXPECT_NEAR(l[i], s[i], 1e-9 * s[i]);
        ++n;
      }
    }
  EXPECT_GT(n, 0U);
}

TEST(Flip_to_geodesic_tree, bends_about_the_border_of_an_unfolded_lattice) {
  // the distance by visibility in the plane polygon that the folds unfold to; that of Surface_mesh_shortest_path is longer
  Exact t(meshes::folded_lattice(4, 6, 2).input());
  const std::vector<double> l = tree_lengths(t, 0);
  EXPECT_TRUE(
      std::any_of(l.begin(), l.end(), [](double x) { return std::abs(x - 133.43026) < 1e-5; }));
}

TEST(Flip_to_geodesic_tree, has_the_distances_of_a_box) {
  Exact t(meshes::box(1, 1, 1).input());
  std::vector<double> l = tree_lengths(t, 0);
  std::sort(l.begin(), l.end());
  const std::vector<double> expected{0,           1, 1, 1, std::sqrt(2), std::sqrt(2), std::sqrt(2),
                                     std::sqrt(5)};
  for (std::size_t i = 0; i < 8; ++i) EXPECT_NEAR(l[i], expected[i], 1e-12);
}

TEST(Flip_to_geodesic_tree, has_a_path_to_every_vertex_of_a_delta_complex) {
  for (const gallery::Surface& g : gallery::oriented()) {
    if (g.expected.nonmanifold_vertices + g.expected.isolated_vertices > 0) continue;
    for (std::uint32_t from = 0; from < g.expected.vertices; ++from) {
      SCOPED_TRACE(g.name);
      Exact t(gallery::input(g));
      tree_lengths(t, from);
    }
  }
}

// It need not find all ways there: edges lead on in one fan of faces.
TEST(Flip_to_geodesic_tree, ends_where_vertices_are_not_manifold) {
  for (const gallery::Surface& g : gallery::oriented()) {
    if (g.expected.nonmanifold_vertices == 0) continue;
    for (std::uint32_t from = 0; from < g.expected.vertices; ++from) {
      SCOPED_TRACE(g.name);
      Exact t(gallery::input(g));
      const auto tree = IT::flip_to_geodesic_tree(t, IT::vertex_of_row(t, from));
      EXPECT_EQ(tree.length(IT::vertex_of_row(t, from)), 0);
    }
  }
}

TEST(Flip_to_geodesic_tree, has_the_distances_of_a_flat_torus) {
  const gallery::Surface g = gallery::flat_torus(5, 4);
  const std::vector<double> squared = gallery::squared_lengths(g);
  Exact t({IT::Gluing_map(g.gluing), squared});
  const double step = std::sqrt(*std::min_element(squared.begin(), squared.end()));
  std::vector<double> l = tree_lengths(t, 0), expected;
  std::sort(l.begin(), l.end());
  for (int i = 0; i < 5; ++i)
    for (int k = 0; k < 4; ++k)
      expected.push_back(step * std::hypot(std::min(i, 5 - i), std::min(k, 4 - k)));
  std::sort(expected.begin(), expected.end());
  ASSERT_EQ(l.size(), expected.size());
  for (std::size_t i = 0; i < l.size(); ++i) EXPECT_NEAR(l[i], expected[i], 1e-9);
}

TEST(Flip_to_geodesic_tree, has_no_path_to_another_component) {
  meshes::Mesh m = meshes::box(1, 1, 1);
  const meshes::Mesh other = meshes::translated(m, {5, 0, 0});
  for (auto f : other.triangles) m.triangles.push_back({f[0] + 8, f[1] + 8, f[2] + 8});
  m.points.insert(m.points.end(), other.points.begin(), other.points.end());
  Exact t(m.input());
  const std::vector<double> l = tree_lengths(t, 3);
  EXPECT_EQ(std::count(l.begin(), l.end(), infinity), 8);
}

TEST(Flip_to_geodesic_tree, stops_at_a_cap_and_when_cancelled) {
  struct Refusing : IT::Shortening_visitor {
    bool progress(const IT::Shortening_result&) { return false; }
  };
  Exact t(meshes::potato(4, 5).input());
  const auto s = IT::vertex_of_row(t, 0);
  const auto capped = IT::flip_to_geodesic_tree(t, s, IT::parameters::maximum_number(3));
  EXPECT_EQ(capped.shortening().status, IT::Status::cap);
  EXPECT_EQ(capped.shortening().flips, 3U);
  const auto cancelled = IT::flip_to_geodesic_tree(t, s, IT::parameters::visitor(Refusing()));
  EXPECT_EQ(cancelled.shortening().status, IT::Status::cancelled);
  expect_geodesics(t, cancelled, s);
}

TEST(Flip_to_geodesic_tree, is_the_same_in_doubles) {
  const meshes::Mesh m = meshes::potato(4, 5);
  Exact t(m.input());
  Double d(m.input());
  const std::vector<double> l = tree_lengths(t, 0);
  const std::vector<double> k = lengths(d, IT::flip_to_geodesic_tree(d, IT::vertex_of_row(d, 0)));
  for (std::size_t i = 0; i < l.size(); ++i) EXPECT_NEAR(l[i], k[i], 1e-9 * l[i]);
}

TEST(Flip_to_geodesic_tree, does_not_flip_back_and_forth_in_doubles) {
  // such slender faces that rounding makes up bends, and lengths that do not fit each other
  for (meshes::Mesh m : {meshes::sphere(4), meshes::rough_grid(30, 1), meshes::sphere(5)}) {
    for (auto& p : m.points) p[0] *= m.points.size() > 2000 ? 1e3 : 1e4;
    Double d(m.input());
    const auto tree = IT::flip_to_geodesic_tree(d, IT::vertex_of_row(d, 0));
    const std::vector<double> l = lengths(d, tree);
    const auto missing = std::count(l.begin(), l.end(), infinity);
    EXPECT_LT(tree.shortening().flips, 20 * num_edges(d.mesh()));
    EXPECT_LE(50 * static_cast<std::size_t>(missing), l.size());
    EXPECT_EQ(tree.shortening().status, missing == 0 ? IT::Status::done : IT::Status::stalled);
    for (const auto v :
         vertices(d.mesh())) { // no way is left that leads elsewhere, or round in a circle
      const auto way = tree.path_to(v);
      if (way.empty()) continue;
      EXPECT_EQ(source(way.front(), d.mesh()), IT::vertex_of_row(d, 0));
      EXPECT_EQ(target(way.back(), d.mesh()), v);
    }
  }
}
