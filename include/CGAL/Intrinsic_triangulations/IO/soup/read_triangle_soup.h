// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_SOUP_READ_TRIANGLE_SOUP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_SOUP_READ_TRIANGLE_SOUP_H

#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>

#include <array>
#include <span>
#include <string>
#include <string_view>

namespace CGAL::Intrinsic_triangulations {

/// The extensions of the meshes that `read_triangle_soup()` reads; without faces they are point
/// sets.
inline constexpr std::array<std::string_view, 5> mesh_extensions{"off", "obj", "ply", "stl", "ts"};

/// The extensions of the lists of points that `read_triangle_soup()` reads.
inline constexpr std::array<std::string_view, 2> point_set_extensions{"xyz", "pwn"};

/*!
\brief returns whether the name of a file has one of some extensions, in any letter case.

Such are `mesh_extensions`, `point_set_extensions`, `polyline_extensions` and
`common_subdivision_extensions`.
\param filename the name; the file need not exist
\param extensions the extensions, in lower case and without a dot
\complexity linear in their number
*/
bool has_extension(const std::string& filename, std::span<const std::string_view> extensions);

/// Treatment of the faces of a file, see `read_triangle_soup()`.
enum class File_faces {
  needed,   ///< a file without faces is refused
  optional, ///< a file may be a point set: the soup has no triangles then
  ignored   ///< the vertices are a point set, whatever the faces are
};

/*!
\brief reads a polygon mesh from a file as a soup of triangles.

The format follows from the extension, in any letter case (`mesh_extensions`,
`point_set_extensions`): OFF with all its prefixes (`.off`), OBJ (`.obj`), PLY (`.ply`), STL
(`.stl`) and GOCAD (`.ts`), the formats of
`CGAL::IO::read_polygon_soup()`; OFF, PLY and STL as text or binary. Vertices and faces keep the
numbers they have in the file; those of STL are the distinct corners in the order in which they
first occur. A decimal coordinate becomes the nearest `double`; where a format stores single
precision (binary OFF and STL, properties of type `float` in PLY), it becomes that number. Point
sets, for `make_point_cloud()`, are files of these formats without faces, and lists of points
(`.xyz`, `.pwn`): three coordinates on each line, after which the rest, such as a normal, is
ignored; comments start with `#`, and the number of points may come first. Faces of OFF may take
several lines. Unknown statements of OBJ and byte order marks are skipped, and lines end by LF, CR
LF or CR.

If a face lists a vertex twice, its parts without area are left out and counted: 0 1 1 2 and 0 1 2 3
2 have a vertex or a line too many; 0 1 1 is left out entirely.

Faces with more than three sides are triangulated: a quadrilateral along the diagonal that
`CGAL::Polygon_mesh_processing::triangulate_faces()` takes, others by constrained Delaunay
triangulation in the plane normal to their vector area, or with least area where their projection to
that plane crosses itself. As edges are later matched by their end vertices, a diagonal between two
vertices that another edge joins is avoided by another triangulation of the polygon, if there is
one.

\param filename the name of the file
\param polygons what replaces polygons that are not planar: `Nonplanar_polygons::planar`
  triangulates the planar polygons that take their place
\param faces whether point sets are read
\throws Invalid_input naming the file, its line where it has lines, the element and the remedy if
  the file does not exist or cannot be read, is empty, truncated or not of its format, has a
  coordinate that is not finite, a face with fewer than three vertices, with area on two sides of a
  vertex that it repeats, or with one out of range, a line of more than 64 MiB, no points, no faces
  where they are needed, or a polygon with no triangulation
\complexity linear for text and binary alike, expected for STL, and \f$n\log n\f$ in the number of
  diagonals;
  memory follows the size of the file, never a count in it
*/
Triangle_soup read_triangle_soup(const std::string& filename,
                                 Nonplanar_polygons polygons = Nonplanar_polygons::fan,
                                 File_faces faces = File_faces::needed);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_SOUP_READ_TRIANGLE_SOUP_H
