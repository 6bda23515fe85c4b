// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SUBDIVISIONS_H
#define SUBDIVISIONS_H

#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

// Common subdivisions with known results.
namespace subdivisions {

namespace IT = CGAL::Intrinsic_triangulations;
using Points = std::vector<std::array<double, 3>>;
using Side = IT::Common_subdivision::Side;

inline constexpr std::uint32_t none = IT::Common_subdivision::none;

inline void add_face(IT::Common_subdivision& s, const std::vector<std::uint32_t>& vertices,
                     const std::vector<Side>& sides, std::uint32_t input, std::uint32_t intrinsic) {
  s.corner.insert(s.corner.end(), vertices.begin(), vertices.end());
  s.side.insert(s.side.end(), sides.begin(), sides.end());
  s.face_begin.push_back(static_cast<std::uint32_t>(s.corner.size()));
  s.input_face.push_back(input);
  s.intrinsic_face.push_back(intrinsic);
}

inline void add_input_vertices(IT::Common_subdivision& s, std::uint32_t n) {
  s.number_of_input_vertices = s.number_of_intrinsic_vertices = n;
  for (std::uint32_t v = 0; v < n; ++v)
    s.vertices.push_back(
        {v, IT::Subdivision_vertex_kind::input, 0, {1, {v, none, none}, {1, 0, 0}}});
}

// The weights of a corner of a face in the intrinsic face of `base`: it is on the halfedge of it
// that the subdivision says.
template <class View>
std::array<double, 3> corner_in_face(const View& view, const IT::Common_subdivision& s,
                                     std::uint32_t base, std::size_t c) {
  const std::uint32_t h = s.intrinsic_halfedge[c];
  const bool is_crossing = s.kind(s.corner[c]) == IT::Subdivision_vertex_kind::crossing;
  const double x =
      is_crossing ? s.crossings[s.corner[c] - s.vertices.size()].on_intrinsic.parameter : 0;
  const double along = is_crossing && h % 2 != 0 ? 1 - x : x;
  if (h == base) return {1 - along, along, 0};
  if (h == view.next(base)) return {0, 1 - along, along};
  return {along, 0, 1 - along};
}

// The weights of a corner of a face in the input face of `base`: at a vertex, on the halfedge that
// the subdivision says, or from it, inside.
inline std::array<double, 3> corner_in_input_face(const IT::Input& input,
                                                  const IT::Common_subdivision& s,
                                                  std::uint32_t base, std::size_t c) {
  const std::uint32_t v = s.corner[c], h = s.input_halfedge[c];
  std::array<double, 3> w{1, 0, 0}; // from `h`
  if (s.kind(v) == IT::Subdivision_vertex_kind::crossing) {
    const double x = s.crossings[v - s.vertices.size()].on_input.parameter;
    w = h % 2 == 0 ? std::array{1 - x, x, 0.} : std::array{x, 1 - x, 0.};
  } else if (s.kind(v) == IT::Subdivision_vertex_kind::inserted) {
    w = s.vertices[v].on_input.weights;
    if (h != s.vertices[v].input_halfedge) std::swap(w[0], w[1]);
  }
  if (h == base) return w;
  if (h == input.next(base)) return {w[2], w[0], w[1]};
  return {w[1], w[2], w[0]};
}

// A grid of n x n squares; the input has one diagonal of each, the intrinsic triangulation the other.
// Square q has input faces and intrinsic faces 2q, 2q + 1, and diagonals of number 2n(n + 1) + q.
inline IT::Common_subdivision grid(std::uint32_t n) {
  IT::Common_subdivision s;
  add_input_vertices(s, (n + 1) * (n + 1));
  const auto horizontal = [&](std::uint32_t i, std::uint32_t j) { return i * n + j; };
  const auto vertical = [&](std::uint32_t i, std::uint32_t j) {
    return n * (n + 1) + i * (n + 1) + j;
  };
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t q = i * n + j, e = 2 * n * (n + 1) + q;
      const std::uint32_t a = i * (n + 1) + j, b = a + 1, c = b + n + 1, d = a + n + 1;
      const auto x = static_cast<std::uint32_t>(s.number_of_vertices());
      s.crossings.push_back({{e, {a, c}, 0.5}, {e, {d, b}, 0.5}});
      const Side outer{none, e}, inner{e, none};
      const std::uint32_t south = horizontal(i, j), north = horizontal(i + 1, j),
                          west = vertical(i, j), east = vertical(i, j + 1);
      add_face(s, {a, b, x}, {{south, south}, outer, inner}, 2 * q, 2 * q);
      add_face(s, {d, a, x}, {{west, west}, inner, outer}, 2 * q + 1, 2 * q);
      add_face(s, {b, c, x}, {{east, east}, inner, outer}, 2 * q, 2 * q + 1);
      add_face(s, {c, d, x}, {{north, north}, outer, inner}, 2 * q + 1, 2 * q + 1);
    }
  return s;
}

// The vertices of that grid on a hyperbolic paraboloid, in coordinates that have no short decimals.
inline Points grid_points(std::uint32_t n) {
  Points result;
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t j = 0; j <= n; ++j)
      result.push_back({j / 3., i / 7., double(i) * double(j) / 11.});
  return result;
}

// A tetrahedron without flips.
inline IT::Common_subdivision tetrahedron() {
  IT::Common_subdivision s;
  add_input_vertices(s, 4);
  const auto side = [](std::uint32_t e) { return Side{e, e}; };
  add_face(s, {0, 2, 1}, {side(1), side(3), side(0)}, 0, 0); // edges 01 02 03 12 13 23
  add_face(s, {0, 1, 3}, {side(0), side(4), side(2)}, 1, 1);
  add_face(s, {1, 2, 3}, {side(3), side(5), side(4)}, 2, 2);
  add_face(s, {2, 0, 3}, {side(1), side(2), side(5)}, 3, 3);
  return s;
}

// The flat torus of unit squares with one vertex: the input has edges (1, 0), (0, 1), (1, 1), numbers
// 0, 1, 2; the intrinsic triangulation has (1, 0), (k, 1), (k + 1, 1), numbers 0, 1, 2. All are loops.
class Torus {
  using Point = std::array<double, 2>;
  struct Cell {
    std::vector<Point> points;
    std::vector<Side> sides;
  };

public:
  explicit Torus(int k) : k_(k) {
    const double x = k;
    add_triangle({{{0, 0}, {x + 1, 1}, {x, 1}}, {{none, 2}, {none, 0}, {none, 1}}}, 0);
    add_triangle({{{0, 0}, {1, 0}, {x + 1, 1}}, {{none, 0}, {none, 1}, {none, 2}}}, 1);
    finish();
  }
  IT::Common_subdivision s;

private:
  void add_triangle(const Cell& triangle, std::uint32_t intrinsic_face) {
    std::vector<Cell> cells{triangle};
    for (int m = 0; m <= 1; ++m) cells = cut(cells, {0, 1}, m, 0);
    for (int m = 0; m <= k_ + 1; ++m) cells = cut(cells, {1, 0}, m, 1);
    for (int m = 0; m <= k_; ++m) cells = cut(cells, {1, -1}, m, 2);
    for (const Cell& cell : cells) {
      double x = 0, y = 0;
      for (const Point& p : cell.points) {
        x += p[0];
        y += p[1];
      }
      x = x / double(cell.points.size()) - std::floor(x / double(cell.points.size()));
      y /= double(cell.points.size());
      faces_.push_back({cell, x > y ? 0u : 1u, intrinsic_face});
    }
  }

  // cuts convex cells along the line <normal, p> = m on edge e of the input
  static std::vector<Cell> cut(const std::vector<Cell>& cells, Point normal, int m,
                               std::uint32_t e) {
    std::vector<Cell> result;
    for (const Cell& cell : cells)
      for (const double sign : {1., -1.}) {
        const auto height = [&](const Point& p) {
          const double h = sign * (normal[0] * p[0] + normal[1] * p[1] - m);
          return std::abs(h) < 1e-9 ? 0 : h;
        };
        Cell part;
        bool is_proper = false;
        for (std::size_t i = 0; i < cell.points.size(); ++i) {
          const Point p = cell.points[i], q = cell.points[(i + 1) % cell.points.size()];
          const double a = height(p), b = height(q);
          is_proper = is_proper || a > 0;
          const double t = a / (a - b);
          const Point x{p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])};
          if (a > 0 || (a == 0 && b > 0)) {
            part.points.push_back(p);
            part.sides.push_back(cell.sides[i]);
            if (b < 0) {
              part.points.push_back(x);
              part.sides.push_back({e, none});
            }
          } else if (a == 0) { // the part continues along the line
            part.points.push_back(p);
            part.sides.push_back({e, b == 0 ? cell.sides[i].intrinsic_edge : none});
          } else if (b > 0) {
            part.points.push_back(x);
            part.sides.push_back(cell.sides[i]);
          }
        }
        if (is_proper) result.push_back(part);
      }
    return result;
  }

  struct Face {
    Cell cell;
    std::uint32_t input_face, intrinsic_face;
  };
  struct Crossing {
    Point point;
    std::uint32_t input_edge = none, intrinsic_edge = none;
  };

  static double fraction(double x) {
    const double f = x - std::floor(x + 1e-9);
    return std::max(f, 0.);
  }
  static bool is_near(const Point& p, const Point& q) {
    return std::abs(p[0] - q[0]) + std::abs(p[1] - q[1]) < 1e-6;
  }

  Crossing& crossing(const Point& p) {
    const auto it = std::find_if(crossings_.begin(), crossings_.end(),
                                 [&](const Crossing& c) { return is_near(c.point, p); });
    return it == crossings_.end() ? crossings_.emplace_back(Crossing{p}) : *it;
  }

  // A point is identified by its coordinates modulo 1; the vertex is (0, 0).
  void finish() {
    for (const Face& f : faces_)
      for (std::size_t i = 0, n = f.cell.points.size(); i < n; ++i) {
        const Point p{fraction(f.cell.points[i][0]), fraction(f.cell.points[i][1])};
        if (is_near(p, {0, 0})) continue;
        Crossing& c = crossing(p);
        for (const Side& side : {f.cell.sides[i], f.cell.sides[(i + n - 1) % n]}) {
          if (side.input_edge != none) c.input_edge = side.input_edge;
          if (side.intrinsic_edge != none) c.intrinsic_edge = side.intrinsic_edge;
        }
      }
    // by edge, but from its end to its start
    std::sort(crossings_.begin(), crossings_.end(), [](const Crossing& a, const Crossing& b) {
      return std::make_pair(a.intrinsic_edge, -a.point[1]) <
             std::make_pair(b.intrinsic_edge, -b.point[1]);
    });
    add_input_vertices(s, 1);
    // all edges that cross have y = parameter, or x = parameter
    for (const Crossing& c : crossings_)
      s.crossings.push_back(
          {{c.input_edge, {0, 0}, c.point[1]}, {c.intrinsic_edge, {0, 0}, c.point[1]}});
    for (const Face& f : faces_) {
      std::vector<std::uint32_t> vertices;
      for (const Point& q : f.cell.points) {
        const Point p{fraction(q[0]), fraction(q[1])};
        const bool is_vertex = is_near(p, {0, 0});
        vertices.push_back(
            is_vertex ? 0u : 1u + static_cast<std::uint32_t>(&crossing(p) - crossings_.data()));
      }
      add_face(s, vertices, f.cell.sides, f.input_face, f.intrinsic_face);
    }
  }

  int k_;
  std::vector<Face> faces_;
  std::vector<Crossing> crossings_;
};

} // namespace subdivisions

#endif // SUBDIVISIONS_H
