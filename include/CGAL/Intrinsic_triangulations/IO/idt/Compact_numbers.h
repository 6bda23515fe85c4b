// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_COMPACT_NUMBERS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_COMPACT_NUMBERS_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Numbers some numbers anew, from 0 and in their order.
class Ranks {
public:
  // those of the elements of a range
  template <class Range, class Number>
  Ranks(const Range& range, Number number) {
    for (const auto element : range) numbers_.push_back(number(element));
    std::sort(numbers_.begin(), numbers_.end());
    if (!numbers_.empty()) rank_.resize(numbers_.back() + std::size_t{1});
    for (std::uint32_t i = 0; i < numbers_.size(); ++i) rank_[numbers_[i]] = i;
  }

  std::uint32_t rank(std::uint32_t number) const { return rank_[number]; }
  std::uint32_t number(std::uint32_t rank) const { return numbers_[rank]; }
  std::uint32_t count() const { return static_cast<std::uint32_t>(numbers_.size()); }

private:
  std::vector<std::uint32_t> rank_, numbers_;
};

// The elements of a triangulation, numbered without the gaps that removals leave. Otherwise the order
// stays: vertices of the input come first. To be used like a `Mesh_adaptor`.
template <class Triangulation>
class Compact_numbers {
  using Mesh = typename Triangulation::Mesh;

public:
  explicit Compact_numbers(const Triangulation& t)
      : t_(t), vertex_(vertices(t.mesh()), number()), edge_(edges(t.mesh()), number()),
        face_(faces(t.mesh()), number()) {}

  const Ranks& vertex_ranks() const { return vertex_; }
  const Ranks& edge_ranks() const { return edge_; }
  const Ranks& face_ranks() const { return face_; }

  std::uint32_t vertex(typename Triangulation::vertex_descriptor v) const {
    return vertex_.rank(t_.index(v));
  }
  std::uint32_t halfedge(typename Triangulation::halfedge_descriptor h) const {
    const std::uint32_t i = t_.numbers().halfedge(h);
    return 2 * edge_.rank(i / 2) + i % 2;
  }
  std::uint32_t face(typename Triangulation::face_descriptor f) const {
    return face_.rank(t_.index(f));
  }

  std::uint32_t vertex_capacity(const Mesh&) const { return vertex_.count(); }
  std::uint32_t edge_capacity(const Mesh&) const { return edge_.count(); }
  std::uint32_t face_capacity(const Mesh&) const { return face_.count(); }

private:
  auto number() const {
    return [this](auto element) { return t_.index(element); };
  }

  const Triangulation& t_;
  Ranks vertex_, edge_, face_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_COMPACT_NUMBERS_H
