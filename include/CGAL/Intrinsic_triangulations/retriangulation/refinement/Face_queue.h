// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_FACE_QUEUE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_FACE_QUEUE_H

#include <cstddef>
#include <cstdint>
#include <queue>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief lets faces wait, named by numbers, that with the highest priority first; of equal priorities the
one that came first.

A face that changes is pushed again, or removed: its old entry is passed over then.
*/
class Face_queue {
public:
  /// pushes a face, whether it waits or not. \complexity logarithmic
  void push(std::uint32_t face, double priority);

  /// removes a face, if it waits.
  void remove(std::uint32_t face);

  /// tells whether no face waits.
  bool empty() const { return waiting_ == 0; }

  /// takes the first face out. \pre `!empty()`
  std::uint32_t pop();

  /// marks a face, and tells whether it was not marked.
  bool begin_check(std::uint32_t face);
  /// takes the mark away.
  void end_check(std::uint32_t face) { is_marked_[face] = 0; }

private:
  struct Entry {
    double priority;
    std::uint64_t ticket;
    std::uint32_t face;
    friend bool operator<(const Entry& a, const Entry& b) {
      return a.priority < b.priority || (a.priority == b.priority && a.ticket > b.ticket);
    }
  };

  void resize(std::uint32_t face);

  std::priority_queue<Entry> heap_;
  std::vector<std::uint64_t> ticket_; // of the entry that is valid; 0: the face does not wait
  std::vector<char> is_marked_;
  std::uint64_t tickets_ = 0;
  std::size_t waiting_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Face_queue_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_FACE_QUEUE_H
