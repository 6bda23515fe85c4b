// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_STUDY_CYCLE_COUNTER_H
#define INTRINSIC_STUDY_CYCLE_COUNTER_H

#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Moves.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace program {

namespace IT = CGAL::Intrinsic_triangulations;

/*!
\brief keeps integer coordinates and counts flips that undo the last flip of the same edge.

A flip undoes the last one of its edge if no outer edge of the diamond was flipped in between: only
flips of outer edges change the diamond, and the last of these edges still is an outer edge.
*/
class Cycle_counter : public IT::Integer_coordinates {
public:
  template <class Triangulation>
  void start(const Triangulation& t) {
    IT::Integer_coordinates::start(t);
    last_flip_.assign(number_of_edges(), 0);
  }

  using IT::Integer_coordinates::after;

  template <class Triangulation>
  void after(const Triangulation& t, const IT::Flip& move) noexcept {
    IT::Integer_coordinates::after(t, move);
    std::uint64_t last_nearby = 0;
    for (const std::uint32_t side : {move.jk, move.ki, move.im, move.mj})
      last_nearby = std::max(last_nearby, last_flip_[side / 2]);
    if (last_flip_[move.ij / 2] > last_nearby) ++cycles_;
    last_flip_[move.ij / 2] = ++flips_;
  }

  /// returns how many flips undid another.
  std::uint64_t cycles() const { return cycles_; }

private:
  std::vector<std::uint64_t> last_flip_; // per edge, from 1; 0: never
  std::uint64_t flips_ = 0, cycles_ = 0;
};

} // namespace program

#endif // INTRINSIC_STUDY_CYCLE_COUNTER_H
