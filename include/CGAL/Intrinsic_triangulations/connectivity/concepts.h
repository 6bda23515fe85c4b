// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_CONCEPTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_CONCEPTS_H

#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>

#include <boost/graph/graph_traits.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief requires triangles that are read by the numbers of their sides.

Syntax of \ref ::NumberedTriangles, where its meaning is described.
*/
template <class Complex>
concept NumberedTriangles = requires(const Complex& c, std::uint32_t h) {
  { c.next(h) } -> std::same_as<std::uint32_t>;
};

/*!
\brief requires a triangulated surface with a metric that is read by the numbers of its elements.

Syntax of \ref ::NumberedComplex, which describes its meaning.
*/
template <class Complex>
concept NumberedComplex = requires(const Complex& c, std::uint32_t i) {
  { c.next(i) } -> std::same_as<std::uint32_t>;
  { c.is_border(i) } -> std::same_as<bool>;
  { c.face(i) } -> std::same_as<std::uint32_t>;
  { c.source(i) } -> std::same_as<std::uint32_t>;
  { c.target(i) } -> std::same_as<std::uint32_t>;
  { c.outgoing_halfedge(i) } -> std::same_as<std::uint32_t>;
  { c.squared_length(i) } -> std::same_as<double>;
  { c.quadruple_area(i) } -> std::same_as<double>;
  { c.scale_exponent() } -> std::same_as<int>;
};

namespace internal {

// `boost::graph_traits<T>` is an error, not a substitution failure, if T is not a mesh: require
// functions on it first.
template <class Mesh>
concept Has_mesh_elements = requires(const Mesh& m) {
  vertices(m);
  halfedges(m);
  edges(m);
  faces(m);
};

template <class Mesh, class Traits = boost::graph_traits<Mesh>,
          class V = typename Traits::vertex_descriptor,
          class H = typename Traits::halfedge_descriptor,
          class E = typename Traits::edge_descriptor, class F = typename Traits::face_descriptor>
concept Has_connectivity = requires(const Mesh& m, V v, H h, E e, F f) {
  { num_vertices(m) } -> std::convertible_to<std::size_t>;
  { num_edges(m) } -> std::convertible_to<std::size_t>;
  { num_faces(m) } -> std::convertible_to<std::size_t>;
  { next(h, m) } -> std::convertible_to<H>;
  { opposite(h, m) } -> std::convertible_to<H>;
  { source(h, m) } -> std::convertible_to<V>;
  { target(h, m) } -> std::convertible_to<V>;
  { face(h, m) } -> std::convertible_to<F>;
  { edge(h, m) } -> std::convertible_to<E>;
  { halfedge(v, m) } -> std::convertible_to<H>;
  { halfedge(e, m) } -> std::convertible_to<H>;
  { halfedge(f, m) } -> std::convertible_to<H>;
  { Traits::null_halfedge() } -> std::convertible_to<H>;
  { Traits::null_face() } -> std::convertible_to<F>;
  { v == v } -> std::convertible_to<bool>;
  { h == h } -> std::convertible_to<bool>;
  { f == f } -> std::convertible_to<bool>;
};

template <class Mesh, class Traits = boost::graph_traits<Mesh>,
          class V = typename Traits::vertex_descriptor,
          class H = typename Traits::halfedge_descriptor,
          class E = typename Traits::edge_descriptor, class F = typename Traits::face_descriptor>
concept Has_mutable_connectivity = requires(Mesh& m, V v, H h, E e, F f) {
  { add_vertex(m) } -> std::convertible_to<V>;
  { add_edge(m) } -> std::convertible_to<E>;
  { add_face(m) } -> std::convertible_to<F>;
  remove_vertex(v, m);
  remove_edge(e, m);
  remove_face(f, m);
  set_next(h, h, m);
  set_target(h, v, m);
  set_face(h, f, m);
  set_halfedge(v, h, m);
  set_halfedge(f, h, m);
};

template <class Mesh, class Traits = boost::graph_traits<Mesh>>
concept Has_numbers = requires(Mesh& m, const Mesh& c, const Mesh_adaptor<Mesh>& a,
                               Mesh_adaptor<Mesh>& n, typename Traits::vertex_descriptor v,
                               typename Traits::halfedge_descriptor h,
                               typename Traits::edge_descriptor e,
                               typename Traits::face_descriptor f, std::uint32_t i) {
  Mesh_adaptor<Mesh>(m);
  Mesh_adaptor<Mesh>(c);
  Mesh_adaptor<Mesh>(m, a, c);
  n.add(v, c);
  n.add(e, c);
  n.add(f, c);
  n.remove(v, c);
  n.remove(e, c);
  n.remove(f, c);
  { a.vertex_capacity(c) } -> std::same_as<std::uint32_t>;
  { a.edge_capacity(c) } -> std::same_as<std::uint32_t>;
  { a.face_capacity(c) } -> std::same_as<std::uint32_t>;
  { a.vertex_at(i) } -> std::convertible_to<typename Traits::vertex_descriptor>;
  { a.halfedge_at(i) } -> std::convertible_to<typename Traits::halfedge_descriptor>;
  { a.face_at(i) } -> std::convertible_to<typename Traits::face_descriptor>;
  { a.vertex(v) } -> std::same_as<std::uint32_t>;
  { a.halfedge(h) } -> std::same_as<std::uint32_t>;
  { a.face(f) } -> std::same_as<std::uint32_t>;
};

} // namespace internal

/*!
\brief requires the connectivity of a surface of polygons that can be read.

Syntax of \ref ::ReadableFaceGraph, where its meaning is described.
*/
template <class Mesh>
concept ReadableFaceGraph = internal::Has_mesh_elements<Mesh> && internal::Has_connectivity<Mesh>;

/*!
\brief requires a surface of polygons that can be built, one element after another.

Syntax of \ref ::WritableFaceGraph, where its meaning is described.
*/
template <class Mesh>
concept WritableFaceGraph = ReadableFaceGraph<Mesh> && internal::Has_mutable_connectivity<Mesh>;

/*!
\brief requires the connectivity of a triangulated surface that can be built and flipped, read as a
Delta-complex: elements need not be determined by their vertices.

Syntax of \ref ::MutableDeltaComplex, which describes its meaning.
*/
template <class Mesh>
concept MutableDeltaComplex = std::default_initializable<Mesh> && std::move_constructible<Mesh> &&
    WritableFaceGraph<Mesh> && internal::Has_numbers<Mesh>;

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_CONCEPTS_H
