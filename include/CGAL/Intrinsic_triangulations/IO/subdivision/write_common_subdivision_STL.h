// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_STL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_STL_H

#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision_input.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Output_buffer.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <span>
#include <string>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

using STL_point = std::array<double, 3>;

// The unit normal of a triangle; 0 if its corners are collinear.
inline STL_point STL_normal(const STL_point& a, const STL_point& b, const STL_point& c) {
  STL_point u, v;
  for (std::size_t i = 0; i < 3; ++i) {
    u[i] = b[i] - a[i];
    v[i] = c[i] - a[i];
  }
  const STL_point n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                    u[0] * v[1] - u[1] * v[0]};
  const double length = std::hypot(n[0], n[1], n[2]);
  return length > 0 ? STL_point{n[0] / length, n[1] / length, n[2] / length} : STL_point{0, 0, 0};
}

inline void check_STL_range(Subdivision_points points) {
  for (const STL_point& p : points)
    for (const double x : p)
      if (std::abs(x) > static_cast<double>(std::numeric_limits<float>::max()))
        throw Invalid_input(Element_kind::none, 0,
                            "a coordinate exceeds the range of STL; scale the mesh, or write .ply");
}

inline void write_STL_triangle(Output_buffer& out, const STL_point& a, const STL_point& b,
                               const STL_point& c) {
  for (const STL_point& p : {STL_normal(a, b, c), a, b, c})
    for (const double x : p) out.binary(static_cast<float>(x));
  out.binary(std::uint16_t{0});
}

} // namespace internal

/*!
\brief writes a common subdivision as binary STL: each convex polygon as a fan of triangles.

STL has no labels, and single precision: coordinates are rounded.
\param out the stream, binary
\param s the subdivision
\param points the position of each vertex, see `positions()`
\throws Invalid_input if `points` does not have one value for each vertex, or if a coordinate exceeds
  single precision
\throws std::runtime_error if the stream fails
\complexity linear
*/
inline void write_common_subdivision_STL(std::ostream& out, const Common_subdivision& s,
                                         std::span<const std::array<double, 3>> points) {
  internal::check_output(s, points, {});
  internal::check_STL_range(points);
  internal::Output_buffer buffer(out);
  // exactly 80 bytes, which must not start with "solid" as text does
  std::string title = "binary STL: common subdivision of a mesh and an intrinsic triangulation";
  title.resize(80, ' ');
  buffer.text(title);
  buffer.binary(static_cast<std::uint32_t>(s.corner.size() - 2 * s.number_of_faces()));
  for (std::size_t f = 0; f < s.number_of_faces(); ++f) {
    const std::span<const std::uint32_t> face = s.face(f);
    for (std::size_t k = 2; k < face.size(); ++k)
      internal::write_STL_triangle(buffer, points[face[0]], points[face[k - 1]], points[face[k]]);
  }
  internal::check_written(buffer.flush());
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_STL_H
