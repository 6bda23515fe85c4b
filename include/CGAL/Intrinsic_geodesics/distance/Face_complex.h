// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_DISTANCE_FACE_COMPLEX_H
#define CGAL_INTRINSIC_GEODESICS_DISTANCE_FACE_COMPLEX_H

#include <CGAL/Intrinsic_geodesics/distance/Corner_table.h>
#include <CGAL/Intrinsic_geodesics/distance/trace_back.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Sheets.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <array>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*!
\brief is what a double cover covers: the user's faces, each once, any number of them at an edge.

Its vertices have the numbers of rows; its faces those of pairs of front and back. In a cloud, of
which each point has triangles of its own, those at the same three points are one face, and all
with two points in common meet at the segment between them. Nothing is flipped: windows have to meet
edges of more than two faces as edges.
*/
class Face_complex {
public:
  /// tells whether a surface is the double cover of faces. \complexity linear
  static bool is_under(const Input& input);

  /// reads the faces under a cover, which must outlive this object. \pre `is_under(input)`
  /// \complexity linear
  explicit Face_complex(const Input& input);

  /// returns the faces for searches. \complexity linear, but for sorting
  Corner_table table() const;
  /// returns the place of a point of the cover, on its front or its back.
  Path_place place(const Surface_point& p) const;
  /// returns a point of the cover at a place: on its front.
  Surface_point point(const Path_place& p) const { return {halfedges_[p.side], p.weights}; }

private:
  struct Side {
    std::uint32_t number;
    bool is_against; // it runs against that side
  };

  struct Side_on_edge {
    std::array<std::uint32_t, 2> edge; // a name that the sides at one edge share
    std::uint32_t number;
    bool is_along; // it runs in the direction of the name
  };

  Side same_side(std::uint32_t first, const std::array<std::uint32_t, 3>& sides, unsigned k) const;
  std::uint32_t side(std::uint32_t halfedge, bool& is_back) const;
  Side_on_edge on_edge(std::uint32_t side) const;
  std::vector<Branched_side> sides_at_edges() const;
  // of the source of a halfedge
  std::uint32_t row(std::uint32_t h) const { return input_.names().row(input_.source(h)); }

  const Input& input_;
  Sheets sheets_;
  std::vector<Side> sides_;              // by the sides of the user's faces
  std::vector<std::uint32_t> halfedges_; // of the front, by sides
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_DISTANCE_FACE_COMPLEX_H
