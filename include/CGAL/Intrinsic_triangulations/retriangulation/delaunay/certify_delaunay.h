// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_CERTIFY_DELAUNAY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_CERTIFY_DELAUNAY_H

#include <CGAL/Integer_only_triangulation.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <CGAL/enum.h>

#include <cstddef>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief certifies a triangulation exactly. If there are inverted faces or bent edges, it is not a
triangulation, and the other numbers have no meaning.
*/
struct Delaunay_certificate {
  /// Faces whose area is not positive: their edges cross, because of rounding.
  std::size_t inverted_faces = 0;
  /// Edges that do not run straight: a straight path between their ends passes vertices on another
  /// side.
  std::size_t bent_edges = 0;
  /// Edges whose opposite angles sum to more than pi.
  std::size_t non_delaunay_edges = 0;
  /// Edges whose opposite angles sum to exactly pi.
  std::size_t ties = 0;
  /// How the signs were decided.
  Predicate_statistics statistics;

  /// tells whether the triangulation is an intrinsic Delaunay triangulation, proven unless
  /// `statistics.probable_zero` is positive.
  bool is_delaunay() const {
    return inverted_faces == 0 && bent_edges == 0 && non_delaunay_edges == 0;
  }
};

/*!
\brief decides exactly whether a triangulation is Delaunay, from its integers and the input.
\param t the triangulation; its predicates only count how they were decided
\complexity linear in the number of crossings, mostly; see `Integer_geometry::sign()`
*/
template <MutableDeltaComplex Mesh>
Delaunay_certificate certify_delaunay(const Integer_only_triangulation<Mesh>& t) {
  Delaunay_certificate certificate;
  const Predicate_statistics before = std::exchange(t.statistics(), {});
  {
    const typename Integer_only_triangulation<Mesh>::Const_session session(t);
    for (const typename Integer_only_triangulation<Mesh>::face_descriptor f : faces(t.mesh()))
      if (session.orientation(halfedge(f, t.mesh())) != POSITIVE) ++certificate.inverted_faces;
    for (const typename Integer_only_triangulation<Mesh>::edge_descriptor e : edges(t.mesh()))
      if (!session.is_straight(halfedge(e, t.mesh()))) ++certificate.bent_edges;
  }
  const auto report = check_delaunay(t);
  certificate.non_delaunay_edges = report.non_delaunay_edges;
  certificate.ties = report.cocircular_edges.size();
  certificate.statistics = std::exchange(t.statistics(), before);
  return certificate;
}

/*!
\brief decides exactly whether a triangulation from any arithmetic is Delaunay.

It uses only where edges run on the input, and unfolds them there (see
`Integer_only_triangulation`); it reads no lengths, areas or history. Inserted vertices are where
`Integer_coordinates::location()` says, with weights rounded by `representable_weights()`.
\tparam Mesh a model of `MutableDeltaComplex`
\tparam Traits a model of `IntrinsicTriangulationTraits`
\tparam Correspondence any that answers queries
\param t the triangulation
\throws Invalid_input and std::length_error as the constructor of `Integer_only_triangulation`
\complexity see the other overload
*/
template <MutableDeltaComplex Mesh, IntrinsicTriangulationTraits Traits,
          internal::Answers_queries Correspondence>
Delaunay_certificate
certify_delaunay(const Intrinsic_triangulation<Mesh, Traits, Correspondence>& t) {
  return certify_delaunay(Integer_only_triangulation<Mesh>(t));
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_CERTIFY_DELAUNAY_H
