// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/input/Input.h>

#include "meshes.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Gluing;
using IT::Gluing_map;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Triangulation = IT::Intrinsic_triangulation<>;
using Integer =
    IT::Intrinsic_triangulation<Gluing_map, IT::Exact_euclidean_traits, IT::Integer_coordinates>;

// a mesh of squares and triangles: a cube with one square cut
Mesh cube() {
  Mesh mesh;
  CGAL::make_hexahedron(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0),
                        Point(0, 1, 1), Point(0, 0, 1), Point(1, 0, 1), Point(1, 1, 1), mesh);
  const auto h = halfedge(Mesh::Face_index(2), mesh);
  CGAL::Euler::split_face(h, next(next(h, mesh), mesh), mesh);
  return mesh;
}

using Ends = std::set<std::uint32_t>;

Ends ends(const IT::Input& in, std::uint32_t e) {
  const IT::Element_names& names = in.names().vertices;
  return {names.user(in.source(2 * e)), names.user(in.target(2 * e))};
}

// An edge of the user's mesh keeps its ends, and its triangles are parts of its faces.
template <class T>
void expect_names_of(const Mesh& mesh, const T& t) {
  const IT::Input& in = t.input();
  std::uint32_t named = 0;
  for (std::uint32_t e = 0; e < in.number_of_edges(); ++e) {
    const std::uint32_t user = in.names().edges.user(e);
    std::set<std::uint32_t> faces{in.names().polygon(in.face(2 * e)),
                                  in.names().polygon(in.face(2 * e + 1))};
    if (user == Gluing::none) { // a diagonal is in one polygon
      EXPECT_EQ(faces.size(), 1U);
      continue;
    }
    ++named;
    EXPECT_EQ(in.names().edges.here(user), e);
    const auto h = halfedge(Mesh::Edge_index(user), mesh);
    EXPECT_EQ(ends(in, e), (Ends{source(h, mesh), target(h, mesh)}));
    EXPECT_EQ(faces, (std::set<std::uint32_t>{face(h, mesh), face(opposite(h, mesh), mesh)}));
  }
  EXPECT_EQ(named, num_edges(mesh));
}

TEST(Input, names_edges_and_polygons_as_the_users_mesh_does) {
  const Mesh mesh = cube();
  const Integer t(mesh);
  EXPECT_EQ(t.input().number_of_faces(), 12U);
  EXPECT_EQ(t.input().names().polygon_of_triangle.size(), 12U);
  expect_names_of(mesh, t);
}

TEST(Input, names_triangles_without_tables) {
  Mesh mesh;
  CGAL::make_tetrahedron(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1), mesh);
  const Integer t(mesh);
  EXPECT_TRUE(t.input().names().edges.is_identity());
  EXPECT_TRUE(t.input().names().faces.is_identity());
  EXPECT_TRUE(t.input().names().polygon_of_triangle.empty());
  expect_names_of(mesh, t);
}

// Squares over a large grid in random order: faces and edges are renumbered, and triangulated before that.
TEST(Input, names_edges_and_polygons_that_were_renumbered) {
  const std::uint32_t n = 300; // 180000 triangles, more than what fits a cache
  const auto order = meshes::permutation((n + 1) * (n + 1), 3);
  const auto corner = [&](std::uint32_t i, std::uint32_t j) {
    return Mesh::Vertex_index(order[i * (n + 1) + j]);
  };
  Mesh mesh;
  for (std::uint32_t v = 0; v < (n + 1) * (n + 1); ++v) mesh.add_vertex();
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t j = 0; j <= n; ++j) mesh.point(corner(i, j)) = Point(i, j, std::sin(i * j));
  for (const std::uint32_t square : meshes::permutation(n * n, 4)) {
    const std::uint32_t i = square / n, j = square % n;
    mesh.add_face(corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1));
  }
  const Integer t(mesh);
  ASSERT_TRUE(t.report().renumbered);
  const IT::Input& in = t.input();
  std::uint32_t diagonals = 0;
  for (std::uint32_t e = 0; e < in.number_of_edges(); ++e) {
    const std::uint32_t user = in.names().edges.user(e);
    if (user == Gluing::none) {
      ++diagonals;
      continue;
    }
    const auto h = halfedge(Mesh::Edge_index(user), mesh);
    ASSERT_EQ(ends(in, e), (Ends{source(h, mesh), target(h, mesh)}));
  }
  EXPECT_EQ(diagonals, n * n);
  for (std::uint32_t f = 0; f < in.number_of_faces(); ++f) {
    ASSERT_EQ(in.names().faces.here(in.names().faces.user(f)), f);
    Ends corners;
    for (const auto v :
         vertices_around_face(halfedge(Mesh::Face_index(in.names().polygon(f)), mesh), mesh))
      corners.insert(v);
    std::uint32_t h = in.halfedge_of_face(f);
    for (int k = 0; k < 3; ++k, h = in.next(h))
      ASSERT_TRUE(corners.count(in.names().vertices.user(in.source(h))));
  }
}

TEST(Input, is_shared_by_copies_and_correspondence_and_never_changes) {
  Integer t(meshes::rough_grid(8, 1).input());
  const Integer copy(t);
  EXPECT_EQ(&t.input(), &copy.input());
  EXPECT_EQ(&t.input(), &t.correspondence().input());
  const std::uint32_t before = t.input().next(0);
  const double length = t.input().squared_length(0);
  for (const auto h : halfedges(t.mesh())) t.flip_edge(h);
  EXPECT_EQ(t.input().next(0), before);
  EXPECT_EQ(t.input().squared_length(0), length);
  EXPECT_TRUE(t.input().is_defined_by_metric());
}

TEST(Input, knows_lengths_and_areas_that_no_metric_gave_it) {
  const Integer t(meshes::rough_grid(8, 1).input());
  const IT::Input defined(t.input().mesh(), t.input().metric());
  for (std::uint32_t e = 0; e < defined.number_of_edges(); ++e)
    EXPECT_NEAR(defined.squared_length(e), t.input().squared_length(e), 1e-14);
  for (std::uint32_t f = 0; f < defined.number_of_faces(); ++f)
    EXPECT_NEAR(defined.quadruple_area(f), t.input().quadruple_area(f), 1e-13);
}

TEST(Input, keeps_lengths_and_areas_where_a_correspondence_needs_them) {
  const meshes::Mesh m = meshes::box(2, 1, 1);
  EXPECT_EQ(Triangulation(m.input()).input().surface(), nullptr);
  const Integer t(m.input());
  ASSERT_EQ(t.input().surface(), &t.input());
  for (std::uint32_t f = 0; f < t.input().number_of_faces(); ++f) // 4 A, scaled
    EXPECT_EQ(t.input().quadruple_area(f), std::ldexp(2.0, 2 * t.input().scale_exponent()));
}

} // namespace
