// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/read_triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>

#include "meshes.h"
#include "paths.h"
#include "refined_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <limits>
#include <queue>
#include <random>
#include <string>
#include <utility>
#include <variant>
#include <vector>

// Exact distances on the meshes of CGAL's data set. Oracles: what holds for distances on any
// surface in space.

#ifdef INTRINSIC_TRIANGULATIONS_CGAL_MESH_DIR

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>>;
using Vertex = Triangulation::vertex_descriptor;
using Distance = IT::Polyhedral_distance<Triangulation>;
using Place = std::variant<Vertex, IT::Surface_point>;

constexpr double infinity = std::numeric_limits<double>::infinity();

// Distances along edges from a vertex, by rows: the copies of a vertex are one point.
std::vector<double> along_edges(const Triangulation& t, std::uint32_t from) {
  std::vector<std::vector<std::pair<std::uint32_t, double>>> neighbours(t.number_of_vertices());
  for (const Triangulation::edge_descriptor e : edges(t.mesh())) {
    const auto h = halfedge(e, t.mesh());
    const std::uint32_t i = t.input_vertex(source(h, t.mesh()));
    const std::uint32_t j = t.input_vertex(target(h, t.mesh()));
    neighbours[i].emplace_back(j, t.length(e));
    neighbours[j].emplace_back(i, t.length(e));
  }
  std::vector<double> result(neighbours.size(), infinity);
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  result[from] = 0;
  queue.emplace(0, from);
  while (!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d > result[v]) continue;
    for (const auto& [w, length] : neighbours[v])
      if (d + length < result[w]) queue.emplace(result[w] = d + length, w);
  }
  return result;
}

// Where vertices and points in faces are in space, in the units of the file.
class Positions {
public:
  explicit Positions(const Triangulation& t) : t_(t) {}

  meshes::Point operator()(Vertex v) const {
    meshes::Point p = t_.input().metric().points()[t_.index(v)];
    for (double& x : p) x = std::ldexp(x, -t_.input().scale_exponent());
    return p;
  }
  meshes::Point operator()(const IT::Surface_point& p) const {
    meshes::Point sum{};
    auto h = t_.numbers().halfedge_at(p.halfedge);
    for (const double w : p.weights) {
      const meshes::Point corner = (*this)(source(h, t_.mesh()));
      for (std::size_t k = 0; k < 3; ++k) sum[k] += w * corner[k];
      h = next(h, t_.mesh());
    }
    return sum;
  }

private:
  const Triangulation& t_;
};

// Two vertices, and two points in faces.
std::vector<Place> random_places(const Triangulation& t, std::mt19937& random) {
  const std::vector<Vertex> all(vertices(t.mesh()).begin(), vertices(t.mesh()).end());
  std::vector<Place> result;
  for (int i = 0; i < 2; ++i) {
    result.emplace_back(all[random() % all.size()]);
    result.emplace_back(paths::random_point(t, random));
  }
  return result;
}

// What may be lost: 1e-10 of a distance, and what coordinates of points
// in faces round to, far from the origin.
class Tolerance {
public:
  explicit Tolerance(const Triangulation& t) {
    for (const Vertex v : vertices(t.mesh()))
      for (const double x : Positions(t)(v)) greatest_ = std::max(greatest_, std::abs(x));
  }
  double operator()(double distance) const { return 1e-10 * distance + 0x1p-50 * greatest_; }

private:
  double greatest_ = 0;
};

// What holds for the distances of all places and vertices from all places.
void expect_metric(const Triangulation& t, unsigned seed) {
  std::mt19937 random(seed);
  const std::vector<Place> places = random_places(t, random);
  const Positions position(t);
  const Tolerance error(t);
  std::vector<Distance> from;
  for (const Place& p : places)
    from.push_back(std::visit([&](const auto& q) { return Distance(t, q); }, p));
  const auto distance = [&](std::size_t i, const Place& p) {
    return std::visit([&](const auto& q) { return from[i].distance(q); }, p);
  };
  for (std::size_t i = 0; i < places.size(); ++i) {
    ASSERT_EQ(from[i].status(), IT::Status::done);
    const meshes::Point x = std::visit(position, places[i]);
    std::vector<double> edges;
    if (const Vertex* v = std::get_if<Vertex>(&places[i]))
      edges = along_edges(t, t.input_vertex(*v));
    for (std::size_t j = 0; j < places.size(); ++j) {
      const double there = distance(i, places[j]), back = distance(j, places[i]);
      if (there != back) { // not both infinite
        EXPECT_NEAR(there, back, error(there));
      }
    }
    for (const Vertex v : vertices(t.mesh())) {
      const double d = from[i].distance(v);
      ASSERT_GE(d, meshes::distance(x, position(v)) - error(d));
      if (!edges.empty()) {
        ASSERT_LE(d, edges[t.input_vertex(v)] + error(d));
      }
      for (std::size_t j = 0; j < places.size(); ++j) {
        const double by_way = distance(i, places[j]) + from[j].distance(v);
        if (by_way < infinity) {
          ASSERT_LE(d, by_way + error(d));
        }
      }
    }
  }
}

// Up to half a megabyte, which takes three seconds; all files hold as well, and take fourteen.
TEST(Distances_of_data_set, are_a_metric_between_chords_and_ways_along_edges) {
  std::size_t count = 0;
  for (const auto& file : refined::files(500'000)) {
    SCOPED_TRACE(file.string());
    IT::Intrinsic_input in;
    try {
      in = IT::make_domain(IT::read_triangle_soup(file.string())).input;
    } catch (const std::exception&) {
      continue; // no surface
    }
    expect_metric(Triangulation(std::move(in)), 35);
    ++count;
  }
  EXPECT_GT(count, 50U);
}

} // namespace

#endif
