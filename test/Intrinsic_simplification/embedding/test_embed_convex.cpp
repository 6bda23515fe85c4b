// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "convex_polyhedra.h"

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_simplification/embedding/embed_convex.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <vector>

// Surfaces of convex polyhedra that are known: distances in space must return from lengths alone.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using namespace convex_polyhedra;

// From the first point.
double distance_of_farthest(const std::vector<Point>& points) {
  double result = 0;
  for (const Point& p : points) result = std::max(result, distance(points.front(), p));
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

// Whatever the addresses are: all other tests are the same in each run then.
TEST(EmbedConvex, isTestedOnHullsThatKeepTheOrderOfPoints) {
  const std::vector<Point> points = random_points(300, {1, .6, .3}, 3);
  const Mesh mesh = hull_of(points);
  ASSERT_EQ(mesh.number_of_vertices(), points.size());
  for (std::size_t v = 0; v < points.size(); ++v) {
    const auto& p = mesh.point(Mesh::Vertex_index(static_cast<Mesh::size_type>(v)));
    EXPECT_EQ((Point{p.x(), p.y(), p.z()}), points[v]);
  }
  EXPECT_TRUE(mesh.is_valid(false));
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

// Lengths without rounding: nothing is stretched, and a diagonal of each side is flat.
TEST(EmbedConvex, findsExactBoxesWithoutStretch) {
  const IT::Convex_polyhedron p =
      IT::embed_convex(IT::Corresponding_triangulation(box({1, 1, .5}, 4)));
  EXPECT_TRUE(p.certificate.is_proven);
  EXPECT_EQ(p.certificate.stretch, 0);
  EXPECT_EQ(p.certificate.flat_edges, 6U);
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
