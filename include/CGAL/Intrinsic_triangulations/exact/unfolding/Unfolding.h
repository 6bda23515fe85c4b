// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_UNFOLDING_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_UNFOLDING_H

#include <CGAL/Intrinsic_triangulations/exact/unfolding/Crossing_path.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flip_history.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Unfolded_diamond.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/unfold_corners.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief finds the input triangles over which the diamonds of a history lie; integers only.

A move is drawn in the plane of one input face, its *base*: that of its left, or first, parent. For each
side of a face it makes it keeps the *path* of crossings of input edges from the base to the plane in
which that side was made (an input face, or the base of the move that made it). The two sides of an edge
were made in one plane, or in two input faces glued along it; hence the paths of both sides give
the path from the base of the left parent to that of the right one. A vertex that is inserted is a
combination of the corners of the face, in the plane of its base.

What is found is remembered.
*/
class Unfolding {
public:
  /// A slot of a version of a face.
  using Side = Flip_history::Side;

  /// Longest path that is followed. Flips of a flat torus make paths whose length is exponential.
  static constexpr std::size_t maximal_path = 1000;

  /*!
  \brief finds input triangles that reach the corners of the diamond between two sides.
  \return the triangles, or nothing if a path is longer than `maximal_path`, or too many inserted
  vertices hang together
  \complexity linear in the number of ancestors not seen yet, times the length of paths
  */
  std::optional<Unfolded_diamond> diamond(const Flip_history& history, Side left, Side right) {
    develop_ancestors(history, left.face, right.face);
    if (is_too_long(history, left) || is_too_long(history, right)) return std::nullopt;
    const Corner k = start(history, last_side(left));
    Corner m = start(history, last_side(right));
    m.path = product(transition(history, left, right), m.path);
    return unfold({start(history, left), start(history, next_side(left)), k, m});
  }

  /*!
  \brief finds input triangles that reach the corners of a face, as a diamond whose corner m is i.
  \return the triangles, or nothing, see `diamond()`
  \complexity likewise
  */
  std::optional<Unfolded_diamond> face(const Flip_history& history, Side s) {
    develop_ancestors(history, s.face, s.face);
    if (is_too_long(history, s)) return std::nullopt;
    const Corner i = start(history, s);
    return unfold({i, start(history, next_side(s)), start(history, last_side(s)), i});
  }

  /// returns the number of moves that are remembered.
  std::size_t size() const { return flips_.size() + moves_.size(); }

private:
  using Path = Crossing_path;
  using Corner = Developed_corner;
  using Move = Flip_history::Vertex_move;

  struct Flip {
    std::uint32_t base; // none if a path is too long
    Path mj, jk, ki, im;
    Corner k, m;
  };

  struct Vertex_move {
    Developed_insertion
        vertex; // base none if a path is too long; corners of the face without the vertex
    std::array<Path, 3> paths; // of a face left by a removal
  };

  static constexpr std::uint32_t none = 0xffffffffU;

  void develop_ancestors(const Flip_history& history, std::uint32_t a, std::uint32_t b) {
    const auto is_known = [&](std::uint32_t n) {
      return history.is_flip(n) ? flips_.count(n) != 0 : moves_.count(n) != 0;
    };
    for (const std::uint32_t n : history.ancestors(a, b, is_known))
      if (history.is_flip(n))
        flips_.emplace(n, flip(history, history.left_parent(n), history.right_parent(n)));
      else
        moves_.emplace(n, vertex_move(history, n));
  }

  std::optional<Unfolded_diamond> unfold(std::array<Corner, 4> corners) const {
    for (Corner& c : corners) c.trim();
    while (internal::move_base(corners)) {
    }
    return unfold_corners(corners, [this](std::uint32_t n) -> const Developed_insertion& {
      return moves_.at(n).vertex;
    });
  }

  std::uint32_t base(const Flip_history& history, std::uint32_t version) const {
    if (history.is_input(version)) return version;
    const std::uint32_t n = history.node_of(version);
    return history.is_flip(n) ? flips_.at(n).base : moves_.at(n).vertex.base;
  }

  bool is_too_long(const Flip_history& history, Side s) const {
    return base(history, s.face) == none;
  }

  // from the base of the version of a side to the plane in which the side was made
  const Path& path(const Flip_history& history, Side s) const {
    static const Path identity;
    while (!history.is_input(s.face)) {
      const std::uint32_t n = history.node_of(s.face);
      if (history.is_flip(n)) return path(history, flips_.at(n), n, s);
      const Move& m = history.vertex_move(n);
      if (is_removal(m)) return moves_.at(n).paths[s.slot];
      const std::optional<Side> parent = history.inherited(m, s); // with the same base
      if (!parent) break;
      s = *parent;
    }
    return identity;
  }

  const Path& path(const Flip_history& history, const Flip& f, std::uint32_t n, Side s) const {
    static const Path identity;
    if (s.slot == 0) return identity;
    if (s.face == history.left_version(n)) return s.slot == 1 ? f.mj : f.jk;
    return s.slot == 1 ? f.ki : f.im;
  }

  // from the base of the left version to that of the right version
  Path transition(const Flip_history& history, Side left, Side right) const {
    Path result = path(history, left);
    const Side from = history.origin(left);
    if (history.is_input(from.face)) append(result, {from, history.origin(right)});
    return product_with_inverse(std::move(result), path(history, right));
  }

  // where a side starts, from the base of its version
  Corner start(const Flip_history& history, Side s) const {
    const Side o = history.origin(s);
    if (history.is_input(o.face)) return {path(history, s), o};
    const Corner c = start_where_made(history, o);
    return {product(path(history, s), c.path), c.side};
  }

  // where a side starts, from the base of the move that made it
  Corner start_where_made(const Flip_history& history, Side s) const {
    const std::uint32_t n = history.node_of(s.face);
    if (history.is_flip(n))
      return s.face == history.left_version(n) ? flips_.at(n).k : flips_.at(n).m;
    const std::array<Corner, 3>& corners = moves_.at(n).vertex.corners;
    const std::uint32_t k = s.face - history.left_version(n);
    const Corner inserted{{}, {n, Corner::inserted}};
    switch (history.vertex_move(n).kind) {
    case Move::Kind::insert_in_face: // ijp, jkp, kip
      return s.slot == 1 ? corners[(k + 1) % 3] : inserted;
    case Move::Kind::insert_in_border_edge: // ipk, pjk
      if (k == 0) return s.slot == 0 ? corners[0] : inserted;
      return s.slot == 0 ? inserted : corners[2];
    default: // the border edge ij
      return corners[0];
    }
  }

  Flip flip(const Flip_history& history, Side left, Side right) const {
    if (is_too_long(history, left) || is_too_long(history, right))
      return {none, {}, {}, {}, {}, {}, {}};
    const Path t = transition(history, left, right);
    Flip f{base(history, left.face),
           product(t, path(history, last_side(right))),
           path(history, next_side(left)),
           path(history, last_side(left)),
           product(t, path(history, next_side(right))),
           start(history, last_side(left)),
           start(history, last_side(right))};
    f.m.path = product(t, f.m.path);
    f.k.trim();
    f.m.trim();
    for (const Path* p : {&f.mj, &f.jk, &f.ki, &f.im, &f.k.path, &f.m.path})
      if (p->size() > maximal_path) return {none, {}, {}, {}, {}, {}, {}};
    return f;
  }

  static bool is_removal(const Move& m) {
    return m.kind == Move::Kind::remove_from_face || m.kind == Move::Kind::remove_from_border_edge;
  }

  Vertex_move vertex_move(const Flip_history& history, std::uint32_t n) const {
    const Move& m = history.vertex_move(n);
    Vertex_move result{{base(history, m.parents[0].face), {}, m.weights}, {}};
    bool is_long = result.vertex.base == none;
    if (m.kind == Move::Kind::remove_from_face)
      for (const Side s : {m.parents[1], m.parents[2]})
        is_long = is_long || is_too_long(history, s);
    if (m.kind == Move::Kind::remove_from_border_edge)
      is_long = is_long || is_too_long(history, m.parents[1]);
    if (!is_long) find_paths(history, m, result);
    for (std::size_t k = 0; k < 3; ++k)
      is_long = is_long || result.paths[k].size() > maximal_path ||
                result.vertex.corners[k].path.size() > maximal_path;
    if (is_long) return {{none, {}, {}}, {}};
    return result;
  }

  void find_paths(const Flip_history& history, const Move& m, Vertex_move& result) const {
    const auto& [first, second, third] = m.parents;
    std::array<Corner, 3>& corners = result.vertex.corners;
    switch (m.kind) {
    case Move::Kind::insert_in_face:
    case Move::Kind::insert_in_border_edge:
      corners = {start(history, first), start(history, next_side(first)),
                 start(history, last_side(first))};
      for (Corner& c : corners) c.trim();
      break;
    case Move::Kind::remove_from_face: { // ijp, jkp, kip
      const Path to_second = transition(history, next_side(first), last_side(second));
      const Path to_third = transition(history, last_side(first), next_side(third));
      result.paths = {path(history, first), product(to_second, path(history, second)),
                      product(to_third, path(history, third))};
      break;
    }
    case Move::Kind::remove_from_border_edge: { // pk of kip, kp of pjk
      const Path to_second = transition(history, first, second);
      result.paths = {Path{}, product(to_second, path(history, last_side(second))),
                      path(history, next_side(first))};
      corners[0] = start(history, last_side(first));
      corners[0].trim();
      break;
    }
    }
  }

  std::unordered_map<std::uint32_t, Flip> flips_;
  std::unordered_map<std::uint32_t, Vertex_move> moves_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_UNFOLDING_H
