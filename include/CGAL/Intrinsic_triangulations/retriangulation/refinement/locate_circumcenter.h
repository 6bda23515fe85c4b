// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_LOCATE_CIRCUMCENTER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_LOCATE_CIRCUMCENTER_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_walk.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief returns the barycentric coordinates of the circumcenter of a face: in order, of the corners
where the sides start.

L_jk (L_ij + L_ki - L_jk) / a^2 for the corner i, as these products sum to a^2 (Heron).
\param squared_lengths of the sides ij, jk, ki
\param area the quadruple area a \pre it is not zero
*/
inline std::array<double, 3> circumcenter(const std::array<double, 3>& squared_lengths,
                                          double area) {
  const auto& [ij, jk, ki] = squared_lengths;
  return {jk / area * ((ij + ki - jk) / area), ki / area * ((jk + ij - ki) / area),
          ij / area * ((ki + jk - ij) / area)};
}

/// Where the walk from a face to its circumcenter ends.
struct Located_circumcenter {
  /// The kinds of ends.
  enum class Kind {
    point,   ///< at the circumcenter
    segment, ///< at an edge that may not be crossed
    none     ///< nowhere: rounding misled the walk
  };
  /// The result.
  Kind kind;
  /// The circumcenter. It is never at a vertex; if it is close to an edge up to rounding, it is on
  /// it.
  Surface_point point;
  /// The edge that may not be crossed: the halfedge of the side that was reached.
  std::uint32_t segment;
};

namespace internal {

// Relative distance from an edge within which a point is moved onto it: else it would make a face
// of height 2^-30, which takes more bits to decide, and could meet no bound on angles.
inline constexpr double on_edge = 0x1p-30;
// A walk is this many faces long at most; those to circumcenters cross few: 30 are enough on 85
// meshes of the data set.
inline constexpr std::size_t longest_walk = 10000;

template <class Is_segment>
Located_circumcenter arrived(Surface_point p, const Geodesic_face& face,
                             const Is_segment& is_segment) {
  using Kind = Located_circumcenter::Kind;
  std::size_t zeros = 0, side = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (p.weights[k] > on_edge) continue;
    p.weights[k] = 0;
    ++zeros;
    side = (k + 1) % 3;
  }
  if (zeros > 1) return {Kind::none, p, Gluing::none};
  if (zeros == 1) {
    // the two others sum to one exactly, up to one rounding
    p.weights[side] = 1 - p.weights[(side + 1) % 3];
    if (is_segment(face.side[side])) return {Kind::segment, p, face.side[side]};
  }
  return {Kind::point, p, Gluing::none};
}

} // namespace internal

/*!
\brief finds the circumcenter of a face, or a point near it: from the barycenter straight on.

In a Delaunay triangulation the disk about it contains no vertex and is therefore flat.
\tparam Complex a model of `NumberedComplex`
\tparam Is_segment a functor from a halfedge to whether its edge must not be crossed: true on the
border
\param complex the surface
\param h a halfedge of the face
\param is_segment the functor
\param offset from the circumcenter to the point, where `h` has the direction of the first axis
\complexity linear in the number of faces crossed
*/
template <NumberedComplex Complex, std::predicate<std::uint32_t> Is_segment>
Located_circumcenter locate_circumcenter(const Complex& complex, std::uint32_t h,
                                         const Is_segment& is_segment,
                                         const Plane_vector<double>& offset = {0, 0}) {
  using Kind = Located_circumcenter::Kind;
  const Located_circumcenter nowhere{Kind::none, {Gluing::none, {}}, Gluing::none};
  const Geodesic_face face(complex, h);
  const double area = complex.quadruple_area(complex.face(h));
  if (!(area > 0)) return nowhere;
  std::array<double, 3> w = circumcenter({complex.squared_length(face.side[0] / 2),
                                          complex.squared_length(face.side[1] / 2),
                                          complex.squared_length(face.side[2] / 2)},
                                         area);
  if (offset[0] != 0 || offset[1] != 0) {
    const double along_last = -offset[1] / face.edge[2][1];
    const double along_first = (offset[0] + along_last * face.edge[2][0]) / face.edge[0][0];
    w = {w[0] - along_first - along_last, w[1] + along_first, w[2] + along_last};
  }
  if (w[0] >= 0 && w[1] >= 0 && w[2] >= 0) return internal::arrived({h, w}, face, is_segment);
  // from the barycenter, which is at a third of the sum of the vectors to the corners
  const double third = 1.0 / 3, x = w[1] - third, y = w[2] - third;
  const Plane_vector<double> v = x * face.edge[0] - y * face.edge[2];
  const double length = std::hypot(v[0], v[1]);
  if (!(length > 0) || !std::isfinite(length)) return nowhere;
  internal::Geodesic_walk<Complex> walk(complex, {h, {1 - 2 * third, third, third}}, v);
  for (std::size_t n = 0; n < internal::longest_walk; ++n) {
    const typename internal::Geodesic_walk<Complex>::Exit e = walk.exit();
    const double remaining = std::max(0.0, length - walk.travelled());
    if (remaining <= e.distance)
      return internal::arrived(walk.point(e, remaining), walk.face(), is_segment);
    if (is_segment(walk.halfedge(e)))
      return {Kind::segment, walk.point(e, e.distance), walk.halfedge(e)};
    walk.advance(e);
    walk.cross(e);
  }
  return nowhere;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_LOCATE_CIRCUMCENTER_H
