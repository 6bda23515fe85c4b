// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_DISTANCE_FACE_COMPLEX_H
#define CGAL_INTRINSIC_GEODESICS_DISTANCE_FACE_COMPLEX_H

#include <CGAL/Intrinsic_geodesics/distance/Corner_table.h>
#include <CGAL/Intrinsic_geodesics/distance/trace_back.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*!
\brief is what a double cover covers: the user's faces, each once, any number of them at an edge.

Its vertices have the numbers of rows; its faces those of pairs of front and back. Nothing is
flipped: windows have to meet edges of more than two faces as edges.
*/
class Face_complex {
public:
  /// tells whether a surface is the double cover of faces. \complexity linear
  static bool is_under(const Input& input);

  /// reads the faces under a cover, which must outlive this object. \pre `is_under(input)`
  /// \complexity linear
  explicit Face_complex(const Input& input);

  /// returns the faces for searches. \complexity linear
  Corner_table table() const;
  /// returns the place of a point of the cover, on its front or its back.
  Path_place place(const Surface_point& p) const;
  /// returns a point of the cover at a place: on its front.
  Surface_point point(const Path_place& p) const { return {halfedges_[p.side], p.weights}; }

private:
  std::uint32_t side(std::uint32_t halfedge, bool& is_back) const;
  std::vector<Branched_side::Other> sides_at_edge(std::uint32_t side) const;

  const Input& input_;
  std::vector<std::uint32_t> halfedges_; // of the front, by sides
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_DISTANCE_FACE_COMPLEX_H
