// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_CURVES_SCAN_POLYLINES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_CURVES_SCAN_POLYLINES_H

#include <CGAL/Intrinsic_triangulations/IO/curves/write_polylines.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <istream>
#include <string>
#include <vector>

/*!
\file
Readers of what `write_polylines()` writes, one for each format.
*/

namespace CGAL::Intrinsic_triangulations::internal {

[[noreturn]] inline void fail_polylines(const std::string& what) {
  throw Invalid_input(Element_kind::none, 0, what);
}

// A line whose last point is the first one is closed.
inline void close_polyline(Polyline& line) {
  line.is_closed = line.points.size() > 2 && line.points.front() == line.points.back();
  if (line.is_closed) line.points.pop_back();
}

std::vector<Polyline> scan_polylines_OBJ(std::istream& in);
std::vector<Polyline> scan_polylines_PLY(std::istream& in);
std::vector<Polyline> scan_polylines_VTP(std::istream& in);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_CURVES_SCAN_POLYLINES_H
