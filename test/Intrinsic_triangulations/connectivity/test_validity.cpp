// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gallery.h"
#include "mesh_types.h"
#include "validity.h"

#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

template <class Mesh>
struct Handles {
  using Traits = boost::graph_traits<Mesh>;
  explicit Handles(Mesh& mesh) {
    for (const typename Traits::vertex_descriptor v : vertices(mesh)) vertex.push_back(v);
    for (const typename Traits::edge_descriptor e : edges(mesh)) {
      side.push_back(halfedge(e, mesh));
      side.push_back(opposite(side.back(), mesh));
    }
    for (const typename Traits::face_descriptor f : faces(mesh)) face.push_back(f);
  }
  std::vector<typename Traits::vertex_descriptor> vertex;
  std::vector<typename Traits::halfedge_descriptor> side;
  std::vector<typename Traits::face_descriptor> face;
};

std::string defect_of(const auto& mesh) { return IT::delta_complex_defect(mesh).value_or("none"); }

} // namespace

template <class Mesh>
class Validity : public ::testing::Test {};
TYPED_TEST_SUITE(Validity, All_meshes);

TYPED_TEST(Validity, empty_mesh_is_valid) { EXPECT_TRUE(IT::is_valid_delta_complex(TypeParam())); }

TYPED_TEST(Validity, what_is_wrong_is_named) {
  const auto null = boost::graph_traits<TypeParam>::null_face();
  // Spoils a copy of a surface, whose elements are numbered as in `Gluing_map(s.gluing)`.
  const auto expect_defect = [](const gallery::Surface& s, const std::string& part,
                                const auto& spoil) {
    TypeParam mesh;
    IT::copy_gluing_map(IT::Gluing_map(s.gluing), mesh);
    spoil(mesh, Handles<TypeParam>(mesh));
    const std::string d = defect_of(mesh);
    EXPECT_NE(d.find(part), std::string::npos) << d;
  };
  using Mesh = TypeParam;
  using At = Handles<Mesh>;
  expect_defect(gallery::tetrahedron(), "halfedge 0 of edge 0 is followed by",
                [](Mesh& m, const At& at) { set_next(at.side[0], at.side[1], m); });
  expect_defect(gallery::tetrahedron(), "halfedge 0 of edge 0 does not lie in a triangle",
                [](Mesh& m, const At& at) { set_next(next(at.side[0], m), at.side[0], m); });
  expect_defect(gallery::tetrahedron(), "different end vertices", [](Mesh& m, const At& at) {
    set_target(at.side[2], at.vertex[target(at.side[2], m) == at.vertex[0] ? 1 : 0], m);
  });
  expect_defect(gallery::tetrahedron(), "another face",
                [](Mesh& m, const At& at) { set_face(at.side[0], face(at.side[1], m), m); });
  expect_defect(gallery::triangle(), "edge 0 has no face", [&](Mesh& m, const At& at) {
    for (const auto h : at.side) set_face(h, null, m);
  });
  expect_defect(
      gallery::tetrahedron(), "face 1 has a halfedge that lies in another face",
      [](Mesh& m, const At& at) { set_halfedge(at.face[1], halfedge(at.face[0], m), m); });
  expect_defect(
      gallery::tetrahedron(), "vertex 2 has a halfedge that points to another vertex",
      [](Mesh& m, const At& at) { set_halfedge(at.vertex[2], halfedge(at.vertex[3], m), m); });
  expect_defect(gallery::two_tetrahedra_sharing_a_vertex(), "face 0 has 6 sides",
                [](Mesh& m, const At& at) {
                  auto h = halfedge(at.face[7], m);
                  for (int k = 0; k < 3; ++k, h = next(h, m)) set_face(h, at.face[0], m);
                });
  const auto first_on_border = [&](Mesh& m, const At& at) {
    return *std::find_if(at.side.begin(), at.side.end(),
                         [&](auto h) { return face(h, m) == null; });
  };
  expect_defect(gallery::disc_fan(5), "halfedge", [&](Mesh& m, const At& at) { // into a face
    const auto h = first_on_border(m, at);
    set_next(h, next(opposite(next(h, m), m), m), m);
  });
  expect_defect(gallery::annulus(4), "starts from another vertex", [&](Mesh& m, const At& at) {
    const auto h = first_on_border(m, at);
    set_next(h, next(next(h, m), m), m);
  });
}

TYPED_TEST(Validity, shuffled_references_give_an_answer_and_never_hang) {
  std::mt19937 random(7);
  int found = 0;
  for (int round = 0; round < 300; ++round) {
    TypeParam copy;
    IT::copy_gluing_map(IT::Gluing_map(gallery::annulus(3).gluing), copy);
    const Handles<TypeParam> at(copy);
    const auto any = [&](const auto& list) { return list[random() % list.size()]; };
    for (int k = 0; k < 3; ++k) switch (random() % 5) {
      case 0:
        set_next(any(at.side), any(at.side), copy);
        break;
      case 1:
        set_target(any(at.side), any(at.vertex), copy);
        break;
      case 2:
        set_face(any(at.side), any(at.face), copy);
        break;
      case 3:
        set_halfedge(any(at.face), any(at.side), copy);
        break;
      default:
        set_halfedge(any(at.vertex), any(at.side), copy);
        break;
      }
    if (IT::delta_complex_defect(copy)) ++found;
  }
  EXPECT_GT(found, 250); // some changes are none, or are allowed
}

TEST(Validity_of_gluing_maps, whole_gallery_is_valid) {
  for (const gallery::Surface& s : gallery::all())
    EXPECT_EQ(defect_of(IT::Gluing_map(s.gluing)), "none") << s.name;
}

TEST(Validity_of_gluing_maps, references_to_nothing_are_named) {
  const IT::Gluing_map good(gallery::tetrahedron().gluing);
  IT::Gluing_map m = good;
  m.set_next({3}, {1000});
  EXPECT_EQ(defect_of(m), "halfedge 3 of edge 1 is followed by a halfedge that does not exist");
  m = good;
  m.set_next({3}, {});
  EXPECT_EQ(defect_of(m), "halfedge 3 of edge 1 is followed by a halfedge that does not exist");
  m = good;
  m.set_target({2}, {4});
  EXPECT_EQ(defect_of(m), "halfedge 2 of edge 1 points to a vertex that does not exist");
  m = good;
  m.set_face({2}, {77});
  EXPECT_EQ(defect_of(m), "halfedge 2 of edge 1 lies in a face that does not exist");
  m = good;
  m.set_halfedge(IT::Gluing_map::Face{3}, {12});
  EXPECT_EQ(defect_of(m), "face 3 has a halfedge that does not exist");
  m = good;
  m.set_halfedge(IT::Gluing_map::Vertex{0}, {99});
  EXPECT_EQ(defect_of(m), "vertex 0 has a halfedge that does not exist");
  m = good;
  m.set_halfedge(IT::Gluing_map::Vertex{0}, {});
  EXPECT_EQ(defect_of(m), "vertex 0 has no halfedge though halfedges point to it");
  m = good;
  m.add_face();
  EXPECT_EQ(defect_of(m), "face 4 has a halfedge that does not exist");
  m = good;
  m.add_edge();
  EXPECT_EQ(defect_of(m), "halfedge 12 of edge 6 points to a vertex that does not exist");
  m = good;
  m.add_vertex();
  EXPECT_EQ(defect_of(m), "none"); // an isolated vertex
}

TEST(Validity_of_gluing_maps, inner_halfedge_of_a_border_vertex_is_named) {
  IT::Gluing_map m(gallery::triangle().gluing);
  const IT::Gluing_map::Halfedge h = m.halfedge(IT::Gluing_map::Face{0});
  m.set_halfedge(m.target(h), h);
  EXPECT_EQ(defect_of(m), "vertex " + std::to_string(m.target(h).index) +
                              " is on the border but its halfedge is not");
}

TEST(Validity_of_gluing_maps, reversed_gluing_with_swapped_ends_is_named) {
  IT::Gluing_map m(gallery::moebius_strip(5).gluing);
  for (std::uint32_t e = 0; e < m.number_of_edges(); ++e)
    if (m.is_reversed({e})) {
      m.set_target({2 * e}, m.source({2 * e}));
      break;
    }
  EXPECT_NE(defect_of(m).find("different end vertices"), std::string::npos);
}

TEST(Validity_of_surface_meshes, references_to_removed_elements_are_named) {
  Surface_mesh m;
  IT::copy_gluing_map(IT::Gluing_map(gallery::tetrahedron().gluing), m);
  m.remove_face(Surface_mesh::Face_index(2));
  EXPECT_NE(defect_of(m).find("lies in a face that does not exist"), std::string::npos);
  m.clear();
  IT::copy_gluing_map(IT::Gluing_map(gallery::tetrahedron().gluing), m);
  m.remove_vertex(Surface_mesh::Vertex_index(1));
  EXPECT_NE(defect_of(m).find("points to a vertex that does not exist"), std::string::npos);
}
