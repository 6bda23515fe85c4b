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

A flip is drawn in the plane of one input face, its *base*: that of its left parent. For each side of a
face it makes it keeps the *path* of crossings of input edges from the base to the plane in which that side
was made (an input face, or the base of the flip that made it). The two sides of an edge were made in one
plane, or in two input faces glued along it; hence the paths of both sides give the path from the base of the
left parent to that of the right one.

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
  \return the triangles, or nothing if a path is longer than `maximal_path`, or thousands are needed
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

  /// returns the number of flips that are remembered.
  std::size_t size() const { return flips_.size(); }

private:
  using Path = Crossing_path;
  using Corner = Developed_corner;

  struct Flip {
    std::uint32_t base; // none if a path is too long
    Path mj, jk, ki, im;
    Corner k, m;
  };

  static constexpr std::uint32_t none = 0xffffffffU;

  void develop_ancestors(const Flip_history& history, std::uint32_t a, std::uint32_t b) {
    const auto is_known = [this](std::uint32_t n) { return flips_.count(n) != 0; };
    for (const std::uint32_t n : history.ancestors(a, b, is_known))
      flips_.emplace(n, flip(history, history.left_parent(n), history.right_parent(n)));
  }

  std::optional<Unfolded_diamond> unfold(std::array<Corner, 4> corners) const {
    for (Corner& c : corners) c.trim();
    while (internal::move_base(corners)) {
    }
    return unfold_corners(corners);
  }

  std::uint32_t base(const Flip_history& history, std::uint32_t version) const {
    return history.is_input(version) ? version : flips_.at(history.flip_of(version)).base;
  }

  bool is_too_long(const Flip_history& history, Side s) const {
    return base(history, s.face) == none;
  }

  // from the base of the version of a side to the plane in which the side was made
  const Path& path(const Flip_history& history, Side s) const {
    static const Path identity;
    if (history.is_input(s.face) || s.slot == 0) return identity;
    const std::uint32_t n = history.flip_of(s.face);
    const Flip& f = flips_.at(n);
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
    const std::uint32_t n = history.flip_of(o.face);
    const Corner& c = o.face == history.left_version(n) ? flips_.at(n).k : flips_.at(n).m;
    return {product(path(history, s), c.path), c.side};
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

  std::unordered_map<std::uint32_t, Flip> flips_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_UNFOLDING_H
