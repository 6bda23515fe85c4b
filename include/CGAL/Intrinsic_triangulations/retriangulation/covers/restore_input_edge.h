// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_COVERS_RESTORE_INPUT_EDGE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_COVERS_RESTORE_INPUT_EDGE_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Curve_strip.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Intrinsic_locator.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Move_status.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Which side of a curve the points of its strip are on: 1 right, 2 left, 0 for its ends.
inline std::vector<char> sides_of_curve(const Curve_strip& strip) {
  std::vector<char> side(strip.faces.size() + 2, 0);
  for (std::size_t n = 1; n < strip.faces.size(); ++n) {
    side[strip.faces[n].point[0]] = 1;
    side[strip.faces[n].point[1]] = 2;
  }
  return side;
}

// The point of triangle n - 1 of a strip that is not on the side to triangle n.
inline std::uint32_t point_before(const Curve_strip& strip, std::size_t n) {
  const auto &t = strip.faces[n - 1].point, &next = strip.faces[n].point;
  for (const std::uint32_t p : {t[0], t[1]})
    if (p != next[0] && p != next[1]) return p;
  return static_cast<std::uint32_t>(n + 1);
}

// Flips an edge across a curve, the first from a place in the strip on; whether there was one.
// \param may_cross whether the new edge may cross the curve, too: if not, fewer edges do
template <class Triangulation, class Session>
bool flip_off_curve(const Triangulation& t, Session& session, const Curve_strip& strip,
                    bool may_cross, std::size_t from) {
  const std::vector<char> side = sides_of_curve(strip);
  const std::size_t crossings = strip.faces.size() - 1;
  for (std::size_t i = 0; i < crossings; ++i) {
    const std::size_t n = 1 + (from + i) % crossings;
    const char before = side[point_before(strip, n)], after = side[n + 2];
    if (before != 0 && after != 0 && before != after && !may_cross) continue;
    const auto h = t.numbers().halfedge_at(strip.faces[n].halfedge);
    if (session.flip_edge(h) == Move_status::done) return true;
  }
  return false;
}

/*!
Flips edges until an input edge is an edge of the triangulation, or a chain of edges if vertices were inserted on it.
\param coordinates where the input edges are
\param x a halfedge of the input edge
\param flips is increased by the number of flips
\return whether it is one, which it may fail to become where it crosses a face more than once
\complexity quadratic in the number of edges that cross it
*/
template <class Triangulation, class Session, class Coordinates>
bool restore_input_edge(const Triangulation& t, Session& session, const Coordinates& coordinates,
                        std::uint32_t x, std::uint64_t& flips) {
  const Intrinsic_view<Triangulation> view(t);
  std::uint32_t vertex = coordinates.input().source(x);
  constexpr std::size_t unknown = std::numeric_limits<std::size_t>::max();
  std::size_t detours = 0, least = unknown; // triangles of the strip
  for (;;) {
    const std::optional<Curve_end> start = find_curve(view, coordinates, vertex, x);
    if (!start) return false;
    if (start->index < 0) { // a part of it, which is an edge
      vertex = view.target(start->halfedge);
      if (!coordinates.is_inserted(vertex)) return true;
      least = unknown;
      continue;
    }
    const Curve_strip strip(view, coordinates, *start);
    // Where no flip leaves fewer crossings, as in a zigzag, one that leaves as many makes way for that. Where the curve crosses a
    // face more than once, a flip that takes one crossing away may add others, and might be taken back for ever.
    const std::size_t size = strip.faces.size();
    if (size >= least && ++detours > 100 + 10 * least) return false;
    least = std::min(least, size);
    if (!flip_off_curve(t, session, strip, false, size > least ? detours : 0) &&
        !flip_off_curve(t, session, strip, true, detours))
      return false;
    ++flips;
  }
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_COVERS_RESTORE_INPUT_EDGE_H
