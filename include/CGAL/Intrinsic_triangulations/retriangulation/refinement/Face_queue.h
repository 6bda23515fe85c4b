// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_FACE_QUEUE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_FACE_QUEUE_H

#include <cstddef>
#include <cstdint>
#include <queue>
#include <utility>
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
  void push(std::uint32_t face, double priority) {
    resize(face);
    if (ticket_[face] == 0) ++waiting_;
    ticket_[face] = ++tickets_;
    heap_.push({priority, tickets_, face});
  }

  /// removes a face, if it waits.
  void remove(std::uint32_t face) {
    if (face >= ticket_.size() || ticket_[face] == 0) return;
    --waiting_;
    ticket_[face] = 0;
  }

  /// tells whether no face waits.
  bool empty() const { return waiting_ == 0; }

  /// takes the first face out. \pre `!empty()`
  std::uint32_t pop() {
    while (ticket_[heap_.top().face] != heap_.top().ticket) heap_.pop();
    const std::uint32_t face = heap_.top().face;
    heap_.pop();
    remove(face);
    return face;
  }

  /// marks a face, and tells whether it was not marked.
  bool begin_check(std::uint32_t face) {
    resize(face);
    return !std::exchange(is_marked_[face], 1);
  }
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

  void resize(std::uint32_t face) {
    if (face < ticket_.size()) return;
    ticket_.resize(face + std::size_t{1}, 0);
    is_marked_.resize(face + std::size_t{1}, 0);
  }

  std::priority_queue<Entry> heap_;
  std::vector<std::uint64_t> ticket_; // of the entry that is valid; 0: the face does not wait
  std::vector<char> is_marked_;
  std::uint64_t tickets_ = 0;
  std::size_t waiting_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_FACE_QUEUE_H
