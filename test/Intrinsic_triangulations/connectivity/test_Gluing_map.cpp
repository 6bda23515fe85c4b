// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>

#include "gallery.h"
#include "mesh_types.h"
#include "validity.h"

#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/topology.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

// all that a mesh says of its halfedges, by the numbers of `Mesh_adaptor`
template <class Mesh>
std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> snapshot(const Mesh& mesh) {
  using Traits = boost::graph_traits<Mesh>;
  const IT::Mesh_adaptor<Mesh> number(mesh);
  std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> all;
  for (const typename Traits::halfedge_descriptor h : halfedges(mesh))
    all.emplace_back(number.halfedge(next(h, mesh)), number.vertex(target(h, mesh)),
                     face(h, mesh) == Traits::null_face() ? IT::Gluing::none
                                                          : number.face(face(h, mesh)));
  return all;
}

// the same after exchanging the names of a halfedge and its opposite, and of their faces
template <class Mesh>
auto swapped(const Mesh& mesh, typename boost::graph_traits<Mesh>::halfedge_descriptor h) {
  const IT::Mesh_adaptor<Mesh> number(mesh);
  const std::uint32_t a = number.halfedge(h), b = number.halfedge(opposite(h, mesh));
  const std::uint32_t f = number.face(face(h, mesh)),
                      g = number.face(face(opposite(h, mesh), mesh));
  auto all = snapshot(mesh);
  std::swap(all[a], all[b]);
  for (auto& [n, v, face_number] : all) {
    n = n == a ? b : n == b ? a : n;
    face_number = face_number == f ? g : face_number == g ? f : face_number;
  }
  return all;
}

} // namespace

template <class Mesh>
class Flips : public ::testing::Test {};
TYPED_TEST_SUITE(Flips, All_meshes);

TYPED_TEST(Flips, four_flips_are_the_identity_and_two_swap_the_halfedges) {
  using Traits = boost::graph_traits<TypeParam>;
  std::size_t flipped = 0;
  for (const gallery::Surface& s : gallery::oriented()) {
    SCOPED_TRACE(s.name);
    TypeParam mesh;
    IT::copy_gluing_map(IT::Gluing_map(s.gluing), mesh);
    std::vector<typename Traits::halfedge_descriptor> all;
    for (const typename Traits::halfedge_descriptor h : halfedges(mesh)) all.push_back(h);
    for (const typename Traits::halfedge_descriptor h : all) {
      const auto f = face(h, mesh), g = face(opposite(h, mesh), mesh);
      if (f == Traits::null_face() || g == Traits::null_face() || f == g) continue;
      ++flipped;
      const auto before = snapshot(mesh);
      const auto turned = swapped(mesh, h);
      CGAL::Euler::flip_edge(h, mesh);
      ASSERT_EQ(IT::delta_complex_defect(mesh).value_or("none"), "none");
      gallery::expect_topology(mesh, s);
      CGAL::Euler::flip_edge(h, mesh);
      EXPECT_EQ(snapshot(mesh), turned);
      CGAL::Euler::flip_edge(h, mesh);
      CGAL::Euler::flip_edge(h, mesh);
      EXPECT_EQ(snapshot(mesh), before);
      ASSERT_EQ(IT::delta_complex_defect(mesh).value_or("none"), "none");
    }
  }
  EXPECT_GT(flipped, 200U);
}

TEST(Gluing_map, edges_are_numbered_as_the_faces_meet_them) {
  const IT::Gluing_map m(gallery::flat_torus(4, 3).gluing);
  std::uint32_t edges = 0;
  for (std::uint32_t f = 0; f < m.number_of_faces(); ++f) {
    IT::Gluing_map::Halfedge h = m.halfedge(IT::Gluing_map::Face{f});
    for (int k = 0; k < 3; ++k, h = m.next(h)) {
      EXPECT_LE(h.index / 2, edges);
      if (h.index / 2 == edges) ++edges;
    }
  }
  EXPECT_EQ(edges, m.number_of_edges());
}

TEST(Gluing_map, faces_keep_the_numbers_vertices_and_first_sides_of_the_gluing) {
  for (const gallery::Surface& s : gallery::all()) {
    const IT::Gluing_map m(s.gluing);
    for (std::uint32_t f = 0; f < m.number_of_faces(); ++f) {
      IT::Gluing_map::Halfedge h = m.halfedge(IT::Gluing_map::Face{f});
      for (std::uint32_t k = 0; k < 3; ++k, h = m.next(h)) {
        EXPECT_EQ(m.face(h).index, f) << s.name;
        EXPECT_EQ(m.source(h).index, s.gluing.origin[3 * f + k]) << s.name;
        EXPECT_EQ(m.target(h).index, s.gluing.origin[3 * f + (k + 1) % 3]) << s.name;
      }
    }
  }
}

TEST(Gluing_map, border_halfedges_are_linked_within_umbrellas_and_previous_inverts_next) {
  for (const gallery::Surface& s : gallery::oriented()) {
    const IT::Gluing_map m(s.gluing);
    for (std::uint32_t h = 0; h < m.number_of_halfedges(); ++h) {
      EXPECT_EQ(m.previous(m.next({h})).index, h) << s.name;
      EXPECT_EQ(m.next(m.previous({h})).index, h) << s.name;
      EXPECT_EQ(m.target({h}), m.source(m.next({h}))) << s.name;
    }
  }
}

TEST(Gluing_map, previous_inverts_next_after_copying_a_mesh_with_a_nonmanifold_border_vertex) {
  Surface_mesh mesh;
  IT::copy_gluing_map(IT::Gluing_map(gallery::bow_tie().gluing), mesh);
  // let the border pass from one triangle to the other at the common vertex: valid, and usual
  std::vector<Surface_mesh::Halfedge_index> into, out;
  for (const Surface_mesh::Halfedge_index h : mesh.halfedges())
    if (mesh.is_border(h) && mesh.target(h) == Surface_mesh::Vertex_index(0)) {
      into.push_back(h);
      out.push_back(mesh.next(h));
    }
  ASSERT_EQ(into.size(), 2U);
  mesh.set_next(into[0], out[1]);
  mesh.set_next(into[1], out[0]);
  ASSERT_TRUE(IT::is_valid_delta_complex(mesh));
  EXPECT_EQ(IT::boundary_loops(mesh).size(), 2U);
  const IT::Gluing_map m = IT::gluing_map_from_face_graph(mesh);
  EXPECT_TRUE(IT::is_valid_delta_complex(m));
  for (std::uint32_t h = 0; h < m.number_of_halfedges(); ++h)
    EXPECT_EQ(m.previous(m.next({h})).index, h);
}

TEST(Gluing_map, reversed_gluings_are_kept_with_both_sides_in_one_direction) {
  for (const gallery::Surface& s : gallery::all()) {
    const IT::Gluing_map m(s.gluing);
    EXPECT_EQ(m.is_oriented(), s.expected.is_orientable) << s.name;
    for (std::uint32_t e = 0; e < m.number_of_edges(); ++e)
      if (m.is_reversed({e})) {
        EXPECT_EQ(m.target({2 * e}), m.target({2 * e + 1})) << s.name;
        EXPECT_EQ(m.source({2 * e}), m.source({2 * e + 1})) << s.name;
      }
  }
}

TEST(Gluing_map, source_and_target_of_border_halfedges_are_known_on_a_moebius_strip) {
  const IT::Gluing_map m(gallery::moebius_strip(5).gluing);
  for (std::uint32_t h = 0; h < m.number_of_halfedges(); ++h) {
    if (m.face({h}).index != IT::Gluing::none) continue;
    EXPECT_EQ(m.target({h}), m.source({h ^ 1U}));
    EXPECT_EQ(m.source({h}), m.target({h ^ 1U}));
  }
}

TEST(Gluing_map, invalid_gluing_is_refused) {
  IT::Gluing g = gallery::tetrahedron().gluing;
  g.glue[3] = 3;
  EXPECT_THROW(IT::Gluing_map{g}, IT::Invalid_input);
}

TEST(Gluing_map, added_elements_are_unconnected) {
  IT::Gluing_map m(gallery::klein_bottle().gluing);
  const IT::Gluing_map::Vertex v = m.add_vertex();
  const IT::Gluing_map::Edge e = m.add_edge();
  const IT::Gluing_map::Face f = m.add_face();
  EXPECT_EQ(v.index, 1U);
  EXPECT_EQ(e.index, 3U);
  EXPECT_EQ(f.index, 2U);
  EXPECT_EQ(m.halfedge(v).index, IT::Gluing::none);
  EXPECT_EQ(m.halfedge(f).index, IT::Gluing::none);
  EXPECT_FALSE(m.is_reversed(e));
  EXPECT_EQ(m.next({2 * e.index}).index, IT::Gluing::none);
}

TEST(Gluing_map, ranges_and_index_maps_agree_with_the_numbers) {
  const IT::Gluing_map m(gallery::flat_torus(4, 3).gluing);
  std::size_t i = 0;
  for (const IT::Gluing_map::Edge e : edges(m)) EXPECT_EQ(get(get(boost::edge_index, m), e), i++);
  EXPECT_EQ(i, num_edges(m));
  i = 0;
  for (const IT::Gluing_map::Vertex v : vertices(m))
    EXPECT_EQ(get(get(boost::vertex_index, m), v), i++);
  EXPECT_EQ(i, num_vertices(m));
  EXPECT_EQ(std::distance(halfedges(m).begin(), halfedges(m).end()), 72);
  EXPECT_EQ((*std::next(faces(m).begin(), 5)).index, 5U);
}
