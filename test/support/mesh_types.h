// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_MESH_TYPES_H
#define TEST_INTRINSIC_TRIANGULATIONS_MESH_TYPES_H

#include "meshes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Surface_mesh.h>

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/OpenMesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Polyhedron_3_adaptor.h>
#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>

#include <OpenMesh/Core/Geometry/VectorT.hh>

#include <gtest/gtest.h>

// All models of MutableDeltaComplex, for typed tests.

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Polyhedron_with_ids = CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>;

struct Double_traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using OpenMesh_triangles = OpenMesh::TriMesh_ArrayKernelT<Double_traits>;
using OpenMesh_polygons = OpenMesh::PolyMesh_ArrayKernelT<Double_traits>;

using All_meshes =
    ::testing::Types<CGAL::Intrinsic_triangulations::Gluing_map, Surface_mesh, Polyhedron,
                     Polyhedron_with_ids, OpenMesh_triangles, OpenMesh_polygons>;

namespace meshes {

/// A mesh of any of these types, but `Gluing_map`, with the vertices and faces of a mesh, in order.
template <class Model>
Model mesh_of(const Mesh& m) {
  Model mesh;
  CGAL::Intrinsic_triangulations::copy_gluing_map(m.map(), mesh);
  std::size_t i = 0;
  for (const typename boost::graph_traits<Model>::vertex_descriptor v : vertices(mesh)) {
    const Point& p = m.points[i++];
    if constexpr (requires { mesh.set_point(v, OpenMesh::Vec3d(p[0], p[1], p[2])); })
      mesh.set_point(v, OpenMesh::Vec3d(p[0], p[1], p[2]));
    else
      put(get(CGAL::vertex_point, mesh), v, Kernel::Point_3(p[0], p[1], p[2]));
  }
  return mesh;
}

} // namespace meshes

#endif // TEST_INTRINSIC_TRIANGULATIONS_MESH_TYPES_H
