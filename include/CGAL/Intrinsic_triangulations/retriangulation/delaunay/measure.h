// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_MEASURE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_MEASURE_H

#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/Edge_tester.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/Summed_weights.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/measure_quality.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// What says of edges whether they are kept.
template <class Map, class Triangulation>
concept Marks_edges_of = requires(const Map& map,
                                  const typename Triangulation::edge_descriptor& e) {
  { get(map, e) } -> std::convertible_to<bool>;
};

} // namespace internal

/// What is known of a triangulation as it is, in the units of the input; of a cover, integrals are
/// over the faces below it.
struct Measurements {
  Tested_edges edges;         ///< how they pass the test
  Quality quality;            ///< shapes of faces
  double area = 0;            ///< of all faces
  double laplacian_trace = 0; ///< sum of the diagonal of the cotangent Laplacian
  /// x^T L x of each coordinate function, if there are points.
  std::optional<std::array<double, 3>> dirichlet{};
};

namespace internal {

// The area of a surface by four times the scaled areas of its faces; of a cover, that of the faces
// below it.
template <class Triangulation>
double area_in_units(const Triangulation& t, long double quadruple_area) {
  return std::ldexp(static_cast<double>(quadruple_area), -2 * t.metric().scale_exponent() - 2) /
         t.input().names().sheets;
}

} // namespace internal

/// returns the area of a triangulation as its metric stores it, in the units of the input; of a
/// cover, that of the faces below it. \complexity linear
template <IntrinsicTriangulation Triangulation>
double stored_area(const Triangulation& t) {
  long double sum = 0;
  for (const typename Triangulation::face_descriptor f : faces(t.mesh()))
    sum += t.metric().approximate_quadruple_area(t.index(f));
  return internal::area_in_units(t, sum);
}

/// returns the area of a triangle in space, which also rounding on a needle does not spoil.
double area_in_space(const std::array<double, 3>& p, const std::array<double, 3>& q,
                     const std::array<double, 3>& r);

namespace internal {

// Multiplies by a power of two; `std::ldexp()` took a tenth of the time of statistics.
class Binary_scale {
public:
  explicit Binary_scale(int exponent)
      : first_(std::ldexp(1., exponent / 2)), second_(std::ldexp(1., exponent - exponent / 2)) {}
  double operator()(double x) const { return x * first_ * second_; }

private:
  double first_, second_; // the product may be beyond the range of doubles
};

// Integrals over the surface; x^T L x is summed over edges as w (x_i - x_j)^2, without
// cancellation. Weights of edges from a vertex to itself do not count.
template <class Triangulation>
class Edge_integrals {
public:
  // \param points see `measure()`
  Edge_integrals(const Triangulation& t, const std::vector<std::array<double, 3>>& points)
      : t_(t), points_(points), sheets_(t.input().names().sheets),
        scaled_(t.metric().scale_exponent()) {
    if (!points.empty() && points.size() < t.number_of_vertices())
      throw Invalid_input(Element_kind::vertex, points.size(),
                          "vertex " + std::to_string(points.size()) + " has no point, among " +
                              std::to_string(t.number_of_vertices()) +
                              " with those inserted; give what points_of_rows() returns, or none");
  }

  // adds an edge. \param h one of its halfedges
  void add(typename Triangulation::halfedge_descriptor h, double weight_on_sheets) {
    const std::uint32_t i = t_.input_vertex(source(h, t_.mesh())),
                        j = t_.input_vertex(target(h, t_.mesh()));
    if (i == j) return;
    const double weight = weight_on_sheets / sheets_;
    trace_ += 2 * weight;
    if (points_.empty()) return;
    for (unsigned k = 0; k < 3; ++k) {
      const double d = scaled_(points_[i][k] - points_[j][k]); // its square does not underflow
      dirichlet_[k] += weight * d * d;
    }
  }

  void write(Measurements& result) const {
    result.laplacian_trace = static_cast<double>(trace_);
    if (points_.empty()) return;
    result.dirichlet.emplace();
    for (unsigned k = 0; k < 3; ++k)
      (*result.dirichlet)[k] =
          std::ldexp(static_cast<double>(dirichlet_[k]), -2 * t_.metric().scale_exponent());
  }

private:
  const Triangulation& t_;
  const std::vector<std::array<double, 3>>& points_;
  double sheets_;
  Binary_scale scaled_;
  long double trace_ = 0;
  std::array<long double, 3> dirichlet_ = {};
};

// Calls a function with the three vertices of each face of the input, by their numbers there. Where
// only changed lengths are kept, and no connectivity, faces are those of the triangulation.
template <class Triangulation, class Function>
void for_each_input_face(const Triangulation& t, const Function& function) {
  const Input_metric& metric = t.input().metric();
  if (!metric.points().empty()) {
    for (std::uint32_t f = 0; f < metric.number_of_faces(); ++f) {
      const auto& [p, q, r] = metric.sides(f);
      function(p, q, r);
    }
  } else if (const Input* input = t.input().surface()) {
    for (std::uint32_t f = 0; f < input->number_of_faces(); ++f) {
      const std::uint32_t h = input->halfedge_of_face(f);
      function(input->source(h), input->target(h), input->target(input->next(h)));
    }
  } else {
    const auto number = [&](auto g) { return t.index(source(g, t.mesh())); };
    for (const typename Triangulation::face_descriptor f : faces(t.mesh())) {
      const auto h = halfedge(f, t.mesh()), n = next(h, t.mesh());
      function(number(h), number(n), number(next(n, t.mesh())));
    }
  }
}

} // namespace internal

/// returns the area of the input from its coordinates, before any mollification, in its units; NaN
/// where the coordinates are not known; where polygons became planar, that of its faces.
/// \param points one per row, in the units of the input; none: those that the input has
/// \pre no edge was flipped and no vertex inserted, unless the input has points or it is known
///   where edges run
template <IntrinsicTriangulation Triangulation>
double area_of_points(const Triangulation& t,
                      const std::vector<std::array<double, 3>>& points = {}) {
  const std::vector<std::array<double, 3>>& kept = t.input().metric().points();
  if (points.empty() && kept.empty()) return std::numeric_limits<double>::quiet_NaN();
  if (!t.input().planar_polygons().empty()) return stored_area(t);
  const int s = t.input().scale_exponent();
  const internal::Binary_scale scaled(s);
  const auto at = [&](std::uint32_t v) { // in units in which no product underflows
    if (points.empty()) return kept[v];
    const std::array<double, 3>& p = points[t.input().names().row(v)];
    return std::array{scaled(p[0]), scaled(p[1]), scaled(p[2])};
  };
  long double sum = 0;
  internal::for_each_input_face(t, [&](std::uint32_t p, std::uint32_t q, std::uint32_t r) {
    sum += area_in_space(at(p), at(q), at(r));
  });
  return std::ldexp(static_cast<double>(sum), -2 * s) / t.input().names().sheets;
}

/*!
\brief tests all edges and measures faces, without integrals but the area: see `measure()`.
\param t the triangulation
\param constrained a readable property map from edges to whether they are kept
\param visit called with a halfedge of each edge, and the cotangent weight, see
  `statistics_tolerance`; that of a tie is 0
\return what was found
\complexity linear, and that of `check_delaunay()`
*/
template <IntrinsicTriangulation Triangulation, internal::Marks_edges_of<Triangulation> Constrained,
          std::invocable<typename Triangulation::halfedge_descriptor, double> Visit>
Measurements measure_shapes(Triangulation& t, const Constrained& constrained, const Visit& visit) {
  Measurements result;
  // values become accurate before anything is found from them
  internal::Summed_weights<Triangulation> sums(t, internal::sharpen_for_statistics(t));
  long double area = 0;
  internal::measure_faces(
      t, result.quality,
      [&](const Indexed_face& face, const Face_values<double>& values, const auto&... more) {
        area += values.quadruple_area;
        sums.add(face, values, more...);
      });
  result.area = internal::area_in_units(t, area);
  result.edges = internal::Edge_tester(t, constrained, sums, result.quality, visit)();
  return result;
}

/// tests all edges and measures faces; see above.
template <IntrinsicTriangulation Triangulation, internal::Marks_edges_of<Triangulation> Constrained>
Measurements measure_shapes(Triangulation& t, const Constrained& constrained) {
  return measure_shapes(t, constrained, [](const auto&, double) {});
}

/*!
\brief tests all edges, and measures faces and integrals.

With exact traits, stored values become as accurate as `statistics_tolerance`.
\param t the triangulation
\param constrained a readable property map from edges to whether they are kept
\param points where each row is in space, in the units of the input, or none: then the energy of
coordinates is not known. See `points_of_rows()`
\throws Invalid_input if there are points, but not for each row, inserted vertices included
\complexity linear, and that of `check_delaunay()`
*/
template <IntrinsicTriangulation Triangulation, internal::Marks_edges_of<Triangulation> Constrained>
Measurements measure(Triangulation& t, const Constrained& constrained,
                     const std::vector<std::array<double, 3>>& points = {}) {
  internal::Edge_integrals<Triangulation> integrals(t, points);
  Measurements result = measure_shapes(
      t, constrained, [&](const auto& h, double weight) { integrals.add(h, weight); });
  integrals.write(result);
  return result;
}

/// measures a triangulation none of whose edges is kept.
template <IntrinsicTriangulation Triangulation>
Measurements measure(Triangulation& t) {
  return measure(t, Static_boolean_property_map<typename Triangulation::edge_descriptor, false>());
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_MEASURE_H
