// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/signed_incidence.h>

#include "gallery.h"
#include "mesh_types.h"
#include "refusals.h"

#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

// the product of the two matrices: for each face and vertex, the sum over paths
std::map<std::pair<std::uint32_t, std::uint32_t>, int>
boundary_of_boundary(const IT::Signed_incidence& s) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> product;
  for (const IT::Incidence_entry& f : s.edge_face)
    for (const IT::Incidence_entry& e : s.vertex_edge)
      if (e.row == f.column) product[{f.row, e.column}] += f.sign * e.sign;
  return product;
}

void expect_same_gluing(const IT::Gluing& a, const IT::Gluing& b) {
  EXPECT_EQ(a.number_of_vertices, b.number_of_vertices);
  EXPECT_EQ(a.origin, b.origin);
  EXPECT_EQ(a.glue, b.glue);
}

} // namespace

TEST(Signed_incidence, boundary_of_the_boundary_is_zero) {
  for (const gallery::Surface& s : gallery::all()) {
    const IT::Signed_incidence m = IT::incidence(IT::Gluing_map(s.gluing));
    EXPECT_EQ(m.vertex_edge.size(), 2 * m.number_of_edges);
    EXPECT_EQ(m.edge_face.size(), 3 * m.number_of_faces);
    for (const auto& [place, value] : boundary_of_boundary(m))
      EXPECT_EQ(value, 0) << s.name << ", face " << place.first << ", vertex " << place.second;
  }
}

TEST(Signed_incidence, gluing_comes_back_for_the_whole_gallery) {
  for (const gallery::Surface& s : gallery::all()) {
    SCOPED_TRACE(s.name);
    expect_same_gluing(IT::gluing_from_incidence(IT::incidence(IT::Gluing_map(s.gluing))),
                       s.gluing);
  }
}

TEST(Signed_incidence, matrices_come_back_with_the_numbers_of_edges) {
  for (const gallery::Surface& s : gallery::all()) {
    SCOPED_TRACE(s.name);
    const IT::Signed_incidence in = IT::incidence(IT::Gluing_map(s.gluing));
    std::vector<std::uint32_t> edge;
    const IT::Gluing g = IT::gluing_from_incidence(in, edge);
    ASSERT_EQ(edge.size(), in.edge_face.size());
    for (std::uint32_t h = 0; h < edge.size(); ++h) {
      EXPECT_EQ(edge[h], in.edge_face[h].column);
      if (g.glue[h] != IT::Gluing::none) {
        EXPECT_EQ(edge[h], edge[IT::Gluing::partner(g.glue[h])]);
      }
    }
  }
}

TEST(Signed_incidence, repeated_entries_are_kept_apart) {
  const IT::Signed_incidence s = IT::incidence(IT::Gluing_map(gallery::self_folded_cone().gluing));
  ASSERT_EQ(s.number_of_edges, 2U);
  // edge 0 is the loop at vertex 0, edge 1 leads to the tip, along which the face is folded
  EXPECT_EQ(s.vertex_edge[0], (IT::Incidence_entry{0, 0, -1}));
  EXPECT_EQ(s.vertex_edge[1], (IT::Incidence_entry{0, 0, +1}));
  EXPECT_EQ(s.edge_face[0], (IT::Incidence_entry{0, 0, +1}));
  EXPECT_EQ(s.edge_face[1], (IT::Incidence_entry{0, 1, +1}));
  EXPECT_EQ(s.edge_face[2], (IT::Incidence_entry{0, 1, -1}));
}

TEST(Signed_incidence, gluing_along_the_direction_of_both_sides_has_equal_signs) {
  const IT::Signed_incidence s = IT::incidence(IT::Gluing_map(gallery::moebius_triangle().gluing));
  EXPECT_EQ(s.edge_face[0], (IT::Incidence_entry{0, 0, +1}));
  EXPECT_EQ(s.edge_face[1], (IT::Incidence_entry{0, 0, +1}));
}

TEST(Signed_incidence, entries_may_come_in_any_order_where_vertices_tell_the_cyclic_one) {
  std::mt19937 random(5);
  for (const gallery::Surface& s : {gallery::tetrahedron(), gallery::annulus(4),
                                    gallery::flat_torus(4, 3), gallery::moebius_strip(5)}) {
    SCOPED_TRACE(s.name);
    IT::Signed_incidence m = IT::incidence(IT::Gluing_map(s.gluing));
    std::shuffle(m.vertex_edge.begin(), m.vertex_edge.end(), random);
    std::shuffle(m.edge_face.begin(), m.edge_face.end(), random);
    std::vector<std::uint32_t> edge;
    const IT::Gluing g = IT::gluing_from_incidence(m, edge);
    IT::validate(g);
    IT::Signed_incidence back = IT::incidence(IT::Gluing_map(g));
    ASSERT_EQ(back.edge_face.size(), m.edge_face.size());
    // the same faces with the same edges, up to rotation of the sides
    const auto key = [](const IT::Incidence_entry& x) { return std::pair(x.row, x.column); };
    std::vector<std::pair<std::uint32_t, std::uint32_t>> before, after;
    for (const IT::Incidence_entry& x : m.edge_face) before.push_back(key(x));
    for (std::uint32_t h = 0; h < edge.size(); ++h) after.emplace_back(h / 3, edge[h]);
    std::sort(before.begin(), before.end());
    std::sort(after.begin(), after.end());
    EXPECT_EQ(before, after);
    for (const auto& [place, value] : boundary_of_boundary(back)) EXPECT_EQ(value, 0);
  }
}

TEST(Signed_incidence, order_of_a_row_is_kept_where_all_sides_are_loops) {
  IT::Signed_incidence s = IT::incidence(IT::Gluing_map(gallery::one_vertex_torus().gluing));
  const IT::Gluing torus = IT::gluing_from_incidence(s);
  expect_same_gluing(torus, gallery::one_vertex_torus().gluing);
  std::swap(s.edge_face[4], s.edge_face[5]); // glued otherwise, it is no longer a torus
  EXPECT_NE(IT::gluing_from_incidence(s).glue, torus.glue);
}

TEST(Signed_incidence, every_mesh_type_gives_the_same_matrices) {
  const IT::Gluing_map map(gallery::octagon_of_genus_2().gluing);
  const IT::Signed_incidence expected = IT::incidence(map);
  const auto check = [&](auto mesh) {
    IT::copy_gluing_map(map, mesh);
    const IT::Signed_incidence s = IT::incidence(mesh);
    EXPECT_EQ(s.vertex_edge, expected.vertex_edge);
    EXPECT_EQ(s.edge_face, expected.edge_face);
  };
  check(Surface_mesh());
  check(Polyhedron_with_ids());
  check(OpenMesh_triangles());
}

TEST(Signed_incidence, edges_and_faces_that_make_no_complex_are_named) {
  const auto expect_error = [](IT::Element_kind kind, std::size_t index, const std::string& part,
                               const auto& spoil) {
    auto s = IT::incidence(IT::Gluing_map(gallery::two_triangles_sharing_two_edges().gluing));
    spoil(s);
    refusals::expect_invalid([&] { IT::gluing_from_incidence(s); }, kind, index, {part});
  };
  using Incidence = IT::Signed_incidence;
  constexpr auto edge = IT::Element_kind::edge, face = IT::Element_kind::face;
  expect_error(edge, 2, "edge 2 has fewer than two ends",
               [](Incidence& s) { s.vertex_edge.erase(s.vertex_edge.begin() + 4); });
  expect_error(edge, 1, "edge 1 ends at two vertices",
               [](Incidence& s) { s.vertex_edge[2].sign = +1; });
  expect_error(edge, 1, "edge 1 starts from two vertices",
               [](Incidence& s) { s.vertex_edge[3].sign = -1; });
  expect_error(edge, 1, "vertex 3, which does not exist",
               [](Incidence& s) { s.vertex_edge[3].column = 3; });
  expect_error(edge, 0, "has the entry 0 at vertex",
               [](Incidence& s) { s.vertex_edge[0].sign = 0; });
  expect_error(edge, 4, "edge 4 is out of range", [](Incidence& s) { s.vertex_edge[0].row = 4; });
  expect_error(face, 1, "face 1 has 2 sides", [](Incidence& s) { s.edge_face.pop_back(); });
  expect_error(face, 0, "face 0 has 4 sides",
               [](Incidence& s) { s.edge_face.push_back(s.edge_face.front()); });
  expect_error(face, 0, "has the entry 2 at edge", [](Incidence& s) { s.edge_face[1].sign = 2; });
  expect_error(face, 0, "face 0 has sides 0, 1, 2 that do not run around",
               [](Incidence& s) { s.edge_face[1].sign = -s.edge_face[1].sign; });
  expect_error(edge, 0, "edge 0 has more than two faces (0, 1, 2", [](Incidence& s) {
    s.number_of_faces = 3;
    for (std::size_t k = 0; k < 3; ++k) {
      s.edge_face.push_back(s.edge_face[k]);
      s.edge_face.back().row = 2;
    }
  });
  expect_error(edge, 4, "edge 4 has no face", [](Incidence& s) {
    s.number_of_edges = 5;
    s.vertex_edge.push_back({4, 0, -1});
    s.vertex_edge.push_back({4, 1, +1});
  });
}
