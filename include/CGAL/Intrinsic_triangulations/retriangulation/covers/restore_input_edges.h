// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_COVERS_RESTORE_INPUT_EDGES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_COVERS_RESTORE_INPUT_EDGES_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Intrinsic_locator.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/segments/Segment_flipper.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief reports what `restore_input_edges()` did.
*/
struct Restored_edges {
  std::uint64_t flips = 0; ///< Edges flipped.
  /// Number in `t.input()` of the first edge that was not restored; `Gluing::none` if all were.
  std::uint32_t missing = Gluing::none;
};

namespace internal {

// Flips edges until edges of the input are edges of the triangulation.
template <class Triangulation, class Session, class Coordinates>
class Input_edge_restorer {
  using Crossed = std::vector<typename Triangulation::halfedge_descriptor>;

public:
  // never flips edges that are to be kept: nonzero by their numbers, empty if none is
  Input_edge_restorer(const Triangulation& t, Session& session, const Coordinates& coordinates,
                      const std::vector<char>& is_kept = {})
      : t_(t), session_(session), coordinates_(coordinates), is_kept_(is_kept),
        flip_to_segment_(t, session) {}

  std::uint64_t flips() const { return result_.flips; }

  // Restores an input edge, given by a halfedge, or all of its parts if vertices were inserted on
  // it. Returns whether this succeeded.
  bool operator()(std::uint32_t x) {
    const Intrinsic_view<Triangulation> view(t_);
    std::uint32_t vertex = coordinates_.input().source(x);
    for (;;) {
      const std::optional<Curve_end> start = find_curve(view, coordinates_, vertex, x);
      if (!start) return false;
      const Crossed crossed = crossed_edges(view, *start);
      if (crossed.empty()) {
        vertex = view.target(start->halfedge);
        if (!coordinates_.is_inserted(vertex)) return true;
      } else if (cross_kept(crossed)) {
        return false;
      } else if (!pass_faces_once(t_, std::array{crossed})) {
        if (!flip_off(view, vertex, x, crossed)) return false;
      } else if (flip_to_segment_(crossed, std::numeric_limits<std::uint64_t>::max(), result_,
                                  [](auto) {})
                     .size() > 1) {
        return false;
      }
    }
  }

private:
  // by a curve, from right to left
  Crossed crossed_edges(const Intrinsic_view<Triangulation>& view, const Curve_end& start) const {
    Crossed crossed;
    if (start.index >= 0)
      follow_curve(view, coordinates_, first_crossing(view, coordinates_, start),
                   [&](const Curve_crossing& c) {
                     crossed.push_back(t_.numbers().halfedge_at(c.halfedge));
                   });
    return crossed;
  }

  bool cross_kept(const Crossed& crossed) const {
    const auto is_kept = [this](const auto h) {
      return is_kept_[t_.numbers().halfedge(h) / 2] != 0;
    };
    return !is_kept_.empty() && std::any_of(crossed.begin(), crossed.end(), is_kept);
  }

  // Flips one edge so that the part of x from a vertex crosses fewer edges; if it crosses a face
  // twice, there may be no such flip.
  bool flip_off(const Intrinsic_view<Triangulation>& view, std::uint32_t vertex, std::uint32_t x,
                const Crossed& crossed) {
    for (const auto h : crossed) {
      if (session_.flip_edge(h) != Move_status::done) continue;
      ++result_.flips;
      const std::optional<Curve_end> start = find_curve(view, coordinates_, vertex, x);
      if (start && crossed_edges(view, *start).size() < crossed.size()) return true;
      if (session_.flip_edge(h) != Move_status::done) return false;
      ++result_.flips;
    }
    return false;
  }

  const Triangulation& t_;
  Session& session_;
  const Coordinates& coordinates_;
  std::vector<char> is_kept_;
  Segment_flipper<Triangulation> flip_to_segment_;
  Shortening_result result_;
};

} // namespace internal

/*!
\brief flips edges until some edges of the input are edges of the triangulation again, or chains of
edges through vertices that were inserted on them.

Other edges may not be Delaunay afterwards. With constraints on those that were restored
(`constrained_input_edges()`), `flip_to_delaunay()` makes the constrained Delaunay triangulation, as
if no flip had come before.
\tparam Triangulation an `Intrinsic_triangulation` with a model of `CurveCoordinates` as
correspondence
\param t the triangulation
\param is_wanted nonzero for each edge to be restored, by its number in `t.input()`
\return what was done; it may fail for an edge that crosses a face more than once
\complexity quadratic in the number of edges that cross an edge
*/
template <class Triangulation>
  requires CurveCoordinates<typename Triangulation::Correspondence>
      Restored_edges restore_input_edges(Triangulation& t, const std::vector<char>& is_wanted) {
    typename Triangulation::Session session(t);
    internal::Input_edge_restorer restore(t, session, t.correspondence());
    std::uint32_t missing = Gluing::none;
    for (std::uint32_t e = 0; e < is_wanted.size() && missing == Gluing::none; ++e)
      if (is_wanted[e] != 0 && !restore(2 * e)) missing = e;
    return {restore.flips(), missing};
  }

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_COVERS_RESTORE_INPUT_EDGES_H
