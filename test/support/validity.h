// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_VALIDITY_H
#define INTRINSIC_TRIANGULATIONS_TEST_VALIDITY_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/topology.h>

#include "gallery.h"

#include <boost/graph/graph_traits.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace delta_complex {

// Checks a mesh without trust in its data: it follows a descriptor only after finding it among the
// elements of the mesh, and no walk is longer than three steps.
template <class Mesh>
class Delta_complex_checker {
  using Traits = boost::graph_traits<Mesh>;
  using Vertex = typename Traits::vertex_descriptor;
  using Halfedge = typename Traits::halfedge_descriptor;
  using Edge = typename Traits::edge_descriptor;
  using Face = typename Traits::face_descriptor;
  using Defect = std::optional<std::string>;
  static constexpr std::uint32_t none = Gluing::none;
  static constexpr bool is_gluing_map = std::is_same_v<Mesh, Gluing_map>;

public:
  explicit Delta_complex_checker(const Mesh& mesh) : mesh_(mesh), number_(mesh) {
    for (const Vertex v : vertices(mesh)) append(number_.vertex(v), vertex_known_);
    for (const Halfedge h : halfedges(mesh)) append(number_.halfedge(h), halfedge_known_);
    for (const Face f : faces(mesh)) append(number_.face(f), face_known_);
  }

  // the checks build on each other: each follows only links that earlier checks found correct
  Defect run() {
    if (Defect d = for_each(halfedges(mesh_), &Delta_complex_checker::links)) return d;
    if (Defect d = for_each(edges(mesh_), &Delta_complex_checker::pairing)) return d;
    if (Defect d = for_each(halfedges(mesh_), &Delta_complex_checker::triangle)) return d;
    if (Defect d = for_each(halfedges(mesh_), &Delta_complex_checker::ends)) return d;
    previous_.assign(halfedge_known_.size(), 0);
    sides_.assign(face_known_.size(), 0);
    degree_.assign(vertex_known_.size(), 0);
    border_.assign(vertex_known_.size(), 0);
    if (Defect d = for_each(halfedges(mesh_), &Delta_complex_checker::succession)) return d;
    if (Defect d = for_each(faces(mesh_), &Delta_complex_checker::face_halfedge)) return d;
    return for_each(vertices(mesh_), &Delta_complex_checker::vertex_halfedge);
  }

private:
  static void append(std::uint32_t number, std::vector<char>& known) {
    if (number >= known.size()) known.resize(std::size_t{number} + 1, 0);
    known[number] = 1;
  }

  template <class Range, class Descriptor>
  Defect for_each(const Range& range, Defect (Delta_complex_checker::*check)(Descriptor)) {
    for (const Descriptor d : range)
      if (Defect defect = (this->*check)(d)) return defect;
    return {};
  }

  // the number of an element, or `none` for a descriptor of something that is not in the mesh
  template <class Descriptor, class Number>
  static std::uint32_t find(Descriptor d, const std::vector<char>& known, Number number) {
    if (d == Descriptor()) return none;
    try { // numbers kept in hash maps throw for what they do not hold
      const std::uint32_t i = number(d);
      return i < known.size() && known[i] != 0 ? i : none;
    } catch (const std::out_of_range&) {
      return none;
    }
  }
  std::uint32_t vertex(Vertex v) const {
    return find(v, vertex_known_, [this](Vertex d) { return number_.vertex(d); });
  }
  std::uint32_t halfedge_number(Halfedge h) const {
    return find(h, halfedge_known_, [this](Halfedge d) { return number_.halfedge(d); });
  }
  std::uint32_t face_number(Face f) const {
    return find(f, face_known_, [this](Face d) { return number_.face(d); });
  }

  std::string name(Halfedge h) const {
    return "halfedge " + std::to_string(number_.halfedge(h)) + " of edge " +
           std::to_string(number_.halfedge(h) / 2);
  }
  bool is_border(Halfedge h) const { return face(h, mesh_) == Traits::null_face(); }
  bool is_reversed([[maybe_unused]] Halfedge h) const {
    if constexpr (is_gluing_map)
      return mesh_.is_reversed(edge(h, mesh_));
    else
      return false;
  }
  bool is_oriented() const {
    if constexpr (is_gluing_map)
      return mesh_.is_oriented();
    else
      return true;
  }
  // where a side of a face starts
  Vertex start(Halfedge h) const { return target(next(next(h, mesh_), mesh_), mesh_); }

  // all that a halfedge refers to exists
  Defect links(Halfedge h) {
    if (halfedge_number(opposite(h, mesh_)) == none)
      return name(h) + " has an opposite that does not exist";
    if (vertex(target(h, mesh_)) == none)
      return name(h) + " points to a vertex that does not exist";
    if (!is_border(h) && face_number(face(h, mesh_)) == none)
      return name(h) + " lies in a face that does not exist";
    if (!is_oriented() && is_border(h)) return {}; // border loops have no direction
    if (halfedge_number(next(h, mesh_)) == none)
      return name(h) + " is followed by a halfedge that does not exist";
    return {};
  }

  // the two sides of an edge
  Defect pairing(Edge e) {
    const Halfedge h = halfedge(e, mesh_);
    if (halfedge_number(h) == none) return "an edge has a halfedge that does not exist";
    const Halfedge o = opposite(h, mesh_);
    if (o == h) return name(h) + " is opposite to itself";
    if (opposite(o, mesh_) != h)
      return name(h) + " is not the opposite of its opposite, halfedge " +
             std::to_string(number_.halfedge(o));
    if (edge(h, mesh_) != e || edge(o, mesh_) != e)
      return name(h) + " or its opposite belongs to another edge";
    if (is_border(h) && is_border(o))
      return "edge " + std::to_string(number_.halfedge(h) / 2) + " has no face";
    return {};
  }

  Defect triangle(Halfedge h) {
    if (opposite(opposite(h, mesh_), mesh_) != h) return name(h) + " belongs to no edge";
    if (is_border(h)) return {};
    const Halfedge n = next(h, mesh_);
    if (face(n, mesh_) != face(h, mesh_))
      return name(h) + " is followed by a halfedge of another face";
    if (next(next(n, mesh_), mesh_) != h)
      return name(h) + " does not lie in a triangle: the third halfedge after it is another";
    return {};
  }

  // glued sides have the same ends
  Defect ends(Halfedge h) {
    if (is_border(h)) return {};
    const Halfedge o = opposite(h, mesh_);
    const Vertex s = start(h), t = target(h, mesh_);
    const Vertex other_target = target(o, mesh_);
    if (other_target != (is_reversed(h) ? t : s))
      return name(h) + " and its opposite have different end vertices";
    if (!is_border(o) && start(o) != (is_reversed(h) ? s : t))
      return name(h) + " and its opposite have different end vertices";
    return {};
  }

  // every halfedge follows one other, across a vertex; counts for the checks of faces and vertices
  Defect succession(Halfedge h) {
    ++degree_[vertex(target(h, mesh_))];
    if (!is_border(h)) {
      ++sides_[face_number(face(h, mesh_))];
      return {};
    }
    border_[vertex(target(h, mesh_))] = 1;
    if (!is_oriented()) return {};
    const Halfedge n = next(h, mesh_);
    if (!is_border(n)) return name(h) + " is on the border and followed by one that is not";
    if (target(opposite(n, mesh_), mesh_) != target(h, mesh_))
      return name(h) + " is on the border and followed by one that starts from another vertex";
    char& preceded = previous_[number_.halfedge(n)];
    if (preceded != 0) return name(n) + " follows two halfedges of the border";
    preceded = 1;
    return stored_previous(h, n);
  }

  // the stored link back of meshes that have one, and the result of turning in a gluing map
  Defect stored_previous([[maybe_unused]] Halfedge h, [[maybe_unused]] Halfedge n) const {
    if constexpr (!is_gluing_map)
      if (prev(n, mesh_) != h) return name(n) + " follows another halfedge than it refers back to";
    return {};
  }

  Defect face_halfedge(Face f) {
    const std::string face_name = "face " + std::to_string(number_.face(f));
    const Halfedge h = halfedge(f, mesh_);
    if (halfedge_number(h) == none) return face_name + " has a halfedge that does not exist";
    if (face(h, mesh_) != f) return face_name + " has a halfedge that lies in another face";
    if (sides_[number_.face(f)] != 3)
      return face_name + " has " + std::to_string(sides_[number_.face(f)]) + " sides";
    return {};
  }

  Defect vertex_halfedge(Vertex v) {
    const std::string vertex_name = "vertex " + std::to_string(number_.vertex(v));
    const Halfedge h = halfedge(v, mesh_);
    if (h == Traits::null_halfedge()) {
      if (degree_[number_.vertex(v)] == 0) return {};
      return vertex_name + " has no halfedge though halfedges point to it";
    }
    if (halfedge_number(h) == none) return vertex_name + " has a halfedge that does not exist";
    if (target(h, mesh_) != v) return vertex_name + " has a halfedge that points to another vertex";
    if (is_gluing_map && border_[number_.vertex(v)] != 0 && !is_border(h))
      return vertex_name + " is on the border but its halfedge is not";
    return {};
  }

  const Mesh& mesh_;
  const Mesh_adaptor<Mesh> number_;
  std::vector<char> vertex_known_, halfedge_known_, face_known_; // by number, 1 if in the mesh
  std::vector<char> previous_;        // of a halfedge: 1 if it follows one
  std::vector<char> border_;          // of a vertex: 1 if a border halfedge points to it
  std::vector<std::uint32_t> sides_;  // of a face
  std::vector<std::uint32_t> degree_; // of a vertex: halfedges that point to it
};

} // namespace delta_complex

/*!
\brief finds out why a mesh is not a triangulated surface in the sense of a Delta-complex (§2.1 of
the course).

A valid mesh has the invariants of \ref ::MutableDeltaComplex, refers to nothing that is not in it, and in a
`Gluing_map` that is not oriented border halfedges are not linked.

Loops, faces glued to themselves, parallel edges, nonmanifold and isolated vertices are all valid.
Corrupted data of any kind gives an answer; nothing is followed before it is checked.
\tparam Mesh a model of `MutableDeltaComplex`
\param mesh the mesh
\return a sentence that names the first element at fault in the mesh's own numbering, or nothing if
  the mesh is valid
\complexity linear
*/
template <class Mesh>
std::optional<std::string> delta_complex_defect(const Mesh& mesh) {
  return delta_complex::Delta_complex_checker<Mesh>(mesh).run();
}

/*!
\brief tells whether a mesh is a valid Delta-complex: see `delta_complex_defect()`.
\tparam Mesh a model of `MutableDeltaComplex`
\param mesh the mesh
\complexity linear
*/
template <class Mesh>
bool is_valid_delta_complex(const Mesh& mesh) {
  return !delta_complex_defect(mesh);
}

} // namespace CGAL::Intrinsic_triangulations

namespace gallery {

/// Expects the topology of a surface, in whichever triangulation.
template <class Mesh>
void expect_topology(const Mesh& mesh, const Surface& s) {
  namespace IT = CGAL::Intrinsic_triangulations;
  EXPECT_EQ(IT::euler_characteristic(mesh), s.euler_characteristic());
  EXPECT_EQ(IT::boundary_loops(mesh).size(), s.expected.boundary_loops);
  EXPECT_EQ(IT::connected_components(mesh).count, s.expected.components);
  EXPECT_EQ(IT::genus(mesh).has_value(), s.expected.is_orientable);
  EXPECT_EQ(IT::genus(mesh).value_or(0), s.expected.genus);
  const std::vector<std::uint32_t> u = IT::umbrellas(mesh);
  EXPECT_EQ(std::count(u.begin(), u.end(), 0U), s.expected.isolated_vertices);
  EXPECT_EQ(std::count_if(u.begin(), u.end(), [](std::uint32_t n) { return n > 1; }),
            s.expected.nonmanifold_vertices);
}

} // namespace gallery

#endif // INTRINSIC_TRIANGULATIONS_TEST_VALIDITY_H
