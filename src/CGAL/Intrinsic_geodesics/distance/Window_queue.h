// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_DISTANCE_WINDOW_QUEUE_H
#define CGAL_INTRINSIC_GEODESICS_DISTANCE_WINDOW_QUEUE_H

#include <CGAL/Intrinsic_geodesics/distance/Window.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

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

  /// takes everything off. \complexity linear in what is left
  void clear() {
    for (const Entry& e : heap_)
      if (!e.is_vertex) sides_[e.element] = {};
    heap_.clear();
    pool_.clear();
    free_ = Gluing::none;
  }
  /// returns the number of bytes held.
  std::size_t bytes() const {
    return heap_.capacity() * sizeof(Entry) + sides_.capacity() * sizeof(Waiting) +
           pool_.capacity() * sizeof(Window);
  }
  /// returns the least distance in the queue, infinity if it is empty.
  double least() const {
    return heap_.empty() ? std::numeric_limits<double>::infinity() : heap_.front().key;
  }
  /// returns whether nothing is left.
  bool is_empty() const { return heap_.empty(); }
  /// adds a vertex.
  void push_vertex(double key, std::uint32_t v) { push({key, v, true}); }
  /// adds a window to a side. `squared` is the square of the least distance from its image.
  void push_window(double squared, std::uint32_t side, const Window& w) {
    std::uint32_t i = free_;
    if (i == Gluing::none) {
      i = static_cast<std::uint32_t>(pool_.size());
      pool_.emplace_back();
    } else {
      free_ = pool_[i].next;
    }
    Waiting& s = sides_[side];
    pool_[i] = w;
    pool_[i].next = s.first;
    s.first = i;
    const double gap = s.key - w.offset;
    if (gap > 0 && squared < gap * gap) { // rarely: most windows need no root
      s.key = w.offset + std::sqrt(squared);
      push({s.key, side, false});
    }
  }
  /// takes the nearest. \return whether it is a vertex; else it is a side, whose windows follow
  bool pop(std::uint32_t& element) {
    const Entry least = heap_.front(), last = heap_.back();
    heap_.pop_back();
    const std::size_t n = heap_.size();
    for (std::size_t i = 0; n != 0;) {
      const std::size_t begin = arity * i + 1, end = std::min(begin + arity, n);
      std::size_t child = begin;
      for (std::size_t k = begin + 1; k < end; ++k)
        if (heap_[k].key < heap_[child].key) child = k;
      if (begin >= n || heap_[child].key >= last.key) {
        heap_[i] = last;
        break;
      }
      heap_[i] = heap_[child];
      i = child;
    }
    element = least.element;
    return least.is_vertex;
  }
  /// takes all windows of a side off it. \return the first, which has the next one; none if the
  /// side came before
  std::uint32_t take_windows(std::uint32_t side) {
    const std::uint32_t first = sides_[side].first;
    sides_[side] = {};
    return first;
  }
  /// returns a window, until the next one is added.
  Window& window(std::uint32_t i) { return pool_[i]; }
  /// takes back the memory of a window that was taken.
  void free(std::uint32_t i) {
    pool_[i].next = free_;
    free_ = i;
  }

private:
  struct Entry {
    double key;
    std::uint32_t element;
    bool is_vertex;
  };
  static constexpr std::size_t arity = 4; // of the heap: fewer levels than two
  struct Waiting {
    double key = std::numeric_limits<double>::infinity(); // the least of the windows
    std::uint32_t first = Gluing::none;
  };

  void push(const Entry& e) {
    std::size_t i = heap_.size();
    heap_.push_back(e);
    for (; i > 0 && e.key < heap_[(i - 1) / arity].key; i = (i - 1) / arity)
      heap_[i] = heap_[(i - 1) / arity];
    heap_[i] = e;
  }

  std::vector<Entry> heap_;
  std::vector<Waiting> sides_;
  std::vector<Window> pool_;
  std::uint32_t free_ = Gluing::none; // the first of the pool, which has the next one
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_DISTANCE_WINDOW_QUEUE_H
