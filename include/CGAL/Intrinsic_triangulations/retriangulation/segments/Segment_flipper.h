// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_SEGMENTS_SEGMENT_FLIPPER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_SEGMENTS_SEGMENT_FLIPPER_H

#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Flip_log.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief reports what shortening curves did.
*/
struct Shortening_result {
  /// `done`: all curves are geodesic, or have contracted to a vertex; `stopped`, `cap` or
  /// `cancelled` before that.
  Status status = Status::done;
  /// Number of edges flipped.
  std::uint64_t flips = 0;
  /// Number of times that a piece of a curve was replaced by a shorter one.
  std::uint64_t shortenings = 0;
  /// Number of angles compared with pi.
  std::uint64_t wedge_checks = 0;
  /// Number of those that were exactly pi.
  std::uint64_t exact_ties = 0;
  /// Number of flips refused: a computed area was not positive, or an edge would cross too much of
  /// the input.
  std::uint64_t refused_flips = 0;

  /// adds counts; the status is the last one.
  Shortening_result& operator+=(const Shortening_result& r) {
    status = r.status;
    flips += r.flips;
    shortenings += r.shortenings;
    wedge_checks += r.wedge_checks;
    exact_ties += r.exact_ties;
    refused_flips += r.refused_flips;
    return *this;
  }
};

namespace internal {

// Flips edges out of a wedge (FlipOut, Algorithm 6 of the course).
template <class Triangulation>
class Wedge_flipper {
  using Halfedge = typename Triangulation::halfedge_descriptor;
  using Session = typename Triangulation::Session;

public:
  // without a log, flips cannot be taken back
  Wedge_flipper(const Triangulation& t, Session& session, Flip_log<Triangulation>* log)
      : t_(t), session_(session), log_(log) {}

  // Flips edges between two halfedges from the same vertex, the first one that can be flipped,
  // until none can; false if there would be more than `most` flips. `flipped(e)` is called after
  // each flip.
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

// Whether segments pass through no face twice; they can do so only where a triangulation winds
// around the surface. `crossed` projects a segment to the edges that it crosses, in order.
template <class Triangulation, class Segments, class Crossed = std::identity>
bool pass_faces_once(const Triangulation& t, const Segments& segments, Crossed crossed = {}) {
  const auto& mesh = t.mesh();
  std::vector<std::uint32_t> faces;
  for (const auto& segment : segments) {
    const auto& edges = std::invoke(crossed, segment);
    for (const auto h : edges) faces.push_back(t.index(face(h, mesh)));
    if (!edges.empty()) faces.push_back(t.index(face(opposite(edges.back(), mesh), mesh)));
  }
  std::sort(faces.begin(), faces.end());
  return std::adjacent_find(faces.begin(), faces.end()) == faces.end();
}

// Flips edges that a straight segment between two vertices crosses until the segment is an edge
// (§4.4 of the course).
//
// The faces that the segment passes through, laid out in the plane, are a strip. On the left of the
// segment, its border is a chain of edges. Where the angle of the chain at a vertex is below pi on
// the side of the strip, all edges of the strip from that vertex are flipped away, as in FlipOut:
// their far ends are on the right of the segment, so that they do not cross the segment, and the
// chain loses the vertex. The vertex that is farthest from the segment has such an angle: in the
// end none is left.
template <class Triangulation>
class Segment_flipper {
  using Halfedge = typename Triangulation::halfedge_descriptor;
  using Session = typename Triangulation::Session;

public:
  /// Edges that a segment crosses, in order: each from its right end to its left one.
  using Crossed = std::vector<Halfedge>;

  // without a log, flips cannot be taken back
  Segment_flipper(const Triangulation& t, Session& session, Flip_log<Triangulation>* log = nullptr)
      : t_(t), session_(session), flip_wedge_(t, session, log) {}

  /*!
  Flips edges.
  \param crossed at least one edge; the segment passes through no face twice
  \param most cap on the number of flips
  \param result counts them
  \param flipped called with an edge after its flip
  \return the segment, an edge; or, if rounding or the cap prevents that, the chain on its left
  */
  template <class Function>
  std::vector<Halfedge> operator()(Crossed crossed, std::uint64_t most, Shortening_result& result,
                                   const Function& flipped) {
    crossed_ = std::move(crossed);
    const std::uint64_t last = result.flips + most;
    Halfedge segment = crossed_.front();
    for (std::size_t i = 0; i < crossed_.size();) {
      const std::size_t end = end_of_fan(i);
      ++result.wedge_checks;
      if (compare_angle_to_pi(i, end) != SMALLER) {
        i = end;
        continue;
      }
      std::size_t left = end - i; // edges from the vertex
      const auto take_note = [&](Halfedge e) {
        flipped(e);
        segment = crossed_flipped(i, e);
        --left;
      };
      if (!flip_wedge_(next(crossed_[i], t_.mesh()), after(end - 1), false, last - result.flips,
                       result, take_note))
        break;
      i = left != 0 ? i + left : i == 0 ? 0 : start_of_fan(i - 1);
    }
    if (crossed_.empty()) return {segment};
    return chain();
  }

private:
  Halfedge previous(Halfedge h) const { return next(next(h, t_.mesh()), t_.mesh()); }

  // from the left end of a crossed edge to the next vertex of the chain, if the segment leaves the
  // face on the right
  Halfedge after(std::size_t i) const {
    return opposite(previous(opposite(crossed_[i], t_.mesh())), t_.mesh());
  }
  // whether an edge has the left end of the one before
  bool shares_left(std::size_t i) const {
    return previous(opposite(crossed_[i - 1], t_.mesh())) == crossed_[i];
  }
  std::size_t end_of_fan(std::size_t i) const {
    for (++i; i < crossed_.size() && shares_left(i);) ++i;
    return i;
  }
  std::size_t start_of_fan(std::size_t i) const {
    while (i > 0 && shares_left(i)) --i;
    return i;
  }

  Comparison_result compare_angle_to_pi(std::size_t begin, std::size_t end) const {
    return session_.compare_angle_to_pi(opposite(after(end - 1), t_.mesh()),
                                        next(crossed_[begin], t_.mesh()));
  }

  // Records the flip of an edge of the fan that begins at i. At an end of the fan, the segment
  // crosses it again unless that is the end of the segment, too. Returns its halfedge from the near
  // side, which turns into one that leads on along the segment.
  Halfedge crossed_flipped(std::size_t& i, Halfedge e) {
    std::size_t k = i;
    while (edge(crossed_[k], t_.mesh()) != edge(e, t_.mesh())) ++k;
    const Halfedge c = crossed_[k];
    const auto& mesh = t_.mesh();
    const bool is_inside = k > 0 && k + 1 < crossed_.size();
    // the face that the segment enters through the edge before, and leaves through the edge after
    // it if these have one
    const auto near = face(is_inside ? opposite(crossed_[k - 1], mesh) : c, mesh);
    if (is_inside && near != face(crossed_[k + 1], mesh)) {
      crossed_[k] = face(c, mesh) == near ? c : opposite(c, mesh);
      if (k == i) ++i; // it is the last one of the fan before
    } else {
      crossed_.erase(crossed_.begin() + static_cast<std::ptrdiff_t>(k));
    }
    return c;
  }

  // the chain on the left of the segment
  std::vector<Halfedge> chain() const {
    std::vector<Halfedge> result{opposite(next(crossed_.front(), t_.mesh()), t_.mesh())};
    for (std::size_t i = 0; i < crossed_.size(); ++i)
      if (i + 1 == crossed_.size() || !shares_left(i + 1)) result.push_back(after(i));
    return result;
  }

  const Triangulation& t_;
  Session& session_;
  Wedge_flipper<Triangulation> flip_wedge_;
  Crossed crossed_;
};

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_SEGMENTS_SEGMENT_FLIPPER_H
