// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_SURFACE_MESH_H
#define TEST_INTRINSIC_TRIANGULATIONS_SURFACE_MESH_H

#include "meshes.h"

namespace meshes {

/// A `CGAL::Surface_mesh` with the vertices and faces of a mesh, in order.
template <class Surface_mesh>
Surface_mesh surface_mesh(const Mesh& m) {
  Surface_mesh result;
  for (const auto& p : m.points) result.add_vertex({p[0], p[1], p[2]});
  using V = typename Surface_mesh::Vertex_index;
  for (const auto& f : m.triangles) result.add_face(V(f[0]), V(f[1]), V(f[2]));
  return result;
}

} // namespace meshes

#endif // TEST_INTRINSIC_TRIANGULATIONS_SURFACE_MESH_H
