// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gallery.h"
#include "meshes.h"
#include "refusals.h"
#include "soups.h"
#include "validity.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/topology.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Domain_kind;
using meshes::Mesh;

IT::Domain domain(const Mesh& m, Domain_kind kind = Domain_kind::automatic) {
  return IT::make_domain(soups::soup(m), kind);
}

// the message, if there is one
using refusals::refusal;

std::size_t border_edges(const IT::Gluing_map& mesh) {
  std::size_t count = 0;
  for (std::uint32_t h = 0; h < mesh.number_of_halfedges(); ++h)
    count += mesh.face({h}).index == IT::Gluing::none ? 1 : 0;
  return count;
}

// the properties of every cover
void expect_cover(const IT::Domain& d, const Mesh& m, const std::string& what) {
  const IT::Gluing_map& mesh = d.input.mesh;
  ASSERT_TRUE(IT::is_valid_delta_complex(mesh)) << what;
  EXPECT_TRUE(mesh.is_oriented()) << what;
  EXPECT_EQ(d.report.sheets, 2U) << what;
  ASSERT_EQ(mesh.number_of_faces(), 2 * m.triangles.size()) << what;
  for (const std::uint32_t n : IT::umbrellas(mesh)) EXPECT_LE(n, 1U) << what;
  ASSERT_EQ(d.input.points.size(), mesh.number_of_vertices()) << what;
  const IT::Input_names& names = d.input.names;
  EXPECT_EQ(names.number_of_rows(mesh.number_of_vertices()), m.points.size()) << what;
  for (std::uint32_t v = 0; v < mesh.number_of_vertices(); ++v)
    EXPECT_EQ(d.input.points[v], m.points[names.row(v)]) << what;
  for (std::uint32_t row = 0; row < m.points.size(); ++row)
    EXPECT_EQ(names.row(names.vertex(row)), row) << what;
  for (std::uint32_t f = 0; f < mesh.number_of_faces(); ++f) {
    EXPECT_EQ(names.polygon(f), f / 2) << what;
    meshes::Triangle corners{};
    for (unsigned k = 0; k < 3; ++k) corners[k] = names.row(mesh.source(mesh.sides({f})[k]).index);
    const auto& [i, j, k] = m.triangles[f / 2];
    EXPECT_EQ(corners, f % 2 == 0 ? (meshes::Triangle{i, j, k}) : (meshes::Triangle{j, i, k}))
        << what;
  }
}

TEST(Make_domain, takes_oriented_manifolds_as_they_are) {
  for (const Mesh& m : {meshes::box(2, 1, 1), meshes::grid(3, 2)}) {
    const IT::Domain d = domain(m);
    EXPECT_EQ(d.report.kind, Domain_kind::manifold);
    EXPECT_EQ(d.report.sheets, 1U);
    EXPECT_EQ(d.report.unoriented_edges, 0U);
    EXPECT_NE(d.report.reason, "");
    EXPECT_EQ(d.input.mesh.number_of_faces(), m.triangles.size());
    EXPECT_EQ(d.input.points, m.points);
    EXPECT_TRUE(d.input.names.row_of_vertex.empty());
  }
}

TEST(Make_domain, turns_faces_around_that_disagree) {
  Mesh m = meshes::box(2, 1, 1);
  std::swap(m.triangles[4][0], m.triangles[4][1]);
  const IT::Domain d = domain(m);
  EXPECT_EQ(d.report.kind, Domain_kind::manifold);
  EXPECT_EQ(d.report.unoriented_edges, 3U);
  EXPECT_EQ(d.input.reversed_faces, 1U);
  EXPECT_NE(d.report.reason.find("1 of them"), std::string::npos) << d.report.reason;
}

TEST(Make_domain, takes_the_tufted_cover_where_three_faces_meet) {
  const Mesh m = soups::three_fins();
  const IT::Domain d = domain(m);
  EXPECT_EQ(d.report.kind, Domain_kind::tufted_cover);
  EXPECT_EQ(d.report.nonmanifold_edges, 1U);
  EXPECT_EQ(d.report.reason, "edge (0, 1) has 3 faces (0, 1, 2)");
  expect_cover(d, m, "fins");
  EXPECT_EQ(border_edges(d.input.mesh), 0U);
}

// Edge 01 has the faces 012, 013 and 104, whose other corners are seen along the edge at 0, 81 and 235 degrees. Edge 20 has
// 012 and 203. All others have one.
TEST(Make_domain, glues_three_faces_as_one_does_by_hand) {
  const Mesh m = soups::three_fins();
  const IT::Gluing_map& mesh = domain(m).input.mesh;
  // the neighbour across side k of each front and back, as (face, side); front ijk, back jik
  using Side = std::pair<std::uint32_t, unsigned>;
  const std::map<Side, Side> expected{
      {{0, 0}, {3, 0}}, // the front of 012 runs along 01, the back of 013 against it
      {{2, 0}, {4, 0}}, // the front of 013 along, the front of 104 against
      {{5, 0}, {1, 0}}, // the back of 104 along, the back of 012 against
      {{0, 1}, {1, 2}}, // 12 has one face
      {{0, 2},
       {7, 0}}, // 20: 012 and 203 are both written from 2 to 0, so fronts are glued to backs
      {{6, 0}, {1, 1}}, // side 1 of the back 102
  };
  for (const auto& [here, there] : expected)
    EXPECT_EQ(IT::Gluing_map::opposite(mesh.sides({here.first})[here.second]),
              mesh.sides({there.first})[there.second])
        << here.first << ' ' << here.second;
}

TEST(Make_domain, covers_one_sided_surfaces) {
  const Mesh strip = soups::moebius_strip(), bottle = soups::klein_bottle(),
             plane = soups::projective_plane();
  const IT::Domain d = domain(strip), e = domain(bottle), f = domain(plane);
  for (const IT::Domain* x : {&d, &e, &f}) {
    EXPECT_EQ(x->report.kind, Domain_kind::orientation_cover);
    EXPECT_GT(x->report.unoriented_edges, 0U);
    EXPECT_EQ(x->report.nonmanifold_edges, 0U);
    EXPECT_NE(x->report.reason.find("only one side"), std::string::npos) << x->report.reason;
    EXPECT_EQ(IT::connected_components(x->input.mesh).count, 1U) << "the cover is connected";
  }
  expect_cover(d, strip, "Moebius strip");
  expect_cover(e, bottle, "Klein bottle");
  expect_cover(f, plane, "projective plane");
  EXPECT_EQ(IT::boundary_loops(d.input.mesh).size(), 2U) << "an annulus";
  EXPECT_EQ(IT::euler_characteristic(d.input.mesh), 0);
  EXPECT_EQ(IT::genus(e.input.mesh), 1U) << "a torus";
  EXPECT_EQ(IT::genus(f.input.mesh), 0U) << "a sphere";
  EXPECT_EQ(f.input.mesh.number_of_vertices(), 12U) << "the icosahedron";
}

TEST(Make_domain, closes_the_border_of_a_tufted_cover_only) {
  const Mesh m = meshes::grid(3, 2);
  const IT::Domain tufted = domain(m, Domain_kind::tufted_cover),
                   cover = domain(m, Domain_kind::orientation_cover);
  expect_cover(tufted, m, "tufted");
  expect_cover(cover, m, "orientation");
  EXPECT_EQ(border_edges(tufted.input.mesh), 0U);
  EXPECT_EQ(IT::genus(tufted.input.mesh), 0U);
  EXPECT_EQ(border_edges(cover.input.mesh), 2 * border_edges(domain(m).input.mesh));
  EXPECT_EQ(IT::connected_components(cover.input.mesh).count, 2U);
  EXPECT_EQ(IT::connected_components(tufted.input.mesh).count, 1U);
}

TEST(Make_domain, covers_a_closed_surface_twice) {
  const Mesh m = meshes::box(2, 1, 1);
  const IT::Domain d = domain(m, Domain_kind::tufted_cover);
  expect_cover(d, m, "box");
  EXPECT_EQ(d.input.mesh.number_of_vertices(), 2 * m.points.size());
  EXPECT_EQ(IT::connected_components(d.input.mesh).count, 2U);
}

TEST(Make_domain, takes_random_and_repeated_faces_and_isolated_points) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    const Mesh m = soups::random(4 + seed % 9, 3 + seed, seed);
    const IT::Domain d = domain(m, Domain_kind::tufted_cover);
    expect_cover(d, m, "seed " + std::to_string(seed));
    EXPECT_EQ(border_edges(d.input.mesh), 0U);
  }
  Mesh twice{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {7, 7, 7}},
             {{0, 1, 2}, {1, 2, 0}, {1, 0, 2}, {0, 1, 2}}};
  expect_cover(domain(twice), twice, "four times the same");
  EXPECT_EQ(domain(twice).report.nonmanifold_edges, 3U);
}

TEST(Make_domain, takes_faces_without_area) {
  const Mesh m{{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}},
               {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}, {0, 1, 5}, {0, 5, 3}, {5, 0, 4}}};
  const IT::Domain d = domain(m);
  expect_cover(d, m, "faces without area");
  EXPECT_EQ(border_edges(d.input.mesh), 0U);
}

TEST(Make_domain, splits_vertices_of_a_manifold_only_on_its_cover) {
  const Mesh m{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}};
  EXPECT_EQ(domain(m).report.kind, Domain_kind::manifold);
  EXPECT_EQ(domain(m).input.mesh.number_of_vertices(), 5U);
  const IT::Domain d = domain(m, Domain_kind::orientation_cover);
  expect_cover(d, m, "bow tie");
  EXPECT_EQ(d.input.mesh.number_of_vertices(), 12U);
}

TEST(Make_domain, refuses_what_was_not_asked_for) {
  const auto manifold = [](const Mesh& m) {
    return refusal([&] { domain(m, Domain_kind::manifold); });
  };
  EXPECT_NE(manifold(soups::three_fins()).find("edge (0, 1) has 3 faces (0, 1, 2)"),
            std::string::npos);
  EXPECT_NE(manifold(soups::moebius_strip()).find("only one side"), std::string::npos);
  EXPECT_EQ(manifold(meshes::box(1, 1, 1)), "");
  EXPECT_NE(refusal([] {
              domain(soups::three_fins(), Domain_kind::orientation_cover);
            }).find("take the tufted cover"),
            std::string::npos);
}

TEST(Make_domain, names_what_no_cover_can_mend) {
  const Mesh good = soups::three_fins();
  Mesh m = good;
  m.points[3][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refusal([&] { domain(m); }).find("vertex 3"), std::string::npos);
  m = good;
  m.triangles[2] = {1, 9, 4};
  EXPECT_NE(refusal([&] { domain(m); }).find("face 2"), std::string::npos);
  m.triangles[2] = {1, 4, 1};
  EXPECT_NE(refusal([&] { domain(m); }).find("face 2"), std::string::npos);
}

TEST(Make_domain, covers_gluings_with_lengths) {
  for (const gallery::Surface& s : gallery::all()) {
    const std::vector<double> lengths = gallery::squared_lengths(s);
    for (const Domain_kind kind :
         {Domain_kind::automatic, Domain_kind::orientation_cover, Domain_kind::tufted_cover}) {
      const IT::Intrinsic_input in(IT::Gluing_map(s.gluing), lengths);
      IT::Domain d = IT::make_domain(in, kind);
      const IT::Gluing_map& mesh = d.input.mesh;
      ASSERT_TRUE(IT::is_valid_delta_complex(mesh)) << s;
      EXPECT_TRUE(mesh.is_oriented()) << s;
      EXPECT_EQ(mesh.number_of_faces(), d.report.sheets * s.gluing.number_of_faces()) << s;
      if (kind == Domain_kind::tufted_cover) {
        EXPECT_EQ(border_edges(mesh), 0U) << s;
      }
      // sides of a face keep their lengths: those of faces 2f and 2f + 1 are those of f, in some order
      for (std::uint32_t f = 0; f < mesh.number_of_faces(); ++f) {
        std::multiset<double> here, there;
        for (const auto h : mesh.sides({f})) here.insert(d.input.squared_lengths[h.index / 2]);
        for (const auto h : in.mesh.sides({f / d.report.sheets}))
          there.insert(lengths[h.index / 2]);
        EXPECT_EQ(here, there) << s << ", face " << f;
      }
      const IT::Intrinsic_triangulation<> t(std::move(d.input));
      EXPECT_EQ(t.number_of_vertices(), s.gluing.number_of_vertices) << s;
    }
  }
}

TEST(Make_domain, takes_lengths_of_sides_on_which_both_sides_of_an_edge_agree) {
  for (const gallery::Surface& s : gallery::all()) {
    const IT::Gluing_map mesh(s.gluing);
    const std::vector<double> squares = gallery::squared_lengths(s);
    std::vector<std::array<double, 3>> lengths;
    for (std::uint32_t f = 0; f < mesh.number_of_faces(); ++f) {
      lengths.emplace_back();
      for (std::size_t k = 0; const auto h : mesh.sides({f}))
        lengths.back()[k++] = std::sqrt(squares[h.index / 2]);
    }
    const IT::Domain d = IT::make_domain(IT::Gluing_map(s.gluing), lengths);
    const IT::Domain expected =
        IT::make_domain(IT::Intrinsic_input(IT::Gluing_map(s.gluing), squares));
    ASSERT_EQ(d.input.squared_lengths.size(), expected.input.squared_lengths.size()) << s;
    for (std::size_t e = 0; e < d.input.squared_lengths.size(); ++e)
      EXPECT_DOUBLE_EQ(d.input.squared_lengths[e], expected.input.squared_lengths[e]) << s;
    EXPECT_NE(refusal([&] {
                IT::make_domain(IT::Gluing_map(s.gluing), {lengths.begin() + 1, lengths.end()});
              }).find("give one for each"),
              std::string::npos)
        << s;
    if (border_edges(mesh) != 0) continue;
    lengths[0][1] *= 1.01;
    EXPECT_NE(
        refusal([&] { IT::make_domain(IT::Gluing_map(s.gluing), lengths); }).find("one length"),
        std::string::npos)
        << s;
  }
}

TEST(Make_domain, refuses_lengths_below_zero_and_no_numbers) {
  for (const double x : {-3., std::numeric_limits<double>::quiet_NaN()})
    for (const std::size_t face : {std::size_t(0), std::size_t(1)}) {
      std::vector<std::array<double, 3>> lengths{{3, 4, 5}, {5, 4, 3}};
      lengths[face][face == 0 ? 0 : 2] = x;
      const std::string message = refusal([&] {
        IT::make_domain(3, {{0, 1, 2}, {0, 2, 1}}, lengths);
      });
      EXPECT_NE(message.find("lengths[" + std::to_string(face)), std::string::npos) << message;
      EXPECT_NE(message.find("not negative"), std::string::npos) << message;
    }
}

TEST(Make_domain, covers_meshes_of_cgal) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  CGAL::Surface_mesh<Kernel::Point_3> mesh;
  std::vector<CGAL::Surface_mesh<Kernel::Point_3>::Vertex_index> v;
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
    v.push_back(mesh.add_vertex(Kernel::Point_3(x, y, 0)));
  mesh.add_face(v);
  const IT::Domain d = IT::make_domain(IT::Intrinsic_input(mesh), Domain_kind::tufted_cover);
  EXPECT_EQ(d.input.mesh.number_of_faces(), 4U);
  EXPECT_EQ(d.input.triangulated_polygons, 1U);
  EXPECT_EQ(d.input.names.polygon(3), 0U);
  EXPECT_EQ(IT::make_domain(IT::Intrinsic_input(mesh)).report.kind, Domain_kind::manifold);
}

TEST(Make_domain, glues_faces_that_are_repeated_to_others) {
  Mesh m;
  m.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
  m.triangles = {{0, 1, 2}, {1, 0, 3}, {2, 0, 1}, {0, 1, 2}, {1, 0, 3}, {0, 3, 1}};
  const IT::Domain d = domain(m);
  expect_cover(d, m, "each three times");
  const IT::Gluing_map& mesh = d.input.mesh;
  const auto row = [&](IT::Gluing_map::Vertex v) { return d.input.names.row(v.index); };
  const auto apex = [&](IT::Gluing_map::Halfedge h) { return row(mesh.target(mesh.next(h))); };
  unsigned glued = 0;
  for (std::uint32_t e = 0; e < mesh.number_of_edges(); ++e) {
    const IT::Gluing_map::Halfedge h{2 * e}, o{2 * e + 1};
    if (row(mesh.source(h)) + row(mesh.target(h)) != 1) continue;
    EXPECT_NE(apex(h), apex(o)) << "a face folded on its copy";
    ++glued;
  }
  EXPECT_EQ(glued, 6U);
}

TEST(Make_domain, covers_a_cover) {
  const Mesh m = meshes::grid(2, 2);
  const IT::Domain d =
      IT::make_domain(domain(m, Domain_kind::orientation_cover).input, Domain_kind::tufted_cover);
  EXPECT_EQ(d.report.sheets, 4U);
  EXPECT_EQ(d.input.mesh.number_of_faces(), 4 * m.triangles.size());
  EXPECT_EQ(d.input.names.row_of_vertex.back() + 1, m.points.size());
  EXPECT_EQ(d.input.names.polygon(d.input.mesh.number_of_faces() - 1), m.triangles.size() - 1);
}

} // namespace
