// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_CUTS_CUT_SURFACE_H
#define CGAL_INTRINSIC_GEODESICS_CUTS_CUT_SURFACE_H

#include <CGAL/Intrinsic_geodesics/cuts/cut_open.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/connectivity/points_of.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is the surface of the user's mesh, cut open along curves: triangles, and the origin of all
their parts.

The triangles of the mesh that no curve enters are whole; others are divided along the curves, and
the pieces into triangles. See `cut_along()`. Vertices of the input are the first vertices, with the
user's numbers; then come the points where curves cross edges or end inside of faces, then the
copies that cuts make, see `original_vertex`.
*/
struct Cut_surface : Opened_surface {
  /// Where a vertex comes from.
  struct Vertex {
    std::uint32_t input_vertex = Gluing::none; ///< the user's vertex that it is, or `none`
    std::uint32_t input_edge = Gluing::none;   ///< the user's edge that it is inside of, or `none`
    std::uint32_t input_face = Gluing::none;   ///< the user's face that it is inside of, or `none`
    Weighted_vertices on_input;                ///< its place, by the user's vertices
    std::uint32_t input_halfedge = Gluing::none; ///< a halfedge of a face of `t.input()` with it
  };
  /// What a side of a triangle lies on; a diagonal lies on neither.
  struct Side {
    std::uint32_t input_edge = Gluing::none; ///< the user's edge, or `none`
    std::uint32_t curve = 0;                 ///< the label of the curve; 0: none
  };

  /// The vertices.
  std::vector<Vertex> vertices;
  /// The sides of triangles, by the numbers of `gluing`.
  std::vector<Side> sides;
  /// The place of each corner in the triangle `input_triangle` of its face: weights of the corners
  /// there, in the order in which the user's triangle lists them.
  std::vector<std::array<double, 3>> weights;
  /// The triangle of the user that each face is in; polygons are made of several.
  std::vector<std::uint32_t> input_triangle;
  /// The user's face that each face is in.
  std::vector<std::uint32_t> input_face;
  /// The connected component of each face.
  std::vector<std::uint32_t> component;
  /// The number of components.
  std::uint32_t number_of_components = 0;

  /// returns the vertices of face `f`, counterclockwise.
  std::span<const std::uint32_t, 3> face(std::size_t f) const {
    return std::span<const std::uint32_t, 3>(gluing.origin.data() + 3 * f, 3);
  }
};

/*!
\brief computes where the vertices of a cut surface are in space.
\param s the surface
\param points one point per vertex of the user's mesh
\complexity linear
*/
std::vector<std::array<double, 3>> positions(const Cut_surface& s,
                                             std::span<const std::array<double, 3>> points);

/// computes the same for a triangulation with input `input`, also in polygons that became planar.
std::vector<std::array<double, 3>>
positions(const Cut_surface& s, std::span<const std::array<double, 3>> points, const Input& input);

/*!
\brief computes where the vertices of a cut surface are in space.
\tparam FaceGraph a model of `FaceListGraph` with a point map of its own
\param s the surface
\param mesh the mesh that the triangulation was built from
\complexity linear
*/
template <ReadableFaceGraph FaceGraph>
std::vector<std::array<double, 3>> positions(const Cut_surface& s, const FaceGraph& mesh) {
  return positions(s, std::span<const std::array<double, 3>>(points_of(mesh)));
}

/*!
\brief takes values at the vertices of the user's mesh to the vertices of a cut surface: linear in
each triangle of the input.
\param s the surface
\param values a number per vertex of the user
\return a number per vertex of `s`
\throws Invalid_input if there are not as many
\complexity linear
*/
std::vector<double> values_at_vertices(const Cut_surface& s, std::span<const double> values);

/*!
\brief takes values at the corners of the user's triangles, such as texture coordinates with seams,
to the corners of a cut surface.
\param s the surface
\param values a number per corner: corner k of triangle f has number 3 f + k, in the order in which
  triangles list their vertices
\return a number per corner of `s`, in the order of `s.gluing.origin`
\throws Invalid_input if there are not as many
\complexity linear
*/
std::vector<double> values_at_corners(const Cut_surface& s, std::span<const double> values);

/*!
\brief builds a mesh of any type from a cut surface: vertices and faces in its order.
\tparam Mesh a model of `WritableFaceGraph` that is empty, with a point map that can be written, or
  a mesh of OpenMesh
\param s the surface
\param points a point per vertex, see `positions()`
\param mesh the mesh
\throws Invalid_input if there is not one point for each vertex
\complexity linear
*/
template <WritableFaceGraph Mesh>
void copy_cut_surface(const Cut_surface& s, std::span<const std::array<double, 3>> points,
                      Mesh& mesh) {
  if (points.size() != s.vertices.size())
    throw Invalid_input(Element_kind::none, 0,
                        "there are " + std::to_string(points.size()) +
                            " points; give one for each of the " +
                            std::to_string(s.vertices.size()) + " vertices of the cut surface");
  copy_gluing_map(Gluing_map::from_valid(s.gluing), mesh);
  std::size_t i = 0;
  for (const typename boost::graph_traits<Mesh>::vertex_descriptor v : vertices(mesh)) {
    const std::array<double, 3>& x = points[i++];
    if constexpr (requires {
                    typename Mesh::Point::value_type;
                    mesh.set_point(v, mesh.point(v));
                  }) {
      typename Mesh::Point p; // of OpenMesh, whose map for CGAL rounds
      for (unsigned c = 0; c < 3; ++c) p[c] = static_cast<typename Mesh::Point::value_type>(x[c]);
      mesh.set_point(v, p);
    } else {
      auto map = get(CGAL::vertex_point, mesh);
      using Point = typename boost::property_traits<decltype(map)>::value_type;
      put(map, v, Point(x[0], x[1], x[2]));
    }
  }
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_CUTS_CUT_SURFACE_H
