// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_CONFORMAL_CONFORMAL_SPHERE_H
#define CGAL_INTRINSIC_OPERATORS_CONFORMAL_CONFORMAL_SPHERE_H

#include <CGAL/Intrinsic_operators/conformal/Ideal_surface_of.h>
#include <CGAL/Intrinsic_operators/conformal/conformal_metric.h>
#include <CGAL/Intrinsic_operators/conformal/flat_surface.h>
#include <CGAL/Intrinsic_operators/conformal/lay_out_on_sphere.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a discrete conformal map to the unit sphere.
*/
struct Conformal_sphere {
  /// The metric of the plane that the sphere is projected to. `u` of the pole has no meaning.
  /// Iterations and flips are all that were made.
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
};

namespace internal {

// The metric of a sphere without the pole, and what is known about it.
struct Punctured_sphere {
  Conformal_metric metric;
  std::vector<double> areas; // of each row, before scaling
  std::uint32_t pole = 0;    // a row
  unsigned rounds = 0;
  bool is_convex = false;
};

// \param pole a row; nothing: one with many neighbours is chosen
Punctured_sphere punctured_sphere(Ideal_surface& surface, std::optional<std::uint32_t> pole);

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
\param pole the vertex of the user that is moved to infinity; nothing: one with the most neighbours
\return the map; `metric.status` tells whether a metric was found
\throws Invalid_input if the surface is not a closed sphere, or the triangles without the pole are
  no disk; see `lay_out_on_sphere()`
\complexity that of `conformal_metric()` for each of at most 21 rounds, usually two to five
*/
template <IndexedTriangulation Triangulation>
  requires internal::Has_horocycles<Triangulation> Conformal_sphere
  conformal_sphere(Triangulation& t, std::optional<std::uint32_t> pole = std::nullopt) {
    internal::Ideal_surface_of<Triangulation> surface(t);
    internal::Punctured_sphere found = internal::punctured_sphere(surface, pole);
    const std::vector<std::uint32_t>& row = surface.row_of_vertex();
    std::uint32_t pole_vertex = 0;
    std::vector<double> areas(row.size(), 0);
    for (std::uint32_t v = 0; v < row.size(); ++v) {
      if (row[v] == Gluing::none) continue;
      areas[v] = found.areas[row[v]];
      if (row[v] == found.pole) pole_vertex = v;
    }
    Conformal_sphere result{std::move(found.metric),
                            lay_out_on_sphere(flat_surface(t), pole_vertex, areas), found.rounds,
                            found.is_convex};
    std::vector<std::array<double, 3>> by_row(surface.number_of_rows());
    for (std::uint32_t v = 0; v < row.size(); ++v)
      if (row[v] != Gluing::none) by_row[row[v]] = result.layout.positions[v];
    result.layout.positions = std::move(by_row);
    result.layout.pole = found.pole;
    return result;
  }

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_CONFORMAL_CONFORMAL_SPHERE_H
