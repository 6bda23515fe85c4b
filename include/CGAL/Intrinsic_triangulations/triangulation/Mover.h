// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_MOVER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_MOVER_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Status.h>
#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/connectivity/moves.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/metric/nearest_lengths.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Moves.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/enum.h>

#include <boost/config.hpp>
#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations::internal {

// The edges and faces at an edge with two faces.
template <class Mesh>
BOOST_FORCEINLINE Diamond diamond_of(typename boost::graph_traits<Mesh>::halfedge_descriptor h,
                                     const Mesh& mesh, const Mesh_adaptor<Mesh>& number) {
  using Halfedge = typename boost::graph_traits<Mesh>::halfedge_descriptor;
  const Halfedge o = opposite(h, mesh), jk = next(h, mesh), im = next(o, mesh);
  return {number.halfedge(h) / 2,
          number.halfedge(jk) / 2,
          number.halfedge(next(jk, mesh)) / 2,
          number.halfedge(im) / 2,
          number.halfedge(next(im, mesh)) / 2,
          number.face(face(h, mesh)),
          number.face(face(o, mesh))};
}

// The record of the flip of an edge with two faces. It stores the diamond, too: computing it from
// the other numbers would cost more than reading the mesh again.
template <class Mesh>
BOOST_FORCEINLINE Flip flip_record(typename boost::graph_traits<Mesh>::halfedge_descriptor h,
                                   const Mesh& mesh, const Mesh_adaptor<Mesh>& number) {
  using Halfedge = typename boost::graph_traits<Mesh>::halfedge_descriptor;
  const Halfedge jk = next(h, mesh), im = next(opposite(h, mesh), mesh);
  return {number.halfedge(h),
          number.halfedge(jk),
          number.halfedge(next(jk, mesh)),
          number.halfedge(im),
          number.halfedge(next(im, mesh)),
          number.halfedge(h),
          diamond_of(h, mesh, number)};
}

// The elementary moves of a triangulation. Each makes its record, computes the values, announces
// itself to the correspondence, changes connectivity and metric, and notifies the correspondence. A
// refused move changes nothing.
template <class Triangulation>
class Mover {
  using Mesh = typename Triangulation::Mesh;
  using Graph_traits = boost::graph_traits<Mesh>;
  using Metric = typename Triangulation::Metric;
  using Vertex = typename Graph_traits::vertex_descriptor;
  using Halfedge = typename Graph_traits::halfedge_descriptor;
  using Weights = std::array<double, 3>;
  using Wanted = std::optional<Surface_point>;

public:
  using Insertion = typename Triangulation::Insertion;

  explicit Mover(Triangulation& t)
      : t_(t), mesh_(t.numbered_.mesh), number_(t.numbered_.numbers), metric_(t.metric_),
        correspondence_(t.correspondence_), places_(t.places_) {}

  // of the face of h with the sides ij, jk, ki, without a vertex inside
  Star_of_vertex star_of_face(Halfedge h) const {
    const Halfedge jk = next(h, mesh_), ki = next(jk, mesh_);
    return {{number_.halfedge(h), number_.halfedge(jk), number_.halfedge(ki)},
            {Gluing::none, Gluing::none, Gluing::none},
            {face_number(h), Gluing::none, Gluing::none},
            Gluing::none};
  }

  // of the vertex opposite h
  Star_of_vertex star_of_vertex(Halfedge h) const {
    const Halfedge jp = next(h, mesh_), pi = next(jp, mesh_);
    const Halfedge jk = next(opposite(jp, mesh_), mesh_), kp = next(jk, mesh_);
    const Halfedge ki = next(opposite(kp, mesh_), mesh_);
    return {{number_.halfedge(h), number_.halfedge(jk), number_.halfedge(ki)},
            {number_.halfedge(pi) ^ 1U, number_.halfedge(jp), number_.halfedge(kp)},
            {face_number(h), face_number(jk), face_number(ki)},
            number_.vertex(target(jp, mesh_))};
  }

  // of the border edge of h, without a vertex on it
  Star_on_border star_of_border_edge(Halfedge h) const {
    const Halfedge jk = next(h, mesh_), ki = next(jk, mesh_);
    return {number_.halfedge(h),  Gluing::none,   Gluing::none, number_.halfedge(jk),
            number_.halfedge(ki), face_number(h), Gluing::none, Gluing::none};
  }

  // of the target of h
  Star_on_border star_on_border(Halfedge h) const {
    const Halfedge pk = next(h, mesh_), ki = next(pk, mesh_);
    const Halfedge pj = next(opposite(pk, mesh_), mesh_), jk = next(pj, mesh_);
    return {number_.halfedge(h),  number_.halfedge(pk),
            number_.halfedge(pj), number_.halfedge(jk),
            number_.halfedge(ki), face_number(h),
            face_number(pj),      number_.vertex(target(h, mesh_))};
  }

  Move_status flip(Halfedge h) {
    return flip(h, [this](const Diamond& d) { return metric_.compute_flip(d); });
  }
  // for long sequences
  Move_status flip_consistently(Halfedge h) {
    if constexpr (requires(const Diamond& d) { metric_.compute_consistent_flip(d); })
      return flip(h, [this](const Diamond& d) { return metric_.compute_consistent_flip(d); });
    else
      return flip(h);
  }
  Move_status flip_to_zero_area(Halfedge h) {
    return flip(h, [this](const Diamond& d) { return metric_.compute_flip_to_zero_area(d); });
  }
  // Inlined by force, for the loops over many flips: a call costs a third of a flip in doubles.
  template <class Compute>
  BOOST_FORCEINLINE Move_status flip(Halfedge h, const Compute& compute_values) {
    const Flip move = flip_record(h, mesh_, number_);
    const auto values = compute_values(move.diamond);
    if (!values) return Move_status::arithmetic;
    if (!ask(move)) return Move_status::crossings;
    CGAL::Euler::flip_edge(h, mesh_);
    metric_.store_flip(move.diamond, *values);
    tell(move);
    return Move_status::done;
  }

  // Takes back the flip of h, the last one; observers follow.
  void undo_flip(Halfedge h, const typename Metric::Flipped& before) {
    Flip move = flip_record(h, mesh_, number_);
    move.km = move.ij ^ 1U;
    places_.before(t_, move);
    correspondence_.before(t_, move);
    flip_edge_back(h, mesh_);
    metric_.store_flip(move.diamond, before);
    places_.after_undoing(t_, move);
    t_.exact_memory_.after(move);
    correspondence_.after(t_, move);
  }

  // Not a move of the correspondence. Metrics allocate memory for the first factors only.
  void scale_vertices(std::span<const double> factors,
                      std::span<const double> rests) requires Scales_vertices<Metric> {
    check_vertex_factors(factors, t_.number_of_vertices());
    [[maybe_unused]] const typename Metric::Scope scope;
    metric_.set_factors(factors, rests);
    for (const typename Graph_traits::edge_descriptor e : edges(mesh_))
      metric_.scale(t_.index(e), t_.input_vertex(source(e, mesh_)),
                    t_.input_vertex(target(e, mesh_)));
  }

  // \param place on the input, if known; the weights approximate it
  Insertion insert(Halfedge h, const Weights& weights, const Wanted& place = {}) {
    return weights[2] == 0 ? insert_on_edge(h, weights, place) : insert_in_face(h, weights, place);
  }

  // Takes back what `insert()` of this object did last; observers follow.
  void undo_insertion(Halfedge h, const Weights& weights) {
    const bool is_on_edge = weights[2] == 0;
    if (is_on_edge && is_on_border(h)) {
      remove(h, Removal_from_border{star_on_border(h)}, false);
      return;
    }
    if (is_on_edge) undo_flip(h, *before_flip_);
    remove(h, Removal_from_face{star_of_vertex(h)}, false);
  }

  Move_status remove_from_face(Halfedge h) {
    return remove(h, Removal_from_face{star_of_vertex(h)}, true);
  }
  Move_status remove_from_border(Halfedge h) {
    return remove(h, Removal_from_border{star_on_border(h)}, true);
  }

private:
  // All are asked, in a fixed order, before any follows: a refused move changes nothing.
  template <class Move>
  bool ask(const Move& move) {
    const bool is_accepted = places_.before(t_, move); // both hear of moves that take others back
    return correspondence_.before(t_, move) && is_accepted;
  }
  template <class Insertion_move>
  bool ask_to_insert(Insertion_move& move) {
    if (!places_.before(t_, move)) return false;
    if constexpr (Defined_by_places<Metric>) {
      const auto* found = places_.coordinates(t_);
      if (&found->input() == &t_.input() && static_cast<const void*>(found) != &correspondence_)
        tell_place(*found, move);
    }
    return correspondence_.before(t_, move);
  }
  // data that a correspondence need not find itself
  template <class Coordinates, class Insertion_move>
  static void tell_place(const Coordinates& found, Insertion_move& move) {
    move.place = found.inserted_place();
    if constexpr (requires {
                    Triangulation::Correspondence::asks_for_directions;
                    move.seen;
                  })
      move.seen = found.inserted_direction();
  }
  template <class Move>
  void tell(const Move& move) {
    places_.after(t_, move);
    t_.exact_memory_.after(move);
    correspondence_.after(t_, move);
  }

  bool store_insertion(const Vertex_star& s, const Weights& weights) {
    if constexpr (Defined_by_places<Metric>)
      return metric_.insert_in_face(s, places_.inserted_values(t_)), true;
    else
      return metric_.insert_in_face(s, weights);
  }
  bool store_insertion(const Border_star& s, double parameter) {
    if constexpr (Defined_by_places<Metric>)
      return metric_.insert_in_border_edge(s, places_.inserted_values(t_)), true;
    else
      return metric_.insert_in_border_edge(s, parameter);
  }

  template <class Removal>
  Move_status remove(Halfedge h, const Removal& move, bool can_be_refused) {
    if (!ask(move) && can_be_refused) return Move_status::not_removable;
    t_.rows_.remove(move.vertex);
    if constexpr (std::is_same_v<Removal, Removal_from_face>) {
      metric_.remove_from_face(move.edges_and_faces());
      remove_degree_3_vertex(h, mesh_, number_);
    } else {
      metric_.remove_from_border_edge(move.edges_and_faces());
      remove_border_vertex(h, mesh_, number_);
    }
    tell(move);
    return Move_status::done;
  }

  Insertion insert_in_face(Halfedge h, const Weights& weights, const Wanted& place) {
    Insertion_in_face move{star_of_face(h), weights, place};
    if (!ask_to_insert(move)) return {Move_status::not_traceable};
    const Vertex v = split_face(h, mesh_, number_);
    static_cast<Star_of_vertex&>(move) = star_of_vertex(h);
    if (!store_insertion(move.edges_and_faces(), weights)) {
      remove_degree_3_vertex(h, mesh_, number_);
      return {Move_status::arithmetic};
    }
    t_.rows_.insert(move.vertex);
    tell(move);
    return {Move_status::done, v};
  }

  // Whether the edge that a vertex was inserted on, or within rounding of, can be flipped.
  bool is_convex(Halfedge h) const {
    if constexpr (Defined_by_places<Metric>) {
      const Diamond d = diamond_of(h, mesh_, number_);
      return metric_.is_degenerate(d.f) ||
             (t_.sign(d, Convexity_at_source_expression()) == POSITIVE &&
              t_.sign(d, Convexity_at_target_expression()) == POSITIVE);
    } else {
      return true;
    }
  }

  // inside: a vertex in the face, at distance zero from the edge, which is flipped away
  Insertion insert_on_edge(Halfedge h, const Weights& weights, const Wanted& place) {
    if (is_on_border(h)) return insert_on_border(h, weights[1], place);
    const Insertion n = insert_in_face(h, weights, place);
    if (n.status != Move_status::done) return n;
    before_flip_ = metric_.before_flip(diamond_of(h, mesh_, number_));
    const Move_status s = is_convex(h) ? flip(h) : Move_status::not_convex;
    if (s == Move_status::done) return n;
    remove(h, Removal_from_face{star_of_vertex(h)}, false);
    return {s};
  }

  Insertion insert_on_border(Halfedge h, double parameter, const Wanted& place) {
    Insertion_on_border move{star_of_border_edge(h), parameter, place};
    if (!ask_to_insert(move)) return {Move_status::not_traceable};
    const Vertex v = split_border_edge(h, mesh_, number_);
    static_cast<Star_on_border&>(move) = star_on_border(h);
    if (!store_insertion(move.edges_and_faces(), parameter)) {
      remove_border_vertex(h, mesh_, number_);
      return {Move_status::arithmetic};
    }
    t_.rows_.insert(move.vertex);
    tell(move);
    return {Move_status::done, v};
  }

  bool is_on_border(Halfedge h) const {
    return face(opposite(h, mesh_), mesh_) == Graph_traits::null_face();
  }
  std::uint32_t face_number(Halfedge h) const { return number_.face(face(h, mesh_)); }

  Triangulation& t_;
  Mesh& mesh_;
  Mesh_adaptor<Mesh>& number_;
  Metric& metric_;
  typename Triangulation::Correspondence& correspondence_;
  typename Triangulation::Places& places_;
  std::optional<typename Metric::Flipped> before_flip_; // of an edge with a new vertex on it
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_MOVER_H
