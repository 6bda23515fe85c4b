// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_conformal/angles/ideal_start.h>
#include <CGAL/Intrinsic_simplification/embedding/embed_convex.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numbers>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Surfaces of convex polyhedra that are known: distances in space must return from lengths alone.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Point = std::array<double, 3>;

double distance(const Point& p, const Point& q) {
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

Mesh hull_of(const std::vector<Point>& points) {
  std::vector<Kernel::Point_3> all;
  for (const Point& p : points) all.emplace_back(p[0], p[1], p[2]);
  Mesh mesh;
  CGAL::convex_hull_3(all.begin(), all.end(), mesh);
  return mesh;
}

// From the first point.
double distance_of_farthest(const std::vector<Point>& points) {
  double result = 0;
  for (const Point& p : points) result = std::max(result, distance(points.front(), p));
  return result;
}

// Whether the lengths of a face, rounded to doubles, may violate the triangle inequality.
bool is_thin(const IT::Corresponding_triangulation& t, IT::Gluing_map::Halfedge h) {
  const auto n = next(h, t.mesh());
  const double a = t.squared_length(edge(h, t.mesh())), b = t.squared_length(edge(n, t.mesh())),
               c = t.squared_length(edge(next(n, t.mesh()), t.mesh()));
  return 4 * a * b - (a + b - c) * (a + b - c) < 1e-8 * std::max({a, b, c}) * std::max({a, b, c});
}

// A surface that has the lengths of a mesh, but other triangles and no points.
IT::Corresponding_triangulation lengths_only(const Mesh& mesh, unsigned seed) {
  IT::Corresponding_triangulation t(mesh);
  std::mt19937 random(seed);
  std::vector<IT::Gluing_map::Edge> all(edges(t.mesh()).begin(), edges(t.mesh()).end());
  for (std::size_t n = 0; n < all.size(); ++n) {
    const auto h = halfedge(all[random() % all.size()], t.mesh());
    if (t.flip_edge(h) != IT::Move_status::done) continue;
    if (is_thin(t, h) || is_thin(t, opposite(h, t.mesh()))) t.flip_edge(h); // back
  }
  return IT::Corresponding_triangulation(IT::ideal_start(t));
}

// All pairs of vertices; returns the greatest error by the diameter.
double error_of_distances(const std::vector<Point>& found, const Mesh& mesh) {
  double error = 0, diameter = 0;
  const auto at = [&](std::size_t v) {
    const Kernel::Point_3& p = mesh.point(Mesh::Vertex_index(static_cast<Mesh::size_type>(v)));
    return Point{p.x(), p.y(), p.z()};
  };
  for (std::size_t v = 0; v < found.size(); ++v)
    for (std::size_t w = 0; w < v; ++w) {
      const double d = distance(at(v), at(w));
      diameter = std::max(diameter, d);
      error = std::max(error, std::abs(distance(found[v], found[w]) - d));
    }
  return error / diameter;
}

// How far points are outside of a face, at most; and faces close the surface.
double greatest_height(const IT::Convex_polyhedron& p) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  double result = 0;
  for (const auto& f : p.faces) {
    for (std::size_t k = 0; k < 3; ++k) ++sides[{f[k], f[(k + 1) % 3]}];
    const auto vector = [&](std::uint32_t v) {
      const Point &a = p.points[f[0]], &b = p.points[v];
      return Kernel::Vector_3(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
    };
    const Kernel::Vector_3 normal = CGAL::cross_product(vector(f[1]), vector(f[2]));
    const double length = std::sqrt(normal.squared_length());
    EXPECT_GT(length, 0);
    for (std::uint32_t v = 0; v < p.points.size(); ++v)
      result = std::max(result, normal * vector(v) / length);
  }
  for (const auto& [side, number] : sides) {
    EXPECT_EQ(number, 1);
    EXPECT_EQ(sides.count({side.second, side.first}), 1U);
  }
  return result;
}

void expect_embeds(const Mesh& mesh, unsigned seed, double within = 1e-12) {
  const IT::Convex_polyhedron p = IT::embed_convex(lengths_only(mesh, seed));
  ASSERT_EQ(p.status, IT::Status::done) << p.steps << " steps";
  EXPECT_EQ(p.shape, IT::Convex_shape::polyhedron);
  EXPECT_LT(error_of_distances(p.points, mesh), within);
  EXPECT_LT(p.largest_error, 1e-14);
  EXPECT_EQ(p.certificate.concave_edges, 0U);
  EXPECT_TRUE(p.certificate.is_proven);
  EXPECT_LT(p.certificate.within, 1e-14 * distance_of_farthest(p.points));
  EXPECT_EQ(p.certificate.stretch, 0);
  EXPECT_TRUE(p.certificate.encloses_its_centre);
  EXPECT_EQ(p.faces.size(), 2 * p.points.size() - 4);
}

std::vector<Point> random_points(std::size_t n, const Point& axes, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<Point> result;
  for (std::size_t i = 0; i < n; ++i) {
    Point p{normal(random), normal(random), normal(random)};
    const double length = distance(p, {0, 0, 0});
    for (std::size_t k = 0; k < 3; ++k) p[k] *= axes[k] / length;
    result.push_back(p);
  }
  return result;
}

// The surface of a box, with a grid of flat vertices.
Mesh box(const Point& sides, int n) {
  std::map<std::array<int, 3>, Mesh::Vertex_index> place;
  Mesh mesh;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [i, is_new] = place.insert({at, Mesh::Vertex_index()});
    if (is_new)
      i->second =
          mesh.add_vertex({sides[0] * at[0] / n, sides[1] * at[1] / n, sides[2] * at[2] / n});
    return i->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const int end : {0, n})
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const auto at = [&](int a, int b) {
            std::array<int, 3> p{};
            p[axis] = end;
            p[(axis + 1) % 3] = a;
            p[(axis + 2) % 3] = b;
            return vertex(p);
          };
          std::array<Mesh::Vertex_index, 4> q{at(i, j), at(i + 1, j), at(i + 1, j + 1),
                                              at(i, j + 1)};
          if (end == 0) std::swap(q[1], q[3]);
          mesh.add_face(q[0], q[1], q[2]);
          mesh.add_face(q[0], q[2], q[3]);
        }
  return mesh;
}

TEST(EmbedConvex, returnsPlatonicSolids) {
  const double g = std::numbers::phi, s = 1 / g;
  std::vector<std::vector<Point>> solids(4);
  solids[0] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  for (const double x : {-1., 1.}) {
    solids[1].insert(solids[1].end(), {{x, 0, 0}, {0, x, 0}, {0, 0, x}});
    for (const double y : {-1., 1.}) {
      solids[2].insert(solids[2].end(), {{0, x, y * g}, {x, y * g, 0}, {y * g, 0, x}});
      solids[3].insert(solids[3].end(), {{0, x * s, y * g}, {x * s, y * g, 0}, {y * g, 0, x * s}});
      for (const double z : {-1., 1.}) solids[3].push_back({x, y, z});
    }
  }
  for (const std::vector<Point>& points : solids)
    for (unsigned seed = 1; seed <= 3; ++seed) {
      SCOPED_TRACE(std::to_string(points.size()) + " corners, seed " + std::to_string(seed));
      expect_embeds(hull_of(points), seed, 1e-14);
    }
}

TEST(EmbedConvex, returnsHullsOfRandomPoints) {
  struct Family {
    Point axes;
    std::vector<std::size_t> sizes;
  };
  const std::vector<Family> families{
      {{1, 1, 1}, {8, 30, 300}}, {{1, .3, .05}, {30, 100, 300}}, {{100, 1, 1}, {8, 30, 100}}};
  for (const Family& f : families)
    for (const std::size_t n : f.sizes) {
      SCOPED_TRACE(std::to_string(f.axes[0]) + ", " + std::to_string(n) + " points");
      const Mesh mesh = hull_of(random_points(n, f.axes, 7));
      expect_embeds(mesh, 11);
    }
}

TEST(EmbedConvex, isConvexFromOutside) {
  const Mesh mesh = hull_of(random_points(60, {1, .6, .3}, 3));
  const IT::Convex_polyhedron p = IT::embed_convex(lengths_only(mesh, 5));
  ASSERT_EQ(p.status, IT::Status::done);
  EXPECT_LT(greatest_height(p), 1e-14);
  EXPECT_EQ(p.certificate.flat_edges, 0U);
  EXPECT_EQ(p.certificate.convex_edges, 3 * p.points.size() - 6);
  EXPECT_LT(p.certificate.within, 1e-10);
  EXPECT_EQ(hull_of(p.points).number_of_vertices(), p.points.size());
}

TEST(EmbedConvex, putsFlatVerticesBack) {
  const std::vector<std::pair<Point, int>> boxes{
      {{1, 1, 1}, 6}, {{1, 1, .02}, 4}, {{1, 1, .02}, 10}, {{3, 1, .1}, 3}, {{1, 1, .02}, 18}};
  for (const auto& [sides, n] : boxes) {
    SCOPED_TRACE(std::to_string(sides[2]));
    const Mesh mesh = box(sides, n);
    const IT::Convex_polyhedron p = IT::embed_convex(IT::Corresponding_triangulation(mesh));
    ASSERT_EQ(p.status, IT::Status::done);
    EXPECT_EQ(p.flat_vertices.size(), mesh.number_of_vertices() - 8);
    EXPECT_LT(error_of_distances(p.points, mesh), 1e-13);
    EXPECT_EQ(p.faces.size(), mesh.number_of_faces());
    EXPECT_LT(greatest_height(p), 1e-13);
    EXPECT_TRUE(p.certificate.is_proven);
    EXPECT_GE(p.certificate.convex_edges, 12U); // those of the box; of some boxes diagonals, too
    const IT::Convex_polyhedron flipped = IT::embed_convex(lengths_only(mesh, 3));
    ASSERT_EQ(flipped.status, IT::Status::done);
    EXPECT_LT(error_of_distances(flipped.points, mesh), 1e-12);
    // rounded lengths leave some curvature at vertices of flat faces
    EXPECT_TRUE(flipped.certificate.is_proven);
    EXPECT_GT(flipped.certificate.stretch, 0);
    EXPECT_LT(flipped.certificate.stretch, 1e-10);
  }
}

// Lengths without rounding: nothing is stretched, and a diagonal of each side is flat.
TEST(EmbedConvex, findsExactBoxesWithoutStretch) {
  const IT::Convex_polyhedron p =
      IT::embed_convex(IT::Corresponding_triangulation(box({1, 1, .5}, 4)));
  EXPECT_TRUE(p.certificate.is_proven);
  EXPECT_EQ(p.certificate.stretch, 0);
  EXPECT_EQ(p.certificate.flat_edges, 6U);
}

// A low pyramid on a cube, whose tip is made flat: by symmetry all four edges at it take the length
// of half a diagonal, and in their direction curves are stretched as they are.
TEST(EmbedConvex, boundsTheStretchOfFlatVertices) {
  for (const double height : {1e-6, 1e-4, 1e-2}) {
    SCOPED_TRACE(std::to_string(height));
    std::vector<Point> points{{.5, .5, 1 + height}};
    for (int c = 0; c < 8; ++c) points.push_back({c % 2 * 1., c / 2 % 2 * 1., c / 4 * 1.});
    const Mesh mesh = hull_of(points);
    IT::Embed_options options;
    options.flat_within = 10 * height * height;
    const IT::Convex_polyhedron p =
        IT::embed_convex(IT::Corresponding_triangulation(mesh), options);
    ASSERT_EQ(p.status, IT::Status::done);
    EXPECT_EQ(p.flat_vertices.size(), 1U);
    EXPECT_TRUE(p.certificate.is_proven);
    const double least = std::hypot(std::sqrt(.5), height) / std::sqrt(.5) - 1;
    EXPECT_GT(p.certificate.stretch, least * (1 - 1e-3));
    EXPECT_LT(p.certificate.stretch, 4 * least);
  }
}

// The same lengths with other numbers, on another scale, in a mirror: the same polyhedron.
TEST(EmbedConvex, doesNotDependOnNumbersScalesAndMirrors) {
  const std::vector<Point> points = random_points(40, {1, .4, .1}, 5);
  const auto embedded = [&](const std::vector<std::size_t>& order, double scale, double mirror) {
    std::vector<Point> all;
    for (const std::size_t v : order)
      all.push_back({scale * points[v][0], scale * points[v][1], scale * mirror * points[v][2]});
    const Mesh mesh = hull_of(all);
    const IT::Convex_polyhedron p = IT::embed_convex(lengths_only(mesh, 1));
    EXPECT_TRUE(p.certificate.is_proven);
    EXPECT_LT(error_of_distances(p.points, mesh), 1e-13);
    EXPECT_LT(greatest_height(p), 1e-13 * scale); // outside is outside
    EXPECT_LT(p.certificate.within, 1e-14 * scale);
  };
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  embedded(order, 0x1p-200, 1);
  embedded(order, 1234.5, 1);
  embedded(order, 1, -1);
  std::mt19937 random(3);
  std::shuffle(order.begin(), order.end(), random);
  embedded(order, 1, 1);
}

// Lengths of a square, front and back, whose corners are nearly in a plane: a polyhedron with the
// height 1e-5, not the polygon, from which distances differ by 1e-11.
TEST(EmbedConvex, tellsThinPolyhedraFromPolygons) {
  const Mesh thin = hull_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1e-5}});
  const IT::Convex_polyhedron p = IT::embed_convex(IT::Corresponding_triangulation(thin));
  EXPECT_EQ(p.status, IT::Status::done);
  EXPECT_EQ(p.shape, IT::Convex_shape::polyhedron);
  EXPECT_LT(error_of_distances(p.points, thin), 1e-14);
}

// Heights that polygons lack: the lengths of front and back differ by their squares.
TEST(EmbedConvex, provesNoPolygonForAThinPolyhedronWithoutStretch) {
  for (const double height : {1e-5, 1e-6, 3e-7, 1e-7, 3e-8}) {
    SCOPED_TRACE(height);
    const Mesh thin = hull_of({{0, 0, 0}, {1, 0, height}, {1, 1, 0}, {0, 1, height}});
    const IT::Convex_polyhedron p = IT::embed_convex(IT::Corresponding_triangulation(thin));
    if (p.points.empty() || !p.certificate.is_proven) continue;
    EXPECT_LT(p.certificate.stretch, 1e-8);
    if (p.shape == IT::Convex_shape::doubly_covered_polygon) {
      EXPECT_GT(p.certificate.stretch, height * height / 8);
    } else {
      EXPECT_LT(error_of_distances(p.points, thin), 1e-14);
    }
  }
}

// Vertices that get the curvature of flat neighbours do not count as flat.
TEST(EmbedConvex, keepsCornersThatFlatNeighborsMake) {
  const Mesh mesh = hull_of(random_points(300, {1, 1, 1}, 1));
  for (const double within : {.01, .05, .1}) {
    SCOPED_TRACE(within);
    IT::Embed_options options;
    options.flat_within = within;
    const IT::Convex_polyhedron p =
        IT::embed_convex(IT::Corresponding_triangulation(mesh), options);
    ASSERT_FALSE(p.points.empty()) << IT::reason_without_points(p);
    EXPECT_LT(p.flat_vertices.size(), 290U);
    EXPECT_LT(error_of_distances(p.points, mesh), .2);
    EXPECT_EQ(p.status == IT::Status::done, std::isfinite(p.certificate.stretch));
  }
}

TEST(EmbedConvex, refusesAnglesThatAreNoneForFlatVertices) {
  const IT::Corresponding_triangulation t(box({1, 1, 1}, 1));
  for (const double angle : {-1., 1., std::nan("")}) {
    IT::Embed_options options;
    options.flat_within = angle;
    EXPECT_THROW(IT::embed_convex(t, options), IT::Invalid_input);
  }
}

// A triangulation by a fan, and its copy in a mirror, glued along the border.
IT::Intrinsic_input two_copies(const std::vector<std::array<double, 2>>& corners) {
  const auto n = static_cast<std::uint32_t>(corners.size());
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> side;
  IT::Gluing g;
  g.number_of_vertices = n;
  const auto add = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    g.origin.insert(g.origin.end(), {i, j, k});
  };
  for (std::uint32_t k = 1; k + 1 < n; ++k) add(0, k, k + 1);
  for (std::uint32_t k = 1; k + 1 < n; ++k) add(0, k + 1, k);
  const std::uint32_t half = 3 * (n - 2);
  g.glue.resize(g.origin.size());
  for (std::uint32_t h = 0; h < 2 * half; ++h) { // sides of one copy by their ends
    const std::uint32_t a = g.origin[h], b = g.origin[IT::Gluing::next(h)];
    const bool is_border = (a + 1) % n == b || (b + 1) % n == a;
    for (std::uint32_t o = 0; o < 2 * half; ++o)
      if (g.origin[o] == b && g.origin[IT::Gluing::next(o)] == a &&
          (o < half) == ((h < half) != is_border))
        g.glue[h] = o;
  }
  IT::Gluing_map map(g);
  std::vector<double> squared;
  for (const auto e : edges(map)) {
    const auto h = halfedge(e, map);
    const auto &p = corners[source(h, map).index], &q = corners[target(h, map).index];
    squared.push_back((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]));
  }
  return {std::move(map), std::move(squared), IT::Mollification::none};
}

TEST(EmbedConvex, knowsDoublyCoveredPolygons) {
  std::vector<std::vector<std::array<double, 2>>> polygons{{{0, 0}, {1, 0}, {1, 1}, {0, 1}},
                                                           {{0, 0}, {3, 0}, {1, .2}},
                                                           {{0, 0}, {1, 0}, {1, .02}, {0, .02}}};
  for (const std::size_t n : {5U, 12U, 40U}) {
    polygons.emplace_back();
    for (std::size_t k = 0; k < n; ++k) {
      const double a = 2 * std::numbers::pi * static_cast<double>(k * k + 3 * k) /
                       static_cast<double>(n * n + 3 * n);
      polygons.back().push_back({std::cos(a), .3 * std::sin(a)});
    }
  }
  for (const auto& corners : polygons) {
    SCOPED_TRACE(std::to_string(corners.size()) + " corners");
    const IT::Convex_polyhedron p =
        IT::embed_convex(IT::Corresponding_triangulation(two_copies(corners)));
    ASSERT_EQ(p.status, IT::Status::done) << p.steps;
    EXPECT_EQ(p.shape, IT::Convex_shape::doubly_covered_polygon);
    for (std::size_t v = 0; v < corners.size(); ++v) {
      EXPECT_EQ(p.points[v][2], 0);
      for (std::size_t w = 0; w < v; ++w)
        EXPECT_NEAR(distance(p.points[v], p.points[w]),
                    std::hypot(corners[v][0] - corners[w][0], corners[v][1] - corners[w][1]),
                    1e-12);
    }
  }
}

// Four copies of an acute triangle with sides 1, a, a: a rectangle whose border is folded.
TEST(EmbedConvex, gluesRectanglesToTetrahedra) {
  for (const double a : {.71, 1., 4.}) {
    IT::Gluing g;
    g.number_of_vertices = 4;
    g.origin = {0, 1, 2, 1, 0, 3, 2, 3, 0, 3, 2, 1};
    g.glue.resize(12);
    for (std::uint32_t h = 0; h < 12; ++h)
      for (std::uint32_t o = 0; o < 12; ++o)
        if (g.origin[h] == g.origin[IT::Gluing::next(o)] &&
            g.origin[o] == g.origin[IT::Gluing::next(h)])
          g.glue[h] = o;
    IT::Gluing_map map(g);
    std::vector<double> squared;
    for (const auto e : edges(map)) {
      const auto h = halfedge(e, map);
      const std::uint32_t low = std::min(source(h, map).index, target(h, map).index),
                          high = std::max(source(h, map).index, target(h, map).index);
      squared.push_back((low == 0 && high == 1) || (low == 2 && high == 3) ? 1 : a * a);
    }
    const IT::Convex_polyhedron p =
        IT::embed_convex(IT::Corresponding_triangulation(IT::Intrinsic_input(map, squared)));
    ASSERT_EQ(p.status, IT::Status::done);
    // opposite edges of length 1 are at right angles, at the distance sqrt(a^2 - 1/2)
    const auto middle = [&](std::size_t v, std::size_t w) {
      Point m{};
      for (std::size_t k = 0; k < 3; ++k) m[k] = (p.points[v][k] + p.points[w][k]) / 2;
      return m;
    };
    EXPECT_NEAR(distance(middle(0, 1), middle(2, 3)), std::sqrt(a * a - .5), 1e-14);
  }
}

TEST(EmbedConvex, namesWhatIsNotConvex) {
  Mesh mesh = box({1, 1, 1}, 2);
  for (const auto v : mesh.vertices())
    if (mesh.point(v) == Kernel::Point_3(.5, .5, 1)) mesh.point(v) = {.5, .5, .5};
  const auto message = [](const auto& t) -> std::string {
    try {
      IT::embed_convex(t);
    } catch (const IT::Invalid_input& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(message(IT::Corresponding_triangulation(mesh)).find("has angles that sum to"),
            std::string::npos);
  Mesh disk;
  const auto a = disk.add_vertex({0, 0, 0}), b = disk.add_vertex({1, 0, 0}),
             c = disk.add_vertex({0, 1, 0});
  disk.add_face(a, b, c);
  EXPECT_NE(message(IT::Corresponding_triangulation(disk)).find("--domain closed"),
            std::string::npos);
}

TEST(EmbedConvex, stopsWhenAsked) {
  const IT::Corresponding_triangulation t =
      lengths_only(hull_of(random_points(60, {1, .6, .3}, 3)), 5);
  IT::Embed_options options;
  options.maximum_steps = 2;
  EXPECT_EQ(IT::embed_convex(t, options).status, IT::Status::cap);
  options.maximum_steps = 1000;
  std::size_t calls = 0;
  options.progress = [&](const IT::Embedding_progress& p) {
    EXPECT_LE(p.curvature_left, 1);
    return ++calls < 3;
  };
  const IT::Convex_polyhedron p = IT::embed_convex(t, options);
  EXPECT_EQ(p.status, IT::Status::cancelled);
  EXPECT_TRUE(p.points.empty());
  EXPECT_EQ(calls, 3U);
}

// A box whose faces are paraboloids.
Mesh bent_box(int points_by_axis, double bend, unsigned seed) {
  std::vector<Point> points;
  for (int c = 0; c < 8; ++c)
    points.push_back({c % 2 * 2. - 1, c / 2 % 2 * 2. - 1, c / 4 * 2. - 1});
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (int k = 0; k < points_by_axis; ++k) {
      Point p{uniform(random), uniform(random), uniform(random)};
      const std::size_t a = (axis + 1) % 3, b = (axis + 2) % 3;
      p[axis] = (k % 2 * 2 - 1) * (1 + bend * (2 - p[a] * p[a] - p[b] * p[b]));
      points.push_back(p);
    }
  return hull_of(points);
}

// Curvatures of the surface are 1e-9 to 1e-5, or 1e-13 to 1e-9: lengths are rounded by 1e-16.
TEST(EmbedConvex, findsFacesThatAreHardlyBent) {
  for (const double bend : {1e-3, 1e-5}) {
    SCOPED_TRACE(std::to_string(bend));
    const Mesh mesh = bent_box(40, bend, 2);
    IT::Embed_options options;
    options.flat_within = 1e-12;
    const IT::Convex_polyhedron p = IT::embed_convex(lengths_only(mesh, 4), options);
    ASSERT_EQ(p.status, IT::Status::done) << IT::reason_without_points(p);
    EXPECT_LT(error_of_distances(p.points, mesh), bend * 1e-1);
    EXPECT_TRUE(p.certificate.is_proven);
    EXPECT_LT(p.certificate.within, 1e-14);
    EXPECT_TRUE(bend < 1e-3 || p.flat_vertices.empty());
  }
}

// Derivatives are so nearly singular that a proof takes more than 64 bits.
TEST(EmbedConvex, provesFacesWithTheLeastBends) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const Mesh mesh = bent_box(20, 1e-7, seed);
    IT::Embed_options options;
    options.flat_within = 1e-15;
    const IT::Convex_polyhedron p = IT::embed_convex(lengths_only(mesh, 4), options);
    ASSERT_EQ(p.status, IT::Status::done) << IT::reason_without_points(p);
    EXPECT_LT(error_of_distances(p.points, mesh), 1e-7);
    EXPECT_TRUE(p.certificate.is_proven) << seed;
    EXPECT_LT(p.certificate.within, 1e-14);
  }
}

TEST(EmbedConvex, asksInEveryStageWhetherToGoOn) {
  const IT::Corresponding_triangulation t(box({1, 1, .3}, 3));
  std::vector<IT::Embedding_stage> stages;
  IT::Embed_options options;
  options.progress = [&](const IT::Embedding_progress& p) {
    stages.push_back(p.stage);
    return true;
  };
  ASSERT_EQ(IT::embed_convex(t, options).status, IT::Status::done);
  EXPECT_EQ(std::set(stages.begin(), stages.end()).size(), 5U);
  const std::vector<IT::Embedding_stage> all = stages;
  for (std::size_t last = 0; last < all.size(); ++last) {
    stages.clear();
    options.progress = [&](const IT::Embedding_progress& p) {
      stages.push_back(p.stage);
      return stages.size() <= last;
    };
    const IT::Convex_polyhedron p = IT::embed_convex(t, options);
    EXPECT_EQ(p.status, IT::Status::cancelled);
    EXPECT_TRUE(p.points.empty());
    EXPECT_EQ(stages.size(), last + 1);
    EXPECT_NE(IT::reason_without_points(p).find(IT::name_of(p.stage)), std::string::npos);
  }
}

} // namespace
