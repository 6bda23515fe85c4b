// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_PLACES_PLACE_FINDER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_PLACES_PLACE_FINDER_H

#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Sheets.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Twin_points.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Vertex_copies.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// The same vector, at a point with one name: on an edge it may be in the frame of the other face.
// At a corner it keeps its frame.
Tangent_vector with_one_name(const Input& input, const Tangent_vector& v);

} // namespace internal

/*!
\brief finds the vertices and points of a triangulation at places that a user names.

This is the one way from a place to the triangulation: a point has the same result whichever face
names it, and on a cover a place has a vertex or point on every sheet.

\tparam Triangulation a model of `CorrespondingTriangulation`
*/
template <QueriedTriangulation Triangulation>
class Place_finder {
  using Mesh = typename Triangulation::Mesh;

public:
  /// Vertex of the triangulation.
  using vertex_descriptor = typename Triangulation::vertex_descriptor;

  /// prepares the search on a triangulation, which must outlive this object unchanged.
  explicit Place_finder(const Triangulation& t) : t_(t) {}

  /*!
  \brief returns the vertices of a row: one, on a cover all copies of the user's vertex. A point of
  a cloud at the place of an earlier one has the vertex of that.
  \param row the number of one of the user's vertices, or the row of an inserted one
  \throws Invalid_input naming a vertex that does not exist, or has no face
  \complexity that of `vertex_of_row()` for each; the first inserted one needs linear time
  */
  std::vector<vertex_descriptor> copies(std::uint32_t row) {
    std::vector<vertex_descriptor> result =
        row < t_.input().number_of_rows() ? internal::copies_of_row(t_, row) : inserted(row);
    std::erase_if(result, [this](vertex_descriptor v) {
      return halfedge(v, t_.mesh()) == boost::graph_traits<Mesh>::null_halfedge();
    });
    if (!result.empty()) return result;
    if (const std::uint32_t twin = Twin_points(t_).row(row); twin != row) return copies(twin);
    throw Invalid_input::about(Element_kind::vertex, row,
                               " is isolated: no face has it; choose another");
  }

  /// returns the vertex of a row; on a cover, the first copy. \throws Invalid_input as `copies()`
  vertex_descriptor vertex(std::uint32_t row) { return copies(row).front(); }

  /*!
  \brief returns the points of the input at a place in a face, one on each sheet.
  \param place the place, normalized, in a face
  \complexity that of `normalized()`; on a cover, also the number of copies, and for the first place
    linear
  */
  std::vector<Surface_point> on_input(const Place& place) {
    const Input& input = t_.input();
    std::vector<Surface_point> result{internal::with_one_name(input, point_on_input(input, place))};
    if (!input.names().is_cover()) return result;
    if (!sheets_) sheets_.emplace(input);
    if (!sheets_->is_cover()) return result;
    for (const Surface_point& other : sheets_->others(result.front()))
      result.push_back(internal::with_one_name(input, other));
    if (result.front().weights[2] == 0) // on an edge, of faces that have no order
      std::sort(result.begin(), result.end(), [](const Surface_point& p, const Surface_point& q) {
        return p.halfedge < q.halfedge;
      });
    return result;
  }

  /// appends the points of the triangulation at a place: on a cover, one on each sheet, and at a
  /// vertex one at each copy.
  /// \throws Invalid_input as `normalized()` and `copies()`
  /// \complexity that of `locate_on_intrinsic()` for each
  void append(const Place& place, std::vector<Surface_point>& points) {
    const Place p = normalized(t_.input(), place);
    if (p.is_vertex()) {
      for (const vertex_descriptor v : copies(p.vertex)) points.push_back(corner_at(v));
      return;
    }
    for (const Surface_point& sheet : on_input(p)) {
      const std::optional<Surface_point> q = locate_on_intrinsic(t_, sheet);
      if (!q)
        throw Invalid_input(Element_kind::face, p.face,
                            "the point in face " + std::to_string(p.face) +
                                " is not found on the triangulation; choose another");
      points.push_back(*q);
    }
  }

  /// returns the points of the triangulation at a place, see `append()`.
  std::vector<Surface_point> points(const Place& place) {
    std::vector<Surface_point> result;
    append(place, result);
    return result;
  }

  /// returns the points of the triangulation at places, in their order.
  std::vector<Surface_point> points(const std::vector<Place>& places) {
    std::vector<Surface_point> result;
    for (const Place& p : places) append(p, result);
    return result;
  }

  /*!
  \brief takes a vector in the frame of the face that names a place to the triangulation.
  \param place the place, normalized
  \param vector along the first side of the face, and to the left of it
  \return the vector, in the frame of a face there; on a cover, on the front
  \pre the place has a face
  \complexity that of `tangent_to_intrinsic()`
  */
  Tangent_vector tangent(const Place& place, const Unscaled_vector& vector) const {
    const Input& input = t_.input();
    return *tangent_to_intrinsic(
        t_, internal::with_one_name(input, {point_on_input(input, place), vector}));
  }

private:
  // a corner of a face
  Surface_point corner_at(vertex_descriptor v) const {
    const Intrinsic_view<Triangulation> view(t_);
    const std::uint32_t h = view.outgoing_halfedge(t_.index(v));
    return {view.is_border(h) ? view.next(h ^ 1U) : h, {1, 0, 0}};
  }

  std::vector<vertex_descriptor> inserted(std::uint32_t row) {
    if (inserted_.empty())
      for (const vertex_descriptor v : vertices(t_.mesh()))
        if (t_.is_inserted(v)) inserted_[t_.input_vertex(v)].push_back(v);
    if (const auto found = inserted_.find(row); found != inserted_.end()) return found->second;
    throw Invalid_input(Element_kind::vertex, row,
                        "there is no vertex " + std::to_string(row) + "; numbers are below " +
                            std::to_string(t_.number_of_vertices()));
  }

  const Triangulation& t_;
  std::map<std::uint32_t, std::vector<vertex_descriptor>> inserted_; // by rows
  std::optional<internal::Sheets> sheets_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_PLACES_PLACE_FINDER_H
