// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_METRIC_VALUES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_METRIC_VALUES_H

#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/nonnegative_intervals.h>
#include <CGAL/Intrinsic_triangulations/metric/Enclosed_values.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <CGAL/enum.h>

#include <boost/config.hpp>
#include <boost/graph/graph_traits.hpp>

#include <cstdint>
#include <span>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Greatest relative width of the intervals of values that users get.
inline constexpr double usual_width = Enclosed_values::narrow;

// The numbers of the face of a halfedge and of its sides, from that one on. Inlined by force: in a
// loop over all faces the call takes as long as what it does.
template <class Triangulation>
BOOST_FORCEINLINE Indexed_face indexed_face_from(const Triangulation& t,
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
\brief has what a triangulation asks its metric, or the decider of a metric that leaves questions
open.

Functions with numbers of faces and edges require a live session.
\tparam Triangulation derives from this class, and has `decider()`
*/
template <class Triangulation, MutableDeltaComplex Mesh, IntrinsicMetric Metric>
class Metric_values {
public:
  /// returns the sign of an expression in the values of a diamond, exact with exact traits.
  /// \tparam Expression a model of `DiamondExpression`
  template <class Expression>
  Sign sign(const Diamond& d,
            const Expression& expression) const requires internal::Decides_signs<Metric> {
    return self().decider().sign(d, expression);
  }
  /// returns the sign of an expression in the values of faces, exact with exact traits.
  /// \tparam Expression a model of `FaceExpression`
  template <class Expression>
  Sign sign(std::span<const Indexed_face> faces,
            const Expression& expression) const requires internal::Decides_signs<Metric> {
    return self().decider().sign(faces, expression);
  }
  /// tells whether the angles opposite the edge of a diamond sum to at most pi.
  BOOST_FORCEINLINE bool is_locally_delaunay(const Diamond& d) const {
    if constexpr (internal::Answers_if_certain<Metric>) {
      static_assert(
          !requires(const Metric& m) { m.is_locally_delaunay(d); },
          "a metric with certain_delaunay() is asked that, never is_locally_delaunay()");
      const Certainty c = metric().certain_delaunay(d);
      return c == Certainty::open ? is_open_delaunay(d) : c == Certainty::yes;
    } else {
      return metric().is_locally_delaunay(d);
    }
  }
  /// returns the sign of pi minus the angles opposite the edge of a diamond.
  Sign delaunay_sign(const Diamond& d) const {
    if constexpr (internal::Decides_signs<Metric>)
      return sign(d, Delaunay_expression());
    else
      return self().decider().delaunay_sign(d);
  }
  /// tells whether the diamond is strictly convex, so that its edge can be flipped.
  bool is_flippable(const Diamond& d) const {
    if constexpr (internal::Decides_signs<Metric>)
      return sign(d, Convexity_at_source_expression()) == POSITIVE &&
             sign(d, Convexity_at_target_expression()) == POSITIVE;
    else
      return self().decider().is_flippable(d);
  }
  /// returns half the sum of the cotangents of the angles opposite the edge of a diamond; see
  /// `Enclosed_values::stored_weight()` for the tolerance, which other traits ignore.
  double cotangent_weight(const Diamond& d, double tolerance = Enclosed_values::weight_tolerance)
      const requires EuclideanMetric<Metric> {
    if constexpr (internal::Has_enclosures<Metric>)
      return self().decider().cotangent_weight(d, tolerance);
    else
      return metric().cotangent_weight(d);
  }
  /// makes stored values of faces as accurate as possible; those of all faces, once single ones
  /// have taken as long.
  void sharpen(std::span<const Indexed_face> faces) const requires EuclideanMetric<Metric> {
    if constexpr (internal::Has_enclosures<Metric>) self().decider().sharpen(faces);
  }
  /// makes the stored length of the first side of a face as accurate as possible; see above.
  void sharpen_length(const Indexed_face& face) const requires EuclideanMetric<Metric> {
    if constexpr (internal::Has_enclosures<Metric>) self().decider().sharpen_length(face);
  }

  /// returns the lambda length of an edge as a double, in the units of the input; with exact traits
  /// to 1e-12 of it.
  double lambda(typename boost::graph_traits<Mesh>::edge_descriptor e)
      const requires internal::Scales_vertices<Metric> {
    const std::uint32_t i = self().index(e);
    if constexpr (internal::Answers_if_certain<Metric>)
      if (!metric().is_narrow(i)) {
        const typename Metric::Scope scope;
        self().decider().sharpen(i);
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
  // not within the loop that flips
  BOOST_NOINLINE bool is_open_delaunay(const Diamond& d) const {
    return self().decider().is_open_delaunay(d);
  }

  const Triangulation& self() const { return static_cast<const Triangulation&>(*this); }
  const Metric& metric() const { return self().metric(); }
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_METRIC_VALUES_H
