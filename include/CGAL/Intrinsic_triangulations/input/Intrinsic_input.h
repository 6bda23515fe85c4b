// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_INTRINSIC_INPUT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_INTRINSIC_INPUT_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>
#include <CGAL/Intrinsic_triangulations/input/Element_names.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/input/Planar_polygons.h>
#include <CGAL/Intrinsic_triangulations/input/mollification.h>
#include <CGAL/Intrinsic_triangulations/input/triangulate_face_graph.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief holds points and the triangles between them, before any edge is matched.

Vertices keep the numbers they have in the input. Triangles follow the order of the input faces; a
polygon with `n` sides gives `n - 2` consecutive triangles, oriented as the polygon is.
*/
struct Triangle_soup {
  /// Coordinates of the vertices, isolated ones included.
  std::vector<std::array<double, 3>> points;
  /// Vertices of the triangles, counterclockwise.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// Input face of each triangle; empty if each is one.
  std::vector<std::uint32_t> polygon_of_triangle;
  /// Number of faces of the input.
  std::size_t input_faces = 0;
  /// Number of input faces with more than three sides.
  std::size_t triangulated_polygons = 0;
  /// Number of input faces that listed a vertex more than once. Lines and points are removed from
  /// them.
  std::size_t faces_with_repeated_vertices = 0;
  /// Those of them that became planar.
  Planar_polygons planar_polygons;
};

/*!
\brief describes what an intrinsic triangulation is built from: a gluing of triangles, and either
points in space or squared edge lengths.
*/
struct Intrinsic_input {
  /// Connectivity.
  Gluing_map mesh;
  /// One point per vertex; empty for an abstract metric.
  std::vector<std::array<double, 3>> points;
  /// One squared length per edge of `mesh`, in the order of `edges(mesh)`; empty for a mesh in
  /// space.
  std::vector<double> squared_lengths;
  /// Treatment of degenerate faces.
  Mollification mollification = Mollification::automatic;
  /*!
  Amount of mollification as a fraction of the mean edge length; above 0, at most 1. With `lengths`
  and `nearly_degenerate`, every triangle inequality then holds by this amount (default: 1e-5). With
  `squared_lengths` and `automatic`, its square is added to all squared lengths, so that a length of
  zero becomes this amount (default: 2^-36).
  */
  std::optional<double> mollification_amount;
  /// Whether faces and vertices may be renumbered for locality. If not, vertices and faces keep
  /// their numbers in the order of iteration, and so do edges of a mesh without polygons.
  bool may_renumber = true;
  /// Number of polygonal faces that were triangulated, for the report.
  std::size_t triangulated_polygons = 0;
  /// Number of faces that were turned around to orient the surface, for the report.
  std::size_t reversed_faces = 0;
  /// The user's names of the elements of `mesh`, where polygons were triangulated.
  Input_names names;
  /// Faces that became planar: their triangles lie in a plane, not between the points in space.
  Planar_polygons planar_polygons;

  /// constructs an input without faces.
  Intrinsic_input();
  /// copies.
  Intrinsic_input(const Intrinsic_input& other);
  /// moves.
  Intrinsic_input(Intrinsic_input&& other) noexcept;
  /// copies.
  Intrinsic_input& operator=(const Intrinsic_input& other);
  /// moves.
  Intrinsic_input& operator=(Intrinsic_input&& other) noexcept;
  /// destructs.
  ~Intrinsic_input();

  /*!
  \brief takes an abstract metric: it need not embed in space.
  \param g the connectivity; `gluing_from_triangles()` makes it from triples of vertices
  \param l one squared length per edge of `g`, in the order of `edges(g)`
  \param m treatment of degenerate faces
  */
  Intrinsic_input(Gluing_map g, std::vector<double> l, Mollification m = Mollification::automatic);

  /// takes a gluing map with a point per vertex.
  Intrinsic_input(Gluing_map g, std::vector<std::array<double, 3>> p,
                  Mollification m = Mollification::automatic);

  /*!
  \brief takes points and triples of their numbers, from a file or from arrays.

  Edges are found by their end vertices, see `gluing_from_triangles()`; faces that disagree with
  their neighbours in orientation are turned around, and counted.
  \throws Invalid_input naming faces that do not fit together, or a vertex that does not exist
  */
  explicit Intrinsic_input(Triangle_soup soup, Mollification m = Mollification::automatic);

  /*!
  \brief takes a mesh in space through BGL.

  Coordinates are converted to `double`.
  \tparam FaceGraph a model of `FaceListGraph` and `HalfedgeListGraph`
  \tparam PointMap a readable property map from vertices to points with `operator[]`
  \param graph the mesh
  \param point_map the points
  \param m treatment of degenerate faces
  \param polygons what is made of polygons that are not planar
  \throws Invalid_input naming a polygonal face that cannot be triangulated
  */
  template <class FaceGraph, class PointMap>
  Intrinsic_input(const FaceGraph& graph, PointMap point_map, Mollification m,
                  Nonplanar_polygons polygons = Nonplanar_polygons::fan)
      : mollification(m) {
    std::uint32_t polygon = Gluing::none;
    mesh = gluing_map_unless_polygonal(graph, polygon);
    points.reserve(num_vertices(graph));
    for (const typename boost::graph_traits<FaceGraph>::vertex_descriptor v : vertices(graph))
      points.push_back(Mesh_adaptor<FaceGraph>::coordinates(get(point_map, v)));
    if (polygon != Gluing::none)
      mesh = gluing_map_from_polygons(graph, points, polygons, triangulated_polygons, names,
                                      planar_polygons);
  }

  /// takes a mesh in space with its own points.
  template <class FaceGraph>
  explicit Intrinsic_input(const FaceGraph& graph, Mollification m = Mollification::automatic,
                           Nonplanar_polygons polygons = Nonplanar_polygons::fan)
      : Intrinsic_input(graph, Mesh_adaptor<FaceGraph>::point_map(graph), m, polygons) {}
};

namespace internal {

// The start of a triangulation.
// \tparam Kept what it keeps of its input: `Input`, or `Input_definition`
template <class Metric, class Kept>
struct Prepared_input {
  std::shared_ptr<const Kept> input;
  Gluing_map mesh;
  Metric metric;
};

// Treatment of degenerate faces, if `automatic` treats them: never `automatic` or
// `nearly_degenerate`.
template <class Is_bad>
Mollification needed_mollification(Mollification asked, const Gluing_map& mesh,
                                   const Input_definition::Parts& parts, const Is_bad& is_bad) {
  if (asked == Mollification::nearly_degenerate)
    return has_nearly_degenerate_face(mesh, edge_lengths(mesh, parts.metric))
               ? Mollification::lengths
               : Mollification::none;
  if (asked != Mollification::automatic) return asked;
  return is_bad() ? Mollification::squared_lengths : Mollification::none;
}

// the number of the user's faces whose triangles were reversed
std::size_t number_of_reversed(const std::vector<char>& triangles,
                               const std::vector<std::uint32_t>& polygon_of_triangle);

// One point per vertex, or one squared length per edge: numbers of elements are indices without a
// check.
void check_sizes(const Intrinsic_input& in);

// The amounts that change the squared distances of points to those of planar polygons, by sides of
// faces; empty: none.
// \param points scaled by 2^scale_exponent, which the polygons are not
std::vector<std::array<double, 3>>
planar_excess(const Gluing_map& mesh, const std::vector<std::array<double, 3>>& points,
              const Input_names& names, const Planar_polygons& polygons, int scale_exponent);

// Makes every triangle inequality strict: changes the metric. The amount is a part of the mean
// edge.
Mollification_report mollify(const Gluing_map& mesh, Input_metric& metric, Mollification kind,
                             std::optional<double> amount);

// The input in scaled units and in a fast order. Its connectivity stays in `in`. Throws if there
// are no faces, sizes do not match, or an option is out of range.
Input_definition::Parts scaled_and_ordered(Intrinsic_input& in);

// The metric has areas, so that there are degenerate faces.
template <class Metric>
concept Has_areas = requires(const Metric& m, std::uint32_t f) {
  m.is_degenerate(f);
};

// The metric of the input, mollified if needed, which the report says. Without areas only an edge
// without length is degenerate.
template <class Metric>
Metric prepared_metric(const Intrinsic_input& in, Input_definition::Parts& parts) {
  const auto mollified = [&](Mollification kind) {
    parts.report.mollification = mollify(in.mesh, parts.metric, kind, in.mollification_amount);
    return Metric(in.mesh, parts.metric);
  };
  if constexpr (Has_areas<Metric>) {
    Metric metric(in.mesh, parts.metric);
    for (std::uint32_t f = 0; f < in.mesh.number_of_faces(); ++f)
      if (metric.is_degenerate(f)) ++parts.report.degenerate_faces;
    const Mollification needed = needed_mollification(in.mollification, in.mesh, parts, [&] {
      return parts.report.degenerate_faces > 0 && has_irremovable_degeneracy(in.mesh, metric);
    });
    if (needed != Mollification::none) metric = mollified(needed);
    return metric;
  } else {
    const Mollification needed = needed_mollification(
        in.mollification, in.mesh, parts, [&] { return has_edge_without_length(parts.metric); });
    return needed == Mollification::none ? Metric(in.mesh, parts.metric) : mollified(needed);
  }
}

template <class Metric, class Kept>
Prepared_input<Metric, Kept> prepare(Intrinsic_input&& in) {
  Input_definition::Parts parts = scaled_and_ordered(in);
  Gluing_map& mesh = in.mesh;
  Metric metric = prepared_metric<Metric>(in, parts);
  std::shared_ptr<const Kept> input;
  if constexpr (std::is_same_v<Kept, Input> && Has_areas<Metric>)
    input = std::make_shared<const Input>(mesh, std::move(parts), metric);
  else if constexpr (std::is_same_v<Kept, Input>)
    input = std::make_shared<const Input>(mesh, std::move(parts));
  else
    input = std::make_shared<const Input_definition>(std::move(parts));
  return {std::move(input), std::move(mesh), std::move(metric)};
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_INTRINSIC_INPUT_H
