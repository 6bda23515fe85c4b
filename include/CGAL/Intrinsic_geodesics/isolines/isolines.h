// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_ISOLINES_ISOLINES_H
#define CGAL_INTRINSIC_GEODESICS_ISOLINES_ISOLINES_H

#include <CGAL/Intrinsic_geodesics/isolines/Lines_on_surface.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_curve.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_shortest_path.h>
#include <CGAL/Intrinsic_triangulations/IO/curves/write_polylines.h>
#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// locates a point on an edge.
struct Edge_point {
  /// Number of a halfedge that has a face.
  std::uint32_t halfedge = 0;
  /// 0 at its source, 1 at its target.
  double parameter = 0;

  /// returns the point in the face of the halfedge.
  Surface_point surface_point() const { return {halfedge, {1 - parameter, parameter, 0}}; }
};

/*!
\brief is a line on which a piecewise linear function has one value.

Larger values are on its left. See `isolines()`.
*/
struct Isoline {
  /// The value.
  double level = 0;
  /// Which of the levels it is: its place among them.
  std::size_t number_of_level = 0;
  /// Whether a straight piece joins the last point with the first one. Other lines begin and end on
  /// the border.
  bool is_closed = false;
  /// A point on each edge that the line crosses, in order. The piece after a point lies in the face
  /// of its halfedge; the last point of a line that is not closed lies in the face before it.
  std::vector<Edge_point> points;

  /// returns the number of straight pieces, each in a face.
  std::size_t number_of_pieces() const { return is_closed ? points.size() : points.size() - 1; }
  /// returns the point where a piece leaves its face, on a side of that face. \pre
  /// `piece < number_of_pieces()`
  Edge_point end_of_piece(std::size_t piece) const;
};

namespace internal {

// A triangulated surface, by numbers of halfedges, and a function on it.
struct Function_on_halfedges {
  // a halfedge of each face
  std::vector<std::uint32_t> of_face;
  // the next halfedge; `Gluing::none` on the border
  std::vector<std::uint32_t> next;
  // the value at the source of each halfedge that has a face
  std::vector<double> value;

  void resize(std::uint32_t edges);
  void add_face(const std::array<std::uint32_t, 3>& halfedges, const std::array<double, 3>& values);
};

// The value of a row. Throws std::invalid_argument if there is none, or it is NaN.
double value_of_row(std::span<const double> values, std::uint32_t row);

// `progress` is called before each level, with the number of those that are done.
std::vector<Isoline> trace_isolines(const Function_on_halfedges& f, std::span<const double> levels,
                                    const std::function<bool(std::size_t)>& progress);

// Reads a function; `row` returns the row with the value of a vertex.
template <class Mesh, class Numbers, class Row>
Function_on_halfedges function_on_halfedges(const Mesh& mesh, const Numbers& number,
                                            std::span<const double> values, const Row& row) {
  Function_on_halfedges all;
  all.resize(number.edge_capacity(mesh));
  for (const auto f : faces(mesh)) {
    std::array<std::uint32_t, 3> sides{};
    std::array<double, 3> corners{};
    auto h = halfedge(f, mesh);
    for (std::size_t k = 0; k < 3; ++k, h = next(h, mesh)) {
      sides[k] = number.halfedge(h);
      corners[k] = value_of_row(values, row(source(h, mesh)));
    }
    if (h != halfedge(f, mesh))
      throw std::invalid_argument("isolines need triangles; face " +
                                  std::to_string(number.face(f)) + " is a polygon");
    all.add_face(sides, corners);
  }
  return all;
}

// Adds a line through points to polylines, unless its length is zero. Points that repeat the last
// one are left out.
void add_polyline(std::size_t level, bool is_closed,
                  const std::vector<std::array<double, 3>>& points,
                  std::vector<Polyline>& polylines);

} // namespace internal

/// returns so many levels, evenly between the least and the greatest finite value; none without
/// finite values.
std::vector<double> even_levels(std::span<const double> values, std::size_t count);

/*!
\brief finds the lines on which a function has given values.

The function is linear in each face. All decisions are comparisons of a value with a level, thus
exact: a vertex is *above* if its value is at least the level, else *below*. A line crosses just the
edges between a vertex below and one above, each once, and has one piece in each face with both. So
it is closed, or ends on the border, and no piece dangles, also where vertices or edges are on the
level: there consecutive points coincide. The line of a level that is the largest value near a
vertex has no length: all its points are the vertex.

Infinite values, as distances where a search did not arrive, are above or below all levels. A line
passes between them and finite values through the finite vertex.

\tparam Triangulation a model of `NumberedTriangulation`; of a cover, lines are on the cover
\param t the triangulation
\param values a number per row, see `Intrinsic_triangulation::input_vertex()`
\param levels the levels, in any order
\param np an optional named parameter:
  - `visitor(v)`: `v.progress(n)` is called before each level with the number of those that are
    done, a `std::size_t`; it returns whether to go on
\return the lines, level by level; halfedges are those of `t`, by number. If the visitor ends the
  work, those of the levels that are done.
\throws std::invalid_argument if a level is not finite, or a vertex has no value or one that is NaN
\complexity linear in the number of faces for each level, and in the number of pieces
*/
template <NumberedTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
std::vector<Isoline> isolines(const Triangulation& t, std::span<const double> values,
                              std::span<const double> levels,
                              const NP& np = parameters::default_values()) {
  internal::expect_names<internal::tags::visitor>(np);
  return internal::trace_isolines(
      internal::function_on_halfedges(t.mesh(), t.numbers(), values,
                                      [&](const auto v) { return t.input_vertex(v); }),
      levels, internal::progress_of(np));
}

/*!
\brief finds the lines on which a function on a mesh of triangles has given values; see the overload
for triangulations.
\tparam Mesh a model of `ReadableFaceGraph`
\param mesh the mesh
\param values a number per vertex, by its number in `Mesh_adaptor<Mesh>`
\param levels the levels
\param np see the overload for triangulations
\return the lines; halfedges are those of `mesh`, by number
\throws std::invalid_argument also if a face has more than three sides
*/
template <ReadableFaceGraph Mesh, NamedParameters NP = parameters::Parameters<>>
std::vector<Isoline> isolines(const Mesh& mesh, std::span<const double> values,
                              std::span<const double> levels,
                              const NP& np = parameters::default_values()) {
  internal::expect_names<internal::tags::visitor>(np);
  const Mesh_adaptor<Mesh> number(mesh);
  return internal::trace_isolines(
      internal::function_on_halfedges(mesh, number, values,
                                      [&](const auto v) { return number.vertex(v); }),
      levels, internal::progress_of(np));
}

/*!
\brief returns the length of an isoline, in the units of the input.
\tparam Triangulation a model of `NumberedTriangulation`
\param t the triangulation
\param line one of the lines that `isolines()` found on `t`
\complexity linear
*/
template <NumberedTriangulation Triangulation>
double length_of_isoline(const Triangulation& t, const Isoline& line) {
  const internal::Accurate_view<Triangulation> view(t);
  double sum = 0;
  for (std::size_t i = 0; i < line.number_of_pieces(); ++i) {
    const auto v =
        vector_between(view, line.points[i].surface_point(), line.end_of_piece(i).surface_point());
    sum += std::hypot(v[0], v[1]);
  }
  return sum;
}

/*!
\brief traces an isoline of a triangulation over its input.
\tparam Triangulation a model of `CorrespondingTriangulation`
\param t the triangulation
\param line one of the lines that `isolines()` found on `t`
\return its way, to the first point again if it is closed: `polyline()` and `face_locations()` take
it to the user's mesh. Pieces of length zero are left out; nothing is left of a line of length zero.
\complexity see `trace_shortest_path()`
*/
template <QueriedTriangulation Triangulation>
Traced_curve trace_isoline(const Triangulation& t, const Isoline& line) {
  const internal::Accurate_view<Triangulation> view(t);
  internal::Piece_tracer<Triangulation> tracer(t);
  Traced_curve curve;
  for (std::size_t i = 0; i < line.number_of_pieces(); ++i) {
    const Surface_point p = line.points[i].surface_point();
    const Surface_point q = line.end_of_piece(i).surface_point();
    const auto v = vector_between(view, p, q);
    if (v[0] == 0 && v[1] == 0) continue;
    if (!tracer.append(p, q, v, curve)) return {Status::not_traceable, {}, {}, 0, {0}};
  }
  curve.length = length_of_isoline(t, line);
  curve.length_enclosure = {0, std::numeric_limits<double>::infinity()};
  return curve;
}

/*!
\brief traces isolines of a triangulation over its input: each once, also if the input is a double
cover of the user's faces.

Of a cover, they end where more than two faces meet; a line that changes sides may come in several
parts.
\tparam Triangulation a model of `CorrespondingTriangulation`
\param t the triangulation
\param lines what `isolines()` found on `t`
\param np an optional named parameter:
  - `visitor(v)`: `v.progress(n)` is called before each line with the number of those that are done;
    it returns whether to go on
\return their ways; lines of length zero are left out
\complexity see `trace_isoline()`; of a cover, linear in its size also
*/
template <QueriedTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
std::vector<Traced_isoline> trace_isolines(const Triangulation& t,
                                           const std::vector<Isoline>& lines,
                                           const NP& np = parameters::default_values()) {
  internal::expect_names<internal::tags::visitor>(np);
  const std::function<bool(std::size_t)> progress = internal::progress_of(np);
  const internal::Lines_on_surface once(t.correspondence().input());
  std::vector<Traced_isoline> result;
  for (std::size_t i = 0; i < lines.size() && progress(i); ++i)
    if (Traced_curve way = trace_isoline(t, lines[i]); !way.points.empty())
      once.add({lines[i].level, lines[i].number_of_level, lines[i].is_closed, std::move(way)},
               result);
  return result;
}

namespace internal {

// Isolines as polylines; `point` takes points of the input to coordinates.
template <class Triangulation, class Point_of>
std::vector<Polyline> polylines_at(const Triangulation& t, const std::vector<Isoline>& lines,
                                   const Point_of& point) {
  std::vector<Polyline> result;
  for (Traced_isoline& line : trace_isolines(t, lines)) {
    if (line.is_closed) line.curve.points.pop_back(); // the first one again
    std::vector<std::array<double, 3>> points;
    for (const Surface_point& p : line.curve.points) points.push_back(point(p));
    add_polyline(line.number_of_level, line.is_closed, points, result);
  }
  return result;
}

} // namespace internal

/*!
\brief returns isolines of a triangulation as polylines in space, which `write_polylines()` writes.
\tparam Triangulation a model of `CorrespondingTriangulation`
\param t the triangulation
\param lines what `isolines()` found on `t`
\param mesh the mesh that `t` was built from; its faces may be polygons
\return the polylines, labelled by the numbers of their levels, see `trace_isolines()`; lines that
`Signposts` lost are left out
\throws Invalid_input if the mesh is another one
*/
template <QueriedTriangulation Triangulation, ReadableFaceGraph Mesh>
std::vector<Polyline> polylines(const Triangulation& t, const std::vector<Isoline>& lines,
                                const Mesh& mesh) {
  const internal::Named_mesh_elements<Mesh> named(internal::kept_input(t), mesh);
  return internal::polylines_at(t, lines, [&](const Surface_point& p) {
    return Mesh_adaptor<Mesh>::coordinates(named.point(p));
  });
}

/*!
\brief returns isolines of a triangulation as polylines in space, for programs with a soup instead
of a mesh; see the overload with a mesh.
\param t, lines see there
\param points coordinates of the vertices of the mesh that `t` was built from, in its order
*/
template <QueriedTriangulation Triangulation>
std::vector<Polyline> polylines(const Triangulation& t, const std::vector<Isoline>& lines,
                                const std::vector<std::array<double, 3>>& points) {
  return internal::polylines_at(
      t, lines, [&](const Surface_point& p) { return point_in_space(t, p, points); });
}

/*!
\brief returns isolines of a mesh as polylines in space.
\tparam Mesh a model of `ReadableFaceGraph`
\param lines what `isolines()` found on `mesh`
\param mesh the mesh
\return the polylines, labelled by the numbers of their levels; lines of length zero are left out
\complexity linear
*/
template <ReadableFaceGraph Mesh>
std::vector<Polyline> polylines(const std::vector<Isoline>& lines, const Mesh& mesh) {
  const Mesh_adaptor<Mesh> number(mesh);
  const auto map = Mesh_adaptor<Mesh>::point_map(mesh);
  std::vector<Polyline> result;
  for (const Isoline& line : lines) {
    std::vector<std::array<double, 3>> points;
    for (const Edge_point& p : line.points) {
      const auto h = number.halfedge_at(p.halfedge);
      const auto a = Mesh_adaptor<Mesh>::coordinates(get(map, source(h, mesh)));
      const auto b = Mesh_adaptor<Mesh>::coordinates(get(map, target(h, mesh)));
      std::array<double, 3> x{};
      for (std::size_t k = 0; k < 3; ++k) x[k] = std::lerp(a[k], b[k], p.parameter);
      points.push_back(x);
    }
    internal::add_polyline(line.number_of_level, line.is_closed, points, result);
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_ISOLINES_ISOLINES_H
