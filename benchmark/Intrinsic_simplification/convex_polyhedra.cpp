// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How often, how precisely and how fast does embed_convex() find the polyhedron of a metric? Hulls
// of random points and boxes with flat vertices, lengths only, after random flips.
// Usage: convex_polyhedra [METRICS_PER_FAMILY]

#include <CGAL/Intrinsic_simplification.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <iostream>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

struct Family {
  std::string name;
  std::array<double, 3> axes;
  std::size_t least, most; // points
  bool is_box = false;     // with a grid of flat vertices
};

const std::vector<Family> families{
    {"sphere", {1, 1, 1}, 20, 2000},
    {"ellipsoid 1 : 0.6 : 0.4", {1, .6, .4}, 20, 2000},
    {"ellipsoid 1 : 0.3 : 0.05", {1, .3, .05}, 20, 1000},
    {"needle 100 : 1 : 1", {100, 1, 1}, 8, 300},
    {"pancake 1 : 1 : 0.02", {1, 1, .02}, 20, 1000},
    {"box with flat vertices, random sides", {0, 0, 0}, 20, 2000, true},
    {"box with flat vertices, 1 : 1 : 0.02", {1, 1, .02}, 20, 2000, true}};

Mesh hull(const Family& f, std::size_t n, std::mt19937& random) {
  std::normal_distribution<double> normal;
  std::vector<Kernel::Point_3> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = normal(random), y = normal(random), z = normal(random),
                 r = std::hypot(x, y, z);
    points.emplace_back(f.axes[0] * x / r, f.axes[1] * y / r, f.axes[2] * z / r);
  }
  Mesh mesh;
  CGAL::convex_hull_3(points.begin(), points.end(), mesh);
  return mesh;
}

// each side is a grid of k by k squares, 6 k^2 + 2 vertices in all
Mesh box(const Family& f, std::size_t n, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(.1, 1);
  std::array<double, 3> sides = f.axes;
  if (sides[0] == 0) sides = {uniform(random), uniform(random), uniform(random)};
  const int k = std::max(2, static_cast<int>(std::sqrt(static_cast<double>(n) / 6)));
  std::map<std::array<int, 3>, Mesh::Vertex_index> place;
  Mesh mesh;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [i, is_new] = place.insert({at, {}});
    if (is_new)
      i->second =
          mesh.add_vertex({sides[0] * at[0] / k, sides[1] * at[1] / k, sides[2] * at[2] / k});
    return i->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const int end : {0, k})
      for (int i = 0; i < k * k; ++i) {
        std::array<Mesh::Vertex_index, 4> q;
        for (int c = 0; c < 4; ++c) {
          std::array<int, 3> at{};
          at[axis] = end;
          at[(axis + 1) % 3] = i / k + (c == 1 || c == 2 ? 1 : 0);
          at[(axis + 2) % 3] = i % k + (c >= 2 ? 1 : 0);
          q[static_cast<std::size_t>(c)] = vertex(at);
        }
        if (end == 0) std::swap(q[1], q[3]);
        mesh.add_face(q[0], q[1], q[2]);
        mesh.add_face(q[0], q[2], q[3]);
      }
  return mesh;
}

struct Result {
  std::size_t found = 0, proven = 0, steps = 0;
  double error = 0, seconds = 0, slowest = 0;
};

double error_of_distances(const Mesh& mesh, const std::vector<std::array<double, 3>>& points) {
  double error = 0, diameter = 0;
  for (const Mesh::Vertex_index v : mesh.vertices())
    for (Mesh::Vertex_index w(0); w < v; ++w) {
      const auto &p = points[v], &q = points[w];
      const double d = std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(w)));
      diameter = std::max(diameter, d);
      error = std::max(error, std::abs(d - std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2])));
    }
  return error / diameter;
}

// Whether the lengths of a face, rounded to doubles, may violate the triangle inequality.
bool is_thin(const IT::Corresponding_triangulation& t, IT::Gluing_map::Halfedge h) {
  const auto n = next(h, t.mesh());
  const double a = t.squared_length(edge(h, t.mesh())), b = t.squared_length(edge(n, t.mesh())),
               c = t.squared_length(edge(next(n, t.mesh()), t.mesh()));
  return 4 * a * b - (a + b - c) * (a + b - c) < 1e-8 * std::max({a, b, c}) * std::max({a, b, c});
}

void run(const Mesh& mesh, std::mt19937& random, Result& result) {
  IT::Corresponding_triangulation t(mesh);
  std::vector<IT::Gluing_map::Edge> all(edges(t.mesh()).begin(), edges(t.mesh()).end());
  for (std::size_t n = 0; n < all.size(); ++n) {
    const auto h = halfedge(all[random() % all.size()], t.mesh());
    if (t.flip_edge(h) != IT::Move_status::done) continue;
    if (is_thin(t, h) || is_thin(t, opposite(h, t.mesh()))) t.flip_edge(h); // back
  }
  const IT::Corresponding_triangulation lengths_only(IT::ideal_start(t));
  const auto start = std::chrono::steady_clock::now();
  const IT::Convex_polyhedron p = IT::embed_convex(lengths_only);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  result.seconds += seconds;
  result.slowest = std::max(result.slowest, seconds);
  result.steps += p.steps;
  if (p.status != IT::Status::done) return;
  ++result.found;
  result.proven += p.certificate.is_proven ? 1 : 0;
  result.error = std::max(result.error, error_of_distances(mesh, p.points));
}

} // namespace

int main(int argc, char* argv[]) {
  const std::size_t asked = argc > 1 ? std::stoul(argv[1]) : 143;
  std::cout << "| metrics | vertices | found | proven | greatest error of distances | mean steps | "
               "mean seconds | slowest |\n|---|---|---|---|---|---|---|---|\n";
  for (const Family& f : families) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> logarithm(std::log(f.least), std::log(f.most));
    Result r;
    for (std::size_t i = 0; i < asked; ++i) {
      const auto n = static_cast<std::size_t>(std::exp(logarithm(random)));
      run(f.is_box ? box(f, n, random) : hull(f, n, random), random, r);
    }
    const auto mean = [&](double sum) { return sum / static_cast<double>(asked); };
    std::cout << std::setprecision(2) << "| " << f.name << " | " << f.least << " to " << f.most
              << " | " << r.found << " of " << asked << " | " << r.proven << " | " << r.error
              << " | " << std::lround(mean(static_cast<double>(r.steps))) << " | "
              << mean(r.seconds) << " | " << r.slowest << " |\n"
              << std::flush;
  }
}
