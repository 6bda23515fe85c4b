// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_OPERATORS_CONNECTION_GRAPH_H
#define CGAL_INTRINSIC_OPERATORS_OPERATORS_CONNECTION_GRAPH_H

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Vertex_copies.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief requires what matrices on tangent vectors are assembled from.

Syntax of \ref ::ConnectedTriangulation, where its meaning is described.
*/
template <class Triangulation>
concept ConnectedTriangulation =
    MeasuredTriangulation<Triangulation> && NumberedTriangulation<Triangulation>;

namespace internal {

// Where a vector is not known.
inline constexpr std::complex<double> unknown_vector{std::numeric_limits<double>::quiet_NaN(),
                                                     std::numeric_limits<double>::quiet_NaN()};

inline bool is_known(const std::complex<double>& z) {
  return std::isfinite(z.real()) && std::isfinite(z.imag());
}

// A vector of length 1, or zero.
inline std::complex<double> unit_vector(const std::complex<double>& z) {
  const double larger = std::max(std::abs(z.real()), std::abs(z.imag()));
  if (!(larger > 0) || !std::isfinite(larger)) return 0;
  const std::complex<double> scaled = z / larger; // its square is between 1 and 2
  return scaled / std::sqrt(std::norm(scaled));
}

// A sum of vectors that is shorter than this part of their lengths has no direction: rounding of
// thousands of terms.
inline constexpr double cancelled = 0x1p-40;

// Refuses the surface of a point cloud: the sheets at a point share no tangent plane.
template <class Triangulation>
void expect_tangent_planes(const Triangulation& t) {
  if (t.input().names().is_cloud())
    throw std::invalid_argument("the surface of a cloud of points has " +
                                std::to_string(t.input().names().sheets) +
                                " sheets at each point and no single tangent plane; use "
                                "Point_cloud_vectors for vectors");
}

// How angles at border vertices are scaled.
enum class Border_angles {
  half_circle, // to half a circle (§2.4)
  as_they_are  // not at all up to three quarters of a circle: flat surfaces stay flat
};

// The angles of halfedges about their sources, counterclockwise from the first, scaled: at inner
// vertices to a whole circle.
class Halfedge_angles {
public:
  template <class Triangulation>
  Halfedge_angles(const Triangulation& t, Border_angles border)
      : border_(border), angle_(2 * std::size_t{t.numbers().edge_capacity(t.mesh())}, -1),
        scale_(angle_.size(), 1) {
    const Intrinsic_view<Triangulation> view(t);
    const auto null = boost::graph_traits<typename Triangulation::Mesh>::null_halfedge();
    for (const auto v : vertices(t.mesh()))
      if (halfedge(v, t.mesh()) != null) measure(view, view.outgoing_halfedge(t.index(v)));
    // other fans of vertices that are not manifold
    for (const bool starts_on_border : {true, false})
      for (const auto f : faces(t.mesh()))
        for (const std::uint32_t h : sides_of_face(view, view.halfedge_of_face(t.index(f))))
          if (angle_[h] < 0 && (!starts_on_border || view.is_border(h ^ 1U))) measure(view, h);
  }

  // the angle of a halfedge from the first one at its source
  double operator[](std::uint32_t h) const { return angle_[h]; }
  // the factor of angles on the surface in the fan of a halfedge
  double scale(std::uint32_t h) const { return scale_[h]; }

private:
  template <class View>
  void measure(const View& view, std::uint32_t first) {
    const auto [sum, is_on_border] =
        measure_fan(view, first, [&](std::uint32_t h, double angle) { angle_[h] = angle; });
    const double s = sum > 0 ? scale_of(is_on_border, sum) : 1;
    std::uint32_t h = first;
    do {
      angle_[h] *= s;
      scale_[h] = s;
      if (view.is_border(h)) break;
      h = next_around_source(view, h);
    } while (h != first);
  }

  double scale_of(bool is_on_border, double sum) const {
    constexpr double pi = std::numbers::pi;
    if (!is_on_border) return 2 * pi / sum;
    return border_ == Border_angles::half_circle ? pi / sum : std::min(1., 1.5 * pi / sum);
  }

  Border_angles border_;
  std::vector<double> angle_; // per halfedge
  std::vector<double> scale_; // per halfedge
};

} // namespace internal

/*!
\brief returns the polar angle of each halfedge at the vertex where it starts, by its number: the
argument that a vector along it has in a `Tangent_field`.
\param t a triangulation whose vertices are manifold, or a cover
\complexity linear
*/
template <NumberedTriangulation Triangulation>
std::vector<double> polar_angles(const Triangulation& t) {
  const internal::Halfedge_angles angles(t, internal::Border_angles::half_circle);
  std::vector<double> result(2 * std::size_t{t.numbers().edge_capacity(t.mesh())});
  for (std::uint32_t h = 0; h < result.size(); ++h) result[h] = angles[h];
  return result;
}

namespace internal {

// An edge between neighbourhoods of vertices, with the directions in which it leaves them.
struct Connection_edge {
  int source, target;
  double weight; // the cotangent weight, at least zero
  double length; // in scaled units
  double source_angle, target_angle;

  // the angle that turns a vector at the source to the parallel one at the target
  double turn() const { return target_angle + std::numbers::pi - source_angle; }
};

// A triangulation for solvers for tangent vectors: edges and the areas of vertices, with a number
// per copy of a vertex, in scaled units. Negative weights (in a Delaunay triangulation only on the
// border) become zero: on a curved surface they would make the matrix indefinite.
struct Connection_graph {
  std::size_t size = 0;
  std::vector<Connection_edge> edges;
  std::vector<double> areas;      // a third of the area of the faces at each vertex
  double squared_mean_length = 0; // of edges

  // for each vertex, the least vertex that edges of positive weight connect with it
  std::vector<std::uint32_t> parts() const {
    return joined_sets(size, [this](const auto& join) {
      for (const Connection_edge& e : edges)
        if (e.weight > 0) join(e.source, e.target);
    });
  }

  // The graph for functions with one value at all copies of a vertex. \param first the first copy
  // of each, which stands for all
  Connection_graph joined(const std::vector<std::uint32_t>& first) const {
    Connection_graph graph = *this;
    for (Connection_edge& e : graph.edges) {
      e.source = static_cast<int>(first[static_cast<std::size_t>(e.source)]);
      e.target = static_cast<int>(first[static_cast<std::size_t>(e.target)]);
    }
    std::fill(graph.areas.begin(), graph.areas.end(), 0);
    for (std::size_t i = 0; i < size; ++i) graph.areas[first[i]] += areas[i];
    return graph;
  }
};

template <class Triangulation>
void add_areas(const Triangulation& t, const Vertex_copies<Triangulation>& copies,
               Connection_graph& graph) {
  graph.areas.assign(graph.size, 0);
  for (const typename Triangulation::face_descriptor f : faces(t.mesh())) {
    const double third = t.metric().approximate_quadruple_area(t.index(f)) / 12;
    auto h = halfedge(f, t.mesh());
    for (int k = 0; k < 3; ++k, h = next(h, t.mesh()))
      graph.areas[copies(target(h, t.mesh()))] += third;
  }
}

template <ConnectedTriangulation Triangulation>
Connection_graph connection_graph(const Triangulation& t, const Halfedge_angles& angles) {
  expect_tangent_planes(t);
  const auto& mesh = t.mesh();
  const Vertex_copies<Triangulation> copies(t);
  Connection_graph graph;
  graph.size = copies.size();
  graph.edges.reserve(num_edges(mesh));
  double sum = 0;
  for_each_cotangent_weight(t, [&](typename Triangulation::edge_descriptor e, double weight) {
    const auto h = halfedge(e, mesh);
    const std::uint32_t i = t.numbers().halfedge(h);
    const double length = std::sqrt(t.metric().approximate_squared_length(t.index(e)));
    graph.edges.push_back({static_cast<int>(copies(source(h, mesh))),
                           static_cast<int>(copies(target(h, mesh))), std::max(0., weight), length,
                           angles[i], angles[i ^ 1U]});
    sum += length;
  });
  const double mean = graph.edges.empty() ? 1 : sum / static_cast<double>(graph.edges.size());
  graph.squared_mean_length = mean * mean;
  add_areas(t, copies, graph);
  return graph;
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_OPERATORS_CONNECTION_GRAPH_H
