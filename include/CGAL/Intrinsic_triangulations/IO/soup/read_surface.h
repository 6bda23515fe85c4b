// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_SOUP_READ_SURFACE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_SOUP_READ_SURFACE_H

#include <CGAL/Intrinsic_triangulations/connectivity/count_elements.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/domains/Point_cloud.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/input/Planar_polygons.h>
#include <CGAL/Intrinsic_triangulations/input/mollification.h>

#include <cstddef>
#include <optional>
#include <string>

/*!
\file
A file, or a soup, as the input of a triangulation: in one step what `read_triangle_soup()`,
`make_domain()` and `make_point_cloud()` do.
*/

namespace CGAL::Intrinsic_triangulations {

/// Which surface is made of faces or points.
struct Surface_options {
  Domain_kind kind = Domain_kind::automatic;              ///< of faces
  bool is_points = false;                                 ///< whether faces are ignored
  std::optional<std::size_t> neighbors{};                 ///< of each point; 30 by default
  Nonplanar_polygons polygons = Nonplanar_polygons::fan;  ///< what is made of bent ones
  Mollification mollification = Mollification::automatic; ///< treatment of degenerate faces
};

/*!
\brief returns the options that words name.
\param domain `auto`, `manifold`, `orientation-cover`, `tufted`, `closed` or `points`
\param mollification `automatic`, `none`, `lengths` or `squared`
\param polygons `fan` or `planar`
\throws Invalid_input naming a word that is none of these
*/
Surface_options surface_options(const std::string& domain,
                                const std::string& mollification = "automatic",
                                const std::string& polygons = "fan");

/// What is known of a surface when a triangulation of it is built.
struct Surface_facts {
  /// Of the surface's triangles when it was built, or as it was stored.
  Element_counts counts{};
  std::size_t polygons = 0;                     ///< faces of the user; 0: points alone
  std::size_t triangulated_polygons = 0;        ///< those with more than three sides
  std::size_t faces_with_repeated_vertices = 0; ///< see `Triangle_soup`
  Domain_report domain{};                       ///< which surface was made, and why
  Polygon_report planar_polygons{};             ///< what was made of polygons
  std::optional<Point_cloud_report> cloud{};    ///< if it was made of points
  double seconds_of_reading = 0;                ///< without matching edges
  double seconds_of_building = 0;               ///< of the triangulation
  double seconds_of_counting = 0;               ///< of its elements
};

/// What a triangulation is built from, and what is known of it.
struct Read_surface {
  Intrinsic_input input; ///< what a triangulation is built from
  Surface_facts facts{}; ///< what is known of it
};

/*!
\brief makes a surface of triangles, or of points if there are none.

Messages name options as the program does.
\param soup triangles; or points without any
\param options which surface is made
\return the input of a triangulation, for `build_surface()`
\throws Invalid_input as `make_domain()` and `make_point_cloud()` do, or if `neighbors` is given and
  there are faces
\complexity that of `make_domain()` or `make_point_cloud()`
*/
Read_surface make_surface(Triangle_soup soup, const Surface_options& options = {});

/*!
\brief reads a file of a mesh or of points, and makes a surface of it.

Messages name options as the program does.
\param path the file, in a format that `read_triangle_soup()` reads
\param options which surface is made
\return the input of a triangulation, for `build_surface()`
\throws Invalid_input naming the file, as `read_triangle_soup()` and `make_surface()` do
\complexity that of `read_triangle_soup()` and `make_surface()`
*/
Read_surface read_surface(const std::string& path, const Surface_options& options = {});

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_SOUP_READ_SURFACE_H
