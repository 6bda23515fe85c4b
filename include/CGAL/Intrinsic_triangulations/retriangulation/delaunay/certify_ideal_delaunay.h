// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_CERTIFY_IDEAL_DELAUNAY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_CERTIFY_IDEAL_DELAUNAY_H

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_ideal_hyperbolic_traits.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/Delaunay_certificate.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

namespace CGAL::Intrinsic_triangulations {

/// \cond see the overload for Euclid's metric: doxygen cannot tell the two apart
// Uses only where edges run on the input, the lengths there, and the factors of vertices: no stored
// lambda lengths and no history. Normal coordinates define straight edges, and there are no areas,
// so that no face is inverted and no edge bent.
template <MutableDeltaComplex Mesh, IntrinsicTriangulationTraits Traits, class Correspondence>
  requires internal::Scales_vertices<typename Traits::Metric> &&
      IntegerCorrespondence<Correspondence>
          Delaunay_certificate
          certify_delaunay(const Intrinsic_triangulation<Mesh, Traits, Correspondence>& ideal) {
    using Exact = Intrinsic_triangulation<Mesh, Exact_ideal_hyperbolic_traits, Integer_coordinates>;
    const Input& input = ideal.input();
    Exact exact(ideal, Exact_ideal_hyperbolic_metric(input.mesh(), input.metric()),
                ideal.correspondence().integer_coordinates());
    if (!ideal.metric().relative_factors().empty())
      exact.scale_vertices(ideal.metric().relative_factors(), ideal.metric().rests());
    const typename Exact::Metric::Scope scope;
    for (const auto e : edges(exact.mesh())) exact.decider().sharpen(exact.index(e));
    exact.metric().statistics() = {};
    const auto report = check_delaunay(exact);
    Delaunay_certificate certificate;
    certificate.non_delaunay_edges = report.non_delaunay_edges;
    certificate.ties = report.cocircular_edges.size();
    certificate.statistics = exact.metric().statistics();
    return certificate;
  }
/// \endcond

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_CERTIFY_IDEAL_DELAUNAY_H
