// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_CONFORMAL_METRIC_FLAT_SURFACE_H
#define CGAL_INTRINSIC_CONFORMAL_METRIC_FLAT_SURFACE_H

#include <CGAL/Intrinsic_geodesics/cuts/cut_to_disk.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <CGAL/Interval_nt.h>

#include <array>
#include <concepts>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Exact ideal hyperbolic traits.
template <class Triangulation>
concept Has_precise_lambdas = requires(const Triangulation& t, std::uint32_t e) {
  t.decider().template lambdas<Double_double>(std::array{e});
};

// The lambda length of an edge, in scaled units.
template <Has_precise_lambdas Triangulation>
Double_double precise_lambda(const Triangulation& t, std::uint32_t e) {
  const Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
  return t.decider().template lambdas<Double_double>(std::array{e})[0];
}

// The sides of triangles as vectors, each with nearly all digits, in a frame in which the first
// side is on the axis.
// \param lengths of the sides
// \param scale_exponent vectors become shorter by two to this power
std::vector<std::array<double, 2>> vectors_of_triangles(const std::vector<Double_double>& lengths,
                                                        int scale_exponent);

} // namespace internal

/*!
\brief takes the lambda lengths of an ideal Delaunay triangulation as lengths of Euclidean
triangles, for `lay_out_in_plane()` and its relatives.

If `conformal_metric()` has scaled the triangulation, this is the surface with the prescribed
angles. All triangle inequalities hold in an ideal Delaunay triangulation.
\tparam Triangulation a model of `IndexedTriangulation` with ideal hyperbolic traits
\param t the triangulation
\return the surface, in the units of the input; faces in the order of `faces(t.mesh())`, vertices by
  number
\complexity linear
*/
template <IndexedTriangulation Triangulation>
  requires requires(const Triangulation& t) {
    { t.lambda(typename Triangulation::edge_descriptor()) } -> std::same_as<double>;
  }
Surface_to_cut flat_surface(const Triangulation& t) {
  std::vector<double> length(t.numbers().edge_capacity(t.mesh()), 0);
  for (const auto e : edges(t.mesh())) length[t.index(e)] = t.lambda(e);
  Surface_to_cut s =
      internal::surface_to_cut(t.mesh(), t.numbers(), [&](std::uint32_t e) { return length[e]; });
  std::vector<Double_double> lambda; // of each side, in scaled units
  if constexpr (internal::Has_precise_lambdas<Triangulation>) {
    lambda.resize(s.length.size());
    for (const auto e : edges(t.mesh())) {
      const Double_double precise = internal::precise_lambda(t, t.index(e));
      for (const std::uint32_t h : {2 * t.index(e), 2 * t.index(e) + 1})
        if (s.side[h] != Gluing::none) lambda[s.side[h]] = precise;
    }
  }
  s.vector = internal::vectors_of_triangles(lambda, t.metric().scale_exponent());
  return s;
}

/*!
\brief takes the triangles of a surface before the first move, with their lengths.
\param surface the surface
\return the surface, in the units of the user; faces, vertices and halfedges keep their numbers
\complexity linear
*/
inline Surface_to_cut flat_surface(const Input& surface) {
  return internal::surface_to_cut(
      surface.mesh(), Mesh_adaptor<Gluing_map>(surface.mesh()), [&surface](std::uint32_t e) {
        return std::ldexp(std::sqrt(surface.squared_length(e)), -surface.scale_exponent());
      });
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_CONFORMAL_METRIC_FLAT_SURFACE_H
