// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_CONFORMAL_LAYOUT_LAY_OUT_SCALED_H
#define CGAL_INTRINSIC_CONFORMAL_LAYOUT_LAY_OUT_SCALED_H

#include <CGAL/Intrinsic_conformal/angles/Prescribed_angles.h>
#include <CGAL/Intrinsic_conformal/layout/flat_torus.h>
#include <CGAL/Intrinsic_conformal/layout/lay_out_subdivision.h>
#include <CGAL/Intrinsic_conformal/metric/conformal_metric.h>
#include <CGAL/Intrinsic_conformal/metric/flat_surface.h>
#include <CGAL/Intrinsic_conformal/metric/hyperbolic_metric.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_to_disk.h>
#include <CGAL/Intrinsic_operators/parametrization/certify_map.h>
#include <CGAL/Intrinsic_operators/parametrization/measure_distortion.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/overlay_subdivisions.h>
#include <CGAL/Intrinsic_triangulations/input/Element_names.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a mesh on which the triangles of a `Scaled_surface` lie.
*/
struct Scaled_mesh {
  Surface_to_cut triangles;     ///< of the mesh, with their lengths and `side`
  Overlaid_subdivision overlay; ///< of the mesh, the start and the ideal Delaunay triangulation
};

/*!
\brief is a surface with scale factors that make it flat or hyperbolic but for cones, see
`conformal_metric()` and `hyperbolic_metric()`.
*/
struct Scaled_surface {
  /// The triangles of the start, with their lengths and `side`, as `flat_surface()` returns them.
  Surface_to_cut start;
  /// The ideal Delaunay triangulation, with scaled or hyperbolic lengths and `side`.
  Surface_to_cut flat;
  Common_subdivision subdivision;    ///< of both; faces of the start by their numbers
  std::vector<std::uint32_t> row;    ///< of each vertex
  std::vector<double> factors;       ///< of each row
  const Input_names& names;          ///< of the mesh
  const Prescribed_angles& angles;   ///< of each row
  bool is_hyperbolic = false;        ///< whether triangles are hyperbolic
  std::optional<Scaled_mesh> mesh{}; ///< none: the start has the triangles of the mesh
  /// Nonzero for each face of the mesh, by its number there, that has no area but for rounding: its
  /// pieces have none either, and no orientation. Empty: none is.
  std::vector<char> has_no_area{};
};

/*!
\brief gathers what `lay_out_scaled()` needs.
\tparam Triangulation a model of `IndexedTriangulation` with ideal hyperbolic traits and a
  correspondence
\param t the triangulation after `conformal_metric(t, angles)` or `hyperbolic_metric(t, angles)`
\param start `flat_surface(t)` before: `t` was built by `ideal_start()` of an input, or of a
  Euclidean triangulation; then give that to `add_mesh()`, too
\param scale_factors what that has found
\param angles the angles, which must outlive the result
\param names of the input, which must outlive the result
\param is_hyperbolic whether that was `hyperbolic_metric()`
\complexity that of `common_subdivision()`
*/
template <IndexedTriangulation Triangulation>
Scaled_surface scaled_surface(const Triangulation& t, Surface_to_cut start,
                              std::vector<double> scale_factors, const Prescribed_angles& angles,
                              const Input_names& names, bool is_hyperbolic = false) {
  Scaled_surface s{std::move(start),
                   is_hyperbolic ? hyperbolic_surface(t) : flat_surface(t),
                   common_subdivision(t),
                   {},
                   std::move(scale_factors),
                   names,
                   angles,
                   is_hyperbolic};
  s.row.assign(s.flat.gluing.number_of_vertices, Gluing::none);
  for (const typename Triangulation::vertex_descriptor v : vertices(t.mesh()))
    s.row[t.index(v)] = t.input_vertex(v);
  return s;
}

/*!
\brief adds the mesh to a surface that started from a Euclidean triangulation of it: then
`lay_out_scaled()` has pieces that are on one face of the mesh, too, and the seams are its edges.

In a triangle of the start, edges of the mesh and of the ideal Delaunay triangulation are straight,
see `overlay_subdivisions()`; the map is projective on the pieces between them.
\tparam Triangulation a model of `CorrespondingTriangulation`, without inserted vertices
\tparam Ideal a model of `IndexedTriangulation` with ideal hyperbolic traits
\param surface what `scaled_surface(ideal, ...)` returned
\param t the Euclidean triangulation
\param ideal the triangulation that was built by `ideal_start(t)`
\complexity that of `common_subdivision()` and of `overlay_subdivisions()`
*/
template <QueriedTriangulation Triangulation, IndexedTriangulation Ideal>
void add_mesh(Scaled_surface& surface, const Triangulation& t, const Ideal& ideal) {
  surface.mesh.emplace(flat_surface(t.input()),
                       overlay_subdivisions(common_subdivision(t), surface.subdivision, t.input(),
                                            ideal.input().mesh()));
}

/*!
\brief is the layout of a scaled surface in the plane, of a hyperbolic one in Poincaré's disk.
*/
struct Scaled_layout {
  /// The faces of the common subdivision, cut open along edges of the mesh, and their places.
  /// Faces have the numbers of the user's. With a `Scaled_surface::mesh`, intrinsic elements are
  /// those of `Overlaid_subdivision`.
  Subdivision_layout layout;
  /// The same faces without the cuts: corners have the places of `layout`.
  Common_subdivision closed;
  /// The user's vertices at the ends of each edge that was cut.
  std::vector<std::array<std::uint32_t, 2>> seams;
  Map_certificate certificate; ///< see `certify_map()`
  /// How many triangles that the certificate counts as turned or without area lie on faces of the
  /// mesh that have none.
  std::size_t without_area = 0;
  /// See `flipped_geodesic_triangles()`; 0 if the surface is not hyperbolic.
  std::size_t flipped_geodesic_triangles = 0;
  Map_distortion distortion; ///< from the faces of the mesh to the plane

  /// returns `inaccurate` if the metric was found, but triangles of pieces have turned over or have
  /// no area though the face of the mesh has, with geodesic sides if the surface is hyperbolic;
  /// else the status of the metric.
  Status status(Status of_metric) const {
    const std::size_t turned =
        (layout.is_hyperbolic ? flipped_geodesic_triangles
                              : certificate.flipped + certificate.degenerate) -
        without_area;
    return of_metric == Status::done && turned != 0 ? Status::inaccurate : of_metric;
  }
};

/*!
\brief lays a scaled surface out in the plane, by projective interpolation, see
`lay_out_subdivision()`. Of the double of a surface with border, it lays out the front. The cut is
that of `cut_to_disk()`, of hyperbolic surfaces that of `cut_to_round_disk()`.
\param surface the surface
\param torus none, or the torus that it is: coordinates are then in the basis of its translations
\return the layout
\throws Invalid_input if the surface is a cover but not a double, and so has no front
\complexity that of a sparse factorization, and n log n
*/
Scaled_layout lay_out_scaled(const Scaled_surface& surface, const Flat_torus* torus = nullptr);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_CONFORMAL_LAYOUT_LAY_OUT_SCALED_H
