// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_H

#include <CGAL/Intrinsic_triangulations/IO/subdivision/Subdivision_field.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>

#include <array>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace CGAL::Intrinsic_triangulations {

/// The extensions of the files that `write_common_subdivision()` writes.
inline constexpr std::array<std::string_view, 5> common_subdivision_extensions{"ply", "obj", "off",
                                                                               "stl", "vtp"};

/*!
\brief labels the faces and vertices of a common subdivision with the polygons of the input, for a
file: the user's faces instead of their triangles.

Label a copy: computations with a common subdivision need the triangles.
\param s the subdivision
\param polygon_of_triangle the polygon of each triangle, as in `Triangle_soup` and `Input_names`;
  empty: all faces are triangles, and nothing changes
\complexity linear
*/
void label_with_polygons(Common_subdivision& s, std::span<const std::uint32_t> polygon_of_triangle);

namespace internal {

// Options in which formats differ.
struct Subdivision_format {
  std::optional<bool> is_binary, has_lines;
  bool is_plain = false;
};

void write_subdivision(std::ostream& out, std::string_view extension, const Subdivision_output& o,
                       const Subdivision_format& format);
void write_subdivision(const std::string& path, const Subdivision_output& o,
                       const Subdivision_format& format);

template <NamedParameters NP>
Subdivision_format subdivision_format(const NP& np) {
  using namespace tags;
  expect_names<use_binary_mode, lines>(np);
  return {value_or<use_binary_mode>(np, std::optional<bool>()),
          value_or<lines>(np, std::optional<bool>())};
}

} // namespace internal

/*!
\brief writes a common subdivision in the format of a file extension.

All formats hold the polygons. PLY and VTP hold all labels and the fields; OBJ has labels of faces
and edges in comments, OFF the colours of `intrinsic_face_colors()`, STL only fans of triangles in
single precision; the others are without loss.
\tparam NP a chain of named parameters
\param out the stream, binary
\param extension one of `common_subdivision_extensions`, in any letter case, with or without its dot
\param s the subdivision
\param points the position of each vertex, see `positions()`
\param fields numbers or vectors to be written for each vertex or face, to PLY and VTP; where two
  have a number per vertex or per corner and the names `u` and `v`, OBJ has them as texture
  coordinates. Numbers per corner are lists of faces in PLY, `u` and `v` also as `texcoord`; VTP has
  none
\param np optional named parameters:
  - `use_binary_mode(b)`: whether PLY is binary, little endian; the other formats have one encoding
    here. Default: true.
  - `lines(b)`: whether VTP and OBJ contain the intrinsic edges as polylines; `CGAL::IO::read_OBJ()`
    refuses such files. Default: true for VTP, false for OBJ.
\throws Invalid_input if the extension is another one, if `points` or a field do not have one value
  for each element, or if a coordinate exceeds the range of STL
\throws std::runtime_error if the stream fails
\complexity linear
*/
template <NamedParameters NP = parameters::Parameters<>>
void write_common_subdivision(std::ostream& out, std::string_view extension,
                              const Common_subdivision& s,
                              std::span<const std::array<double, 3>> points,
                              std::span<const Subdivision_field> fields = {},
                              const NP& np = parameters::default_values()) {
  internal::write_subdivision(out, extension, {s, points, fields},
                              internal::subdivision_format(np));
}

/*!
\brief writes a common subdivision to a file, in the format of its extension.

If anything fails, the file is unchanged: see `Replacing_file`. Other parameters and complexity are
those of the overload with a stream.
\param path the file
\throws Invalid_input see above
\throws File_error naming the file if it cannot be written
*/
template <NamedParameters NP = parameters::Parameters<>>
void write_common_subdivision(const std::string& path, const Common_subdivision& s,
                              std::span<const std::array<double, 3>> points,
                              std::span<const Subdivision_field> fields = {},
                              const NP& np = parameters::default_values()) {
  internal::write_subdivision(path, {s, points, fields}, internal::subdivision_format(np));
}

/*!
\brief writes a common subdivision as all readers take it: PLY with points, polygons and fields, and
without labels and edges; OFF of triangles, without colours. Other formats are those of
`write_common_subdivision()`.

Parameters, errors and complexity are those of the overload with a stream there.
*/
inline void write_plain_subdivision(std::ostream& out, std::string_view extension,
                                    const Common_subdivision& s,
                                    std::span<const std::array<double, 3>> points,
                                    std::span<const Subdivision_field> fields = {}) {
  internal::Subdivision_format format;
  format.is_plain = true;
  internal::write_subdivision(out, extension, {s, points, fields}, format);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_WRITE_COMMON_SUBDIVISION_H
