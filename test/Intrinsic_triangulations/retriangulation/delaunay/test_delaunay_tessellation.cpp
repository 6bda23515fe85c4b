// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/delaunay_tessellation.h>

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include "gallery.h"
#include "mesh_types.h"
#include "meshes.h"
#include "oracle.h"

#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Exact = IT::Intrinsic_triangulation<>;
using Polygon = std::vector<std::uint32_t>;

template <class Mesh>
std::map<typename boost::graph_traits<Mesh>::vertex_descriptor, std::uint32_t>
numbers(const Mesh& mesh) {
  std::map<typename boost::graph_traits<Mesh>::vertex_descriptor, std::uint32_t> result;
  std::uint32_t n = 0;
  for (const auto v : vertices(mesh)) result[v] = n++;
  return result;
}

/// The vertices of each cell counterclockwise from the smallest, sorted.
template <class Mesh>
std::vector<Polygon> cells(const Mesh& mesh) {
  auto number = numbers(mesh);
  std::vector<Polygon> result;
  for (const auto f : faces(mesh)) {
    Polygon p;
    auto h = halfedge(f, mesh);
    do {
      p.push_back(number[source(h, mesh)]);
      h = next(h, mesh);
    } while (h != halfedge(f, mesh));
    Polygon least = p;
    for (std::size_t k = 0; k < p.size(); ++k) {
      std::rotate(p.begin(), p.begin() + 1, p.end());
      least = std::min(least, p);
    }
    result.push_back(least);
  }
  std::sort(result.begin(), result.end());
  return result;
}

template <class T>
Surface_mesh tessellation(T t) {
  IT::flip_to_delaunay(t);
  Surface_mesh mesh;
  IT::delaunay_tessellation(t, mesh);
  return mesh;
}

template <class Mesh>
class Tessellation_of_mesh : public ::testing::Test {};
using Polygon_meshes =
    ::testing::Types<Surface_mesh, Polyhedron, Polyhedron_with_ids, OpenMesh_polygons>;
TYPED_TEST_SUITE(Tessellation_of_mesh, Polygon_meshes);

TYPED_TEST(Tessellation_of_mesh, of_a_box_has_its_squares_as_cells) {
  Exact t(meshes::box(2, 3, 4).input());
  IT::flip_to_delaunay(t);
  TypeParam mesh;
  const IT::Delaunay_tessellation d = IT::delaunay_tessellation(t, mesh);
  const std::size_t squares = 2 * (2 * 3 + 3 * 4 + 4 * 2);
  EXPECT_EQ(num_faces(mesh), squares);
  EXPECT_EQ(d.number_of_cells, squares);
  EXPECT_EQ(num_edges(mesh), 2 * squares);
  EXPECT_EQ(num_vertices(mesh), num_vertices(t.mesh()));
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  EXPECT_TRUE(CGAL::is_closed(mesh));
  EXPECT_TRUE(CGAL::is_quad_mesh(mesh));
}

TEST(Delaunay_tessellation, of_a_grid_has_its_border) {
  const Surface_mesh mesh = tessellation(Exact(meshes::grid(4, 3).input()));
  EXPECT_EQ(num_faces(mesh), 12U);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  std::size_t border = 0;
  for (const auto h : halfedges(mesh))
    if (CGAL::is_border(h, mesh)) ++border;
  EXPECT_EQ(border, 14U);
  for (const auto v : vertices(mesh))
    EXPECT_TRUE(mesh.is_border(v) == mesh.is_border(mesh.halfedge(v)));
}

TEST(Delaunay_tessellation, of_regular_polygons_that_stand_on_each_other_has_them_as_cells) {
  // a hexagonal prism: integer coordinates of a hexagon in a circle of radius 5 sqrt 13
  const std::vector<std::pair<int, int>> circle{{18, 1},   {15, 10},  {6, 17},
                                                {-10, 15}, {-17, -6}, {1, -18}};
  meshes::Mesh m;
  const auto n = static_cast<std::uint32_t>(circle.size());
  for (const double z : {0., 3.})
    for (const auto& [x, y] : circle)
      m.points.push_back({static_cast<double>(x), static_cast<double>(y), z});
  for (std::uint32_t i = 0; i + 2 < n; ++i) {
    m.triangles.push_back({0, i + 2, i + 1});
    m.triangles.push_back({n, n + i + 1, n + i + 2});
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    m.triangles.push_back({i, j, n + j});
    m.triangles.push_back({i, n + j, n + i});
  }
  std::vector<std::size_t> sides;
  for (const Polygon& p : cells(tessellation(Exact(m.input())))) sides.push_back(p.size());
  std::sort(sides.begin(), sides.end());
  // long walls may be cut, but top and bottom have the largest empty circles there
  ASSERT_EQ(sides.size(), 8U);
  EXPECT_EQ(sides, (std::vector<std::size_t>{4, 4, 4, 4, 4, 4, 6, 6}));
}

std::vector<std::pair<std::string, meshes::Mesh>> all_meshes() {
  return {{"box", meshes::box(2, 3, 1)},
          {"sheared grid", meshes::sheared_grid(4, 4, 3)},
          {"stairs", meshes::stairs(3, 4)},
          {"sheared stairs", meshes::stairs(3, 4, 2)},
          {"folded lattice", meshes::folded_lattice(4, 6, 1)},
          {"potato", meshes::potato(1, 6)},
          {"l shape", meshes::l_shape(3)}};
}

TEST(Delaunay_tessellation, has_the_edges_that_an_independent_implementation_finds) {
  for (const auto& [name, m] : all_meshes()) {
    Exact t(m.input());
    IT::flip_to_delaunay(t);
    Surface_mesh mesh;
    const IT::Delaunay_tessellation d = IT::delaunay_tessellation(t, mesh);
    auto number = numbers(mesh);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> found, expected;
    for (const auto e : edges(mesh))
      found.push_back(std::minmax(number[source(e, mesh)], number[target(e, mesh)]));
    for (const auto& [i, j, squared] : oracle::delaunay(m).tessellation)
      expected.emplace_back(i, j);
    std::sort(found.begin(), found.end());
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(found, expected) << name;
    // each edge of the mesh is the intrinsic edge that it is said to be
    std::size_t i = 0;
    for (const auto e : edges(mesh)) {
      const auto h = t.numbers().halfedge_at(2 * d.intrinsic_edge[i++]);
      EXPECT_EQ(number[target(halfedge(e, mesh), mesh)], t.input_vertex(target(h, t.mesh())));
      EXPECT_EQ(number[source(halfedge(e, mesh), mesh)], t.input_vertex(source(h, t.mesh())));
    }
    // a polygon of n sides is cut into n - 2 faces
    std::vector<std::size_t> parts(d.number_of_cells, 0);
    for (const auto f : faces(t.mesh())) ++parts[d.cell[t.index(f)]];
    i = 0;
    for (const auto f : faces(mesh)) EXPECT_EQ(degree(f, mesh), parts[i++] + 2) << name;
  }
}

TEST(Delaunay_tessellation, is_the_same_whichever_triangulation_it_is_made_of) {
  for (const auto& [name, m] : all_meshes()) {
    const std::vector<Polygon> expected = cells(tessellation(Exact(m.input())));
    for (unsigned seed = 1; seed <= 3; ++seed) {
      Exact t(m.input());
      std::vector<Exact::edge_descriptor> all(edges(t.mesh()).begin(), edges(t.mesh()).end());
      std::mt19937 random(seed);
      for (int i = 0; i < 60; ++i) t.flip_edge(halfedge(all[random() % all.size()], t.mesh()));
      EXPECT_EQ(cells(tessellation(t)), expected) << name << ' ' << seed;
      // vertices that have other numbers
      const auto order = meshes::permutation(m.points.size(), seed);
      std::vector<Polygon> renamed =
          cells(tessellation(Exact(meshes::permuted(m, order, seed).input())));
      std::vector<std::uint32_t> back(order.size());
      for (std::uint32_t v = 0; v < order.size(); ++v) back[order[v]] = v;
      for (Polygon& p : renamed) {
        for (std::uint32_t& v : p) v = back[v];
        std::rotate(p.begin(), std::min_element(p.begin(), p.end()), p.end());
      }
      std::sort(renamed.begin(), renamed.end());
      EXPECT_EQ(renamed, expected) << name << ' ' << seed;
    }
  }
}

TEST(Delaunay_tessellation, of_delta_complexes_keeps_the_surface) {
  for (const gallery::Surface& s : gallery::oriented()) {
    Exact t(gallery::input(s));
    IT::flip_to_delaunay(t);
    Surface_mesh mesh;
    const IT::Delaunay_tessellation d = IT::delaunay_tessellation(t, mesh);
    const auto euler = static_cast<std::ptrdiff_t>(num_vertices(mesh) + num_faces(mesh)) -
                       static_cast<std::ptrdiff_t>(num_edges(mesh));
    EXPECT_EQ(euler, s.euler_characteristic()) << s;
    for (const auto h : halfedges(mesh)) {
      EXPECT_EQ(target(h, mesh), source(next(h, mesh), mesh)) << s;
      EXPECT_EQ(face(h, mesh), face(next(h, mesh), mesh)) << s;
    }
    for (const auto f : faces(t.mesh())) EXPECT_LT(d.cell[t.index(f)], num_faces(mesh)) << s;
  }
  Exact torus(IT::Intrinsic_input(IT::Gluing_map(gallery::one_vertex_torus().gluing),
                                  gallery::squared_lengths(gallery::one_vertex_torus())));
  const Surface_mesh square = tessellation(torus);
  EXPECT_EQ(num_faces(square), 1U);
  EXPECT_EQ(num_edges(square), 2U);
  EXPECT_EQ(degree(*faces(square).begin(), square), 4U);
}

TEST(Delaunay_tessellation, of_a_refined_triangulation_has_its_inserted_vertices) {
  IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, IT::Integer_coordinates>
      t(meshes::grid(3, 3).input());
  IT::delaunay_refine(t, IT::parameters::minimum_angle(0).maximum_edge_length(0.8));
  Surface_mesh mesh;
  IT::delaunay_tessellation(t, mesh);
  EXPECT_EQ(num_vertices(mesh), num_vertices(t.mesh()));
  EXPECT_LT(num_faces(mesh), num_faces(t.mesh()));
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
}

} // namespace
