// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_MOVES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_MOVES_H

#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>

#include <boost/graph/graph_traits.hpp>

#include <type_traits>

/*!
\file
Inserts and removes vertices of a Delta-complex, and takes flips back, in the connectivity only.
Remaining halfedges keep their names. Edges are not looked up by their ends, so that loops and faces
glued to themselves are correct.
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Connects three halfedges to a face.
template <class Mesh, class Halfedge = typename boost::graph_traits<Mesh>::halfedge_descriptor>
void connect_face(Halfedge a, Halfedge b, Halfedge c,
                  typename boost::graph_traits<Mesh>::face_descriptor f, Mesh& mesh) {
  set_next(a, b, mesh);
  set_next(b, c, mesh);
  set_next(c, a, mesh);
  for (const Halfedge h : {a, b, c}) set_face(h, f, mesh);
  set_halfedge(f, a, mesh);
}

// Makes `kept` the halfedge of its target if that is `removed` so far. Any other halfedge stays, so
// that vertices of the border keep theirs on the border.
template <class Mesh, class Halfedge = typename boost::graph_traits<Mesh>::halfedge_descriptor>
void replace_halfedge_of_target(Halfedge removed, Halfedge kept, Mesh& mesh) {
  const auto v = target(kept, mesh);
  if (halfedge(v, mesh) == removed) set_halfedge(v, kept, mesh);
}

template <class Mesh, class Numbers, class Element>
Element numbered(Element e, const Mesh& mesh, Numbers& numbers) {
  numbers.add(e, mesh);
  return e;
}

// Adds an unconnected, numbered element; the numbering may reuse a removed one. An edge is given by
// its halfedge.
template <class Mesh, class Numbers>
typename boost::graph_traits<Mesh>::vertex_descriptor add_numbered_vertex(Mesh& mesh,
                                                                          Numbers& numbers) {
  if constexpr (requires { numbers.reuse_vertex(mesh); })
    if (const auto v = numbers.reuse_vertex(mesh); v != boost::graph_traits<Mesh>::null_vertex())
      return v;
  return numbered(add_vertex(mesh), mesh, numbers);
}

template <class Mesh, class Numbers>
typename boost::graph_traits<Mesh>::halfedge_descriptor add_numbered_edge(Mesh& mesh,
                                                                          Numbers& numbers) {
  if constexpr (requires { numbers.reuse_edge(mesh); })
    if (const auto h = numbers.reuse_edge(mesh); h != boost::graph_traits<Mesh>::null_halfedge())
      return h;
  return halfedge(numbered(add_edge(mesh), mesh, numbers), mesh);
}

template <class Mesh, class Numbers>
typename boost::graph_traits<Mesh>::face_descriptor add_numbered_face(Mesh& mesh,
                                                                      Numbers& numbers) {
  if constexpr (requires { numbers.reuse_face(mesh); })
    if (const auto f = numbers.reuse_face(mesh); f != boost::graph_traits<Mesh>::null_face())
      return f;
  return numbered(add_face(mesh), mesh, numbers);
}

// Removes a vertex, an edge or a face, and gives its number back.
template <class Mesh, class Numbers, class Element>
void remove_numbered(Element e, Mesh& mesh, Numbers& numbers) {
  using Traits = boost::graph_traits<Mesh>;
  numbers.remove(e, mesh);
  if constexpr (std::is_same_v<Element, typename Traits::vertex_descriptor>)
    remove_vertex(e, mesh);
  else if constexpr (std::is_same_v<Element, typename Traits::edge_descriptor>)
    remove_edge(e, mesh);
  else
    remove_face(e, mesh);
}

} // namespace internal

/*!
\brief takes back the flip of an edge: turns it from km in the faces kmj and mki to ij in ijk and
jim.
\tparam Mesh a model of `MutableDeltaComplex`
\param h the halfedge km, which `CGAL::Euler::flip_edge()` has turned; its face and that of its
  opposite are not the same
\param mesh the complex
\complexity constant
*/
template <MutableDeltaComplex Mesh>
void flip_edge_back(typename boost::graph_traits<Mesh>::halfedge_descriptor h, Mesh& mesh) {
  using Halfedge = typename boost::graph_traits<Mesh>::halfedge_descriptor;
  const Halfedge o = opposite(h, mesh), mj = next(h, mesh), jk = next(mj, mesh);
  const Halfedge ki = next(o, mesh), im = next(ki, mesh);
  internal::replace_halfedge_of_target(h, im, mesh);
  internal::replace_halfedge_of_target(o, jk, mesh);
  set_target(h, target(mj, mesh), mesh);
  set_target(o, target(ki, mesh), mesh);
  const auto f = face(h, mesh), g = face(o, mesh);
  internal::connect_face(h, jk, ki, f, mesh);
  internal::connect_face(o, im, mj, g, mesh);
}

/*!
\brief inserts a vertex p in the face ijk of `h` = ij: `h` is in face ijp then, followed by jp and
pi.
\tparam Mesh a model of `MutableDeltaComplex`
\param h a halfedge with a face
\param mesh the complex
\param numbers numbers the new elements
\return the vertex
\complexity constant
*/
template <MutableDeltaComplex Mesh>
typename boost::graph_traits<Mesh>::vertex_descriptor
split_face(typename boost::graph_traits<Mesh>::halfedge_descriptor h, Mesh& mesh,
           Mesh_adaptor<Mesh>& numbers) {
  using Halfedge = typename boost::graph_traits<Mesh>::halfedge_descriptor;
  const Halfedge ij = h, jk = next(h, mesh), ki = next(jk, mesh);
  const auto p = internal::add_numbered_vertex(mesh, numbers);
  const Halfedge ip = internal::add_numbered_edge(mesh, numbers);
  const Halfedge jp = internal::add_numbered_edge(mesh, numbers);
  const Halfedge kp = internal::add_numbered_edge(mesh, numbers);
  const Halfedge pi = opposite(ip, mesh), pj = opposite(jp, mesh), pk = opposite(kp, mesh);
  set_target(pi, target(ki, mesh), mesh);
  set_target(pj, target(ij, mesh), mesh);
  set_target(pk, target(jk, mesh), mesh);
  for (const Halfedge s : {ip, jp, kp}) set_target(s, p, mesh);
  internal::connect_face(ij, jp, pi, face(h, mesh), mesh);
  internal::connect_face(jk, kp, pj, internal::add_numbered_face(mesh, numbers), mesh);
  internal::connect_face(ki, ip, pk, internal::add_numbered_face(mesh, numbers), mesh);
  set_halfedge(p, ip, mesh);
  return p;
}

/*!
\brief removes a vertex p with three edges, none of them a loop: undoes `split_face()`.
\tparam Mesh a model of `MutableDeltaComplex`
\param h the halfedge ij of a face ijp; its face is the one that stays
\param mesh the complex
\param numbers gives back the numbers of what is removed
\complexity constant
*/
template <MutableDeltaComplex Mesh>
void remove_degree_3_vertex(typename boost::graph_traits<Mesh>::halfedge_descriptor h, Mesh& mesh,
                            Mesh_adaptor<Mesh>& numbers) {
  using Halfedge = typename boost::graph_traits<Mesh>::halfedge_descriptor;
  const Halfedge ij = h, jp = next(ij, mesh), pi = next(jp, mesh);
  const Halfedge jk = next(opposite(jp, mesh), mesh), kp = next(jk, mesh);
  const Halfedge ki = next(opposite(kp, mesh), mesh);
  const auto p = target(jp, mesh);
  const auto g = face(jk, mesh), e = face(ki, mesh);
  internal::connect_face(ij, jk, ki, face(h, mesh), mesh);
  internal::replace_halfedge_of_target(opposite(jp, mesh), ij, mesh);
  internal::replace_halfedge_of_target(opposite(kp, mesh), jk, mesh);
  internal::replace_halfedge_of_target(pi, ki, mesh);
  for (const Halfedge s : {jp, kp, pi}) internal::remove_numbered(edge(s, mesh), mesh, numbers);
  internal::remove_numbered(g, mesh, numbers);
  internal::remove_numbered(e, mesh, numbers);
  internal::remove_numbered(p, mesh, numbers);
}

/*!
\brief inserts a vertex p on a border edge: `h` = ij, in face ijk, becomes ip in face ipk; pj is in
a new face pjk.
\tparam Mesh a model of `MutableDeltaComplex`
\param h a halfedge with a face, its opposite without
\param mesh the complex
\param numbers numbers the new elements
\return the vertex
\complexity linear in the degree of j
*/
template <MutableDeltaComplex Mesh>
typename boost::graph_traits<Mesh>::vertex_descriptor
split_border_edge(typename boost::graph_traits<Mesh>::halfedge_descriptor h, Mesh& mesh,
                  Mesh_adaptor<Mesh>& numbers) {
  using Halfedge = typename boost::graph_traits<Mesh>::halfedge_descriptor;
  const Halfedge ij = h, jk = next(h, mesh), ki = next(jk, mesh), ji = opposite(h, mesh);
  const Halfedge before = prev(ji, mesh); // on the border
  const auto j = target(ij, mesh);
  const auto p = internal::add_numbered_vertex(mesh, numbers);
  const Halfedge pj = internal::add_numbered_edge(mesh, numbers), jp = opposite(pj, mesh);
  const Halfedge pk = internal::add_numbered_edge(mesh, numbers), kp = opposite(pk, mesh);
  for (const Halfedge s : {ij, kp, jp}) set_target(s, p, mesh);
  set_target(pk, target(jk, mesh), mesh);
  set_target(pj, j, mesh);
  if (halfedge(j, mesh) == ij) set_halfedge(j, pj, mesh);
  internal::connect_face(ij, pk, ki, face(h, mesh), mesh);
  internal::connect_face(pj, jk, kp, internal::add_numbered_face(mesh, numbers), mesh);
  set_face(jp, boost::graph_traits<Mesh>::null_face(), mesh);
  set_next(before, jp, mesh);
  set_next(jp, ji, mesh);
  set_halfedge(p, jp, mesh);
  return p;
}

/*!
\brief removes a vertex p of the border with one inner edge: undoes `split_border_edge()`.
\tparam Mesh a model of `MutableDeltaComplex`
\param h the halfedge ip along the border that has a face; it becomes ij
\param mesh the complex
\param numbers gives back the numbers of what is removed
\complexity linear in the degree of j
*/
template <MutableDeltaComplex Mesh>
void remove_border_vertex(typename boost::graph_traits<Mesh>::halfedge_descriptor h, Mesh& mesh,
                          Mesh_adaptor<Mesh>& numbers) {
  using Halfedge = typename boost::graph_traits<Mesh>::halfedge_descriptor;
  const Halfedge ip = h, pk = next(h, mesh), ki = next(pk, mesh), kp = opposite(pk, mesh);
  const Halfedge pj = next(kp, mesh), jk = next(pj, mesh), jp = opposite(pj, mesh);
  const Halfedge pi = opposite(ip, mesh), before = prev(jp, mesh);
  const auto p = target(ip, mesh), j = target(pj, mesh);
  const auto g = face(pj, mesh);
  set_target(ip, j, mesh);
  internal::connect_face(ip, jk, ki, face(h, mesh), mesh);
  set_next(before, pi, mesh);
  internal::replace_halfedge_of_target(pj, ip, mesh);
  internal::replace_halfedge_of_target(pk, jk, mesh);
  internal::remove_numbered(edge(pj, mesh), mesh, numbers);
  internal::remove_numbered(edge(pk, mesh), mesh, numbers);
  internal::remove_numbered(g, mesh, numbers);
  internal::remove_numbered(p, mesh, numbers);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_MOVES_H
