// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_DISTANCE_SEARCHED_SURFACE_H
#define CGAL_INTRINSIC_GEODESICS_DISTANCE_SEARCHED_SURFACE_H

#include <CGAL/Intrinsic_geodesics/distance/Corner_table.h>
#include <CGAL/Intrinsic_geodesics/distance/Distance_field.h>
#include <CGAL/Intrinsic_geodesics/distance/Face_complex.h>
#include <CGAL/Intrinsic_geodesics/distance/trace_back.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <CGAL/assertions.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <memory>

namespace CGAL::Intrinsic_triangulations::internal {

// A vertex of a triangulation, or a point on it.
template <class Place, class Triangulation>
concept Place_on = std::convertible_to<Place, typename Triangulation::vertex_descriptor> ||
    std::same_as<Place, Surface_point> ||
    std::same_as<Place, Face_location<typename Triangulation::Mesh>>;

/*!
\brief is what a search reads: a triangulation, or the faces under it if that is of a cover. Takes
  places on the triangulation there, and back.
*/
template <NumberedTriangulation Triangulation>
class Searched_surface {
  using Vertex = typename Triangulation::vertex_descriptor;

public:
  /// is the triangulation.
  explicit Searched_surface(const Triangulation& t) : t_(&t) {}
  /// is the faces under it if it is of a double cover.
  static Searched_surface on_faces(const Triangulation& t) {
    Searched_surface result(t);
    if constexpr (is_queried)
      if (Face_complex::is_under(t.correspondence().input()))
        result.faces_ = std::make_shared<const Face_complex>(t.correspondence().input());
    return result;
  }

  /// returns the triangulation.
  const Triangulation& triangulation() const { return *t_; }
  /// returns whether these are the faces under a cover.
  bool has_faces() const { return faces_ != nullptr; }
  /// returns the tables of a search. \complexity linear
  Corner_table table() const { return faces_ ? faces_->table() : corner_table(*t_); }
  /// returns the point at a place: on the input if these are the faces, else on the triangulation.
  Surface_point point(const Path_place& p) const {
    return faces_ ? faces_->point(p) : Surface_point{halfedge_of_corner(*t_, p.side), p.weights};
  }

  /// calls a function with vertices by number and with points in faces.
  template <class Places, class Function>
  void for_each_place(const Distance_field& field, const Places& places, const Function& f) const {
    if constexpr (std::convertible_to<Places, Vertex>) {
      on_vertex(field, Vertex(places), f);
    } else if constexpr (std::same_as<Places, Surface_point>) {
      for (std::uint32_t k = 0; k < 3; ++k) // a corner is a vertex
        if (places.weights[(k + 1) % 3] == 0 && places.weights[(k + 2) % 3] == 0)
          return on_vertex(field, corner(places.halfedge, k), f);
      f(point_in_face(field, places));
    } else if constexpr (std::same_as<Places, Face_location<typename Triangulation::Mesh>>) {
      for_each_place(field, surface_point(*t_, places), f);
    } else {
      static_assert(
          std::ranges::range<const Places>,
          "sources and targets are vertices of t.mesh(), objects Surface_point or Face_location on "
          "it, or ranges of them; a vertex of the user's mesh is vertex_on_intrinsic(t, v, mesh), "
          "a place on it *locate_on_intrinsic(t, place, mesh)");
      for (const auto& p : places) for_each_place(field, p, f);
    }
  }

private:
  static constexpr bool is_queried = CorrespondingTriangulation<Triangulation>;
  using Halfedge = typename Triangulation::halfedge_descriptor;
  using Graph_traits = boost::graph_traits<typename Triangulation::Mesh>;

  // Inserted vertices are points in faces of the user.
  template <class Function>
  void on_vertex(const Distance_field& field, Vertex v, const Function& f) const {
    if constexpr (is_queried)
      if (faces_) {
        if (!t_->is_inserted(v)) return f(t_->input_vertex(v));
        const Intrinsic_view<Triangulation> view(*t_);
        const std::uint32_t out = view.outgoing_halfedge(t_->index(v));
        return f(
            point_in_face(field, {view.is_border(out) ? view.next(out ^ 1U) : out, {1, 0, 0}}));
      }
    f(t_->index(v));
  }

  Point_in_face point_in_face(const Distance_field& field, const Surface_point& p) const {
    if constexpr (is_queried)
      if (faces_) {
        const Path_place place = faces_->place(locate_on_input(*t_, p).value());
        return field.point(place.side, place.weights);
      }
    return field.point(side(p.halfedge), p.weights);
  }

  std::uint32_t side(std::uint32_t halfedge_number) const {
    const typename Triangulation::Mesh& mesh = t_->mesh();
    const Halfedge h = t_->numbers().halfedge_at(halfedge_number);
    CGAL_precondition(face(h, mesh) != Graph_traits::null_face());
    std::uint32_t k = 0;
    for (Halfedge g = halfedge(face(h, mesh), mesh); g != h; g = next(g, mesh)) ++k;
    return 3 * t_->index(face(h, mesh)) + k;
  }

  Vertex corner(std::uint32_t halfedge_number, std::uint32_t k) const {
    Halfedge h = t_->numbers().halfedge_at(halfedge_number);
    for (; k > 0; --k) h = next(h, t_->mesh());
    return source(h, t_->mesh());
  }

  const Triangulation* t_;
  std::shared_ptr<const Face_complex> faces_; // null: the triangulation is searched
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_DISTANCE_SEARCHED_SURFACE_H
