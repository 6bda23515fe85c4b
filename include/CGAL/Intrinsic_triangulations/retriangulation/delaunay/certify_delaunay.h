// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_CERTIFY_DELAUNAY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_CERTIFY_DELAUNAY_H

#include <CGAL/Integer_only_triangulation.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/is_straight.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/Delaunay_certificate.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/certify_ideal_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <CGAL/enum.h>

#include <utility>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief decides exactly whether a triangulation is Delaunay, from its integers and the input.
\param t the triangulation; its predicates only count how they were decided
\complexity linear in the number of crossings, mostly; see `Exact_ladder`
*/
template <MutableDeltaComplex Mesh>
Delaunay_certificate certify_delaunay(const Integer_only_triangulation<Mesh>& t) {
  Delaunay_certificate certificate;
  const Predicate_statistics before = std::exchange(t.metric().statistics(), {});
  {
    const typename Integer_only_triangulation<Mesh>::Const_session session(t);
    for (const typename Integer_only_triangulation<Mesh>::face_descriptor f : faces(t.mesh()))
      if (session.orientation(halfedge(f, t.mesh())) != POSITIVE) ++certificate.inverted_faces;
    for (const typename Integer_only_triangulation<Mesh>::edge_descriptor e : edges(t.mesh()))
      if (!internal::is_straight(t, halfedge(e, t.mesh()))) ++certificate.bent_edges;
  }
  const auto report = check_delaunay(t);
  certificate.non_delaunay_edges = report.non_delaunay_edges;
  certificate.ties = report.cocircular_edges.size();
  certificate.statistics = std::exchange(t.metric().statistics(), before);
  return certificate;
}

/*!
\brief decides exactly whether a triangulation from any arithmetic is Delaunay.

It uses only where edges run on the input, and unfolds them there (see
`Integer_only_triangulation`); it reads no lengths, areas or history. Inserted vertices are where
`Integer_coordinates::location()` says, with weights rounded by `representable_weights()`.
With an ideal hyperbolic metric it reads the factors of vertices, too.
\tparam Mesh a model of `MutableDeltaComplex`
\tparam Traits a model of `IntrinsicTriangulationTraits`, with a `EuclideanMetric` or an ideal
  hyperbolic metric
\tparam Correspondence any that answers queries; for ideal hyperbolic metrics
  `Integer_coordinates` or `Explicit_crossings`
\param t the triangulation
\throws Invalid_input and std::length_error as the constructor of `Integer_only_triangulation`
\complexity see the other overload
*/
template <MutableDeltaComplex Mesh, IntrinsicTriangulationTraits Traits,
          internal::Answers_queries Correspondence>
  requires EuclideanMetric<typename Traits::Metric> Delaunay_certificate
  certify_delaunay(const Intrinsic_triangulation<Mesh, Traits, Correspondence>& t) {
    return certify_delaunay(Integer_only_triangulation<Mesh>(t));
  }

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_CERTIFY_DELAUNAY_H
