// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_BUILD_GLUING_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_BUILD_GLUING_IMPL_H

#include <CGAL/Intrinsic_triangulations/compilation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Halfedges_by_edge::Halfedges_by_edge(const Gluing& g)
    : start_(g.number_of_vertices + 1, 0) {
  const auto lower = [&](std::uint32_t h) {
    return std::min(g.origin[h], g.origin[Gluing::next(h)]);
  };
  const auto count = static_cast<std::uint32_t>(g.origin.size());
  for (std::uint32_t h = 0; h < count; ++h) ++start_[lower(h) + 1];
  for (std::size_t v = 1; v < start_.size(); ++v) start_[v] += start_[v - 1];
  entries_.resize(count);
  std::vector<std::uint32_t> fill(start_.begin(), start_.end() - 1);
  for (std::uint32_t h = 0; h < count; ++h)
    entries_[fill[lower(h)]++] = {std::max(g.origin[h], g.origin[Gluing::next(h)]), h};
  for (std::size_t v = 0; v + 1 < start_.size(); ++v)
    std::sort(begin(v), begin(v + 1), [](const Entry& a, const Entry& b) {
      return std::pair(a.upper, a.halfedge) < std::pair(b.upper, b.halfedge);
    });
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::string
edge_with_faces(const Gluing& g, Halfedges_by_edge::Iterator first,
                Halfedges_by_edge::Iterator last, const std::vector<std::uint32_t>& names) {
  std::string faces, diagonal;
  std::uint32_t before = Gluing::none;
  for (auto i = first; i != last; ++i) {
    const std::uint32_t name = face_name(i->halfedge / 3, names);
    faces += (i == first ? "" : ", ") + std::to_string(name);
    if (name == before) diagonal = ", a diagonal of face " + std::to_string(name) + ",";
    before = name;
  }
  return "edge (" + std::to_string(g.origin[first->halfedge]) + ", " +
         std::to_string(g.origin[Gluing::next(first->halfedge)]) + ")" + diagonal + " has " +
         std::to_string(last - first) + " faces (" + faces + ")";
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void
fail_nonmanifold(const Gluing& g, Halfedges_by_edge::Iterator first,
                 Halfedges_by_edge::Iterator last, const std::vector<std::uint32_t>& names) {
  throw Invalid_input(Element_kind::edge, first->halfedge,
                      edge_with_faces(g, first, last, names) +
                          "; remove faces or duplicate vertices so that at most two remain, or "
                          "take the tufted cover");
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Gluing
glue_triangles(Gluing g, std::uint32_t& conflict, const std::vector<std::uint32_t>& names) {
  Halfedges_by_edge sides(g);
  const auto refuse = [&](auto first, auto last) { fail_nonmanifold(g, first, last, names); };
  conflict = glue_pairs(g, sides, refuse).conflict;
  return g;
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_BUILD_GLUING_IMPL_H
