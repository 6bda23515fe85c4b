// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_CURVES_WRITE_POLYLINES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_CURVES_WRITE_POLYLINES_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a curve in space, for a file or a page: points that straight lines join.
*/
struct Polyline {
  /// Its points, in order.
  std::vector<std::array<double, 3>> points;
  /// Whether a line joins the last point with the first one.
  bool is_closed = false;
  /// A number that identifies it.
  std::int32_t label = 0;

  /// returns the number of lines.
  std::size_t number_of_segments() const {
    return points.size() < 2 ? 0 : points.size() - (is_closed ? 0 : 1);
  }
};

/// The extensions of the files that `write_polylines()` writes.
inline constexpr std::array<std::string_view, 3> polyline_extensions{"vtp", "obj", "ply"};

/*!
\brief writes polylines in the format of a file extension.

VTP has lines with labels as cell data, OBJ elements `l` with labels in comments, PLY vertices and
edges with labels as properties; polylines of one point are vertices without edges. Nothing is
rounded.
\param out the stream, binary
\param extension one of `polyline_extensions`, in any letter case, with or without its dot
\param polylines the polylines
\param label the name of the labels in files: letters, digits and `_`
\throws Invalid_input if the extension is another one
\throws std::runtime_error if the stream fails
\complexity linear
*/
void write_polylines(std::ostream& out, std::string_view extension,
                     std::span<const Polyline> polylines, const std::string& label = "curve");

/*!
\brief writes polylines to a file, in the format of its extension; see the overload with a stream.

If anything fails, the file is unchanged: see `Replacing_file`.
\param path the file
\param polylines the polylines
\param label the name of the labels in files
\throws File_error naming the file if it cannot be written
*/
void write_polylines(const std::string& path, std::span<const Polyline> polylines,
                     const std::string& label = "curve");

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_CURVES_WRITE_POLYLINES_H
