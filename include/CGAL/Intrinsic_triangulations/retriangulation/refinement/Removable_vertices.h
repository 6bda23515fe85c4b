// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_REMOVABLE_VERTICES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_REMOVABLE_VERTICES_H

#include <CGAL/Intrinsic_triangulations/connectivity/for_each_outgoing.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The vertices, by number, that refinement may remove near a segment that is split: those that were inserted and lie on no
// segment.
class Removable_vertices {
public:
  // finds those that were inserted before, by a refinement that goes on or by the user
  template <class Triangulation, class Is_segment>
  void find(const Triangulation& t, const Is_segment& is_segment) {
    for (const typename Triangulation::vertex_descriptor v : vertices(t.mesh())) {
      if (!t.is_inserted(v)) continue;
      bool is_free = true;
      for_each_outgoing(v, t.mesh(), [&](typename Triangulation::halfedge_descriptor h) {
        is_free = is_free && !is_segment(h);
      });
      set(t.index(v), is_free);
    }
  }

  void set(std::uint32_t v, bool value) {
    if (v >= is_removable_.size()) is_removable_.resize(v + std::size_t{1}, 0);
    is_removable_[v] = value ? 1 : 0;
  }
  bool has(std::uint32_t v) const { return v < is_removable_.size() && is_removable_[v] != 0; }

private:
  std::vector<char> is_removable_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_REMOVABLE_VERTICES_H
