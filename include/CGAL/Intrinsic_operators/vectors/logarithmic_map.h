// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_VECTORS_LOGARITHMIC_MAP_H
#define CGAL_INTRINSIC_OPERATORS_VECTORS_LOGARITHMIC_MAP_H

#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_operators/operators/Connection_graph.h>
#include <CGAL/Intrinsic_operators/vectors/Point_frames.h>
#include <CGAL/Intrinsic_operators/vectors/Vectors_on_sheets.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Sheets.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Vertex_frames.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/trace_geodesic.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <complex>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// The method for a logarithmic map.
enum class Logarithm_method {
  /// by exact distances and the shortest paths: `logarithmic_map()`, without heat
  exact,
  /// by heat of affine vectors: exact on flat surfaces, smooth, fast for many sources (Soliman and
  /// Sharp 2025)
  affine,
  /// by the angle between a radial and a parallel field, and the distance whose gradient is the
  /// radial field (Sharp et al. 2019)
  polar
};

/// returns the name of a method, such as "exact".
inline const char* name_of(Logarithm_method method) {
  return method == Logarithm_method::exact    ? "exact"
         : method == Logarithm_method::affine ? "affine"
                                              : "polar";
}

/*!
\brief follows a vector at a vertex straight over the surface, for its length (§2.4.2 of the
course): the exponential map, the inverse of logarithmic maps. A vector that points out of the
surface leads nowhere: the geodesic ends where it starts, with the status `border`.
\tparam Triangulation a model of `NumberedTriangulation`
\param t the triangulation
\param v the vertex, which is not isolated
\param z the vector, in the polar coordinates of the vertex and the units of the input
\return the geodesic, whose last point is the result
\complexity that of `trace_geodesic()`
*/
template <NumberedTriangulation Triangulation>
Geodesic exponential_map(const Triangulation& t, typename Triangulation::vertex_descriptor v,
                         const std::complex<double>& z) {
  const Tangent_vector start = tangent_vector(t, v, z == 0. ? 1 : z);
  return trace_geodesic(t, start.point, start.vector, std::abs(z));
}

/// follows a vector at a point, in the frame of its halfedge; see above.
template <NumberedTriangulation Triangulation>
Geodesic exponential_map(const Triangulation& t, const Surface_point& p,
                         const std::complex<double>& z) {
  const std::complex<double> direction = z == 0. ? 1 : z;
  return trace_geodesic(t, p, {direction.real(), direction.imag()}, std::abs(z));
}

namespace internal {

// The result of `to_frame` for the logarithm of each vertex, by its number. The visitor of the
// search is asked again and again.
template <class Triangulation, class NP, class To_frame>
std::vector<std::complex<double>> logarithms(const Point_frames<Triangulation>& frames,
                                             const Polyhedral_distance<Triangulation>& distance,
                                             const NP& np, const To_frame& to_frame) {
  auto stored_visitor = object_or<tags::visitor>(np, Polyhedral_distance_visitor());
  auto& observed = unwrapped(stored_visitor);
  std::vector<std::complex<double>> result(frames.size(), unknown_vector);
  std::size_t count = 0;
  for (const auto v : vertices(frames.triangulation().mesh())) {
    if (++count % 1024 == 0 &&
        !observed.progress(distance.number_of_windows(), distance.reached_distance()))
      break;
    const Tangent_vector x = distance.logarithm(v);
    if (std::isfinite(x.vector[0])) result[frames.number(v)] = to_frame(x);
  }
  return result;
}

// Takes vectors from faces of the user under a cover to the coordinates of a copy of a vertex, if
// one side of the face is about it; else to those of another copy.
template <class Triangulation>
class Vectors_at_copy {
  using Vertex = typename Triangulation::vertex_descriptor;

public:
  Vectors_at_copy(const Point_frames<Triangulation>& frames, Vertex v)
      : frames_(frames), sheets_(frames.triangulation()), v_(v) {}

  std::complex<double> operator()(const Tangent_vector& on_input) const {
    const Triangulation& t = frames_.triangulation();
    const auto front = tangent_to_intrinsic(t, on_input);
    if (!front) return unknown_vector;
    std::complex<double> result = unknown_vector;
    for (const Tangent_vector& x : sheets_(*front)) {
      const auto corner = frames_.corners(x.point)[0];
      const bool is_here = corner.vertex == frames_.number(v_);
      if (is_known(result) && !is_here) continue;
      result = frames_.to_field(corner.vertex, corner.to_here({x.vector[0], x.vector[1]}));
      if (is_here) break;
    }
    return result;
  }

private:
  const Point_frames<Triangulation>& frames_;
  Vectors_on_sheets<Triangulation> sheets_;
  Vertex v_;
};

// A vector in the frame of a halfedge of the same face, or of one beside it; else unknown.
template <class Triangulation>
std::complex<double> vector_in_frame(const Triangulation& t, const Tangent_vector& v,
                                     std::uint32_t halfedge) {
  const Intrinsic_view<Triangulation> view(t);
  const Geodesic_face from(view, v.point.halfedge), to(view, halfedge);
  for (unsigned k = 0; k < 3; ++k)
    for (unsigned j = 0; j < 3; ++j) {
      const bool is_same = from.side[k] == to.side[j];
      if (!is_same && from.side[k] != (to.side[j] ^ 1U)) continue;
      const Unscaled_vector along = from.relative_to(k, v.vector),
                            x = to.from_relative_to(j, is_same ? along : -1. * along);
      return {x[0], x[1]};
    }
  return unknown_vector;
}

// Takes vectors at a point from faces of the user under a cover to the frame of its halfedge, or of
// another copy of the point if they are in no face beside it.
template <class Triangulation>
class Vectors_at_point {
public:
  Vectors_at_point(const Triangulation& t, const Surface_point& p)
      : t_(t), sheets_(t), halfedges_{p.halfedge} {
    if (const std::optional<Surface_point> here = locate_on_input(t, p))
      for (const Surface_point& q : Sheets(t.correspondence().input()).others(*here))
        if (const auto copy = locate_on_intrinsic(t, q)) halfedges_.push_back(copy->halfedge);
  }

  std::complex<double> operator()(const Tangent_vector& on_input) const {
    if (const auto front = tangent_to_intrinsic(t_, on_input))
      for (const std::uint32_t h : halfedges_)
        for (const Tangent_vector& v : sheets_(*front))
          if (const auto z = vector_in_frame(t_, v, h); is_known(z)) return z;
    return unknown_vector;
  }

private:
  const Triangulation& t_;
  Vectors_on_sheets<Triangulation> sheets_;
  std::vector<std::uint32_t> halfedges_; // of the copies
};

} // namespace internal

/*!
\brief finds the logarithmic map of a vertex, without discretization: for each vertex the vector at
  `v` along the shortest path to it, as long as the path (see `exponential_map()`).

Lengths and directions are those of `Polyhedral_distance`, so the result does not depend on the
triangulation of the surface. In the plane it is the displacement. Shortest paths bend only at
vertices with more than a full turn of angle: all vertices behind such a vertex have its direction.

On a cover with a correspondence, paths are those on the faces under it, see
`Polyhedral_distance::on_faces()`. A vector is that on the side of its face that is about `v`; if
none is, it is in the coordinates of another copy. (On a soup, some faces at a vertex may be about
other copies of it on both sides.) Without a correspondence, vectors along paths from other copies
are unknown.
\tparam Triangulation a model of `MeasuredTriangulation` and `NumberedTriangulation`
\param t the triangulation
\param v the vertex, which is not isolated
\param np named parameters of `Polyhedral_distance`: `maximum_distance(d)` finds the map near the
vertex only, and takes less time. The visitor is called while vectors are found, too; if it ends the
work, the others are NaN
\return by the numbers of a `Tangent_field`, vectors in the coordinates of `v`; NaN on other
components and beyond the maximum distance
\throws std::invalid_argument if the vertex is isolated, or the surface is that of a cloud of
  points, see `Point_cloud_vectors`
\complexity that of `Polyhedral_distance`, and linear in the number of edges that all shortest
  paths cross
*/
template <ConnectedTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
std::vector<std::complex<double>> logarithmic_map(const Triangulation& t,
                                                  typename Triangulation::vertex_descriptor v,
                                                  const NP& np = parameters::default_values()) {
  internal::expect_tangent_planes(t);
  const internal::Point_frames<Triangulation> frames(t);
  if (frames.is_isolated(v))
    throw std::invalid_argument("vertex " + std::to_string(frames.number(v)) +
                                " has no face, so that there are no vectors at it");
  auto distance = Polyhedral_distance<Triangulation>::on_faces(t);
  distance.search(v, np);
  if constexpr (CorrespondingTriangulation<Triangulation>)
    if (distance.is_on_faces())
      return internal::logarithms(frames, distance, np,
                                  internal::Vectors_at_copy<Triangulation>(frames, v));
  return internal::logarithms(frames, distance, np, [&](const Tangent_vector& x) {
    return frames.to_field(frames.number(v), frames.at_corner(x.point, x.vector));
  });
}

/*!
\brief finds the logarithmic map of a point; see above.
\return vectors in the frame of `p.halfedge`; at a vertex, angles from the sides of its face are
  those on the surface
*/
template <ConnectedTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
std::vector<std::complex<double>> logarithmic_map(const Triangulation& t, const Surface_point& p,
                                                  const NP& np = parameters::default_values()) {
  internal::expect_tangent_planes(t);
  const internal::Point_frames<Triangulation> frames(t);
  if (const unsigned k = internal::corner_of(p); k < 3) {
    const Intrinsic_view<Triangulation> view(t);
    const auto v = t.numbers().vertex_at(view.source(sides_of_face(view, p.halfedge)[k]));
    std::vector<std::complex<double>> result = logarithmic_map(t, v, np);
    for (std::complex<double>& z : result)
      z = frames.from_corner(p, frames.from_field(frames.number(v), z));
    return result;
  }
  auto distance = Polyhedral_distance<Triangulation>::on_faces(t);
  distance.search(p, np);
  if constexpr (CorrespondingTriangulation<Triangulation>)
    if (distance.is_on_faces())
      return internal::logarithms(frames, distance, np,
                                  internal::Vectors_at_point<Triangulation>(t, p));
  return internal::logarithms(frames, distance, np, [](const Tangent_vector& x) {
    return std::complex(x.vector[0], x.vector[1]);
  });
}

/// \cond
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_MESH(logarithmic_map)
/// \endcond

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_VECTORS_LOGARITHMIC_MAP_H
