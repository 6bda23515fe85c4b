// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_TUFTED_COVER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_TUFTED_COVER_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Sorts points counterclockwise about the line from `a` to `b`, starting in the half plane of one
// of them; decided exactly. Points in one half plane keep their order, and so do those on the line,
// which come last.
// \param apices numbers of the points, from 0 in `points`
// \return places in `apices`, in the new order
// \pre coordinates are finite
std::vector<std::uint32_t> sort_around_edge(const std::vector<std::array<double, 3>>& points,
                                            std::uint32_t a, std::uint32_t b,
                                            const std::vector<std::uint32_t>& apices);

// The front and the back of each face of a gluing, as faces 2f and 2f + 1 of another one: the back
// of ijk is jik.
class Double_cover {
public:
  // \param faces only its origins are read
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

  // Glues the faces at an edge (Algorithm 8 of the course): the copy of each that runs along the
  // edge, to the copy of the next one in the circle that runs against it.
  // \param fan counterclockwise about the edge
  void glue(std::span<const Edge_side> fan) {
    for (std::size_t i = 0; i < fan.size(); ++i) {
      const Edge_side &here = fan[i], &next = fan[i + 1 < fan.size() ? i + 1 : 0];
      const std::uint32_t along = here.is_along ? front(here.halfedge) : back(here.halfedge);
      const std::uint32_t against = next.is_along ? back(next.halfedge) : front(next.halfedge);
      cover_.glue[along] = against;
      cover_.glue[against] = along;
    }
  }

  // A corner of a face: its angle, and the length of the opposite side.
  struct Corner {
    double angle, opposite;
  };

  // Splits every vertex into copies, one per umbrella, in the order of vertices; those without
  // faces stay. The first copy is the one with the largest angle, and the longest sides opposite
  // to it: vectors at the vertex are in its tangent plane, in whichever order faces are given.
  // \param corners of the faces, at the source of each side
  Gluing take(std::vector<std::uint32_t>& row_of_vertex, const std::vector<Corner>& corners);

private:
  std::vector<std::uint32_t> number_umbrellas(std::vector<std::uint32_t>& umbrella) const;
  std::vector<std::uint32_t> order_umbrellas(const std::vector<std::uint32_t>& row,
                                             const std::vector<std::uint32_t>& umbrella,
                                             const std::vector<Corner>& corners) const;

  Gluing cover_;
};

// The tufted cover of triangles; any number of them may meet at an edge. Without points, they are
// given in the order around it.
Double_cover tufted_cover(const Gluing& faces, const Sides_by_edge& edges,
                          const std::vector<std::array<double, 3>>& points);

// The same for triangles of stars, whose first corner is the center: at an edge to the center, the
// two of its star are glued to each other, not to those of other stars. So no edge glues copies of
// one face, which stars have in common, and their order does not matter.
Double_cover cover_of_stars(const Gluing& faces, const Sides_by_edge& edges,
                            const std::vector<std::array<double, 3>>& points);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_TUFTED_COVER_H
