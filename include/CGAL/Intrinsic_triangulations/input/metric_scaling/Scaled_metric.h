// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_METRIC_SCALING_SCALED_METRIC_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_METRIC_SCALING_SCALED_METRIC_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>
#include <CGAL/Intrinsic_triangulations/formulas/Space_vector.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <type_traits>
#include <utility>
#include <vector>

/*!
\file
Any input of the package, or a triangulation, as a gluing with squared lengths, together with the
mesh that names its vertices and faces.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief requires a triangulation with its own metric: points in space do not define its edges.

Syntax of \ref ::TriangulationWithMetric, where its meaning is described.
*/
template <class Mesh>
concept TriangulationWithMetric = requires(const Mesh& t) {
  t.mesh();
  t.metric().approximate_squared_length(0U);
  t.metric().scale_exponent();
};

namespace internal {

// The mesh that vertices and faces are named in: what descriptors belong to.
template <class Mesh>
const Mesh& named_mesh(const Mesh& mesh) {
  return mesh;
}
template <TriangulationWithMetric Mesh>
const typename Mesh::Mesh& named_mesh(const Mesh& t) {
  return t.mesh();
}
inline const Gluing_map& named_mesh(const Intrinsic_input& in) { return in.mesh; }
template <class Mesh>
using Named_graph = std::remove_cvref_t<decltype(named_mesh(std::declval<const Mesh&>()))>;
template <class Mesh>
using Named_vertex = typename boost::graph_traits<Named_graph<Mesh>>::vertex_descriptor;
template <class Mesh>
using Named_face = typename boost::graph_traits<Named_graph<Mesh>>::face_descriptor;

// All in scaled units: lengths are 2^scale_exponent times the user's.
struct Metric_source {
  Intrinsic_input in; // with squared lengths, and points where it has any
  int scale_exponent = 0;

  // from the source of a halfedge to its target
  std::array<double, 3> side_in_space(Gluing_map::Halfedge h) const {
    return difference(in.points[in.mesh.target(h).index], in.points[in.mesh.source(h).index]);
  }
};

Metric_source read_metric(Intrinsic_input in);

template <class Mesh>
Metric_source read_metric(const Mesh& mesh) {
  return read_metric(Intrinsic_input(mesh));
}

template <TriangulationWithMetric Triangulation>
Metric_source read_metric(const Triangulation& t) {
  Metric_source s{Intrinsic_input(gluing_map_from_face_graph(t.mesh()), std::vector<double>()),
                  t.metric().scale_exponent()};
  for (const typename Triangulation::edge_descriptor e : edges(t.mesh()))
    s.in.squared_lengths.push_back(t.metric().approximate_squared_length(t.index(e)));
  return s;
}

} // namespace internal

/// Treatment of new lengths that violate the triangle inequality (§4.8 of the course). Faces
/// without area may do so because of rounding: meshes with such faces need `repair`.
enum class Triangle_inequality {
  refuse, ///< an exception names the first face
  repair, ///< edges are shortened, see `shorten_edges()`
  check   ///< faces are listed, and no more: the result may not be a metric
};

/*!
\brief holds a new metric, and reports its repair.
*/
struct Scaled_metric {
  /// The surface with the new lengths; an `Intrinsic_triangulation` is built from it.
  Intrinsic_input input;
  /// Faces in which the new lengths violated the triangle inequality before any repair, by their
  /// numbers in the order of iteration, after polygons were triangulated.
  std::vector<std::uint32_t> violating_faces;
  /// Edges that repair shortened.
  std::size_t changed_edges = 0;
  /// Largest (l - l') / l, where repair shortened an edge from l to l'.
  double largest_relative_change = 0;
  /// Whether all faces satisfy the triangle inequality now, so that a triangulation can be built.
  bool is_metric = true;
};

namespace internal {

// How a metric is scaled: see `scale_conformally()`.
struct Metric_scaling_options {
  Triangle_inequality triangle_inequality = Triangle_inequality::refuse;
  double margin = 1e-5; // as the course recommends for mollification
};

template <class NP>
Metric_scaling_options metric_scaling_options(const NP& np) {
  expect_names<tags::triangle_inequality, tags::margin>(np);
  const Metric_scaling_options d;
  return {value_or<tags::triangle_inequality>(np, d.triangle_inequality),
          value_or<tags::margin>(np, d.margin)};
}

std::string text_of_length(double x);

// Does what the options say about the triangle inequality.
Scaled_metric finish_scaling(Intrinsic_input&& in, const Metric_scaling_options& options);

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_METRIC_SCALING_SCALED_METRIC_H
