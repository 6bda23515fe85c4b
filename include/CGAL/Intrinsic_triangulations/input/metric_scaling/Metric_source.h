// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_METRIC_SCALING_METRIC_SOURCE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_METRIC_SCALING_METRIC_SOURCE_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/input/scaling.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/*!
\file
Any input of the package, or a triangulation, as a gluing with squared lengths, together with the
names by which its owner knows its vertices and faces.
*/

namespace CGAL::Intrinsic_triangulations::internal {

// A triangulation with a metric of its own; its points, if it ever had any, say nothing of its edges.
template <class Mesh>
concept Has_intrinsic_metric = requires(const Mesh& t) {
  t.mesh();
  t.metric().approximate_squared_length(0U);
  t.metric().scale_exponent();
};

// The mesh that vertices and faces are named in: what descriptors belong to.
template <class Mesh>
struct Named_mesh {
  using type = Mesh;
};
template <Has_intrinsic_metric Mesh>
struct Named_mesh<Mesh> {
  using type = typename Mesh::Mesh;
};
template <>
struct Named_mesh<Intrinsic_input> {
  using type = Gluing_map;
};

template <class Mesh>
struct Metric_source {
  using Traits = boost::graph_traits<typename Named_mesh<Mesh>::type>;
  using Vertex = typename Traits::vertex_descriptor;
  using Face = typename Traits::face_descriptor;

  Gluing_map map;
  std::vector<Vertex> vertices;              // by number in `map`
  std::vector<Face> faces;                   // likewise, unless polygons were triangulated
  std::vector<std::array<double, 3>> points; // scaled; empty without points
  std::vector<double> squared_lengths;       // per edge of `map`, scaled
  int scale_exponent = 0;                    // lengths here are 2^scale_exponent times the user's
  Mollification mollification = Mollification::automatic;
  std::size_t triangulated_polygons = 0;

  void measure(Intrinsic_input&& in) {
    map = std::move(in.mesh);
    mollification = in.mollification;
    triangulated_polygons = in.triangulated_polygons;
    squared_lengths = std::move(in.squared_lengths);
    if (in.points.empty() && squared_lengths.size() != map.number_of_edges())
      throw Invalid_input(Element_kind::none, 0,
                          std::to_string(squared_lengths.size()) +
                              " squared lengths are given for " +
                              std::to_string(map.number_of_edges()) + " edges; give one for each");
    if (!squared_lengths.empty() || in.points.empty()) {
      scale_exponent = scale_squared_lengths(squared_lengths);
      return;
    }
    points = std::move(in.points);
    scale_exponent = scale_points(map, points);
    squared_lengths.reserve(map.number_of_edges());
    for (std::uint32_t e = 0; e < map.number_of_edges(); ++e) measure_edge(e);
  }

  void measure_edge(std::uint32_t e) {
    const std::array<double, 3>&p = points[map.source({2 * e}).index],
                             &q = points[map.target({2 * e}).index];
    squared_lengths.push_back(Input_metric::squared_distance<double>(p, q));
    if (squared_lengths.back() < std::numeric_limits<double>::min() && p != q)
      throw Invalid_input(Element_kind::edge, e,
                          "edge " + std::to_string(e) +
                              " is more than 2^500 times shorter than the mean edge; move its "
                              "vertices to the same place, or apart");
  }

  // from the source of a halfedge to its target, scaled
  std::array<double, 3> side_in_space(Gluing_map::Halfedge h) const {
    const std::array<double, 3>&p = points[map.source(h).index], &q = points[map.target(h).index];
    return {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
  }
};

template <class Mesh, class Named>
void name_elements(Metric_source<Mesh>& s, const Named& mesh) {
  for (const typename Metric_source<Mesh>::Vertex v : vertices(mesh)) s.vertices.push_back(v);
  for (const typename Metric_source<Mesh>::Face f : faces(mesh)) s.faces.push_back(f);
}

template <class Mesh>
Metric_source<Mesh> read_metric(const Mesh& mesh) {
  Metric_source<Mesh> s;
  if constexpr (std::is_same_v<Mesh, Intrinsic_input>) {
    s.measure(Intrinsic_input(mesh));
    name_elements(s, s.map);
  } else if constexpr (Has_intrinsic_metric<Mesh>) {
    using Edge = typename Mesh::edge_descriptor;
    s.map = gluing_map_from_face_graph(mesh.mesh());
    s.scale_exponent = mesh.metric().scale_exponent();
    for (const Edge e : edges(mesh.mesh()))
      s.squared_lengths.push_back(mesh.metric().approximate_squared_length(mesh.index(e)));
    name_elements(s, mesh.mesh());
  } else {
    s.measure(Intrinsic_input(mesh));
    name_elements(s, mesh);
  }
  return s;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_METRIC_SCALING_METRIC_SOURCE_H
