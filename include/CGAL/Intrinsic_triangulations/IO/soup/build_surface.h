// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_SOUP_BUILD_SURFACE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_SOUP_BUILD_SURFACE_H

#include <CGAL/Intrinsic_triangulations/IO/soup/read_surface.h>
#include <CGAL/Intrinsic_triangulations/connectivity/count_elements.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/Stopwatch.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// A triangulation with what is known of the user's surface.
template <NumberedTriangulation Triangulation>
struct Built_surface {
  Triangulation triangulation; ///< of the surface
  /// Where each row is, in the order and the units of the user; empty for an abstract metric.
  std::vector<std::array<double, 3>> points{};
  Surface_facts facts{}; ///< what is known of the surface
};

/// returns the number of the user's faces that a surface has parts of.
inline std::size_t number_of_polygons(const Input_definition& input) {
  const std::vector<std::uint32_t>& polygon = input.names().polygon_of_triangle;
  return polygon.empty() ? input.metric().number_of_faces() : std::size_t{polygon.back()} + 1;
}

namespace internal {

// A point for each row, of those of its copies.
template <class Point_of>
std::vector<std::array<double, 3>> points_by_rows(std::size_t vertices, const Input_names& names,
                                                  const Point_of& point_of) {
  std::vector<std::array<double, 3>> points(
      names.number_of_rows(static_cast<std::uint32_t>(vertices)));
  for (std::uint32_t v = 0; v < vertices; ++v) points[names.row(v)] = point_of(v);
  return points;
}

inline void expect_point_per_vertex(std::size_t points, std::size_t vertices) {
  if (points != vertices)
    throw Invalid_input(Element_kind::none, 0,
                        "there are " + std::to_string(points) + " points for " +
                            std::to_string(vertices) +
                            " vertices of the input; give one for each vertex");
}

// Counts the elements that the triangulation has now.
template <NumberedTriangulation Triangulation>
void count_elements_of(Built_surface<Triangulation>& built) {
  Stopwatch watch;
  built.facts.counts = count_elements(built.triangulation.mesh());
  built.facts.seconds_of_counting = watch.lap();
}

} // namespace internal

/*!
\brief builds the triangulation of a surface that was read or made.
\tparam Triangulation an `Intrinsic_triangulation`
\param surface the result of `read_surface()` or `make_surface()`
\param points where its vertices are, if its input has lengths that were changed; else none
\return the triangulation, the point of each row, and what is known of the surface
\throws Invalid_input as the constructor of the triangulation does, or if there are points, but not
  one for each vertex of the input
\complexity linear
*/
template <NumberedTriangulation Triangulation>
Built_surface<Triangulation> build_surface(Read_surface surface,
                                           std::vector<std::array<double, 3>> points = {}) {
  Stopwatch watch;
  if (points.empty()) points = surface.input.points;
  if (!points.empty()) {
    internal::expect_point_per_vertex(points.size(), surface.input.mesh.number_of_vertices());
    points = internal::points_by_rows(points.size(), surface.input.names,
                                      [&](std::uint32_t v) { return points[v]; });
  }
  Built_surface<Triangulation> built{Triangulation(std::move(surface.input)), std::move(points),
                                     std::move(surface.facts)};
  built.facts.seconds_of_building = watch.lap();
  internal::count_elements_of(built);
  return built;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_SOUP_BUILD_SURFACE_H
