// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_APPLICATION_DIRECTION_LINES_H
#define INTRINSIC_APPLICATION_DIRECTION_LINES_H

#include "../delaunay.h"
#include "Computed.h"

#include <CGAL/Intrinsic_triangulations/IO/curves/Polyline.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/vector_field.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Vertex_copies.h>

#include <complex>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

namespace program {

/// appends a line from a point along a vector, or an arrow, the tip of which has another colour.
void append_direction(std::vector<IT::Polyline>& lines, const Point& from, const Point& vector,
                      bool is_arrow);
/// returns the factor by which to draw vectors: the longest as long as half of a mean edge.
double length_of_lines(const IT::Common_subdivision& s, const std::vector<Point>& points,
                       const IT::Tangent_field& vectors);

/*!
\brief returns lines that show a direction field on a surface: an arrow at each vertex, or crosses.
\param loaded the triangulation
\param computed the field
\param drawn the common subdivision, or the mesh of the file, on which lines are drawn at the vertices of the triangulation
*/
template <class Triangulation>
std::vector<IT::Polyline> direction_lines(const Loaded<Triangulation>& loaded,
                                          const Computed& computed,
                                          const Drawn_subdivision& drawn) {
  std::vector<IT::Polyline> lines;
  if (!computed.directions) return lines;
  const auto& t = loaded.triangulation;
  const IT::Tangent_field& vectors = computed.directions->vectors;
  const unsigned degree = computed.directions->degree;
  const double length = length_of_lines(drawn.s, drawn.points, vectors);
  const IT::internal::Vertex_copies copies(t);
  const std::vector<Point> points = input_points(loaded);
  for (unsigned k = 0; k < degree; ++k) {
    IT::Tangent_field turned = vectors;
    for (std::complex<double>& z : turned)
      z *= std::polar(length, 2 * std::numbers::pi * k / degree);
    const std::vector<Point> in_space = IT::vectors_in_space(t, turned, points);
    for (std::size_t v = 0; v < drawn.s.vertices.size(); ++v)
      append_direction(lines, drawn.points[v],
                       in_space[copies(t.numbers().vertex_at(drawn.s.vertices[v].intrinsic))],
                       degree == 1);
  }
  return lines;
}

} // namespace program

#endif // INTRINSIC_APPLICATION_DIRECTION_LINES_H
