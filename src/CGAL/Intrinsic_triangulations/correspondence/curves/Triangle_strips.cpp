// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/correspondence/curves/Crossing_run.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Triangle_strips.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>

#include <algorithm>
#include <cstdint>
#include <span>

namespace CGAL::Intrinsic_triangulations {

void Triangle_strips::enter(const Input& input, const Vertex_fans& fans, std::uint32_t parent,
                            std::span<const Crossing_run> entered) {
  fans_ = &fans;
  if (entered.empty()) return;
  if (parent != last()) {
    branch_ = size_;
    branches_from_ = parent;
  }
  Triangle last{side(parent), points(parent)};
  for (const Crossing_run& run : entered) {
    add(input, last, run.first());
    const std::uint32_t count = run.count();
    if (count > long_turn)
      add_turn(last, run.part(fans, 1, count));
    else
      for (std::uint32_t i = 1; i < count; ++i) add(input, last, run(fans, i));
  }
}

void Triangle_strips::add(const Input& input, Triangle& last, std::uint32_t halfedge) {
  const std::uint32_t exit = halfedge ^ 1U, apex = size_ + 2;
  const auto [a, b, c] = last.points;
  Points points{a, c, apex};
  if (exit == input.next(last.side))
    points = {c, b, apex};
  else if (exit == last.side)
    points = {b, a, apex};
  last = {halfedge, points};
  triangles_.push_back(last);
  ++size_;
}

void Triangle_strips::add_turn(Triangle& last, const Crossing_run& rest) {
  const unsigned end = rest.is_clockwise() ? 1 : 0;
  const std::uint32_t before = turns_.empty() ? 0 : turns_.back().skipped, count = rest.count();
  turns_.push_back({size_, size_ + count, before + count, rest.first(), last.points[end], end});
  size_ += count;
  last = {rest(*fans_, count - 1), points(size_ - 1)};
}

const Triangle_strips::Turn& Triangle_strips::turn_at(std::uint32_t n) const {
  return *(std::upper_bound(turns_.begin(), turns_.end(), n,
                            [](std::uint32_t m, const Turn& t) { return m < t.first; }) -
           1);
}

unsigned Triangle_strips::exit_to(std::uint32_t child) const {
  const Points of_parent = points(parent(child)), entered = points(child);
  unsigned exit = 0;
  while (exit < 2 && of_parent[exit] != entered[1]) ++exit;
  return exit;
}

std::uint32_t Triangle_strips::entered_over(std::uint32_t n, unsigned side) const {
  if (n > 0 && side == 0) return parent(n);
  for (const std::uint32_t child : {n + 1, branch_})
    if (child < size_ && parent(child) == n && exit_to(child) == side) return child;
  return none;
}

std::uint32_t Triangle_strips::end_of_turn(std::uint32_t n, unsigned end) const {
  const std::uint32_t pivot = points(n)[end];
  std::uint32_t next = n + 1;
  while (next < size_ && next != branch_) {
    if (!is_stored(next)) {
      const Turn& t = turn_at(next);
      if (next < t.end) {
        if (t.pivot_end != end || t.pivot != pivot) break;
        next = t.end;
        continue;
      }
    }
    if (points(next)[end] != pivot) break;
    ++next;
  }
  return next;
}

} // namespace CGAL::Intrinsic_triangulations
