// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_CURVES_INSERT_POINT_H
#define CGAL_INTRINSIC_GEODESICS_CURVES_INSERT_POINT_H

#include <CGAL/Intrinsic_geodesics/curves/GeodesicTriangulation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Sheets.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place_finder.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/tracing/within_rounding.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a vertex at a point of the input.
\tparam Triangulation the type of the triangulation
*/
template <RefinableTriangulation Triangulation>
struct Vertex_at_point {
  /// `done`, or the reason why no vertex was inserted.
  Move_status status = Move_status::done;
  /// The vertex.
  typename Triangulation::vertex_descriptor vertex{};
  /// Whether it was inserted.
  bool is_new = false;
};

namespace internal {

// The weights with which a located point is inserted or traced. It goes to a side or corner within
// 2^-44 of the longest side, 512 roundings of coordinates, as corners of needles may be 2^-40 of
// their sides apart; and where weights are below 2^-38.
template <NumberedComplex Complex>
std::array<double, 3> weights_within_rounding(const Complex& complex, const Surface_point& p) {
  return within_rounding(complex, p, 0x1p-44, 0x1p-38).weights;
}

// Finds the vertex at a point of the input, or inserts one by a function of a halfedge and weights.
template <RefinableTriangulation Triangulation, class Insert>
Vertex_at_point<Triangulation> insert_point_by(Triangulation& t, const Surface_point& p,
                                               const Insert& insert) {
  const std::optional<Surface_point> q = locate_on_intrinsic(t, p);
  if (!q) return {Move_status::not_traceable};
  const std::array<double, 3> weights =
      weights_within_rounding(Intrinsic_view<Triangulation>(t), *q);
  typename Triangulation::halfedge_descriptor h = t.numbers().halfedge_at(q->halfedge);
  for (std::size_t k = 0; k < 3; ++k, h = next(h, t.mesh()))
    if (weights[k] == 1) return {Move_status::done, source(h, t.mesh()), false};
  auto inserted = insert(h, weights);
  // rounding off its edge may move a point beyond a vertex close by
  for (std::size_t k = 0; k < 3; ++k, h = next(h, t.mesh()))
    if (inserted.status != Move_status::done && weights[(k + 2) % 3] == 0)
      inserted = insert(opposite(h, t.mesh()), {1 - weights[k], weights[k], 0});
  if (inserted.status != Move_status::done) inserted = insert(h, q->weights);
  return {inserted.status, inserted.vertex, inserted.status == Move_status::done};
}

} // namespace internal

/*!
\brief finds or inserts the vertex of the intrinsic triangulation at a point of the input.

A vertex or an edge counts as at the point if it is there up to rounding. With exact traits,
`Intrinsic_triangulation::insert_vertex()` rounds the new vertex.
\tparam Triangulation a model of `RefinableTriangulation` and of `CorrespondingTriangulation`
\param t the triangulation
\param p the point, on the input
\complexity that of `locate_on_intrinsic()` and of an insertion
*/
template <RefinableTriangulation Triangulation>
Vertex_at_point<Triangulation> insert_point(Triangulation& t, const Surface_point& p) {
  return internal::insert_point_by(t, p, [&](auto h, const std::array<double, 3>& weights) {
    return t.insert_vertex(h, weights);
  });
}

/*!
\brief finds or inserts the vertices at a point of the user's faces: on a cover, one on each sheet.

The first is that of `insert_point()`; a point at a vertex of the user has this one only. The others
are exactly at the same point, and have the same row in matrices, if the correspondence has places
on the input (see `Intrinsic_triangulation::places()`).
\tparam Triangulation a model of `RefinableTriangulation` and of `CorrespondingTriangulation`
\param t the triangulation
\param p the point on one of the sheets
\complexity that of `insert_point()` for each; on a cover, linear in the size of the input
*/
template <RefinableTriangulation Triangulation>
std::vector<Vertex_at_point<Triangulation>> insert_point_on_sheets(Triangulation& t,
                                                                   const Surface_point& p) {
  std::vector<Vertex_at_point<Triangulation>> result{insert_point(t, p)};
  const Vertex_at_point<Triangulation> first = result.front();
  if (!t.input().names().is_cover() || first.status != Move_status::done ||
      !t.is_inserted(first.vertex))
    return result;
  Surface_point place = p;
  if constexpr (internal::Knows_places<Triangulation>)
    if (t.places() != nullptr) place = t.places()->location(t.index(first.vertex));
  const internal::Sheets sheets(t.input());
  if (!sheets.is_cover()) return result;
  for (const Surface_point& other : sheets.others(place))
    result.push_back(
        internal::insert_point_by(t, other, [&](auto h, const std::array<double, 3>& weights) {
          return typename Triangulation::Session(t).insert_copy(h, weights, other);
        }));
  return result;
}

/*!
\brief finds or inserts the vertices at a place that a user names: on a cover, all of its copies.

Vertices that are inserted at points of edges and faces do not survive a refinement: refine first.
\tparam Triangulation a model of `RefinableTriangulation` and of `CorrespondingTriangulation`
\param t the triangulation
\param place the place
\throws Invalid_input as `Place_finder::append()`, or if its face has no room for a vertex there
\complexity that of `insert_point_on_sheets()`
*/
template <RefinableTriangulation Triangulation>
std::vector<typename Triangulation::vertex_descriptor> insert_place(Triangulation& t,
                                                                    const Place& place) {
  Place_finder<Triangulation> find(t);
  const Place p = normalized(t.input(), place);
  if (p.is_vertex()) return find.copies(p.vertex);
  std::vector<typename Triangulation::vertex_descriptor> result;
  for (const auto& v : insert_point_on_sheets(t, find.on_input(p).front())) {
    if (v.status != Move_status::done)
      throw Invalid_input::about(Element_kind::face, p.face,
                                 " has no room for a vertex at that point; choose another");
    result.push_back(v.vertex);
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_CURVES_INSERT_POINT_H
