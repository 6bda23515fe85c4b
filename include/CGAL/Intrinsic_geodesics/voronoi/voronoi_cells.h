// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_VORONOI_VORONOI_CELLS_H
#define CGAL_INTRINSIC_GEODESICS_VORONOI_VORONOI_CELLS_H

#include <CGAL/Intrinsic_geodesics/distance/Corner_table.h>
#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_geodesics/isolines/isolines.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_curve.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_shortest_path.h>
#include <CGAL/Intrinsic_geodesics/voronoi/cell_boundaries.h>
#include <CGAL/Intrinsic_triangulations/IO/curves/write_polylines.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a line between the cells of two sources.
*/
struct Cell_boundary {
  /// Index of the source of the cell on its left.
  std::uint32_t left = 0;
  /// Index of the source of the cell on its right.
  std::uint32_t right = 0;
  /// Whether it ends where it begins. Other lines end at junctions or on the border.
  bool is_closed = false;
  /// Whether the points are those of the input: of a search on the faces under a cover.
  bool is_on_input = false;
  /// Straight pieces, in order: begin and end, as points of one face.
  std::vector<std::array<Surface_point, 2>> pieces;
};

/// is a point where three or more cells meet.
struct Cell_junction {
  /// Where it is.
  Surface_point point;
  /// Indices of the sources of the cells, in clockwise order.
  std::vector<std::uint32_t> sources;
};

/// is a point on an edge where the nearest source changes.
struct Cell_break {
  /// Where it is; the halfedge is that of a side.
  Edge_point point;
  /// Index of the source that is the nearest on the halfedge before the point.
  std::uint32_t before = 0;
  /// Index of the source that is the nearest after it.
  std::uint32_t after = 0;
};

/*!
\brief is a surface divided among sources: each point belongs to the nearest one.
*/
struct Voronoi_cells {
  /// `done`; `inaccurate` if rounding has hidden how some boundaries go on, which are drawn to the
  /// middle of the part of a face where that is.
  Status status = Status::done;
  /// Area of the cell of each source, in the units of the input.
  std::vector<double> areas;
  /// The boundaries between cells.
  std::vector<Cell_boundary> boundaries;
  /// Where boundaries meet.
  std::vector<Cell_junction> junctions;
  /// Where boundaries cross edges, those of an edge in order along one halfedge. An edge without
  /// any lies in one cell.
  std::vector<Cell_break> breaks;
};

/*!
\brief divides a surface into the cells of the sources of a search: the exact geodesic Voronoi
  diagram, up to a tolerance.

Breaks on edges are exact, but for rounding. In a face, boundaries are pieces of hyperbolas, drawn
as polylines. Every point of a polyline is within the tolerance of a point where two sources are
nearest, of the cells on its sides; junctions are that near to one where cells meet. No cell is
missed, however small its part of a face. Where all of a region has two nearest sources, as
behind a vertex with more than a full turn that has two, it goes to one of them. Areas sum to that
of the surface. In faces of no height, 10^-9 of their longest side, three or more lines meet at the
mean of where they come in, whatever the tolerance.

Sources may share a cell: a set of them has the points that are nearest to one of the set. Results
name the cell where they name a source.

Cells of a search on the faces under a cover, see `Polyhedral_distance::on_faces()`, have their
areas there. Boundaries end where more than two faces meet, and at edges of two faces that disagree.

\tparam Triangulation a model of `NumberedTriangulation`
\tparam NP a chain of named parameters
\param distance the search
\param cell_of_source index of the cell of each source, from 0
\param np optional named parameters:
  - `tolerance(x)`: of polylines and junctions, in the units of the input; no less than 10^-9 of a
    face. Default: a thousandth of the mean edge length
\return the cells
\throws std::invalid_argument if the search did not go everywhere, or there is not a cell for each
  source
\complexity linear in the number of windows, which the first query keeps, see `Polyhedral_distance`;
  and, for each face with k windows that a boundary crosses, about k^2
*/
template <NumberedTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
Voronoi_cells voronoi_cells(const Polyhedral_distance<Triangulation>& distance,
                            const std::vector<std::uint32_t>& cell_of_source,
                            const NP& np = parameters::default_values()) {
  internal::expect_names<internal::tags::tolerance>(np);
  if (distance.status() != Status::done || std::isfinite(distance.reached_distance()))
    throw std::invalid_argument("cells need a search that goes everywhere; leave out "
                                "maximum_distance, targets, and caps");
  if (cell_of_source.size() != distance.number_of_sources())
    throw std::invalid_argument("each source needs the index of its cell; there are " +
                                std::to_string(distance.number_of_sources()) + " sources, not " +
                                std::to_string(cell_of_source.size()));
  const auto point = [&](const internal::Path_place& p) { return distance.surface().point(p); };
  const internal::Distance_field& field = distance.field_with_windows();
  const double unit = field.table.unit;
  const double tolerance = internal::value_or<internal::tags::tolerance>(
      np, unit * internal::default_cell_tolerance(field.table));
  const internal::Cell_partition found =
      internal::cell_boundaries(field, cell_of_source, tolerance / unit);
  Voronoi_cells cells;
  if (!found.is_complete) cells.status = Status::inaccurate;
  for (const double area : found.areas) cells.areas.push_back(area * unit * unit);
  for (const internal::Side_break& b : found.breaks)
    cells.breaks.push_back({{point({b.side, {1, 0, 0}}).halfedge, b.parameter}, b.before, b.after});
  for (const internal::Boundary_junction& j : found.junctions)
    cells.junctions.push_back({point(j.place), j.sources});
  for (const internal::Boundary_line& line : internal::joined_lines(found)) {
    const internal::Boundary_segment& first = line.segments.front();
    Cell_boundary boundary{first.left, first.right, line.is_closed, distance.is_on_faces(), {}};
    for (const internal::Boundary_segment& s : line.segments)
      boundary.pieces.push_back({point(s.places[0]), point(s.places[1])});
    cells.boundaries.push_back(std::move(boundary));
  }
  return cells;
}

/// divides a surface into a cell for each source; see the overload with a cell of each source.
template <NumberedTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
Voronoi_cells voronoi_cells(const Polyhedral_distance<Triangulation>& distance,
                            const NP& np = parameters::default_values()) {
  std::vector<std::uint32_t> own(distance.number_of_sources());
  std::iota(own.begin(), own.end(), 0U);
  return voronoi_cells(distance, own, np);
}

/*!
\brief traces the boundary between two cells over the input.
\tparam Triangulation a model of `CorrespondingTriangulation`
\param t the triangulation of the search
\param boundary one of those that `voronoi_cells()` found
\return its way, to the first point again if it is closed: `polyline()` and `face_locations()` take
it to the user's mesh. Pieces of length zero are left out; the status is `not_traceable` if
`Signposts` lost a piece
\complexity see `trace_shortest_path()`
*/
template <QueriedTriangulation Triangulation>
Traced_curve trace_boundary(const Triangulation& t, const Cell_boundary& boundary) {
  const internal::Accurate_view<Triangulation> view(t);
  internal::Piece_tracer<Triangulation> tracer(t);
  Traced_curve curve;
  const Input& input = t.correspondence().input();
  for (const auto& [p, q] : boundary.pieces) {
    const auto v = boundary.is_on_input ? vector_between(input, p, q) : vector_between(view, p, q);
    if (v[0] == 0 && v[1] == 0) continue;
    if (boundary.is_on_input) {
      if (curve.points.empty()) curve.points.push_back(p);
      curve.faces.push_back(input.face(p.halfedge));
      curve.points.push_back(q);
    } else if (!tracer.append(p, q, v, curve))
      return {Status::not_traceable, {}, {}, 0, {0}};
    curve.length += std::hypot(v[0], v[1]);
  }
  curve.length_enclosure = {0, std::numeric_limits<double>::infinity()};
  return curve;
}

namespace internal {

// The boundaries as polylines; `point` takes points of the input to coordinates.
template <class Triangulation, class Point_of>
std::vector<Polyline> boundaries_at(const Triangulation& t, const Voronoi_cells& cells,
                                    const Point_of& point) {
  std::vector<Polyline> result;
  for (std::size_t i = 0; i < cells.boundaries.size(); ++i) {
    Polyline line{{}, cells.boundaries[i].is_closed, static_cast<std::int32_t>(i)};
    for (const Surface_point& p : trace_boundary(t, cells.boundaries[i]).points) {
      const std::array<double, 3> x = point(p);
      if (line.points.empty() || line.points.back() != x) line.points.push_back(x);
    }
    if (line.is_closed && !line.points.empty()) line.points.pop_back(); // the first one again
    if (line.points.size() > 1) result.push_back(std::move(line));
  }
  return result;
}

} // namespace internal

/*!
\brief returns the boundaries of cells as polylines in space, which `write_polylines()` writes.
\tparam Triangulation a model of `CorrespondingTriangulation`
\tparam Mesh a model of `ReadableFaceGraph`
\param t the triangulation of the search
\param cells what `voronoi_cells()` found
\param mesh the mesh that `t` was built from; its faces may be polygons
\return the polylines, labelled by the places of the boundaries in `cells`; boundaries of length
zero, and those that `Signposts` lost, are left out
\throws Invalid_input if the mesh is another one
*/
template <QueriedTriangulation Triangulation, ReadableFaceGraph Mesh>
std::vector<Polyline> polylines(const Triangulation& t, const Voronoi_cells& cells,
                                const Mesh& mesh) {
  const internal::Named_mesh_elements<Mesh> named(internal::kept_input(t), mesh);
  return internal::boundaries_at(t, cells, [&](const Surface_point& p) {
    return Mesh_adaptor<Mesh>::coordinates(named.point(p));
  });
}

/*!
\brief returns the boundaries of cells as polylines in space, for programs with a soup instead of a
mesh; see the overload with a mesh.
\param t, cells see there
\param points coordinates of the vertices of the mesh that `t` was built from, in its order
*/
template <QueriedTriangulation Triangulation>
std::vector<Polyline> polylines(const Triangulation& t, const Voronoi_cells& cells,
                                const std::vector<std::array<double, 3>>& points) {
  return internal::boundaries_at(
      t, cells, [&](const Surface_point& p) { return point_in_space(t, p, points); });
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_VORONOI_VORONOI_CELLS_H
