// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_HAS_ACCURATE_VALUES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_HAS_ACCURATE_VALUES_H

#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/Summed_weights.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/measure_quality.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Metric_values.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <boost/graph/graph_traits.hpp>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief tells whether `measure()` reads stored values as they are.

Else, with exact traits around slivers, it makes them more accurate: then the last bits of what is
computed afterwards depend on whether it was called.
\tparam Triangulation a model of `MeasuredTriangulation` and `NumberedTriangulation`
\param t the triangulation, which does not change at all
\return true for traits without enclosures
\complexity linear
*/
template <NumberedTriangulation Triangulation>
  requires MeasuredTriangulation<Triangulation>
bool has_accurate_values(const Triangulation& t) {
  if constexpr (internal::Has_enclosures<typename Triangulation::Metric>) {
    const double width = internal::relative_width(t);
    const bool has_wide = !(width <= statistics_tolerance);
    internal::Summed_weights<Triangulation> sums(t, width);
    for (const typename Triangulation::face_descriptor f : faces(t.mesh())) {
      const Indexed_face face = internal::indexed_face(t, f);
      if (has_wide && !t.metric().is_narrow(face, statistics_tolerance)) return false;
      const Face_values<double> values = internal::approximate_values(t.metric(), face);
      const double inverse = 1 / values.quadruple_area;
      sums.add(face, values, inverse, internal::cotangents_of(values, inverse));
    }
    const auto null = boost::graph_traits<typename Triangulation::Mesh>::null_face();
    const typename Triangulation::Const_session session(t); // for arithmetic of intervals
    for (const typename Triangulation::edge_descriptor e : edges(t.mesh())) {
      if (sums.certain(t.index(e), statistics_tolerance)) continue;
      const auto h = halfedge(e, t.mesh());
      if (face(h, t.mesh()) == null || face(opposite(h, t.mesh()), t.mesh()) == null) continue;
      if (!t.metric().stored_weight(t.diamond(h), statistics_tolerance) &&
          !t.metric().remembered_signs().is_zero(t.index(e)))
        return false;
    }
  }
  return true;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_HAS_ACCURATE_VALUES_H
