// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_SEGMENTS_FLIP_LOG_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_SEGMENTS_FLIP_LOG_H

#include <CGAL/Intrinsic_triangulations/triangulation/Move_status.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief flips edges and remembers how to take the flips back, at the cost of what they have touched.
\tparam Triangulation an instance of `Intrinsic_triangulation`
*/
template <class Triangulation>
class Flip_log {
public:
  /// Halfedge of the mesh.
  using halfedge_descriptor = typename Triangulation::halfedge_descriptor;
  /// Makes the moves.
  using Session = typename Triangulation::Session;

  /// flips an edge, see `Intrinsic_triangulation::flip_edge()`.
  Move_status flip_edge(Session& session, halfedge_descriptor h) {
    const Move_status possible = session.flip_status(h);
    if (possible != Move_status::done) return possible;
    typename Session::Before_flip before = session.before_flip(h);
    const Move_status s = session.flip_convex_edge(h);
    if (s == Move_status::done) flips_.emplace_back(h, std::move(before));
    return s;
  }
  /// returns the number of flips.
  std::size_t size() const { return flips_.size(); }
  /// keeps the flips: they can no longer be taken back.
  void clear() { flips_.clear(); }
  /// takes all flips back, the last one first. \pre nothing else has moved since the first one
  void undo(Session& session) {
    for (; !flips_.empty(); flips_.pop_back())
      session.undo_flip(flips_.back().first, flips_.back().second);
  }

private:
  std::vector<std::pair<halfedge_descriptor, typename Session::Before_flip>> flips_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_SEGMENTS_FLIP_LOG_H
