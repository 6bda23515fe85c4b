// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_QUERIES_TRACE_SHORTEST_PATH_H
#define CGAL_INTRINSIC_GEODESICS_QUERIES_TRACE_SHORTEST_PATH_H

#include <CGAL/Intrinsic_geodesics/curves/insert_point.h>
#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_curve.h>
#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_to_target.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_walk.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Follows a straight piece from a place of the input to a point over the input, and adds its points
// to a curve. `strip` is memory for it.
void append_piece(const Input& input, const Tangent_vector& from, const Surface_point& to,
                  std::vector<Strip_side>& strip, Traced_curve& curve);

// Follows the straight pieces of a shortest path, each in one face of the triangulation, over the
// input.
template <class Triangulation>
class Piece_tracer {
public:
  explicit Piece_tracer(const Triangulation& t) : t_(t), input_(t.correspondence().input()) {}

  // Appends the straight piece v from p to q, of one face, to a curve over the input. Returns false
  // if the piece is not traceable.
  bool append(const Surface_point& p, const Surface_point& q, const Unscaled_vector& v,
              Traced_curve& curve) {
    auto from = tangent_to_input(t_, {p, v});
    auto to = locate_on_input(t_, q);
    if (!from || !to) return false;
    // where an edge or a vertex of the input is within rounding, the point is named on it
    from->point.weights = weights_within_rounding(input_, from->point);
    to->weights = weights_within_rounding(input_, *to);
    if (curve.points.empty()) curve.points.push_back(from->point);
    append_piece(input_, *from, *to, strip_, curve);
    return true;
  }

private:
  const Triangulation& t_;
  const Input& input_;
  std::vector<Strip_side> strip_;
};

template <class Triangulation>
class Path_over_input {
  using View = Accurate_view<Triangulation>;

public:
  explicit Path_over_input(const Triangulation& t) : t_(t), view_(t), tracer_(t) {}

  Traced_curve operator()(const Shortest_path& path) {
    Traced_curve curve;
    curve.status = path.status;
    if (path.is_on_input) { // on the faces under a cover
      curve.points = path.points;
      for (std::size_t i = 0; i + 1 < path.points.size(); ++i)
        curve.faces.push_back(t_.correspondence().input().face(path.points[i].halfedge));
    }
    for (std::size_t i = 0; !path.is_on_input && i + 1 < path.points.size(); ++i) {
      const Surface_point& p = path.points[i];
      const std::optional<Surface_point> q = in_face(path.points[i + 1], p);
      if (!q) continue; // a copy of the same vertex on a cover
      if (!tracer_.append(p, *q, vector_between(view_, p, *q), curve))
        return {Status::not_traceable, {}, {}, 0, {0}};
    }
    curve.length = path.length;
    curve.length_enclosure = {0, std::numeric_limits<double>::infinity()};
    return curve;
  }

private:
  // A point of a path, seen in the face where the piece before it lies, which begins at p.
  std::optional<Surface_point> in_face(const Surface_point& q, const Surface_point& p) const {
    const std::uint32_t f = view_.face(p.halfedge);
    const unsigned corner = corner_of(q);
    if (corner == 3 && view_.face(q.halfedge) == f && q.weights[2] != 0)
      return seen_from(view_, q, p.halfedge); // the end
    if (corner == 3) return Surface_point{q.halfedge ^ 1U, {q.weights[1], q.weights[0], 0}};
    // a vertex: the apex if the piece crosses the face
    const std::uint32_t v = view_.source(sides_of_face(view_, q.halfedge)[corner]);
    const auto sides = sides_of_face(view_, p.halfedge);
    for (const unsigned k : {2U, 1U, 0U})
      if (view_.source(sides[k]) == v && !(k == 0 && p.weights[0] == 1))
        return Surface_point{sides[k], {1, 0, 0}};
    return std::nullopt;
  }

  const Triangulation& t_;
  View view_;
  Piece_tracer<Triangulation> tracer_;
};

} // namespace internal

/*!
\brief traces a shortest path over the input.
\tparam Triangulation a model of `CorrespondingTriangulation`
\param t the triangulation of the distances
\param path the result of `Polyhedral_distance::shortest_path()`
\return the curve; `polyline()` and `face_locations()` map it to the user's mesh. The status is that
of the path; `inaccurate` also if rounding may have moved a piece out of its faces; or
`not_traceable`
\complexity linear in the number of crossings, and that of `locate_on_input()` for each point
*/
template <QueriedTriangulation Triangulation>
Traced_curve trace_shortest_path(const Triangulation& t, const Shortest_path& path) {
  return internal::Path_over_input<Triangulation>(t)(path);
}

/// returns the points of a shortest path in space: where it crosses edges of the user's mesh and of
/// the triangulation; see `trace_shortest_path()` and `polyline()`.
template <QueriedTriangulation Triangulation, ReadableFaceGraph Mesh>
auto polyline(const Triangulation& t, const Shortest_path& path, const Mesh& mesh) {
  return polyline(t, trace_shortest_path(t, path), mesh);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_QUERIES_TRACE_SHORTEST_PATH_H
