// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_MESH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_MESH_H

#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision_input.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Output_buffer.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/intrinsic_face_colors.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/subdivision_edges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/*!
\file
Formats for polygons alone: OBJ, OFF, STL.
*/

namespace CGAL::Intrinsic_triangulations::internal {

// A line with the numbers of vertices as OBJ has them, from 1.
inline void write_OBJ_vertices(Output_buffer& out, char kind,
                               std::span<const std::uint32_t> vertices) {
  out.words(kind);
  for (const std::uint32_t v : vertices) out.words(std::uint64_t{v} + 1);
  out.line();
}

// A corner of a face: its vertex, and its place in the plane, which has the same number.
inline void write_OBJ_face(Output_buffer& out, std::span<const std::uint32_t> vertices,
                           bool has_texture) {
  if (!has_texture) return write_OBJ_vertices(out, 'f', vertices);
  out.words('f');
  for (const std::uint32_t v : vertices)
    out.text(' ', std::uint64_t{v} + 1, '/', std::uint64_t{v} + 1);
  out.line();
}

// Fields of these names are places in the plane.
inline const Subdivision_field* find_field(const Subdivision_output& o, std::string_view name) {
  const auto i = std::ranges::find_if(
      o.fields, [name](const Subdivision_field& f) { return f.name == name && f.is_function(); });
  return i == o.fields.end() ? nullptr : &*i;
}

// Numbers of intrinsic faces, faces of the input and intrinsic edges are in comments before the elements.
inline void write_OBJ(Output_buffer& out, const Subdivision_output& o, bool with_lines) {
  const Common_subdivision& s = o.s;
  out.text("# common subdivision of a mesh (the input) and an intrinsic triangulation of it\n"
           "# numbers in comments count from 0; input_faces: one for each face that follows\n");
  for (const std::array<double, 3>& p : o.points) out.line('v', p[0], p[1], p[2]);
  const Subdivision_field *const u = find_field(o, "u"), *const v = find_field(o, "v");
  const bool has_texture = u != nullptr && v != nullptr;
  for (std::size_t i = 0; has_texture && i < o.points.size(); ++i)
    out.line("vt", u->values[i], v->values[i]);
  for (std::size_t f = 0, end = 0; f < s.number_of_faces(); f = end) {
    out.words("# intrinsic_face", s.intrinsic_face[f], "input_faces");
    for (; end < s.number_of_faces() && s.intrinsic_face[end] == s.intrinsic_face[f]; ++end)
      out.words(s.input_face[end]);
    out.line();
    for (std::size_t g = f; g < end; ++g) write_OBJ_face(out, s.face(g), has_texture);
  }
  if (!with_lines) return;
  const Edge_polylines lines = intrinsic_edge_polylines(s);
  for (std::size_t e = 0; e < lines.size(); ++e) {
    if (lines[e].empty()) continue;
    out.line("# intrinsic_edge", e);
    write_OBJ_vertices(out, 'l', lines[e]);
  }
}

// Polygons in the colours of `intrinsic_face_colors()`.
inline void write_OFF(Output_buffer& out, const Subdivision_output& o) {
  out.text("OFF\n", o.points.size(), ' ', o.s.number_of_faces(), " 0\n");
  for (const std::array<double, 3>& p : o.points) out.line(p[0], p[1], p[2]);
  const std::vector<Rgb_color> colors = intrinsic_face_colors(o.s);
  for (std::size_t f = 0; f < o.s.number_of_faces(); ++f) {
    out.words(o.s.face(f).size());
    for (const std::uint32_t v : o.s.face(f)) out.words(v);
    const Rgb_color& c = colors[o.s.intrinsic_face[f]];
    out.line(c[0], c[1], c[2]);
  }
}

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

inline void check_STL_range(std::span<const STL_point> points) {
  for (const STL_point& p : points)
    for (const double x : p)
      if (std::abs(x) > static_cast<double>(std::numeric_limits<float>::max()))
        throw Invalid_input(Element_kind::none, 0,
                            "a coordinate exceeds the range of STL; scale the mesh, or write .ply");
}

// Binary: each convex polygon as a fan of triangles, coordinates rounded to single precision.
inline void write_STL(Output_buffer& out, const Subdivision_output& o) {
  check_STL_range(o.points);
  // exactly 80 bytes, which must not start with "solid" as text does
  std::string title = "binary STL: common subdivision of a mesh and an intrinsic triangulation";
  title.resize(80, ' ');
  out.text(title);
  out.binary(static_cast<std::uint32_t>(o.s.corner.size() - 2 * o.s.number_of_faces()));
  for (std::size_t f = 0; f < o.s.number_of_faces(); ++f) {
    const std::span<const std::uint32_t> face = o.s.face(f);
    const STL_point& a = o.points[face[0]];
    for (std::size_t k = 2; k < face.size(); ++k) {
      const STL_point &b = o.points[face[k - 1]], &c = o.points[face[k]];
      for (const STL_point& p : {STL_normal(a, b, c), a, b, c})
        for (const double x : p) out.binary(static_cast<float>(x));
      out.binary(std::uint16_t{0});
    }
  }
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_MESH_H
