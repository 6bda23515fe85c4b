// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Polyhedron_3_adaptor.h>

#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

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
  double area = 0;
  for (const auto f : faces(t.mesh())) area += t.area(f);
  EXPECT_EQ(area, 6); // sums of halves are exact
  // every diagonal of a square is a tie, and nothing else is
  const auto report = IT::check_delaunay(t);
  EXPECT_EQ(report.non_delaunay_edges, 0U);
  ASSERT_EQ(report.cocircular_edges.size(), 6U);
  for (const auto e : report.cocircular_edges) EXPECT_EQ(t.squared_length(e), 2);
}

TYPED_TEST(Polygonal_meshes, triangulation_is_copied_moved_and_assigned_with_its_numbers) {
  using Triangulation = IT::Intrinsic_triangulation<TypeParam>;
  const Triangulation original(cube<TypeParam>());
  Triangulation copy(original), assigned(cube<TypeParam>());
  assigned = copy;
  Triangulation moved(std::move(copy));
  std::uint32_t i = 0;
  for (const auto e : edges(moved.mesh())) EXPECT_EQ(moved.index(e), i++);
  EXPECT_EQ(IT::check_delaunay(moved).cocircular_edges.size(), 6U);
  EXPECT_EQ(IT::check_delaunay(assigned).cocircular_edges.size(), 6U);
}

TEST(Triangulate_face_graph, meshes_of_triangles_are_taken_as_they_are) {
  CGAL::Surface_mesh<Point> mesh;
  CGAL::make_tetrahedron(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1), mesh);
  EXPECT_EQ(IT::Intrinsic_triangulation<>(mesh).report().triangulated_polygons, 0U);
}

TEST(Triangulate_face_graph, polygon_is_named_where_connectivity_alone_is_asked_for) {
  try {
    IT::gluing_map_from_face_graph(cube<CGAL::Surface_mesh<Point>>());
    FAIL() << "a cube of quadrilaterals was taken for triangles";
  } catch (const IT::Invalid_input& error) {
    EXPECT_EQ(error.kind(), IT::Element_kind::face);
    EXPECT_EQ(error.index(), 0U);
  }
}

} // namespace
