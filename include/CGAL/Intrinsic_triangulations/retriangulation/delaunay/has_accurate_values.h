// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_HAS_ACCURATE_VALUES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_HAS_ACCURATE_VALUES_H

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
    const auto null = boost::graph_traits<typename Triangulation::Mesh>::null_face();
    const typename Triangulation::Const_session session(t); // for arithmetic of intervals
    for (const typename Triangulation::face_descriptor f : faces(t.mesh()))
      if (!t.metric().is_narrow(internal::indexed_face(t, f), statistics_tolerance)) return false;
    for (const typename Triangulation::edge_descriptor e : edges(t.mesh())) {
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
