// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_MOVER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_MOVER_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/connectivity/moves.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/metric/nearest_lengths.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Moves.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <CGAL/boost/graph/Euler_operations.h>

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

// The elementary moves of a triangulation. Each is planned: it makes its record, asks all
// observers, which change nothing but caches, and computes the new values. Either may refuse. Then
// it is made, and nothing is refused any more: connectivity, metric and observers follow. Moves
// that take others back are not refused.
template <class Triangulation>
class Mover {
  using Mesh = typename Triangulation::Mesh;
  using Graph_traits = boost::graph_traits<Mesh>;
  using Metric = typename Triangulation::Metric;
  using Halfedge = typename Graph_traits::halfedge_descriptor;
  using Weights = std::array<double, 3>;
  using Wanted = std::optional<Surface_point>;

public:
  using Insertion = typename Triangulation::Insertion;

  explicit Mover(Triangulation& t)
      : t_(t), mesh_(t.numbered_.mesh), number_(t.numbered_.numbers), metric_(t.metric_) {}

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
    ask(move, false);
    flip_edge_back(h, mesh_);
    metric_.store_flip(move.diamond, before);
    tell(move);
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
    if (weights[2] != 0) return insert_in_face(h, weights, place);
    if (!is_on_border(h)) return insert_on_edge(h, weights, place);
    return make(h, Insertion_on_border{star_of_border_edge(h), weights[1], place}, weights[1]);
  }

  // Takes back what `insert()` of this object did last.
  void undo_insertion(Halfedge h, const Weights& weights) {
    const bool is_on_edge = weights[2] == 0;
    if (is_on_edge && is_on_border(h)) return take_back(h, Removal_from_border{star_on_border(h)});
    if (is_on_edge) undo_flip(h, *before_flip_);
    take_back(h, Removal_from_face{star_of_vertex(h)});
  }

  Move_status remove_from_face(Halfedge h) {
    return remove(h, Removal_from_face{star_of_vertex(h)});
  }
  Move_status remove_from_border(Halfedge h) {
    return remove(h, Removal_from_border{star_on_border(h)});
  }

  // whether a vertex can move within its star
  static constexpr bool moves_in_star =
      RepositioningCorrespondence<typename Triangulation::Correspondence, Triangulation> &&
      requires(Metric & m, const Whole_star& star) { m.move_in_star(star, 0., 0.); };
  // of the source of the first spoke; edges and faces stay
  bool move_in_star(const Whole_star& star, const Move_in_star& move) requires(moves_in_star) {
    if (!ask(move) || !metric_.move_in_star(star, move.weights[1], move.weights[2])) return false;
    tell(move);
    return true;
  }

private:
  // All are asked in their order; the first may complete the record of an insertion. They are
  // const: a refused move changes nothing.
  template <class Move>
  BOOST_FORCEINLINE bool ask(Move& move, bool can_be_refused = true) const {
    return t_.with_observers([&](const auto&... observers) {
      return ((observers.before(t_, move) || !can_be_refused) && ...);
    });
  }
  template <class Move>
  BOOST_FORCEINLINE void tell(const Move& move) {
    t_.with_observers([&](auto&... observers) { (observers.after(t_, move), ...); });
  }

  // the values at a vertex whose insertion all have agreed to
  template <class Star, class Where>
  auto values_of_insertion(const Star& star, const Where& where) const {
    if constexpr (Has_enclosures<Metric>)
      return std::optional(t_.places_.inserted_values(t_));
    else
      return metric_.inserted_values(star, where);
  }

  Insertion insert_in_face(Halfedge h, const Weights& weights, const Wanted& place) {
    return make(h, Insertion_in_face{star_of_face(h), weights, place}, weights);
  }
  template <class Move, class Where>
  Insertion make(Halfedge h, Move move, const Where& where) {
    if (!ask(move)) return {Move_status::not_traceable};
    const auto values = values_of_insertion(move.edges_and_faces(), where);
    if (!values) return {Move_status::arithmetic};
    before_insertion_ = metric_.before_flip(side_and_face(h));
    Insertion result{Move_status::done};
    if constexpr (std::is_same_v<Move, Insertion_in_face>) {
      result.vertex = split_face(h, mesh_, number_);
      static_cast<Star_of_vertex&>(move) = star_of_vertex(h);
      metric_.insert_in_face(move.edges_and_faces(), *values);
    } else {
      result.vertex = split_border_edge(h, mesh_, number_);
      static_cast<Star_on_border&>(move) = star_on_border(h);
      metric_.insert_in_border_edge(move.edges_and_faces(), *values);
    }
    tell(move);
    return result;
  }

  template <class Removal>
  Move_status remove(Halfedge h, const Removal& move, bool can_be_refused = true) {
    if (!ask(move, can_be_refused)) return Move_status::not_removable;
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

  // the last insertion
  template <class Removal>
  void take_back(Halfedge h, const Removal& move) {
    remove(h, move, false);
    metric_.store_flip(side_and_face(h), *before_insertion_);
  }

  // what an insertion changes of a face, as if an edge between two were flipped
  Diamond side_and_face(Halfedge h) const {
    const std::uint32_t e = number_.halfedge(h) / 2, f = face_number(h);
    return {e, e, e, e, e, f, f};
  }

  // Whether the edge that a vertex was inserted on, or within rounding of, can be flipped.
  bool is_convex(Halfedge h) const {
    if constexpr (Has_enclosures<Metric>) {
      const Diamond d = diamond_of(h, mesh_, number_);
      return metric_.is_degenerate(d.f) || t_.is_flippable(d);
    } else {
      return true;
    }
  }

  // a vertex in the face, at distance zero from the edge, which is flipped away
  Insertion insert_on_edge(Halfedge h, const Weights& weights, const Wanted& place) {
    const Insertion n = insert_in_face(h, weights, place);
    if (n.status != Move_status::done) return n;
    before_flip_ = metric_.before_flip(diamond_of(h, mesh_, number_));
    const Move_status s = is_convex(h) ? flip(h) : Move_status::not_convex;
    if (s == Move_status::done) return n;
    take_back(h, Removal_from_face{star_of_vertex(h)});
    return {s};
  }

  bool is_on_border(Halfedge h) const {
    return face(opposite(h, mesh_), mesh_) == Graph_traits::null_face();
  }
  std::uint32_t face_number(Halfedge h) const { return number_.face(face(h, mesh_)); }

  Triangulation& t_;
  Mesh& mesh_;
  Mesh_adaptor<Mesh>& number_;
  Metric& metric_;
  // of the last insertion, to take it back: a side and its face, and the edge that the vertex is on
  std::optional<typename Metric::Flipped> before_insertion_, before_flip_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_MOVER_H
