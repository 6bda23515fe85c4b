// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How often, how precisely and how fast does embed_convex() find the polyhedron of a metric? Hulls
// of random points, boxes with flat vertices and with low bumps, lengths only, after random flips;
// and polygons whose border is glued to itself.
// Usage: convex_polyhedra [METRICS_PER_FAMILY [FAMILY]]

#include "hull_mesh.h"

#include <CGAL/Intrinsic_simplification.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <iomanip>
#include <iostream>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using hull_mesh::hull_of;
using hull_mesh::Kernel;
using hull_mesh::Mesh;

enum class Kind { hull, box, bumps, polygon };

struct Family {
  std::string name;
  std::array<double, 3> axes; // of a box or bumps, sides, zeros: at random
  std::size_t least, most;    // points
  Kind kind = Kind::hull;
  double height = 0; // of bumps
};

const std::vector<Family> families{
    {"sphere", {1, 1, 1}, 20, 2000},
    {"ellipsoid 1 : 0.6 : 0.4", {1, .6, .4}, 20, 2000},
    {"ellipsoid 1 : 0.3 : 0.05", {1, .3, .05}, 20, 1000},
    {"needle 100 : 1 : 1", {100, 1, 1}, 8, 300},
    {"pancake 1 : 1 : 0.02", {1, 1, .02}, 20, 1000},
    {"box with flat vertices, random sides", {0, 0, 0}, 20, 2000, Kind::box},
    {"box with flat vertices, 1 : 1 : 0.02", {1, 1, .02}, 20, 2000, Kind::box},
    {"box with faces bent by 1e-3", {0, 0, 0}, 20, 2000, Kind::bumps, 1e-3},
    {"box with faces bent by 1e-5", {0, 0, 0}, 20, 2000, Kind::bumps, 1e-5},
    {"convex polygon, its border zipped", {1, .6, 0}, 20, 2000, Kind::polygon}};

Mesh hull(const Family& f, std::size_t n, std::mt19937& random) {
  std::normal_distribution<double> normal;
  std::vector<Kernel::Point_3> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = normal(random), y = normal(random), z = normal(random),
                 r = std::hypot(x, y, z);
    points.emplace_back(f.axes[0] * x / r, f.axes[1] * y / r, f.axes[2] * z / r);
  }
  return hull_of(points);
}

std::array<double, 3> sides_of(const Family& f, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(.1, 1);
  if (f.axes[0] != 0) return f.axes;
  return {uniform(random), uniform(random), uniform(random)};
}

// points of a box whose faces are bent to paraboloids
Mesh bumps(const Family& f, std::size_t n, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const std::array<double, 3> sides = sides_of(f, random);
  std::vector<Kernel::Point_3> points;
  for (int c = 0; c < 8; ++c)
    points.emplace_back(sides[0] * (c % 2 * 2 - 1), sides[1] * (c / 2 % 2 * 2 - 1),
                        sides[2] * (c / 4 * 2 - 1));
  while (points.size() < n) {
    std::array<double, 3> p{uniform(random), uniform(random), uniform(random)};
    const std::size_t axis = random() % 3, a = (axis + 1) % 3, b = (axis + 2) % 3;
    p[axis] = (random() % 2 == 0 ? -1 : 1) * (1 + f.height * (2 - p[a] * p[a] - p[b] * p[b]));
    points.emplace_back(sides[0] * p[0], sides[1] * p[1], sides[2] * p[2]);
  }
  return hull_of(points);
}

// each side is a grid of k by k squares, 6 k^2 + 2 vertices in all
Mesh box(const Family& f, std::size_t n, std::mt19937& random) {
  const std::array<double, 3> sides = sides_of(f, random);
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

/*
A convex polygon, whose border is zipped from a random place of it: points at equal distances from
there, along the border, are glued. At each vertex of the polygon is less than a full turn, so that
this is the metric of a polyhedron. The triangles meet in a flat vertex inside.
*/
IT::Intrinsic_input zipped_polygon(const Family& f, std::size_t n, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0, 2 * std::numbers::pi);
  std::vector<double> angles(n), at{0};
  for (double& a : angles) a = uniform(random);
  std::sort(angles.begin(), angles.end());
  const auto corner = [&](std::size_t k) {
    const double a = angles[k % n];
    return std::complex<double>(f.axes[0] * std::cos(a), f.axes[1] * std::sin(a));
  };
  for (std::size_t k = 0; k < n; ++k) at.push_back(at.back() + std::abs(corner(k + 1) - corner(k)));
  const double all = at.back(), start = uniform(random) / (2 * std::numbers::pi) * all;
  // places by their distance from the start, of one half
  std::vector<double> half{0, all / 2};
  for (std::size_t k = 0; k < n; ++k) {
    const double s = std::fmod(at[k] - start + all, all);
    half.push_back(std::min(s, all - s));
  }
  std::sort(half.begin(), half.end());
  const auto m = static_cast<std::uint32_t>(half.size() - 1); // sides of each half
  const auto place = [&](double s) {
    s = std::fmod(s + 2 * all, all);
    const auto k =
        static_cast<std::size_t>(std::upper_bound(at.begin(), at.end() - 1, s) - at.begin() - 1);
    return corner(k) + (corner(k + 1) - corner(k)) * ((s - at[k]) / (at[k + 1] - at[k]));
  };
  const auto point = [&](std::uint32_t k) { // of 2 m on the border
    return place(k <= m ? start + half[k] : start - half[2 * m - k]);
  };
  IT::Gluing g;
  g.number_of_vertices = m + 2;
  std::vector<double> squared;
  for (std::uint32_t k = 0; k < 2 * m; ++k) { // faces: centre, k, k + 1
    const auto name = [&](std::uint32_t i) { return i <= m ? i : 2 * m - i; };
    const std::uint32_t before = (k + 2 * m - 1) % (2 * m), after = (k + 1) % (2 * m);
    for (const std::uint32_t v : {m + 1, name(k), name(after)}) g.origin.push_back(v);
    for (const std::uint32_t h : {3 * before + 2, 3 * (2 * m - 1 - k) + 1, 3 * after})
      g.glue.push_back(h);
  }
  for (std::uint32_t h = 0; h < g.glue.size(); ++h) { // edges are numbered as faces meet them
    if (g.glue[h] < h) continue;
    const std::uint32_t k = h / 3, from = std::min(k, 2 * m - 1 - k), j = h % 3 == 0 ? k : k + 1;
    squared.push_back(h % 3 == 1 ? std::pow(half[from + 1] - half[from], 2)
                                 : std::norm(point(j % (2 * m))));
  }
  IT::Gluing_map map(g);
  return {std::move(map), std::move(squared), IT::Mollification::none};
}

struct Result {
  std::size_t found = 0, proven = 0, steps = 0;
  double error = 0, stretch = 0, within = 0, seconds = 0, slowest = 0;
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

// \param mesh if it is known
void run(IT::Corresponding_triangulation t, const Mesh* mesh, double flat_within,
         std::mt19937& random, Result& result) {
  std::vector<IT::Gluing_map::Edge> all(edges(t.mesh()).begin(), edges(t.mesh()).end());
  for (std::size_t n = 0; n < all.size(); ++n) {
    const auto h = halfedge(all[random() % all.size()], t.mesh());
    if (t.flip_edge(h) != IT::Move_status::done) continue;
    if (is_thin(t, h) || is_thin(t, opposite(h, t.mesh()))) t.flip_edge(h); // back
  }
  const IT::Corresponding_triangulation lengths_only(IT::ideal_start(t));
  const auto start = std::chrono::steady_clock::now();
  IT::Embed_options options;
  options.flat_within = flat_within;
  const IT::Convex_polyhedron p = IT::embed_convex(lengths_only, options);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  result.seconds += seconds;
  result.slowest = std::max(result.slowest, seconds);
  result.steps += p.steps;
  if (p.status != IT::Status::done) {
    std::cerr << t.mesh().number_of_vertices() << " vertices: " << IT::name_of(p.status)
              << " while " << IT::name_of(p.stage) << " after " << p.steps << " steps\n";
    return;
  }
  ++result.found;
  const IT::Convexity_certificate& c = p.certificate;
  if (c.is_proven) {
    ++result.proven;
    result.stretch = std::max(result.stretch, c.stretch);
    result.within = std::max(result.within, c.within);
  } else {
    std::cerr << t.mesh().number_of_vertices() << " vertices: not proven, stretch " << c.stretch
              << ", within " << c.within << ", " << c.convex_edges << " convex edges, "
              << c.flat_edges << " flat ones\n";
  }
  result.error = std::max(result.error,
                          mesh != nullptr ? error_of_distances(*mesh, p.points) : p.largest_error);
}

} // namespace

int main(int argc, char* argv[]) {
  const std::size_t asked = argc > 1 ? std::stoul(argv[1]) : 100;
  std::cout
      << "| metrics | vertices | found | proven | greatest proven distance | greatest stretch | "
         "greatest error of distances | mean steps | mean seconds | slowest |\n"
         "|---|---|---|---|---|---|---|---|---|---|\n";
  for (const Family& f : families) {
    if (argc > 2 && f.name != argv[2]) continue;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> logarithm(std::log(f.least), std::log(f.most));
    Result r;
    // vertices of bent faces have curvatures far below 1e-10
    const double flat_within = f.kind == Kind::bumps ? 1e-12 : IT::Embed_options().flat_within;
    for (std::size_t i = 0; i < asked; ++i) {
      const auto n = static_cast<std::size_t>(std::exp(logarithm(random)));
      if (f.kind == Kind::polygon) {
        run(IT::Corresponding_triangulation(zipped_polygon(f, n, random)), nullptr, flat_within,
            random, r);
        continue;
      }
      const Mesh mesh = f.kind == Kind::box     ? box(f, n, random)
                        : f.kind == Kind::bumps ? bumps(f, n, random)
                                                : hull(f, n, random);
      run(IT::Corresponding_triangulation(mesh), &mesh, flat_within, random, r);
    }
    const auto mean = [&](double sum) { return sum / static_cast<double>(asked); };
    std::cout << std::setprecision(2) << "| " << f.name << " | " << f.least << " to " << f.most
              << " | " << r.found << " of " << asked << " | " << r.proven << " | " << r.within
              << " | " << r.stretch << " | " << r.error << " | "
              << std::lround(mean(static_cast<double>(r.steps))) << " | " << mean(r.seconds)
              << " | " << r.slowest << " |\n"
              << std::flush;
  }
}
