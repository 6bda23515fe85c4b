// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_CERTIFY_MAP_H
#define CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_CERTIFY_MAP_H

#include <CGAL/Intrinsic_operators/operators/Face_table.h>
#include <CGAL/Intrinsic_operators/parametrization/disk_border.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief tells whether a map to the plane, given by doubles, is injective; the answer is exact.

The surface is a disk, or consists of several.
*/
struct Map_certificate {
  std::size_t faces = 0;      ///< number of faces
  std::size_t flipped = 0;    ///< those that turn clockwise in the plane
  std::size_t degenerate = 0; ///< those with corners on a line
  /// Numbers of the faces that are flipped or degenerate, in ascending order, a hundred at most.
  std::vector<std::uint32_t> bad_faces;
  /// Whether the border is a simple closed polygon: it does not meet itself. Those of several disks
  /// also have disjoint bounding boxes, as `pack_components()` makes them.
  bool border_is_simple = false;

  /// tells whether the map is injective near each point that is not a vertex: no face is flipped or
  /// degenerate.
  bool is_locally_injective() const { return flipped == 0 && degenerate == 0; }
  /*!
  \brief tells whether the map is injective.

  Let all faces turn counterclockwise and the border be a simple polygon. The number of preimages of
  a point inside, counted with signs, is the number of turns of the border around it (the degree of
  the map). All signs are positive, and a simple border turns once: one preimage. The border need
  not be convex. Images of several disks are in disjoint boxes.
  */
  bool is_injective() const { return is_locally_injective() && border_is_simple; }
};

namespace internal {

// Lists all bad faces. There is a border for each component, or none at all.
Map_certificate certify_map(const std::vector<std::array<std::uint32_t, 3>>& faces,
                            const std::vector<std::uint32_t>& face_numbers,
                            const std::vector<std::vector<std::uint32_t>>& borders,
                            const Eigen::MatrixX2d& uv);

// The certificate with all bad faces.
template <class Triangulation>
Map_certificate complete_certificate(const Triangulation& t, const Eigen::MatrixX2d& uv) {
  const Face_table table = face_table(t);
  std::vector<std::array<std::uint32_t, 3>> faces(table.faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k)
      faces[f][k] = static_cast<std::uint32_t>(table.faces[f].rows[k]);
  std::vector<std::uint32_t> numbers(faces.size());
  for (std::uint32_t i = 0; i < table.slot.size(); ++i)
    if (table.slot[i] != Gluing::none) numbers[table.slot[i]] = i;
  std::vector<std::vector<std::uint32_t>> borders;
  for (Disk_border& b : disk_borders(table, t.input().names().sheets))
    borders.push_back(std::move(b.rows));
  return certify_map(faces, numbers, borders, uv);
}

// Keeps as many bad faces as a certificate lists: a screen or two of them.
inline Map_certificate shortened(Map_certificate c) {
  if (c.bad_faces.size() > 100) c.bad_faces.resize(100);
  return c;
}

} // namespace internal

/*!
\brief certifies, with exact predicates, a map of a disk, or of several, to the plane that is linear
on the faces of a triangulation.
\tparam Triangulation a model of `NumberedTriangulation`
\param t the triangulation
\param uv a point per row of `t.input_vertex()`; the doubles are taken as they are
\return the certificate; faces have the numbers `t.index(f)`
\throws Invalid_input if a component is not a disk, see `circular_border()`
\throws std::invalid_argument if a row is missing, or a coordinate is not finite
\complexity linear in the number of faces, O(n log n) in that of vertices on the border
*/
template <NumberedTriangulation Triangulation>
Map_certificate certify_map(const Triangulation& t, const Eigen::MatrixX2d& uv) {
  return internal::shortened(internal::complete_certificate(t, uv));
}

/*!
\brief certifies a map of triangles to the plane, such as the user's mesh. There, the values of a
map from an intrinsic triangulation give another map between the vertices.
\param triangles disks, as triples of vertices
\param uv a point per vertex
\return the certificate; the border is simple only if each component has one, a loop, and no vertex
  is on it twice
\throws std::invalid_argument as above
\complexity O(n log n)
*/
Map_certificate certify_map(const std::vector<std::array<std::uint32_t, 3>>& triangles,
                            const Eigen::MatrixX2d& uv);

/*!
\brief certifies a map of the user's mesh to the plane, see the overload with triangles.
\param input disks
\param uv a point per row; more rows, those of inserted vertices, are ignored
\return the certificate of the map between the vertices, linear on each triangle of the input
\throws std::invalid_argument as above
\complexity O(n log n)
*/
Map_certificate certify_map(const Input& input, const Eigen::MatrixX2d& uv);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_PARAMETRIZATION_CERTIFY_MAP_H
