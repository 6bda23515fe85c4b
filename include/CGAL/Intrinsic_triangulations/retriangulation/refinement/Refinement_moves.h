// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_REFINEMENT_MOVES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_REFINEMENT_MOVES_H

#include <CGAL/Intrinsic_triangulations/connectivity/for_each_outgoing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/covers/Sheet_copies.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/Delaunay_flipper.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Constrained_segments.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Refinement_state.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/dijkstra_ball.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/caps.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_set>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*!
Inserts and removes vertices of a triangulation that is being refined, with their copies on the
sheets of a cover, and flips it back to Delaunay; notes which faces changed. `Delaunay_refiner`
decides what comes next.
*/
template <class Triangulation>
class Refinement_moves {
  using Mesh = typename Triangulation::Mesh;
  using Traits = boost::graph_traits<Mesh>;
  using Session = typename Triangulation::Session;
  using Vertex = typename Triangulation::vertex_descriptor;
  using Halfedge = typename Triangulation::halfedge_descriptor;
  using Face = typename Triangulation::face_descriptor;
  using View = Intrinsic_view<Triangulation>;
  using State = Refinement_state<Triangulation>;

public:
  enum class Insertion {
    done,     // it is there, with its copies
    not_here, // a copy would come too close to other vertices: nothing has changed
    refused   // by the triangulation, or too close in the end: edges may have been flipped
  };

  // records changes and results in `state`
  Refinement_moves(Triangulation& t, bool is_conforming, State& state)
      : t_(t), mesh_(t.mesh()), state_(state), copies_(t), session_(t), view_(t),
        flipper_(t, session_), is_conforming_(is_conforming) {}

  Session& session() { return session_; }
  // whether vertices have copies on a cover
  bool has_copies() const { return copies_.exist(); }
  Constrained_segments& segments() { return segments_; }

  // \param is_kept which edges, by number, are constrained; empty: none
  void find_segments(const std::vector<char>& is_kept) {
    state_.result.counts.flips += copies_.restore_seams(session_, is_kept);
    for (const auto e : edges(mesh_)) {
      const Halfedge h = halfedge(e, mesh_);
      const bool is_constrained = !is_kept.empty() && is_kept[number(h) / 2] != 0;
      const bool is_seam = copies_.is_seam(number(h) / 2);
      if (is_constrained || is_seam || is_border(h) || is_border(opposite(h, mesh_)))
        segments_.add(view_, number(h), is_constrained, is_seam);
    }
    segments_.find_small_angles(view_);
    for (const Vertex v : vertices(mesh_)) // inserted by a refinement that goes on, or by the user
      if (t_.is_inserted(v) && !is_on_segment(v)) removable_.insert(t_.index(v));
  }

  void suspect(Halfedge h) { flipper_.push(h); } // an edge that may not be Delaunay

  // Flips until all waiting edges are Delaunay; calls `may_go_on` before every check.
  template <class May_go_on>
  bool flip(const May_go_on& may_go_on) {
    Observer<May_go_on> observer{*this, may_go_on};
    return flipper_.run(observer);
  }
  bool flip() {
    return flip([] { return true; });
  }

  // Inserts a vertex and its copies if all keep a least distance, squared, from other vertices.
  // \param wanted the one, squared, that copies must have before if the vertex is inside a face
  Insertion insert(const Surface_point& p, double least, double wanted) {
    const auto n = session_.insert_vertex(descriptor(p.halfedge), p.weights);
    if (n.status != Move_status::done) return Insertion::refused;
    const std::vector<Surface_point> places = copies_.missing(t_.index(n.vertex));
    const bool is_in_face = std::count(p.weights.begin(), p.weights.end(), 0.) == 0;
    const auto is_free = [&](auto& q) { return has_room(q, is_in_face ? wanted : least); };
    const bool have_room = std::all_of(places.begin(), places.end(), is_free);
    // removed from an edge, it would leave other edges than before: it is flipped away below
    if (is_in_face && !have_room && session_.remove_vertex(n.vertex) == Move_status::done)
      return Insertion::not_here;
    start_from(n.vertex);
    std::vector<std::uint32_t> all{t_.index(n.vertex)};
    const auto keeps = [&](std::uint32_t v) {
      return keeps_distance(t_, t_.numbers().vertex_at(v), least, v == all.front());
    };
    const auto all_keep = [&] { return std::all_of(all.begin(), all.end(), keeps); };
    if (have_room && insert_copies(places, all) && (!flip() || all_keep())) return Insertion::done;
    copies_.take(all.front());
    for (const std::uint32_t v : all) {
      if (!flip()) return Insertion::refused; // before: edges that wait may be removed
      if (!is_on_segment(t_.numbers().vertex_at(v))) remove(t_.numbers().vertex_at(v));
    }
    flip();
    return Insertion::refused;
  }
  // inserts a vertex without its copies; false if the triangulation refuses
  bool insert_alone(const Surface_point& p) {
    const auto n = session_.insert_vertex(descriptor(p.halfedge), p.weights);
    if (n.status != Move_status::done) return false;
    ++state_.result.counts.without_copies;
    start_from(n.vertex);
    flip();
    return true;
  }
  // Splits a segment and those under it, and removes vertices near them; false if the triangulation
  // refuses. Where there is no segment on another sheet, as for constrained edges, copies are
  // inserted if they are as far from other vertices as the ends of the parts from each other.
  bool split(Halfedge h) {
    if (is_border(h)) h = opposite(h, mesh_);
    const double length = std::sqrt(view_.squared_length(number(h) / 2)),
                 parameter = segments_.split_parameter(view_, number(h));
    const std::optional<Vertex> v = split_at(h, parameter, std::nullopt);
    if (!v) return false;
    std::vector<std::uint32_t> all{t_.index(*v)};
    std::vector<Surface_point> places = copies_.missing(all.front());
    std::erase_if(places, [&](const Surface_point& place) {
      const std::optional<Vertex> copy = split_copy(place);
      if (copy) all.push_back(t_.index(*copy));
      return copy.has_value();
    });
    for (std::size_t i = 0; i < all.size() && flip(); ++i)
      remove_near(t_.numbers().vertex_at(all[i]), length);
    const double least = length * std::min(parameter, 1 - parameter);
    std::erase_if(places, [&](const Surface_point& place) {
      return has_room(place, (1 - 0x1p-10) * least * least) && insert_copy(place) && flip();
    });
    if (!places.empty()) ++state_.result.counts.without_copies;
    return true;
  }

private:
  template <class May_go_on>
  struct Observer {
    Refinement_moves& moves;
    const May_go_on& may_go_on;

    bool before_check() { return may_go_on(); }
    bool before_flip() { return moves.before_flip(); }
    bool is_constrained(Halfedge h) { return moves.is_constrained(h); }
    void after_flip(Halfedge h) {
      ++moves.state_.result.counts.flips;
      moves.touch(face(h, moves.mesh_));
      moves.touch(face(opposite(h, moves.mesh_), moves.mesh_));
    }
    void refused(Halfedge) { ++moves.state_.result.counts.refused; }
  };

  bool before_flip() {
    return Triangulation::Metric::is_exact ||
           state_.result.counts.flips <
               flip_cap(num_edges(mesh_) + state_.result.counts.circumcenters) ||
           state_.stop(Status::cap);
  }
  bool is_constrained(Halfedge h) {
    const std::uint32_t e = number(h) / 2;
    if (!segments_.is_segment(e)) return false;
    const bool is_seam = segments_.is_seam(e);
    if (is_seam && !state_.is_going_on && !segments_.is_constrained(e)) {
      segments_.release(e);
      return false;
    }
    if (is_conforming_ || is_seam) state_.encroached.push_back(h);
    return true;
  }
  std::uint32_t number(Halfedge h) const { return t_.numbers().halfedge(h); }
  Halfedge descriptor(std::uint32_t h) const { return t_.numbers().halfedge_at(h); }
  bool is_border(Halfedge h) const { return face(h, mesh_) == Traits::null_face(); }
  bool is_segment(Halfedge h) const { return segments_.is_segment(number(h) / 2); }

  void touch(Face f) { state_.touched.push_back(f); }
  bool is_on_segment(const Surface_point& p) const {
    return p.weights[2] == 0 && segments_.is_segment(p.halfedge / 2);
  }
  // whether a copy keeps a squared distance from other vertices
  bool has_room(const Surface_point& place, double distance) const {
    return copies_.has_room(place, distance,
                            [this](std::uint32_t h) { return segments_.is_segment(h / 2); });
  }

  // such a copy stays: without it the parts of the segment would not be edges
  bool is_on_segment(Vertex v) const {
    bool is_on_one = false;
    for_each_outgoing(v, mesh_, [&](Halfedge h) { is_on_one |= is_segment(h); });
    return is_on_one;
  }

  void start_from(Vertex circumcenter) {
    ++state_.result.counts.circumcenters;
    removable_.insert(t_.index(circumcenter));
    copies_.note(t_.index(circumcenter));
    suspect_star(circumcenter);
  }

  // Inserts copies of a vertex at places, all or as many as can be; whether these are all.
  bool insert_copies(const std::vector<Surface_point>& places, std::vector<std::uint32_t>& all) {
    for (const Surface_point& place : places)
      if (const std::optional<Vertex> v = insert_copy(place))
        all.push_back(t_.index(*v));
      else
        return false;
    if (all.size() > 1) copies_.join(all);
    return true;
  }

  // on the segment where it is, if there is one
  std::optional<Vertex> split_copy(const Surface_point& place) {
    if constexpr (Knows_places<Triangulation>) {
      for (const Surface_point& p : copies_.locate(place))
        if (is_on_segment(p)) return split_at(descriptor(p.halfedge), p.weights[1], place);
    }
    return std::nullopt;
  }

  // in the first face of those where it may be
  std::optional<Vertex> insert_copy(const Surface_point& place) {
    if constexpr (Knows_places<Triangulation>) {
      for (const Surface_point& p : copies_.locate(place))
        if (const std::optional<Vertex> v = insert_copy_at(p, place)) return v;
    }
    return std::nullopt;
  }

  std::optional<Vertex> insert_copy_at(const Surface_point& p, const Surface_point& place) {
    const Halfedge h = descriptor(p.halfedge);
    if (is_on_segment(p)) return split_at(h, p.weights[1], place);
    const auto n = session_.insert_copy(h, p.weights, place);
    if (n.status != Move_status::done) return std::nullopt;
    start_from(n.vertex);
    return n.vertex;
  }

  std::optional<Vertex> split_at(Halfedge h, double parameter,
                                 const std::optional<Surface_point>& place) {
    const std::uint32_t e = number(h) / 2;
    const std::array<std::uint32_t, 2> ends{t_.index(source(h, mesh_)), t_.index(target(h, mesh_))};
    const bool on_border = is_border(opposite(h, mesh_));
    const auto n = insert_on_edge(h, parameter, place);
    if (n.status != Move_status::done) {
      ++state_.result.counts.refused;
      return std::nullopt;
    }
    ++state_.result.counts.segment_splits;
    // on the border h is the first half; inside it was flipped, and runs from the vertex
    const Halfedge other =
        on_border ? next(opposite(next(h, mesh_), mesh_), mesh_) : next(opposite(h, mesh_), mesh_);
    const Halfedge one = on_border ? h : next(next(h, mesh_), mesh_);
    segments_.split(e, {number(one) / 2, number(other) / 2}, ends, t_.index(n.vertex), parameter);
    removable_.erase(t_.index(n.vertex));
    copies_.note(t_.index(n.vertex));
    suspect_star(n.vertex);
    return n.vertex;
  }

  auto insert_on_edge(Halfedge h, double parameter, const std::optional<Surface_point>& place) {
    if constexpr (Knows_places<Triangulation>)
      if (place) return session_.insert_copy(h, {1 - parameter, parameter, 0}, *place);
    return session_.split_edge(h, parameter);
  }

  void suspect_star(Vertex v) {
    flipper_.push_star(v);
    for_each_outgoing(v, mesh_, [this](Halfedge h) {
      if (!is_border(h)) touch(face(h, mesh_));
    });
  }

  // ---- removal of inserted vertices near a split segment

  void remove_near(Vertex v, double radius) {
    for (const std::uint32_t w : dijkstra_ball(view_, t_.index(v), radius)) {
      if (!removable_.contains(w)) continue;
      for (const std::uint32_t copy : copies_.take(w)) {
        if (!removable_.contains(copy)) continue; // on a segment
        remove(t_.numbers().vertex_at(copy));
        if (!flip()) return; // now: edges that wait may be removed next
      }
    }
  }

  void remove(Vertex v) {
    std::vector<Halfedge> rim;
    std::vector<std::uint32_t> old;
    for_each_outgoing(v, mesh_, [&](Halfedge h) {
      const Halfedge opposite_side = next(h, mesh_); // unless there is a loop, which is removed
      if (target(h, mesh_) != v && target(opposite_side, mesh_) != v) rim.push_back(opposite_side);
      old.push_back(t_.index(face(h, mesh_)));
    });
    const std::uint32_t number_of_v = t_.index(v);
    copies_.forget(number_of_v);
    if (session_.remove_vertex(v) != Move_status::done) {
      copies_.note(number_of_v);
      ++state_.result.counts.refused;
      for (const Halfedge h : rim) suspect_face(h); // flips have been taken back
      return;
    }
    ++state_.result.counts.removals;
    removable_.erase(number_of_v);
    const auto is_old = [&](Face f) { return std::count(old.begin(), old.end(), t_.index(f)) > 0; };
    std::erase_if(state_.touched, is_old);
    for (const std::uint32_t f : old) state_.queue.remove(f);
    // the faces of a polygon that was a star: two less than the star had
    if (!rim.empty() && old.size() > 2)
      for (const Halfedge h : faces_inside(t_, rim, old.size() - 2)) suspect_face(h);
  }

  void suspect_face(Halfedge h) {
    touch(face(h, mesh_));
    for (int k = 0; k < 3; ++k, h = next(h, mesh_)) flipper_.push(h);
  }

  Triangulation& t_;
  const Mesh& mesh_;
  State& state_;
  Sheet_copies<Triangulation> copies_;
  Session session_;
  View view_;
  Delaunay_flipper<Triangulation> flipper_;
  bool is_conforming_;
  Constrained_segments segments_;
  // may be removed near a segment that is split: inserted, on no segment
  std::unordered_set<std::uint32_t> removable_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_REFINEMENT_MOVES_H
