// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_HULL_MESH_H
#define TEST_HULL_MESH_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <vector>

/// Convex hulls as meshes, for tests and benchmarks.
namespace hull_mesh {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// The triangles of a hull by the numbers of its points, sorted; each begins with its least one.
inline std::vector<std::array<std::uint32_t, 3>>
sorted_triangles(const std::vector<Kernel::Point_3>& points) {
  std::map<Kernel::Point_3, std::uint32_t> number; // of equal points, the first
  for (std::uint32_t i = 0; i < points.size(); ++i) number.insert({points[i], i});
  Mesh mesh;
  CGAL::convex_hull_3(points.begin(), points.end(), mesh);
  std::vector<std::array<std::uint32_t, 3>> result;
  for (const Mesh::Face_index f : mesh.faces()) {
    std::array<std::uint32_t, 3> t{};
    Mesh::Halfedge_index h = mesh.halfedge(f);
    for (std::uint32_t& corner : t) {
      corner = number.at(mesh.point(mesh.source(h)));
      h = mesh.next(h);
    }
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    result.push_back(t);
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// The convex hull of points, with vertices in their order, and sorted faces. Numbers that
/// `CGAL::convex_hull_3()` gives depend on addresses: it walks around a hole from the vertex with
/// the least one.
inline Mesh hull_of(const std::vector<Kernel::Point_3>& points) {
  const std::vector<std::array<std::uint32_t, 3>> triangles = sorted_triangles(points);
  std::vector<char> is_corner(points.size(), 0);
  for (const auto& t : triangles)
    for (const std::uint32_t i : t) is_corner[i] = 1;
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertex(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i)
    if (is_corner[i] != 0) vertex[i] = mesh.add_vertex(points[i]);
  for (const auto& t : triangles) mesh.add_face(vertex[t[0]], vertex[t[1]], vertex[t[2]]);
  return mesh;
}

} // namespace hull_mesh

#endif // TEST_HULL_MESH_H
