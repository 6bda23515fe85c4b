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
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>
#include <CGAL/Intrinsic_triangulations/triangulation/metric_concepts.h>

#include <boost/graph/graph_traits.hpp>

#include <atomic>
#include <concepts>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// A vertex of a triangulation, or a point on it.
template <class Place, class Triangulation>
concept Place_on = std::convertible_to<Place, typename Triangulation::vertex_descriptor> ||
    std::same_as<Place, Surface_point> ||
    std::same_as<Place, Face_location<typename Triangulation::Mesh>>;

// A triangulation whose copy is flipped for a search: rounded flips would change the surface, and
// without a correspondence points would not be found on the copy.
template <class Triangulation>
concept Flipped_for_search = CorrespondingTriangulation<Triangulation> &&
    IntrinsicTriangulation<Triangulation> && std::copy_constructible<Triangulation> &&
    EuclideanMetric<typename Triangulation::Metric> && Triangulation::Metric::is_exact;

// Places as users give them, with which a second search begins again.
template <NumberedTriangulation Triangulation>
class Asked_places {
public:
  void clear() { places_.clear(); }
  // \param places a place, or a range of such
  template <class Places>
  void add(const Places& places) {
    if constexpr (std::convertible_to<Places, Vertex>)
      places_.push_back(Vertex(places));
    else if constexpr (Place_on<Places, Triangulation>)
      places_.push_back(places);
    else
      for (const auto& p : places) add(p);
  }
  // calls a function with each place
  template <class Function>
  void for_each(const Function& f) const {
    for (const auto& place : places_) std::visit(f, place);
  }

private:
  using Vertex = typename Triangulation::vertex_descriptor;

  std::vector<std::variant<Vertex, Surface_point, Face_location<typename Triangulation::Mesh>>>
      places_;
};

/*!
\brief is what a search reads: a triangulation, a copy of it that is Delaunay, or the faces under it
  if that is of a cover. Takes places on the triangulation there, and back if it is no copy.
*/
template <NumberedTriangulation Triangulation>
class Searched_surface {
  using Vertex = typename Triangulation::vertex_descriptor;

public:
  /// is the triangulation.
  explicit Searched_surface(const Triangulation& t) : t_(&t) {}
  /// is a copy whose edges were flipped until they are Delaunay, unless those of the triangulation
  /// are. Where flips are rounded, or nothing takes points in faces to the copy, it is the
  /// triangulation.
  static Searched_surface flipped(const Triangulation& t) {
    Searched_surface result(t);
    if constexpr (can_flip)
      if (!is_delaunay(t)) {
        const auto copy = std::make_shared<Flipped>(t);
        flip_to_delaunay(copy->triangulation);
        result.flipped_ = copy;
      }
    return result;
  }
  /// is the faces under it if it is of a double cover, else the triangulation.
  static Searched_surface faces_or_given(const Triangulation& t) {
    Searched_surface result(t);
    if constexpr (is_queried)
      if (Face_complex::is_under(t.correspondence().input()))
        result.faces_ = std::make_shared<const Face_complex>(t.correspondence().input());
    return result;
  }
  /// is the faces under it if it is of a double cover; else see `flipped()`.
  static Searched_surface on_faces(const Triangulation& t) {
    Searched_surface result = faces_or_given(t);
    return result.has_faces() ? result : flipped(t);
  }

  /// returns the triangulation.
  const Triangulation& triangulation() const { return *t_; }
  /// returns whether these are the faces under a cover.
  bool has_faces() const { return faces_ != nullptr; }
  /// returns whether it is a copy of the triangulation with other edges.
  bool is_flipped() const { return flipped_ != nullptr; }
  /// returns the tables of a search. \complexity linear
  Corner_table table() const {
    return faces_ ? faces_->table() : corner_table(flipped_ ? flipped_->triangulation : *t_);
  }
  /// returns the point at a place: on the input if these are the faces, else on the triangulation.
  /// \pre it is no copy
  Surface_point point(const Path_place& p) const {
    return faces_ ? faces_->point(p) : Surface_point{halfedge_of_corner(*t_, p.side), p.weights};
  }

  /// calls a function with vertices by number and with points in faces.
  /// \throws Invalid_input if a place is not on the triangulation
  template <class Places, class Function>
  void for_each_place(const Distance_field& field, const Places& places, const Function& f) const {
    if constexpr (std::convertible_to<Places, Vertex>) {
      on_vertex(field, Vertex(places), f);
    } else if constexpr (std::same_as<Places, Surface_point>) {
      expect_here(places);
      if (!flipped_ || corner_of(places) < 3) return on_point(*t_, field, places, f);
      if constexpr (can_flip) on_point(flipped_->triangulation, field, there(places), f);
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
  static constexpr bool can_flip = Flipped_for_search<Triangulation>;
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
        const Surface_point p{view.is_border(out) ? view.next(out ^ 1U) : out, {1, 0, 0}};
        const Path_place place = faces_->place(locate_on_input(*t_, p).value());
        return f(field.point(place.side, place.weights));
      }
    const std::uint32_t i = t_->index(v); // the same on the copy
    if (i >= field.vertices.size())
      throw Invalid_input(Element_kind::vertex, i,
                          "vertex " + std::to_string(i) +
                              " is not on the triangulation that is searched: it is one of "
                              "another; give one of this, see vertex_on_intrinsic()");
    f(i);
  }

  // A corner is a vertex. \param t the triangulation of the point
  template <class Function>
  void on_point(const Triangulation& t, const Distance_field& field, const Surface_point& p,
                const Function& f) const {
    if (const unsigned k = corner_of(p); k < 3)
      return on_vertex(field, corner(t, p.halfedge, k), f);
    if constexpr (is_queried)
      if (faces_) {
        const Path_place place = faces_->place(locate_on_input(t, p).value());
        return f(field.point(place.side, place.weights));
      }
    f(field.point(side(t, p.halfedge), p.weights));
  }

  // A copy that the searches of several threads share. Predicates make what it stores accurate.
  struct Flipped {
    explicit Flipped(const Triangulation& t) : triangulation(t) {}
    Triangulation triangulation;
    std::atomic_flag is_taken = ATOMIC_FLAG_INIT;
  };

  // While it exists, other threads wait. It is no std::lock_guard since <mutex> is long.
  struct Turn {
    explicit Turn(std::atomic_flag& f) : is_taken(f) {
      while (is_taken.test_and_set()) is_taken.wait(true);
    }
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;
    ~Turn() {
      is_taken.clear();
      is_taken.notify_one();
    }
    std::atomic_flag& is_taken;
  };

  // A point of the triangulation on the copy.
  Surface_point there(const Surface_point& p) const {
    const Turn turn(flipped_->is_taken);
    if (const std::optional<Surface_point> q = locate_on_input(*t_, p))
      if (const std::optional<Surface_point> r = locate_on_intrinsic(flipped_->triangulation, *q))
        return *r;
    throw Invalid_input(Element_kind::halfedge, p.halfedge,
                        "the point is not found after flips to Delaunay; make the search with "
                        "Polyhedral_distance::as_given(t), without them");
  }

  void expect_here(const Surface_point& p) const {
    const auto& mesh = t_->mesh();
    if (p.halfedge < 2 * t_->numbers().edge_capacity(mesh) &&
        face(t_->numbers().halfedge_at(p.halfedge), mesh) != Graph_traits::null_face())
      return;
    throw Invalid_input(Element_kind::halfedge, p.halfedge,
                        "the point is beside halfedge " + std::to_string(p.halfedge) +
                            ", which has no face on the triangulation that is searched: it is a "
                            "point of another one; give one of this, see locate_on_intrinsic()");
  }

  static std::uint32_t side(const Triangulation& t, std::uint32_t halfedge_number) {
    const typename Triangulation::Mesh& mesh = t.mesh();
    const Halfedge h = t.numbers().halfedge_at(halfedge_number);
    std::uint32_t k = 0;
    for (Halfedge g = halfedge(face(h, mesh), mesh); g != h; g = next(g, mesh)) ++k;
    return 3 * t.index(face(h, mesh)) + k;
  }

  static Vertex corner(const Triangulation& t, std::uint32_t halfedge_number, unsigned k) {
    Halfedge h = t.numbers().halfedge_at(halfedge_number);
    for (; k > 0; --k) h = next(h, t.mesh());
    return source(h, t.mesh());
  }

  const Triangulation* t_;
  std::shared_ptr<const Face_complex> faces_; // null: they are not searched
  std::shared_ptr<Flipped> flipped_;          // null: there is no copy
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_DISTANCE_SEARCHED_SURFACE_H
