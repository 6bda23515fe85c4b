// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_geodesics/queries/Geodesic_finder.h>
#include <CGAL/Intrinsic_geodesics/queries/add_geodesics.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/read_triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include "../../benchmark/synthetic_meshes.h"
#include "meshes.h"
#include "numbered_as_mesh.h"
#include "paths.h"
#include "planar_bezier.h"
#include "straight_segments.h"
#include "unfolded_paths.h"

#include <CGAL/Interval_nt.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Geodesic_path;
using IT::Gluing_map;
using IT::Status;
using IT::Surface_point;
using Exact = IT::Exact_euclidean_traits;
using Triangulation = IT::Intrinsic_triangulation<Gluing_map, Exact, IT::Integer_coordinates>;
using Doubles =
    IT::Intrinsic_triangulation<Gluing_map, IT::Euclidean_traits<double>, IT::Integer_coordinates>;
using planar_bezier::distance;

template <class T>
typename T::vertex_descriptor random_vertex(const T& t, std::mt19937& random) {
  return t.numbers().vertex_at(static_cast<std::uint32_t>(random() % num_vertices(t.mesh())));
}

/// A point inside a face of the input; its weights are exact.
template <class T>
Surface_point random_point(const T& t, std::mt19937& random) {
  const auto f = static_cast<std::uint32_t>(random() % t.input().number_of_faces());
  const double a = static_cast<double>(1 + random() % 30) / 64,
               b = static_cast<double>(1 + random() % 30) / 64;
  return {t.input().halfedge_of_face(f), {a, b, 1 - a - b}};
}

/// Everything that flips change.
struct State {
  std::vector<std::uint32_t> next, target, face;
  std::vector<double> lengths, areas;
  std::vector<std::int64_t> normal;
};

template <class T>
State state(const T& t) {
  State s;
  for (const auto h : halfedges(t.mesh())) {
    s.next.push_back(t.numbers().halfedge(next(h, t.mesh())));
    s.target.push_back(t.index(target(h, t.mesh())));
    s.face.push_back(t.index(face(h, t.mesh())));
  }
  for (const auto e : edges(t.mesh())) {
    s.lengths.push_back(t.metric().approximate_squared_length(t.index(e)));
    if constexpr (requires { t.correspondence().normal_coordinate(0U); })
      s.normal.push_back(
          static_cast<std::int64_t>(t.correspondence().normal_coordinate(t.index(e))));
  }
  for (const auto f : faces(t.mesh()))
    s.areas.push_back(t.metric().approximate_quadruple_area(t.index(f)));
  return s;
}

/// Exact traits may have learnt better values on the way.
void expect_same(const std::vector<double>& a, const std::vector<double>& b, bool is_exact) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], is_exact ? 1e-9 * b[i] : 0);
}

template <class T>
class GeodesicFinder : public ::testing::Test {};
using Triangulations =
    ::testing::Types<Triangulation, Doubles,
                     IT::Intrinsic_triangulation<Gluing_map, Exact, IT::Explicit_crossings>,
                     IT::Intrinsic_triangulation<Gluing_map, Exact, IT::Signposts>>;
TYPED_TEST_SUITE(GeodesicFinder, Triangulations);

// Flips are undone, before and after flips to Delaunay, whose history exact traits keep.
TYPED_TEST(GeodesicFinder, LeavesTheTriangulationAsItWas) {
  for (const bool is_delaunay : {false, true}) {
    TypeParam t = numbered_as<TypeParam>(meshes::potato(3, 5));
    if (is_delaunay) flip_to_delaunay(t);
    IT::Geodesic_finder<TypeParam> find(t);
    std::mt19937 random(3);
    std::uint64_t flips = 0;
    std::vector<double> lengths;
    const State before = state(t);
    for (const unsigned round : {0U, 1U}) {
      random.seed(3);
      for (unsigned i = 0; i < 40; ++i) {
        const auto from = random_vertex(t, random), to = random_vertex(t, random);
        const Geodesic_path path = find(from, to);
        ASSERT_EQ(path.status, Status::done);
        EXPECT_LE(path.length, path.initial_length * (1 + 1e-12));
        flips += path.shortening.flips;
        if (round == 0)
          lengths.push_back(path.length);
        else
          EXPECT_NEAR(path.length, lengths[i], 1e-12 * lengths[i]);
      }
    }
    EXPECT_GT(flips, 500U);
    const State after = state(t);
    EXPECT_EQ(after.next, before.next);
    EXPECT_EQ(after.target, before.target);
    EXPECT_EQ(after.face, before.face);
    EXPECT_EQ(after.normal, before.normal);
    expect_same(after.lengths, before.lengths, TypeParam::Metric::is_exact);
    expect_same(after.areas, before.areas, TypeParam::Metric::is_exact);
  }
}

// Points follow each other in the faces that are named, and lie as far apart as the geodesic is long.
TYPED_TEST(GeodesicFinder, PathsOverTheInputAreStraightInItsFaces) {
  const meshes::Mesh mesh = meshes::rough_grid(12, 4);
  TypeParam t = numbered_as<TypeParam>(mesh);
  const auto place = [&](const Surface_point& p) { return point_in_space(t, p, mesh.points); };
  IT::Geodesic_finder<TypeParam> find(t);
  std::mt19937 random(8);
  for (unsigned i = 0; i < 60; ++i) {
    const Geodesic_path path = find(random_vertex(t, random), random_vertex(t, random));
    ASSERT_EQ(path.status, Status::done);
    if (path.points.empty()) continue;
    ASSERT_EQ(path.faces.size() + 1, path.points.size());
    double sum = 0;
    for (std::size_t k = 0; k < path.faces.size(); ++k) {
      sum += distance(place(path.points[k]), place(path.points[k + 1]));
      for (const Surface_point& p : {path.points[k], path.points[k + 1]}) {
        const Surface_point seen = IT::seen_in_face(t.input(), p, path.faces[k]);
        EXPECT_EQ(t.input().face(seen.halfedge), path.faces[k]);
        EXPECT_LT(distance(place(seen), place(p)), 1e-12);
        for (const double w : seen.weights) EXPECT_GE(w, -1e-12);
      }
    }
    EXPECT_NEAR(sum, path.length, 1e-9 * path.length);
  }
}

// In a plane the geodesic between any two points is the segment, and the triangulation gets rid of the points again.
TEST(GeodesicFinderOfPoints, GeodesicsInAPlaneAreSegments) {
  const meshes::Mesh mesh = meshes::random_planar(200, 64, 2);
  Triangulation t = numbered_as<Triangulation>(mesh);
  const std::uint32_t vertices_before = t.number_of_vertices();
  IT::Geodesic_finder<Triangulation> find(t);
  std::mt19937 random(2);
  unsigned convex = 0;
  for (unsigned i = 0; i < 60; ++i) {
    const Surface_point from = random_point(t, random), to = random_point(t, random);
    const Geodesic_path path = find({from, to});
    ASSERT_EQ(path.status, Status::done);
    const double straight =
        distance(IT::point_in_space(t, from, mesh.points), IT::point_in_space(t, to, mesh.points));
    // round corners of the border, else along the segment
    EXPECT_GE(path.length, straight * (1 - 1e-9));
    if (path.length < straight * (1 + 1e-9)) ++convex;
    EXPECT_EQ(t.number_of_vertices(), vertices_before);
  }
  EXPECT_GT(convex, 40U);
}

TEST(GeodesicFinderOfPoints, PointsThatAreNotConnectedAreReported) {
  meshes::Mesh two = meshes::sphere(0);
  const auto n = static_cast<std::uint32_t>(two.points.size());
  const meshes::Mesh other = meshes::translated(meshes::sphere(0), {5, 0, 0});
  two.points.insert(two.points.end(), other.points.begin(), other.points.end());
  for (const meshes::Triangle& x : other.triangles)
    two.triangles.push_back({x[0] + n, x[1] + n, x[2] + n});
  Triangulation t = numbered_as<Triangulation>(two);
  IT::Geodesic_finder<Triangulation> find(t);
  const Geodesic_path path = find(t.numbers().vertex_at(0), t.numbers().vertex_at(n));
  EXPECT_EQ(path.status, Status::stalled);
  EXPECT_TRUE(path.points.empty());
}

// ---- Shortest paths

/// Flips without need: faces become long, and wind about the surface.
template <class T>
void flip_at_random(T& t, std::mt19937& random) {
  const std::size_t edges = num_edges(t.mesh());
  for (std::size_t i = 0; i < 2 * edges; ++i)
    t.flip_edge(t.numbers().halfedge_at(static_cast<std::uint32_t>(random() % (2 * edges))));
}

// Errors of sums of fewer than 100 lengths of doubles, each relative to the whole path, stay below
// 1e-12; the search takes a path that passes a vertex within 1e-12 of its length for one through
// the vertex.
constexpr double rounding = 1e-11;

TYPED_TEST(GeodesicFinder, ShortestPathsAreAsLongAsBruteForceTells) {
  for (unsigned seed = 0; seed < 6; ++seed)
    for (const meshes::Mesh& mesh :
         {meshes::potato(0, seed), meshes::rough_grid(3, seed, 2), meshes::box(1, 2, 1),
          meshes::l_shape(1), meshes::integer_height_field(3, 5, seed),
          meshes::prism({{0, 0}, {9, 0}, {9, 1}, {1, 1}, {1, 8}, {0, 8}}, 1)}) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", vertices " +
                   std::to_string(mesh.points.size()));
      TypeParam t = numbered_as<TypeParam>(mesh);
      const straight_segments::Distances distance(t.input());
      const double unit = std::ldexp(1.0, -t.metric().scale_exponent());
      IT::Geodesic_finder<TypeParam> find(t);
      for (std::uint32_t i = 0; i < mesh.points.size(); ++i)
        for (std::uint32_t j = 0; j < i; ++j) {
          const auto v = t.numbers().vertex_at(i), w = t.numbers().vertex_at(j);
          const Geodesic_path path = find(v, w);
          ASSERT_EQ(path.status, Status::done);
          EXPECT_NEAR(path.length, unit * distance(i, j), rounding * path.length) << i << " " << j;
        }
    }
}

// Between points in faces, and as edges of the triangulation.
TYPED_TEST(GeodesicFinder, ShortestPathsAreAsLongAsTheExactDistance) {
  std::size_t shorter = 0;
  for (unsigned seed = 0; seed < 6; ++seed)
    for (const meshes::Mesh& mesh : {meshes::potato(2, seed), meshes::rough_grid(9, seed, 3),
                                     meshes::integer_terrain(60, 64, seed), meshes::l_shape(4)}) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      TypeParam t = numbered_as<TypeParam>(mesh);
      std::mt19937 random(seed);
      if (seed % 2 == 0) flip_at_random(t, random);
      IT::Geodesic_finder<TypeParam> find(t);
      for (unsigned i = 0; i < 6; ++i) {
        const Surface_point from = random_point(t, random), to = random_point(t, random);
        TypeParam other = t;
        const auto v = insert_point(other, from).vertex, w = insert_point(other, to).vertex;
        const double d = IT::Polyhedral_distance(other, v).distance(w);
        const Geodesic_path path = find({from, to});
        ASSERT_EQ(path.status, Status::done);
        EXPECT_NEAR(path.length, d, rounding * d);
        const auto edges = insert_geodesic(other, v, w);
        ASSERT_EQ(edges.status, Status::done);
        double sum = 0;
        for (const auto h : edges.halfedges) sum += other.length(edge(h, other.mesh()));
        EXPECT_NEAR(sum, d, rounding * d);
        const Geodesic_path near = find({from, to}, IT::parameters::shortest(false));
        if (near.length > d * (1 + 1e-9)) ++shorter;
      }
    }
  EXPECT_GT(shorter, 10U);
}

// ---- An oracle in 200 digits

/// The vertices that a geodesic passes and the faces between, by what makes it a path of edges.
std::vector<unfolded_paths::Piece> pieces(Triangulation t, Gluing_map::Vertex from,
                                          Gluing_map::Vertex to) {
  std::vector<unfolded_paths::Piece> result;
  for (const auto h : insert_geodesic(t, from, to).halfedges)
    result.push_back({t.index(source(h, t.mesh())), t.index(target(h, t.mesh())),
                      trace_curve(t, std::vector{h}).faces});
  return result;
}

void expect_as_unfolded(const Geodesic_path& path, const unfolded_paths::Path& unfolded) {
  using namespace unfolded_paths;
  const CGAL::Interval_nt<>& bounds = path.length_enclosure;
  const Wide error = tiny() * unfolded.length; // of the oracle
  EXPECT_TRUE(bounds.inf() <= unfolded.length + error && unfolded.length - error <= bounds.sup())
      << bounds << " lacks " << unfolded.length;
  EXPECT_LE(bounds.sup() - bounds.inf(), 1e-12 * path.length);
  EXPECT_NEAR(bounds.inf(), path.length, 1e-12 * path.length);
  EXPECT_LE(unfolded.deviation, tiny());
  EXPECT_GE(unfolded.least_angle, pi() - tiny());
}

/// Geodesics between random vertices, before and after flips to Delaunay.
void expect_unfolded_paths(const meshes::Mesh& mesh, unsigned paths, unsigned seed,
                           std::size_t& passed) {
  const unfolded_paths::Unfolder unfold(mesh);
  std::mt19937 random(seed);
  for (const bool is_delaunay : {false, true}) {
    Triangulation t = numbered_as<Triangulation>(mesh);
    if (is_delaunay) flip_to_delaunay(t);
    IT::Geodesic_finder<Triangulation> find(t);
    for (unsigned i = 0; i < paths; ++i) {
      const auto from = random_vertex(t, random), to = random_vertex(t, random);
      const Geodesic_path path = find(from, to);
      if (path.status == Status::stalled) continue; // in another component
      ASSERT_EQ(path.status, Status::done);
      const std::vector<unfolded_paths::Piece> way = pieces(t, from, to);
      std::vector<std::uint32_t> faces;
      for (const unfolded_paths::Piece& p : way)
        faces.insert(faces.end(), p.faces.begin(), p.faces.end());
      ASSERT_EQ(faces, path.faces);
      expect_as_unfolded(path, unfold(way));
      passed += way.empty() ? 0 : way.size() - 1;
    }
  }
}

TEST(GeodesicFinderUnfolded, LengthsAndAnglesAreThoseIn200Digits) {
  std::size_t passed = 0;
  for (unsigned seed = 0; seed < 4; ++seed)
    for (const meshes::Mesh& mesh :
         {meshes::rough_grid(12, seed), meshes::potato(3, seed),
          meshes::integer_terrain(90, 64, seed), meshes::integer_height_field(9, 4, seed),
          meshes::sheared_grid(7, 7, 5.5), meshes::box(3, 4, 5), meshes::l_shape(5),
          meshes::scaled(meshes::rough_grid(7, seed), 0x1p-600),
          meshes::scaled(meshes::potato(2, seed), 0x1p500)}) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      expect_unfolded_paths(mesh, 12, seed, passed);
    }
  EXPECT_GT(passed, 300U);
}

// Doubles do not know how wrong they are, intervals do.
TEST(GeodesicFinderUnfolded, EnclosuresWithoutBoundsOfErrorsAreUnbounded) {
  const meshes::Mesh mesh = meshes::rough_grid(5, 1);
  Doubles t = numbered_as<Doubles>(mesh);
  const Geodesic_path path =
      IT::Geodesic_finder<Doubles>(t)(t.numbers().vertex_at(0), t.numbers().vertex_at(30));
  ASSERT_EQ(path.status, Status::done);
  EXPECT_EQ(path.length_enclosure.inf(), 0);
  EXPECT_EQ(path.length_enclosure.sup(), std::numeric_limits<double>::infinity());
}

#ifdef INTRINSIC_TRIANGULATIONS_CGAL_MESH_DIR
TEST(GeodesicFinderUnfolded, LengthsAndAnglesAreThoseIn200DigitsOnMeshesOfCgal) {
  std::size_t passed = 0;
  for (const std::string name : {"anchor", "bull", "couplingdown", "elephant", "fandisk", "homer",
                                 "joint", "pinion", "rotor_small", "triceratops"}) {
    SCOPED_TRACE(name);
    const IT::Triangle_soup soup =
        IT::read_triangle_soup(INTRINSIC_TRIANGULATIONS_CGAL_MESH_DIR "/" + name + ".off");
    const meshes::Mesh mesh{soup.points, soup.triangles};
    expect_unfolded_paths(mesh, 20, 5, passed);
  }
  EXPECT_GT(passed, 300U);
}

// Flips do not open angles of zero in faces without area: such steps gain nothing, and must end.
TEST(GeodesicFinder, EndsOnFacesWithoutArea) {
  const IT::Triangle_soup soup =
      IT::read_triangle_soup(INTRINSIC_TRIANGULATIONS_CGAL_MESH_DIR "/degtri_sliding.off");
  Triangulation t(IT::Intrinsic_input(soup, IT::Mollification::none));
  IT::flip_to_delaunay(t);
  IT::Geodesic_finder<Triangulation> find(t);
  std::mt19937 random(1);
  std::size_t done = 0, stalled = 0;
  for (int i = 0; i < 30; ++i) {
    const auto from = random_vertex(t, random), to = random_vertex(t, random);
    if (from == to) continue;
    const Status s = find(from, to).status;
    (s == Status::done ? done : stalled) += 1;
    EXPECT_TRUE(s == Status::done || s == Status::stalled);
  }
  EXPECT_GT(done, stalled);
}
#endif

// The fans of thin faces that flips make along a path must not spoil lengths.
TEST(Geodesic_finder, finds_in_doubles_the_lengths_that_exact_traits_find) {
  IT::synthetic::Triangle_soup soup = IT::synthetic::torus(200, 100, 0.35, 12);
  const meshes::Mesh m{std::move(soup.points), std::move(soup.triangles)};
  Doubles doubles(m.input());
  Triangulation exact(m.input());
  IT::Geodesic_finder find_in_doubles(doubles);
  IT::Geodesic_finder find(exact);
  constexpr std::uint32_t seed = 3;
  std::mt19937 random(seed);
  for (int i = 0; i < 30; ++i) { // both have the same numbers
    const auto from = random_vertex(exact, random), to = random_vertex(exact, random);
    const Geodesic_path found = find_in_doubles(from, to, IT::parameters::shortest(false));
    const Geodesic_path expected = find(from, to, IT::parameters::shortest(false));
    ASSERT_EQ(found.status, Status::done) << "seed " << seed;
    ASSERT_NEAR(found.length, expected.length, 1e-9 * expected.length)
        << "seed " << seed << ": from " << from.index << " to " << to.index;
  }
}

// Many vertices are on lines: shortening went round there until its cap.
TEST(Geodesic_finder, finds_segments_in_doubles_where_vertices_are_collinear) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const meshes::Mesh m =
        meshes::subdivided(meshes::subdivided(planar_bezier::random_square(10 + seed, random)));
    Doubles t(m.input());
    IT::Geodesic_finder find(t);
    for (int i = 0; i < 20; ++i) {
      const auto from = static_cast<std::uint32_t>(random() % m.points.size());
      const auto to = static_cast<std::uint32_t>(random() % m.points.size());
      const Geodesic_path found = find(t.numbers().vertex_at(from), t.numbers().vertex_at(to));
      ASSERT_EQ(found.status, Status::done);
      // a piece for each of some hundred faces passed, to some units of rounding
      ASSERT_NEAR(found.length, planar_bezier::distance(m.points[from], m.points[to]), 1e-12);
    }
  }
}

} // namespace
