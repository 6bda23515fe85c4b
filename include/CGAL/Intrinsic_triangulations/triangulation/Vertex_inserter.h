// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_VERTEX_INSERTER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_VERTEX_INSERTER_H

#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Mover.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/metric_concepts.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <optional>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

// Inserts a vertex, which takes two moves on an inner edge, and takes it back at the end of its own
// life unless it is kept: so if a later move is refused, or memory is exhausted, no move is left.
template <class Triangulation>
class Vertex_inserter {
  using Halfedge = typename Triangulation::halfedge_descriptor;
  using Metric = typename Triangulation::Metric;

public:
  using Insertion = typename Triangulation::Insertion;

  explicit Vertex_inserter(Triangulation& t) : t_(t), mover_(t) {}
  Vertex_inserter(const Vertex_inserter&) = delete;
  Vertex_inserter& operator=(const Vertex_inserter&) = delete;
  ~Vertex_inserter() {
    if (edge_) mover_.undo_flip(h_, std::move(*edge_));
    if (face_)
      is_on_border_ ? mover_.undo_insertion_on_border(h_, std::move(*face_))
                    : mover_.undo_insertion_in_face(h_, std::move(*face_));
  }

  // Call it once.
  // \param weights on the edge of h if the last one is zero
  // \param place on the input, if known; the weights approximate it
  Insertion insert(Halfedge h, const std::array<double, 3>& weights,
                   const std::optional<Surface_point>& place) {
    h_ = h;
    is_on_border_ = weights[2] == 0 && is_border(opposite(h, t_.mesh()));
    typename Metric::Flipped before = mover_.before_insertion(h);
    const Insertion n = is_on_border_ ? mover_.insert_on_border(h, weights, place)
                                      : mover_.insert_in_face(h, weights, place);
    if (n.status != Move_status::done) return n;
    face_ = std::move(before);
    if (weights[2] != 0 || is_on_border_) return n;
    // the vertex is in the face, at distance zero from the edge, which is flipped away
    const Move_status s = flip_edge();
    return s == Move_status::done ? n : Insertion{s};
  }
  void keep() {
    edge_.reset();
    face_.reset();
  }

private:
  bool is_border(Halfedge h) const {
    return face(h, t_.mesh()) == boost::graph_traits<typename Triangulation::Mesh>::null_face();
  }

  Move_status flip_edge() {
    if (!is_convex()) return Move_status::not_convex;
    Before_flip<Triangulation> before = mover_.before_flip(h_);
    const Move_status s = mover_.flip(h_);
    if (s == Move_status::done) edge_ = std::move(before);
    return s;
  }
  // Whether the edge that the vertex was inserted on, or within rounding of, can be flipped.
  bool is_convex() const {
    if constexpr (Has_enclosures<Metric>) {
      const auto d = t_.diamond(h_);
      return t_.metric().is_degenerate(d.f) || t_.is_flippable(d);
    } else {
      return true;
    }
  }

  Triangulation& t_;
  Mover<Triangulation> mover_;
  Halfedge h_{};
  bool is_on_border_ = false;
  std::optional<typename Metric::Flipped> face_;   // before the insertion, unless that is kept
  std::optional<Before_flip<Triangulation>> edge_; // before the flip, unless that is kept
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_VERTEX_INSERTER_H
