// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_APPLICATION_DIRECTION_LINES_H
#define INTRINSIC_APPLICATION_DIRECTION_LINES_H

#include "../delaunay.h"
#include "Computed.h"

#include <CGAL/Intrinsic_triangulations/IO/view/write_html_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/vector_field.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Vertex_copies.h>

#include <complex>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace program {

/// A direction field on the surface that is drawn, in space.
struct Drawn_directions {
  std::vector<std::vector<Point>> at_vertices{}; ///< each of the directions; zero at crossings
  std::vector<std::vector<Point>> at_faces{};
  std::vector<int> index{}; ///< of each face, or none
};

/// returns the directions at vertices for a page: those of each vertex one after another.
std::vector<IT::Placed_vector> placed_vectors(const Drawn_directions& directions,
                                              const Drawn_subdivision& drawn);
/// appends vectors at vertices and faces, and indices of faces, to the fields of a file.
void append_fields(std::vector<IT::Subdivision_field>& fields, const std::string& name,
                   const Drawn_directions& directions);

/*!
\brief returns the directions of a field on a surface, in space.
\param loaded the triangulation: the one with the field, or the input before its first move
\param field one of the directions at each vertex of it
\param degree how many of them differ by turns of a full turn by their number
\param drawn its common subdivision
*/
template <class Triangulation>
Drawn_directions directions_in_space(const Loaded<Triangulation>& loaded,
                                     const IT::Tangent_field& field, unsigned degree,
                                     const Drawn_subdivision& drawn) {
  const Triangulation& t = loaded.triangulation;
  const IT::Vertex_copies copies(t);
  const std::vector<Point> points = input_points(loaded);
  Drawn_directions result;
  IT::Common_subdivision s = drawn.s;
  s.input_face = drawn.input_triangle;
  const std::vector<Point> in_faces = IT::vectors_in_space(t, field, s, points, degree);
  for (unsigned k = 0; k < degree; ++k) {
    IT::Tangent_field turned = field;
    for (std::complex<double>& z : turned) z *= std::polar(1., 2 * std::numbers::pi * k / degree);
    const std::vector<Point> in_space = IT::vectors_in_space(t, turned, points);
    std::vector<Point> at_vertices(s.number_of_vertices(), {0, 0, 0}), at_faces;
    for (std::size_t v = 0; v < s.vertices.size(); ++v)
      at_vertices[v] = in_space[copies(t.numbers().vertex_at(s.vertices[v].intrinsic))];
    for (std::size_t f = 0; f < s.number_of_faces(); ++f)
      at_faces.push_back(in_faces[degree * f + k]);
    result.at_vertices.push_back(std::move(at_vertices));
    result.at_faces.push_back(std::move(at_faces));
  }
  return result;
}

} // namespace program

#endif // INTRINSIC_APPLICATION_DIRECTION_LINES_H
