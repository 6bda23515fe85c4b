// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_geodesics/curves/Curve_network.h>
#include <CGAL/Intrinsic_geodesics/curves/insert_polyline.h>
#include <CGAL/Intrinsic_geodesics/cuts/Cut_surface.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_along.h>
#include <CGAL/Intrinsic_geodesics/isolines/isolines.h>
#include <CGAL/Intrinsic_geodesics/queries/add_geodesics.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/domains/triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include "expected_cuts.h"
#include "mesh_types.h"
#include "meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <vector>

// Oracles: planes that cut meshes in space, closed forms of areas and numbers of pieces, Euler's
// formula, and the place of each corner by its labels.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Corresponding_triangulation;
using Curve = IT::Curve_through_vertices<Triangulation>;
using cuts::expect_cut;
using cuts::expect_sides;

Triangulation::vertex_descriptor vertex(const Triangulation& t, std::uint32_t row) {
  return IT::vertex_of_row(t, row);
}

meshes::Mesh torus(std::uint32_t n, std::uint32_t m) {
  meshes::Mesh r;
  const double full = 2 * std::numbers::pi;
  for (std::uint32_t j = 0; j < m; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      const double a = full * i / n, b = full * j / m, d = 3 + std::cos(a);
      r.points.push_back({d * std::cos(b), d * std::sin(b), std::sin(a)});
      const std::uint32_t p = n * j + i, q = n * j + (i + 1) % n, u = n * ((j + 1) % m) + i,
                          v = n * ((j + 1) % m) + (i + 1) % n;
      r.triangles.push_back({p, u, v});
      r.triangles.push_back({p, v, q});
    }
  return r;
}

// The Euler characteristic after a cut, from the numbers of cut edges at the vertices before.
template <class T, class Map>
std::ptrdiff_t predicted_euler_characteristic(const T& t, const Map& marked) {
  std::vector<std::ptrdiff_t> at(t.numbers().vertex_capacity(t.mesh()), 0);
  std::vector<char> is_on_border(at.size(), 0);
  std::ptrdiff_t cut = 0;
  for (const auto e : edges(t.mesh())) {
    const auto h = halfedge(e, t.mesh());
    const bool is_border = CGAL::is_border_edge(h, t.mesh());
    for (const auto v : {source(h, t.mesh()), target(h, t.mesh())}) {
      if (is_border) is_on_border[t.index(v)] = 1;
      if (!is_border && get(marked, e)) ++at[t.index(v)];
    }
    if (!is_border && get(marked, e)) ++cut;
  }
  std::ptrdiff_t result = IT::euler_characteristic(t.mesh()) - cut;
  for (std::size_t v = 0; v < at.size(); ++v)
    if (at[v] > 0) result += is_on_border[v] != 0 ? at[v] : at[v] - 1;
  return result;
}

double area_of_component(const IT::Cut_surface& s, const meshes::Mesh& m, std::uint32_t component) {
  const auto points = IT::positions(s, m.points);
  double sum = 0;
  for (std::uint32_t f = 0; f < s.gluing.number_of_faces(); ++f)
    if (s.component[f] == component)
      sum += cuts::norm(
          cuts::vector_area(points[s.face(f)[0]], points[s.face(f)[1]], points[s.face(f)[2]]));
  return sum;
}

TEST(Cut_along, divides_a_square_by_its_diagonal_and_keeps_all_other_faces_whole) {
  const meshes::Mesh m = meshes::grid(9, 7); // the diagonal passes no other vertex
  Triangulation t(m.input());
  IT::flip_to_delaunay(t);
  IT::Curve_network network(t);
  ASSERT_EQ(IT::add_geodesics(network, std::vector{Curve{{vertex(t, 0), vertex(t, 79)}}}).status,
            IT::Status::done);
  const IT::Cut_surface s = IT::cut_along(network);
  expect_cut(s, m, 1e-9);
  expect_sides(s);
  EXPECT_EQ(s.number_of_components, 2U);
  EXPECT_NEAR(area_of_component(s, m, 0), 31.5, 1e-10);
  EXPECT_NEAR(area_of_component(s, m, 1), 31.5, 1e-10);
  const std::vector<std::size_t> pieces = cuts::pieces(s, m.triangles.size());
  for (std::size_t f = 0; f < pieces.size(); ++f) {
    double low = 0, high = 0; // of the distance from the line, at the corners
    for (const std::uint32_t v : m.triangles[f]) {
      const double d = 9 * m.points[v][1] - 7 * m.points[v][0];
      low = std::min(low, d);
      high = std::max(high, d);
    }
    EXPECT_EQ(pieces[f] > 1, low < 0 && high > 0) << f;
    EXPECT_LE(pieces[f], 3U);
  }
}

TEST(Cut_along, leaves_the_mesh_as_it_is_where_nothing_is_marked) {
  const meshes::Mesh m = meshes::potato(3, 4);
  Triangulation t(m.input());
  IT::delaunay_refine(t);
  const IT::Cut_surface s = IT::cut_along(t, IT::Marked_edges(t));
  ASSERT_EQ(s.gluing.number_of_faces(), m.triangles.size());
  EXPECT_EQ(s.gluing.number_of_vertices, m.points.size());
  EXPECT_EQ(s.number_of_components, 1U);
  EXPECT_TRUE(s.seams.empty());
  expect_cut(s, m);
  expect_sides(s);
  std::vector<std::size_t> once(m.triangles.size(), 1);
  EXPECT_EQ(cuts::pieces(s, m.triangles.size()), once);
}

TEST(Cut_along, makes_a_disk_of_a_torus_by_two_loops_and_an_annulus_by_one) {
  const meshes::Mesh m = torus(9, 13);
  for (const std::size_t loops : {1U, 2U}) {
    Triangulation t(m.input());
    IT::flip_to_delaunay(t);
    IT::Curve_network network(t);
    std::vector<Curve> curves{
        Curve{{vertex(t, 4), vertex(t, 7), vertex(t, 1)}, true},
        Curve{{vertex(t, 4), vertex(t, 40), vertex(t, 76), vertex(t, 100)}, true}};
    curves.resize(loops);
    ASSERT_EQ(IT::add_geodesics(network, curves).status, IT::Status::done);
    const IT::Cut_surface s = IT::cut_along(network);
    expect_cut(s, m);
    expect_sides(s);
    EXPECT_EQ(s.number_of_components, 1U);
    EXPECT_EQ(cuts::euler_characteristic(s), loops == 1 ? 0 : 1);
    EXPECT_EQ(cuts::border_loops(s), loops == 1 ? 2U : 1U);
  }
}

std::vector<double> heights(const meshes::Mesh& m) {
  std::vector<double> z;
  for (const meshes::Point& p : m.points) z.push_back(p[2]);
  return z;
}

TEST(Cut_along, divides_a_sphere_by_two_isolines_into_two_disks_and_a_ring) {
  const meshes::Mesh m = meshes::sphere(4);
  const std::vector<double> z = heights(m), levels{-0.3, 0.4};
  Triangulation t(m.input());
  const auto labels = IT::insert_isolines(t, IT::isolines(t, z, levels));
  const IT::Cut_surface s = IT::cut_along(t, labels);
  expect_cut(s, m);
  expect_sides(s);
  ASSERT_EQ(s.number_of_components, 3U);
  EXPECT_EQ(cuts::euler_characteristic(s), 2);
  EXPECT_EQ(cuts::border_loops(s), 4U);
  const auto points = IT::positions(s, m.points);
  std::array<double, 3> low{2, 2, 2}, high{-2, -2, -2};
  for (std::uint32_t f = 0; f < s.gluing.number_of_faces(); ++f)
    for (const std::uint32_t v : s.face(f)) {
      low[s.component[f]] = std::min(low[s.component[f]], points[v][2]);
      high[s.component[f]] = std::max(high[s.component[f]], points[v][2]);
    }
  std::ranges::sort(low);
  std::ranges::sort(high);
  for (std::size_t i = 0; i < 2; ++i) { // each component is between levels
    EXPECT_NEAR(high[i], levels[i], 1e-12);
    EXPECT_NEAR(low[i + 1], levels[i], 1e-12);
  }
  for (std::uint32_t h = 0; h < s.sides.size(); ++h)
    if (s.sides[h].curve != 0) {
      EXPECT_NEAR(points[s.gluing.origin[h]][2], levels[s.sides[h].curve - 1], 1e-12);
    }
}

TEST(Cut_along, decides_exactly_where_isolines_pass_vertices_and_run_along_edges) {
  const meshes::Mesh m = meshes::box(4, 4, 4);
  const std::vector<double> z = heights(m);
  double top = z[0];
  for (const double x : z) top = std::max(top, x);
  for (const double level : {top / 4, top / 2, 3 * top / 4}) {
    Triangulation t(m.input());
    const auto labels = IT::insert_isolines(t, IT::isolines(t, z, std::vector{level}));
    const IT::Cut_surface s = IT::cut_along(t, labels);
    expect_cut(s, m);
    expect_sides(s);
    EXPECT_EQ(s.number_of_components, 2U);
    EXPECT_EQ(s.gluing.number_of_faces(), m.triangles.size()); // along edges: all are whole
    EXPECT_EQ(cuts::euler_characteristic(s), 2);
  }
}

// At the level of a vertex but for rounding, other pieces of the line end at that vertex, too.
TEST(Cut_along, cutsAlongIsolinesThatMissVerticesByRounding) {
  const meshes::Mesh m = meshes::box(2, 2, 2);
  std::mt19937 random(1);
  std::uniform_int_distribution<int> units(-2, 2);
  for (int i = 0; i < 50; ++i) {
    std::vector<double> z;
    for (const double x : heights(m)) z.push_back(x + 0x1p-52 * units(random));
    const double top = *std::max_element(z.begin(), z.end());
    Triangulation t(m.input());
    const IT::Cut_surface s =
        IT::cut_along(t, IT::insert_isolines(t, IT::isolines(t, z, std::vector{top / 2})));
    expect_cut(s, m);
  }
}

// A square with coincident vertices: faces between them become needles of width 1e-11.
meshes::Mesh square_with_needles(unsigned seed) {
  constexpr std::uint32_t n = 9;
  meshes::Mesh m;
  for (std::uint32_t i = 0; i < n * n; ++i)
    m.points.push_back({(i % n) / (n - 1.), (i / n) / (n - 1.), 0});
  for (std::uint32_t y = 0; y + 1 < n; ++y)
    for (std::uint32_t x = 0; x + 1 < n; ++x) {
      const std::uint32_t v = n * y + x;
      m.triangles.push_back({v, v + 1, v + n + 1});
      m.triangles.push_back({v, v + n + 1, v + n});
    }
  std::mt19937 random(seed);
  std::uniform_int_distribution<std::uint32_t> column(1, n - 3);
  for (const std::uint32_t y : {2U, 4U, 6U}) {
    const std::uint32_t v = n * y + column(random);
    m.points[v] = m.points[v + 1];
  }
  return m;
}

// The part of the unit square where x + y/4 is less than c.
double area_below(double c) {
  const auto triangle = [](double x) { return x > 0 ? 2 * x * x : 0; };
  return triangle(c) - triangle(c - 0.25) - triangle(c - 1) + triangle(c - 1.25);
}

TEST(Cut_along, cutsNeedlesOfCoincidentVerticesAlongIsolines) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const meshes::Mesh m = square_with_needles(seed);
    std::vector<double> u, levels;
    for (const auto& p : m.points) u.push_back(p[0] + p[1] / 4);
    for (int k = 1; k <= 6; ++k) levels.push_back(1.25 * k / 7.);
    Triangulation t(m.input(IT::Mollification::automatic));
    IT::flip_to_delaunay(t);
    const IT::Cut_surface s =
        IT::cut_along(t, IT::insert_isolines(t, IT::isolines(t, u, levels)));
    const auto points = IT::positions(s, m.points);
    for (const double level : levels) {
      double area = 0;
      for (std::uint32_t f = 0; f < s.gluing.number_of_faces(); ++f) {
        const auto face = s.face(f);
        const auto &p = points[face[0]], &q = points[face[1]], &r = points[face[2]];
        if ((p[0] + q[0] + r[0]) / 3 + (p[1] + q[1] + r[1]) / 12 < level)
          area += ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])) / 2;
      }
      EXPECT_NEAR(area, area_below(level), 1e-10) << level;
    }
  }
}

// A random network of shortest paths on a triangulation that was flipped and refined.
template <class T>
void expect_random_cuts(const meshes::Mesh& m, unsigned seed, bool is_refined) {
  std::mt19937 random(seed);
  T t(m.input());
  IT::flip_to_delaunay(t);
  if (is_refined) IT::delaunay_refine(t);
  IT::Curve_network<T> network(t);
  std::vector<IT::Curve_through_vertices<T>> curves;
  std::uniform_int_distribution<std::uint32_t> row(0,
                                                   static_cast<std::uint32_t>(m.points.size() - 1));
  for (int i = 0; i < 4; ++i) {
    const std::uint32_t a = row(random);
    const std::uint32_t b =
        (a + 1 + row(random) % static_cast<std::uint32_t>(m.points.size() - 1)) %
        static_cast<std::uint32_t>(m.points.size());
    curves.push_back({{IT::vertex_of_row(t, a), IT::vertex_of_row(t, b)}, false, false});
  }
  if (IT::add_geodesics(network, curves).status != IT::Status::done) return; // not connected
  const auto labels = IT::curve_labels(network);
  const IT::Cut_surface s = IT::cut_along(t, labels);
  expect_cut(s, m);
  expect_sides(s);
  EXPECT_EQ(cuts::euler_characteristic(s), predicted_euler_characteristic(t, labels));
  std::vector<char> is_seen(curves.size(), 0);
  for (const IT::Cut_surface::Side& side : s.sides)
    if (side.curve != 0) is_seen[side.curve - 1] = 1;
  EXPECT_EQ(std::ranges::count(is_seen, 1), 4);
}

TEST(Cut_along, conserves_areas_and_predicts_the_topology_of_random_networks) {
  using Exact = IT::Exact_euclidean_traits;
  for (unsigned seed = 1; seed <= 6; ++seed)
    for (const meshes::Mesh& m : {meshes::rough_grid(9, seed), meshes::potato(2, seed),
                                  meshes::random_planar(60, 1000, seed), meshes::box(3, 2, 4)}) {
      SCOPED_TRACE(seed);
      expect_random_cuts<Triangulation>(m, seed, seed % 2 == 0);
      expect_random_cuts<
          IT::Intrinsic_triangulation<IT::Gluing_map, Exact, IT::Explicit_crossings>>(m, seed,
                                                                                      false);
      if (seed < 3)
        expect_random_cuts<IT::Intrinsic_triangulation<IT::Gluing_map, Exact, IT::Signposts>>(
            m, seed, false);
    }
}

TEST(Cut_along, opens_slits_and_holes_inside_of_one_face) {
  const meshes::Mesh m{{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}}, {{0, 1, 2}}};
  Triangulation t(m.input());
  const std::uint32_t h = t.input().halfedge_of_face(0);
  const auto at = [&](double x, double y) {
    return IT::Surface_point{h, {1 - x / 8 - y / 8, x / 8, y / 8}};
  };
  IT::Marked_edges<Triangulation, std::uint32_t> labels(t);
  const auto insert = [&](const std::vector<IT::Surface_point>& points, std::uint32_t label) {
    const auto path = IT::insert_polyline(t, points);
    ASSERT_EQ(path.status, IT::Move_status::done);
    for (const auto g : path.halfedges) put(labels, edge(g, t.mesh()), label);
  };
  insert({at(1, 1), at(2, 1), at(2, 2), at(1, 2), at(1, 1)}, 1);
  insert({at(4, 1), at(5, 1.5)}, 2);
  insert({at(1, 4), at(0, 5)}, 3); // to the border
  const IT::Cut_surface s = IT::cut_along(t, labels);
  expect_cut(s, m, 1e-6);
  expect_sides(s);
  EXPECT_EQ(s.number_of_components, 2U);
  // the square, and a disk with two holes, whose border the third cut does not divide
  EXPECT_EQ(cuts::euler_characteristic(s), 1 + (1 - 2));
  EXPECT_EQ(cuts::border_loops(s), 1U + 3U);
  // corners, those of the square twice, ends of cuts, and points where a cut crosses edges of t
  EXPECT_GE(s.vertices.size(), 3U + 4U + 2U + 2U + 4U + 1U);
  EXPECT_LE(s.vertices.size(), 3U * 3U * (4U + 1U + 1U));
}

TEST(Cut_along, builds_meshes_of_all_types_with_values_of_vertices_and_corners) {
  const meshes::Mesh m = meshes::rough_grid(5, 8);
  Triangulation t(m.input());
  IT::flip_to_delaunay(t);
  IT::Curve_network network(t);
  ASSERT_EQ(IT::add_geodesics(network, std::vector{Curve{{vertex(t, 0), vertex(t, 35)}}}).status,
            IT::Status::done);
  const IT::Cut_surface s = IT::cut_along(network);
  const auto points = IT::positions(s, m.points);
  const auto expect_mesh = [&](auto mesh) {
    IT::copy_cut_surface(s, points, mesh);
    using Adaptor = IT::Mesh_adaptor<decltype(mesh)>;
    std::size_t i = 0;
    for (const auto v : vertices(mesh))
      EXPECT_EQ(Adaptor::coordinates(get(Adaptor::point_map(mesh), v)), points[i++]);
    EXPECT_EQ(i, points.size());
    EXPECT_EQ(num_faces(mesh), s.gluing.number_of_faces());
    EXPECT_EQ(IT::connected_components(mesh).of_face, s.component);
  };
  expect_mesh(Surface_mesh());
  expect_mesh(Polyhedron_with_ids());
  expect_mesh(OpenMesh_triangles());
  std::vector<double> x, of_corners;
  for (const meshes::Point& p : m.points) x.push_back(p[0]);
  const std::vector<double> at_vertices = IT::values_at_vertices(s, x);
  for (std::size_t v = 0; v < points.size(); ++v) EXPECT_NEAR(at_vertices[v], points[v][0], 1e-12);
  for (const meshes::Triangle& f : m.triangles)
    for (const std::uint32_t v : f) of_corners.push_back(x[v]);
  const std::vector<double> at_corners = IT::values_at_corners(s, of_corners);
  for (std::size_t c = 0; c < at_corners.size(); ++c)
    EXPECT_NEAR(at_corners[c], points[s.gluing.origin[c]][0], 1e-12);
  EXPECT_THROW(IT::values_at_vertices(s, of_corners), IT::Invalid_input);
  EXPECT_THROW(IT::values_at_corners(s, x), IT::Invalid_input);
  Surface_mesh mesh;
  EXPECT_THROW(IT::copy_cut_surface(s, m.points, mesh), IT::Invalid_input);
}

TEST(Cut_along, refuses_covers_and_curves_that_are_points) {
  const IT::Domain domain = IT::make_domain(IT::triangle_soup(
      std::vector<std::array<double, 3>>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}},
      std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}));
  const Triangulation cover(domain.input);
  EXPECT_THROW(IT::cut_along(cover, IT::Marked_edges(cover)), IT::Invalid_input);
  Triangulation t(meshes::sphere(1).input());
  IT::Curve_network network(t);
  const auto h = halfedge(vertex(t, 0), t.mesh());
  network.add_loop(std::vector{h, opposite(h, t.mesh())});
  EXPECT_THROW(IT::cut_along(network), IT::Invalid_input);
}

} // namespace
