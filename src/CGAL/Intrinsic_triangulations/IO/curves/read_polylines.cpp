// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/IO/curves/read_polylines.h>
#include <CGAL/Intrinsic_triangulations/IO/curves/scan_polylines.h>
#include <CGAL/Intrinsic_triangulations/IO/curves/write_polylines.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Buffered_input.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <filesystem>
#include <fstream>
#include <istream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

std::vector<Polyline> read_polylines(std::istream& in, std::string_view extension) {
  const std::string name = text::plain_extension(extension);
  std::vector<Polyline> read;
  if (name == "vtp")
    read = internal::scan_polylines_VTP(in);
  else if (name == "obj")
    read = internal::scan_polylines_OBJ(in);
  else if (name == "ply")
    read = internal::scan_polylines_PLY(in);
  else
    internal::fail_polylines("the extension \"" + name +
                             "\" is not one of curves; give a file .vtp, .obj or .ply");
  if (read.empty())
    internal::fail_polylines("the file has no lines; give what commands write for curves, or an "
                             ".obj file with elements l");
  return read;
}

std::vector<Polyline> read_polylines(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in)
    throw std::runtime_error(path +
                             ": the file cannot be read; give the path of a file with curves");
  try {
    return read_polylines(in, std::filesystem::path(path).extension().string());
  } catch (const Invalid_input& e) {
    throw std::runtime_error(path + ": " + e.what());
  }
}

} // namespace CGAL::Intrinsic_triangulations
