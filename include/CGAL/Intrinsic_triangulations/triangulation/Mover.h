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
#include <utility>

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

// What a flip replaces in a correspondence that rounds its data; nothing in others.
template <class Correspondence>
struct Rounded_by {
  struct Flipped {};
};
template <Remembers_rounded_flips Correspondence>
struct Rounded_by<Correspondence> {
  using Flipped = typename Correspondence::Flipped;
};

// What a flip replaces, from which it is taken back.
template <class Triangulation>
struct Before_flip {
  typename Triangulation::Metric::Flipped values;
  [[no_unique_address]]
  typename Rounded_by<typename Triangulation::Correspondence>::Flipped rounded;
};

// The elementary moves of a triangulation. Each is planned: it makes its record, asks all
// observers, which change nothing but caches, and computes the new values. Either may refuse. Then
// all make room for what is new. Until here exceptions, such as for memory that is exhausted, leave
// everything as it was. Then the move is made, where nothing fails: connectivity, metric and
// observers follow. So do moves that take others back.
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
    auto values = compute_values(move.diamond);
    if (!values) return Move_status::arithmetic;
    if (!ask(move)) return Move_status::crossings;
    make_room(move);
    make_flip(h, move, std::move(*values));
    return Move_status::done;
  }

  Before_flip<Triangulation> before_flip(Halfedge h) const {
    const Flip move = flip_record(h, mesh_, number_);
    if constexpr (Remembers_rounded_flips<typename Triangulation::Correspondence>)
      return {metric_.before_flip(move.diamond), t_.correspondence_.before_flip(move)};
    else
      return {metric_.before_flip(move.diamond), {}};
  }
  // Takes back the flip of h, the last one; observers follow.
  void undo_flip(Halfedge h, Before_flip<Triangulation>&& before) noexcept {
    Flip move = flip_record(h, mesh_, number_);
    move.km = move.ij ^ 1U;
    flip_edge_back(h, mesh_);
    metric_.store_flip(move.diamond, std::move(before.values));
    tell(move);
    if constexpr (Remembers_rounded_flips<typename Triangulation::Correspondence>)
      t_.correspondence_.store_flip(move, before.rounded);
  }

  // Not a move of the correspondence. A copy is scaled, since memory may be exhausted.
  void scale_vertices(std::span<const double> factors,
                      std::span<const double> rests) requires Scales_vertices<Metric> {
    check_vertex_factors(factors, t_.number_of_vertices());
    [[maybe_unused]] const typename Metric::Scope scope;
    Metric scaled = metric_;
    scaled.set_factors(factors, rests);
    for (const typename Graph_traits::edge_descriptor e : edges(mesh_))
      scaled.scale(t_.index(e), t_.input_vertex(source(e, mesh_)),
                   t_.input_vertex(target(e, mesh_)));
    metric_ = std::move(scaled);
  }

  // \param place on the input, if known; the weights approximate it
  Insertion insert_in_face(Halfedge h, const Weights& weights, const Wanted& place) {
    return insert(h, Insertion_in_face{star_of_face(h), weights, place}, weights);
  }
  // \param weights the last one is zero
  Insertion insert_on_border(Halfedge h, const Weights& weights, const Wanted& place) {
    return insert(h, Insertion_on_border{star_of_border_edge(h), weights[1], place}, weights[1]);
  }
  // the values of a side and its face, which an insertion there changes
  typename Metric::Flipped before_insertion(Halfedge h) const {
    return metric_.before_flip(without_vertex(star_of_face(h).edges_and_faces()));
  }
  // Takes back an insertion, the last move.
  void undo_insertion_in_face(Halfedge h, typename Metric::Flipped&& before) noexcept {
    make_removal(h, Removal_from_face{star_of_vertex(h)}, std::move(before));
  }
  void undo_insertion_on_border(Halfedge h, typename Metric::Flipped&& before) noexcept {
    make_removal(h, Removal_from_border{star_on_border(h)}, std::move(before));
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
      requires(Metric & m, const Whole_star& star) {
    m.store_star(star, *m.moved_values(star, 0., 0.));
  };
  // of the source of the first spoke; edges and faces stay
  bool move_in_star(const Whole_star& star, const Move_in_star& move) requires(moves_in_star) {
    if (!ask(move)) return false;
    auto values = metric_.moved_values(star, move.weights[1], move.weights[2]);
    if (!values) return false;
    make_room(move);
    [&]() noexcept {
      metric_.store_star(star, std::move(*values));
      tell(move);
    }();
    return true;
  }

private:
  // All are asked in their order; the first may complete the record of an insertion. They are
  // const: a refused move changes nothing.
  template <class Move>
  BOOST_FORCEINLINE bool ask(Move& move) const {
    return t_.with_observers(
        [&](const auto&... observers) { return (observers.before(t_, move) && ...); });
  }
  template <class Move>
  BOOST_FORCEINLINE void make_room(const Move& move) {
    t_.with_observers([&](auto&... observers) { (observers.make_room(t_, move), ...); });
    if constexpr (!std::is_same_v<Move, Flip> && !std::is_same_v<Move, Move_in_star>) {
      metric_.make_room(number_.edge_capacity(mesh_) + 3, number_.face_capacity(mesh_) + 2);
      number_.make_room(mesh_);
    }
  }
  template <class Move>
  BOOST_FORCEINLINE void tell(const Move& move) noexcept {
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

  template <class Move, class Where>
  Insertion insert(Halfedge h, Move move, const Where& where) {
    if (!ask(move)) return {Move_status::not_traceable};
    auto values = values_of_insertion(move.edges_and_faces(), where);
    if (!values) return {Move_status::arithmetic};
    make_room(move);
    return {Move_status::done, make_insertion(h, move, std::move(*values))};
  }
  template <class Removal>
  Move_status remove(Halfedge h, const Removal& move) {
    if (!ask(move)) return Move_status::not_removable;
    typename Metric::Flipped values = metric_.removed_values(move.edges_and_faces());
    make_room(move);
    make_removal(h, move, std::move(values));
    return Move_status::done;
  }

  // ---- nothing fails here

  BOOST_FORCEINLINE void make_flip(Halfedge h, const Flip& move,
                                   typename Metric::Flipped&& values) noexcept {
    CGAL::Euler::flip_edge(h, mesh_);
    metric_.store_flip(move.diamond, std::move(values));
    tell(move);
  }
  template <class Values>
  Vertex make_insertion(Halfedge h, Insertion_in_face& move, Values&& values) noexcept {
    const Vertex v = split_face(h, mesh_, number_);
    static_cast<Star_of_vertex&>(move) = star_of_vertex(h);
    metric_.insert_in_face(move.edges_and_faces(), std::move(values));
    tell(move);
    return v;
  }
  template <class Values>
  Vertex make_insertion(Halfedge h, Insertion_on_border& move, Values&& values) noexcept {
    const Vertex v = split_border_edge(h, mesh_, number_);
    static_cast<Star_on_border&>(move) = star_on_border(h);
    metric_.insert_in_border_edge(move.edges_and_faces(), std::move(values));
    tell(move);
    return v;
  }
  template <class Removal>
  void make_removal(Halfedge h, const Removal& move, typename Metric::Flipped&& values) noexcept {
    metric_.store_flip(without_vertex(move.edges_and_faces()), std::move(values));
    if constexpr (std::is_same_v<Removal, Removal_from_face>)
      remove_degree_3_vertex(h, mesh_, number_);
    else
      remove_border_vertex(h, mesh_, number_);
    tell(move);
  }

  std::uint32_t face_number(Halfedge h) const { return number_.face(face(h, mesh_)); }

  Triangulation& t_;
  Mesh& mesh_;
  Mesh_adaptor<Mesh>& number_;
  Metric& metric_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_MOVER_H
