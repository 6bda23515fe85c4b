// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_MEASURES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_MEASURES_H

#include <CGAL/Intrinsic_triangulations/connectivity/for_each_outgoing.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/triangle_formulas.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Metric_values.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <concepts>
#include <cstdint>
#include <limits>
#include <vector>

/*!
\file
Measures of single elements and of the whole surface (§2.3 of the course).
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Stores exact numbers, or intervals that contain them.
template <class Metric>
concept Encloses_lengths = requires(const Metric& m, std::uint32_t e) {
  CGAL::to_interval(m.squared_length(e));
  requires Metric::is_exact || std::same_as<typename Metric::FT, Interval_nt<false>>;
};

} // namespace internal

/*!
\brief returns an interval that contains the length of an edge: that of the input as its numbers
define it, after mollification, and between inserted vertices.

With exact traits the bounds differ by 1e-12 of the length at most, with `Interval_traits` by the
width of the stored intervals. Other inexact arithmetic has no error bounds: then the interval is
[0, infinity].
\param t the triangulation
\param e the edge
\return bounds in the units of the input
\complexity that of `Intrinsic_triangulation::length()`
*/
template <MeasuredTriangulation Triangulation>
Interval_nt<> length_enclosure(const Triangulation& t, typename Triangulation::edge_descriptor e) {
  if constexpr (internal::Encloses_lengths<typename Triangulation::Metric>) {
    t.length(e); // narrows stored intervals
    const auto squared = CGAL::to_interval(t.metric().squared_length(t.index(e)));
    const int s = t.metric().scale_exponent(); // 2^-s need not be a double, its parts are
    return sqrt(Interval_nt<>(squared)) * Interval_nt<>(std::ldexp(1.0, -s / 2)) *
           Interval_nt<>(std::ldexp(1.0, s / 2 - s));
  } else {
    return {0, std::numeric_limits<double>::infinity()};
  }
}

/*!
\brief returns the cotangent weight of an edge: half the sum of the cotangents of the angles
opposite it (Eq. 4 of the course), one of them on the border.

See `Predicate_session::cotangent_weight()`, which is faster for many edges.
\tparam Triangulation a model of `MeasuredTriangulation`
\param t the triangulation
\param e the edge
\return the weight, without dimension; with exact traits to 1e-12 of it, or of the Dirichlet energy
  of its faces, and zero only if the opposite angles sum to pi
\pre the faces at the edge have an area; else the result is not finite
\complexity constant
*/
template <MeasuredTriangulation Triangulation>
double cotangent_weight(const Triangulation& t, typename Triangulation::edge_descriptor e) {
  return typename Triangulation::Const_session(t).cotangent_weight(e);
}

/*!
\brief returns the Gaussian curvature of a vertex, as a measure: 2 pi minus the sum of the angles
around it (Eq. 3 of the course); on the border the geodesic curvature of the border: pi minus that
sum.

Moves do not change it, and it is zero at inserted vertices. The sum over all vertices is 2 pi times
the Euler characteristic (Gauss and Bonnet). Divided by the entry of the lumped mass matrix it
approximates curvature in a point.
\tparam Triangulation a model of `MeasuredTriangulation`
\param t the triangulation
\param v the vertex; at one that is not manifold, the faces are those of one fan
\return the curvature in radians; errors of angles are those of the values (1e-12 with exact traits)
  times the aspect ratio of the face
\pre no edge at the vertex has the length zero
\complexity linear in the degree
*/
template <MeasuredTriangulation Triangulation>
double gaussian_curvature(const Triangulation& t, typename Triangulation::vertex_descriptor v) {
  using Halfedge = typename Triangulation::halfedge_descriptor;
  using Traits = boost::graph_traits<typename Triangulation::Mesh>;
  const auto& mesh = t.mesh();
  CGAL_precondition(halfedge(v, mesh) != Traits::null_halfedge());
  std::vector<double> angles;
  bool is_on_border = false;
  for_each_outgoing(v, mesh, [&](Halfedge h) {
    if (face(h, mesh) == Traits::null_face()) {
      is_on_border = true;
      return;
    }
    const Face_values<double> values = internal::accurate_values(t, face(h, mesh));
    std::size_t k = 0;
    for (Halfedge g = halfedge(face(h, mesh), mesh); g != h; g = next(g, mesh)) ++k;
    const auto& l = values.squared_lengths;
    angles.push_back(corner_angle(values.quadruple_area,
                                  twice_inner_product(l[k], l[(k + 1) % 3], l[(k + 2) % 3])));
  });
  return is_on_border ? boundary_geodesic_curvature(angles) : angle_defect(angles);
}

/*!
\brief returns the area of the surface.
\tparam Triangulation a model of `MeasuredTriangulation`
\param t the triangulation
\return the sum of the areas of the faces, in the units of the input; with exact traits to 1e-12 of
it
\complexity linear
*/
template <MeasuredTriangulation Triangulation>
double total_area(const Triangulation& t) {
  double sum = 0, lost = 0; // with compensation, as surfaces have many faces
  for (const typename Triangulation::face_descriptor f : faces(t.mesh())) {
    const auto s = internal::two_sum(sum, t.area(f));
    sum = s.high;
    lost += s.low;
  }
  return sum + lost;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_MEASURES_H
