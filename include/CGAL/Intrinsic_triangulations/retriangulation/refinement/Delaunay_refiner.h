// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_DELAUNAY_REFINER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_DELAUNAY_REFINER_H

#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Proof_watch.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Constrained_segments.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Refinement_moves.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Refinement_result.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Refinement_settings.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Refinement_test.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Surface_check.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/locate_circumcenter.h>
#include <CGAL/Intrinsic_triangulations/support/caps.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*!
Refines a triangulation: Chew's second algorithm, intrinsically (§4.3 of the course, Algorithm 5).

See `delaunay_refine()`; a segment is an edge of the border, a constrained one, or on a cover one
along a wide seam. Vertices that are removed near a split one are those in a Dijkstra ball, with
their copies. For a bound of at most 30 degrees the circumradius of such a face is at least its
shortest side: new vertices keep this distance from all others.

On a cover, copies must keep it, too. Exchanging sheets is an isometry of the cover cut along its
seams, see `Sheets`, and maps vertices to vertices: unless seams are crossed, a copy is as far from
other vertices as the circumcenter. Seams that make wide angles with each other are segments: splits
do not lead from one to the next without end (Ruppert). Seams with small angles between them are
crossed like other edges, since neither belongs to the user's surface, and a constrained edge may be
on one sheet only. So the distances of copies are measured: they are inserted only where all of them
keep theirs. Where no such place is found, the circumcenter is inserted without its copies when all
other faces are done. So every vertex, copy or not, keeps the distance that Chew's argument needs,
and refinement ends as if there were no copies.
*/
template <class Triangulation>
class Delaunay_refiner {
  using Moves = Refinement_moves<Triangulation>;
  using Mesh = typename Triangulation::Mesh;
  using Face = typename Triangulation::face_descriptor;
  using Halfedge = typename Triangulation::halfedge_descriptor;
  using Insertion = typename Moves::Insertion;
  using Corners = std::array<std::uint32_t, 3>; // of a face, in order

public:
  using Result = Refinement_result<Face>;

  Delaunay_refiner(Triangulation& t, const Refinement_settings& asked,
                   const Refinement_questions<Triangulation>& visitor)
      : t_(t), mesh_(t.mesh()), view_(t), moves_(t, asked.is_conforming, state_),
        test_(asked.minimum_angle, asked.maximum_circumradius, asked.maximum_edge_length,
              t.metric().scale_exponent()),
        visitor_(visitor), order_(asked.order),
        cap_(asked.maximum_insertions.value_or(insertion_cap(num_faces(t.mesh())))) {}

  /// refines; `is_kept` says which edges, by number, are constrained; empty: none.
  Result run(const std::vector<char>& is_kept) {
    moves_.find_segments(is_kept);
    for (const auto e : edges(mesh_)) moves_.suspect(halfedge(e, mesh_));
    moves_.flip([this] { return (++checks_ & 0xffffU) != 0 || ask_visitor(); });
    state_.touched.clear();
    for (const Face f : faces(mesh_)) state_.touched.push_back(f);
    if (split_encroached()) check_touched();
    do
      while (state_.is_going_on && !state_.queue.empty()) refine(state_.queue.pop());
    while (queue_refused());
    if (!state_.is_going_on) flip_over_seams();
    list_unsatisfied();
    return std::move(state_.result);
  }

  /// moves out the edges that were kept, and the parts of those that were split.
  Constrained_segments take_segments() { return std::move(moves_.segments()); }

private:
  std::uint32_t number(Halfedge h) const { return t_.numbers().halfedge(h); }
  Halfedge descriptor(std::uint32_t h) const { return t_.numbers().halfedge_at(h); }

  // where its sides start
  std::array<std::uint32_t, 3> corners_of_sides(Face f) const {
    const Halfedge h = halfedge(f, mesh_), n = next(h, mesh_), l = next(n, mesh_);
    return {t_.index(source(h, mesh_)), t_.index(source(n, mesh_)), t_.index(source(l, mesh_))};
  }
  Corners corners(Face f) const {
    Corners result = corners_of_sides(f);
    std::sort(result.begin(), result.end());
    return result;
  }

  Face_state state(Face f) {
    const Face_state s = test_(t_, indexed_face(t_, f), corners_of_sides(f), moves_.segments());
    if (s != Face_state::bad && is_bad_for_visitor(f)) return Face_state::bad;
    return s;
  }

  bool is_bad_for_visitor(Face f) {
    return visitor_.is_bad && moves_.session().suspended([&] { return visitor_.is_bad(f); });
  }

  Face_values<double> approximation(Face f) const { return approximate_values(t_, f); }
  double priority(Face f) const { return refinement_priority(order_, approximation(f)); }

  // puts the faces that changed into the queue, or takes them out
  void check_touched() {
    for (const Face f : state_.touched) {
      const std::uint32_t i = t_.index(f);
      if (!state_.queue.begin_check(i)) continue; // seen
      if (!state_.is_going_on || ((++checks_ & 0x3fffU) == 0 && !ask_visitor())) continue;
      if (state(f) == Face_state::bad && refusals(corners(f)) == 0)
        state_.queue.push(i, priority(f));
      else
        state_.queue.remove(i);
    }
    for (const Face f : state_.touched) state_.queue.end_check(t_.index(f));
    state_.touched.clear();
  }

  void refine(std::uint32_t f) {
    if (!may_insert()) return;
    // in thin faces lengths and area may be too inaccurate to agree
    const Corners face = corners(t_.numbers().face_at(f));
    const bool is_done =
        refine(f, view_) || (state_.touched.empty() && refine(f, Accurate_view<Triangulation>(t_)));
    if (!is_done) {
      ++state_.result.counts.refused;
      ++refusals_[face];
    }
    if (split_encroached()) check_touched();
  }

  int refusals(const Corners& face) const {
    const auto found = refusals_.find(face);
    return found == refusals_.end() ? 0 : found->second;
  }

  // On a cover, queues the bad faces again, for vertices without copies. Whether there are any.
  bool queue_refused() {
    if (!state_.is_going_on || !moves_.has_copies()) return false;
    for (const Face f : faces(mesh_))
      if (refusals(corners(f)) < 2 && state(f) == Face_state::bad)
        state_.queue.push(t_.index(f), priority(f));
    return !state_.queue.empty();
  }

  // whether there was a circumcenter, by the values of a view, and a vertex was inserted; if not,
  // usually nothing has changed
  template <class Complex>
  bool refine(std::uint32_t f, const Complex& view) {
    using Kind = Located_circumcenter::Kind;
    const Face bad = t_.numbers().face_at(f);
    const std::uint32_t h = number(halfedge(bad, mesh_));
    const auto is_kept = [this](std::uint32_t g) { return moves_.segments().is_segment(g / 2); };
    const Located_circumcenter c = locate_circumcenter(view, h, is_kept);
    if (c.kind == Kind::segment) split_between(bad, descriptor(c.segment));
    if (c.kind != Kind::point) return c.kind == Kind::segment;
    return insert_near(approximation(bad), h, c.point, view);
  }

  // Inserts a circumcenter. On a cover a copy may be close to other vertices: then other points of
  // a disk about the circumcenter are tried, and in the end the circumcenter alone.
  template <class Complex>
  bool insert_near(const Face_values<double>& v, std::uint32_t h, const Surface_point& center,
                   const Complex& view) {
    const auto is_kept = [this](std::uint32_t g) { return moves_.segments().is_segment(g / 2); };
    if (moves_.has_copies() && refusals(corners(face(descriptor(h), mesh_))) > 0)
      return moves_.insert_alone(center);
    const double least = least_distance(v, test_.is_thin(v)),
                 radius = std::sqrt(squared_circumradius(v)),
                 wanted = std::max(least, radius * radius / 4),
                 offset = std::min(radius / 2, radius - std::sqrt(least));
    Insertion found = moves_.insert(center, least, wanted);
    for (int k = 0; k < number_of_tries && found == Insertion::not_here; ++k) {
      const double angle = k * 2 * std::numbers::pi / number_of_tries;
      const Located_circumcenter c = locate_circumcenter(
          view, h, is_kept, {offset * std::cos(angle), offset * std::sin(angle)});
      if (c.kind == Located_circumcenter::Kind::point)
        found = moves_.insert(c.point, least, wanted);
    }
    return found == Insertion::done;
  }

  // Splits a segment between a face and its circumcenter. The segment cuts off less than half of
  // the face's circle, and the face is inside: the part of the segment in the circle, whose ends
  // are vertices outside, is at least as long as the longest side of the face. Only rounding can
  // show a shorter part: splitting it might not end. If the new vertex is outside the circle, too,
  // the face stays and waits again; this ends, since each split halves the segment, up to the
  // shells.
  void split_between(Face f, Halfedge segment) {
    const Face_values<double> v = approximation(f);
    const double longest = *std::max_element(v.squared_lengths.begin(), v.squared_lengths.end());
    const bool is_long = view_.squared_length(number(segment) / 2) >= (1 - 0x1p-10) * longest;
    const std::uint32_t i = t_.index(f);
    // before the split: changed edges are checked again, removed ones dropped
    state_.queue.push(i, priority(f));
    if (is_long && moves_.split(segment)) {
      refusals_.clear(); // vertices near it are removed
      return;
    }
    state_.queue.remove(i);
    ++refusals_[corners(f)];
    if (!is_long) ++state_.result.counts.refused;
  }

  bool may_insert() {
    const std::uint64_t n =
        state_.result.counts.circumcenters + state_.result.counts.segment_splits;
    if (n >= cap_) {
      state_.stop(Status::cap);
    } else if (is_time_to_report(n)) {
      ask_visitor();
    }
    return state_.is_going_on;
  }

  bool ask_visitor() {
    if (moves_.session().suspended([this] { return visitor_.progress(state_.result.counts); }))
      return true;
    return state_.stop(Status::cancelled);
  }

  bool is_time_to_report(std::uint64_t insertions) {
    if (insertions < next_report_ && !watch_.is_stopped()) return false;
    next_report_ = insertions + 256;
    return true;
  }

  // splits constrained edges that are not locally Delaunay, if the options say so
  bool split_encroached() {
    while (state_.is_going_on && !state_.encroached.empty()) {
      const Halfedge h = state_.encroached.back();
      state_.encroached.pop_back();
      if (moves_.segments().is_segment(number(h) / 2) && !moves_.session().is_locally_delaunay(h) &&
          !moves_.segments().is_between_shells(view_, number(h)) && may_insert())
        moves_.split(h);
    }
    return state_.is_going_on;
  }

  // ---- the end

  // Seams that are not Delaunay are split until they are. If refinement stops before, they are
  // flipped instead.
  void flip_over_seams() {
    for (const auto e : edges(mesh_))
      if (moves_.segments().is_seam(t_.index(e))) moves_.suspect(halfedge(e, mesh_));
    moves_.flip();
  }

  void list_unsatisfied() {
    for (const Face f : faces(mesh_)) {
      const Face_state s = state(f);
      if (s == Face_state::good) continue;
      state_.result.unsatisfied.push_back({f, unsatisfied_reason(s, !state_.is_going_on)});
      if (state_.result.status == Status::done &&
          state_.result.unsatisfied.back().reason == Unsatisfied_reason::refused)
        state_.result.status = Status::stalled;
    }
  }

  // Directions, all around: six points at a distance from the center have it from each other, too.
  static constexpr int number_of_tries = 6;

  Triangulation& t_;
  const Mesh& mesh_;
  Intrinsic_view<Triangulation> view_;
  Refinement_state<Triangulation> state_;
  Moves moves_;
  Refinement_test test_;
  std::map<Corners, int> refusals_; // how often no vertex could be inserted for a face
  const Refinement_questions<Triangulation>& visitor_;
  Proof_watch watch_{[this] { return visitor_.progress(state_.result.counts); }};
  Refinement_order order_;
  std::uint64_t cap_;
  std::uint64_t next_report_ = 255, checks_ = 0;
};

// The result of refinement, and the edges that were kept, with the parts of those that were split.
template <std::semiregular Face>
struct Refined {
  Refinement_result<Face> result;
  Constrained_segments segments;
};

// Not inline, and with no type but the triangulation's: the library has it compiled for the usual
// triangulations.
template <class Triangulation>
Refined<typename Triangulation::face_descriptor>
refine(Triangulation& t, const Refinement_settings& asked, const std::vector<char>& is_kept,
       const Refinement_questions<Triangulation>& visitor) {
  const Surface_check<Triangulation> check(t);
  Delaunay_refiner<Triangulation> refiner(t, asked, visitor);
  auto result = refiner.run(is_kept);
  check.conclude(result);
  return {std::move(result), refiner.take_segments()};
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_DELAUNAY_REFINER_H
