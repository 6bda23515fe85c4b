// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_SEGMENTS_WEDGE_FLIPPER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_SEGMENTS_WEDGE_FLIPPER_H

#include <CGAL/Intrinsic_triangulations/connectivity/Status.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/segments/Flip_log.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/segments/Shortening_result.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Move_status.h>

#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Flips edges out of a wedge (FlipOut, Algorithm 6 of the course).
template <class Triangulation>
class Wedge_flipper {
  using Halfedge = typename Triangulation::halfedge_descriptor;
  using Session = typename Triangulation::Session;

public:
  // without a log, flips cannot be taken back
  Wedge_flipper(const Triangulation& t, Session& session, Flip_log<Triangulation>* log)
      : t_(t), session_(session), log_(log) {}

  // Flips edges between two halfedges from the same vertex, the first one that can be flipped, until none can; false if
  // there would be more than `most` flips. `flipped(e)` is called after each flip.
  template <class Function>
  bool operator()(Halfedge from, Halfedge to, bool is_clockwise, std::uint64_t most,
                  Shortening_result& result, const Function& flipped) {
    const auto turned = [&](Halfedge e) {
      const auto& mesh = t_.mesh();
      return is_clockwise ? next(opposite(e, mesh), mesh)
                          : opposite(next(next(e, mesh), mesh), mesh);
    };
    std::vector<Halfedge>& before = inner_; // edges that cannot be flipped, in order
    before.clear();
    Halfedge e = turned(from);
    while (e != to) {
      if (most == 0) return false;
      const Halfedge after = turned(e);
      const Move_status s = flip(e);
      if (s == Move_status::done) {
        ++result.flips;
        --most;
        flipped(e);
        e = before.empty() ? after : before.back();
        if (!before.empty()) before.pop_back();
        continue;
      }
      if (s != Move_status::not_convex && s != Move_status::same_face) ++result.refused_flips;
      before.push_back(e);
      e = after;
    }
    return true;
  }

  Move_status flip(Halfedge e) {
    if (log_ != nullptr) return log_->flip_edge(session_, e);
    const Move_status s = session_.flip_status(e);
    return s == Move_status::done ? session_.flip_convex_edge(e) : s;
  }

private:
  const Triangulation& t_;
  Session& session_;
  Flip_log<Triangulation>* log_;
  std::vector<Halfedge> inner_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_SEGMENTS_WEDGE_FLIPPER_H
