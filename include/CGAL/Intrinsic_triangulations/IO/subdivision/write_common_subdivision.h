// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_H

#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision_OBJ.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision_OFF.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision_PLY.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision_STL.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision_VTP.h>
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

/// The extensions of the files that `write_common_subdivision()` writes.
inline constexpr std::array<std::string_view, 5> common_subdivision_extensions{"ply", "obj", "off",
                                                                               "stl", "vtp"};

namespace internal {

// Lower case, without a dot.
inline std::string plain_extension(std::string_view extension) {
  if (extension.starts_with('.')) extension.remove_prefix(1);
  std::string result(extension);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

} // namespace internal

/*!
\brief returns whether `write_common_subdivision()` writes files with an extension.
\param extension the extension, in any letter case, with or without its dot
*/
inline bool is_common_subdivision_extension(std::string_view extension) {
  return std::find(common_subdivision_extensions.begin(), common_subdivision_extensions.end(),
                   internal::plain_extension(extension)) != common_subdivision_extensions.end();
}

/*!
\brief writes a common subdivision in the format of a file extension.

All formats hold the polygons. PLY and VTP hold all labels and the fields; OBJ has labels of faces and
edges in comments, OFF a colour for each intrinsic face, STL only triangles in single precision.
\param out the stream, binary
\param extension one of `common_subdivision_extensions`, in any letter case, with or without its dot
\param s the subdivision
\param points the position of each vertex, see `positions()`
\param fields numbers to be written for each vertex, to PLY and VTP
\param options see there
\throws Invalid_input if the extension is another one, or if `points` or a field do not have one value
  for each vertex
\throws std::runtime_error if the stream fails
\complexity linear
*/
inline void write_common_subdivision(std::ostream& out, std::string_view extension,
                                     const Common_subdivision& s,
                                     std::span<const std::array<double, 3>> points,
                                     std::span<const Vertex_field> fields = {},
                                     const Common_subdivision_output& options = {}) {
  const std::string format = internal::plain_extension(extension);
  internal::check_output(s, points, fields);
  if (format == "ply")
    write_common_subdivision_PLY(out, s, points, fields, options);
  else if (format == "obj")
    write_common_subdivision_OBJ(out, s, points, options);
  else if (format == "off")
    write_common_subdivision_OFF(out, s, points);
  else if (format == "stl")
    write_common_subdivision_STL(out, s, points);
  else if (format == "vtp")
    write_common_subdivision_VTP(out, s, points, fields, options);
  else
    throw Invalid_input(Element_kind::none, 0,
                        "the extension \"" + format +
                            "\" is not supported; write the common subdivision to .ply, .obj, "
                            ".off, .stl or .vtp");
}

/*!
\brief writes a common subdivision to a file, in the format of its extension.

Whatever fails, the file is complete or what it was before: see `Replacing_file`.
\param path the file
\param s the subdivision
\param points the position of each vertex, see `positions()`
\param fields numbers to be written for each vertex, to PLY and VTP
\param options see there
\throws Invalid_input see above
\throws std::runtime_error naming the file if it cannot be written
\complexity linear
*/
inline void write_common_subdivision(const std::filesystem::path& path, const Common_subdivision& s,
                                     std::span<const std::array<double, 3>> points,
                                     std::span<const Vertex_field> fields = {},
                                     const Common_subdivision_output& options = {}) {
  Replacing_file file(path);
  try {
    write_common_subdivision(file.stream(), path.extension().string(), s, points, fields, options);
  } catch (const Invalid_input& e) {
    throw Invalid_input(e.kind(), e.index(), path.string() + ": " + e.what());
  } catch (const std::runtime_error&) {
    throw std::runtime_error(path.string() +
                             ": the file cannot be written completely; is the disk full?");
  }
  file.commit();
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_H
