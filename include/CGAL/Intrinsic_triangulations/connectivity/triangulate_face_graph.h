// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_TRIANGULATE_FACE_GRAPH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_TRIANGULATE_FACE_GRAPH_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief copies the connectivity of a mesh with polygonal faces, cut into triangles by
`CGAL::Polygon_mesh_processing::triangulate_faces()`.

Vertices keep their numbers. Flat polygons keep their shape; the choice of triangles is what gives one
to others.
\tparam FaceGraph a model of `FaceListGraph` and `HalfedgeListGraph`
\param mesh the mesh
\param points one point per vertex, in the order of iteration
\param polygons set to the number of faces that are not triangles
\throws Invalid_input naming a face that cannot be triangulated, or that meets others at a vertex or
  edge that is not manifold
\complexity linear in the number of faces, for polygons of bounded size
*/
template <class FaceGraph>
Gluing_map gluing_map_from_polygons(const FaceGraph& mesh,
                                    const std::vector<std::array<double, 3>>& points,
                                    std::size_t& polygons) {
  using Point = Exact_predicates_inexact_constructions_kernel::Point_3;
  using Traits = boost::graph_traits<FaceGraph>;
  using Copy = Surface_mesh<Point>;
  const Mesh_adaptor<FaceGraph> number(mesh);
  const auto fail = [](std::size_t f, const char* what) {
    throw Invalid_input(Element_kind::face, f, "face " + std::to_string(f) + what);
  };
  Copy copy;
  std::unordered_map<std::uint32_t, Copy::Vertex_index> vertex;
  for (const typename Traits::vertex_descriptor v : vertices(mesh)) {
    const std::array<double, 3>& p = points[vertex.size()];
    vertex.emplace(number.vertex(v), copy.add_vertex(Point(p[0], p[1], p[2])));
  }
  std::size_t f = 0;
  polygons = 0;
  for (const typename Traits::face_descriptor d : faces(mesh)) {
    std::vector<Copy::Vertex_index> corners;
    for (const typename Traits::halfedge_descriptor h :
         halfedges_around_face(halfedge(d, mesh), mesh))
      corners.push_back(vertex.at(number.vertex(target(h, mesh))));
    if (corners.size() < 3) fail(f, " has fewer than three sides; remove it");
    if (corners.size() > 3) ++polygons;
    if (copy.add_face(corners) == Copy::null_face())
      fail(f, " is a polygon, or meets one, at an edge or vertex that is not manifold; triangulate "
              "the faces first");
    ++f;
  }
  if (!Polygon_mesh_processing::triangulate_faces(copy))
    for (const Copy::Face_index d : copy.faces())
      if (copy.degree(d) > 3)
        fail(d, " is a polygon that cannot be triangulated; split it into triangles");
  return gluing_map_from_face_graph(copy);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_TRIANGULATE_FACE_GRAPH_H
