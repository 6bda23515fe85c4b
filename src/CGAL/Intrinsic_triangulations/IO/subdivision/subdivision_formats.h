// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_SUBDIVISION_FORMATS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_SUBDIVISION_FORMATS_H

#include <CGAL/Intrinsic_triangulations/IO/subdivision/Subdivision_field.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/Subdivision_output.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Output_buffer.h>

#include <algorithm>
#include <string_view>

namespace CGAL::Intrinsic_triangulations::internal {

// Fields of these names are places in the plane.
inline const Subdivision_field* find_field(const Subdivision_output& o, std::string_view name,
                                           Subdivision_field::Place place) {
  const auto i = std::ranges::find_if(o.fields, [&](const Subdivision_field& f) {
    return f.name == name && f.place == place && f.components == 1;
  });
  return i == o.fields.end() ? nullptr : &*i;
}

// Elements vertex, face and edge with all labels. Comments in the header say what properties mean.
// Plain: vertices and faces with fields.
void write_subdivision_PLY(Output_buffer& out, const Subdivision_output& o, bool is_binary,
                           bool is_plain);

// Labels are point and cell data, intrinsic edges are lines. Cells: lines before polygons.
void write_subdivision_VTP(Output_buffer& out, const Subdivision_output& o, bool has_lines);

// Comments before elements have the numbers of faces of both triangulations and of edges.
void write_subdivision_OBJ(Output_buffer& out, const Subdivision_output& o, bool with_lines);

// Polygons in the colours of `intrinsic_face_colors()`, plain: triangles without.
void write_subdivision_OFF(Output_buffer& out, const Subdivision_output& o, bool is_plain);

// Binary: each convex polygon as a fan of triangles, coordinates rounded to single precision.
void write_subdivision_STL(Output_buffer& out, const Subdivision_output& o);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_SUBDIVISION_FORMATS_H
