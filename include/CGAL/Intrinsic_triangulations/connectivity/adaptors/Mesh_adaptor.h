// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_ADAPTORS_MESH_ADAPTOR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_ADAPTORS_MESH_ADAPTOR_H

#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <bit>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is the common base of adaptors of meshes with internal indices.
\tparam Mesh a model of `HalfedgeListGraph` and `FaceListGraph`
*/
template <class Mesh>
class Indexed_mesh_adaptor {
public:
  /// makes room so that adding one vertex, three edges and two faces, or removing as many, cannot
  /// fail. This function serves meshes that can reserve memory.
  void make_room(Mesh& mesh) {
    if constexpr (requires { mesh.make_room(); })
      mesh.make_room();
    else // powers of two: mostly there is nothing to do
      mesh.reserve(std::bit_ceil(num_vertices(mesh) + 1U), std::bit_ceil(num_edges(mesh) + 3U),
                   std::bit_ceil(num_faces(mesh) + 2U));
  }
  /// numbers a vertex, an edge or a face that was added to the mesh.
  template <class Descriptor>
  void add(Descriptor, const Mesh&) {}
  /// frees the number of a vertex, an edge or a face that is going to be removed from the mesh.
  template <class Descriptor>
  void remove(Descriptor, const Mesh&) {}

  /// returns a bound of the numbers of vertices, those of removed ones included.
  std::uint32_t vertex_capacity(const Mesh& mesh) const {
    return static_cast<std::uint32_t>(num_vertices(mesh));
  }
  /// returns a bound of the numbers of edges; twice as many are one for halfedges.
  std::uint32_t edge_capacity(const Mesh& mesh) const {
    return static_cast<std::uint32_t>(num_edges(mesh));
  }
  /// returns a bound of the numbers of faces.
  std::uint32_t face_capacity(const Mesh& mesh) const {
    return static_cast<std::uint32_t>(num_faces(mesh));
  }

  /// reads the coordinates of a point as doubles.
  template <class Point>
  static std::array<double, 3> coordinates(const Point& p) {
    return {CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2])};
  }

  /// returns the point map of `mesh`.
  static auto point_map(const Mesh& mesh) { return get(CGAL::vertex_point, mesh); }
};

/*!
\brief numbers the elements of a mesh and reads its coordinates: the only place for differences
between meshes.

The primary template serves meshes with internal indices in which halfedges `2e` and `2e + 1` are
the sides of edge `e`, such as `CGAL::Surface_mesh` and `Gluing_map`. `CGAL::Polyhedron_3` and
OpenMesh have specialisations in `Polyhedron_3_adaptor.h` and `OpenMesh_adaptor.h`; specialise it
for your own mesh.
\tparam Mesh a model of `HalfedgeListGraph` and `FaceListGraph`
*/
template <class Mesh>
class Mesh_adaptor : public Indexed_mesh_adaptor<Mesh> {
  using Traits = boost::graph_traits<Mesh>;

public:
  /// distinguishes this template from its specialisations.
  static constexpr bool is_primary = true;

  /// numbers the elements of `mesh`; numbers may have gaps where elements were removed.
  explicit Mesh_adaptor(const Mesh& mesh)
      : vertex_(get(boost::vertex_index, mesh)), halfedge_(get(boost::halfedge_index, mesh)),
        face_(get(boost::face_index, mesh)) {}

  /// numbers the elements of a mesh that the caller may change; numbers are 0, 1, 2, ...
  explicit Mesh_adaptor(Mesh& mesh) : Mesh_adaptor(static_cast<const Mesh&>(mesh)) {}

  /// numbers the elements of `copy`, a copy of `original`, as those of `original` are numbered;
  /// `original` may have been moved from.
  Mesh_adaptor(Mesh& copy, [[maybe_unused]] const Mesh_adaptor& numbers,
               [[maybe_unused]] const Mesh& original)
      : Mesh_adaptor(copy) {}

  /// returns the number of a vertex.
  std::uint32_t vertex(typename Traits::vertex_descriptor v) const {
    return static_cast<std::uint32_t>(get(vertex_, v));
  }
  /// returns the number of a halfedge.
  std::uint32_t halfedge(typename Traits::halfedge_descriptor h) const {
    return static_cast<std::uint32_t>(get(halfedge_, h));
  }
  /// returns the number of a face.
  std::uint32_t face(typename Traits::face_descriptor f) const {
    return static_cast<std::uint32_t>(get(face_, f));
  }

  /// returns the vertex with a number.
  typename Traits::vertex_descriptor vertex_at(std::uint32_t i) const {
    return typename Traits::vertex_descriptor{i};
  }
  /// returns the halfedge with a number.
  typename Traits::halfedge_descriptor halfedge_at(std::uint32_t i) const {
    return typename Traits::halfedge_descriptor{i};
  }
  /// returns the face with a number.
  typename Traits::face_descriptor face_at(std::uint32_t i) const {
    return typename Traits::face_descriptor{i};
  }

private:
  typename boost::property_map<Mesh, boost::vertex_index_t>::const_type vertex_;
  typename boost::property_map<Mesh, boost::halfedge_index_t>::const_type halfedge_;
  typename boost::property_map<Mesh, boost::face_index_t>::const_type face_;
};

namespace internal {

// A mesh with numbers of its elements, which copies keep even where descriptors are pointers.
template <class Mesh>
struct Mesh_with_numbers {
  explicit Mesh_with_numbers(Mesh m) : mesh(std::move(m)), numbers(mesh) {}
  Mesh_with_numbers(const Mesh& m, const Mesh_adaptor<Mesh>& n) : mesh(m), numbers(mesh, n, m) {}
  Mesh_with_numbers(const Mesh_with_numbers& other)
      : Mesh_with_numbers(other.mesh, other.numbers) {}
  Mesh_with_numbers(Mesh_with_numbers&& other)
      : mesh(std::move(other.mesh)), numbers(mesh, other.numbers, other.mesh) {}
  Mesh_with_numbers& operator=(Mesh_with_numbers other) {
    mesh = std::move(other.mesh);
    numbers = Mesh_adaptor<Mesh>(mesh, other.numbers, other.mesh);
    return *this;
  }
  ~Mesh_with_numbers() = default;

  Mesh mesh;
  Mesh_adaptor<Mesh> numbers;
};

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_ADAPTORS_MESH_ADAPTOR_H
