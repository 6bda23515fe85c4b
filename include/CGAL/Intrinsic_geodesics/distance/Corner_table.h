// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_DISTANCE_CORNER_TABLE_H
#define CGAL_INTRINSIC_GEODESICS_DISTANCE_CORNER_TABLE_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Metric_values.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*!
\brief is a corner of a face and the side that starts there, counterclockwise.

The angle is a unit vector: unfolding across a side turns about a corner by it. Errors of rounding
in a long and thin face are so relative to its longest side, whichever sides are crossed.
*/
struct Face_corner {
  double length = 0; ///< length of the side
  double cosine = 1; ///< of the angle at the corner
  double sine = 0;   ///< of the angle at the corner
  std::uint32_t opposite =
      Gluing::none; ///< the same edge as a side of a face; a number from `first_branch` on where it
                    ///< has several others; `Gluing::none` on the border
  std::uint32_t origin = Gluing::none; ///< the vertex

  /// Numbers from here on are those of branches, plus this.
  static constexpr std::uint32_t first_branch = 0x80000000U;
  /// returns whether there is just one face on the other side, which runs against this one.
  bool has_one_neighbor() const { return opposite < first_branch; }
};

/*!
\brief is a side of a face where other than one face goes on that runs against it.
*/
struct Branched_side {
  /// The same edge as a side of another face.
  struct Other {
    std::uint32_t side; ///< a corner
    bool is_along;      ///< whether it runs along this one, instead of against it
  };
  std::uint32_t side = Gluing::none; ///< a corner
  std::vector<Other> others;         ///< all others at the edge
};

/*!
\brief is a triangulation as one flat array: corner `3 f + k` is the source of side `k` of face `f`.

Lengths are in scaled units, see `unit`. Vertices and faces have their numbers in the triangulation;
those of removed ones are left empty.
*/
struct Corner_table {
  std::vector<Face_corner> corners; ///< three per face
  std::vector<std::uint32_t>
      first_corner; ///< per vertex: the most clockwise corner of a fan, or none
  /// Other fans of vertices that are not manifold: the vertex, and the most clockwise corner;
  /// sorted.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> other_fans;
  /// On a cover, per vertex the next copy of the same vertex of the user, in a circle; else empty.
  std::vector<std::uint32_t> next_copy;
  std::vector<Branched_side> branches; ///< sides where several faces go on
  double unit = 1;                     ///< what the length 1 is in the units of the input

  /// returns the next corner of the face.
  static std::uint32_t next(std::uint32_t c) { return c % 3 == 2 ? c - 2 : c + 1; }
  /// returns the corner before it in the face.
  static std::uint32_t previous(std::uint32_t c) { return c % 3 == 0 ? c + 2 : c - 1; }
  /// returns the side on the other side if it is the only one and runs against this one, or
  /// `Gluing::none`.
  std::uint32_t neighbor(std::uint32_t c) const {
    return corners[c].has_one_neighbor() ? corners[c].opposite : Gluing::none;
  }
  /// returns the branch of a side. \pre it has one
  const Branched_side& branch(std::uint32_t c) const {
    return branches[corners[c].opposite - Face_corner::first_branch];
  }
  /// returns the corner of the same vertex in the next face counterclockwise, or `Gluing::none`.
  std::uint32_t turn_left(std::uint32_t c) const { return neighbor(previous(c)); }
  /// returns the corner of the same vertex in the next face clockwise, or `Gluing::none`.
  std::uint32_t turn_right(std::uint32_t c) const {
    const std::uint32_t o = neighbor(c);
    return o == Gluing::none ? o : next(o);
  }

  /// finds the fans of all vertices. \pre `corners` are there, and `first_corner` is long enough
  void find_fans();
};

// The cosine and the sine of the angle between two sides, from the squared lengths of all sides and
// the quadruple area; those of a right angle at a side of length zero.
std::pair<double, double> corner_direction(double left, double right, double opposite,
                                           double quadruple_area);

// Writes the corners of a face.
template <NumberedTriangulation Triangulation>
void write_corners(const Triangulation& t, typename Triangulation::face_descriptor f,
                   const std::vector<std::uint32_t>& corner_of_halfedge, Corner_table& table) {
  const Face_values<double> values = accurate_values(t, f);
  const std::array<double, 3>& l = values.squared_lengths;
  typename Triangulation::halfedge_descriptor h = halfedge(f, t.mesh());
  for (std::size_t k = 0; k < 3; ++k, h = next(h, t.mesh())) {
    const auto [cosine, sine] =
        corner_direction(l[k], l[(k + 2) % 3], l[(k + 1) % 3], values.quadruple_area);
    table.corners[3 * std::size_t{t.index(f)} + k] = {
        std::sqrt(l[k]), cosine, sine,
        corner_of_halfedge[t.numbers().halfedge(opposite(h, t.mesh()))],
        t.index(source(h, t.mesh()))};
  }
}

// Links the copies of vertices on a cover, which have one row.
template <NumberedTriangulation Triangulation>
void link_copies(const Triangulation& t, Corner_table& table) {
  if constexpr (requires { t.input().names().row_of_vertex; }) {
    if (t.input().names().row_of_vertex.empty()) return;
    table.next_copy.resize(table.first_corner.size());
    std::unordered_map<std::uint32_t, std::uint32_t> first; // by row
    for (const typename Triangulation::vertex_descriptor v : vertices(t.mesh())) {
      const std::uint32_t i = t.index(v);
      table.next_copy[i] = i;
      const auto [place, is_new] = first.emplace(t.input_vertex(v), i);
      if (!is_new) std::swap(table.next_copy[i], table.next_copy[place->second]);
    }
  }
}

// The halfedge whose source a corner is, in its face.
template <NumberedTriangulation Triangulation>
std::uint32_t halfedge_of_corner(const Triangulation& t, std::uint32_t corner) {
  typename Triangulation::halfedge_descriptor h =
      halfedge(t.numbers().face_at(corner / 3), t.mesh());
  for (std::uint32_t k = 0; k < corner % 3; ++k) h = next(h, t.mesh());
  return t.numbers().halfedge(h);
}

// Reads a triangulation once; the search uses the table alone.
template <NumberedTriangulation Triangulation>
Corner_table corner_table(const Triangulation& t) {
  const typename Triangulation::Mesh& mesh = t.mesh();
  std::vector<std::uint32_t> corner_of_halfedge(2 * std::size_t{t.numbers().edge_capacity(mesh)},
                                                Gluing::none);
  std::uint32_t vertex_bound = 0;
  for (const typename Triangulation::vertex_descriptor v : vertices(mesh))
    vertex_bound = std::max(vertex_bound, t.index(v) + 1);
  for (const typename Triangulation::face_descriptor f : faces(mesh)) {
    typename Triangulation::halfedge_descriptor h = halfedge(f, mesh);
    for (std::uint32_t k = 0; k < 3; ++k, h = next(h, mesh))
      corner_of_halfedge[t.numbers().halfedge(h)] = 3 * t.index(f) + k;
  }
  Corner_table table;
  table.unit = std::ldexp(1.0, -t.metric().scale_exponent());
  table.corners.resize(3 * std::size_t{t.numbers().face_capacity(mesh)});
  table.first_corner.assign(vertex_bound, Gluing::none);
  for (const typename Triangulation::face_descriptor f : faces(mesh))
    write_corners(t, f, corner_of_halfedge, table);
  table.find_fans();
  link_copies(t, table);
  return table;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_DISTANCE_CORNER_TABLE_H
