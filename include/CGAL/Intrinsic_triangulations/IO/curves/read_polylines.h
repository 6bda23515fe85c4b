// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_CURVES_READ_POLYLINES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_CURVES_READ_POLYLINES_H

#include <CGAL/Intrinsic_triangulations/IO/curves/write_polylines.h>

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief reads polylines: what `write_polylines()` writes; and of any OBJ file the elements `l`, and
`p` as polylines of one point.

A line whose last point is the first one is closed. Labels in OBJ are those of the comment before,
as `write_polylines()` has them; without one, lines count from 0. Other elements are skipped.
\param in the stream, binary
\param extension one of `polyline_extensions`, in any letter case, with or without its dot
\throws Invalid_input if the extension is another one, naming the line that is wrong in OBJ, or if
  there is no polyline
\complexity linear
*/
std::vector<Polyline> read_polylines(std::istream& in, std::string_view extension);

/// reads polylines from a file, in the format of its extension: see the overload with a stream.
/// \throws std::runtime_error naming the file if it cannot be read, or what is wrong in it
std::vector<Polyline> read_polylines(const std::string& path);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_CURVES_READ_POLYLINES_H
