// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_CONFORMAL_LAYOUT_CONFORMAL_SPHERE_H
#define CGAL_INTRINSIC_CONFORMAL_LAYOUT_CONFORMAL_SPHERE_H

#include <CGAL/Intrinsic_conformal/angles/Ideal_surface_of.h>
#include <CGAL/Intrinsic_conformal/layout/lay_out_on_sphere.h>
#include <CGAL/Intrinsic_conformal/metric/conformal_metric.h>
#include <CGAL/Intrinsic_conformal/metric/flat_surface.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/triangulation/common_mistakes.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a discrete conformal map to the unit sphere.
*/
struct Conformal_sphere {
  /// The metric of the plane that the sphere is projected to. `u` of the pole has no meaning.
  /// Iterations and flips are all that were made for this pole.
  Conformal_metric metric;
  /// The map; `pole` and `positions` go by vertices of the user.
  Sphere_layout layout;
  /// How often the metric of the plane was computed.
  unsigned rounds = 0;
  /// Whether the neighbours of the pole are corners of a convex polygon in the plane, so that the
  /// points on the sphere are the corners of a convex polyhedron, with the edges of the
  /// triangulation. Else the number of rounds was limited, or a round found no metric and was
  /// undone.
  bool is_convex = false;
  /// `stalled` if it is not convex, `inaccurate` if rounding has turned faces over though the
  /// metric was found, else the status of the metric.
  Status status = Status::done;
};

namespace internal {

// Lays a surface that is flat except at a pole out on the sphere.
// \param pole, areas by vertices
using Sphere_projector =
    std::function<Sphere_layout(std::uint32_t pole, std::span<const double> areas)>;

// \param pole a row; nothing: some are tried
Conformal_sphere conformal_sphere(Ideal_surface& surface, std::optional<std::uint32_t> pole,
                                  const Sphere_projector& project);

} // namespace internal

/*!
\brief maps a closed surface of genus 0 to the unit sphere: a discrete conformal map, with flips.

First all vertices get the same curvature, so that the surface is nearly round. Then the pole is
moved to infinity (Springborn, Schröder, Pinkall, Conformal equivalence of triangle
meshes, 2008). Its neighbours are scaled such that their lambda lengths to it are equal, and then
keep their scale; all others get angles that sum to 2 pi. Neighbours at which the plane polygon is
not convex lose their edge to the pole, and vertices that leave the polygon get one, until all edges
are ideal Delaunay: the points are then the corners of the one ideal polyhedron with the hyperbolic
metric of the surface (Rivin, Intrinsic geometry of convex ideal polyhedra, 1996). A motion of
hyperbolic space puts the mean of the vertices, weighted by their areas, to the centre.

\tparam Triangulation see `conformal_metric()`
\param t the triangulation. It is scaled by the result and ideal Delaunay afterwards
\param pole the vertex of the user that is moved to infinity. Nothing: the one with the most
  neighbours, and if the map has a fault with it, up to eleven others, of which the best is taken.
  Long limbs become small on a sphere; a pole in one of them makes others smaller than rounding,
  one in the thickest part does not
\return the map
\throws Invalid_input if the surface is not a closed sphere, or the triangles without the pole are
  not a disk; see `lay_out_on_sphere()`
\complexity that of `conformal_metric()` for each of at most 21 rounds, usually two to five, and of
  `lay_out_on_sphere()`, for each pole that is tried
*/
template <IndexedTriangulation Triangulation>
  requires internal::Has_horocycles<Triangulation> Conformal_sphere
  conformal_sphere(Triangulation& t, std::optional<std::uint32_t> pole = std::nullopt) {
    internal::Ideal_surface_of<Triangulation> surface(t);
    return internal::conformal_sphere(surface, pole,
                                      [&t](std::uint32_t vertex, std::span<const double> areas) {
                                        return lay_out_on_sphere(flat_surface(t), vertex, areas);
                                      });
  }

/*!
\brief finds the logarithms u of the factors by which a map to the unit sphere scales.

In each triangle ijk, exp(u_i) is the ratio of ij ik / jk on the sphere, in chords, and before the
triangulation was scaled, so that chords are exp((u_i + u_j) / 2) times lengths.
\tparam Triangulation see `conformal_metric()`
\param t the triangulation after `conformal_sphere()`
\param layout the map that it has found
\return u per vertex of the user, zero at isolated ones; infinite where vertices fall together
\complexity linear
*/
template <IndexedTriangulation Triangulation>
  requires internal::Has_horocycles<Triangulation> std::vector<double>
  logarithmic_scale(const Triangulation& t, const Sphere_layout& layout) {
    using Halfedge = typename Triangulation::halfedge_descriptor;
    const auto& mesh = t.mesh();
    std::vector<double> u(t.number_of_vertices(), 0);
    const auto ratio = [&](Halfedge h) { // of the length on the sphere to that before
      const std::uint32_t i = t.input_vertex(source(h, mesh)), j = t.input_vertex(target(h, mesh));
      const std::array<double, 3>&p = layout.positions[i], &q = layout.positions[j];
      return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) *
             (t.metric().factor(i) * t.metric().factor(j)) / t.lambda(edge(h, mesh));
    };
    for (const typename Triangulation::vertex_descriptor v : vertices(mesh)) {
      const Halfedge in = halfedge(v, mesh);
      if (in == boost::graph_traits<typename Triangulation::Mesh>::null_halfedge()) continue;
      const Halfedge out = next(in, mesh);
      u[t.input_vertex(v)] = std::log(ratio(in) * ratio(out) / ratio(next(out, mesh)));
    }
    return u;
  }

/// \cond
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_EUCLIDEAN(conformal_sphere, "uniformize()")
/// \endcond

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_CONFORMAL_LAYOUT_CONFORMAL_SPHERE_H
