// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_GLUING_MAP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_GLUING_MAP_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <array>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief names an element of a `Gluing_map`; `Tag` keeps vertices, halfedges, edges and faces apart.
\tparam Tag any type
*/
template <class Tag>
struct Gluing_descriptor {
  /// Number of the element, or `Gluing::none`.
  std::uint32_t index = Gluing::none;

  /// orders descriptors by number.
  friend auto operator<=>(const Gluing_descriptor&, const Gluing_descriptor&) = default;
  /// hashes the descriptor for Boost's and CGAL's hash maps.
  friend std::size_t hash_value(const Gluing_descriptor& d) { return d.index; }
};

/*!
\brief stores a triangulated surface as glued triangles: a compact model of `MutableDeltaComplex`.

It is the gluing map of the course (§2.2), built from a `Gluing` (three halfedges per face, arrays
of gluings and origins) and mutable. Halfedges `2e` and `2e + 1` are the sides of edge `e`; a side
without a face is a border halfedge. A flip keeps the number of every element, so that data indexed
by them stays valid. Loops, faces glued to themselves, several edges between the same vertices,
nonmanifold vertices and nonorientable gluings are all representable. The functions of BGL's
`MutableFaceGraph` are in `graph_traits_Gluing_map.h`.

Memory: 24 bytes per edge and 4 per vertex and face.

\cgalModels{MutableDeltaComplex}
*/
class Gluing_map {
public:
  /// Names a vertex.
  using Vertex = Gluing_descriptor<struct Vertex_tag>;
  /// Names a halfedge.
  using Halfedge = Gluing_descriptor<struct Halfedge_tag>;
  /// Names an edge.
  using Edge = Gluing_descriptor<struct Edge_tag>;
  /// Names a face.
  using Face = Gluing_descriptor<struct Face_tag>;

  /// constructs the empty complex.
  Gluing_map();
  /// copies.
  Gluing_map(const Gluing_map& other);
  /// moves.
  Gluing_map(Gluing_map&& other) noexcept;
  /// copies.
  Gluing_map& operator=(const Gluing_map& other);
  /// moves.
  Gluing_map& operator=(Gluing_map&& other) noexcept;
  /// destructs.
  ~Gluing_map();

  /*!
  \brief glues triangles together.

  Edges are numbered in the order in which the faces meet them.
  \throws Invalid_input if the arrays do not describe a gluing (see `validate()`)
  \complexity linear
  */
  explicit Gluing_map(const Gluing& gluing);
  /// builds the connectivity of a valid gluing, such as those of `gluing_from_triangles()`.
  /// \pre `validate(gluing)` does not throw \complexity linear
  static Gluing_map from_valid(const Gluing& gluing);

  /// constructs elements that are not connected yet; the setters connect them.
  Gluing_map(std::uint32_t vertices, std::uint32_t edges, std::uint32_t faces);

  /// returns the number of vertices, removed ones included: a bound of their indices.
  std::uint32_t number_of_vertices() const { return static_cast<std::uint32_t>(vertex_.size()); }
  /// returns the number of halfedges, border halfedges and removed ones included.
  std::uint32_t number_of_halfedges() const { return static_cast<std::uint32_t>(halfedge_.size()); }
  /// returns the number of edges, removed ones included.
  std::uint32_t number_of_edges() const { return number_of_halfedges() / 2; }
  /// returns the number of faces, removed ones included.
  std::uint32_t number_of_faces() const { return static_cast<std::uint32_t>(face_.size()); }

  /// tells whether removed elements have left free numbers.
  bool has_garbage() const {
    return !free_vertices_.empty() || !free_edges_.empty() || !free_faces_.empty();
  }
  /// tells whether a vertex has been removed.
  bool is_removed(Vertex v) const { return vertex_[v.index] == removed; }
  /// tells whether the edge of a halfedge has been removed.
  bool is_removed(Halfedge h) const { return halfedge_[h.index].next == removed; }
  /// tells whether an edge has been removed.
  bool is_removed(Edge e) const { return is_removed(Halfedge{2 * e.index}); }
  /// tells whether a face has been removed.
  bool is_removed(Face f) const { return face_[f.index] == removed; }

  /// returns the halfedge that follows `h` in its face or border loop.
  Halfedge next(Halfedge h) const { return {halfedge_[h.index].next}; }
  /// returns the vertex that `h` points to.
  Vertex target(Halfedge h) const { return {halfedge_[h.index].target}; }
  /// returns the face of `h`, or the null face on the border.
  Face face(Halfedge h) const { return {halfedge_[h.index].face}; }
  /// returns the other side of the edge of `h`.
  static Halfedge opposite(Halfedge h) { return {h.index ^ 1U}; }
  /// returns a halfedge that points to `v`, a border one if there is one; null if `v` is isolated.
  Halfedge halfedge(Vertex v) const { return {vertex_[v.index]}; }
  /// returns a halfedge of `f`.
  Halfedge halfedge(Face f) const { return {face_[f.index]}; }

  /// returns the sides of `f`, the first of which is `halfedge(f)`.
  std::array<Halfedge, 3> sides(Face f) const {
    const Halfedge h = halfedge(f), n = next(h);
    return {h, n, next(n)};
  }

  /// returns the border halfedge after `h` around its target, within one umbrella. \pre
  /// `is_oriented()`
  Halfedge next_on_border(Halfedge h) const {
    Halfedge n = opposite(h);
    while (face(n).index != Gluing::none) n = opposite(next(next(n)));
    return n;
  }

  /// returns the halfedge before `h`; constant time in a face, linear in the degree on the border.
  Halfedge previous(Halfedge h) const {
    if (face(h).index != Gluing::none) return next(next(h));
    Halfedge p = opposite(h);
    while (face(p).index != Gluing::none) p = opposite(next(p));
    return p;
  }

  /// returns the vertex that `h` starts from.
  Vertex source(Halfedge h) const {
    return reversed_.empty() || face(h).index == Gluing::none ? target(opposite(h))
                                                              : target(next(next(h)));
  }

  /// tells whether both sides of `e` run the same way, so that its faces have opposite
  /// orientations. False if `is_oriented()`.
  bool is_reversed(Edge e) const { return !reversed_.empty() && reversed_[e.index] != 0; }

  /// tells whether all gluings respect the orientation of the faces. Algorithms on BGL halfedges
  /// require this.
  bool is_oriented() const { return reversed_.empty(); }

  /// sets the halfedge that follows `h`.
  void set_next(Halfedge h, Halfedge n) { halfedge_[h.index].next = n.index; }
  /// sets the vertex that `h` points to.
  void set_target(Halfedge h, Vertex v) { halfedge_[h.index].target = v.index; }
  /// sets the face of `h`.
  void set_face(Halfedge h, Face f) { halfedge_[h.index].face = f.index; }
  /// sets the halfedge of `v`.
  void set_halfedge(Vertex v, Halfedge h) { vertex_[v.index] = h.index; }
  /// sets the halfedge of `f`.
  void set_halfedge(Face f, Halfedge h) { face_[f.index] = h.index; }

  /// makes room so that adding or removing one vertex, three edges and two faces, as an insertion
  /// or a removal does, allocates no memory. \complexity constant, amortized
  void make_room();
  /// adds an isolated vertex, with the number of a removed one if there is one.
  Vertex add_vertex() { return {add(vertex_, free_vertices_)}; }
  /// adds an unconnected edge.
  Edge add_edge();
  /// adds an unconnected face.
  Face add_face() { return {add(face_, free_faces_)}; }

  /// removes a vertex. \pre no element refers to it
  void remove_vertex(Vertex v) {
    vertex_[v.index] = removed;
    free_vertices_.push_back(v.index);
  }
  /// removes an edge. \pre no element refers to it
  void remove_edge(Edge e) {
    halfedge_[2 * e.index].next = halfedge_[2 * e.index + 1].next = removed;
    free_edges_.push_back(e.index);
  }
  /// removes a face. \pre no element refers to it
  void remove_face(Face f) {
    face_[f.index] = removed;
    free_faces_.push_back(f.index);
  }

private:
  // the reference of removed elements
  static constexpr std::uint32_t removed = Gluing::none - 1;

  static std::uint32_t add(std::vector<std::uint32_t>& elements, std::vector<std::uint32_t>& free);

  struct Halfedge_record {
    std::uint32_t next = Gluing::none;
    std::uint32_t target = Gluing::none;
    std::uint32_t face = Gluing::none;
  };

  void number_edges(const Gluing& g);

  // A border halfedge runs against its inner side; the next one is found by turning about its
  // target. In a gluing that is not oriented, the turn may meet a reversed edge: border loops have
  // no direction there, and next() of a border halfedge stays null.
  void link_border();

  std::vector<Halfedge_record> halfedge_;
  std::vector<std::uint32_t> vertex_;
  std::vector<std::uint32_t> face_;
  std::vector<char> reversed_; // per edge; empty in an oriented complex
  std::vector<std::uint32_t> free_vertices_, free_edges_, free_faces_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_GLUING_MAP_H
