// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Polyhedron_3_adaptor.h>

#include "properties.h"
#include "refusals.h"

#include <CGAL/Intrinsic_triangulations.h>
#include <CGAL/Intrinsic_triangulations/connectivity/topology.h>

#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;

// the unit cube with six quadrilaterals
template <class Mesh>
Mesh cube() {
  Mesh mesh;
  CGAL::make_hexahedron(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0),
                        Point(0, 1, 1), Point(0, 0, 1), Point(1, 0, 1), Point(1, 1, 1), mesh);
  return mesh;
}

template <class Mesh>
class Polygonal_meshes : public testing::Test {};
using Meshes = testing::Types<CGAL::Surface_mesh<Point>, CGAL::Polyhedron_3<Kernel>,
                              CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>>;
TYPED_TEST_SUITE(Polygonal_meshes, Meshes);

TYPED_TEST(Polygonal_meshes, quadrilaterals_are_triangulated_and_that_is_reported) {
  IT::Intrinsic_triangulation<> t(cube<TypeParam>());
  EXPECT_EQ(t.report().triangulated_polygons, 6U);
  EXPECT_EQ(num_faces(t.mesh()), 12U);
  EXPECT_EQ(properties::total_area(t), 6); // sums of halves are exact
  // every diagonal of a square is a tie, and nothing else is
  const auto report = IT::check_delaunay(t);
  EXPECT_EQ(report.non_delaunay_edges, 0U);
  ASSERT_EQ(report.cocircular_edges.size(), 6U);
  for (const auto e : report.cocircular_edges) EXPECT_EQ(t.squared_length(e), 2);
}

// a prism with its faces as polygons
CGAL::Surface_mesh<Point> prism(unsigned n) {
  CGAL::Surface_mesh<Point> mesh;
  std::vector<CGAL::Surface_mesh<Point>::Vertex_index> bottom, top;
  for (unsigned i = 0; i < n; ++i) {
    const double angle = 2 * CGAL_PI * i / n;
    top.push_back(mesh.add_vertex(Point(std::cos(angle), std::sin(angle), 1)));
    bottom.push_back(mesh.add_vertex(Point(std::cos(angle), std::sin(angle), 0)));
  }
  for (unsigned i = 0; i < n; ++i)
    mesh.add_face(bottom[i], bottom[(i + 1) % n], top[(i + 1) % n], top[i]);
  mesh.add_face(top);
  std::reverse(bottom.begin(), bottom.end());
  mesh.add_face(bottom);
  return mesh;
}

TEST(Triangulate_face_graph, prisms_keep_their_area_and_stay_closed) {
  for (const unsigned n : {5U, 6U, 17U, 1000U}) {
    const CGAL::Surface_mesh<Point> mesh = prism(n);
    const IT::Intrinsic_triangulation<> t(mesh);
    EXPECT_EQ(t.report().triangulated_polygons, n + 2);
    EXPECT_EQ(num_faces(t.mesh()), 4 * n - 4);
    EXPECT_EQ(IT::euler_characteristic(t.mesh()), 2);
    EXPECT_TRUE(CGAL::is_closed(t.mesh()));
    const double side = 2 * std::sin(CGAL_PI / n);
    // each of the 4n faces is rounded, some of them are thin
    EXPECT_NEAR(properties::total_area(t), n * (side + std::sin(2 * CGAL_PI / n)), 4 * n * 0x1p-48);
  }
}

TEST(Triangulate_face_graph, diagonal_may_join_vertices_that_an_edge_joins_already) {
  // two squares, folded over each other: both may be cut along 0-2, and are glued along their sides
  CGAL::Surface_mesh<Point> mesh;
  std::vector<CGAL::Surface_mesh<Point>::Vertex_index> v;
  for (const Point& p : {Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)})
    v.push_back(mesh.add_vertex(p));
  mesh.add_face(v[0], v[1], v[2], v[3]);
  mesh.add_face(v[3], v[2], v[1], v[0]);
  const IT::Intrinsic_triangulation<> t(mesh);
  EXPECT_EQ(num_edges(t.mesh()), 6U);
  EXPECT_EQ(IT::euler_characteristic(t.mesh()), 2);
  EXPECT_EQ(properties::total_area(t), 2);
}

TEST(Triangulate_face_graph, sides_on_the_border_stay_there) {
  CGAL::Surface_mesh<Point> mesh;
  std::vector<CGAL::Surface_mesh<Point>::Vertex_index> v;
  for (const Point& p : {Point(0, 0, 0), Point(2, 0, 0), Point(3, 1, 0), Point(2, 2, 0),
                         Point(0, 2, 0), Point(1, 1, 0)}) // the last one is a reflex corner
    v.push_back(mesh.add_vertex(p));
  mesh.add_face(v);
  const IT::Intrinsic_triangulation<> t(mesh);
  EXPECT_EQ(num_faces(t.mesh()), 4U);
  EXPECT_EQ(num_edges(t.mesh()), 9U);
  double border = 0;
  for (const auto e : edges(t.mesh()))
    if (CGAL::is_border(e, t.mesh())) border += std::sqrt(t.squared_length(e));
  EXPECT_EQ(properties::total_area(t), 4);
  EXPECT_NEAR(border, 4 + 4 * std::sqrt(2), 0x1p-46);
}

TEST(Triangulate_face_graph, meshes_of_triangles_are_taken_as_they_are) {
  CGAL::Surface_mesh<Point> mesh;
  CGAL::make_tetrahedron(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1), mesh);
  EXPECT_EQ(IT::Intrinsic_triangulation<>(mesh).report().triangulated_polygons, 0U);
}

TEST(Triangulate_face_graph, polygon_is_named_where_connectivity_alone_is_asked_for) {
  refusals::expect_invalid(
      [] { IT::gluing_map_from_face_graph(cube<CGAL::Surface_mesh<Point>>()); },
      IT::Element_kind::face, 0);
}

} // namespace
