// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_simplification/simplification/hierarchy.h>
#include <CGAL/Intrinsic_simplification/simplification/prolongation.h>
#include <CGAL/Intrinsic_simplification/simplification/remove_flat_vertices.h>
#include <CGAL/Intrinsic_simplification/simplification/simplify.h>
#include <CGAL/Intrinsic_triangulations/connectivity/topology.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/points_of_rows.h>
#include <CGAL/Intrinsic_triangulations/triangulation/measures.h>

#include "gallery.h"
#include "operator_test_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace {

using namespace operator_test;
using T = IT::Corresponding_triangulation;

T delaunay(IT::Intrinsic_input input) { return IT::delaunay_triangulation(std::move(input)); }

T delaunay(const Shape& s) { return delaunay(s.input()); }

IT::Simplify_options to(std::size_t vertices) {
  IT::Simplify_options options;
  options.vertices = vertices;
  return options;
}

// A cube whose faces are grids of n times n squares.
Shape cube_of_grids(int n) {
  Shape s;
  std::map<std::array<int, 3>, std::uint32_t> number;
  const auto vertex = [&](const std::array<int, 3>& p) {
    const auto [at, is_new] = number.emplace(p, static_cast<std::uint32_t>(number.size()));
    if (is_new)
      s.points.push_back(
          {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
    return at->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const int level : {0, n})
      for (int x = 0; x < n; ++x)
        for (int y = 0; y < n; ++y) {
          const auto at = [&](int a, int b) {
            std::array<int, 3> p;
            p[axis] = level;
            p[(axis + 1) % 3] = level > 0 ? a : b;
            p[(axis + 2) % 3] = level > 0 ? b : a;
            return vertex(p);
          };
          const std::uint32_t a = at(x, y), b = at(x + 1, y), c = at(x + 1, y + 1),
                              d = at(x, y + 1);
          s.triangles.push_back({a, b, c});
          s.triangles.push_back({a, c, d});
        }
  return s;
}

double total_curvature(const T& t) {
  double sum = 0;
  for (const auto v : vertices(t.mesh())) sum += IT::gaussian_curvature(t, v);
  return sum;
}

// The coarse surface is a surface: proper triangles, Delaunay, with the topology of the fine one,
// and each vertex has a place on it.
void expect_surface(const T& fine, const IT::Simplification& s) {
  const T coarse(s.surface);
  EXPECT_EQ(coarse.input().report().degenerate_faces, 0U);
  EXPECT_EQ(IT::euler_characteristic(coarse.mesh()), IT::euler_characteristic(fine.mesh()));
  EXPECT_EQ(IT::boundary_loops(coarse.mesh()).size(), IT::boundary_loops(fine.mesh()).size());
  EXPECT_NEAR(total_curvature(coarse), total_curvature(fine), 1e-9);
  EXPECT_EQ(s.kept.size() + s.removed, num_vertices(fine.mesh()));
  EXPECT_EQ(num_vertices(coarse.mesh()), s.kept.size());
  EXPECT_EQ(s.places.size(), fine.number_of_vertices());
  EXPECT_EQ(s.face_stretch.size(), num_faces(coarse.mesh()));
  for (std::uint32_t c = 0; c < s.kept.size(); ++c) EXPECT_EQ(s.places[s.kept[c]].vertex, c);
  for (const IT::Place& p : s.places)
    if (!p.is_vertex()) {
      EXPECT_LT(p.face, num_faces(coarse.mesh()));
      for (const double w : p.weights) EXPECT_GE(w, 0);
      EXPECT_NEAR(p.weights[0] + p.weights[1] + p.weights[2], 1, 1e-15);
    }
  for (const auto e : edges(coarse.mesh()))
    if (!CGAL::is_border(e, coarse.mesh())) {
      EXPECT_GT(IT::cotangent_weight(coarse, e), -1e-8);
    }
}

// Exact distances from some vertices to all others that stay are within the proven bounds.
void expect_distances_within(const T& fine, const IT::Simplification& s) {
  const T coarse(s.surface);
  IT::Polyhedral_distance<T> on_fine(fine), on_coarse(coarse);
  for (std::uint32_t c = 0; c < s.kept.size(); c += 3) {
    on_fine.search(IT::vertex_of_row(fine, s.kept[c]));
    on_coarse.search(IT::vertex_of_row(coarse, c));
    const std::vector<double> a = on_fine.distances(), b = on_coarse.distances();
    for (std::uint32_t d = 0; d < s.kept.size(); ++d) {
      EXPECT_LE(b[d], a[s.kept[d]] * s.stretch.upper * (1 + 1e-12));
      EXPECT_GE(b[d], a[s.kept[d]] * s.stretch.lower * (1 - 1e-12));
    }
  }
}

TEST(Simplify, keeps_distances_within_the_proven_bounds) {
  for (const Shape& shape : {rough_torus(10, .3, 1), rough_grid(9, .3, .6, 4)}) {
    const T fine = delaunay(shape);
    for (const std::size_t vertices : {60, 25, 12}) {
      const IT::Simplification s = IT::simplify(fine, to(vertices));
      EXPECT_EQ(s.status, IT::Status::done);
      EXPECT_EQ(s.kept.size(), vertices);
      EXPECT_LT(s.stretch.lower, s.stretch.mean_lower);
      EXPECT_LT(s.stretch.mean_lower, s.stretch.mean_upper);
      EXPECT_LT(s.stretch.mean_upper, s.stretch.upper);
      expect_surface(fine, s);
      expect_distances_within(fine, s);
    }
  }
}

TEST(Simplify, stops_where_the_stretch_would_leave_its_bound) {
  const T fine = delaunay(rough_torus(10, .3, 1));
  std::size_t before = num_vertices(fine.mesh());
  for (const double most : {1.05, 1.2, 2.}) {
    IT::Simplify_options options;
    options.stretch = most;
    const IT::Simplification s = IT::simplify(fine, options);
    EXPECT_EQ(s.status, IT::Status::stalled);
    EXPECT_LE(s.stretch.upper, most);
    EXPECT_GE(s.stretch.lower, 1 / most);
    EXPECT_GT(s.kept_by_bound, 0U);
    EXPECT_LT(s.kept.size(), before);
    before = s.kept.size();
    expect_surface(fine, s);
    expect_distances_within(fine, s);
  }
}

TEST(Simplify, reproduces_linear_functions_on_a_flat_surface) {
  const Shape shape = rough_grid(12, .3, 0, 2);
  const T fine = delaunay(shape);
  const auto flat = [&](const std::vector<std::uint32_t>& kept) { // the border stays
    IT::Simplify_options options = to(50);
    options.kept_vertices = kept;
    return options;
  };
  std::vector<std::uint32_t> border;
  for (const auto h : halfedges(fine.mesh()))
    if (CGAL::is_border(h, fine.mesh()))
      border.push_back(fine.input_vertex(target(h, fine.mesh())));
  const IT::Simplification s = IT::simplify(fine, flat(border));
  ASSERT_EQ(s.kept.size(), 50U);
  EXPECT_NEAR(s.stretch.lower, 1, 2e-12);
  EXPECT_NEAR(s.stretch.upper, 1, 2e-12);
  EXPECT_LE(s.stretch.lower, 1);
  EXPECT_GE(s.stretch.upper, 1);
  const Eigen::SparseMatrix<double> p = IT::prolongation(s);
  ASSERT_EQ(p.rows(), 169);
  ASSERT_EQ(p.cols(), 50);
  EXPECT_GE(p.coeffs().minCoeff(), 0);
  Eigen::VectorXd coarse(50);
  for (Eigen::Index i = 0; i < 50; ++i) {
    const auto q = shape.points[s.kept[static_cast<std::size_t>(i)]];
    coarse[i] = 3 * q[0] - 2 * q[1] + 1;
  }
  const Eigen::VectorXd found = p * coarse;
  for (std::size_t v = 0; v < shape.points.size(); ++v)
    EXPECT_NEAR(found[static_cast<Eigen::Index>(v)],
                3 * shape.points[v][0] - 2 * shape.points[v][1] + 1, 1e-10);
}

TEST(Simplify, ends_on_every_oriented_surface) {
  for (const gallery::Surface& surface : gallery::oriented()) {
    SCOPED_TRACE(surface.name);
    T fine(gallery::input(surface));
    IT::flip_to_delaunay(fine);
    const IT::Simplification s = IT::simplify(fine, to(1));
    if (surface.expected.nonmanifold_vertices > 0) {
      EXPECT_EQ(IT::euler_characteristic(T(s.surface).mesh()) +
                    static_cast<std::ptrdiff_t>(surface.expected.isolated_vertices),
                IT::euler_characteristic(fine.mesh()));
      continue;
    }
    EXPECT_EQ(s.not_flattened, 0U);
    if (surface.expected.isolated_vertices == 0) expect_surface(fine, s);
    // without border, one more than the Euler characteristic stay, and at least one
    if (surface.expected.boundary_loops == 0 && surface.expected.components == 1) {
      EXPECT_EQ(static_cast<std::ptrdiff_t>(s.kept.size()),
                std::max<std::ptrdiff_t>(1, surface.euler_characteristic() + 1));
    }
  }
}

TEST(Simplify, keeps_a_vertex_that_no_triangles_make_flat) {
  const Shape shape{{{-5, 0, 0}, {5, 0, 0}, {0, 1, 0}, {0, -12, 30}},
                    {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  IT::Simplify_options options = to(1);
  options.kept_vertices = {0, 1, 2};
  IT::Simplification s = IT::simplify(delaunay(shape), options);
  EXPECT_EQ(s.status, IT::Status::stalled);
  EXPECT_EQ(s.kept.size(), 4U);
  EXPECT_EQ(s.blocked_by_border, 1U);
  EXPECT_EQ(s.not_flattened, 0U);
  // Without a vertex of the border, the others make room.
  s = IT::simplify(delaunay(shape), to(1));
  EXPECT_LT(s.kept.size(), 4U);
  EXPECT_EQ(s.not_flattened, 0U);
}

TEST(Simplify, keeps_vertices_and_edges_that_shall_stay) {
  const Shape shape = rough_torus(8, .3, 2);
  const T fine = delaunay(shape);
  IT::Simplify_options options = to(12);
  options.kept_vertices = {3, 17};
  const auto e = *std::next(edges(fine.mesh()).begin(), 40);
  options.kept_edges = {fine.index(e)};
  const std::uint32_t a = fine.input_vertex(source(e, fine.mesh())),
                      b = fine.input_vertex(target(e, fine.mesh()));
  const IT::Simplification s = IT::simplify(fine, options);
  EXPECT_EQ(s.kept.size(), 12U);
  for (const std::uint32_t v : {3U, 17U, a, b}) EXPECT_EQ(std::ranges::count(s.kept, v), 1);
  const T coarse(s.surface);
  double length = 0;
  for (const auto d : edges(coarse.mesh())) {
    const std::uint32_t x = s.kept[coarse.input_vertex(source(d, coarse.mesh()))],
                        y = s.kept[coarse.input_vertex(target(d, coarse.mesh()))];
    if (std::minmax(x, y) == std::minmax(a, b) &&
        std::abs(coarse.length(d) - fine.length(e)) < 1e-12)
      length = coarse.length(d);
  }
  EXPECT_NEAR(length, fine.length(e), 1e-12);
  expect_distances_within(fine, s);
  options.kept_vertices = {64};
  EXPECT_THROW(IT::simplify(fine, options), IT::Invalid_input);
  options.kept_vertices = {};
  options.kept_edges = {192};
  EXPECT_THROW(IT::simplify(fine, options), IT::Invalid_input);
  options.kept_edges = {};
  options.stretch = 0.5;
  EXPECT_THROW(IT::simplify(fine, options), IT::Invalid_input);
}

TEST(Simplify, keeps_distances_within_the_bounds_in_any_order) {
  const T fine = delaunay(rough_torus(8, .3, 2));
  for (const IT::Transported_mass& cost : {IT::curvature_cost(fine), IT::area_cost(fine)}) {
    IT::Simplify_options options = to(20);
    const IT::Simplification s = IT::simplify(fine, options, cost);
    EXPECT_EQ(s.kept.size(), 20U);
    expect_surface(fine, s);
    expect_distances_within(fine, s);
    options.cost = 0.05;
    options.vertices = 1;
    EXPECT_GT(IT::simplify(fine, options, cost).kept_by_bound, 0U);
  }
}

TEST(Simplify, takes_costs_of_the_user_and_stops_when_asked) {
  const T fine = delaunay(rough_torus(24, .3, 2));
  IT::Simplify_options options = to(100);
  // Vertices with high numbers go first; the first 50 stay.
  const auto cost = [](const IT::Removal_candidate& c) {
    return c.vertex < 50 ? std::numeric_limits<double>::infinity() : -static_cast<double>(c.vertex);
  };
  IT::Simplification s = IT::simplify(fine, options, cost);
  ASSERT_EQ(s.kept.size(), 100U);
  EXPECT_LT(std::ranges::max(s.kept), 110U);
  options.vertices = 1;
  s = IT::simplify(fine, options, cost); // in this order some removals cannot be proven
  EXPECT_EQ(s.kept.size(), 50U + s.not_flattened);
  std::size_t calls = 0;
  options.progress = [&](const IT::Simplify_progress& p) {
    ++calls;
    EXPECT_EQ(p.removed, 255U); // before the 256th
    EXPECT_EQ(p.left, 321U);
    return false;
  };
  s = IT::simplify(fine, options, cost);
  EXPECT_EQ(s.status, IT::Status::cancelled);
  EXPECT_EQ(s.kept.size(), 321U);
  EXPECT_EQ(calls, 1U);
  expect_surface(fine, s);
}

TEST(Remove_flat_vertices, leaves_the_corners_of_a_cube) {
  const T fine = delaunay(cube_of_grids(4));
  const IT::Simplification s = IT::remove_flat_vertices(fine);
  EXPECT_EQ(s.kept.size(), 8U);
  EXPECT_EQ(s.status, IT::Status::done);
  EXPECT_NEAR(s.stretch.lower, 1, 1e-12);
  EXPECT_NEAR(s.stretch.upper, 1, 1e-12);
  expect_surface(fine, s);
  expect_distances_within(fine, s);
}

TEST(Remove_flat_vertices, goes_along_a_straight_border_and_asks_for_exact_angles) {
  Shape shape = grid(6);
  EXPECT_EQ(IT::remove_flat_vertices(delaunay(shape)).kept.size(), 4U);
  // A hill of 1e-7: its curvature is below 1e-12, and not zero.
  shape.points[24][2] = 1e-7;
  const T hill = delaunay(shape);
  const IT::Simplification exact = IT::remove_flat_vertices(hill);
  EXPECT_GT(exact.kept.size(), 4U);
  EXPECT_EQ(std::ranges::count(exact.kept, 24U), 1);
  EXPECT_EQ(IT::remove_flat_vertices(hill, 1e-6).kept.size(), 4U);
  EXPECT_THROW(IT::remove_flat_vertices(hill, -1), IT::Invalid_input);
}

TEST(Hierarchy, has_a_quarter_of_the_vertices_at_each_level) {
  const T fine = delaunay(rough_torus(16, .2, 3));
  const std::vector<IT::Simplification> levels = IT::hierarchy(fine, 3);
  ASSERT_EQ(levels.size(), 3U);
  EXPECT_EQ(levels[0].kept.size(), 64U);
  EXPECT_EQ(levels[1].kept.size(), 16U);
  EXPECT_EQ(levels[2].kept.size(), 4U);
  const Eigen::SparseMatrix<double> p = IT::prolongation(levels[0]) * IT::prolongation(levels[1]);
  EXPECT_EQ(p.rows(), 256);
  EXPECT_LT((p * Eigen::VectorXd::Ones(16) - Eigen::VectorXd::Ones(256)).cwiseAbs().maxCoeff(),
            1e-14);
}

} // namespace
