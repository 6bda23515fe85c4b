// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_CUTS_WRITE_CUT_SURFACE_H
#define CGAL_INTRINSIC_GEODESICS_CUTS_WRITE_CUT_SURFACE_H

#include <CGAL/Intrinsic_geodesics/cuts/Cut_surface.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>

#include <array>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>

namespace CGAL::Intrinsic_triangulations {

/// The extensions of the files that `write_cut_surface()` writes.
inline constexpr std::array<std::string_view, 4> cut_surface_extensions{"ply", "obj", "off", "vtp"};

/*!
\brief writes a cut surface in the format of a file extension.

PLY and VTP hold all labels; OBJ has components as groups, and texture coordinates at corners; OFF
the components as colours. All are without loss of coordinates.
\param out the stream, binary
\param extension one of `cut_surface_extensions`, in any letter case, with or without its dot
\param s the surface
\param points the position of each vertex, see `positions()`
\param texture a place in the plane for each corner, which OBJ and PLY hold; or empty
\throws Invalid_input if the extension is another one, or if `points` or `texture` have another size
\throws std::runtime_error if the stream fails
\complexity linear
*/
void write_cut_surface(std::ostream& out, std::string_view extension, const Cut_surface& s,
                       std::span<const std::array<double, 3>> points,
                       std::span<const std::array<double, 2>> texture = {});

/*!
\brief writes a cut surface to a file, in the format of its extension.

If anything fails, the file is unchanged: see `Replacing_file`.
\param path the file
\param s, points, texture see the overload with a stream
\throws Invalid_input see there
\throws std::runtime_error naming the file if it cannot be written
*/
void write_cut_surface(const std::string& path, const Cut_surface& s,
                       std::span<const std::array<double, 3>> points,
                       std::span<const std::array<double, 2>> texture = {});

/*!
\brief returns a cut surface in the form that `write_html_view()` draws: components are the
intrinsic faces, cuts and borders the intrinsic edges.
\param s the surface
\complexity linear
*/
Common_subdivision drawn_as_subdivision(const Cut_surface& s);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_CUTS_WRITE_CUT_SURFACE_H
