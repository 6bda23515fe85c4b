// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_AS_GLUING_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_AS_GLUING_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>

#include <boost/graph/graph_traits.hpp>

#include <cstdint>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief writes a gluing map as a list of gluings: the inverse of `Gluing_map(const Gluing&)`.

Side 0 of face `f` is `map.halfedge(f)`; where elements have been removed, the others are numbered
in the order of iteration. Building a gluing map from the result gives the same faces and vertices;
edges are numbered anew, in the order in which the faces meet them.
\param map the gluing map, oriented or not
\pre the map has the invariants of `MutableDeltaComplex`
\complexity linear
*/
inline Gluing gluing_from_map(const Gluing_map& map) {
  if (map.has_garbage()) return gluing_from_map(gluing_map_from_face_graph(map));
  Gluing g;
  g.number_of_vertices = map.number_of_vertices();
  std::vector<std::uint32_t> corner(map.number_of_halfedges(), Gluing::none);
  for (std::uint32_t f = 0; f < map.number_of_faces(); ++f) {
    for (const Gluing_map::Halfedge h : map.sides({f})) {
      corner[h.index] = static_cast<std::uint32_t>(g.origin.size());
      g.origin.push_back(map.source(h).index);
    }
  }
  g.glue.assign(g.origin.size(), Gluing::none);
  for (std::uint32_t h = 0; h < map.number_of_halfedges(); ++h) {
    const std::uint32_t o = Gluing_map::opposite({h}).index;
    if (corner[h] == Gluing::none || corner[o] == Gluing::none) continue;
    g.glue[corner[h]] = map.is_reversed({h / 2}) ? Gluing::reversed(corner[o]) : corner[o];
  }
  return g;
}

namespace internal {

// The connectivity of any mesh as a gluing map with vertices, edges and faces in the order of
// iteration: a reference to a map; a copy of any other mesh, and of a map with removed elements.
template <class Mesh>
class As_gluing_map {
public:
  explicit As_gluing_map(const Mesh& mesh) {
    if constexpr (std::is_same_v<Mesh, Gluing_map>)
      if (!mesh.has_garbage()) {
        map_ = &mesh;
        return;
      }
    copy_ = gluing_map_from_face_graph(mesh);
  }
  As_gluing_map(const As_gluing_map&) = delete;
  As_gluing_map& operator=(const As_gluing_map&) = delete;

  const Gluing_map& operator*() const { return *map_; }

private:
  Gluing_map copy_;
  const Gluing_map* map_ = &copy_;
};

// The connectivity of any mesh as a gluing map with given numbers, which are those from 0 to the
// capacities: a `Mesh_adaptor` of a mesh without removed elements, or the like.
template <class Mesh, class Numbers>
Gluing_map numbered_copy(const Mesh& mesh, const Numbers& number) {
  using Traits = boost::graph_traits<Mesh>;
  Gluing_map copy(number.vertex_capacity(mesh), number.edge_capacity(mesh),
                  number.face_capacity(mesh));
  for (const typename Traits::halfedge_descriptor h : halfedges(mesh)) {
    const Gluing_map::Halfedge c{number.halfedge(h)};
    copy.set_next(c, {number.halfedge(next(h, mesh))});
    copy.set_target(c, {number.vertex(target(h, mesh))});
    const typename Traits::face_descriptor f = face(h, mesh);
    if (f != Traits::null_face()) copy.set_face(c, {number.face(f)});
  }
  for (const typename Traits::vertex_descriptor v : vertices(mesh))
    if (halfedge(v, mesh) != Traits::null_halfedge())
      copy.set_halfedge(Gluing_map::Vertex{number.vertex(v)}, {number.halfedge(halfedge(v, mesh))});
  for (const typename Traits::face_descriptor f : faces(mesh))
    copy.set_halfedge(Gluing_map::Face{number.face(f)}, {number.halfedge(halfedge(f, mesh))});
  return copy;
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_AS_GLUING_H
