// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_FLIP_HISTORY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_FLIP_HISTORY_H

#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief remembers the flips by which every face came about, so that its geometry can be recomputed from the
input in any arithmetic.

A *version* of a face is an input face or one that a flip made: version `v < F` is input face `v`,
versions `F + 2n` and `F + 2n + 1` are the left and right face of flip `n`. Each version has its sides in
slots 0, 1, 2; slot 0 of a flipped face is the new edge. A flip is a node of eight bytes, the versions of the
two faces that it consumed and the slots in which they had the flipped edge. Everything else follows: lengths
of the other sides are inherited. Nodes refer to smaller versions only, so that increasing order is an order
of evaluation and nothing is recursive.
*/
class Flip_history {
public:
  /// A slot of a version of a face.
  using Side = Face_side;

  /// constructs the history of `number_of_faces` input faces and no flips.
  explicit Flip_history(std::uint32_t number_of_faces = 0) : faces_(number_of_faces) {}

  /// returns the number of flips.
  std::uint32_t number_of_flips() const { return static_cast<std::uint32_t>(flips_.size()); }
  /// tells whether a version is an input face.
  bool is_input(std::uint32_t version) const { return version < faces_; }
  /// returns the flip that made a version. \pre `!is_input(version)`
  std::uint32_t flip_of(std::uint32_t version) const { return (version - faces_) / 2; }
  /// returns the left version that flip `n` made; the right one is the next.
  std::uint32_t left_version(std::uint32_t n) const { return faces_ + 2 * n; }
  /// returns the side that flip `n` consumed on the left.
  Side left_parent(std::uint32_t n) const { return unpack(flips_[n].first); }
  /// returns the side that flip `n` consumed on the right.
  Side right_parent(std::uint32_t n) const { return unpack(flips_[n].second); }

  /*!
  \brief records a flip of the edge between two sides.
  \return the version of the left face; that of the right face is the next number
  \throws std::length_error after about 5e8 flips, when versions no longer fit 30 bits
  */
  std::uint32_t record_flip(Side left, Side right) {
    const std::uint32_t version = left_version(number_of_flips());
    if (version >= (1U << 30) - 2)
      throw std::length_error("the history of flips is full; rebuild from the input");
    flips_.emplace_back(pack(left), pack(right));
    return version;
  }

  /// forgets the last flip. \pre no face has a version that it made
  void forget_flip() { flips_.pop_back(); }

  /*!
  \brief finds where the length of a side was made: slot 0 of a flipped face, or an input side.
  \complexity linear in the number of flips that the side went through as an outer edge
  */
  Side origin(Side s) const {
    while (!is_input(s.face) && s.slot != 0) {
      const std::uint32_t n = flip_of(s.face);
      const bool is_left = s.face == left_version(n);
      // left face: km, mj, jk; right face: mk, ki, im; see Flipped_values
      const bool from_right_parent = is_left == (s.slot == 1);
      const Side parent = from_right_parent ? right_parent(n) : left_parent(n);
      s = {parent.face, (parent.slot + (s.slot == 1 ? 2 : 1)) % 3};
    }
    return s;
  }

  /// lists ancestors of two versions, see below
  template <class Is_known>
  std::vector<std::uint32_t> ancestors(std::uint32_t a, std::uint32_t b,
                                       const Is_known& is_known) const {
    return ancestors(std::vector<std::uint32_t>{a, b}, is_known);
  }

  /*!
  \brief lists flips from which versions came about, in increasing order, which is an order of
  evaluation.
  \param versions the versions
  \param is_known a predicate on flips; those that are known are left out, with their ancestors
  \param most how many are wanted at most: when there are more, one more is listed, in no order of use
  \complexity linear in the number of flips listed, but for sorting; an explicit stack: nothing
  recurses, however deep the history
  */
  template <class Is_known>
  std::vector<std::uint32_t>
  ancestors(std::vector<std::uint32_t> versions, const Is_known& is_known,
            std::size_t most = std::numeric_limits<std::size_t>::max()) const {
    std::vector<std::uint32_t> order;
    std::vector<std::uint32_t>& stack = versions;
    std::unordered_set<std::uint32_t> seen; // the same flips as `order`, once these are many
    const auto is_new = [&](std::uint32_t n) {
      constexpr std::size_t few = 48;
      if (order.size() < few) return std::find(order.begin(), order.end(), n) == order.end();
      if (seen.empty()) seen.insert(order.begin(), order.end());
      return seen.insert(n).second;
    };
    while (!stack.empty() && order.size() <= most) {
      const std::uint32_t v = stack.back();
      stack.pop_back();
      if (is_input(v)) continue;
      const std::uint32_t n = flip_of(v);
      if (is_known(n) || !is_new(n)) continue;
      order.push_back(n);
      stack.push_back(left_parent(n).face);
      stack.push_back(right_parent(n).face);
    }
    std::sort(order.begin(), order.end());
    return order;
  }

private:
  static std::uint32_t pack(Side s) { return (s.face << 2) | s.slot; }
  static Side unpack(std::uint32_t x) { return {x >> 2, x & 3U}; }

  std::uint32_t faces_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> flips_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_FLIP_HISTORY_H
