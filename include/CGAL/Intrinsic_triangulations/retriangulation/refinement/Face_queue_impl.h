// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_FACE_QUEUE_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_FACE_QUEUE_IMPL_H

#include <CGAL/Intrinsic_triangulations/compilation.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Face_queue.h>

#include <cstddef>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations {

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void Face_queue::push(std::uint32_t face, double priority) {
  resize(face);
  if (ticket_[face] == 0) ++waiting_;
  ticket_[face] = ++tickets_;
  heap_.push({priority, tickets_, face});
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void Face_queue::remove(std::uint32_t face) {
  if (face >= ticket_.size() || ticket_[face] == 0) return;
  --waiting_;
  ticket_[face] = 0;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::uint32_t Face_queue::pop() {
  while (ticket_[heap_.top().face] != heap_.top().ticket) heap_.pop();
  const std::uint32_t face = heap_.top().face;
  heap_.pop();
  remove(face);
  return face;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE bool Face_queue::begin_check(std::uint32_t face) {
  resize(face);
  if (is_marked_[face]) return false;
  is_marked_[face] = 1;
  return true;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void Face_queue::resize(std::uint32_t face) {
  if (face < ticket_.size()) return;
  ticket_.resize(face + std::size_t{1}, 0);
  is_marked_.resize(face + std::size_t{1}, 0);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_FACE_QUEUE_IMPL_H
