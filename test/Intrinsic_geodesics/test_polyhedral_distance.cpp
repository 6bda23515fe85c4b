// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_shortest_path.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include "gallery.h"
#include "meshes.h"
#include "numbered_as_mesh.h"
#include "paths.h"
#include "surface_mesh.h"
#include "triangulation_archetypes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

// Oracles: closed forms, where the surface unfolds; CGAL's own algorithm, on meshes in space; and the fact that distances do
// not depend on the triangulation.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
namespace parameters = IT::parameters;
using IT::Polyhedral_distance;
using IT::Shortest_path;
using IT::Status;
using IT::Surface_point;
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                                  IT::Integer_coordinates>;
using Vertex = Triangulation::vertex_descriptor;
using Distance = Polyhedral_distance<Triangulation>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double pi = std::numbers::pi;

Vertex vertex(const Triangulation& t, std::uint32_t i) { return t.numbers().vertex_at(i); }

/// The point of a face with weights of its corners in order.
template <class T>
Surface_point point(const T& t, std::uint32_t face, const std::array<double, 3>& weights) {
  return {t.numbers().halfedge(halfedge(t.numbers().face_at(face), t.mesh())), weights};
}

/// Whether the path that is found has the length that is claimed, measured piece by piece.
template <class T, class Place>
void expect_path(const T& t, const Polyhedral_distance<T>& d, const Place& p, double tolerance) {
  const Shortest_path path = d.shortest_path(p);
  EXPECT_EQ(path.status, Status::done);
  EXPECT_EQ(path.length, d.distance(p));
  EXPECT_NEAR(paths::length_of_path(t, path.points), path.length, tolerance);
}

// A triangulation without a name would end before the object that searches it.
static_assert(std::constructible_from<Distance, const Triangulation&, Vertex>);
static_assert(!std::constructible_from<Distance, Triangulation>);
static_assert(!std::constructible_from<Distance, Triangulation, Vertex>);

// ---- closed forms

TEST(PolyhedralDistance, tetrahedron_unfolds) {
  const gallery::Surface s = gallery::tetrahedron(); // sides of length sqrt(2)
  const Triangulation t(gallery::input(s));
  const Distance d(t, vertex(t, 0));
  for (std::uint32_t v = 1; v < 4; ++v) EXPECT_NEAR(d.distance(vertex(t, v)), std::sqrt(2), 1e-15);
  // the face opposite: straight across the middle of one of its sides
  const Surface_point centroid = point(t, 2, {1. / 3, 1. / 3, 1. / 3});
  EXPECT_NEAR(d.distance(centroid), std::sqrt(8. / 3), 1e-15);
  expect_path(t, d, centroid, 1e-15);
  // the same point as CGAL names it, as place and as source
  const IT::Face_location<Triangulation::Mesh> named(t.numbers().face_at(2), centroid.weights);
  EXPECT_EQ(d.distance(named), d.distance(centroid));
  EXPECT_EQ(Distance(t, named).distances(), Distance(t, centroid).distances());
}

// Kotani's ant: the farthest point of a box of 1 x 1 x 2 from a corner is not the opposite one.
TEST(PolyhedralDistance, farthest_point_of_a_box_is_not_the_opposite_corner) {
  const meshes::Mesh m = meshes::box(1, 1, 2);
  const Triangulation t = numbered_as<Triangulation>(m);
  const Distance d(t, vertex(t, 0));
  ASSERT_EQ(m.points[0], (meshes::Point{0, 0, 0}));
  double farthest = 0;
  for (std::uint32_t f = 0; f < m.triangles.size(); ++f)
    for (int i = 0; i <= 16; ++i)
      for (int j = 0; i + j <= 16; ++j)
        farthest =
            std::max(farthest, d.distance(point(t, f, {(16 - i - j) / 16., i / 16., j / 16.})));
  EXPECT_NEAR(farthest, std::sqrt(130) / 4, 1e-14); // at (3/4, 3/4, 2)
}

TEST(PolyhedralDistance, pillow_is_crossed_at_the_middle_of_its_sides) {
  const Triangulation t(gallery::input(gallery::triangle_pillow()));
  const Distance d(t, point(t, 0, {1. / 3, 1. / 3, 1. / 3}));
  const Surface_point other = point(t, 1, {1. / 3, 1. / 3, 1. / 3});
  EXPECT_NEAR(d.distance(other), 1 / std::sqrt(3), 1e-15);
  EXPECT_EQ(d.distance(point(t, 0, {1. / 3, 1. / 3, 1. / 3})), 0);
  for (const Vertex v : vertices(t.mesh())) EXPECT_NEAR(d.distance(v), 1 / std::sqrt(3), 1e-15);
  expect_path(t, d, other, 1e-15);
}

/// Isosceles triangles with legs 1 around a point, glued to a cone of a total angle.
gallery::Surface cone(std::uint32_t n, double total) {
  std::vector<gallery::Glued> pairs;
  for (std::uint32_t i = 0; i < n; ++i) pairs.push_back({3 * i + 2, 3 * ((i + 1) % n)});
  const double chord = 2 * std::sin(total / n / 2);
  return gallery::abstract("cone", gallery::glue(n, pairs), {n + 1, 2 * n, n, 1},
                           {1, chord * chord, 1});
}

/// The point of a cone with polar coordinates, if it is there: its distance from the apex and its direction.
Surface_point polar(const Triangulation& t, std::uint32_t n, double total, double r,
                    double direction) {
  const double sector = total / n;
  const auto face = std::min(n - 1, static_cast<std::uint32_t>(direction / sector));
  const double angle = direction - face * sector;
  const double second = r * std::sin(angle) / std::sin(sector);
  const double first = r * std::sin(sector - angle) / std::sin(sector);
  // the halfedge that leaves the apex, vertex 0
  auto h = halfedge(t.numbers().face_at(face), t.mesh());
  while (t.index(source(h, t.mesh())) != 0) h = next(h, t.mesh());
  return {t.numbers().halfedge(h), {1 - first - second, first, second}};
}

// Both with a convex apex, around which paths have to go on one side or the other, and with a saddle, which they go through.
TEST(PolyhedralDistance, cones_of_any_angle_obey_the_law_of_cosines) {
  std::mt19937 random(5);
  for (const std::uint32_t n : {1U, 2U, 3U, 5U, 12U, 31U})
    for (const double total : {0.3, 1.9, pi, 4.0, 2 * pi, 6.5, 9.0, 20.0}) {
      if (total / n > 3) continue;
      SCOPED_TRACE(std::to_string(n) + " triangles, angle " + std::to_string(total));
      const Triangulation t(gallery::input(cone(n, total)));
      const double inner =
          std::cos(total / n / 2); // a straight line between such points stays inside
      for (int i = 0; i < 8; ++i) {
        const auto uniform = [&random] { return static_cast<double>(random()) / 0x1p32; };
        const double r = inner * uniform(), s = inner * uniform();
        const double a = total * uniform(), b = total * uniform();
        const double turn = std::min(std::abs(a - b), total - std::abs(a - b));
        const double expected =
            turn < pi ? std::sqrt((r - s) * (r - s) + 4 * r * s * std::pow(std::sin(turn / 2), 2))
                      : r + s;
        const Surface_point p = polar(t, n, total, r, a), q = polar(t, n, total, s, b);
        const Distance d(t, p);
        EXPECT_NEAR(d.distance(q), expected, 1e-14);
        expect_path(t, d, q, 1e-13);
        // the frame of p begins with the side that leaves the apex; no path is clearly the shortest
        // opposite
        const std::complex<double> frame = std::polar(1., std::floor(a / (total / n)) * total / n);
        const double around = std::remainder(b - a, total);
        if (std::abs(turn - std::min(pi, total / 2)) < 1e-6) continue;
        const std::complex<double> log =
            turn < pi ? s * std::polar(1., a + around) - r * std::polar(1., a)
                      : -(r + s) * std::polar(1., a);
        const IT::Tangent_vector found = d.logarithm(q);
        EXPECT_EQ(found.point.halfedge, p.halfedge);
        EXPECT_EQ(found.point.weights, p.weights);
        // lengths and directions that are turned over some faces
        EXPECT_LE(std::abs(std::complex(found.vector[0], found.vector[1]) * frame - log), 1e-12);
      }
    }
}

/// A torus of two triangles, spanned by (1, 0) and (x, y).
gallery::Surface torus(double x, double y) {
  return gallery::abstract("torus", gallery::glue(2, {{0, 3}, {1, 4}, {2, 5}}), {1, 3, 2, 0, 1, 1},
                           {1, x * x + y * y, (1 + x) * (1 + x) + y * y});
}

// The more it is sheared, the more often a shortest path crosses the same two faces.
TEST(PolyhedralDistance, torus_of_two_triangles_is_the_plane_modulo_a_lattice) {
  std::mt19937 random(6);
  for (const double x : {0., 0.25, 3., 17.5, 300.})
    for (const double y : {1., 0.125, 4.}) {
      SCOPED_TRACE("spanned by (1, 0) and (" + std::to_string(x) + ", " + std::to_string(y) + ")");
      const Triangulation t(gallery::input(torus(x, y)));
      const std::array<double, 2> corner[2][3] = {{{0, 0}, {1, 0}, {1 + x, y}},
                                                  {{1 + x, y}, {x, y}, {0, 0}}};
      const auto place = [&](std::uint32_t f, const std::array<double, 3>& w) {
        std::array<double, 2> p{0, 0};
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t k = 0; k < 2; ++k) p[k] += w[i] * corner[f][i][k];
        return p;
      };
      for (int i = 0; i < 6; ++i) {
        const Surface_point a = paths::random_point(t, random), b = paths::random_point(t, random);
        const auto face_of = [&](const Surface_point& p) {
          return t.index(face(t.numbers().halfedge_at(p.halfedge), t.mesh()));
        };
        const auto p = place(face_of(a), a.weights), q = place(face_of(b), b.weights);
        double expected = infinity;
        for (int n = -12; n <= 12; ++n) {
          const double dx = q[0] - p[0] + n * x;
          expected = std::min(expected, std::hypot(dx - std::round(dx), q[1] - p[1] + n * y));
        }
        const Distance d(t, a);
        EXPECT_EQ(d.status(), Status::done);
        EXPECT_NEAR(d.distance(b), expected, 1e-13 * (1 + x));
        expect_path(t, d, b, 1e-13 * (1 + x));
      }
    }
}

// ---- borders

/// A square of n x n cells without those of a square hole from `low` to `high`.
meshes::Mesh square_with_hole(std::uint32_t n, double low, double high) {
  meshes::Mesh m = meshes::grid(n, n);
  std::erase_if(m.triangles, [&](const meshes::Triangle& f) {
    double x = 0, y = 0;
    for (const std::uint32_t v : f) {
      x += m.points[v][0] / 3;
      y += m.points[v][1] / 3;
    }
    return x > low && x < high && y > low && y < high;
  });
  return m;
}

/// The Euclidean distance in a plane with a square obstacle.
double distance_around(const meshes::Point& p, const meshes::Point& q, double low, double high) {
  std::vector<meshes::Point> nodes{p, q};
  for (const double x : {low, high})
    for (const double y : {low, high}) nodes.push_back({x, y, 0});
  const auto visible = [&](const meshes::Point& a, const meshes::Point& b) {
    for (int i = 1; i < 1024; ++i) { // whether it meets the open square
      const double s = i / 1024., x = a[0] + s * (b[0] - a[0]), y = a[1] + s * (b[1] - a[1]);
      if (x > low + 1e-9 && x < high - 1e-9 && y > low + 1e-9 && y < high - 1e-9) return false;
    }
    return true;
  };
  std::vector<double> d(nodes.size(), infinity);
  d[0] = 0;
  for (std::size_t round = 0; round < nodes.size(); ++round)
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (std::size_t j = 0; j < nodes.size(); ++j)
        if (visible(nodes[i], nodes[j]))
          d[j] = std::min(d[j],
                          d[i] + std::hypot(nodes[i][0] - nodes[j][0], nodes[i][1] - nodes[j][1]));
  return d[1];
}

TEST(PolyhedralDistance, paths_go_around_holes) {
  const meshes::Mesh m = square_with_hole(9, 3, 6);
  const Triangulation t = numbered_as<Triangulation>(m);
  std::uint32_t bends = 0;
  for (const std::uint32_t a : {0U, 4U, 31U, 42U, 74U}) {
    const Distance d(t, vertex(t, a));
    EXPECT_EQ(d.status(), Status::done);
    for (std::uint32_t b = 0; b < m.points.size(); ++b) {
      if (halfedge(vertex(t, b), t.mesh()) == IT::Gluing_map::Halfedge{}) continue; // in the hole
      const double expected = distance_around(m.points[a], m.points[b], 3, 6);
      const double straight =
          std::hypot(m.points[a][0] - m.points[b][0], m.points[a][1] - m.points[b][1]);
      if (expected > straight + 1e-9) ++bends;
      EXPECT_NEAR(d.distance(vertex(t, b)), expected, 1e-13) << a << " to " << b;
      expect_path(t, d, vertex(t, b), 1e-13);
    }
  }
  EXPECT_GT(bends, 50U);
}

TEST(PolyhedralDistance, vertices_of_a_plane_are_as_far_as_they_look) {
  for (const meshes::Mesh& m : {meshes::grid(12, 9), meshes::sheared_grid(6, 6, 5),
                                meshes::random_planar(120, 1000, 3), meshes::parabola_fan(40)}) {
    const Triangulation t = numbered_as<Triangulation>(m);
    const Distance d(t, vertex(t, 1));
    for (std::uint32_t v = 0; v < m.points.size(); ++v) {
      const double expected =
          std::hypot(m.points[v][0] - m.points[1][0], m.points[v][1] - m.points[1][1]);
      // the hull of the grids and of the points is convex
      EXPECT_NEAR(d.distance(vertex(t, v)), expected, 1e-13 * (1 + expected));
      expect_path(t, d, vertex(t, v), 1e-13 * (1 + expected));
    }
  }
}

// ---- against CGAL

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// CGAL's are never shorter, and hardly ever longer: on meshes with exact ties it misses some shortest paths. The path found
// here is measured: it exists.
void expect_distances_of_cgal(const Mesh& mesh, const std::string& name, std::uint32_t from,
                              std::size_t& shorter) {
  using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
  SCOPED_TRACE(name + " from " + std::to_string(from));
  CGAL::Surface_mesh_shortest_path<Traits> cgal(mesh);
  cgal.add_source_point(Mesh::Vertex_index(from));
  const Triangulation t(mesh);
  for (const Vertex v : vertices(t.mesh())) {
    if (t.input_vertex(v) != from) continue;
    const Distance d(t, v);
    const std::vector<double> distances = d.distances();
    for (const Vertex w : vertices(t.mesh())) {
      const std::uint32_t i = t.input_vertex(w);
      const double expected = cgal.shortest_distance_to_source_points(Mesh::Vertex_index(i)).first;
      if (expected < 0) {
        ASSERT_EQ(distances[i], infinity);
        continue;
      }
      if (distances[i] < expected * (1 - 1e-12)) ++shorter;
      ASSERT_LE(distances[i], expected * (1 + 1e-12)) << i;
      expect_path(t, d, w, 1e-12 * (1 + expected));
    }
  }
}

TEST(PolyhedralDistance, is_that_of_cgal_on_small_meshes) {
  std::vector<std::pair<std::string, meshes::Mesh>> all{
      {"cube", meshes::box(1, 1, 1)},  {"box", meshes::box(2, 3, 4)},
      {"l_shape", meshes::l_shape(3)}, {"stairs", meshes::stairs(4, 3)},
      {"sphere", meshes::sphere(3)},   {"folded lattice", meshes::folded_lattice(6, 8, 1)}};
  for (unsigned seed = 0; seed < 12; ++seed) {
    all.emplace_back("rough grid", meshes::rough_grid(9, seed, seed / 4.));
    all.emplace_back("potato", meshes::potato(3, seed));
    all.emplace_back("terrain", meshes::integer_terrain(80, 50, seed));
    all.emplace_back("height field", meshes::integer_height_field(8, 4, seed));
  }
  std::size_t shorter = 0;
  for (const auto& [name, m] : all)
    for (const std::uint32_t from : {0U, 7U})
      expect_distances_of_cgal(meshes::surface_mesh<Mesh>(m), name, from, shorter);
  EXPECT_LE(shorter, 2U); // on the folded lattice
}

#ifdef INTRINSIC_TRIANGULATIONS_CGAL_MESH_DIR
TEST(PolyhedralDistance, is_that_of_cgal_on_its_meshes) {
  std::size_t shorter = 0;
  for (const std::string name : {"blobby_3cc", "eight", "elephant", "holes", "joint",
                                 "mesh_with_border", "pinion", "rotor_small", "triceratops"}) {
    Mesh mesh;
    const std::string file = INTRINSIC_TRIANGULATIONS_CGAL_MESH_DIR "/" + name + ".off";
    ASSERT_TRUE(CGAL::IO::read_polygon_mesh(file, mesh));
    if (CGAL::is_triangle_mesh(mesh)) expect_distances_of_cgal(mesh, name, 0, shorter);
  }
  EXPECT_EQ(shorter, 0U);
}
#endif

// ---- what holds on any surface

// Distances from random points of an input, on it and on another triangulation of the same surface.
TEST(PolyhedralDistance, does_not_depend_on_the_triangulation) {
  std::mt19937 random(8);
  const auto check = [&random](IT::Corresponding_triangulation t, const std::string& name) {
    SCOPED_TRACE(name);
    const IT::Corresponding_triangulation input = t;
    IT::flip_to_delaunay(t);
    for (int i = 0; i < 4; ++i) {
      const Surface_point a = paths::random_point(input, random);
      const Polyhedral_distance d(input, a), e(t, *IT::locate_on_intrinsic(t, a));
      for (const auto v : vertices(t.mesh()))
        EXPECT_TRUE(d.distance(v) == e.distance(v) ||
                    std::abs(d.distance(v) - e.distance(v)) <= 1e-13 * (1 + d.distance(v)));
      for (int j = 0; j < 6; ++j) {
        const Surface_point b = paths::random_point(input, random);
        const double there = d.distance(b), back = Polyhedral_distance(input, b).distance(a);
        if (there == infinity) {
          EXPECT_EQ(back, infinity);
          continue;
        }
        EXPECT_NEAR(there, back, 1e-13 * (1 + there));
        EXPECT_NEAR(there, e.distance(*IT::locate_on_intrinsic(t, b)), 1e-12 * (1 + there));
        expect_path(input, d, b, 1e-12 * (1 + there));
      }
    }
  };
  for (const gallery::Surface& s : gallery::oriented())
    check(IT::Corresponding_triangulation(gallery::input(s)), s.name);
  check(IT::Corresponding_triangulation(meshes::rough_grid(5, 2).input()), "rough grid");
  check(IT::Corresponding_triangulation(meshes::sheared_grid(4, 4, 9).input()), "sheared grid");
  check(IT::Corresponding_triangulation(meshes::walls({{0, 0}, {3, 0}, {0, 4}}, 3).input()),
        "walls");
  check(IT::Corresponding_triangulation(gallery::input(torus(40, 0.5))), "sheared torus");
}

// On the mesh, whatever the triangulation: pieces lie in faces of the mesh, one after the other,
// and their lengths in space sum to the distance. Points are within 2^-45 or so of a side of where
// they should be, which sums of 100 pieces do not see at 1e-10.
TEST(PolyhedralDistance, polylines_on_the_mesh_are_as_long_as_the_distance) {
  using Flipped = IT::Corresponding_triangulation;
  for (unsigned seed = 0; seed < 4; ++seed)
    for (const meshes::Mesh& m : {meshes::potato(2, seed), meshes::rough_grid(9, seed, 3),
                                  meshes::l_shape(3), meshes::integer_terrain(60, 64, seed)}) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      const auto mesh = meshes::surface_mesh<
          CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>>(m);
      Flipped t(mesh);
      std::mt19937 random(seed);
      if (seed % 2 == 0) flip_to_delaunay(t);
      for (std::size_t i = 0; seed > 1 && i < num_edges(t.mesh()); ++i)
        t.flip_edge(t.numbers().halfedge_at(
            static_cast<std::uint32_t>(random() % (2 * num_edges(t.mesh())))));
      const Vertex from = t.numbers().vertex_at(0);
      const Polyhedral_distance<Flipped> d(t, from);
      const auto check = [&](const Shortest_path& path) {
        ASSERT_EQ(path.status, Status::done);
        const IT::Traced_curve curve = trace_shortest_path(t, path);
        ASSERT_EQ(curve.status, Status::done);
        ASSERT_EQ(curve.points.size(), curve.faces.size() + 1);
        const auto line = polyline(t, path, mesh);
        double sum = 0;
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
          sum += std::sqrt(CGAL::squared_distance(line[i], line[i + 1]));
          for (const std::size_t k : {i, i + 1}) { // both ends are in the face
            const Surface_point p = IT::seen_in_face(t.input(), curve.points[k], curve.faces[i]);
            ASSERT_EQ(t.input().face(p.halfedge), curve.faces[i]);
          }
        }
        EXPECT_NEAR(sum, path.length, 1e-10 * path.length);
        EXPECT_EQ(face_locations(t, curve, mesh).size(), line.size());
      };
      for (const Vertex v : vertices(t.mesh()))
        if (v != from) check(d.shortest_path(v));
      for (std::uint32_t f = 0; f < num_faces(t.mesh()); f += 3)
        check(d.shortest_path(point(t, f, {0.25, 0.25, 0.5})));
    }
}

TEST(PolyhedralDistance, is_a_metric) {
  for (const gallery::Surface& s : gallery::oriented()) {
    SCOPED_TRACE(s.name);
    const Triangulation t(gallery::input(s));
    std::vector<Distance> from;
    for (const Vertex v : vertices(t.mesh())) from.emplace_back(t, v);
    for (const Vertex v : vertices(t.mesh()))
      for (const Vertex w : vertices(t.mesh())) {
        const double d = from[t.index(v)].distance(w);
        EXPECT_EQ(d == 0, v == w);
        const double back = from[t.index(w)].distance(v);
        EXPECT_TRUE(d == infinity ? back == infinity : std::abs(d - back) <= 1e-14 * d);
        for (const auto e : edges(t.mesh())) {
          const Distance& f = from[t.index(v)];
          const double a = f.distance(source(halfedge(e, t.mesh()), t.mesh()));
          const double b = f.distance(target(halfedge(e, t.mesh()), t.mesh()));
          EXPECT_TRUE(a == infinity || std::abs(a - b) <= t.length(e) * (1 + 1e-14));
        }
      }
  }
}

TEST(PolyhedralDistance, passes_from_fan_to_fan_at_a_vertex_that_is_not_manifold) {
  const gallery::Surface s = gallery::bow_tie();
  const Triangulation t(gallery::input(s));
  const Distance d(t, vertex(t, 1));
  EXPECT_NEAR(d.distance(vertex(t, 4)), 1 + std::sqrt(2), 1e-15);
  expect_path(t, d, vertex(t, 4), 1e-15);
}

TEST(PolyhedralDistance, isolated_vertices_and_other_components_are_out_of_reach) {
  const gallery::Surface s = gallery::two_fans_and_an_isolated_vertex();
  const Triangulation t(gallery::input(s));
  const Distance d(t, vertex(t, 0)), e(t, vertex(t, 4));
  EXPECT_EQ(d.distance(vertex(t, 4)), infinity);
  EXPECT_EQ(d.shortest_path(vertex(t, 4)).status, Status::stalled);
  EXPECT_EQ(e.distance(vertex(t, 4)), 0);
  EXPECT_EQ(e.distance(vertex(t, 0)), infinity);
}

TEST(PolyhedralDistance, of_many_sources_is_the_least) {
  const Triangulation t = numbered_as<Triangulation>(meshes::rough_grid(7, 11));
  std::mt19937 random(3);
  std::vector<Surface_point> sources;
  for (int i = 0; i < 5; ++i) sources.push_back(paths::random_point(t, random));
  sources.push_back(point(t, 9, {0, 1, 0}));      // at a vertex
  sources.push_back(point(t, 20, {0, .25, .75})); // on an edge
  const Distance all(t, sources);
  std::vector<Distance> single;
  for (const Surface_point& s : sources) single.emplace_back(t, s);
  for (int i = 0; i < 60; ++i) {
    const Surface_point p = paths::random_point(t, random);
    double expected = infinity;
    for (const Distance& d : single) expected = std::min(expected, d.distance(p));
    EXPECT_NEAR(all.distance(p), expected, 1e-14 * (1 + expected));
    expect_path(t, all, p, 1e-13);
  }
  for (const Surface_point& s : sources) EXPECT_NEAR(all.distance(s), 0, 1e-15);
}

TEST(PolyhedralDistance, has_the_units_of_the_input) {
  const meshes::Mesh m = meshes::potato(2, 3);
  const Triangulation unscaled = numbered_as<Triangulation>(m);
  const std::vector<double> expected = Distance(unscaled, vertex(unscaled, 0)).distances();
  for (const double factor : {0x1p-300, 0x1p-4, 0x1p300}) {
    const Triangulation t = numbered_as<Triangulation>(meshes::scaled(m, factor));
    const std::vector<double> distances = Distance(t, vertex(t, 0)).distances();
    for (std::size_t v = 0; v < expected.size(); ++v) EXPECT_EQ(distances[v], expected[v] * factor);
  }
}

// ---- options

TEST(PolyhedralDistance, stops_where_it_is_told_to) {
  const Triangulation t = numbered_as<Triangulation>(meshes::rough_grid(40, 4));
  const Distance all(t, vertex(t, 0));
  const std::vector<double> expected = all.distances();
  EXPECT_EQ(all.reached_distance(), infinity);
  const Distance near(t, vertex(t, 0), parameters::maximum_distance(9.));
  EXPECT_EQ(near.status(), Status::done);
  EXPECT_EQ(near.reached_distance(), 9);
  const Distance to(t, vertex(t, 0), parameters::targets(vertex(t, 50)));
  EXPECT_EQ(to.status(), Status::done);
  EXPECT_GE(to.reached_distance(), expected[50]);
  EXPECT_EQ(to.distance(vertex(t, 50)), expected[50]);
  EXPECT_LT(to.reached_distance(), *std::ranges::max_element(expected));
  const Surface_point p = point(t, 99, {0.25, 0.5, 0.25});
  const Distance to_point(t, vertex(t, 0), parameters::targets(std::vector{p}));
  EXPECT_EQ(to_point.distance(p), all.distance(p));
  const Distance capped(t, vertex(t, 0), parameters::maximum_number(1000));
  EXPECT_EQ(capped.status(), Status::cap);
  EXPECT_LT(near.number_of_windows(), all.number_of_windows());
  EXPECT_LT(to.number_of_windows(), all.number_of_windows());
  for (const Distance* d : {&near, &to, &to_point, &capped})
    for (std::size_t v = 0; v < expected.size(); ++v)
      EXPECT_EQ(d->distances()[v], expected[v] <= d->reached_distance() ? expected[v] : infinity);
}

TEST(PolyhedralDistance, visitor_is_told_of_progress_and_may_cancel) {
  struct Visitor {
    int calls = 0;
    double last = 0;
    bool progress(std::uint64_t, double distance) {
      EXPECT_GE(distance, last);
      last = distance;
      return ++calls < 2;
    }
  } visitor;
  const Triangulation t = numbered_as<Triangulation>(meshes::rough_grid(160, 4));
  const Distance d(t, vertex(t, 0), parameters::visitor(std::ref(visitor)));
  EXPECT_EQ(d.status(), Status::cancelled);
  EXPECT_EQ(visitor.calls, 2);
  EXPECT_EQ(d.reached_distance(), visitor.last);
}

// ---- bad triangles

TEST(PolyhedralDistance, caps_and_needles_do_no_harm) {
  const meshes::Mesh plain = meshes::rough_grid(6, 9);
  std::vector<meshes::Mesh> bad{meshes::with_cap(plain, 20), meshes::with_needle(plain, 30, 1e-9),
                                meshes::with_needle(plain, 30, 1e-14),
                                meshes::with_cap(meshes::with_cap(plain, 20), 20)};
  for (const meshes::Mesh& m : bad) {
    const Triangulation t = numbered_as<Triangulation>(m);
    Triangulation flipped = t;
    IT::flip_to_delaunay(flipped);
    const Distance d(t, vertex(t, 3)), e(flipped, vertex(flipped, 3));
    EXPECT_EQ(d.status(), Status::done);
    for (const Vertex v : vertices(t.mesh())) {
      EXPECT_NEAR(d.distance(v), e.distance(v), 1e-12 * (1 + d.distance(v)));
      expect_path(t, d, v, 1e-7); // measured by lengths, which caps make too large
    }
  }
}

// On a body so thin, windows that wind around it are hardly longer than those that do not. It ends,
// and reports an early end; all results it reports are right.
TEST(PolyhedralDistance, ends_on_a_mesh_of_needles) {
  for (const double stretch : {1e3, 1e6, 1e8, 1e12}) {
    meshes::Mesh m = meshes::potato(2, 5);
    for (meshes::Point& p : m.points) p[0] *= stretch;
    const Triangulation t = numbered_as<Triangulation>(m);
    Triangulation flipped = t;
    IT::flip_to_delaunay(flipped);
    const Distance d(t, vertex(t, 0), parameters::maximum_number(1000000)),
        e(flipped, vertex(flipped, 0), parameters::maximum_number(1000000));
    EXPECT_TRUE(d.status() == Status::done || d.status() == Status::cap);
    EXPECT_LE(std::max(d.number_of_windows(), e.number_of_windows()), 1000000U);
    for (const Vertex v : vertices(t.mesh()))
      if (d.distance(v) < infinity && e.distance(v) < infinity) {
        EXPECT_NEAR(d.distance(v), e.distance(v), 1e-9 * (1 + d.distance(v)));
      }
  }
}

// ---- requirements on a triangulation

TEST(PolyhedralDistance, is_the_same_on_another_mesh_type_and_on_an_archetype_of_the_concept) {
  const meshes::Mesh m = meshes::rough_grid(6, 1);
  const Triangulation plain(m.input());
  const std::vector<double> expected = Distance(plain, vertex(plain, 0)).distances();
  const auto check = [&](const auto& t, auto v) {
    const std::vector<double> distances = Polyhedral_distance(t, v).distances();
    ASSERT_EQ(distances.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_NEAR(distances[i], expected[i], 1e-14 * (1 + expected[i]));
  };
  const IT::Intrinsic_triangulation<Mesh, IT::Euclidean_traits<double>> t(m.input());
  check(t, IT::vertex_of_row(t, 0));
  archetypes::Wrapped wrapped(m.input());
  const archetypes::Numbered_triangulation archetype(wrapped);
  check(archetype, archetype.numbers().vertex_at(0));
}

} // namespace
