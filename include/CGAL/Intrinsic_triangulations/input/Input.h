// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_INPUT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_INPUT_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/input/Element_names.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/input/Planar_polygons.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// How degenerate faces of the input are treated.
enum class Mollification {
  none,            ///< the metric stays as it is
  automatic,       ///< `squared_lengths`, only where flips cannot remove the degenerate faces
  lengths,         ///< an epsilon is added to all lengths (§4.7 of the course)
  squared_lengths, ///< a delta is added to all squared lengths
  /// `lengths`, only where a face is so near to having no area that doubles lose most of their digits, see
  /// `has_nearly_degenerate_face()`: for inexact arithmetic
  nearly_degenerate
};

/*!
\brief reports what was done about degenerate faces.
*/
struct Mollification_report {
  /// What was applied: `none`, `lengths` or `squared_lengths`.
  Mollification kind = Mollification::none;
  /// What was added to the lengths (`lengths`) or squared lengths (`squared_lengths`), in the units
  /// of the input.
  double delta = 0;
};

/*!
\brief reports what was found in the input and done about it.
*/
struct Input_report {
  /// Input faces of zero area, counted exactly.
  std::size_t degenerate_faces = 0;
  /// Treatment of degenerate faces.
  Mollification_report mollification;
  /// Whether faces and vertices were renumbered for locality.
  bool renumbered = false;
  /// Number of polygonal faces that were triangulated; faces of the report are numbered after that.
  std::size_t triangulated_polygons = 0;
  /// Number of faces of the user that were turned around, since they disagreed with their neighbours.
  std::size_t reversed_faces = 0;
};

/*!
\brief is the surface that an intrinsic triangulation was built from: connectivity, exact metric, the
user's names of its elements, and what was done to it.

The triangulation owns it, shared with its copies and with all that reads it: metric, correspondence,
queries, certificates and files. It never changes. Numbers of vertices, edges and faces are those of the
triangulation before its first move; halfedges `2e` and `2e + 1` are the sides of edge `e`.

Connectivity, lengths and areas are kept where a correspondence needs them, see `has_surface()`: to copy them
costs a triangulation without one as much as its flips.

A triangulation that was read from a file has the input of the one that was written, with its surface if the file
says how the two lie on each other; if not, names are all that is known.
\cgalModels{NumberedComplex}
*/
class Input {
public:
  /// constructs the empty surface.
  Input() = default;

  /*!
  \brief takes the parts of the surface.
  \param mesh the connectivity
  \param metric what defines lengths and areas
  \param names the numbers in the user's mesh
  */
  Input(Gluing_map mesh, Input_metric metric, Input_names names = {})
      : mesh_(std::move(mesh)), number_of_vertices_(mesh_.number_of_vertices()),
        metric_(std::move(metric)), names_(std::move(names)) {}

  /// returns the connectivity. \pre `has_surface()`, for all that asks for edges or faces
  const Gluing_map& mesh() const { return mesh_; }
  /// returns what defines lengths and areas exactly.
  const Input_metric& metric() const { return metric_; }
  /// tells whether `metric()` defines the lengths of the faces of `mesh()`, which it does if there are any but those
  /// that users put together. \complexity linear
  bool is_defined_by_metric() const {
    if (metric_.number_of_faces() != number_of_faces()) return false;
    for (std::uint32_t f = 0; f < number_of_faces(); ++f) {
      std::uint32_t h = halfedge_of_face(f);
      for (const std::uint32_t name : metric_.sides(f)) {
        if (name != (metric_.is_embedded() ? source(h) : h / 2)) return false;
        h = next(h);
      }
    }
    return true;
  }
  /// returns how the user's mesh numbers the vertices, edges and faces.
  const Input_names& names() const { return names_; }
  /// returns what was done to the input.
  const Input_report& report() const { return report_; }
  /// returns the user's faces that became planar polygons.
  const Planar_polygons& planar_polygons() const { return planar_polygons_; }
  /// returns s, where coordinates are scaled by 2^s and squared lengths by 4^s.
  int scale_exponent() const { return metric_.scale_exponent(); }

  /// returns the number of vertices.
  std::uint32_t number_of_vertices() const { return number_of_vertices_; }
  /// returns the number of the user's vertices: fewer on a cover, where vertices are copies of them.
  std::uint32_t number_of_rows() const { return names_.number_of_rows(number_of_vertices_); }
  /// returns the number of edges.
  std::uint32_t number_of_edges() const { return mesh_.number_of_edges(); }
  /// returns the number of halfedges.
  std::uint32_t number_of_halfedges() const { return mesh_.number_of_halfedges(); }
  /// returns the number of faces.
  std::uint32_t number_of_faces() const { return mesh_.number_of_faces(); }
  /// returns a halfedge of face `f`.
  std::uint32_t halfedge_of_face(std::uint32_t f) const {
    return mesh_.halfedge(Gluing_map::Face{f}).index;
  }
  /// returns the other side of the edge of `h`.
  static std::uint32_t opposite(std::uint32_t h) { return h ^ 1U; }
  /// \cond the functions of `NumberedComplex`; lengths and areas only if `has_surface()`
  std::uint32_t next(std::uint32_t h) const { return mesh_.next({h}).index; }
  bool is_border(std::uint32_t h) const { return face(h) == Gluing::none; }
  std::uint32_t face(std::uint32_t h) const { return mesh_.face({h}).index; }
  std::uint32_t source(std::uint32_t h) const {
    return mesh_.source(Gluing_map::Halfedge{h}).index;
  }
  std::uint32_t target(std::uint32_t h) const {
    return mesh_.target(Gluing_map::Halfedge{h}).index;
  }
  std::uint32_t outgoing_halfedge(std::uint32_t v) const {
    return mesh_.halfedge(Gluing_map::Vertex{v}).index ^ 1U;
  }
  double squared_length(std::uint32_t e) const { return squared_length_[e]; }
  double quadruple_area(std::uint32_t f) const { return quadruple_area_[f]; }
  /// \endcond
  /// tells whether connectivity, lengths and areas are kept: those of a triangulation with correspondence are.
  bool has_surface() const { return !squared_length_.empty(); }

  /// \name Construction
  /// A triangulation that is being built completes its input; afterwards all see it const.
  /// @{

  /// keeps the lengths and areas that a metric of the surface has, as doubles.
  /// \tparam Metric a model of `IntrinsicMetric` \complexity linear
  template <class Metric>
  void keep_values(const Metric& metric) {
    squared_length_.clear();
    quadruple_area_.clear();
    squared_length_.reserve(number_of_edges());
    quadruple_area_.reserve(number_of_faces());
    for (std::uint32_t e = 0; e < number_of_edges(); ++e)
      squared_length_.push_back(metric.approximate_squared_length(e));
    for (std::uint32_t f = 0; f < number_of_faces(); ++f)
      quadruple_area_.push_back(metric.approximate_quadruple_area(f));
  }
  /// gives the connectivity away.
  Gluing_map release_mesh() { return std::exchange(mesh_, {}); }
  /// changes what defines lengths and areas.
  void set_metric(Input_metric metric) { metric_ = std::move(metric); }
  /// reports what was done to the input.
  void set_report(const Input_report& report) { report_ = report; }
  /// tells which of the user's faces became planar polygons.
  void set_planar_polygons(Planar_polygons polygons) { planar_polygons_ = std::move(polygons); }
  /// @}

private:
  Gluing_map mesh_;
  std::uint32_t number_of_vertices_ = 0;
  Input_metric metric_;
  Input_names names_;
  Planar_polygons planar_polygons_;
  Input_report report_;
  std::vector<double> squared_length_;
  std::vector<double> quadruple_area_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_INPUT_H
