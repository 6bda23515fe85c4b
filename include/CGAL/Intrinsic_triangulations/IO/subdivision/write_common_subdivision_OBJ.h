// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_OBJ_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_OBJ_H

#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision_input.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Output_buffer.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/subdivision_edges.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <span>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// A comment with the labels of the faces from `f` on in its intrinsic face, and these faces; the first
// face after them.
inline std::size_t write_OBJ_faces(Output_buffer& out, const Common_subdivision& s, std::size_t f) {
  std::size_t end = f + 1;
  while (end < s.number_of_faces() && s.intrinsic_face[end] == s.intrinsic_face[f]) ++end;
  out.text("# intrinsic_face ", s.intrinsic_face[f], " input_faces");
  for (std::size_t g = f; g < end; ++g) out.text(' ', s.input_face[g]);
  out.text('\n');
  for (std::size_t g = f; g < end; ++g) {
    out.text('f');
    for (const std::uint32_t v : s.face(g)) out.text(' ', std::uint64_t{v} + 1);
    out.text('\n');
  }
  return end;
}

inline void write_OBJ_lines(Output_buffer& out, const Common_subdivision& s) {
  const Intrinsic_edge_polylines lines = intrinsic_edge_polylines(s);
  for (std::size_t e = 0; e < lines.size(); ++e) {
    if (lines[e].empty()) continue;
    out.text("# intrinsic_edge ", e, "\nl");
    for (const std::uint32_t v : lines[e]) out.text(' ', std::uint64_t{v} + 1);
    out.text('\n');
  }
}

} // namespace internal

/*!
\brief writes a common subdivision as OBJ: polygons and, if asked for, the intrinsic edges as polylines.

Numbers of intrinsic faces, faces of the input and intrinsic edges are in comments before the elements.
\param out the stream
\param s the subdivision
\param points the position of each vertex, see `positions()`; written without loss
\param options `lines_in_OBJ`
\throws Invalid_input if `points` does not have one value for each vertex
\throws std::runtime_error if the stream fails
\complexity linear
*/
inline void write_common_subdivision_OBJ(std::ostream& out, const Common_subdivision& s,
                                         std::span<const std::array<double, 3>> points,
                                         const Common_subdivision_output& options = {}) {
  internal::check_output(s, points, {});
  internal::Output_buffer buffer(out);
  buffer.text("# common subdivision of a mesh (the input) and an intrinsic triangulation of it\n"
              "# numbers in comments count from 0; input_faces: one for each face that follows\n");
  for (const std::array<double, 3>& p : points) buffer.text("v ", p[0], ' ', p[1], ' ', p[2], '\n');
  for (std::size_t f = 0; f < s.number_of_faces();) f = internal::write_OBJ_faces(buffer, s, f);
  if (options.lines_in_OBJ) internal::write_OBJ_lines(buffer, s);
  internal::check_written(buffer.flush());
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_OBJ_H
