// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_CONVEX_POLYHEDRA_H
#define TEST_CONVEX_POLYHEDRA_H

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_conformal/angles/ideal_start.h>
#include <CGAL/Intrinsic_simplification/embedding/embed_convex.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include "hull_mesh.h"
#include "polyhedra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <utility>
#include <vector>

// Convex polyhedra that are known, and their lengths alone.
namespace convex_polyhedra {

namespace IT = CGAL::Intrinsic_triangulations;
using hull_mesh::Kernel;
using hull_mesh::Mesh;
using polyhedra::distance;
using polyhedra::Point;

inline Mesh hull_of(const std::vector<Point>& points) {
  std::vector<Kernel::Point_3> all;
  for (const Point& p : points) all.emplace_back(p[0], p[1], p[2]);
  return hull_mesh::hull_of(all);
}

// Whether the lengths of a face, rounded to doubles, may violate the triangle inequality.
inline bool is_thin(const IT::Corresponding_triangulation& t, IT::Gluing_map::Halfedge h) {
  const auto n = next(h, t.mesh());
  const double a = t.squared_length(edge(h, t.mesh())), b = t.squared_length(edge(n, t.mesh())),
               c = t.squared_length(edge(next(n, t.mesh()), t.mesh()));
  return 4 * a * b - (a + b - c) * (a + b - c) < 1e-8 * std::max({a, b, c}) * std::max({a, b, c});
}

// A surface that has the lengths of a mesh, but other triangles and no points.
inline IT::Corresponding_triangulation lengths_only(const Mesh& mesh, unsigned seed) {
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
inline double error_of_distances(const std::vector<Point>& found, const Mesh& mesh) {
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
inline double greatest_height(const IT::Convex_polyhedron& p) {
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

inline std::vector<Point> random_points(std::size_t n, const Point& axes, unsigned seed) {
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
inline Mesh box(const Point& sides, int n) {
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

} // namespace convex_polyhedra

#endif // TEST_CONVEX_POLYHEDRA_H
