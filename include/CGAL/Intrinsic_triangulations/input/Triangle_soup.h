// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_TRIANGLE_SOUP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_TRIANGLE_SOUP_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief holds points and the triangles between them, before any edge is matched.

Vertices keep the numbers they have in the input. Triangles follow the order of the input faces; a
polygon with `n` sides gives `n - 2` consecutive triangles, oriented as the polygon is.
*/
struct Triangle_soup {
  /// Coordinates of the vertices, isolated ones included.
  std::vector<std::array<double, 3>> points;
  /// Vertices of the triangles, counterclockwise.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// Input face of each triangle; empty if all input faces are triangles.
  std::vector<std::uint32_t> polygon_of_triangle;
  /// Number of faces of the input.
  std::size_t input_faces = 0;
  /// Number of input faces with more than three sides.
  std::size_t triangulated_polygons = 0;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_TRIANGLE_SOUP_H
