// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_DELAUNAY_CERTIFICATE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_DELAUNAY_CERTIFICATE_H

#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>

#include <cstddef>

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

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_DELAUNAY_CERTIFICATE_H
