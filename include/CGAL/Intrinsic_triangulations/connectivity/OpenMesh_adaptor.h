// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_OPENMESH_ADAPTOR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_OPENMESH_ADAPTOR_H

#include <CGAL/Intrinsic_triangulations/connectivity/Mesh_adaptor.h>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

#include <array>
#include <cstdint>

/*!
\file
The only header that includes OpenMesh. OpenMesh needs `_USE_MATH_DEFINES` to be defined.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief reads the coordinates of an OpenMesh vertex in full.

The point map that CGAL 5.5 has for OpenMesh rounds coordinates to `float`.
\tparam Mesh an OpenMesh mesh
*/
template <class Mesh>
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
\brief numbers the elements of an OpenMesh mesh by their handles.
\tparam Mesh an OpenMesh mesh
*/
template <class Mesh>
class OpenMesh_adaptor {
  using Traits = boost::graph_traits<Mesh>;

public:
  /// numbers the elements of `mesh`.
  explicit OpenMesh_adaptor(const Mesh&) {}

  /// returns the number of a vertex.
  std::uint32_t vertex(typename Traits::vertex_descriptor v) const {
    return static_cast<std::uint32_t>(v.idx());
  }
  /// returns the number of a halfedge.
  std::uint32_t halfedge(typename Traits::halfedge_descriptor h) const {
    return static_cast<std::uint32_t>(h.idx());
  }
  /// returns the number of a face.
  std::uint32_t face(typename Traits::face_descriptor f) const {
    return static_cast<std::uint32_t>(f.idx());
  }

  /// returns the vertex with a number.
  typename Traits::vertex_descriptor vertex_at(std::uint32_t i) const {
    return typename Traits::vertex_descriptor(static_cast<int>(i));
  }
  /// returns the halfedge with a number.
  typename Traits::halfedge_descriptor halfedge_at(std::uint32_t i) const {
    return typename Traits::halfedge_descriptor(static_cast<int>(i));
  }
  /// returns the face with a number.
  typename Traits::face_descriptor face_at(std::uint32_t i) const {
    return typename Traits::face_descriptor(static_cast<int>(i));
  }

  /// numbers an element that was added to the mesh.
  template <class Descriptor>
  void add(Descriptor, const Mesh&) {}
  /// frees the number of an element that is going to be removed from the mesh.
  template <class Descriptor>
  void remove(Descriptor, const Mesh&) {}

  /// reads the coordinates of a point as doubles.
  template <class Point>
  static std::array<double, 3> coordinates(const Point& p) {
    return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
  }

  /// returns a point map without loss.
  static OpenMesh_coordinate_map<Mesh> point_map(const Mesh& mesh) { return {&mesh}; }
};

/// adapts OpenMesh triangle meshes
template <class T>
class Mesh_adaptor<OpenMesh::TriMesh_ArrayKernelT<T>>
    : public OpenMesh_adaptor<OpenMesh::TriMesh_ArrayKernelT<T>> {
public:
  using OpenMesh_adaptor<OpenMesh::TriMesh_ArrayKernelT<T>>::OpenMesh_adaptor;
};

/// adapts OpenMesh polygon meshes
template <class T>
class Mesh_adaptor<OpenMesh::PolyMesh_ArrayKernelT<T>>
    : public OpenMesh_adaptor<OpenMesh::PolyMesh_ArrayKernelT<T>> {
public:
  using OpenMesh_adaptor<OpenMesh::PolyMesh_ArrayKernelT<T>>::OpenMesh_adaptor;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_OPENMESH_ADAPTOR_H
