// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_INTRINSIC_EDGE_POLYLINES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_INTRINSIC_EDGE_POLYLINES_H

#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief holds for each intrinsic edge the vertices of a common subdivision along it, one after another.
*/
struct Intrinsic_edge_polylines {
  /// For each number of an edge the index of its first vertex, and one entry more.
  std::vector<std::size_t> begin{0};
  /// The vertices; none for a number that no edge has.
  std::vector<std::uint32_t> vertices;

  /// returns the bound of the numbers of edges.
  std::size_t size() const { return begin.size() - 1; }
  /// returns the vertices along edge `e`; empty if there is no edge of this number.
  std::span<const std::uint32_t> operator[](std::size_t e) const {
    return {vertices.data() + begin[e], begin[e + 1] - begin[e]};
  }
};

namespace internal {

// Bound of the numbers of intrinsic edges that have sides.
inline std::size_t intrinsic_edge_bound(const Common_subdivision& s) {
  std::size_t bound = 0;
  for (const Common_subdivision::Side& side : s.side)
    if (side.intrinsic_edge != Common_subdivision::none)
      bound = std::max(bound, std::size_t{side.intrinsic_edge} + 1);
  return bound;
}

// Chains the sides on each intrinsic edge. The interior vertices of such a path are crossings, and a
// crossing lies on one intrinsic edge: two sides on that edge leave it, to its two neighbours.
class Intrinsic_edge_chainer {
  static constexpr std::uint32_t none = Common_subdivision::none;

public:
  explicit Intrinsic_edge_chainer(const Common_subdivision& s) : s_(s) {}

  Intrinsic_edge_polylines run() {
    count();
    neighbours_.assign(s_.crossings.size(), {none, none});
    for (std::size_t f = 0; f < s_.number_of_faces(); ++f) {
      const std::span<const std::uint32_t> face = s_.face(f);
      const std::span<const Common_subdivision::Side> sides = s_.sides(f);
      for (std::size_t k = 0; k < face.size(); ++k)
        if (sides[k].intrinsic_edge != none)
          add(face[k], face[k + 1 == face.size() ? 0 : k + 1], sides[k].intrinsic_edge);
    }
    for (std::size_t e = 0; e < result_.size(); ++e) walk(result_.begin[e], result_.begin[e + 1]);
    return std::move(result_);
  }

private:
  bool is_crossing(std::uint32_t v) const { return v >= s_.vertices.size(); }
  const Common_subdivision::Edge_point& on_intrinsic(std::uint32_t v) const {
    return s_.crossings[v - s_.vertices.size()].on_intrinsic;
  }

  void count() {
    std::vector<std::size_t>& begin = result_.begin;
    begin.assign(intrinsic_edge_bound(s_) + 1, 0);
    for (const Common_subdivision::Side& side : s_.side)
      if (side.intrinsic_edge != none) begin[side.intrinsic_edge + 1] = 2;
    for (const Common_subdivision::Crossing& c : s_.crossings) ++begin[c.on_intrinsic.edge + 1];
    for (std::size_t e = 1; e < begin.size(); ++e) begin[e] += begin[e - 1];
    result_.vertices.assign(begin.back(), none);
  }

  void add(std::uint32_t source, std::uint32_t target, std::uint32_t e) {
    std::uint32_t* const path = result_.vertices.data() + result_.begin[e];
    if (is_crossing(source)) {
      std::array<std::uint32_t, 2>& n = neighbours_[source - s_.vertices.size()];
      n[n[0] == none ? 0 : 1] = target;
    } else if (!is_crossing(target)) {
      path[0] = std::min(source, target);
      path[1] = std::max(source, target);
    } else if (path[0] == none || is_first(source, target, path[1])) {
      path[0] = source;
      path[1] = target;
    }
  }

  // Whether the edge starts with `source, target`, where `other` may follow its other end.
  bool is_first(std::uint32_t source, std::uint32_t target, std::uint32_t other) const {
    const Common_subdivision::Edge_point& p = on_intrinsic(target);
    if (p.vertices[0] != p.vertices[1]) return s_.vertices[source].intrinsic == p.vertices[0];
    return p.parameter < on_intrinsic(other).parameter; // a loop
  }

  void walk(std::size_t begin, std::size_t end) {
    std::vector<std::uint32_t>& v = result_.vertices;
    for (std::size_t i = begin + 2; i < end; ++i) {
      const std::array<std::uint32_t, 2>& n = neighbours_[v[i - 1] - s_.vertices.size()];
      v[i] = n[n[0] == v[i - 2] ? 1 : 0];
    }
  }

  const Common_subdivision& s_;
  Intrinsic_edge_polylines result_;
  std::vector<std::array<std::uint32_t, 2>> neighbours_;
};

} // namespace internal

/*!
\brief chains the vertices of a common subdivision along each intrinsic edge (§3.6 of the course).

An edge with crossings runs as their locations on it say, from `vertices[0]` to `vertices[1]`; one
without runs from its smaller vertex to the greater one.
\param s the subdivision
\pre `s` is the common subdivision of two triangulations
\return the polylines; polylines of interior edges, and those of the border
\complexity linear
*/
inline Intrinsic_edge_polylines intrinsic_edge_polylines(const Common_subdivision& s) {
  return internal::Intrinsic_edge_chainer(s).run();
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_INTRINSIC_EDGE_POLYLINES_H
