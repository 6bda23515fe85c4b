// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_TOPOLOGY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_TOPOLOGY_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/as_gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

/*!
\file
Counts that describe the topology of a Delta-complex. All of them count with multiplicity, read any
mesh through BGL without looking an edge up by its end vertices, and take time and memory linear in
the mesh, in flat arrays. They require the invariants of that concept. Elements are numbered in the
order of iteration. A `Gluing_map` without removed elements is read in place, another mesh is copied
to one first.
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// the number of umbrellas of each vertex
std::vector<std::uint32_t> umbrellas_of_vertices(const Gluing_map& m);

// a border halfedge of each boundary loop
std::vector<std::uint32_t> border_of_loops(const Gluing_map& m);

} // namespace internal

/*!
\brief tells whether the faces of a mesh can be oriented consistently; this fails only for a
`Gluing_map`.
\tparam Mesh a model of `MutableDeltaComplex`
\complexity constant for meshes whose gluings respect the orientation, else linear
*/
template <ReadableFaceGraph Mesh>
bool is_orientable(const Mesh& mesh) {
  if constexpr (std::is_same_v<Mesh, Gluing_map>)
    return mesh.is_oriented() || find_orientation(gluing_from_map(mesh)).is_orientable;
  else
    return true;
}

/*!
\brief returns V - E + F, isolated vertices included.
\tparam Mesh a model of `MutableDeltaComplex`
*/
template <ReadableFaceGraph Mesh>
std::ptrdiff_t euler_characteristic(const Mesh& mesh) {
  const internal::As_gluing_map read(mesh); // element counts without removed elements
  const Gluing_map& m = *read;
  return std::ptrdiff_t{m.number_of_vertices()} - std::ptrdiff_t{m.number_of_edges()} +
         std::ptrdiff_t{m.number_of_faces()};
}

/*!
\brief numbers the components that faces form across edges.
*/
struct Face_components {
  /// Number of components; two that share only vertices count separately.
  std::uint32_t count = 0;
  /// Component of each face, numbered in the order of their first faces.
  std::vector<std::uint32_t> of_face;
};

/*!
\brief finds the components that faces form across edges.
\tparam Mesh a model of `MutableDeltaComplex`
*/
template <ReadableFaceGraph Mesh>
Face_components connected_components(const Mesh& mesh) {
  const internal::As_gluing_map read(mesh);
  const Gluing_map& m = *read;
  const std::vector<std::uint32_t> first =
      internal::joined_sets(m.number_of_faces(), [&m](const auto& join) {
        for (std::uint32_t e = 0; e < m.number_of_edges(); ++e) {
          const std::uint32_t f = m.face({2 * e}).index, g = m.face({2 * e + 1}).index;
          if (f != Gluing::none && g != Gluing::none) join(f, g);
        }
      });
  Face_components c;
  for (std::uint32_t f = 0; f < first.size(); ++f)
    c.of_face.push_back(first[f] == f ? c.count++ : c.of_face[first[f]]);
  return c;
}

/*!
\brief finds a border halfedge of each boundary loop.

Loops are those of the surface after splitting its nonmanifold vertices: each turns about a vertex
within one umbrella. It does not use `next()`, which is arbitrary at nonmanifold vertices and does
not exist on the border of a nonorientable gluing.
\tparam Mesh a model of `MutableDeltaComplex`
\return one halfedge without a face per loop
*/
template <ReadableFaceGraph Mesh>
std::vector<typename boost::graph_traits<Mesh>::halfedge_descriptor>
boundary_loops(const Mesh& mesh) {
  using Traits = boost::graph_traits<Mesh>;
  const std::vector<std::uint32_t> numbers =
      internal::border_of_loops(*internal::As_gluing_map(mesh));
  std::vector<typename Traits::halfedge_descriptor> loops;
  std::uint32_t e = 0;
  auto wanted = numbers.begin();
  for (const typename Traits::edge_descriptor d : edges(mesh)) {
    if (wanted == numbers.end()) break;
    if (e++ != *wanted / 2) continue;
    const typename Traits::halfedge_descriptor h = halfedge(d, mesh);
    loops.push_back(*wanted++ % 2 == 0 ? h : opposite(h, mesh));
  }
  return loops;
}

/*!
\brief counts the umbrellas of each vertex: the components that the face corners at it form across
edges. One at a manifold vertex, none at an isolated one, more at a nonmanifold one.
\tparam Mesh a model of `MutableDeltaComplex`
*/
template <ReadableFaceGraph Mesh>
std::vector<std::uint32_t> umbrellas(const Mesh& mesh) {
  return internal::umbrellas_of_vertices(*internal::As_gluing_map(mesh));
}

/*!
\brief returns the genus of an orientable surface, summed over its components.

Nonmanifold vertices are split and isolated ones dropped first. Then V - E + F = 2 C - 2 g - b with
C components and b boundary loops.
\tparam Mesh a model of `MutableDeltaComplex`
\return the genus, or nothing if the surface is not orientable
*/
template <ReadableFaceGraph Mesh>
std::optional<std::size_t> genus(const Mesh& mesh) {
  const internal::As_gluing_map read(mesh);
  const Gluing_map& m = *read;
  if (!is_orientable(m)) return std::nullopt;
  // all terms are nonnegative, and so is the sum: 2 g = (2 C + E) - (V + F + b)
  const std::size_t more = 2 * std::size_t{connected_components(m).count} + m.number_of_edges();
  std::size_t less = m.number_of_faces() + internal::border_of_loops(m).size();
  for (const std::uint32_t count : umbrellas(m)) less += count;
  return (more - less) / 2;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_TOPOLOGY_H
