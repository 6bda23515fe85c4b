// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/count_elements.h>
#include <CGAL/Intrinsic_triangulations/connectivity/topology.h>

#include <cstddef>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations {

Element_counts count_elements(const Gluing_map& mesh) {
  Element_counts n;
  n.vertices = mesh.number_of_vertices();
  n.edges = mesh.number_of_edges();
  n.faces = mesh.number_of_faces();
  for (std::uint32_t h = 0; h < mesh.number_of_halfedges(); ++h)
    if (mesh.face({h}).index == Gluing::none) ++n.boundary_edges;
  n.components = connected_components(mesh).count;
  n.boundary_loops = boundary_loops(mesh).size();
  std::size_t all = 0;
  for (const std::uint32_t count : umbrellas(mesh)) {
    all += count;
    n.isolated_vertices += count == 0 ? 1 : 0;
    n.nonmanifold_vertices += count > 1 ? 1 : 0;
  }
  // as genus() does, which would count all of this again
  if (is_orientable(mesh))
    n.genus = (2 * n.components + n.edges - all - n.faces - n.boundary_loops) / 2;
  return n;
}

} // namespace CGAL::Intrinsic_triangulations
