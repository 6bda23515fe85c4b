// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_H

#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision_PLY.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision_VTP.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision_mesh.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Buffered_input.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Replacing_file.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/connectivity/parameters.h>

#include <algorithm>
#include <array>
#include <cstdint>
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

/*!
\brief returns whether `write_common_subdivision()` writes files with an extension.
\param extension the extension, in any letter case, with or without its dot
*/
inline bool is_common_subdivision_extension(std::string_view extension) {
  return std::ranges::count(common_subdivision_extensions, internal::plain_extension(extension)) !=
         0;
}

/*!
\brief labels the faces and vertices of a common subdivision with the polygons of the input, for a file: the user's
faces instead of the triangles that they were made of.

What computes with a common subdivision needs the triangles: use a copy.
\param s the subdivision
\param polygon_of_triangle the polygon of each triangle, as in `Triangle_soup` and `Input_names`; empty: all
  faces are triangles, and nothing changes
\complexity linear
*/
inline void label_with_polygons(Common_subdivision& s,
                                std::span<const std::uint32_t> polygon_of_triangle) {
  if (polygon_of_triangle.empty()) return;
  const auto rename = [&](std::uint32_t& f) {
    if (f != Common_subdivision::none) f = polygon_of_triangle[f];
  };
  for (std::uint32_t& f : s.input_face) rename(f);
  for (Common_subdivision::Vertex& v : s.vertices) rename(v.input_face);
}

/*!
\brief writes a common subdivision in the format of a file extension.

All formats hold the polygons. PLY and VTP hold all labels and the fields; OBJ has labels of faces and
edges in comments, OFF the colours of `intrinsic_face_colors()`, STL only fans of triangles in single
precision; the others are without loss.
\tparam NP a chain of named parameters
\param out the stream, binary
\param extension one of `common_subdivision_extensions`, in any letter case, with or without its dot
\param s the subdivision
\param points the position of each vertex, see `positions()`
\param fields numbers to be written for each vertex, to PLY and VTP
\param np optional named parameters:
  - `use_binary_mode(b)`: whether PLY is binary, little endian; the other formats have one encoding here.
    Default: true.
  - `lines(b)`: whether VTP and OBJ contain the intrinsic edges as polylines; `CGAL::IO::read_OBJ()` refuses
    such files. Default: true for VTP, false for OBJ.
\throws Invalid_input if the extension is another one, if `points` or a field do not have one value
  for each vertex, or if a coordinate exceeds the range of STL
\throws std::runtime_error if the stream fails
\complexity linear
*/
template <NamedParameters NP = parameters::Parameters<>>
void write_common_subdivision(std::ostream& out, std::string_view extension,
                              const Common_subdivision& s,
                              std::span<const std::array<double, 3>> points,
                              std::span<const Vertex_field> fields = {},
                              const NP& np = parameters::default_values()) {
  using namespace internal::tags;
  internal::expect_names<use_binary_mode, lines>(np);
  const std::string format = internal::plain_extension(extension);
  const internal::Subdivision_output o{s, points, fields};
  internal::check_output(o);
  internal::Output_buffer buffer(out);
  if (format == "ply" && internal::value_or<use_binary_mode>(np, true))
    internal::PLY_subdivision_writer<true>(buffer, o).run();
  else if (format == "ply")
    internal::PLY_subdivision_writer<false>(buffer, o).run();
  else if (format == "obj")
    internal::write_OBJ(buffer, o, internal::value_or<lines>(np, false));
  else if (format == "off")
    internal::write_OFF(buffer, o);
  else if (format == "stl")
    internal::write_STL(buffer, o);
  else if (format == "vtp")
    internal::VTP_subdivision_writer(buffer, o, internal::value_or<lines>(np, true)).run();
  else
    throw Invalid_input(Element_kind::none, 0,
                        "the extension \"" + format +
                            "\" is not supported; write the common subdivision to .ply, .obj, "
                            ".off, .stl or .vtp");
  if (!buffer.flush())
    throw std::runtime_error("the common subdivision cannot be written completely");
}

/*!
\brief writes a common subdivision to a file, in the format of its extension.

Whatever fails, the file is complete or what it was before: see `Replacing_file`. Other parameters and
complexity are those of the overload with a stream.
\param path the file
\throws Invalid_input see above
\throws std::runtime_error naming the file if it cannot be written
*/
template <NamedParameters NP = parameters::Parameters<>>
void write_common_subdivision(const std::filesystem::path& path, const Common_subdivision& s,
                              std::span<const std::array<double, 3>> points,
                              std::span<const Vertex_field> fields = {},
                              const NP& np = parameters::default_values()) {
  Replacing_file file(path);
  try {
    write_common_subdivision(file.stream(), path.extension().string(), s, points, fields, np);
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
