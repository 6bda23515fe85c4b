// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_OFF_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_OFF_H

#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision_input.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Output_buffer.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/intrinsic_face_colors.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief writes a common subdivision as OFF: polygons in the colours of `intrinsic_face_colors()`.

\param out the stream
\param s the subdivision
\param points the position of each vertex, see `positions()`; written without loss
\throws Invalid_input if `points` does not have one value for each vertex
\throws std::runtime_error if the stream fails
\complexity linear
*/
inline void write_common_subdivision_OFF(std::ostream& out, const Common_subdivision& s,
                                         std::span<const std::array<double, 3>> points) {
  internal::check_output(s, points, {});
  internal::Output_buffer buffer(out);
  buffer.text("OFF\n", points.size(), ' ', s.number_of_faces(), " 0\n");
  for (const std::array<double, 3>& p : points) buffer.text(p[0], ' ', p[1], ' ', p[2], '\n');
  const std::vector<Rgb_color> colors = intrinsic_face_colors(s);
  for (std::size_t f = 0; f < s.number_of_faces(); ++f) {
    buffer.text(s.face(f).size());
    for (const std::uint32_t v : s.face(f)) buffer.text(' ', v);
    for (const std::uint8_t c : colors[s.intrinsic_face[f]]) buffer.text(' ', c);
    buffer.text('\n');
  }
  internal::check_written(buffer.flush());
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_OFF_H
