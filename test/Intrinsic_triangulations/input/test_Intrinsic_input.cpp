// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gallery.h"
#include "meshes.h"
#include "properties.h"
#include "refusals.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

using Exact = IT::Intrinsic_triangulation<>;
using Double = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>>;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using IT::Element_kind;

// builds both, and checks that the message names the element
template <class Make>
void expect_invalid(const Make& make, Element_kind kind, std::size_t index,
                    const std::string& text) {
  const auto i = kind == Element_kind::none ? std::optional<std::size_t>() : index;
  refusals::expect_invalid([&] { Exact t(make()); }, kind, i, {text});
  refusals::expect_invalid([&] { Double t(make()); }, kind, i, {text});
}

TEST(Intrinsic_input, polygonal_faces_of_a_mesh_are_triangulated_and_counted) {
  Surface_mesh mesh;
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}})
    mesh.add_vertex(Kernel::Point_3(x, y, 0));
  using V = Surface_mesh::Vertex_index;
  mesh.add_face(V(1), V(4), V(2));
  mesh.add_face(V(0), V(1), V(2), V(3));
  const IT::Intrinsic_input input(mesh);
  EXPECT_EQ(input.triangulated_polygons, 1U);
  EXPECT_EQ(input.mesh.number_of_faces(), 3U);
  EXPECT_EQ(input.mesh.number_of_edges(), 7U);
}

TEST(Intrinsic_input, coordinates_that_are_not_finite_are_named) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    meshes::Mesh m = meshes::box(1, 1, 1);
    m.points[5][0] = bad;
    expect_invalid([&] { return m.input(); }, Element_kind::vertex, 5, "vertex 5");
  }
}

TEST(Intrinsic_input, a_mesh_without_faces_is_refused) {
  expect_invalid([] { return IT::Intrinsic_input(); }, Element_kind::none, 0, "no faces");
  expect_invalid([] { return IT::Intrinsic_input(Surface_mesh()); }, Element_kind::none, 0,
                 "no faces");
}

TEST(Intrinsic_input, a_nonorientable_gluing_is_refused) {
  const gallery::Surface s = gallery::klein_bottle();
  expect_invalid([&] { return gallery::input(s); }, Element_kind::none, 0, "orient");
}

TEST(Intrinsic_input, lengths_that_violate_the_triangle_inequality_are_named) {
  const gallery::Surface s = gallery::triangle_pillow();
  std::vector<double> l = gallery::squared_lengths(s);
  l[0] = 4.5;
  expect_invalid([&] { return IT::Intrinsic_input(IT::Gluing_map(s.gluing), l); },
                 Element_kind::face, 0, "face 0");
  l[0] = -1;
  expect_invalid([&] { return IT::Intrinsic_input(IT::Gluing_map(s.gluing), l); },
                 Element_kind::edge, 0, "edge 0");
}

TEST(Intrinsic_input, isolated_vertices_and_several_components_are_kept) {
  meshes::Mesh m = meshes::box(1, 1, 1);
  m.points.push_back({7, 7, 7});
  const auto n = static_cast<std::uint32_t>(m.points.size());
  const meshes::Mesh other = meshes::translated(meshes::potato(1, 1), {20, 0, 0});
  m.points.insert(m.points.end(), other.points.begin(), other.points.end());
  for (const auto& [a, b, c] : other.triangles) m.triangles.push_back({a + n, b + n, c + n});
  Exact t(m.input());
  EXPECT_EQ(num_vertices(t.mesh()), m.points.size());
  EXPECT_EQ(IT::flip_to_delaunay(t).status, IT::Status::done);
  EXPECT_EQ(properties::euler_characteristic(t), 2 + 2 + 1);
}

TEST(Intrinsic_input, two_faces_on_the_same_three_vertices_are_a_sphere) {
  const meshes::Mesh m{{{0, 0, 0}, {9, 0, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 0, 2}}};
  Exact t(m.input());
  const auto r = IT::flip_to_delaunay(t);
  EXPECT_EQ(r.status, IT::Status::done);
  EXPECT_EQ(properties::euler_characteristic(t), 2);
  EXPECT_NEAR(properties::total_area(t), 9, 1e-12);
}

TEST(Intrinsic_input, every_surface_of_the_gallery_becomes_delaunay) {
  for (const gallery::Surface& s : gallery::oriented()) {
    Exact t(gallery::input(s));
    IT::flip_to_delaunay(t);
    EXPECT_TRUE(IT::is_delaunay(t)) << s;
    EXPECT_EQ(properties::euler_characteristic(t), s.euler_characteristic()) << s;
  }
}

TEST(Intrinsic_input, a_bad_numbering_is_improved_and_mapped_back) {
  const meshes::Mesh tidy = meshes::rough_grid(260, 5);
  const auto order = meshes::permutation(tidy.points.size(), 11);
  const meshes::Mesh m = meshes::permuted(tidy, order, 12);
  Double t(m.input());
  ASSERT_TRUE(t.report().renumbered);
  for (const auto e : edges(t.mesh())) {
    const auto& p = m.points[t.input_vertex(source(e, t.mesh()))];
    const auto& q = m.points[t.input_vertex(target(e, t.mesh()))];
    const double length = (p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) +
                          (p[2] - q[2]) * (p[2] - q[2]);
    ASSERT_NEAR(t.squared_length(e), length, 1e-14 * length);
  }
  IT::Intrinsic_input in = m.input();
  in.may_renumber = false;
  Double u(std::move(in));
  EXPECT_FALSE(u.report().renumbered);
  IT::flip_to_delaunay(t);
  IT::flip_to_delaunay(u);
  properties::expect_same_laplacian(properties::laplacian(t), properties::laplacian(u), 1e-8);
}

TEST(Intrinsic_input, reads_a_mesh_with_any_point_map_and_after_removals) {
  Surface_mesh mesh;
  const meshes::Mesh m = meshes::box(2, 1, 1);
  mesh.add_vertex(Kernel::Point_3(9, 9, 9));
  for (const auto& p : m.points) mesh.add_vertex(Kernel::Point_3(p[0], p[1], p[2]));
  using V = Surface_mesh::Vertex_index;
  for (const auto& [a, b, c] : m.triangles) mesh.add_face(V(a + 1), V(b + 1), V(c + 1));
  mesh.remove_vertex(V(0));
  auto doubled = mesh.add_property_map<V, Kernel::Point_3>("v:doubled").first;
  for (const V v : mesh.vertices()) doubled[v] = CGAL::ORIGIN + 2 * (mesh.point(v) - CGAL::ORIGIN);
  Exact t(mesh), u(IT::Intrinsic_input(mesh, doubled, IT::Mollification::none)),
      expected(m.input());
  EXPECT_EQ(num_vertices(t.mesh()), m.points.size());
  EXPECT_EQ(properties::tessellation(t), properties::tessellation(expected));
  EXPECT_EQ(properties::total_area(u), 4 * properties::total_area(expected));
}

TEST(Intrinsic_input, takes_a_triangle_soup_as_the_gluing_of_its_triangles) {
  const meshes::Mesh m = meshes::rough_grid(3, 1);
  IT::Triangle_soup soup;
  soup.points = m.points;
  soup.triangles = m.triangles;
  Exact t(soup), expected(m.input());
  IT::flip_to_delaunay(t);
  IT::flip_to_delaunay(expected);
  EXPECT_EQ(properties::laplacian(t), properties::laplacian(expected));
}

TEST(Intrinsic_input, asks_for_one_point_per_vertex_and_one_length_per_edge) {
  const meshes::Mesh m = meshes::grid(1, 1); // 4 vertices, 5 edges
  for (const std::size_t given : {3U, 5U})
    expect_invalid(
        [&] {
          IT::Intrinsic_input input = m.input();
          input.points.resize(given);
          return input;
        },
        Element_kind::none, 0, std::to_string(given) + " points for 4 vertices");
  for (const std::size_t given : {4U, 6U})
    expect_invalid([&] { return IT::Intrinsic_input(m.map(), std::vector<double>(given, 1.0)); },
                   Element_kind::none, 0, std::to_string(given) + " squared lengths for 5 edges");
}

} // namespace
