// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_REMOVAL_QUEUE_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_REMOVAL_QUEUE_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// What it costs to remove a vertex; of equal costs, the vertex with the least number is first.
struct Removal_entry {
  double cost;
  std::uint32_t vertex;
  std::uint32_t number; // on the fine surface
  bool operator>(const Removal_entry& e) const {
    return cost != e.cost ? cost > e.cost : number > e.number;
  }
};

// The vertices that may be removed, the cheapest first: a heap. Unlike in `std::priority_queue`,
// the first entry can get another cost. Costs that are found again grow a little, so that the entry
// sinks a few levels only.
class Removal_queue {
public:
  bool empty() const { return heap_.empty(); }
  const Removal_entry& top() const { return heap_.front(); }
  // Entries from the top levels of the heap: those that are cheap.
  std::span<const Removal_entry> first(std::size_t most) const {
    return std::span(heap_).first(std::min(most, heap_.size()));
  }
  void push(const Removal_entry& e) {
    heap_.push_back(e);
    std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
  }
  void pop() {
    std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
    heap_.pop_back();
  }
  // Gives the first entry another cost. Returns whether it still is the first one.
  bool change_top(double cost) {
    const Removal_entry e{cost, heap_.front().vertex, heap_.front().number};
    std::size_t at = 0;
    for (std::size_t child = 1; child < heap_.size(); child = 2 * at + 1) {
      if (child + 1 < heap_.size() && heap_[child] > heap_[child + 1]) ++child;
      if (!(e > heap_[child])) break;
      heap_[at] = heap_[child];
      at = child;
    }
    heap_[at] = e;
    return at == 0;
  }

private:
  std::vector<Removal_entry> heap_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_REMOVAL_QUEUE_H
