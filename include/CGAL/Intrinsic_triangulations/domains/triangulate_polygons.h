// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_TRIANGULATE_POLYGONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_TRIANGULATE_POLYGONS_H

#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/input/Planar_polygons.h>
#include <CGAL/Intrinsic_triangulations/input/Polygon_shaper.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The faces of a soup with more than three sides. The triangles of polygon i are
// first_triangle[i], ...; its corners are corners[first_corner[i]], ...
struct Polygons {
  std::vector<std::uint32_t> face, first_triangle, first_corner, corners;

  // The caller appends its corners next.
  void add(std::size_t f, std::size_t triangle) {
    face.push_back(static_cast<std::uint32_t>(f));
    first_triangle.push_back(static_cast<std::uint32_t>(triangle));
    first_corner.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  std::size_t size() const { return face.size(); }
  std::size_t sides(std::size_t i) const {
    return (i + 1 < size() ? first_corner[i + 1] : corners.size()) - first_corner[i];
  }
  std::uint32_t corner(std::size_t i, std::size_t k) const { return corners[first_corner[i] + k]; }
};

// Throws; its arguments are the face that cannot be triangulated, and why.
using Polygon_failure = std::function<void(std::size_t, const std::string&)>;

// Triangulates the polygons of `soup` in place.
void triangulate_polygons(const Polygons& polygons, Nonplanar_polygons kind, Triangle_soup& soup,
                          const Polygon_failure& fail);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_TRIANGULATE_POLYGONS_H
