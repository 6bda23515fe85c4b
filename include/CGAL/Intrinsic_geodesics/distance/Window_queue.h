// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_DISTANCE_WINDOW_QUEUE_H
#define CGAL_INTRINSIC_GEODESICS_DISTANCE_WINDOW_QUEUE_H

#include <CGAL/Intrinsic_geodesics/distance/Window.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*!
\brief is what window propagation has still to look at: windows and vertices, nearest first.
*/
class Window_queue {
public:
  /// returns the least distance in the queue, infinity if it is empty.
  double least() const {
    return heap_.empty() ? std::numeric_limits<double>::infinity() : heap_.front().key;
  }
  /// tells whether nothing is left.
  bool is_empty() const { return heap_.empty(); }
  /// adds a vertex.
  void push_vertex(double key, std::uint32_t v) { push({key, v, true}); }
  /// adds a window.
  void push_window(double key, const Window& w) {
    std::uint32_t i = 0;
    if (free_.empty()) {
      i = static_cast<std::uint32_t>(pool_.size());
      pool_.push_back(w);
    } else {
      i = free_.back();
      free_.pop_back();
      pool_[i] = w;
    }
    push({key, i, false});
  }
  /// takes the nearest. \return whether it is a vertex, `v` then; else it is window `w`
  bool pop(std::uint32_t& v, Window& w) {
    const Entry e = heap_.front();
    std::pop_heap(heap_.begin(), heap_.end());
    heap_.pop_back();
    if (e.is_vertex) {
      v = e.element;
    } else {
      w = pool_[e.element];
      free_.push_back(e.element);
    }
    return e.is_vertex;
  }

private:
  struct Entry {
    double key;
    std::uint32_t element;
    bool is_vertex;
    // for a heap with the least key on top; windows before vertices, which they may still improve
    friend bool operator<(const Entry& a, const Entry& b) {
      return a.key > b.key || (a.key == b.key && a.is_vertex && !b.is_vertex);
    }
  };

  void push(const Entry& e) {
    heap_.push_back(e);
    std::push_heap(heap_.begin(), heap_.end());
  }

  std::vector<Entry> heap_;
  std::vector<Window> pool_;
  std::vector<std::uint32_t> free_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_DISTANCE_WINDOW_QUEUE_H
