// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_COMPACT_NUMBERS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_COMPACT_NUMBERS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>

#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Numbers some of the numbers below a bound anew, from 0 and in their order.
class Ranks {
public:
  explicit Ranks(std::uint32_t bound) : rank_(bound, Gluing::none) {}

  void add(std::uint32_t number) { rank_[number] = 0; }
  // to be called when all are added
  void finish() {
    for (std::uint32_t i = 0; i < rank_.size(); ++i)
      if (rank_[i] != Gluing::none) {
        rank_[i] = static_cast<std::uint32_t>(numbers_.size());
        numbers_.push_back(i);
      }
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
      : t_(t), vertex_(t.numbers().vertex_capacity(t.mesh())),
        edge_(t.numbers().edge_capacity(t.mesh())), face_(t.numbers().face_capacity(t.mesh())) {
    for (const typename Triangulation::vertex_descriptor v : vertices(t.mesh()))
      vertex_.add(t.index(v));
    for (const typename Triangulation::edge_descriptor e : edges(t.mesh())) edge_.add(t.index(e));
    for (const typename Triangulation::face_descriptor f : faces(t.mesh())) face_.add(t.index(f));
    vertex_.finish();
    edge_.finish();
    face_.finish();
  }

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
  const Triangulation& t_;
  Ranks vertex_, edge_, face_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_COMPACT_NUMBERS_H
