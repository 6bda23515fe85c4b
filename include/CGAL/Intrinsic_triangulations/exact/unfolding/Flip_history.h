// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_FLIP_HISTORY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_FLIP_HISTORY_H

#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief remembers how every face came about, so that its geometry can be recomputed from the input in
any arithmetic.

A *version* of a face is an input face or one that a move made: version `v < F` is input face `v`,
versions `F + 2n` and `F + 2n + 1` are the left and right face of node `n`, mostly a flip. Each
version has its sides in slots 0, 1, 2; slot 0 of a flipped face is the new edge. A flip is a node of
eight bytes, the versions of the two faces that it consumed and the slots in which they had the flipped
edge. Everything else follows: lengths of the other sides are inherited. Insertions and removals of
vertices are kept in a table of their own (`Vertex_move`), to which nodes refer; one that makes three
faces takes two nodes. Nodes refer to smaller versions only, so that increasing order is an order of
evaluation and nothing is recursive.
*/
class Flip_history {
public:
  /// A slot of a version of a face.
  using Side = Face_side;

  /// An insertion or a removal of a vertex; see `Vertex_star`, `Border_star`.
  struct Vertex_move {
    /// What is done, and which versions it makes, from slot 0 on.
    enum class Kind : std::uint32_t {
      insert_in_face,         ///< ij of ijk: makes ijp, jkp, kip
      insert_in_border_edge,  ///< ij of ijk: makes ipk, pjk
      remove_from_face,       ///< ij of ijp, jk of jkp, ki of kip: makes ijk
      remove_from_border_edge ///< pk of kip, kp of pjk: makes ijk
    };
    Kind kind;                     ///< what is done
    std::uint32_t node;            ///< the first node
    std::array<Side, 3> parents;   ///< the sides consumed, as many as there are
    std::array<double, 3> weights; ///< where a vertex is inserted; on the border those of i and j
  };

  /// constructs the history of `number_of_faces` input faces and no moves.
  explicit Flip_history(std::uint32_t number_of_faces = 0) : faces_(number_of_faces) {}

  /// returns the number of input faces.
  std::uint32_t number_of_input_faces() const { return faces_; }
  /// returns the number of nodes.
  std::uint32_t number_of_nodes() const { return static_cast<std::uint32_t>(nodes_.size()); }
  /// returns the number of flips.
  std::uint32_t number_of_flips() const { return number_of_nodes() - vertex_nodes_; }
  /// returns the number of insertions and removals of vertices.
  std::size_t number_of_vertex_moves() const { return moves_.size(); }
  /// tells whether a version is an input face.
  bool is_input(std::uint32_t version) const { return version < faces_; }
  /// returns the flip that made a version. \pre a flip made it
  std::uint32_t flip_of(std::uint32_t version) const { return (version - faces_) / 2; }
  /// returns the node, the first if there are two, that made a version. \pre `!is_input(version)`
  std::uint32_t node_of(std::uint32_t version) const {
    const std::uint32_t n = flip_of(version);
    return is_flip(n) ? n : vertex_move(n).node;
  }
  /// tells whether a node is a flip.
  bool is_flip(std::uint32_t n) const { return (nodes_[n].second & 3U) != 3U; }
  /// returns the left version that node `n` made; the right one is the next.
  std::uint32_t left_version(std::uint32_t n) const { return faces_ + 2 * n; }
  /// returns the side that flip `n` consumed on the left.
  Side left_parent(std::uint32_t n) const { return unpack(nodes_[n].first); }
  /// returns the side that flip `n` consumed on the right.
  Side right_parent(std::uint32_t n) const { return unpack(nodes_[n].second); }
  /// returns the insertion or removal of a node. \pre `!is_flip(n)`
  const Vertex_move& vertex_move(std::uint32_t n) const { return moves_[nodes_[n].second >> 2]; }

  /// returns how many sides an insertion or a removal consumes.
  static std::size_t number_of_parents(Vertex_move::Kind kind) {
    if (kind == Vertex_move::Kind::remove_from_face) return 3;
    return kind == Vertex_move::Kind::remove_from_border_edge ? 2 : 1;
  }
  /// returns how many versions an insertion or a removal makes.
  static std::uint32_t number_of_versions(Vertex_move::Kind kind) {
    if (kind == Vertex_move::Kind::insert_in_face) return 3;
    return kind == Vertex_move::Kind::insert_in_border_edge ? 2 : 1;
  }

  /*!
  \brief records a flip of the edge between two sides.
  \return the version of the left face; that of the right face is the next number
  \throws std::length_error after about 5e8 flips, when versions no longer fit 30 bits
  */
  std::uint32_t record_flip(Side left, Side right) {
    const std::uint32_t version = new_version();
    nodes_.emplace_back(pack(left), pack(right));
    return version;
  }

  /*!
  \brief records an insertion or a removal of a vertex.
  \return the first version that it makes; others are the next numbers
  \throws std::length_error as for flips
  */
  std::uint32_t record_vertex_move(Vertex_move::Kind kind, const std::array<Side, 3>& parents,
                                   const std::array<double, 3>& weights = {}) {
    const std::uint32_t version = new_version();
    const auto reference = static_cast<std::uint32_t>(moves_.size() << 2) | 3U;
    moves_.push_back({kind, number_of_nodes(), parents, weights});
    const std::uint32_t nodes = kind == Vertex_move::Kind::insert_in_face ? 2 : 1;
    nodes_.insert(nodes_.end(), nodes, {0U, reference});
    vertex_nodes_ += nodes;
    return version;
  }

  /*!
  \brief finds where the length of a side was made: slot 0 of a flipped face, a side of another face
  that was made, or an input side.
  \complexity linear in the number of moves that the side went through as an outer edge
  */
  Side origin(Side s) const {
    while (!is_input(s.face)) {
      const std::uint32_t n = flip_of(s.face);
      if (!is_flip(n)) {
        const std::optional<Side> parent = inherited(vertex_move(n), s);
        if (!parent) return s;
        s = *parent;
        continue;
      }
      if (s.slot == 0) return s;
      const bool is_left = s.face == left_version(n);
      // left face: km, mj, jk; right face: mk, ki, im; see Flipped_values
      const bool from_right_parent = is_left == (s.slot == 1);
      const Side parent = from_right_parent ? right_parent(n) : left_parent(n);
      s = {parent.face, (parent.slot + (s.slot == 1 ? 2 : 1)) % 3};
    }
    return s;
  }

  /// returns the side from which a side of a face that a vertex move made has its length, or nothing if
  /// the move made that.
  std::optional<Side> inherited(const Vertex_move& m, Side s) const {
    using Kind = Vertex_move::Kind;
    const std::uint32_t k = s.face - left_version(m.node);
    switch (m.kind) {
    case Kind::insert_in_face:
      if (s.slot == 0) return after(m.parents[0], k);
      break;
    case Kind::insert_in_border_edge:
      if (s.slot == 2 - k) return after(m.parents[0], s.slot);
      break;
    case Kind::remove_from_face:
      return m.parents[s.slot];
    case Kind::remove_from_border_edge:
      if (s.slot == 1) return after(m.parents[1], 2);
      if (s.slot == 2) return after(m.parents[0], 1);
      break;
    }
    return std::nullopt;
  }

  /*!
  \brief tells which of the lengths that a vertex move made is that of a side, see `Vertex_move_values`.
  \pre `s` is an `origin()` in a face that a vertex move made
  */
  std::uint32_t made_length(Side s) const {
    const Vertex_move& m = vertex_move(flip_of(s.face));
    const std::uint32_t k = s.face - left_version(m.node);
    if (m.kind == Vertex_move::Kind::insert_in_face) return s.slot == 1 ? (k + 1) % 3 : k;
    if (m.kind == Vertex_move::Kind::insert_in_border_edge) return s.slot == 0 ? k : 2;
    return 0;
  }

  /// lists ancestors of two versions, see below
  template <class Is_known>
  std::vector<std::uint32_t> ancestors(std::uint32_t a, std::uint32_t b,
                                       const Is_known& is_known) const {
    return ancestors(std::vector<std::uint32_t>{a, b}, is_known);
  }

  /*!
  \brief lists nodes from which versions came about, in increasing order, which is an order of
  evaluation.
  \param versions the versions
  \param is_known a predicate on nodes; nodes that are known are left out, with their ancestors
  \complexity linear in the number of nodes listed, but for sorting; an explicit stack: nothing
  recurses, however deep the history
  */
  template <class Is_known>
  std::vector<std::uint32_t> ancestors(std::vector<std::uint32_t> versions,
                                       const Is_known& is_known) const {
    std::vector<std::uint32_t> order;
    std::vector<std::uint32_t>& stack = versions;
    std::unordered_set<std::uint32_t> seen;
    while (!stack.empty()) {
      const std::uint32_t v = stack.back();
      stack.pop_back();
      if (is_input(v)) continue;
      const std::uint32_t n = node_of(v);
      if (is_known(n) || !seen.insert(n).second) continue;
      order.push_back(n);
      if (is_flip(n)) {
        stack.push_back(left_parent(n).face);
        stack.push_back(right_parent(n).face);
      } else
        for (std::size_t k = 0; k < number_of_parents(vertex_move(n).kind); ++k)
          stack.push_back(vertex_move(n).parents[k].face);
    }
    std::sort(order.begin(), order.end());
    return order;
  }

private:
  static std::uint32_t pack(Side s) { return (s.face << 2) | s.slot; }
  static Side unpack(std::uint32_t x) { return {x >> 2, x & 3U}; }
  static Side after(Side s, std::uint32_t steps) { return {s.face, (s.slot + steps) % 3}; }

  // leaves room for the four versions of two nodes
  std::uint32_t new_version() const {
    const std::uint32_t version = left_version(number_of_nodes());
    if (version >= (1U << 30) - 4)
      throw std::length_error("the history of flips is full; rebuild from the input");
    return version;
  }

  std::uint32_t faces_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> nodes_; // slot 3 on the right: no flip
  std::vector<Vertex_move> moves_;
  std::uint32_t vertex_nodes_ = 0; // nodes that are no flips
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_FLIP_HISTORY_H
