// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_geodesics/voronoi/voronoi_cells.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/triangulation/measures.h>

#include "meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

// Oracles: a search from each source alone, at random points and on boundaries; fine samples of
// faces; closed forms in the plane and on a cube.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
namespace parameters = IT::parameters;
using IT::Surface_point;
using Triangulation = IT::Corresponding_triangulation;
using Vertex = Triangulation::vertex_descriptor;
using Distance = IT::Polyhedral_distance<Triangulation>;

Surface_point point_in(const Triangulation& t, std::uint32_t face,
                       const std::array<double, 3>& weights) {
  return {t.numbers().halfedge(halfedge(t.numbers().face_at(face), t.mesh())), weights};
}

std::vector<Surface_point> random_points(const Triangulation& t, std::size_t n, unsigned seed,
                                         bool also_vertices) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> u(0, 1);
  std::vector<Surface_point> result;
  while (result.size() < n) {
    const double a = u(random), b = u(random) * (1 - a);
    const auto f = static_cast<std::uint32_t>(random() % num_faces(t.mesh()));
    const bool is_vertex = also_vertices && result.size() % 2 == 0;
    result.push_back(point_in(
        t, f, is_vertex ? std::array<double, 3>{1, 0, 0} : std::array<double, 3>{1 - a - b, a, b}));
  }
  return result;
}

/// A surface, sources, and what is known of them.
struct Case {
  Case(const Triangulation& of, const std::vector<Surface_point>& sources, double tol)
      : t(of), tolerance(tol), all(of, sources),
        cells(IT::voronoi_cells(all, parameters::tolerance(tol))) {
    for (const Surface_point& p : sources) alone.emplace_back(of, p);
    cell_of_source.resize(sources.size());
    std::iota(cell_of_source.begin(), cell_of_source.end(), 0U);
  }
  /// A cell for each set of sources.
  Case(const Triangulation& of, const std::vector<std::vector<Surface_point>>& sets, double tol)
      : t(of), tolerance(tol), all(of, sets) {
    for (const auto& set : sets) {
      cell_of_source.insert(cell_of_source.end(), set.size(),
                            static_cast<std::uint32_t>(alone.size()));
      alone.emplace_back(of, set);
    }
    cells = IT::voronoi_cells(all, cell_of_source, parameters::tolerance(tol));
  }
  /// The cell of a vertex.
  std::uint32_t cell_at(Vertex v) const { return cell_of_source[all.nearest_source(v)]; }

  const Triangulation& t;
  double tolerance;
  Distance all;
  IT::Voronoi_cells cells;
  std::vector<Distance> alone;
  std::vector<std::uint32_t> cell_of_source{};
};

/// A point is that near to one where two of the nearest sources are as near: distances change by no
/// more than points move.
void expect_tie(const Case& c, const Surface_point& p, std::uint32_t a, std::uint32_t b) {
  const double least = c.all.distance(p), rounding = 1e-10 * (1 + least);
  EXPECT_LE(c.alone[a].distance(p), least + 2 * c.tolerance + rounding);
  EXPECT_LE(c.alone[b].distance(p), least + 2 * c.tolerance + rounding);
  EXPECT_NE(a, b);
}

Surface_point between(const std::array<Surface_point, 2>& piece, double s, const Triangulation& t) {
  // both in the order of corners of the first
  const Surface_point q = IT::seen_from(IT::Intrinsic_view(t), piece[1], piece[0].halfedge);
  Surface_point p = piece[0];
  for (std::size_t k = 0; k < 3; ++k) p.weights[k] = std::lerp(p.weights[k], q.weights[k], s);
  return p;
}

void expect_ties_on_boundaries(const Case& c) {
  for (const IT::Cell_boundary& b : c.cells.boundaries)
    for (const auto& piece : b.pieces)
      for (const double s : {0.0, 0.3, 0.5, 1.0})
        expect_tie(c, between(piece, s, c.t), b.left, b.right);
  for (const IT::Cell_junction& j : c.cells.junctions) {
    EXPECT_GE(j.sources.size(), 3U);
    for (std::size_t k = 0; k < j.sources.size(); ++k)
      expect_tie(c, j.point, j.sources[k], j.sources[(k + 1) % j.sources.size()]);
  }
}

/// Between breaks, edges have the source that the breaks say.
void expect_labels_on_edges(const Case& c) {
  std::map<std::uint32_t, std::vector<IT::Cell_break>> of_edge;
  for (const IT::Cell_break& b : c.cells.breaks) of_edge[b.point.halfedge / 2].push_back(b);
  const auto expect_near = [&](const Surface_point& p, std::uint32_t label) {
    const double least = c.all.distance(p);
    EXPECT_NEAR(c.alone[label].distance(p), least, 1e-10 * (1 + least));
  };
  for (const auto h : halfedges(c.t.mesh())) {
    if (CGAL::is_border(h, c.t.mesh())) continue;
    const std::uint32_t number = c.t.numbers().halfedge(h);
    const auto found = of_edge.find(number / 2);
    const auto breaks = found == of_edge.end() ? std::vector<IT::Cell_break>() : found->second;
    if (!breaks.empty() && breaks.front().point.halfedge != number) continue;
    double begin = 0;
    std::uint32_t label = c.cell_at(source(h, c.t.mesh()));
    for (std::size_t i = 0; i <= breaks.size(); ++i) {
      const double end = i < breaks.size() ? breaks[i].point.parameter : 1;
      EXPECT_LE(begin, end);
      for (const double s : {0.01, 0.5, 0.99}) {
        const double x = std::lerp(begin, end, s);
        expect_near({number, {1 - x, x, 0}}, label);
      }
      if (i == breaks.size()) break;
      EXPECT_EQ(breaks[i].before, label);
      label = breaks[i].after;
      begin = end;
    }
    EXPECT_EQ(label, c.cell_at(target(h, c.t.mesh())));
  }
}

/// Areas sum to the whole, and are those of a fine sample, except where a small triangle may be
/// parted: where a second source is as near up to its diameter.
void expect_areas(const Case& c, const meshes::Mesh& m) {
  constexpr int n = 12; // n^2 small triangles of equal area in a face
  std::vector<double> least(c.cells.areas.size()), most(least);
  for (std::uint32_t f = 0; f < m.triangles.size(); ++f) {
    const meshes::Triangle& corners = m.triangles[f];
    double diameter = 0;
    for (std::size_t k = 0; k < 3; ++k)
      diameter = std::max(
          diameter, meshes::distance(m.points[corners[k]], m.points[corners[(k + 1) % 3]]) / n);
    const double area = meshes::norm(meshes::area_vector(m.points, corners)) / (n * n);
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < 2 * (n - i) - 1; ++k) { // the triangles of row i
        const double a = (i + (k % 2 == 0 ? 1 : 2) / 3.0) / n;
        const double b = (k / 2 + (k % 2 == 0 ? 1 : 2) / 3.0) / n;
        const Surface_point p = point_in(c.t, f, {1 - a - b, a, b});
        const double nearest = c.all.distance(p);
        std::vector<std::size_t> near;
        for (std::size_t s = 0; s < least.size(); ++s)
          if (c.alone[s].distance(p) <= nearest + 2 * (diameter + c.tolerance)) near.push_back(s);
        if (near.size() == 1) least[near[0]] += area;
        for (const std::size_t s : near) most[s] += area;
      }
  }
  const double whole = IT::total_area(c.t);
  EXPECT_NEAR(std::accumulate(c.cells.areas.begin(), c.cells.areas.end(), 0.0), whole,
              1e-11 * whole);
  for (std::size_t s = 0; s < least.size(); ++s) {
    EXPECT_GE(c.cells.areas[s], least[s] - 1e-9 * whole);
    EXPECT_LE(c.cells.areas[s], most[s] + 1e-9 * whole);
  }
}

void expect_lines_join(const Case& c, bool has_border) {
  std::size_t ends = 0, at_junctions = 0;
  for (const IT::Cell_boundary& b : c.cells.boundaries) {
    ASSERT_FALSE(b.pieces.empty());
    for (std::size_t i = 0; i < b.pieces.size(); ++i) {
      const bool is_last = i + 1 == b.pieces.size();
      if (is_last && !b.is_closed) continue;
      EXPECT_NEAR(c.all.distance(b.pieces[i][1]), c.all.distance(b.pieces[is_last ? 0 : i + 1][0]),
                  1e-9);
    }
    if (!b.is_closed) ends += 2;
  }
  for (const IT::Cell_junction& j : c.cells.junctions) at_junctions += j.sources.size();
  if (has_border)
    EXPECT_LE(at_junctions, ends);
  else
    EXPECT_EQ(at_junctions, ends);
}

void expect_cells(const Case& c) {
  EXPECT_EQ(c.cells.status, IT::Status::done);
  expect_ties_on_boundaries(c);
  expect_labels_on_edges(c);
}

TEST(Voronoi_cells, are_those_of_searches_from_each_source_alone) {
  unsigned seed = 0;
  for (const meshes::Mesh& m :
       {meshes::grid(5, 6), meshes::rough_grid(6, 5), meshes::sphere(2), meshes::potato(2, 3),
        meshes::box(3, 2, 2), meshes::stairs(3, 3), meshes::sheared_grid(4, 4, 3.7)}) {
    SCOPED_TRACE(++seed);
    const Triangulation t(m.input());
    for (const std::size_t n : {2U, 9U}) {
      const Case c(t, random_points(t, n, 10 * seed, true), 1e-3);
      expect_cells(c);
      expect_areas(c, m);
      expect_lines_join(c, true);
    }
  }
}

TEST(Voronoi_cells, of_sets_are_those_of_searches_from_each_set_alone) {
  unsigned seed = 0;
  for (const meshes::Mesh& m : {meshes::rough_grid(6, 5), meshes::sphere(2), meshes::box(3, 2, 2),
                                meshes::sheared_grid(4, 4, 3.7)}) {
    SCOPED_TRACE(++seed);
    const Triangulation t(m.input());
    const auto points = random_points(t, 10, 10 * seed, true);
    std::vector<std::vector<Surface_point>> sets(4);
    for (std::size_t i = 0; i < points.size(); ++i) sets[i % 4].push_back(points[i]);
    const Case c(t, sets, 1e-3);
    expect_cells(c);
    expect_areas(c, m);
    expect_lines_join(c, true);
  }
}

TEST(Voronoi_cells, of_closed_surfaces_end_at_junctions_only) {
  for (const meshes::Mesh& m : {meshes::sphere(2), meshes::potato(2, 8), meshes::box(2, 2, 2)}) {
    const Triangulation t(m.input());
    const Case c(t, random_points(t, 12, 3, true), 1e-4);
    expect_cells(c);
    expect_lines_join(c, false);
  }
}

TEST(Voronoi_cells, do_not_depend_on_the_triangulation) {
  const meshes::Mesh m = meshes::rough_grid(8, 21);
  const Triangulation t(m.input());
  Triangulation flipped(m.input());
  IT::flip_to_delaunay(flipped);
  std::vector<Vertex> sources, same;
  for (const std::uint32_t i : {3U, 17U, 30U, 44U, 61U, 70U}) {
    sources.push_back(t.numbers().vertex_at(i));
    same.push_back(flipped.numbers().vertex_at(i));
  }
  const auto tolerance = parameters::tolerance(1e-5);
  const auto a = IT::voronoi_cells(Distance(t, sources), tolerance);
  const auto b = IT::voronoi_cells(Distance(flipped, same), tolerance);
  double length = 0, other_length = 0;
  for (const auto& line : a.boundaries) length += IT::trace_boundary(t, line).length;
  for (const auto& line : b.boundaries) other_length += IT::trace_boundary(flipped, line).length;
  EXPECT_NEAR(length, other_length, 1e-3 * length);
  for (std::size_t i = 0; i < sources.size(); ++i)
    EXPECT_NEAR(a.areas[i], b.areas[i], 2e-5 * length);
}

TEST(Voronoi_cells, of_many_sources_in_one_triangle_are_planar) {
  meshes::Mesh m;
  m.points = {{0, 0, 0}, {4, 0, 0}, {1, 3, 0}};
  m.triangles = {{0, 1, 2}};
  const Triangulation t(m.input());
  for (const unsigned seed : {1U, 2U, 3U}) {
    const auto sources = random_points(t, 12, seed, false);
    const Case c(t, sources, 1e-6);
    expect_cells(c);
    expect_areas(c, m);
    expect_lines_join(c, true);
    // lines are straight: as long as the way between their ends
    for (const IT::Cell_boundary& b : c.cells.boundaries) {
      const auto at = [&](const Surface_point& p) {
        return meshes::position(t.input(), m.points, p);
      };
      double length = 0;
      for (const auto& [p, q] : b.pieces) length += meshes::distance(at(p), at(q));
      const auto first = at(b.pieces.front()[0]), last = at(b.pieces.back()[1]);
      EXPECT_NEAR(length, meshes::distance(first, last), 1e-5);
      const auto l = at(sources[b.left]), r = at(sources[b.right]);
      for (const auto& p : {first, last})
        EXPECT_NEAR(meshes::distance(p, l), meshes::distance(p, r), 2e-6);
    }
  }
}

TEST(Voronoi_cells, of_the_corners_of_a_cube_are_alike) {
  const meshes::Mesh m = meshes::box(2, 2, 2); // corners at even coordinates
  const Triangulation t(m.input());
  std::vector<Surface_point> sources;
  for (std::uint32_t f = 0; f < m.triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& x = m.points[m.triangles[f][k]];
      const bool is_corner = x[0] != 1 && x[1] != 1 && x[2] != 1;
      std::array<double, 3> weights{0, 0, 0};
      weights[k] = 1;
      const Surface_point p = point_in(t, f, weights);
      const auto is_same = [&](const Surface_point& q) {
        return meshes::distance(meshes::position(t.input(), m.points, q), x) < 1e-9;
      };
      if (is_corner && std::ranges::none_of(sources, is_same)) sources.push_back(p);
    }
  ASSERT_EQ(sources.size(), 8U);
  const Case c(t, sources, 1e-5);
  expect_cells(c);
  expect_lines_join(c, false);
  for (const double area : c.cells.areas) EXPECT_NEAR(area, 3, 1e-4); // of 24
  double length = 0; // four halves of middle lines on each of the six sides
  for (const IT::Cell_boundary& b : c.cells.boundaries) length += IT::trace_boundary(t, b).length;
  EXPECT_NEAR(length, 24, 1e-3);
}

TEST(Voronoi_cells, of_one_set_have_no_boundary) {
  const meshes::Mesh m = meshes::potato(2, 2);
  const Triangulation t(m.input());
  const std::vector sets(1, random_points(t, 7, 2, true));
  const Case c(t, sets, 1e-3);
  EXPECT_TRUE(c.cells.boundaries.empty());
  EXPECT_TRUE(c.cells.breaks.empty());
  EXPECT_NEAR(c.cells.areas.front(), IT::total_area(t), 1e-11 * c.cells.areas.front());
  EXPECT_THROW(IT::voronoi_cells(c.all, std::vector<std::uint32_t>(6)), std::invalid_argument);
}

TEST(Voronoi_cells, of_one_source_have_no_boundary) {
  const meshes::Mesh m = meshes::potato(2, 1);
  const Triangulation t(m.input());
  const auto cells = IT::voronoi_cells(Distance(t, t.numbers().vertex_at(0)));
  EXPECT_TRUE(cells.boundaries.empty() && cells.breaks.empty() && cells.junctions.empty());
  EXPECT_NEAR(cells.areas.front(), IT::total_area(t), 1e-12 * IT::total_area(t));
}

TEST(Voronoi_cells, need_a_search_that_went_everywhere) {
  const Triangulation t(meshes::grid(4, 4).input());
  const Distance d(t, t.numbers().vertex_at(0), parameters::maximum_distance(2));
  EXPECT_THROW(IT::voronoi_cells(d), std::invalid_argument);
}

} // namespace
