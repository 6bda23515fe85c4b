// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_QUERIES_CERTIFY_ON_FACES_H
#define CGAL_INTRINSIC_GEODESICS_QUERIES_CERTIFY_ON_FACES_H

#include <CGAL/Intrinsic_geodesics/queries/trace_curve.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>

#include <CGAL/Interval_nt.h>

#include <string>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is what was proven about a path on the faces under a double cover.
*/
struct Certificate_on_faces {
  /// What could not be proven, and why, in words for the user; empty: the path is locally shortest
  /// among all paths on the faces, any number of which may meet at an edge.
  std::string obstacle;
  /// An interval that contains the length, in the units of the input; [0, infinity] if not all
  /// pieces are proven to be straight.
  Interval_nt<> length{0};

  /// tells whether the path is proven to be locally shortest.
  bool is_geodesic() const { return obstacle.empty(); }
};

/*!
\brief proves that a path on the faces under a double cover is locally shortest there.

Between two vertices, the faces that the path passes are unfolded, each pair along the edge that is
crossed, from the exact lengths of the input, in balls of many bits: the straight line between the
ends must leave the ends of all crossed edges strictly on its two sides. At a vertex on the path,
every way around through the faces that meet there, at edges of any number of faces, must turn by at
least pi. An angle of exactly pi, as at a vertex in a plane, is proven in the field of the square
roots of the areas, as in a triangulation (`Multiquadratic_number`). If numbers there have too many
terms, nothing is proven.
\param input the double cover \param path a path on the fronts of its faces, as
`trace_shortest_path()` returns it for a search on the faces
\complexity quadratic in the number of crossed edges, for the bits; and linear in the faces for each
  vertex that the path passes. Proofs in the field are bounded by `thresholds::words_over_prisms`.
*/
Certificate_on_faces certify_on_faces(const Input& input, const Traced_curve& path);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_QUERIES_CERTIFY_ON_FACES_H
