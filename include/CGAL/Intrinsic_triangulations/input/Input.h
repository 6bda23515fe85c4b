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
  /// `lengths`, only where a face is so near to having no area that doubles lose most of their
  /// digits, see `has_nearly_degenerate_face()`: for inexact arithmetic
  nearly_degenerate
};

/*!
\brief reports what was done about degenerate faces.
*/
struct Mollification_report {
  /// The applied mollification: `none`, `lengths` or `squared_lengths`.
  Mollification kind = Mollification::none;
  /// The amount added to the lengths (`lengths`) or squared lengths (`squared_lengths`), in the
  /// units of the input.
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
  /// Number of faces of the user that were turned around, since they disagreed with their
  /// neighbours.
  std::size_t reversed_faces = 0;
};

class Input;

/*!
\brief defines a surface and names its elements as the user does: a triangulation without
correspondence keeps only this of its input.

It never changes. Numbers of vertices and faces are those of the triangulation before its first
move.
*/
class Input_definition {
public:
  /// The parts of a definition.
  struct Parts {
    std::uint32_t number_of_vertices = 0; ///< isolated ones included
    Input_metric metric;                  ///< what defines lengths and areas
    Input_names names;                    ///< the numbers in the user's mesh
    Planar_polygons planar_polygons;      ///< the user's faces that became planar polygons
    Input_report report;                  ///< what was done to the input
  };

  /// defines the surface without elements.
  Input_definition();
  /// takes the parts.
  explicit Input_definition(Parts parts);
  /// copies.
  Input_definition(const Input_definition& other);
  /// moves.
  Input_definition(Input_definition&& other) noexcept;
  /// copies.
  Input_definition& operator=(const Input_definition& other);
  /// moves.
  Input_definition& operator=(Input_definition&& other) noexcept;
  /// destructs.
  virtual ~Input_definition();

  /// returns what defines lengths and areas exactly.
  const Input_metric& metric() const { return parts_.metric; }
  /// returns how the user's mesh numbers the vertices, edges and faces.
  const Input_names& names() const { return parts_.names; }
  /// returns what was done to the input.
  const Input_report& report() const { return parts_.report; }
  /// returns the user's faces that became planar polygons.
  const Planar_polygons& planar_polygons() const { return parts_.planar_polygons; }
  /// returns s, where coordinates are scaled by 2^s and squared lengths by 4^s.
  int scale_exponent() const { return metric().scale_exponent(); }
  /// returns the number of vertices.
  std::uint32_t number_of_vertices() const { return parts_.number_of_vertices; }
  /// returns the number of the user's vertices. It is smaller on a cover, where several vertices
  /// copy one.
  std::uint32_t number_of_rows() const { return names().number_of_rows(number_of_vertices()); }
  /// returns the surface, if its connectivity is kept, too; otherwise null.
  virtual const Input* surface() const { return nullptr; }

private:
  Parts parts_;
};

/*!
\brief is the surface that an intrinsic triangulation was built from: connectivity, exact metric,
the user's names of its elements, and what was done to it.

A triangulation with correspondence shares it with its copies and with all readers: correspondence,
queries, certificates and files. It never changes. Numbers of vertices, edges and faces are those of
the triangulation before its first move; halfedges `2e` and `2e + 1` are the sides of edge `e`.

A triangulation without correspondence has an `Input_definition` instead, since copying
connectivity, lengths and areas would cost as much as its flips. The exception is one read from a
file that says how it lies on its input.
\cgalModels{NumberedComplex}
*/
class Input final : public Input_definition {
public:
  /// constructs the empty surface.
  Input();
  /// copies.
  Input(const Input& other);
  /// moves.
  Input(Input&& other) noexcept;
  /// copies.
  Input& operator=(const Input& other);
  /// moves.
  Input& operator=(Input&& other) noexcept;
  /// destructs.
  ~Input() override;

  /// takes the parts of the surface. \param mesh the connectivity \param parts all else
  Input(Gluing_map mesh, Parts parts);

  /// takes the parts of the surface.
  /// \param mesh the connectivity \param metric what defines lengths and areas \param names the
  /// numbers in the user's mesh
  Input(Gluing_map mesh, Input_metric metric, Input_names names = {});

  /*!
  \brief takes the parts of the surface, and keeps the lengths and areas of a metric if these are
  doubles.
  \tparam Metric a model of `EuclideanMetric`
  \param mesh the connectivity
  \param parts all else
  \param values the metric of the surface
  */
  template <class Metric>
  Input(Gluing_map mesh, Parts parts, const Metric& values)
      : Input(std::move(mesh), std::move(parts)) {
    squared_length_.reserve(number_of_edges());
    quadruple_area_.reserve(number_of_faces());
    for (std::uint32_t e = 0; e < number_of_edges(); ++e)
      squared_length_.push_back(values.approximate_squared_length(e));
    for (std::uint32_t f = 0; f < number_of_faces(); ++f)
      quadruple_area_.push_back(values.approximate_quadruple_area(f));
  }

  const Input* surface() const override { return this; }
  /// returns the connectivity.
  const Gluing_map& mesh() const { return mesh_; }
  /// tells whether `metric()` defines the lengths of the faces of `mesh()`, which can fail only for
  /// an input that users assembled. \complexity linear
  bool is_defined_by_metric() const;

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
  /// \cond the functions of `NumberedComplex`
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
  double squared_length(std::uint32_t e) const {
    return squared_length_.empty() ? defined_squared_length(e) : squared_length_[e];
  }
  double quadruple_area(std::uint32_t f) const {
    return quadruple_area_.empty() ? defined_quadruple_area(f) : quadruple_area_[f];
  }
  /// \endcond

private:
  double defined_squared_length(std::uint32_t e) const;
  double defined_quadruple_area(std::uint32_t f) const;

  Gluing_map mesh_;
  std::vector<double> squared_length_; // as the metric has them, or none
  std::vector<double> quadruple_area_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_INPUT_H
