// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_SOUP_READ_POLYGON_SOUP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_SOUP_READ_POLYGON_SOUP_H

#include <CGAL/Intrinsic_triangulations/domains/Polygon_soup.h>

#include <string>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief reads points and faces as they are in a file: faces are not triangulated, and may repeat a
point.

Formats and numbers are those of `read_triangle_soup()`. There may be no faces.
\param filename the name of the file
\throws Invalid_input as `read_triangle_soup()` does, but not because a face has no area
\complexity that of `read_triangle_soup()`
*/
Polygon_soup read_polygon_soup(const std::string& filename);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_SOUP_READ_POLYGON_SOUP_H
