// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_geodesics/voronoi/voronoi_cells.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include "gallery.h"
#include "meshes.h"
#include "numbered_as_mesh.h"
#include "paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

// Distances change by no more than a source or target moves, as near to a corner as doubles go.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Surface_point;
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                                  IT::Integer_coordinates>;
using Distance = IT::Polyhedral_distance<Triangulation>;

/// A point at 10^-1 to 10^-18 of a side from a corner, or also from a side.
template <class T>
Surface_point near_corner(const T& t, std::mt19937& random) {
  const auto uniform = [&random] { return static_cast<double>(random()) / 0x1p32; };
  const double a = uniform() * std::pow(10, -1 - double(random() % 18)) / 2;
  const double b = random() % 4 == 0 ? 0 : uniform() * std::pow(10, -1 - double(random() % 18)) / 2;
  const auto f = static_cast<std::uint32_t>(random() % num_faces(t.mesh()));
  auto h = halfedge(t.numbers().face_at(f), t.mesh());
  for (auto k = random() % 3; k > 0; --k) h = next(h, t.mesh());
  return {t.numbers().halfedge(h), {1 - a - b, a, b}};
}

double length_of_move(const Triangulation& t, const meshes::Mesh& m, const Surface_point& p,
                      const Surface_point& q) {
  std::array<double, 3> v{};
  auto h = t.numbers().halfedge_at(p.halfedge);
  for (std::size_t k = 0; k < 3; ++k, h = next(h, t.mesh()))
    for (std::size_t j = 0; j < 3; ++j)
      v[j] += (p.weights[k] - q.weights[k]) * m.points[t.index(source(h, t.mesh()))][j];
  return std::hypot(v[0], v[1], v[2]);
}

TEST(PlacesNearCorners, distances_are_continuous) {
  std::mt19937 random(52);
  double most = 0;
  for (unsigned i = 0; i < 60; ++i) {
    SCOPED_TRACE(i);
    const meshes::Mesh m = meshes::potato(1, i);
    const Triangulation t = numbered_as<Triangulation>(m);
    for (int k = 0; k < 8; ++k) {
      const Surface_point p = near_corner(t, random), r = near_corner(t, random);
      const Surface_point corner{p.halfedge, {1, 0, 0}};
      const Distance from_point(t, p), from_corner(t, corner), back(t, r);
      const double moved = length_of_move(t, m, p, corner);
      for (const auto v : vertices(t.mesh()))
        most = std::max(most, std::abs(from_point.distance(v) - from_corner.distance(v)) - moved);
      most = std::max(most, std::abs(from_point.distance(r) - from_corner.distance(r)) - moved);
      most = std::max(most, std::abs(from_point.distance(r) - back.distance(p)));
    }
  }
  EXPECT_LE(most, 1e-12); // diameters are about 4
}

// ---- Searches on a copy that is flipped

using Exact = IT::Corresponding_triangulation;
using Exact_distance = IT::Polyhedral_distance<Exact>;

// A vertex, or a point in a face, near a corner or on an edge.
Surface_point any_place(const Exact& t, std::mt19937& random) {
  Surface_point p = random() % 2 == 0 ? near_corner(t, random) : paths::random_point(t, random);
  if (random() % 5 == 0) p.weights = {p.weights[0], 1 - p.weights[0], 0};
  if (random() % 5 == 0) p.weights = {0, 1, 0};
  return p;
}

// A torus whose edges wind around it: its faces are long and thin.
meshes::Mesh turned_torus() {
  constexpr std::uint32_t n = 30, m = 40, turn = 12;
  meshes::Mesh result;
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < m; ++j) {
      const double a = 2 * std::numbers::pi * i / n, b = 2 * std::numbers::pi * j / m;
      const double r = 1 + .35 * std::cos(b);
      result.points.push_back({r * std::cos(a), r * std::sin(a), .35 * std::sin(b)});
      const std::uint32_t there = (i + 1) % n * m, p = i * m + j, q = i * m + (j + 1) % m;
      const std::uint32_t s = there + (j + 1 + turn) % m, t = there + (j + turn) % m;
      result.triangles.push_back({p, q, t});
      result.triangles.push_back({q, s, t});
    }
  return result;
}

// The same distances with flips and without. Returns how many windows the search had, by both.
std::array<std::uint64_t, 2> expect_same_distances(const Exact& t, std::mt19937& random) {
  std::array<std::uint64_t, 2> windows{};
  auto flipped = Exact_distance::on_faces(t), given = Exact_distance::as_given(t);
  for (int k = 0; k < 6; ++k) {
    const std::vector<Surface_point> sources{any_place(t, random), any_place(t, random)};
    flipped.search(sources);
    given.search(sources);
    const auto expect_same = [&](const auto& p) {
      const double d = given.distance(p);
      if (flipped.is_on_faces()) {
        EXPECT_LE(flipped.distance(p), d * (1 + 1e-12)); // from side to side, too
      } else if (d < std::numeric_limits<double>::infinity()) {
        EXPECT_NEAR(flipped.distance(p), d, 1e-12 * (1 + d));
      } else {
        EXPECT_EQ(flipped.distance(p), d);
      }
    };
    for (const auto v : vertices(t.mesh())) expect_same(v);
    for (int i = 0; i < 6; ++i) expect_same(any_place(t, random));
    windows[0] += flipped.number_of_windows();
    windows[1] += given.number_of_windows();
  }
  return windows;
}

TEST(FlippedSearch, has_the_distances_of_the_given_triangulation) {
  std::mt19937 random(4);
  for (const gallery::Surface& s : gallery::oriented()) {
    SCOPED_TRACE(s.name);
    expect_same_distances(Exact(gallery::input(s)), random);
  }
  for (unsigned seed = 0; seed < 3; ++seed)
    expect_same_distances(Exact(meshes::rough_grid(6, seed).input()), random);
  expect_same_distances(Exact(meshes::sheared_grid(6, 6, 9).input()), random);
  const auto [flipped, given] = expect_same_distances(Exact(turned_torus().input()), random);
  EXPECT_LT(2 * flipped, given); // which is what flips are for
}

TEST(FlippedSearch, is_on_covers_too) {
  std::mt19937 random(9);
  const meshes::Mesh m = meshes::rough_grid(5, 7);
  IT::Triangle_soup soup;
  soup.points = m.points;
  soup.triangles = m.triangles;
  soup.triangles.push_back({7, 8, 30}); // a third face at an edge
  const Exact t(IT::make_domain(soup).input);
  ASSERT_TRUE(t.input().names().is_cover());
  expect_same_distances(t, random);
  auto flipped = Exact_distance(t), given = Exact_distance::as_given(t); // on the cover itself
  for (int k = 0; k < 6; ++k) {
    const Surface_point p = any_place(t, random);
    flipped.search(p);
    given.search(p);
    for (const auto v : vertices(t.mesh()))
      EXPECT_NEAR(flipped.distance(v), given.distance(v), 1e-12 * (1 + given.distance(v)));
  }
}

// Paths, vectors and cells are on the triangulation, as without flips.
TEST(FlippedSearch, has_paths_and_cells_on_the_triangulation) {
  std::mt19937 random(5);
  const Exact t(meshes::sheared_grid(6, 6, 9).input());
  auto flipped = Exact_distance(t), given = Exact_distance::as_given(t);
  for (int k = 0; k < 8; ++k) {
    const std::vector<Surface_point> sources{any_place(t, random), paths::random_point(t, random)};
    flipped.search(sources.front());
    given.search(sources.front());
    const Surface_point p = any_place(t, random);
    EXPECT_NEAR(paths::length_of_path(t, flipped.shortest_path(p).points), given.distance(p),
                1e-12);
    flipped.add_source(sources.back()); // paths are found anew
    given.add_source(sources.back());
    const IT::Tangent_vector x = flipped.logarithm(p), y = given.logarithm(p);
    EXPECT_EQ(x.point.halfedge, y.point.halfedge);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(x.vector[i], y.vector[i], 1e-12);
    const IT::Voronoi_cells cells = IT::voronoi_cells(flipped), expected = IT::voronoi_cells(given);
    ASSERT_EQ(cells.areas.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(cells.areas[i], expected.areas[i], 1e-9);
    EXPECT_EQ(cells.breaks.size(), expected.breaks.size());
    flipped.search(sources, IT::parameters::targets(p));
    EXPECT_EQ(flipped.shortest_path(p).length, flipped.distance(p));
    EXPECT_EQ(flipped.shortest_path(p).status, IT::Status::done);
  }
}

TEST(FlippedSearch, refuses_places_of_another_triangulation) {
  const Exact t(meshes::sheared_grid(6, 6, 9).input()), larger(meshes::rough_grid(20, 1).input());
  const auto refuses = [](const auto& search, const auto& place) {
    try {
      search(place);
      return std::string("no error");
    } catch (const IT::Invalid_input& e) {
      return std::string(e.what());
    }
  };
  const auto f = larger.numbers().face_at(700);
  const Surface_point far{larger.numbers().halfedge(halfedge(f, larger.mesh())), {.2, .3, .5}};
  const auto v = larger.numbers().vertex_at(400);
  for (auto d : {&Exact_distance::as_given, &Exact_distance::on_faces}) {
    Exact_distance distance = d(t);
    EXPECT_NE(refuses([&](const auto& p) { distance.search(p); }, far).find("of another"),
              std::string::npos);
    EXPECT_NE(refuses([&](const auto& p) { distance.search(p); }, v).find("of another"),
              std::string::npos);
    distance.search(t.numbers().vertex_at(0));
    EXPECT_NE(refuses([&](const auto& p) { distance.distance(p); }, far).find("of another"),
              std::string::npos);
  }
}

} // namespace
