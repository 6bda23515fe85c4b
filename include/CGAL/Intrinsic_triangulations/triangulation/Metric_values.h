// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_METRIC_VALUES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_METRIC_VALUES_H

#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/metric/Enclosed_values.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <CGAL/enum.h>

#include <boost/config.hpp>
#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Greatest relative width of the intervals of values that users get.
inline constexpr double usual_width = Enclosed_values::narrow;

// Stores intervals, which can be made narrow.
template <class Metric>
concept Has_enclosures = requires(const Metric& m, std::span<const Indexed_face> faces) {
  m.is_narrow(faces.front());
  typename Metric::Scope;
};

// The numbers of the face of a halfedge and of its sides, from that one on.
template <class Triangulation>
Indexed_face indexed_face_from(const Triangulation& t,
                               typename Triangulation::halfedge_descriptor h) {
  const auto n = next(h, t.mesh()), l = next(n, t.mesh());
  const auto edge_number = [&t](auto g) { return t.index(edge(g, t.mesh())); };
  return {t.index(face(h, t.mesh())), {edge_number(h), edge_number(n), edge_number(l)}};
}

// The numbers of a face and of its sides, from its halfedge on.
template <class Triangulation>
Indexed_face indexed_face(const Triangulation& t, typename Triangulation::face_descriptor f) {
  return indexed_face_from(t, halfedge(f, t.mesh()));
}

template <class Metric>
Face_values<double> approximate_values(const Metric& metric, const Indexed_face& face) {
  return {{metric.approximate_squared_length(face.edges[0]),
           metric.approximate_squared_length(face.edges[1]),
           metric.approximate_squared_length(face.edges[2])},
          metric.approximate_quadruple_area(face.face)};
}

// The stored values of a face, in scaled units.
template <class Triangulation>
Face_values<double> approximate_values(const Triangulation& t,
                                       typename Triangulation::face_descriptor f) {
  return approximate_values(t.metric(), indexed_face(t, f));
}

// The values of a face in scaled units, for users: with exact traits, it first narrows intervals
// and doubles, if the intervals are wider than allowed.
template <class Triangulation>
Face_values<double> accurate_values(const Triangulation& t,
                                    typename Triangulation::face_descriptor f,
                                    double width = usual_width) {
  const Indexed_face face = indexed_face(t, f);
  if constexpr (Has_enclosures<typename Triangulation::Metric>) {
    if (!t.metric().is_narrow(face, width)) {
      const typename Triangulation::Metric::Scope scope;
      t.sharpen(std::span(&face, 1));
    }
  }
  return approximate_values(t.metric(), face);
}

// The quadruple area of a face in scaled units, for users; see above.
template <class Triangulation>
double accurate_quadruple_area(const Triangulation& t, typename Triangulation::face_descriptor f,
                               double width) {
  const std::uint32_t i = t.index(f);
  if constexpr (Has_enclosures<typename Triangulation::Metric>)
    if (!t.metric().is_area_narrow(i, width)) return accurate_values(t, f).quadruple_area;
  return t.metric().approximate_quadruple_area(i);
}

// The squared length of an edge in scaled units, for users; see above.
template <class Triangulation>
double accurate_squared_length(const Triangulation& t, typename Triangulation::edge_descriptor e) {
  const std::uint32_t i = t.index(e);
  if constexpr (Has_enclosures<typename Triangulation::Metric>)
    if (!t.metric().is_narrow(i)) {
      const auto& mesh = t.mesh();
      const auto null = boost::graph_traits<typename Triangulation::Mesh>::null_face();
      const auto h = halfedge(e, mesh);
      const typename Triangulation::Metric::Scope scope;
      t.sharpen_length(indexed_face_from(t, face(h, mesh) != null ? h : opposite(h, mesh)));
    }
  return t.metric().approximate_squared_length(i);
}

} // namespace internal

/*!
\brief calls the metric of a triangulation, and passes it the data for decisions.

Functions with numbers of faces and edges require a live session.
\tparam Triangulation derives from this class; with a metric that decides by the input it has
`exact_values()`
*/
template <class Triangulation, MutableDeltaComplex Mesh, IntrinsicMetric Metric>
class Metric_values {
public:
  /// returns the sign of an expression in the values of a diamond, exact with exact traits.
  /// \tparam Expression a model of `DiamondExpression`
  template <class Expression>
  Sign sign(const Diamond& d,
            const Expression& expression) const requires internal::Decides_signs<Metric> {
    return decide([&](const auto&... exact) { return metric().sign(d, expression, exact...); });
  }
  /// returns the sign of an expression in the values of faces, exact with exact traits.
  /// \tparam Expression a model of `FaceExpression`
  template <class Expression>
  Sign sign(std::span<const Indexed_face> faces,
            const Expression& expression) const requires internal::Decides_signs<Metric> {
    return decide([&](const auto&... exact) { return metric().sign(faces, expression, exact...); });
  }
  /// tells whether the angles opposite the edge of a diamond sum to at most pi.
  BOOST_FORCEINLINE bool is_locally_delaunay(const Diamond& d) const {
    if constexpr (by_input)
      return metric().is_locally_delaunay(d, self().exact_values());
    else
      return metric().is_locally_delaunay(d);
  }
  /// returns the sign of pi minus the angles opposite the edge of a diamond.
  Sign delaunay_sign(const Diamond& d) const {
    if constexpr (internal::Decides_signs<Metric>)
      return sign(d, Delaunay_expression());
    else
      return decide([&](const auto&... exact) { return metric().delaunay_sign(d, exact...); });
  }
  /// tells whether the diamond is strictly convex, so that its edge can be flipped.
  bool is_flippable(const Diamond& d) const {
    if constexpr (internal::Decides_signs<Metric>)
      return sign(d, Convexity_at_source_expression()) == POSITIVE &&
             sign(d, Convexity_at_target_expression()) == POSITIVE;
    else
      return decide([&](const auto&... exact) { return metric().is_flippable(d, exact...); });
  }
  /// returns half the sum of the cotangents of the angles opposite the edge of a diamond; see
  /// `Enclosed_values::stored_weight()` for the tolerance, which other traits ignore.
  double cotangent_weight(const Diamond& d,
                          double tolerance = 0x1p-40) const requires EuclideanMetric<Metric> {
    if constexpr (by_input) {
      if (const auto weight = metric().stored_weight(d, tolerance)) return *weight;
      const auto exact = self().exact_values();
      if (exact.asks_for_weights()) find_weights();
      if (const auto weight = exact.known_weight(d, metric().statistics())) return *weight;
      return metric().cotangent_weight(d, exact);
    } else {
      return metric().cotangent_weight(d);
    }
  }
  /// makes stored values of faces as accurate as possible; those of all faces, once single ones
  /// have taken as long.
  void sharpen(std::span<const Indexed_face> faces) const requires EuclideanMetric<Metric> {
    if constexpr (by_input) {
      if (self().exact_values().asks_for_faces()) sharpen_all();
      metric().sharpen(faces, self().exact_values());
    }
  }
  /// makes the stored length of the first side of a face as accurate as possible; see above.
  void sharpen_length(const Indexed_face& face) const requires EuclideanMetric<Metric> {
    if constexpr (by_input) {
      if (self().exact_values().asks_for_faces()) sharpen_all();
      metric().sharpen_length(face, self().exact_values());
    }
  }

  /// returns the lambda length of an edge as a double, in the units of the input; with exact traits
  /// to 1e-12 of it.
  double lambda(typename boost::graph_traits<Mesh>::edge_descriptor e)
      const requires internal::Scales_vertices<Metric> {
    const std::uint32_t i = self().index(e);
    if constexpr (by_input)
      if (!metric().is_narrow(i)) {
        const typename Metric::Scope scope;
        metric().sharpen(i, self().exact_values());
      }
    return std::ldexp(metric().approximate_lambda(i), -metric().scale_exponent());
  }
  /// returns the squared length of an edge as a double, in the units of the input; with exact
  /// traits to 1e-12 of it.
  double squared_length(typename boost::graph_traits<Mesh>::edge_descriptor e) const requires
      EuclideanMetric<Metric> {
    return std::ldexp(internal::accurate_squared_length(self(), e), -2 * metric().scale_exponent());
  }
  /// returns the length of an edge as a double, in the units of the input; as accurate as
  /// `squared_length()`, which may overflow.
  double length(typename boost::graph_traits<Mesh>::edge_descriptor e) const requires
      EuclideanMetric<Metric> {
    return std::ldexp(std::sqrt(internal::accurate_squared_length(self(), e)),
                      -metric().scale_exponent());
  }
  /// returns the area of a face as a double, in the units of the input; with exact traits its
  /// relative error is at most the tolerance, and at most 2^-41 where that takes more than the
  /// stored values.
  double area(typename boost::graph_traits<Mesh>::face_descriptor f,
              double tolerance = internal::usual_width) const requires EuclideanMetric<Metric> {
    return std::ldexp(internal::accurate_quadruple_area(self(), f, tolerance),
                      -2 * metric().scale_exponent() - 2);
  }

private:
  // calls a function with what the metric requires to decide
  template <class Function>
  BOOST_FORCEINLINE auto decide(const Function& f) const {
    if constexpr (by_input)
      return f(self().exact_values());
    else
      return f();
  }

  void sharpen_all() const requires EuclideanMetric<Metric> {
    std::vector<Indexed_face> wide;
    for (const auto f : faces(self().mesh()))
      if (const auto face = internal::indexed_face(self(), f); !metric().is_narrow(face))
        wide.push_back(face);
    const auto exact = self().exact_values();
    exact.sharpen_all([&] { metric().sharpen(wide, exact); });
  }

  // of all edges whose stored values are too inaccurate
  void find_weights() const requires EuclideanMetric<Metric> {
    const auto& mesh = self().mesh();
    const auto null = boost::graph_traits<Mesh>::null_face();
    std::vector<Diamond> diamonds;
    for (const auto e : edges(mesh)) {
      const auto h = halfedge(e, mesh);
      if (face(h, mesh) == null || face(opposite(h, mesh), mesh) == null) continue;
      const Diamond d = self().diamond(h);
      if (!metric().stored_weight(d) && !metric().is_known_tie(d)) diamonds.push_back(d);
    }
    std::sort(diamonds.begin(), diamonds.end(),
              [](const Diamond& a, const Diamond& b) { return a.ij < b.ij; });
    self().exact_values().find_weights(diamonds);
  }

  static constexpr bool by_input = internal::Decides_by_input<Metric>;

  const Triangulation& self() const { return static_cast<const Triangulation&>(*this); }
  const Metric& metric() const { return self().metric(); }
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_METRIC_VALUES_H
