// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_COUNT_ELEMENTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_COUNT_ELEMENTS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>

#include <cstddef>
#include <optional>

namespace CGAL::Intrinsic_triangulations {

/// Numbers of elements of triangles that are glued, and of their components and borders.
struct Element_counts {
  std::size_t vertices = 0;             ///< with isolated ones
  std::size_t edges = 0;                ///< of faces
  std::size_t faces = 0;                ///< triangles
  std::size_t boundary_edges = 0;       ///< edges with one face
  std::size_t boundary_loops = 0;       ///< see `boundary_loops()`
  std::size_t components = 0;           ///< see `connected_components()`
  std::optional<std::size_t> genus{};   ///< of all; none: the surface has one side
  std::size_t isolated_vertices = 0;    ///< without faces
  std::size_t nonmanifold_vertices = 0; ///< see `umbrellas()`
};

/// counts the elements of a mesh, and its components and borders. \complexity linear
Element_counts count_elements(const Gluing_map& mesh);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_COUNT_ELEMENTS_H
