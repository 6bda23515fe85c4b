// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_DOUBLE_COVER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_DOUBLE_COVER_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The front and the back of each face of a gluing, as faces 2f and 2f + 1 of another one: the back of ijk is jik.
class Double_cover {
public:
  // A side of a face, and whether it runs along the edge or against it.
  struct Side {
    std::uint32_t halfedge;
    bool is_along;
  };

  // \param faces of which only the origins are read
  explicit Double_cover(const Gluing& faces) {
    cover_.number_of_vertices = faces.number_of_vertices;
    cover_.origin.resize(2 * faces.origin.size());
    cover_.glue.assign(2 * faces.origin.size(), Gluing::none);
    for (std::uint32_t h = 0; h < faces.origin.size(); ++h) {
      cover_.origin[front(h)] = faces.origin[h];
      cover_.origin[back(h)] = faces.origin[Gluing::next(h)];
    }
  }

  // the halfedge of the cover along a side, on the front of its face
  static std::uint32_t front(std::uint32_t h) { return 6 * (h / 3) + h % 3; }
  // the halfedge of the cover against a side, on the back of its face
  static std::uint32_t back(std::uint32_t h) { return 6 * (h / 3) + 3 + (3 - h % 3) % 3; }
  // the side that a halfedge of the cover lies at
  static std::uint32_t side(std::uint32_t h) {
    const std::uint32_t k = h % 3;
    return 3 * (h / 6) + (h % 6 < 3 ? k : (3 - k) % 3);
  }

  // Glues the faces at an edge (Algorithm 8 of the course): the copy of each that runs along the edge, to the copy of
  // the next one in the circle that runs against it.
  // \param fan random access range of `Side`, counterclockwise about the edge
  template <class Fan>
  void glue(const Fan& fan) {
    for (std::size_t i = 0; i < fan.size(); ++i) {
      const Side &here = fan[i], &next = fan[i + 1 < fan.size() ? i + 1 : 0];
      const std::uint32_t along = here.is_along ? front(here.halfedge) : back(here.halfedge);
      const std::uint32_t against = next.is_along ? back(next.halfedge) : front(next.halfedge);
      cover_.glue[along] = against;
      cover_.glue[against] = along;
    }
  }

  // Splits the vertices; see below.
  Gluing take(std::vector<std::uint32_t>& row_of_vertex);

private:
  Gluing cover_;
};

// Splits every vertex into one per umbrella, in the order of vertices; those without faces stay.
// \return the vertex that each new one is a copy of
inline std::vector<std::uint32_t> split_vertices(Gluing& g) {
  std::vector<std::uint32_t> umbrella(g.origin.size(), Gluing::none), row;
  for (std::uint32_t start = 0; start < g.origin.size(); ++start) {
    if (umbrella[start] != Gluing::none) continue;
    const auto number = static_cast<std::uint32_t>(row.size());
    row.push_back(g.origin[start]);
    std::uint32_t h = start; // counterclockwise
    while (h != Gluing::none && umbrella[h] == Gluing::none) {
      umbrella[h] = number;
      h = g.glue[Gluing::next(Gluing::next(h))];
    }
    if (h != Gluing::none) continue;
    for (h = g.glue[start]; h != Gluing::none; h = g.glue[Gluing::next(h)]) // and clockwise
      umbrella[Gluing::next(h)] = number;
  }
  std::vector<std::uint32_t> copies(g.number_of_vertices, 0), rows;
  for (const std::uint32_t v : row) ++copies[v];
  for (std::uint32_t v = 0; v < g.number_of_vertices; ++v) {
    const auto first = static_cast<std::uint32_t>(rows.size());
    rows.insert(rows.end(), copies[v] == 0 ? 1 : copies[v], v);
    copies[v] = first; // now: where the next copy goes
  }
  for (std::uint32_t& v : row) v = copies[v]++;
  for (std::size_t h = 0; h < g.origin.size(); ++h) g.origin[h] = row[umbrella[h]];
  g.number_of_vertices = static_cast<std::uint32_t>(rows.size());
  return rows;
}

inline Gluing Double_cover::take(std::vector<std::uint32_t>& row_of_vertex) {
  row_of_vertex = split_vertices(cover_);
  return std::move(cover_);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_DOUBLE_COVER_H
