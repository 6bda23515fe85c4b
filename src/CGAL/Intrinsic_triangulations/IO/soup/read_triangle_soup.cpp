// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/IO/soup/read_polygon_soup.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/read_triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/scan.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Buffered_input.h>
#include <CGAL/Intrinsic_triangulations/domains/triangle_soup.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <istream>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {
namespace {

std::string extension_of(const std::string& filename) {
  return plain_extension(std::filesystem::path(filename).extension().string());
}

using Scan = void (*)(std::istream&, std::uintmax_t, Soup_builder&);

// in the order of `mesh_extensions`
constexpr std::array<Scan, mesh_extensions.size()> mesh_scans{
    scan_OFF, [](std::istream& in, std::uintmax_t, Soup_builder& out) { scan_OBJ(in, out); },
    scan_PLY, scan_STL,
    [](std::istream& in, std::uintmax_t, Soup_builder& out) { scan_GOCAD(in, out); }};

void scan_mesh_file(const std::string& filename, std::uintmax_t size, Soup_builder& out) {
  std::ifstream in(filename, std::ios::binary);
  if (!in) out.fail("the file cannot be opened; check its permissions");
  if (has_extension(filename, point_set_extensions)) return scan_XYZ(in, out);
  std::string known;
  for (std::size_t i = 0; i < mesh_extensions.size(); ++i) {
    if (has_extension(filename, {&mesh_extensions[i], 1})) return mesh_scans[i](in, size, out);
    known += (i == 0 ? "." : i + 1 == mesh_extensions.size() ? " or ." : ", .");
    known += mesh_extensions[i];
  }
  out.fail("the extension \"" + shown(extension_of(filename)) +
           "\" is not supported; convert the mesh to " + known + ", or points to ." +
           std::string(point_set_extensions.front()));
}

// Scans a file, and returns what `finish` makes of it.
template <class Finish>
auto scanned(const std::string& filename, Soup_builder& out, const Finish& finish) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(filename, error);
  if (!std::filesystem::exists(status)) out.fail("the file does not exist; check the name");
  if (std::filesystem::is_directory(status))
    out.fail("this is a directory; name a mesh file in it");
  const bool regular = std::filesystem::is_regular_file(status);
  const std::uintmax_t size = regular ? std::filesystem::file_size(filename, error) : 0;
  if (error)
    out.fail("the file cannot be examined (" + error.message() + "); check its permissions");
  if (regular && size == 0) out.fail("the file is empty; get a complete copy");
  try {
    scan_mesh_file(filename, size, out);
    return finish();
  } catch (const Buffered_input::Line_too_long& found) {
    out.line = found.line;
    out.fail(found.message);
  } catch (const std::bad_alloc&) {
    out.line = 0;
    out.fail(
        "there is not enough memory to read the mesh; use a machine with more, or a smaller mesh");
  }
}

} // namespace
} // namespace internal

bool has_extension(const std::string& filename, std::span<const std::string_view> extensions) {
  return std::ranges::count(extensions, internal::extension_of(filename)) != 0;
}

Triangle_soup read_triangle_soup(const std::string& filename, Nonplanar_polygons polygons,
                                 File_faces faces) {
  internal::Soup_builder out(filename, polygons);
  out.needs_faces = faces == File_faces::needed;
  out.takes_faces = faces != File_faces::ignored;
  return internal::scanned(filename, out, [&] { return out.finish(); });
}

Polygon_soup read_polygon_soup(const std::string& filename) {
  internal::Soup_builder out(filename);
  out.keeps_polygons = true;
  return internal::scanned(filename, out, [&] { return out.finish_polygons(); });
}

} // namespace CGAL::Intrinsic_triangulations
