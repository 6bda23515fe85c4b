// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_CUTS_FACE_PIECES_H
#define CGAL_INTRINSIC_GEODESICS_CUTS_FACE_PIECES_H

#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// A vertex of the pieces of a face of the input.
struct Piece_vertex {
  std::uint32_t vertex = 0;      // its number in the common subdivision
  unsigned sides = 0;            // a bit for each side of the face that it lies on
  bool is_needed = false;        // it stays
  std::array<double, 3> weights; // of the corners of the face
  Plane_vector<double> place;    // in the face
};

/*
Triangulates a face of the input with some points and segments in it: it begins with all pieces of
the common subdivision there, and removes the vertices that no segment needs, one after another. The
triangles around a removed vertex are replaced by others on the vertices around them. So the
connectivity stays that of a triangulated disk, however coordinates are rounded.
*/
class Face_pieces {
public:
  using Triangle = std::array<std::uint32_t, 3>;

  void clear() {
    vertices_.clear();
    triangles_.clear();
    at_.clear();
  }
  // returns the number of the vertex here
  std::uint32_t add_vertex(const Piece_vertex& v) {
    vertices_.push_back(v);
    at_.emplace_back();
    return static_cast<std::uint32_t>(vertices_.size() - 1);
  }
  Piece_vertex& vertex(std::uint32_t v) { return vertices_[v]; }

  // adds triangles on the vertices of a polygon, the best of all: as few without area as possible,
  // then the one of the worst shape as well shaped as possible. \complexity cubic
  void add_polygon(const std::vector<std::uint32_t>& polygon);

  void remove_unneeded_vertices() {
    for (std::uint32_t v = 0; v < vertices_.size(); ++v)
      if (!vertices_[v].is_needed) remove(v);
  }
  template <class Function>
  void for_each_triangle(const Function& f) const {
    for (const Triangle& t : triangles_)
      if (!is_removed(t)) f(t);
  }

private:
  // Of a triangulation of a part of a polygon.
  struct Choice {
    std::uint32_t faults = 0;
    double quality = std::numeric_limits<double>::infinity();
    std::size_t apex = 0;

    bool is_better_than(const Choice& c) const {
      return faults != c.faults ? faults < c.faults : quality > c.quality;
    }
  };

  static bool is_removed(const Triangle& t) { return t[0] == t[1]; }

  Choice triangle_choice(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
  bool is_edge(std::uint32_t a, std::uint32_t b) const;
  void add_triangle(const Triangle& t);
  void remove(std::uint32_t v);
  std::vector<std::uint32_t> take_polygon_around(std::uint32_t v);

  std::vector<Piece_vertex> vertices_;
  std::vector<Triangle> triangles_;
  std::vector<std::vector<std::uint32_t>> at_; // triangles of each vertex, also removed ones
};

// Twice the area of a triangle in barycentric coordinates, where the face has area 1/2: so the sign
// means the same in faces without area.
inline double barycentric_area(const Piece_vertex& a, const Piece_vertex& b,
                               const Piece_vertex& c) {
  const auto difference = [&](const Piece_vertex& p, std::size_t k) {
    return p.weights[k] - a.weights[k];
  };
  return difference(b, 1) * difference(c, 2) - difference(b, 2) * difference(c, 1);
}

inline Face_pieces::Choice Face_pieces::triangle_choice(std::uint32_t a, std::uint32_t b,
                                                        std::uint32_t c) const {
  const Piece_vertex &p = vertices_[a], &q = vertices_[b], &r = vertices_[c];
  const bool has_area = (p.sides & q.sides & r.sides) == 0 && barycentric_area(p, q, r) > 0;
  const Plane_vector<double> u = q.place - p.place, v = r.place - p.place, w = r.place - q.place;
  const double squares = dot(u, u) + dot(v, v) + dot(w, w);
  return {has_area ? 0U : 1U, squares > 0 ? cross(u, v) / squares : 0, 0};
}

inline bool Face_pieces::is_edge(std::uint32_t a, std::uint32_t b) const {
  const std::uint32_t fewer = at_[a].size() < at_[b].size() ? a : b, other = a + b - fewer;
  return std::ranges::any_of(at_[fewer], [&](std::uint32_t t) {
    return !is_removed(triangles_[t]) && std::ranges::count(triangles_[t], other) != 0;
  });
}

inline void Face_pieces::add_triangle(const Triangle& t) {
  for (const std::uint32_t v : t) at_[v].push_back(static_cast<std::uint32_t>(triangles_.size()));
  triangles_.push_back(t);
}

inline void Face_pieces::add_polygon(const std::vector<std::uint32_t>& polygon) {
  const std::size_t n = polygon.size();
  if (n < 3) return;
  constexpr std::uint32_t double_edge = 1U << 12; // worse than 4095 triangles without area
  std::vector<Choice> best(n * n);
  for (std::size_t length = 2; length < n; ++length)
    for (std::size_t i = 0; i + length < n; ++i) {
      const std::size_t j = i + length;
      Choice& c = best[i * n + j];
      c.faults = std::numeric_limits<std::uint32_t>::max();
      for (std::size_t k = i + 1; k < j; ++k) {
        Choice d = triangle_choice(polygon[i], polygon[k], polygon[j]);
        for (const Choice& part : {best[i * n + k], best[k * n + j]}) {
          d.faults += part.faults;
          d.quality = std::min(d.quality, part.quality);
        }
        d.apex = k;
        if (d.is_better_than(c)) c = d;
      }
      if (length + 1 < n && is_edge(polygon[i], polygon[j])) c.faults += double_edge;
    }
  std::vector<std::pair<std::size_t, std::size_t>> stack{{0, n - 1}};
  while (!stack.empty()) {
    const auto [i, j] = stack.back();
    stack.pop_back();
    if (j - i < 2) continue;
    const std::size_t k = best[i * n + j].apex;
    add_triangle({polygon[i], polygon[k], polygon[j]});
    stack.emplace_back(i, k);
    stack.emplace_back(k, j);
  }
}

// The vertices around a vertex, counterclockwise; on a side of the face from the one after it to
// the one before.
inline std::vector<std::uint32_t> Face_pieces::take_polygon_around(std::uint32_t v) {
  std::map<std::uint32_t, std::uint32_t> next;
  std::vector<std::uint32_t> targets;
  for (const std::uint32_t t : at_[v]) {
    Triangle& triangle = triangles_[t];
    if (is_removed(triangle)) continue;
    const auto k = static_cast<std::size_t>(std::ranges::find(triangle, v) - triangle.begin());
    next[triangle[(k + 1) % 3]] = triangle[(k + 2) % 3];
    targets.push_back(triangle[(k + 2) % 3]);
    triangle = {0, 0, 0};
  }
  std::vector<std::uint32_t> polygon;
  if (next.empty()) return polygon;
  std::ranges::sort(targets);
  polygon.push_back(next.begin()->first);
  for (const auto& [from, to] : next)
    if (!std::ranges::binary_search(targets, from)) polygon[0] = from;
  while (polygon.size() <= next.size()) {
    const auto found = next.find(polygon.back());
    if (found == next.end() || found->second == polygon.front()) break;
    polygon.push_back(found->second);
  }
  return polygon;
}

inline void Face_pieces::remove(std::uint32_t v) {
  const std::vector<std::uint32_t> polygon = take_polygon_around(v);
  at_[v].clear();
  add_polygon(polygon);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_CUTS_FACE_PIECES_H
