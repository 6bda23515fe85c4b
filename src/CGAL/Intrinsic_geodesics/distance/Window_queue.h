// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_DISTANCE_WINDOW_QUEUE_H
#define CGAL_INTRINSIC_GEODESICS_DISTANCE_WINDOW_QUEUE_H

#include <CGAL/Intrinsic_geodesics/distance/Window.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*!
\brief is a queue of vertices and of sides with the windows that wait there, nearest first.

Windows of a side wait for each other, about 20 on meshes of 80,000 faces: they take one step of the
queue, and share what depends on the side.
*/
class Window_queue {
public:
  /// has no windows yet.
  explicit Window_queue(std::size_t sides) : sides_(sides) {}

  /// returns the least distance in the queue, infinity if it is empty.
  double least() const {
    return heap_.empty() ? std::numeric_limits<double>::infinity() : heap_.front().key;
  }
  /// returns whether nothing is left.
  bool is_empty() const { return heap_.empty(); }
  /// adds a vertex.
  void push_vertex(double key, std::uint32_t v) { push({key, v, true}); }
  /// adds a window to a side.
  void push_window(double key, std::uint32_t side, const Window& w) {
    std::uint32_t i = 0;
    if (free_.empty()) {
      i = static_cast<std::uint32_t>(pool_.size());
      pool_.emplace_back();
    } else {
      i = free_.back();
      free_.pop_back();
    }
    Waiting& s = sides_[side];
    pool_[i] = w;
    pool_[i].next = s.first;
    s.first = i;
    if (key < s.key) {
      s.key = key;
      push({key, side, false});
    }
  }
  /// takes the nearest. \return whether it is a vertex; else it is a side, whose windows follow
  bool pop(std::uint32_t& element) {
    const Entry e = heap_.front();
    std::pop_heap(heap_.begin(), heap_.end());
    heap_.pop_back();
    element = e.element;
    return e.is_vertex;
  }
  /// takes all windows of a side off it. \return the first, which has the next one; none if the side
  /// came before
  std::uint32_t take_windows(std::uint32_t side) {
    const std::uint32_t first = sides_[side].first;
    sides_[side] = {};
    return first;
  }
  /// returns a window, until the next one is added.
  Window& window(std::uint32_t i) { return pool_[i]; }
  /// takes back the memory of a window that was taken.
  void free(std::uint32_t i) { free_.push_back(i); }

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
  struct Waiting {
    double key = std::numeric_limits<double>::infinity(); // the least of the windows
    std::uint32_t first = Gluing::none;
  };

  void push(const Entry& e) {
    heap_.push_back(e);
    std::push_heap(heap_.begin(), heap_.end());
  }

  std::vector<Entry> heap_;
  std::vector<Waiting> sides_;
  std::vector<Window> pool_;
  std::vector<std::uint32_t> free_; // of the pool
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_DISTANCE_WINDOW_QUEUE_H
