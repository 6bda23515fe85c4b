// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_PLACES_POINTS_OF_ROWS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_PLACES_POINTS_OF_ROWS_H

#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/connectivity/points_of.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <array>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief returns the point in space of each row: those of the user, then those of inserted vertices,
on the faces of the input. A cloud that was refined is a cloud of all of them.
\tparam Triangulation a model of `CorrespondingTriangulation`
\param t the triangulation
\param points the user's points
\complexity linear, and that of `locate_on_input()` for each inserted vertex
*/
template <QueriedTriangulation Triangulation>
std::vector<std::array<double, 3>>
points_of_rows(const Triangulation& t, const std::vector<std::array<double, 3>>& points) {
  std::vector<std::array<double, 3>> result(points);
  result.resize(t.number_of_vertices());
  for (const auto v : vertices(t.mesh())) {
    if (!t.is_inserted(v)) continue;
    const auto out = opposite(halfedge(v, t.mesh()), t.mesh());
    if (const auto p = locate_on_input(t, Surface_point{t.numbers().halfedge(out), {1, 0, 0}}))
      result[t.input_vertex(v)] = point_in_space(t, *p, points);
  }
  return result;
}

/*!
\brief returns the point in space of each row, from the mesh that the triangulation was built from.
\tparam FaceGraph a model of `FaceListGraph` with a point map of its own
*/
template <QueriedTriangulation Triangulation, ReadableFaceGraph FaceGraph>
std::vector<std::array<double, 3>> points_of_rows(const Triangulation& t, const FaceGraph& mesh) {
  return points_of_rows(t, points_of(mesh));
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_PLACES_POINTS_OF_ROWS_H
