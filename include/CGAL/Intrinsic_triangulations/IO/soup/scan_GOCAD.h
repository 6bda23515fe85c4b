// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_SOUP_SCAN_GOCAD_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_SOUP_SCAN_GOCAD_H

#include <CGAL/Intrinsic_triangulations/IO/soup/Soup_builder.h>

#include <CGAL/IO/GOCAD.h>
#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cstdint>
#include <istream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Scans a triangulated surface of GOCAD by CGAL's reader.
inline void scan_GOCAD(std::istream& in, Soup_builder& out) {
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  std::vector<std::array<std::int32_t, 3>> triangles;
  const bool good = CGAL::IO::read_GOCAD(in, points, triangles);
  out.reserve(points.size(), triangles.size());
  for (const auto& p : points) out.add_vertex(p.x(), p.y(), p.z());
  std::vector<std::int64_t> face;
  for (const auto& t : triangles) {
    face.assign(t.begin(), t.end());
    out.add_face(face);
  }
  if (!good)
    out.fail(Element_kind::none, 0,
             "the file cannot be read as a GOCAD surface beyond vertex " +
                 std::to_string(points.size()) + " and face " + std::to_string(triangles.size()) +
                 "; get a complete copy if it is truncated, or correct what follows them");
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_SOUP_SCAN_GOCAD_H
