// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_DELAUNAY_REFINER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_DELAUNAY_REFINER_H

#include <CGAL/Intrinsic_triangulations/connectivity/for_each_outgoing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/parameters.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/Delaunay_flipper.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Constrained_segments.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Face_queue.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Refinement_result.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Refinement_test.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Removable_vertices.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Sheet_copies.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/dijkstra_ball.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/locate_circumcenter.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Move_status.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*!
Refines a triangulation: Chew's second algorithm, intrinsically (§4.3 of the course, Algorithm 5).

See `delaunay_refine()`; a segment is an edge of the border, a constrained one, or on a cover one over a seam. Vertices that
are removed near a split one are those in a Dijkstra ball, with their copies. For a bound of at most 30 degrees the circumradius of such a face is at least its shortest side: new
vertices keep this distance from all others.
*/
template <class Triangulation, class Visitor>
class Delaunay_refiner {
  using Mesh = typename Triangulation::Mesh;
  using Traits = boost::graph_traits<Mesh>;
  using Session = typename Triangulation::Session;
  using Vertex = typename Triangulation::vertex_descriptor;
  using Halfedge = typename Triangulation::halfedge_descriptor;
  using Face = typename Triangulation::face_descriptor;
  using View = Intrinsic_view<Triangulation>;

public:
  using Result = Refinement_result<Face>;

  /// takes the named parameters of `delaunay_refine()`.
  template <class NP>
  Delaunay_refiner(Triangulation& t, const NP& np, Visitor& visitor)
      : t_(t), mesh_(t.mesh()), copies_(t), session_(t), view_(t),
        test_(value_or<tags::minimum_angle>(np, 25.),
              value_or<tags::maximum_circumradius>(np, infinity),
              value_or<tags::maximum_edge_length>(np, infinity), t.metric().scale_exponent()),
        visitor_(visitor), flipper_(t, session_),
        order_(value_or<tags::order>(np, Refinement_order::first_come)),
        is_conforming_(value_or<tags::conforming>(np, false)),
        cap_(value_or<tags::maximum_insertions>(np, std::optional<std::uint64_t>())
                 .value_or(1000000 + 10 * std::uint64_t{num_faces(t.mesh())})) {}

  /// refines; `constrained` tells which edges are kept.
  template <class Constrained>
  Result run(const Constrained& constrained) {
    for (const auto e : edges(mesh_)) {
      const Halfedge h = halfedge(e, mesh_);
      const bool is_constrained = get(constrained, e);
      if (is_constrained || is_border(h) || is_border(opposite(h, mesh_)) ||
          copies_.is_seam(number(h) / 2))
        segments_.add(view_, number(h), is_constrained);
    }
    find_small_angles();
    removable_.find(t_, [this](Halfedge h) { return is_segment(h); });
    for (const auto e : edges(mesh_)) flipper_.push(halfedge(e, mesh_));
    flipper_.run(*this);
    touched_.clear();
    for (const Face f : faces(mesh_)) touch(f);
    if (split_encroached()) check_touched();
    while (is_going_on_ && !queue_.empty()) refine(queue_.pop());
    list_unsatisfied();
    return std::move(result_);
  }

  /// returns the edges that were kept, and the parts of those that were split.
  const Constrained_segments& segments() const { return segments_; }

  // ---- observer of the flipper
  bool before_check() { return true; }
  bool before_flip() {
    if (Triangulation::Metric::is_exact || result_.counts.flips < flip_cap()) return true;
    result_.status = Status::cap;
    is_going_on_ = false;
    return false;
  }
  bool is_constrained(Halfedge h) {
    if (!segments_.is_segment(number(h) / 2)) return false;
    if (is_conforming_ || copies_.is_seam(number(h) / 2)) encroached_.push_back(h);
    return true;
  }
  void after_flip(Halfedge h) {
    ++result_.counts.flips;
    touch(face(h, mesh_));
    touch(face(opposite(h, mesh_), mesh_));
  }
  void refused(Halfedge) { ++result_.counts.refused; }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  std::uint32_t number(Halfedge h) const { return t_.numbers().halfedge(h); }
  Halfedge descriptor(std::uint32_t h) const { return t_.numbers().halfedge_at(h); }
  bool is_border(Halfedge h) const { return face(h, mesh_) == Traits::null_face(); }
  bool is_segment(Halfedge h) const { return segments_.is_segment(number(h) / 2); }

  void find_small_angles() {
    if (segments_.empty()) return;
    segments_.find_small_angles(view_);
    if (copies_.exist())
      segments_.share_small_angles(t_.input().number_of_vertices(),
                                   [this](std::uint32_t v) { return t_.input().names().row(v); });
  }

  // with inexact numbers, rounding may make flips go round
  std::uint64_t flip_cap() const {
    return 1000000 + 100 * (std::uint64_t{num_edges(mesh_)} + result_.counts.circumcenters);
  }

  void touch(Face f) { touched_.push_back(f); }

  Face_state state(Face f) {
    const Halfedge h = halfedge(f, mesh_), n = next(h, mesh_), l = next(n, mesh_);
    const auto corner = [this](Halfedge g) { return t_.index(source(g, mesh_)); };
    const Face_state s =
        test_(t_.metric(), indexed_face(t_, f), {corner(h), corner(n), corner(l)}, segments_);
    if (s != Face_state::bad && is_bad_for_visitor(f)) return Face_state::bad;
    return s;
  }

  bool is_bad_for_visitor(Face f) {
    if constexpr (std::is_same_v<Visitor, Refinement_visitor>)
      return false;
    else
      return session_.suspended([&] { return visitor_.is_bad(t_, f); });
  }

  Face_values<double> approximation(Face f) const { return approximate_values(t_, f); }
  double priority(Face f) const { return refinement_priority(order_, approximation(f)); }

  // puts the faces that changed into the queue, or takes them out
  void check_touched() {
    for (const Face f : touched_) {
      const std::uint32_t i = t_.index(f);
      if (!queue_.begin_check(i)) continue; // seen
      if (state(f) == Face_state::bad)
        queue_.push(i, priority(f));
      else
        queue_.remove(i);
    }
    for (const Face f : touched_) queue_.end_check(t_.index(f));
    touched_.clear();
  }

  void refine(std::uint32_t f) {
    if (!may_insert()) return;
    const std::uint32_t h = number(halfedge(t_.numbers().face_at(f), mesh_));
    const auto is_segment = [this](std::uint32_t g) { return segments_.is_segment(g / 2); };
    const Located_circumcenter c = locate_circumcenter(view_, h, is_segment);
    const Face face_of_h = t_.numbers().face_at(f);
    if (c.kind == Located_circumcenter::Kind::segment)
      split_between(face_of_h, descriptor(c.segment));
    else if (c.kind == Located_circumcenter::Kind::none ||
             !insert(c.point, least_distance(approximation(face_of_h)))) {
      ++result_.counts.refused;
      give_up();
    }
    if (split_encroached()) check_touched();
  }

  // Splits a segment between a face and its circumcenter. The segment cuts off less than half of the
  // face's circle, and the face is inside: the part of the segment in the circle, whose ends are vertices
  // outside, is at least as long as the longest side of the face. Rounding alone can show a shorter one:
  // splitting that might go on for ever. Where the new vertex is outside the circle, too, the face stays
  // and waits again; as each split halves the segment, up to the shells, that ends.
  void split_between(Face f, Halfedge segment) {
    const Face_values<double> v = approximation(f);
    const double longest = *std::max_element(v.squared_lengths.begin(), v.squared_lengths.end());
    if (view_.squared_length(number(segment) / 2) < (1 - 0x1p-10) * longest) {
      ++result_.counts.refused;
      return;
    }
    const std::uint32_t i = t_.index(f);
    queue_.push(i, priority(f)); // before: what changes is checked again, and removed if it goes
    if (!split(segment)) queue_.remove(i);
  }

  bool may_insert() {
    const std::uint64_t n = result_.counts.circumcenters + result_.counts.segment_splits;
    if (n >= cap_) {
      result_.status = Status::cap;
      is_going_on_ = false;
    } else if (is_time_to_report(n) &&
               !session_.suspended([this] { return visitor_.progress(result_.counts); })) {
      result_.status = Status::cancelled;
      is_going_on_ = false;
    }
    return is_going_on_;
  }

  bool is_time_to_report(std::uint64_t insertions) {
    if (insertions < next_report_) return false;
    next_report_ = insertions + 256;
    return true;
  }

  // inserts a vertex and its copies if they keep their distance, squared, from others
  bool insert(const Surface_point& p, double distance) {
    const auto n = session_.insert_vertex(descriptor(p.halfedge), p.weights);
    if (n.status != Move_status::done) return false;
    start_from(n.vertex);
    std::vector<std::uint32_t> all{t_.index(n.vertex)};
    if (insert_copies(all) && (!flip() || std::ranges::all_of(all, [&](std::uint32_t v) {
          return keeps_distance(t_, t_.numbers().vertex_at(v), distance);
        })))
      return true;
    copies_.take(all.front());
    for (const std::uint32_t v : all) remove(t_.numbers().vertex_at(v));
    flip();
    return false;
  }

  void start_from(Vertex circumcenter) {
    ++result_.counts.circumcenters;
    removable_.set(t_.index(circumcenter), true);
    suspect_star(circumcenter);
  }

  // Inserts the copies of a vertex, all or as many as can be; whether these are all.
  bool insert_copies(std::vector<std::uint32_t>& all) {
    for (const Surface_point& place : copies_.missing(all.front())) {
      const std::optional<Vertex> v = insert_copy(place);
      if (!v) return false;
      all.push_back(t_.index(*v));
    }
    if (all.size() == 1) return true;
    copies_.join(all);
    const bool are_free =
        std::ranges::all_of(all, [this](std::uint32_t v) { return removable_.has(v); });
    for (const std::uint32_t v : all) removable_.set(v, are_free);
    return true;
  }

  // in the face where it is found, or in that beyond a side nearby
  std::optional<Vertex> insert_copy(const Surface_point& place) {
    if constexpr (Knows_places<Triangulation>) {
      const std::optional<Surface_point> p = copies_.locate(place);
      if (!p) return std::nullopt;
      if (const std::optional<Vertex> v = insert_copy_at(*p, place)) return v;
      if (const std::optional<Surface_point> q = copies_.across(*p))
        return insert_copy_at(*q, place);
    }
    return std::nullopt;
  }

  std::optional<Vertex> insert_copy_at(const Surface_point& p, const Surface_point& place) {
    const Halfedge h = descriptor(p.halfedge);
    if (p.weights[2] == 0 && is_segment(h)) return split_at(h, p.weights[1], place);
    const auto n = session_.insert_copy(h, p.weights, place);
    if (n.status != Move_status::done) return std::nullopt;
    start_from(n.vertex);
    return n.vertex;
  }

  // leaves the faces alone that wait to be looked at, until they change again
  void give_up() {
    for (const Face f : touched_) queue_.remove(t_.index(f));
    touched_.clear();
  }

  // splits a segment and its copies, and removes vertices near them; false if the triangulation refuses
  bool split(Halfedge h) {
    if (is_border(h)) h = opposite(h, mesh_);
    const double length = std::sqrt(view_.squared_length(number(h) / 2));
    const std::optional<Vertex> v =
        split_at(h, segments_.split_parameter(view_, number(h)), std::nullopt);
    if (!v) return false;
    std::vector<std::uint32_t> all{t_.index(*v)};
    if (!insert_copies(all)) ++result_.counts.refused;
    for (std::size_t i = 0; i < all.size() && flip(); ++i)
      remove_near(t_.numbers().vertex_at(all[i]), length);
    return true;
  }

  // \param place on the input, if it is known
  std::optional<Vertex> split_at(Halfedge h, double parameter,
                                 const std::optional<Surface_point>& place) {
    const std::uint32_t e = number(h) / 2;
    const std::array<std::uint32_t, 2> ends{t_.index(source(h, mesh_)), t_.index(target(h, mesh_))};
    const bool on_border = is_border(opposite(h, mesh_));
    const auto n = insert_on_edge(h, parameter, place);
    if (n.status != Move_status::done) {
      ++result_.counts.refused;
      return std::nullopt;
    }
    ++result_.counts.segment_splits;
    // on the border h is the first half; inside it was flipped, and runs from the vertex
    const Halfedge other =
        on_border ? next(opposite(next(h, mesh_), mesh_), mesh_) : next(opposite(h, mesh_), mesh_);
    const Halfedge one = on_border ? h : next(next(h, mesh_), mesh_);
    segments_.split(e, {number(one) / 2, number(other) / 2}, ends, t_.index(n.vertex), parameter);
    removable_.set(t_.index(n.vertex), false);
    suspect_star(n.vertex);
    return n.vertex;
  }

  auto insert_on_edge(Halfedge h, double parameter, const std::optional<Surface_point>& place) {
    if constexpr (Knows_places<Triangulation>)
      if (place) return session_.insert_copy(h, {1 - parameter, parameter, 0}, *place);
    return session_.split_edge(h, parameter);
  }

  // splits constrained edges that are not locally Delaunay, if that is asked for
  bool split_encroached() {
    while (is_going_on_ && !encroached_.empty()) {
      const Halfedge h = encroached_.back();
      encroached_.pop_back();
      if (is_segment(h) && !session_.is_locally_delaunay(h) &&
          !segments_.is_between_shells(view_, number(h)) && may_insert())
        split(h);
    }
    return is_going_on_;
  }

  bool flip() { return flipper_.run(*this); }

  void suspect_star(Vertex v) {
    flipper_.push_star(v);
    for_each_outgoing(v, mesh_, [this](Halfedge h) {
      if (!is_border(h)) touch(face(h, mesh_));
    });
  }

  // ---- removal of inserted vertices near a split segment

  void remove_near(Vertex v, double radius) {
    for (const std::uint32_t w : dijkstra_ball(view_, t_.index(v), radius)) {
      if (!removable_.has(w)) continue;
      for (const std::uint32_t copy : copies_.take(w)) {
        remove(t_.numbers().vertex_at(copy));
        if (!flip()) return; // now: edges that wait may be removed next
      }
    }
  }

  void remove(Vertex v) {
    std::vector<Halfedge> rim;
    std::vector<std::uint32_t> old;
    for_each_outgoing(v, mesh_, [&](Halfedge h) {
      const Halfedge opposite_side = next(h, mesh_); // unless there is a loop, which goes
      if (target(h, mesh_) != v && target(opposite_side, mesh_) != v) rim.push_back(opposite_side);
      old.push_back(t_.index(face(h, mesh_)));
    });
    const std::uint32_t number_of_v = t_.index(v);
    if (session_.remove_vertex(v) != Move_status::done) {
      ++result_.counts.refused;
      for (const Halfedge h : rim) suspect_face(h); // flips have been taken back
      return;
    }
    ++result_.counts.removals;
    removable_.set(number_of_v, false);
    touched_.erase(std::remove_if(touched_.begin(), touched_.end(),
                                  [&](Face f) {
                                    return std::find(old.begin(), old.end(), t_.index(f)) !=
                                           old.end();
                                  }),
                   touched_.end());
    for (const std::uint32_t f : old) queue_.remove(f);
    // the faces of a polygon that was a star: two less than the star had
    if (!rim.empty() && old.size() > 2)
      for (const Halfedge h : faces_inside(t_, rim, old.size() - 2)) suspect_face(h);
  }

  void suspect_face(Halfedge h) {
    touch(face(h, mesh_));
    for (int k = 0; k < 3; ++k, h = next(h, mesh_)) flipper_.push(h);
  }

  // ---- the end

  void list_unsatisfied() {
    for (const Face f : faces(mesh_)) {
      const Face_state s = state(f);
      if (s == Face_state::good) continue;
      result_.unsatisfied.push_back({f, unsatisfied_reason(s, !is_going_on_)});
    }
  }

  Triangulation& t_;
  const Mesh& mesh_;
  Sheet_copies<Triangulation> copies_;
  Session session_;
  View view_;
  Refinement_test test_;
  Visitor& visitor_;
  Delaunay_flipper<Triangulation> flipper_;
  Refinement_order order_;
  bool is_conforming_;
  std::uint64_t cap_;
  Constrained_segments segments_;
  Face_queue queue_;
  std::vector<Face> touched_;
  std::vector<Halfedge> encroached_;
  Removable_vertices removable_;
  std::uint64_t next_report_ = 255;
  bool is_going_on_ = true;
  Result result_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_DELAUNAY_REFINER_H
