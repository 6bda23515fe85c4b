// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_PAGE_SURFACE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_PAGE_SURFACE_H

#include <CGAL/Intrinsic_triangulations/IO/view/drawn_geometry.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The part of a common subdivision that a page shows. Corners and ends are numbers in `vertices`.
struct Page_surface {
  std::vector<std::uint32_t> vertices; // of the subdivision
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> polygon; // the face of the subdivision with each triangle
  Drawn_edges input, intrinsic;
  // The side of the cells in which vertices were merged, in units of the radius; 0: none were.
  double cell = 0;

  // Gives each triangle corners of its own, three after three at the end of the vertices, so that
  // it can have values that its neighbours have not.
  void separate_triangles() {
    for (std::array<std::uint32_t, 3>& corners : triangles)
      for (std::uint32_t& corner : corners) {
        vertices.push_back(vertices[corner]);
        corner = static_cast<std::uint32_t>(vertices.size() - 1);
      }
  }

  // The number of bytes in the page. \param per_vertex what fields and places need at each
  std::size_t bytes(std::size_t per_vertex) const {
    const auto bytes_of = [](const Drawn_edges& e) { return 12 * e.room.size() + e.sheets.size(); };
    return (21 + per_vertex) * vertices.size() + 24 * triangles.size() + bytes_of(input) +
           bytes_of(intrinsic);
  }
};

// All of it, with a fan for each convex polygon.
inline Page_surface whole_surface(const Common_subdivision& s,
                                  std::span<const std::array<float, 3>> points) {
  Page_surface all;
  all.vertices.resize(s.number_of_vertices());
  std::iota(all.vertices.begin(), all.vertices.end(), 0U);
  for (std::size_t f = 0; f < s.number_of_faces(); ++f)
    for (std::size_t k = 2; k < s.face(f).size(); ++k) {
      all.triangles.push_back({s.face(f)[0], s.face(f)[k - 1], s.face(f)[k]});
      all.polygon.push_back(static_cast<std::uint32_t>(f));
    }
  all.input = drawn_edges(s, points, &Common_subdivision::Side::input_edge, s.input_face);
  all.intrinsic =
      drawn_edges(s, points, &Common_subdivision::Side::intrinsic_edge, s.intrinsic_face);
  return all;
}

// For each point the first one in the same cell of a grid over the ball of radius 1.
inline std::vector<std::uint32_t>
first_points_in_cells(std::span<const std::array<float, 3>> points, double cell) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> by_cell;
  for (const std::array<float, 3>& p : points) {
    std::uint64_t key = 0;
    for (const float x : p) // from -1 to 1, up to rounding
      key = key << 21 | static_cast<std::uint64_t>(std::isfinite(x) ? (double{x} + 1.5) / cell : 0);
    by_cell.emplace_back(key, static_cast<std::uint32_t>(by_cell.size()));
  }
  std::ranges::sort(by_cell);
  std::vector<std::uint32_t> first(points.size());
  for (std::size_t i = 0, begin = 0; i < by_cell.size(); ++i) {
    if (by_cell[i].first != by_cell[begin].first) begin = i;
    first[by_cell[i].second] = by_cell[begin].second;
  }
  return first;
}

// The edges whose ends differ after vertices were merged, each once.
inline Drawn_edges merged_edges(const Drawn_edges& edges, std::span<const std::uint32_t> place) {
  std::vector<std::pair<std::uint64_t, std::size_t>> order;
  for (std::size_t i = 0; i < edges.edge.size(); ++i) {
    const auto [a, b] = std::minmax(place[edges.ends[2 * i]], place[edges.ends[2 * i + 1]]);
    if (a != b) order.emplace_back(std::uint64_t{a} << 32 | b, i);
  }
  std::ranges::sort(order);
  Drawn_edges result;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const auto [ends, i] = order[k];
    if (k > 0 && order[k - 1].first == ends) {
      result.room.back() = std::max(result.room.back(), edges.room[i]);
      if (!edges.sheets.empty()) result.sheets.back() |= edges.sheets[i];
      continue;
    }
    result.ends.insert(result.ends.end(), {static_cast<std::uint32_t>(ends >> 32),
                                           static_cast<std::uint32_t>(ends & 0xffffffffU)});
    result.edge.push_back(edges.edge[i]);
    result.room.push_back(edges.room[i]);
    if (!edges.sheets.empty()) result.sheets.push_back(edges.sheets[i]);
  }
  return result;
}

// The surface with one vertex for all in a cell of a grid, so that small triangles vanish.
inline Page_surface merged_surface(const Page_surface& all,
                                   std::span<const std::array<float, 3>> points, double cell) {
  const std::vector<std::uint32_t> first = first_points_in_cells(points, cell);
  Page_surface result;
  result.cell = cell;
  std::vector<std::uint32_t> place(first.size());
  for (std::uint32_t v = 0; v < first.size(); ++v) {
    if (first[v] == v) {
      place[v] = static_cast<std::uint32_t>(result.vertices.size());
      result.vertices.push_back(v);
    } else {
      place[v] = place[first[v]]; // which comes before
    }
  }
  for (std::size_t t = 0; t < all.triangles.size(); ++t) {
    const auto [a, b, c] = all.triangles[t];
    const std::array<std::uint32_t, 3> corners{place[a], place[b], place[c]};
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    result.triangles.push_back(corners);
    result.polygon.push_back(all.polygon[t]);
  }
  result.input = merged_edges(all.input, place);
  result.intrinsic = merged_edges(all.intrinsic, place);
  return result;
}

// The surface; if it needs too many bytes, with vertices merged in cells that are little larger
// than they must be.
inline Page_surface surface_within(Page_surface all, std::span<const std::array<float, 3>> points,
                                   std::size_t per_vertex, std::size_t most_bytes) {
  if (all.bytes(per_vertex) <= most_bytes) return all;
  Page_surface merged;
  double cell = 1. / 1024;
  do {
    merged = merged_surface(all, points, cell);
    const double excess =
        static_cast<double>(merged.bytes(per_vertex)) / static_cast<double>(most_bytes);
    cell *= std::clamp(std::sqrt(excess), 1.03, 2.); // cells on a surface: squares
  } while (merged.bytes(per_vertex) > most_bytes && cell < 4);
  return merged;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_PAGE_SURFACE_H
