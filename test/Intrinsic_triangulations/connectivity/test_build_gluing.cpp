// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>

#include "gallery.h"
#include "mesh_types.h"
#include "refusals.h"
#include "validity.h"

#include <CGAL/Intrinsic_triangulations/connectivity/as_gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/topology.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <type_traits>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

void expect_same_maps(const IT::Gluing_map& a, const IT::Gluing_map& b) {
  ASSERT_EQ(a.number_of_vertices(), b.number_of_vertices());
  ASSERT_EQ(a.number_of_halfedges(), b.number_of_halfedges());
  ASSERT_EQ(a.number_of_faces(), b.number_of_faces());
  for (std::uint32_t h = 0; h < a.number_of_halfedges(); ++h) {
    EXPECT_EQ(a.next({h}), b.next({h}));
    EXPECT_EQ(a.target({h}), b.target({h}));
    EXPECT_EQ(a.face({h}), b.face({h}));
  }
  for (std::uint32_t f = 0; f < a.number_of_faces(); ++f)
    EXPECT_EQ(a.halfedge(IT::Gluing_map::Face{f}), b.halfedge(IT::Gluing_map::Face{f}));
}

} // namespace

template <class Mesh>
class Build_gluing : public ::testing::Test {};
TYPED_TEST_SUITE(Build_gluing, All_meshes);

TYPED_TEST(Build_gluing, oriented_gallery_comes_back_from_every_mesh_type_with_its_numbers) {
  for (const gallery::Surface& s : gallery::oriented()) {
    SCOPED_TRACE(s.name);
    const IT::Gluing_map map(s.gluing);
    TypeParam mesh;
    IT::copy_gluing_map(map, mesh);
    EXPECT_EQ(IT::delta_complex_defect(mesh).value_or("none"), "none");
    const IT::Gluing_map back = IT::gluing_map_from_face_graph(mesh);
    EXPECT_EQ(IT::delta_complex_defect(back).value_or("none"), "none");
    expect_same_maps(map, back);
  }
}

TYPED_TEST(Build_gluing, isolated_vertex_has_no_halfedge_in_any_mesh_type) {
  TypeParam mesh;
  IT::copy_gluing_map(IT::Gluing_map(gallery::two_fans_and_an_isolated_vertex().gluing), mesh);
  const std::vector<std::uint32_t> umbrellas = IT::umbrellas(mesh);
  ASSERT_EQ(std::count(umbrellas.begin(), umbrellas.end(), 0U), 1);
  auto n = umbrellas.begin();
  for (const auto v : vertices(mesh))
    EXPECT_EQ(halfedge(v, mesh) == boost::graph_traits<TypeParam>::null_halfedge(), *n++ == 0);
}

TYPED_TEST(Build_gluing, flipped_delta_complex_is_read_right) {
  const IT::Gluing_map map(gallery::octagon_of_genus_2().gluing);
  TypeParam mesh;
  IT::copy_gluing_map(map, mesh);
  IT::Gluing_map expected = map;
  std::vector<typename boost::graph_traits<TypeParam>::halfedge_descriptor> side;
  for (const typename boost::graph_traits<TypeParam>::edge_descriptor e : edges(mesh))
    side.push_back(halfedge(e, mesh));
  for (std::uint32_t e = 0; e < side.size(); ++e) {
    if (expected.face({2 * e}) == expected.face({2 * e + 1})) continue;
    CGAL::Euler::flip_edge(side[e], mesh);
    CGAL::Euler::flip_edge(IT::Gluing_map::Halfedge{2 * e}, expected);
  }
  expect_same_maps(IT::gluing_map_from_face_graph(mesh), expected);
}

TYPED_TEST(Build_gluing, face_that_is_no_triangle_is_named) {
  TypeParam mesh;
  IT::copy_gluing_map(IT::Gluing_map(gallery::tetrahedron().gluing), mesh);
  if constexpr (!std::is_same_v<TypeParam, OpenMesh_triangles> &&
                !std::is_same_v<TypeParam, IT::Gluing_map>) {
    // removing an edge leaves a quadrilateral
    CGAL::Euler::join_face(halfedge(*edges(mesh).begin(), mesh), mesh);
    refusals::expect_invalid([&] { IT::gluing_map_from_face_graph(mesh); }, IT::Element_kind::face,
                             {}, {"is not a triangle"});
  }
}

TEST(Build_gluing_from_meshes, gaps_of_removed_elements_are_closed) {
  Surface_mesh mesh;
  IT::copy_gluing_map(IT::Gluing_map(gallery::annulus(4).gluing), mesh);
  CGAL::Euler::remove_face(mesh.halfedge(Surface_mesh::Face_index(2)), mesh);
  ASSERT_TRUE(mesh.has_garbage());
  const IT::Gluing_map map = IT::gluing_map_from_face_graph(mesh);
  EXPECT_EQ(map.number_of_faces(), 7U);
  EXPECT_EQ(IT::delta_complex_defect(map).value_or("none"), "none");
  EXPECT_EQ(IT::delta_complex_defect(mesh).value_or("none"), "none");
  EXPECT_EQ(IT::euler_characteristic(mesh), 0);
}

TEST(Build_gluing_from_triangles, two_faces_on_the_same_three_vertices_make_a_pillow) {
  const IT::Gluing g = IT::gluing_from_triangles(3, Triangles{{0, 1, 2}, {1, 0, 2}});
  EXPECT_EQ(g.glue, (std::vector<std::uint32_t>{3, 5, 4, 0, 2, 1}));
  EXPECT_EQ(IT::euler_characteristic(IT::Gluing_map(g)), 2);
}

TEST(Build_gluing_from_triangles, what_makes_no_oriented_surface_is_named) {
  const auto expect_error = [](std::uint32_t n, const Triangles& triangles, IT::Element_kind kind,
                               const std::vector<std::string>& parts) {
    refusals::expect_invalid([&] { IT::gluing_from_triangles(n, triangles); }, kind, {}, parts);
  };
  expect_error(3, {{0, 1, 2}, {1, 2, 0}}, IT::Element_kind::edge,
               {"edge (0, 1)", "faces 0 and 1", "same direction", "reverse"});
  expect_error(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}, IT::Element_kind::edge,
               {"edge (0, 1) has 3 faces (0, 1, 2)"});
  expect_error(4, {{0, 1, 2}, {0, 1, 3}}, IT::Element_kind::edge,
               {"edge (0, 1)", "same direction by faces 0 and 1", "reverse one of them"});
  // a Moebius strip of five faces
  expect_error(5, {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 0}, {4, 0, 1}}, IT::Element_kind::edge,
               {"same direction", "only one side", "cut it open"});
  expect_error(3, {{0, 1, 2}, {2, 1, 2}}, IT::Element_kind::face, {"face 1 repeats vertex 2"});
  expect_error(3, {{0, 1, 1}}, IT::Element_kind::face, {"face 0 repeats vertex 1"});
  expect_error(3, {{0, 1, 3}}, IT::Element_kind::face, {"face 0 refers to vertex 3"});
}

TEST(Build_gluing_from_triangles, faces_that_disagree_are_turned_around) {
  // an octahedron, then a tetrahedron, of which one and three faces look inwards
  const Triangles triangles{{0, 2, 4}, {2, 1, 4}, {4, 3, 1}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5},
                            {3, 1, 5}, {0, 3, 5}, {6, 7, 8}, {6, 7, 9}, {7, 8, 9}, {8, 6, 9}};
  std::vector<char> reversed;
  const IT::Gluing g = IT::oriented_gluing_from_triangles(10, triangles, reversed);
  EXPECT_EQ(reversed, (std::vector<char>{0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0}));
  IT::validate(g);
  const IT::Gluing_map map(g);
  EXPECT_TRUE(map.is_oriented());
  EXPECT_EQ(map.number_of_edges(), 18U);
  const auto origins = [&g](std::size_t f) {
    return std::array{g.origin[3 * f], g.origin[3 * f + 1], g.origin[3 * f + 2]};
  };
  EXPECT_EQ(origins(2), (std::array{4U, 1U, 3U}));
  EXPECT_EQ(origins(3), (std::array{3U, 0U, 4U}));
  // a Moebius strip stays an error
  EXPECT_THROW(IT::oriented_gluing_from_triangles(
                   5, Triangles{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 0}, {4, 0, 1}}, reversed),
               IT::Invalid_input);
}

TEST(Build_gluing_from_triangles, no_triangles_make_an_empty_gluing) {
  const IT::Gluing g = IT::gluing_from_triangles(4, Triangles{});
  EXPECT_EQ(g.number_of_faces(), 0U);
  EXPECT_EQ(IT::umbrellas(IT::Gluing_map(g)), std::vector<std::uint32_t>(4, 0));
}

TEST(Build_gluing_from_triangles, vertex_with_many_faces_is_glued_right) {
  const gallery::Surface s = gallery::disc_fan(1000);
  const IT::Gluing_map m(s.gluing);
  EXPECT_EQ(IT::boundary_loops(m).size(), 1U);
  EXPECT_EQ(std::count(s.gluing.origin.begin(), s.gluing.origin.end(), 0U),
            static_cast<std::ptrdiff_t>(m.number_of_faces()));
}
