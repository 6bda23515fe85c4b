// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_CURVES_READ_POLYLINES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_CURVES_READ_POLYLINES_H

#include <CGAL/Intrinsic_triangulations/IO/curves/write_polylines.h>

#include <filesystem>
#include <istream>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief reads polylines from an OBJ file, such as those of `write_polylines()`: its elements `l`, and
`p` as polylines of one point.

A line whose last point is the first one is closed. Labels are those of the comment before, as
`write_polylines()` has them; without one, lines count from 0. Other elements are skipped.
\param in the stream
\throws Invalid_input naming the line that is wrong, or if there is no polyline
\complexity linear
*/
std::vector<Polyline> read_polylines(std::istream& in);

/// reads polylines from a file, see the overload with a stream.
/// \throws std::runtime_error naming the file if it cannot be read, or what is wrong in it
std::vector<Polyline> read_polylines(const std::filesystem::path& path);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_CURVES_READ_POLYLINES_H
