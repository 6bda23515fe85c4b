// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/topology.h>

#include "gallery.h"
#include "mesh_types.h"
#include "validity.h"

#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

template <class Mesh>
void expect_counts(const Mesh& mesh, const gallery::Surface& s) {
  SCOPED_TRACE(s.name);
  EXPECT_EQ(num_vertices(mesh), s.expected.vertices);
  EXPECT_EQ(num_edges(mesh), s.expected.edges);
  EXPECT_EQ(num_faces(mesh), s.expected.faces);
  gallery::expect_topology(mesh, s);
  const IT::Face_components c = IT::connected_components(mesh);
  EXPECT_EQ(c.of_face.size(), s.expected.faces);
  EXPECT_EQ(*std::max_element(c.of_face.begin(), c.of_face.end()), s.expected.components - 1);
  EXPECT_EQ(IT::is_orientable(mesh), s.expected.is_orientable);
  for (const auto h : IT::boundary_loops(mesh))
    EXPECT_TRUE(face(h, mesh) == boost::graph_traits<Mesh>::null_face());
}

} // namespace

template <class Mesh>
class Topology : public ::testing::Test {};
TYPED_TEST_SUITE(Topology, All_meshes);

TYPED_TEST(Topology, counts_of_the_oriented_gallery_are_those_known_on_every_mesh_type) {
  for (const gallery::Surface& s : gallery::oriented()) {
    TypeParam mesh;
    IT::copy_gluing_map(IT::Gluing_map(s.gluing), mesh);
    expect_counts(mesh, s);
  }
}

TEST(Topology_of_gluing_maps, counts_of_the_whole_gallery_are_those_known) {
  for (const gallery::Surface& s : gallery::all()) expect_counts(IT::Gluing_map(s.gluing), s);
}

TEST(Topology_of_gluing_maps, empty_mesh_has_nothing) {
  const IT::Gluing_map empty;
  EXPECT_EQ(IT::euler_characteristic(empty), 0);
  EXPECT_EQ(IT::connected_components(empty).count, 0U);
  EXPECT_TRUE(IT::boundary_loops(empty).empty());
  EXPECT_TRUE(IT::umbrellas(empty).empty());
  EXPECT_EQ(IT::genus(empty), std::size_t{0});
}

TEST(Topology_of_gluing_maps, umbrellas_are_counted_per_vertex) {
  const IT::Gluing_map map(gallery::two_fans_and_an_isolated_vertex().gluing);
  EXPECT_EQ(IT::umbrellas(map), (std::vector<std::uint32_t>{2, 1, 1, 1, 0, 1, 1, 1}));
}

TEST(Topology_of_gluing_maps, components_are_numbered_by_their_first_faces) {
  const IT::Gluing_map map(gallery::two_fans_and_an_isolated_vertex().gluing);
  EXPECT_EQ(IT::connected_components(map).of_face, (std::vector<std::uint32_t>{0, 0, 1, 1}));
}

TEST(Orientation, gluing_made_inconsistent_by_reversing_faces_is_oriented_again) {
  for (const gallery::Surface& s : gallery::oriented()) {
    SCOPED_TRACE(s.name);
    const IT::Gluing& g = s.gluing;
    // reverse every third face: side k becomes side 2 - k
    IT::Gluing mixed = g;
    const auto odd = [](std::uint32_t h) { return h / 3 % 3 == 1; };
    const auto renamed = [&](std::uint32_t h) { return odd(h) ? h - h % 3 + 2 - h % 3 : h; };
    for (std::uint32_t h = 0; h < g.origin.size(); ++h) {
      mixed.origin[renamed(h)] = g.origin[odd(h) ? IT::Gluing::next(h) : h];
      if (g.glue[h] == IT::Gluing::none)
        mixed.glue[renamed(h)] = IT::Gluing::none;
      else
        mixed.glue[renamed(h)] = odd(h) != odd(g.glue[h]) ? IT::Gluing::reversed(renamed(g.glue[h]))
                                                          : renamed(g.glue[h]);
    }
    IT::validate(mixed);
    gallery::Surface turned = s;
    turned.gluing = mixed;
    expect_counts(IT::Gluing_map(mixed), turned);
    const IT::Orientation_result r = IT::orient_faces(mixed);
    ASSERT_TRUE(r.is_orientable);
    IT::validate(mixed);
    const IT::Gluing_map map(mixed);
    EXPECT_TRUE(map.is_oriented());
    EXPECT_TRUE(IT::is_valid_delta_complex(map));
    expect_counts(map, s);
    EXPECT_EQ(r.reversed_faces[0], 0); // the first face of a component is kept
  }
}

TEST(Orientation, nonorientable_gluing_is_left_alone_and_has_a_witness) {
  for (const gallery::Surface& s : gallery::all()) {
    if (s.expected.is_orientable) continue;
    SCOPED_TRACE(s.name);
    IT::Gluing g = s.gluing;
    const IT::Orientation_result r = IT::orient_faces(g);
    EXPECT_FALSE(r.is_orientable);
    ASSERT_LT(r.witness, g.origin.size());
    EXPECT_NE(g.glue[r.witness], IT::Gluing::none);
    EXPECT_EQ(g.origin, s.gluing.origin);
    EXPECT_EQ(g.glue, s.gluing.glue);
    // the rest after cutting there may still be nonorientable, but the Moebius strips are not
    if (s.name == "Moebius strip" || s.name == "Moebius strip of one triangle") {
      g.glue[IT::Gluing::partner(g.glue[r.witness])] = IT::Gluing::none;
      g.glue[r.witness] = IT::Gluing::none;
      EXPECT_TRUE(IT::find_orientation(g).is_orientable);
    }
  }
}
