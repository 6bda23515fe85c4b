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

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Sides_by_edge sides_by_edge(const Gluing& g) {
  struct Entry {
    std::uint32_t upper, halfedge;
  };
  const auto lower = [&](std::uint32_t h) {
    return std::min(g.origin[h], g.origin[Gluing::next(h)]);
  };
  // sorted by the lower end (counting sort), then by the upper one
  std::vector<std::uint32_t> start(g.number_of_vertices + 1, 0);
  const auto count = static_cast<std::uint32_t>(g.origin.size());
  for (std::uint32_t h = 0; h < count; ++h) ++start[lower(h) + 1];
  for (std::size_t v = 1; v < start.size(); ++v) start[v] += start[v - 1];
  std::vector<Entry> entries(count);
  std::vector<std::uint32_t> fill(start.begin(), start.end() - 1);
  for (std::uint32_t h = 0; h < count; ++h)
    entries[fill[lower(h)]++] = {std::max(g.origin[h], g.origin[Gluing::next(h)]), h};
  Sides_by_edge result;
  result.sides.reserve(count);
  result.first.reserve(count / 2 + 1);
  for (std::uint32_t v = 0; v < g.number_of_vertices; ++v) {
    std::sort(entries.begin() + start[v], entries.begin() + start[v + 1],
              [](const Entry& a, const Entry& b) {
                return std::pair(a.upper, a.halfedge) < std::pair(b.upper, b.halfedge);
              });
    for (std::uint32_t i = start[v]; i < start[v + 1]; ++i) {
      const std::uint32_t h = entries[i].halfedge;
      if (i == start[v] || entries[i].upper != entries[i - 1].upper) result.first.push_back(i);
      result.sides.push_back({h, g.origin[h] == v});
    }
  }
  result.first.push_back(count);
  return result;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::string
edge_with_faces(const Gluing& g, std::span<const Edge_side> sides,
                const std::vector<std::uint32_t>& names) {
  std::string faces, diagonal;
  std::uint32_t before = Gluing::none;
  for (const Edge_side& side : sides) {
    const std::uint32_t name = face_name(side.halfedge / 3, names);
    faces += (faces.empty() ? "" : ", ") + std::to_string(name);
    if (name == before) diagonal = ", a diagonal of face " + std::to_string(name) + ",";
    before = name;
  }
  const std::uint32_t h = sides[0].halfedge;
  return "edge (" + std::to_string(g.origin[h]) + ", " + std::to_string(g.origin[Gluing::next(h)]) +
         ")" + diagonal + " has " + std::to_string(sides.size()) + " faces (" + faces + ")";
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void
fail_nonmanifold(const Gluing& g, std::span<const Edge_side> sides,
                 const std::vector<std::uint32_t>& names) {
  throw Invalid_input(Element_kind::edge, sides[0].halfedge,
                      edge_with_faces(g, sides, names) +
                          "; remove faces or duplicate vertices so that at most two remain, or "
                          "take the tufted cover");
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Gluing
glue_triangles(Gluing g, std::uint32_t& conflict, const std::vector<std::uint32_t>& names) {
  const Sides_by_edge sides = sides_by_edge(g);
  const auto refuse = [&](std::uint32_t e) { fail_nonmanifold(g, sides[e], names); };
  conflict = glue_pairs(g, sides, refuse).conflict;
  return g;
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_BUILD_GLUING_IMPL_H
