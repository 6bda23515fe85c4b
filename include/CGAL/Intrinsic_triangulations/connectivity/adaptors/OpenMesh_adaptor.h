// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_ADAPTORS_OPENMESH_ADAPTOR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_ADAPTORS_OPENMESH_ADAPTOR_H

#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/support/reserve_at_least.h>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <vector>

/*!
\file
The only header that includes OpenMesh. OpenMesh needs `_USE_MATH_DEFINES` to be defined.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief reads the coordinates of an OpenMesh vertex in full.

The point map of CGAL 5.5 for OpenMesh rounds coordinates to `float`.
\tparam Mesh an OpenMesh mesh
*/
template <std::derived_from<OpenMesh::PolyConnectivity> Mesh>
struct OpenMesh_coordinate_map {
  /// \cond
  using key_type = typename boost::graph_traits<Mesh>::vertex_descriptor;
  using value_type = typename Mesh::Point;
  using reference = const value_type&;
  using category = boost::readable_property_map_tag;
  friend reference get(const OpenMesh_coordinate_map& m, key_type v) { return m.mesh->point(v); }
  const Mesh* mesh;
  /// \endcond
};

/*!
\brief numbers the elements of an OpenMesh triangle or polygon mesh by their handles.

OpenMesh marks elements as deleted and leaves them until `garbage_collection()`; BGL's ranges skip
them. `reuse_vertex()`, ... bring them back, so that a mesh in which vertices are inserted and
removed in turn does not grow.
\tparam Mesh an OpenMesh mesh
*/
template <class Mesh>
  requires std::derived_from<Mesh, OpenMesh::PolyConnectivity>
class Mesh_adaptor<Mesh> : public Indexed_mesh_adaptor<Mesh> {
  using Traits = boost::graph_traits<Mesh>;
  using Vertex = typename Traits::vertex_descriptor;
  using Halfedge = typename Traits::halfedge_descriptor;
  using Edge = typename Traits::edge_descriptor;
  using Face = typename Traits::face_descriptor;

public:
  /// \cond see `Mesh_adaptor`
  explicit Mesh_adaptor(const Mesh&) {}

  explicit Mesh_adaptor(Mesh& mesh) {
    if (mesh.has_vertex_status())
      find_deleted<OpenMesh::VertexHandle>(mesh, mesh.n_vertices(), free_vertices_);
    if (mesh.has_edge_status())
      find_deleted<OpenMesh::EdgeHandle>(mesh, mesh.n_edges(), free_edges_);
    if (mesh.has_face_status())
      find_deleted<OpenMesh::FaceHandle>(mesh, mesh.n_faces(), free_faces_);
  }

  Mesh_adaptor([[maybe_unused]] Mesh& copy, const Mesh_adaptor& numbers,
               [[maybe_unused]] const Mesh& original)
      : Mesh_adaptor(numbers) {}

  std::uint32_t vertex(Vertex v) const { return static_cast<std::uint32_t>(v.idx()); }
  std::uint32_t halfedge(Halfedge h) const { return static_cast<std::uint32_t>(h.idx()); }
  std::uint32_t face(Face f) const { return static_cast<std::uint32_t>(f.idx()); }

  Vertex vertex_at(std::uint32_t i) const { return Vertex(static_cast<int>(i)); }
  Halfedge halfedge_at(std::uint32_t i) const { return Halfedge(static_cast<int>(i)); }
  Face face_at(std::uint32_t i) const { return Face(static_cast<int>(i)); }
  /// \endcond

  /// makes room in the mesh, for marks of removed elements, and for their numbers.
  void make_room(Mesh& mesh) {
    Indexed_mesh_adaptor<Mesh>::make_room(mesh);
    if (!mesh.has_vertex_status()) mesh.request_vertex_status();
    if (!mesh.has_halfedge_status()) mesh.request_halfedge_status();
    if (!mesh.has_edge_status()) mesh.request_edge_status();
    if (!mesh.has_face_status()) mesh.request_face_status();
    reserve_at_least(free_vertices_, free_vertices_.size() + 1);
    reserve_at_least(free_edges_, free_edges_.size() + 3);
    reserve_at_least(free_faces_, free_faces_.size() + 2);
  }
  /// stores a vertex before its removal from the mesh.
  void remove(Vertex v, const Mesh&) { free_vertices_.push_back(v.idx()); }
  /// stores an edge before its removal from the mesh.
  void remove(Edge e, const Mesh& mesh) {
    free_edges_.push_back(mesh.edge_handle(e.halfedge()).idx());
  }
  /// stores a face before its removal from the mesh.
  void remove(Face f, const Mesh&) { free_faces_.push_back(f.idx()); }

  /// brings back the vertex that was removed last; returns the null vertex if there is none.
  Vertex reuse_vertex(Mesh& mesh) { return revive<OpenMesh::VertexHandle>(mesh, free_vertices_); }
  /// brings back the edge that was removed last; returns its first halfedge, null if there is none.
  Halfedge reuse_edge(Mesh& mesh) {
    const auto e = revive<OpenMesh::EdgeHandle>(mesh, free_edges_);
    if (!e.is_valid()) return Halfedge();
    for (const unsigned side : {0U, 1U})
      mesh.status(mesh.halfedge_handle(e, side)).set_deleted(false);
    return mesh.halfedge_handle(e, 0);
  }
  /// brings back the face that was removed last; returns the null face if there is none.
  Face reuse_face(Mesh& mesh) { return revive<OpenMesh::FaceHandle>(mesh, free_faces_); }

  /// returns a point map without loss.
  static OpenMesh_coordinate_map<Mesh> point_map(const Mesh& mesh) { return {&mesh}; }

private:
  template <class Handle>
  static void find_deleted(const Mesh& mesh, std::size_t count, std::vector<int>& deleted) {
    for (int i = 0; i < static_cast<int>(count); ++i)
      if (mesh.status(Handle(i)).deleted()) deleted.push_back(i);
  }

  template <class Handle>
  static Handle revive(Mesh& mesh, std::vector<int>& deleted) {
    if (deleted.empty()) return Handle();
    const Handle revived(deleted.back());
    deleted.pop_back();
    mesh.status(revived).set_deleted(false);
    return revived;
  }

  std::vector<int> free_vertices_, free_edges_, free_faces_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_ADAPTORS_OPENMESH_ADAPTOR_H
