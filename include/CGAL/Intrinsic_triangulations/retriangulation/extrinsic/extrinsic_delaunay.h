// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_EXTRINSIC_EXTRINSIC_DELAUNAY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_EXTRINSIC_EXTRINSIC_DELAUNAY_H

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/input/mollification.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a triangle mesh in space on the surface of another mesh; all its edges are Delaunay.
*/
struct Extrinsic_delaunay_mesh {
  /// Coordinates of the vertices: first those of the user's mesh, in its order.
  std::vector<std::array<double, 3>> points;
  /// Vertices of the triangles, counterclockwise.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// A face of the user's mesh that each triangle lies on; it may lie on coplanar neighbours, too.
  std::vector<std::uint32_t> input_face;
  /// `done`, or `cap`: then some edges are not Delaunay.
  Status status = Status::done;
  /// How many vertices it inserted, and by which moves.
  Refinement_counts counts;
};

/*!
\brief tells for each edge of an input whether the surface is bent there: the border, and edges
between faces that do not lie in one plane side by side.

Exact: an edge that is not bent may be flipped, and its faces stay straight in space.
\throws Invalid_input if lengths are not those of points in space
\complexity linear
*/
std::vector<char> bent_edges(const Input& input);

/*!
\brief computes an ordinary mesh in space that keeps the surface of another one and is Delaunay in
the intrinsic sense: the extrinsic construction of §4.9.2 of the course, by splits of edges and
planar flips (Dyer, Zhang and Moeller 2007).

Edges where the surface is bent are never flipped, only split until they are Delaunay; in flat parts
edges flip. The mesh therefore has more vertices than the intrinsic Delaunay triangulation, which
`flip_to_delaunay()` finds on the same vertices, and keeps the small angles of the input. Use it for
programs that need triangles in space.

New vertices lie on edges of the user's mesh or in its flat parts; their coordinates are rounded to
doubles, all decisions before are exact.
\tparam FaceGraph a model of `FaceListGraph` with a point map of its own
\tparam NP a chain of named parameters
\param mesh the mesh
\param np optional named parameters:
  - `minimum_angle(x)`: least angle of faces, in degrees; the input's own small angles stay.
    Default: 0.
  - `maximum_edge_length(x)`: largest length of edges. Default: any.
  - `maximum_insertions(n)`: cap on the number of insertions. Default: as for `delaunay_refine()`.
\throws Invalid_input as `Intrinsic_input`, such as for a side of length zero
\complexity usually linear in the number of vertices inserted
*/
template <ReadableFaceGraph FaceGraph, NamedParameters NP = parameters::Parameters<>>
Extrinsic_delaunay_mesh extrinsic_delaunay(const FaceGraph& mesh,
                                           const NP& np = parameters::default_values()) {
  using namespace internal::tags;
  internal::expect_names<minimum_angle, maximum_edge_length, maximum_insertions>(np);
  internal::Refinement_settings settings(np);
  settings.minimum_angle = internal::value_or<minimum_angle>(np, 0.);
  settings.is_conforming = true;

  Corresponding_triangulation t(Intrinsic_input(mesh, Mollification::none));
  const auto refined = internal::refine(t, settings, bent_edges(t.input()), {});
  const Common_subdivision s = common_subdivision(t);
  const std::vector<std::array<double, 3>> points = positions(s, mesh, t.input());

  Extrinsic_delaunay_mesh result;
  result.status = refined.result.status;
  result.counts = refined.result.counts;
  result.points.resize(s.number_of_intrinsic_vertices);
  for (std::size_t v = 0; v < s.vertices.size(); ++v)
    result.points[s.vertices[v].intrinsic] = points[v];
  std::vector<std::uint32_t> face_on_input(t.numbers().face_capacity(t.mesh()), Gluing::none);
  for (std::size_t f = 0; f < s.number_of_faces(); ++f) {
    const std::uint32_t h = s.input_halfedge[s.face_begin[f]];
    if (t.input().quadruple_area(t.input().face(h)) > 0) // in space, triangles lie over no cap
      face_on_input[s.intrinsic_face[f]] = s.input_face[f];
  }
  for (const auto f : faces(t.mesh())) {
    const auto h = halfedge(f, t.mesh()), n = next(h, t.mesh());
    result.triangles.push_back({t.input_vertex(source(h, t.mesh())),
                                t.input_vertex(source(n, t.mesh())),
                                t.input_vertex(target(n, t.mesh()))});
    result.input_face.push_back(face_on_input[t.index(f)]);
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_EXTRINSIC_EXTRINSIC_DELAUNAY_H
