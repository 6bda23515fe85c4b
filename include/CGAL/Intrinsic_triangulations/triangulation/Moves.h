// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_MOVES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_MOVES_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstdint>
#include <optional>

/*!
\file
The records of elementary moves: the elements around, by number. The owner of a triangulation makes
one for each move; metric and correspondence read from it instead of the mesh.

Moves keep the numbers of remaining halfedges, so that a record describes both states, before and
after.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief records the flip of edge ij, from which it runs between k and m: all halfedges keep their
numbers.

Before it, the left face f has the sides ij, jk, ki and the right face g has ji, im, mj. After it,
the face of km has the sides km, mj, jk, and that of mk has mk, ki, im. A flip makes km of ij; one
that is taken back makes it of ji, since two flips would swap the halfedges. The face of ij is f
before and after.
*/
struct Flip {
  std::uint32_t ij; ///< the halfedge that is flipped; the other side of its edge is `ij ^ 1`
  std::uint32_t jk; ///< the halfedge from j to k
  std::uint32_t ki; ///< the halfedge from k to i
  std::uint32_t im; ///< the halfedge from i to m
  std::uint32_t mj; ///< the halfedge from m to j
  std::uint32_t km; ///< the halfedge that runs from k to m afterwards: ij or its opposite
  Diamond diamond;  ///< the edges and faces, from which the metric reads

  /// tells whether this takes the last flip of the edge back.
  bool is_taken_back() const { return km != ij; }
};

/*!
\brief records a vertex p of degree three inside a face ijk.
*/
struct Star_of_vertex {
  std::array<std::uint32_t, 3> sides;  ///< the halfedges ij, jk, ki
  std::array<std::uint32_t, 3> spokes; ///< the halfedges ip, jp, kp
  std::array<std::uint32_t, 3> faces;  ///< the faces ijp, jkp, kip; the first one is ijk without p
  std::uint32_t vertex;                ///< p

  /// returns the edges and faces, from which the metric reads.
  Vertex_star edges_and_faces() const {
    return {{sides[0] / 2, sides[1] / 2, sides[2] / 2},
            {spokes[0] / 2, spokes[1] / 2, spokes[2] / 2},
            faces};
  }
};

/// is the direction of a corner of an intrinsic face from a place on the input under the face.
struct Seen_corner {
  unsigned corner = 0; ///< of the face: 0, 1 or 2
  double angle = 0;    ///< direction to it, in the frame of the halfedge of the place
};

/*!
\brief records the insertion of a vertex in a face.

Before the move, only the sides and the weights are set; new elements are `Gluing::none`.
*/
struct Insertion_in_face : Star_of_vertex {
  /// Barycentric coordinates of p at i, j, k, see `representable_weights()`; the last one is zero
  /// if p is on the edge ij, which is flipped away next.
  std::array<double, 3> weights;
  /// The place on the input that defines p, if the correspondence need not find it.
  std::optional<Surface_point> place{};
  /// The direction of a corner from there, if known.
  std::optional<Seen_corner> seen{};
};

/*!
\brief records the removal of a vertex of degree three.
*/
struct Removal_from_face : Star_of_vertex {};

/*!
\brief records a vertex that moves to a place in one of the faces around it from which all corners
of its star are visible: edges and faces stay, lengths and areas change.

Only metrics that can do it, as `Euclidean_metric`, and correspondences that take the record make
this move; elsewhere a vertex is inserted and the old one removed.
*/
struct Move_in_star {
  std::uint32_t spoke; ///< a halfedge from the vertex, at the face of the place
  /// barycentric coordinates of the place, from the source of `spoke`
  std::array<double, 3> weights;
  std::uint32_t vertex; ///< the vertex
};

/*!
\brief records a vertex p on the border edge ij of a face ijk.
*/
struct Star_on_border {
  std::uint32_t ip;     ///< the halfedge from i to p, which is ij without p
  std::uint32_t pk;     ///< the halfedge from p to k
  std::uint32_t pj;     ///< the halfedge from p to j
  std::uint32_t jk;     ///< the halfedge from j to k
  std::uint32_t ki;     ///< the halfedge from k to i
  std::uint32_t f;      ///< the face ipk, which is ijk without p
  std::uint32_t g;      ///< the face pjk
  std::uint32_t vertex; ///< p

  /// returns the edges and faces, from which the metric reads.
  Border_star edges_and_faces() const { return {ip / 2, pj / 2, jk / 2, ki / 2, pk / 2, f, g}; }
};

/*!
\brief records the insertion of a vertex on a border edge.

Before the move, only `ip`, `jk`, `ki`, `f` and the parameter are set; new elements are
`Gluing::none`.
*/
struct Insertion_on_border : Star_on_border {
  /// Weight of j; that of i is one minus it.
  double parameter;
  /// See `Insertion_in_face`.
  std::optional<Surface_point> place{};
};

/*!
\brief records the removal of a vertex from the border.
*/
struct Removal_from_border : Star_on_border {};

namespace internal {

// The star of the source of a halfedge, which is its first spoke; none on the border, or if an edge
// joins the vertex to itself.
template <class Mesh>
std::optional<Whole_star> whole_star(typename boost::graph_traits<Mesh>::halfedge_descriptor first,
                                     const Mesh& mesh, const Mesh_adaptor<Mesh>& number) {
  using Halfedge = typename boost::graph_traits<Mesh>::halfedge_descriptor;
  Whole_star s;
  Halfedge h = first;
  do {
    if (face(h, mesh) == boost::graph_traits<Mesh>::null_face() ||
        target(h, mesh) == source(h, mesh))
      return std::nullopt;
    s.spokes.push_back(number.halfedge(h) / 2);
    s.rim.push_back(number.halfedge(next(h, mesh)) / 2);
    s.faces.push_back(number.face(face(h, mesh)));
    h = opposite(next(next(h, mesh), mesh), mesh);
  } while (h != first);
  return s;
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_MOVES_H
