// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_TESSELLATION_DART_COMPLEX_H
#define CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_TESSELLATION_DART_COMPLEX_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>

#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Polygons glued along their sides, the darts: a triangulation of which some
// edges are left out.
struct Dart_complex {
  static constexpr std::uint32_t none = Gluing::none;
  static constexpr std::uint32_t of_pinched_vertex = 0x80000000U; // a bit of a degree

  // \param is_left_out for each edge, whether the faces beside it belong to one
  // polygon
  Dart_complex(const Gluing_map& mesh, const std::vector<char>& is_left_out);

  std::uint32_t size() const { return static_cast<std::uint32_t>(next.size()); }
  // whether fans meet at a vertex and nowhere else
  bool has_pinched_vertex() const;

  std::vector<std::uint32_t> next, previous,
      opposite;                         // opposite: none on the border
  std::vector<std::uint32_t> halfedge;  // of the triangulation
  std::vector<std::uint32_t> dart;      // of each halfedge, or none
  std::vector<std::uint32_t> sides;     // number of sides of its polygon
  std::vector<std::uint32_t> degree;    // darts of its fan that start where it does, and
                                        // whether other fans meet there
  std::vector<std::uint32_t> component; // of each dart, from 0
  std::uint32_t number_of_components = 0;

private:
  void count_sides();
  void count_degrees(const Gluing_map& mesh);
  void find_components();
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_TESSELLATION_DART_COMPLEX_H
