// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_CURVES_WRITE_POLYLINES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_CURVES_WRITE_POLYLINES_H

#include <CGAL/Intrinsic_triangulations/IO/curves/Polyline_writers.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Buffered_input.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Output_buffer.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Replacing_file.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <ostream>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace CGAL::Intrinsic_triangulations {

/// The extensions of the files that `write_polylines()` writes.
inline constexpr std::array<std::string_view, 3> polyline_extensions{"vtp", "obj", "ply"};

/*!
\brief returns whether `write_polylines()` writes files with an extension.
\param extension the extension, in any letter case, with or without its dot
*/
inline bool is_polyline_extension(std::string_view extension) {
  return std::ranges::count(polyline_extensions, internal::plain_extension(extension)) != 0;
}

/*!
\brief writes polylines in the format of a file extension.

VTP has lines with labels as cell data, OBJ elements `l` with labels in comments, PLY vertices and
edges with labels as properties; polylines of one point are vertices without edges. Nothing is
rounded.
\param out the stream, binary
\param extension one of `polyline_extensions`, in any letter case, with or without its dot
\param polylines the polylines
\param label what files name the labels: letters, digits and `_`
\throws Invalid_input if the extension is another one
\throws std::runtime_error if the stream fails
\complexity linear
*/
inline void write_polylines(std::ostream& out, std::string_view extension,
                            std::span<const Polyline> polylines, std::string_view label = "curve") {
  const std::string name = internal::plain_extension(extension);
  internal::Output_buffer buffer(out);
  if (name == "vtp")
    internal::write_polylines_VTP(buffer, polylines, label);
  else if (name == "obj")
    internal::write_polylines_OBJ(buffer, polylines, label);
  else if (name == "ply")
    internal::write_polylines_PLY(buffer, polylines, label);
  else
    throw Invalid_input(Element_kind::none, 0,
                        "the extension \"" + name +
                            "\" is not supported; write polylines to .vtp, .obj or .ply");
  if (!buffer.flush()) throw std::runtime_error("the polylines cannot be written completely");
}

/*!
\brief writes polylines to a file, in the format of its extension; see the overload with a stream.

Whatever fails, the file is complete or what it was before: see `Replacing_file`.
\param path the file
\param polylines the polylines
\param label what files name the labels
\throws std::runtime_error naming the file if it cannot be written
*/
inline void write_polylines(const std::filesystem::path& path, std::span<const Polyline> polylines,
                            std::string_view label = "curve") {
  Replacing_file file(path);
  try {
    write_polylines(file.stream(), path.extension().string(), polylines, label);
  } catch (const Invalid_input& e) {
    throw Invalid_input(e.kind(), e.index(), path.string() + ": " + e.what());
  } catch (const std::runtime_error&) {
    throw std::runtime_error(path.string() +
                             ": the file cannot be written completely; is the disk full?");
  }
  file.commit();
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_CURVES_WRITE_POLYLINES_H
