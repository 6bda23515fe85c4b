// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_INPUT_SURFACE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_INPUT_SURFACE_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/as_gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>

#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief keeps the triangulation that the intrinsic one started from: connectivity, squared lengths and
quadruple areas, in its numbering and its scaled units.

It never changes; a correspondence shares it with its copies. All elements are named by their numbers;
halfedges `2e` and `2e + 1` are the sides of edge `e`.
\cgalModels{NumberedComplex}
*/
class Input_surface {
public:
  /// constructs the empty surface.
  Input_surface() = default;

  /*!
  \brief copies a triangulation before its first move.
  \tparam Triangulation an instance of `Intrinsic_triangulation`
  \complexity linear
  */
  template <class Triangulation>
  explicit Input_surface(const Triangulation& t)
      : Input_surface(copy_of(t.mesh(), t.numbers()), t.metric()) {}

  /*!
  \brief takes a connectivity and copies a metric of it.
  \tparam Metric a model of `IntrinsicMetric`
  \complexity linear
  */
  template <class Metric>
  Input_surface(Gluing_map mesh, const Metric& metric) : mesh_(std::move(mesh)) {
    squared_length_.reserve(mesh_.number_of_edges());
    for (std::uint32_t e = 0; e < mesh_.number_of_edges(); ++e)
      squared_length_.push_back(metric.approximate_squared_length(e));
    quadruple_area_.reserve(mesh_.number_of_faces());
    for (std::uint32_t f = 0; f < mesh_.number_of_faces(); ++f)
      quadruple_area_.push_back(metric.approximate_quadruple_area(f));
  }

  /// copies a mesh in the numbers that an adaptor gives its elements. \complexity linear
  template <class Mesh, class Numbers>
  static Gluing_map copy_of(const Mesh& mesh, const Numbers& numbers) {
    if constexpr (std::is_same_v<Mesh, Gluing_map>)
      return mesh;
    else
      return internal::numbered_copy(mesh, numbers);
  }

  /// returns the connectivity.
  const Gluing_map& mesh() const { return mesh_; }
  /// returns the number of vertices.
  std::uint32_t number_of_vertices() const { return mesh_.number_of_vertices(); }
  /// returns the number of halfedges.
  std::uint32_t number_of_halfedges() const { return mesh_.number_of_halfedges(); }
  /// returns the halfedge after `h`.
  std::uint32_t next(std::uint32_t h) const { return mesh_.next({h}).index; }
  /// returns the other side of the edge of `h`.
  static std::uint32_t opposite(std::uint32_t h) { return h ^ 1U; }
  /// tells whether `h` has no face.
  bool is_border(std::uint32_t h) const { return face(h) == Gluing::none; }
  /// returns the face of `h`, `Gluing::none` on the border.
  std::uint32_t face(std::uint32_t h) const { return mesh_.face({h}).index; }
  /// returns the vertex that `h` starts from.
  std::uint32_t source(std::uint32_t h) const {
    return mesh_.source(Gluing_map::Halfedge{h}).index;
  }
  /// returns the vertex that `h` points to.
  std::uint32_t target(std::uint32_t h) const {
    return mesh_.target(Gluing_map::Halfedge{h}).index;
  }
  /// returns a halfedge of face `f`.
  std::uint32_t halfedge_of_face(std::uint32_t f) const {
    return mesh_.halfedge(Gluing_map::Face{f}).index;
  }
  /// returns a halfedge that starts at vertex `v`, the one whose right side is the border if there is
  /// one. \pre `v` is not isolated
  std::uint32_t outgoing_halfedge(std::uint32_t v) const {
    return mesh_.halfedge(Gluing_map::Vertex{v}).index ^ 1U;
  }
  /// returns the squared length of edge `e`, in scaled units.
  double squared_length(std::uint32_t e) const { return squared_length_[e]; }
  /// returns the quadruple area of face `f`, in scaled units.
  double quadruple_area(std::uint32_t f) const { return quadruple_area_[f]; }

private:
  Gluing_map mesh_;
  std::vector<double> squared_length_;
  std::vector<double> quadruple_area_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_INPUT_SURFACE_H
