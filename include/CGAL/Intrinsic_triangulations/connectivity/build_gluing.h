// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_BUILD_GLUING_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_BUILD_GLUING_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>

#include <CGAL/boost/graph/helpers.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief requires a range, of known size, of triples of numbers: the vertices of triangles.

Syntax of \ref ::TriangleRange, where its meaning is described.
*/
template <class Range>
concept TriangleRange = requires(const Range& triangles) {
  { triangles.size() } -> std::convertible_to<std::size_t>;
  requires std::integral<std::remove_cvref_t<decltype((*triangles.begin())[0])>>;
};

namespace internal {

// A side of a triangle, and whether it runs along its edge or against it.
struct Edge_side {
  std::uint32_t halfedge;
  bool is_along;
};

// Sides of triangles, those at one edge together.
struct Sides_by_edge {
  std::vector<Edge_side> sides;
  std::vector<std::uint32_t>
      first; // where the sides of each edge begin, and last the number of all

  std::uint32_t number_of_edges() const { return static_cast<std::uint32_t>(first.size() - 1); }
  std::span<const Edge_side> operator[](std::uint32_t e) const {
    return {sides.data() + first[e], sides.data() + first[e + 1]};
  }
};

// The sides of triangles, of which two with the same ends are at one edge; the edge runs from its
// lower end. The sides at an edge are in the order of halfedges.
Sides_by_edge sides_by_edge(const Gluing& g);

// Triangles before any gluing.
template <TriangleRange Triangles>
Gluing unglued_triangles(std::uint32_t number_of_vertices, const Triangles& triangles) {
  Gluing g;
  g.number_of_vertices = number_of_vertices;
  g.origin.reserve(3 * triangles.size());
  for (const auto& t : triangles) {
    const auto f = g.origin.size() / 3;
    for (unsigned k = 0; k < 3; ++k) {
      if (std::cmp_less(t[k], 0) || std::cmp_greater_equal(t[k], number_of_vertices))
        throw Invalid_input::about(Element_kind::face, f,
                                   " refers to vertex " + std::to_string(t[k]) +
                                       ", but vertices are numbered from 0, and there are " +
                                       std::to_string(number_of_vertices) +
                                       "; correct the number or remove the face");
      if (t[k] == t[(k + 1) % 3])
        throw Invalid_input::about(Element_kind::face, f,
                                   " repeats vertex " + std::to_string(t[k]) + "; remove the face");
      g.origin.push_back(static_cast<std::uint32_t>(t[k]));
    }
  }
  g.glue.assign(g.origin.size(), Gluing::none);
  return g;
}

// "edge (0, 1) has 3 faces (4, 5, 6)"; if several triangles have the same name, as parts of a
// polygon, it is a diagonal.
std::string edge_with_faces(const Gluing& g, std::span<const Edge_side> sides,
                            const std::vector<std::uint32_t>& names);

// Refuses an edge with more than two faces.
[[noreturn]] void fail_nonmanifold(const Gluing& g, std::span<const Edge_side> sides,
                                   const std::vector<std::uint32_t>& names);

// Findings where triangles share edges.
struct Shared_edges {
  std::uint32_t conflict =
      Gluing::none; // a halfedge of the first edge along which two faces run in the same direction
  std::size_t conflicts = 0; // number of these edges
};

// Glues triangles that share edges, whether they agree in orientation or not. Calls
// `nonmanifold(e)` for each edge with more than two faces, which are not glued.
template <class Function>
Shared_edges glue_pairs(Gluing& g, const Sides_by_edge& edges, const Function& nonmanifold) {
  Shared_edges result;
  for (std::uint32_t e = 0; e < edges.number_of_edges(); ++e) {
    const std::span<const Edge_side> sides = edges[e];
    if (sides.size() > 2) nonmanifold(e);
    if (sides.size() != 2) continue;
    const std::uint32_t h = sides[0].halfedge, other = sides[1].halfedge;
    const bool is_conflict = sides[0].is_along == sides[1].is_along;
    if (is_conflict && result.conflicts++ == 0) result.conflict = h;
    g.glue[h] = is_conflict ? Gluing::reversed(other) : other;
    g.glue[other] = is_conflict ? Gluing::reversed(h) : h;
  }
  return result;
}

// Glues triangles that are not glued yet. `conflict` is set to that of `Shared_edges`; `names` are
// those of faces in messages.
Gluing glue_triangles(Gluing g, std::uint32_t& conflict, const std::vector<std::uint32_t>& names);

} // namespace internal

/*!
\brief glues triangles that share edges: two halfedges with the same end vertices become an edge.

\param number_of_vertices number of vertices, isolated ones included
\param triangles range of random access triples of vertex numbers, counterclockwise
\throws Invalid_input naming the faces if an edge has more than two, if two faces run along a shared
  edge in the same direction, or if a face repeats a vertex or has one out of range
\complexity linear for bounded degree, without hashing
*/
template <TriangleRange Triangles>
Gluing gluing_from_triangles(std::uint32_t number_of_vertices, const Triangles& triangles) {
  std::uint32_t conflict = Gluing::none;
  Gluing g = internal::glue_triangles(internal::unglued_triangles(number_of_vertices, triangles),
                                      conflict, {});
  if (conflict != Gluing::none) internal::fail_orientation(g, conflict, {});
  return g;
}

/*!
\brief glues triangles that share edges, and turns those around that disagree with their neighbours.
\param number_of_vertices, triangles see `gluing_from_triangles()`; the order of corners may be any
\param reversed_faces set to nonzero for each face that was turned around, see `Orientation_result`
\param names the name of each face in messages, as `Triangle_soup::polygon_of_triangle`; empty: by
  its number
\throws Invalid_input see above; of orientation, only if no choice of it is consistent
\complexity as above
*/
template <TriangleRange Triangles>
Gluing oriented_gluing_from_triangles(std::uint32_t number_of_vertices, const Triangles& triangles,
                                      std::vector<char>& reversed_faces,
                                      const std::vector<std::uint32_t>& names = {}) {
  std::uint32_t conflict = Gluing::none;
  Gluing g = internal::glue_triangles(internal::unglued_triangles(number_of_vertices, triangles),
                                      conflict, names);
  reversed_faces.assign(g.number_of_faces(), 0);
  if (conflict == Gluing::none) return g;
  Orientation_result r = orient_faces(g);
  if (!r.is_orientable) internal::fail_orientation(g, conflict, names);
  reversed_faces = std::move(r.reversed_faces);
  return g;
}

namespace internal {

// numbers the elements of a range 0, 1, 2, ... from numbers that may have gaps; a mesh without gaps
// needs no look-up
class Compaction {
public:
  void append(std::uint32_t number) {
    if (map_.empty() && number != count_) { // the first gap
      map_.resize(count_);
      std::iota(map_.begin(), map_.end(), 0U);
    }
    if (!map_.empty() || number != count_) {
      if (number >= map_.size()) map_.resize(number + 1, Gluing::none);
      map_[number] = count_;
    }
    ++count_;
  }
  std::uint32_t count() const { return count_; }
  std::uint32_t operator()(std::uint32_t number) const {
    return map_.empty() ? number : map_[number];
  }

private:
  std::vector<std::uint32_t> map_; // empty: the identity
  std::uint32_t count_ = 0;
};

} // namespace internal

/*!
\brief copies the connectivity of a mesh through BGL, or finds a face that is not a triangle.

See `gluing_map_from_face_graph()`.
\param mesh the mesh
\param polygon set to the number of the first face that is not a triangle, or `Gluing::none`; if
  there is one, do not use the result
*/
template <ReadableFaceGraph FaceGraph>
Gluing_map gluing_map_unless_polygonal(const FaceGraph& mesh, std::uint32_t& polygon) {
  using Traits = boost::graph_traits<FaceGraph>;
  using Halfedge = typename Traits::halfedge_descriptor;
  const Mesh_adaptor<FaceGraph> number(mesh);
  polygon = Gluing::none;
  internal::Compaction vertex, side, face_number;
  for (const typename Traits::vertex_descriptor v : vertices(mesh)) vertex.append(number.vertex(v));
  for (const typename Traits::face_descriptor f : faces(mesh)) face_number.append(number.face(f));
  for (const typename Traits::edge_descriptor e : edges(mesh)) {
    side.append(number.halfedge(halfedge(e, mesh)));
    side.append(number.halfedge(opposite(halfedge(e, mesh), mesh)));
  }
  // not num_vertices(mesh), ...: they count removed elements
  Gluing_map map(vertex.count(), side.count() / 2, face_number.count());
  std::vector<unsigned char> sides(face_number.count(), 0);
  const auto connect = [&](Halfedge h) {
    const Gluing_map::Halfedge s{side(number.halfedge(h))};
    map.set_next(s, {side(number.halfedge(next(h, mesh)))});
    const Gluing_map::Vertex v{vertex(number.vertex(target(h, mesh)))};
    map.set_target(s, v);
    const bool border = CGAL::is_border(h, mesh);
    if (!border) {
      const Gluing_map::Face f{face_number(number.face(face(h, mesh)))};
      map.set_face(s, f);
      if (sides[f.index] < 4) ++sides[f.index];
    }
    if (border || map.halfedge(v).index == Gluing::none) map.set_halfedge(v, s);
  };
  for (const typename Traits::edge_descriptor e : edges(mesh)) {
    connect(halfedge(e, mesh));
    connect(opposite(halfedge(e, mesh), mesh));
  }
  std::uint32_t f = 0;
  for (const typename Traits::face_descriptor d : faces(mesh)) {
    const Halfedge h = halfedge(d, mesh);
    if (sides[f] != 3 && polygon == Gluing::none) polygon = f;
    map.set_halfedge(Gluing_map::Face{f++}, {side(number.halfedge(h))});
  }
  // where several umbrellas meet at a vertex, meshes may go on in another one; `previous()` does
  // not
  for (std::uint32_t h = 0; h < map.number_of_halfedges() && polygon == Gluing::none; ++h)
    if (map.face({h}).index == Gluing::none) map.set_next({h}, map.next_on_border({h}));
  return map;
}

/*!
\brief copies the connectivity of a mesh through BGL.

Vertices, edges and faces are numbered in the order of iteration. It does not look edges up by their
end vertices, so that it reads any Delta-complex correctly. Border loops turn within one umbrella of
each vertex, whichever way they go in `mesh`.
\tparam FaceGraph a model of `FaceListGraph` and `HalfedgeListGraph`
\throws Invalid_input if a face is not a triangle
\complexity linear
*/
template <ReadableFaceGraph FaceGraph>
Gluing_map gluing_map_from_face_graph(const FaceGraph& mesh) {
  std::uint32_t polygon = Gluing::none;
  Gluing_map map = gluing_map_unless_polygonal(mesh, polygon);
  if (polygon != Gluing::none)
    throw Invalid_input::about(Element_kind::face, polygon,
                               " is not a triangle; triangulate the faces first");
  return map;
}

/*!
\brief builds a mesh of any type from a gluing map, with the same numbering.

Vertex `i`, edge `e` and face `f` of the result, in the order of iteration, are those of `map`, and
`halfedge(face, mesh)` and the directions of edges agree. Elements that have been removed from `map`
are left out, and those after them move up.
\tparam Mesh a model of `MutableFaceGraph` that is empty
\pre `map.is_oriented()`
\complexity linear
*/
template <WritableFaceGraph Mesh>
void copy_gluing_map(const Gluing_map& map, Mesh& mesh) {
  if (map.has_garbage()) return copy_gluing_map(gluing_map_from_face_graph(map), mesh);
  using Traits = boost::graph_traits<Mesh>;
  std::vector<typename Traits::vertex_descriptor> vertex;
  std::vector<typename Traits::halfedge_descriptor> side;
  std::vector<typename Traits::face_descriptor> face;
  for (std::uint32_t v = 0; v < map.number_of_vertices(); ++v)
    vertex.push_back(add_vertex(mesh)); // with the null halfedge, which OpenMesh does not accept
  for (std::uint32_t e = 0; e < map.number_of_edges(); ++e) {
    side.push_back(halfedge(add_edge(mesh), mesh));
    side.push_back(opposite(side.back(), mesh));
  }
  for (std::uint32_t f = 0; f < map.number_of_faces(); ++f) face.push_back(add_face(mesh));
  for (std::uint32_t h = 0; h < map.number_of_halfedges(); ++h) {
    const std::uint32_t f = map.face({h}).index;
    set_next(side[h], side[map.next({h}).index], mesh);
    set_target(side[h], vertex[map.target({h}).index], mesh);
    set_face(side[h], f == Gluing::none ? Traits::null_face() : face[f], mesh);
  }
  for (std::uint32_t f = 0; f < map.number_of_faces(); ++f)
    set_halfedge(face[f], side[map.halfedge(Gluing_map::Face{f}).index], mesh);
  for (std::uint32_t v = 0; v < map.number_of_vertices(); ++v) {
    const Gluing_map::Halfedge h = map.halfedge(Gluing_map::Vertex{v});
    if (h.index != Gluing::none) set_halfedge(vertex[v], side[h.index], mesh);
  }
}

/*!
\brief makes a mesh of a gluing map, with the same numbers.
\tparam Mesh a model of `MutableDeltaComplex`
\complexity linear; constant if `Mesh` is `Gluing_map`
*/
template <MutableDeltaComplex Mesh>
Mesh mesh_from_gluing_map(Gluing_map map) {
  if constexpr (std::is_same_v<Mesh, Gluing_map>)
    return map;
  else {
    Mesh mesh;
    copy_gluing_map(map, mesh);
    return mesh;
  }
}

/// \cond
extern template Gluing
internal::unglued_triangles(std::uint32_t, const std::vector<std::array<std::uint32_t, 3>>&);
extern template Gluing_map gluing_map_unless_polygonal(const Gluing_map&, std::uint32_t&);
/// \endcond

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_BUILD_GLUING_H
