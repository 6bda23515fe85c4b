// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

template Gluing unglued_triangles(std::uint32_t, const std::vector<std::array<std::uint32_t, 3>>&);

Sides_by_edge sides_by_edge(const Gluing& g) {
  const auto end = [&](std::uint32_t h) { return g.origin[Gluing::next(h)]; };
  const auto count = static_cast<std::uint32_t>(g.origin.size());
  // counting sort by the lower end: where sides of a vertex go next, and at last where they end
  std::vector<std::uint32_t> place(g.number_of_vertices + 1, 0);
  for (std::uint32_t h = 0; h < count; ++h) ++place[std::min(g.origin[h], end(h)) + 1];
  for (std::size_t v = 1; v < place.size(); ++v) place[v] += place[v - 1];
  // then by the upper one; keys: that, the halfedge (31 bits), whether it runs along the edge
  const auto keys = std::make_unique_for_overwrite<std::uint64_t[]>(count);
  for (std::uint32_t h = 0; h < count; ++h) {
    const auto [low, high] = std::minmax({g.origin[h], end(h)});
    keys[place[low]++] = std::uint64_t{high} << 32U | h << 1U | (low == g.origin[h] ? 1U : 0U);
  }
  Sides_by_edge result;
  result.sides.reserve(count);
  result.first.reserve(count / 2 + 1);
  for (std::uint32_t v = 0, i = 0; v < g.number_of_vertices; ++v) {
    std::sort(keys.get() + i, keys.get() + place[v]);
    for (const std::uint32_t begin = i; i < place[v]; ++i) {
      if (i == begin || keys[i] >> 32U != keys[i - 1] >> 32U) result.first.push_back(i);
      result.sides.push_back({static_cast<std::uint32_t>(keys[i]) >> 1U, (keys[i] & 1U) != 0});
    }
  }
  result.first.push_back(count);
  return result;
}

std::string edge_with_faces(const Gluing& g, std::span<const Edge_side> sides,
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

void fail_nonmanifold(const Gluing& g, std::span<const Edge_side> sides,
                      const std::vector<std::uint32_t>& names) {
  throw Invalid_input(Element_kind::edge, sides[0].halfedge,
                      edge_with_faces(g, sides, names) +
                          "; remove faces or duplicate vertices so that at most two remain, or "
                          "take the tufted cover with --domain tufted");
}

Gluing glue_triangles(Gluing g, std::uint32_t& conflict, const std::vector<std::uint32_t>& names) {
  const Sides_by_edge sides = sides_by_edge(g);
  const auto refuse = [&](std::uint32_t e) { fail_nonmanifold(g, sides[e], names); };
  conflict = glue_pairs(g, sides, refuse).conflict;
  return g;
}

} // namespace internal

template Gluing_map gluing_map_unless_polygonal(const Gluing_map&, std::uint32_t&);

} // namespace CGAL::Intrinsic_triangulations
