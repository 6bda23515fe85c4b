// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_FLIP_LOG_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_FLIP_LOG_H

#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/reserve_at_least.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief flips edges and can take the flips back, at a cost linear in the flips.
\tparam Triangulation a model of `IntrinsicTriangulation` whose sessions take flips back
*/
template <IntrinsicTriangulation Triangulation>
  requires requires { typename Triangulation::Session::Before_flip; }
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
    return flip_by(session, h, [&] { return session.flip_convex_edge(h); });
  }
  /// flips an edge by a function.
  /// \param session, h the session and the edge
  /// \param flip flips it in that session, and returns a `Move_status`
  template <class Function>
  Move_status flip_by(Session& session, halfedge_descriptor h, const Function& flip) {
    reserve_at_least(flips_, flips_.size() + 1); // a flip that is made must be in the log
    typename Session::Before_flip before = session.before_flip(h);
    const Move_status s = flip();
    if (s == Move_status::done) flips_.emplace_back(h, std::move(before));
    return s;
  }
  /// returns the number of flips.
  std::size_t size() const { return flips_.size(); }
  /// keeps the flips: they can no longer be taken back.
  void clear() { flips_.clear(); }
  /// takes all flips back, the last one first, which cannot fail. \pre nothing else has moved since
  /// the first one
  void undo(Session& session) noexcept {
    for (; !flips_.empty(); flips_.pop_back())
      session.undo_flip(flips_.back().first, std::move(flips_.back().second));
  }

private:
  std::vector<std::pair<halfedge_descriptor, typename Session::Before_flip>> flips_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_FLIP_LOG_H
