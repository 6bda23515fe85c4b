// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_COMMON_SUBDIVISION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_COMMON_SUBDIVISION_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/points_of.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/position_on_face.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// Kinds of vertices of the common subdivision.
enum class Subdivision_vertex_kind : std::uint8_t {
  input,    ///< a vertex of the input, and of the intrinsic triangulation
  inserted, ///< a vertex that was inserted into the intrinsic triangulation
  crossing  ///< the crossing of an input edge and an intrinsic edge
};

/*!
\brief is an affine combination of up to three vertices of one face of a triangulation.

The first `size` entries are in use; their weights sum to 1.
*/
struct Weighted_vertices {
  std::size_t size = 0;                  ///< number of vertices
  std::array<std::uint32_t, 3> vertices; ///< their numbers
  std::array<double, 3> weights;         ///< their weights
};

/*!
\brief holds the common subdivision of the input and an intrinsic triangulation (§3.6 of the
course): the coarsest polygon mesh in which every edge of both is a path.

Vertices are numbered from 0: first the vertices of the intrinsic triangulation, then the crossings,
those on one intrinsic edge together. Faces are convex polygons on the faces of both triangulations,
counterclockwise, those in one intrinsic face together. Vertices and faces of the input have the
user's numbers (see `Input_names`), intrinsic vertices their rows
(`Intrinsic_triangulation::input_vertex()`); intrinsic edges and faces, and input edges, have the
numbers in the intrinsic triangulation and its input.
*/
struct Common_subdivision {
  /// The number of no element.
  static constexpr std::uint32_t none = Gluing::none;

  /// A point on an edge: `(1 - parameter) * vertices[0] + parameter * vertices[1]`.
  struct Edge_point {
    std::uint32_t edge = none;             ///< number of the edge
    std::array<std::uint32_t, 2> vertices; ///< its ends
    double parameter = 0;                  ///< weight of the second end
  };

  /// A vertex of the intrinsic triangulation.
  struct Vertex {
    std::uint32_t intrinsic = none;                                ///< its row there
    Subdivision_vertex_kind kind = Subdivision_vertex_kind::input; ///< input or inserted
    std::uint32_t input_face = none; ///< a face of the input that contains it
    Weighted_vertices on_input;      ///< its location on the input
    /// For an inserted vertex, the halfedge of `input_face` from which `on_input` is given.
    std::uint32_t input_halfedge = none;
  };

  /// The crossing of an edge of the input with an edge of the intrinsic triangulation.
  struct Crossing {
    Edge_point on_input;     ///< location on the input
    Edge_point on_intrinsic; ///< location on the intrinsic triangulation
  };

  /// The edges that a side of a face lies on; `none` for one that it does not lie on.
  struct Side {
    std::uint32_t input_edge = none;     ///< edge of the input
    std::uint32_t intrinsic_edge = none; ///< edge of the intrinsic triangulation
  };

  /// Number of vertices of the input: columns of the matrix that interpolates from it.
  std::uint32_t number_of_input_vertices = 0;
  /// Number of vertices of the intrinsic triangulation: columns of the matrix that interpolates
  /// from them.
  std::uint32_t number_of_intrinsic_vertices = 0;
  /// Vertices of the intrinsic triangulation: vertices 0, 1, ... of the subdivision.
  std::vector<Vertex> vertices;
  /// Crossings: the vertices of the subdivision after those.
  std::vector<Crossing> crossings;
  /// For each face the index of its first corner, and one entry more.
  std::vector<std::uint32_t> face_begin{0};
  /// The vertex at each corner.
  std::vector<std::uint32_t> corner;
  /// What lies along the side from each corner to the next one of its face.
  std::vector<Side> side;
  /// The halfedge of the intrinsic face that each corner lies on, at its source or inside.
  std::vector<std::uint32_t> intrinsic_halfedge;
  /// The halfedge of the input face that each corner lies on, at its source or inside; if it is
  /// inside of the face, the one from which its location is given.
  std::vector<std::uint32_t> input_halfedge;
  /// The face of the input that contains each face.
  std::vector<std::uint32_t> input_face;
  /// The intrinsic face that contains each face.
  std::vector<std::uint32_t> intrinsic_face;
  /// On a cover (see `make_domain()`), the side of the user's face that each face lies on: 0 front,
  /// 1 back. Else empty.
  std::vector<std::uint8_t> sheet;
  /// Number of sides of faces that are on the border.
  std::size_t number_of_border_edges = 0;

  /// returns the number of vertices.
  std::size_t number_of_vertices() const { return vertices.size() + crossings.size(); }
  /// returns the number of edges.
  std::size_t number_of_edges() const { return (corner.size() + number_of_border_edges) / 2; }
  /// returns the number of faces.
  std::size_t number_of_faces() const { return face_begin.size() - 1; }
  /// returns the vertices of face `f`, counterclockwise.
  std::span<const std::uint32_t> face(std::size_t f) const {
    return {corner.data() + face_begin[f], face_begin[f + 1] - face_begin[f]};
  }
  /// returns what lies along the sides of face `f`; side `k` runs from its vertex `k` to the next.
  std::span<const Side> sides(std::size_t f) const {
    return {side.data() + face_begin[f], face_begin[f + 1] - face_begin[f]};
  }
  /// returns what vertex `v` is.
  Subdivision_vertex_kind kind(std::size_t v) const {
    return v < vertices.size() ? vertices[v].kind : Subdivision_vertex_kind::crossing;
  }
  /// returns where vertex `v` is on the input.
  Weighted_vertices on_input(std::size_t v) const {
    return v < vertices.size() ? vertices[v].on_input
                               : weighted(crossings[v - vertices.size()].on_input);
  }
  /// returns where vertex `v` is on the intrinsic triangulation.
  Weighted_vertices on_intrinsic(std::size_t v) const {
    if (v < vertices.size()) return {1, {vertices[v].intrinsic, none, none}, {1, 0, 0}};
    return weighted(crossings[v - vertices.size()].on_intrinsic);
  }

private:
  static Weighted_vertices weighted(const Edge_point& p) {
    return {2, {p.vertices[0], p.vertices[1], none}, {1 - p.parameter, p.parameter, 0}};
  }
};

namespace internal {

/// returns barycentric coordinates of corner `c` of a subdivision in the intrinsic face of `base`.
template <class View>
std::array<double, 3> corner_in_face(const View& view, const Common_subdivision& s,
                                     std::uint32_t base, std::size_t c) {
  const std::uint32_t h = s.intrinsic_halfedge[c];
  double along = 0;
  if (s.corner[c] >= s.vertices.size()) {
    const double p = s.crossings[s.corner[c] - s.vertices.size()].on_intrinsic.parameter;
    along = h % 2 == 0 ? p : 1 - p;
  }
  const std::size_t k = h == base ? 0 : h == view.next(base) ? 1 : 2;
  std::array<double, 3> weights{0, 0, 0};
  weights[k] = 1 - along;
  weights[(k + 1) % 3] = along;
  return weights;
}

/// returns barycentric coordinates of corner `c` of a subdivision in the input face of `base`.
std::array<double, 3> corner_in_input_face(const Input& input, const Common_subdivision& s,
                                           std::uint32_t base, std::size_t c);

/// returns the rotation that fits places of corners `begin` to `end` in one frame to those in
/// another best: the direction of sum conj(p) q, both from their means. `places(c)` returns an
/// array of p and q.
template <class Places>
std::complex<double> fitting_rotation(std::size_t begin, std::size_t end, const Places& places) {
  std::array<std::complex<double>, 2> mean{};
  std::complex<double> sum = 0;
  for (const bool is_last : {false, true})
    for (std::size_t c = begin; c < end; ++c) {
      const auto [p, q] = places(c);
      if (is_last)
        sum += std::conj(p - mean[0]) * (q - mean[1]);
      else {
        mean[0] += p / static_cast<double>(end - begin);
        mean[1] += q / static_cast<double>(end - begin);
      }
    }
  return std::abs(sum) > 0 ? sum / std::abs(sum) : 1;
}

} // namespace internal

/*!
\brief returns the vertices of a point of the input, by the user's numbers.

With `position()` it gives the position in space of points from functions such as
`locate_on_input()` and `trace_geodesic()`.
\param t the triangulation
\param p a point of the input, not of the intrinsic triangulation
*/
template <IndexedTriangulation Triangulation>
Weighted_vertices weighted_vertices(const Triangulation& t, const Surface_point& p) {
  const auto user = [&input = t.input()](std::uint32_t v) { return input.names().row(v); };
  const auto [i, j, k] = sides_of_face(t.input(), p.halfedge);
  return {3,
          {user(t.input().source(i)), user(t.input().source(j)), user(t.input().source(k))},
          p.weights};
}

/*!
\brief computes where a combination of vertices is in space.
\param w vertices of the input and their weights
\param points one point per vertex of the input
*/
std::array<double, 3> position(const Weighted_vertices& w,
                               std::span<const std::array<double, 3>> points);

/*!
\brief computes where the vertices of a common subdivision are in space.
\param s the subdivision
\param points one point per vertex of the input
\return one point per vertex of the subdivision
\complexity linear
*/
std::vector<std::array<double, 3>> positions(const Common_subdivision& s,
                                             std::span<const std::array<double, 3>> points);

/*!
\brief computes where the vertices of a common subdivision are in space, also in polygons that
became planar.

A planar polygon is mapped to the corners of the one in space by mean value coordinates: linear on
its sides, so that neighbours meet; its diagonals become curves.
\param s the subdivision
\param points one point per vertex of the user's mesh
\param input the input of the triangulation
\return one point per vertex of the subdivision
\complexity linear
*/
std::vector<std::array<double, 3>> positions(const Common_subdivision& s,
                                             std::span<const std::array<double, 3>> points,
                                             const Input& input);

/*!
\brief computes where the vertices of a common subdivision are in space.
\tparam FaceGraph a model of `FaceListGraph` with a point map of its own
\param s the subdivision
\param mesh the mesh that the triangulation was built from
\return one point per vertex of the subdivision
\complexity linear
*/
template <class FaceGraph>
  requires(!std::is_convertible_v<const FaceGraph&, std::span<const std::array<double, 3>>>)
std::vector<std::array<double, 3>> positions(const Common_subdivision& s, const FaceGraph& mesh) {
  return positions(s, std::span<const std::array<double, 3>>(points_of(mesh)));
}

/// computes the same for a triangulation with input `input`, also in polygons that became planar.
template <class FaceGraph>
  requires(!std::is_convertible_v<const FaceGraph&, std::span<const std::array<double, 3>>>)
std::vector<std::array<double, 3>> positions(const Common_subdivision& s, const FaceGraph& mesh,
                                             const Input& input) {
  return positions(s, std::span<const std::array<double, 3>>(points_of(mesh)), input);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_COMMON_SUBDIVISION_H
