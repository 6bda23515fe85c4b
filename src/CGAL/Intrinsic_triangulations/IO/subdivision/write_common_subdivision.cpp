// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/IO/subdivision/Subdivision_field.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/Subdivision_output.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/subdivision_formats.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Buffered_input.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Output_buffer.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Replacing_file.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <cstdint>
#include <filesystem>
#include <ostream>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace CGAL::Intrinsic_triangulations {

void label_with_polygons(Common_subdivision& s,
                         std::span<const std::uint32_t> polygon_of_triangle) {
  if (polygon_of_triangle.empty()) return;
  const auto rename = [&](std::uint32_t& f) {
    if (f != Common_subdivision::none) f = polygon_of_triangle[f];
  };
  for (std::uint32_t& f : s.input_face) rename(f);
  for (Common_subdivision::Vertex& v : s.vertices) rename(v.input_face);
}

namespace internal {

void write_subdivision(std::ostream& out, std::string_view extension, const Subdivision_output& o,
                       const Subdivision_format& format) {
  const std::string name = plain_extension(extension);
  check_output(o);
  Output_buffer buffer(out);
  if (name == "ply")
    write_subdivision_PLY(buffer, o, format.is_binary.value_or(true), format.is_plain);
  else if (name == "obj")
    write_subdivision_OBJ(buffer, o, format.has_lines.value_or(false));
  else if (name == "off")
    write_subdivision_OFF(buffer, o, format.is_plain);
  else if (name == "stl")
    write_subdivision_STL(buffer, o);
  else if (name == "vtp")
    write_subdivision_VTP(buffer, o, format.has_lines.value_or(true));
  else
    throw Invalid_input(Element_kind::none, 0,
                        "the extension \"" + name +
                            "\" is not supported; write the common subdivision to .ply, .obj, "
                            ".off, .stl or .vtp");
  if (!buffer.flush())
    throw std::runtime_error("the common subdivision cannot be written completely");
}

void write_subdivision(const std::string& path, const Subdivision_output& o,
                       const Subdivision_format& format) {
  write_file(path, [&](std::ostream& out) {
    write_subdivision(out, std::filesystem::path(path).extension().string(), o, format);
  });
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations
