// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_PLACES_ON_MESH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_PLACES_ON_MESH_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/position_on_face.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/*!
\file
Places on the user's mesh, in the user's descriptors. The last argument is the unchanged mesh from
which the triangulation was built.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a face of a mesh and barycentric coordinates of its corners, from the source of
`halfedge(face, mesh)`: `CGAL::Polygon_mesh_processing::Face_location<Mesh, double>`, without the
headers of that package.

The face and its file list that corner last: see `place_in_face()`.
*/
template <ReadableFaceGraph Mesh>
using Face_location =
    std::pair<typename boost::graph_traits<Mesh>::face_descriptor, std::array<double, 3>>;

namespace internal {

// `vertices`: number of vertices of the mesh, removed ones included
inline void check_is_mesh_of(const Input_definition& input, std::uint32_t vertices) {
  if (vertices != input.number_of_vertices())
    throw Invalid_input(
        Element_kind::none, 0,
        "the mesh is not the one that the triangulation was built from, or has removed "
        "elements; collect its garbage before the triangulation is built");
}

// A point of the input, from coordinates of the user's vertices by number.
template <class Coordinates>
std::array<double, 3> combination_of_corners(const Input& input, const Surface_point& p,
                                             const Coordinates& coordinates) {
  std::array<std::uint32_t, 3> corners;
  std::uint32_t h = p.halfedge;
  for (std::size_t k = 0; k < 3; ++k, h = input.next(h))
    corners[k] = input.names().row(input.source(h));
  return position_on_face(input, input.face(p.halfedge), corners, p.weights, coordinates);
}

// The user's mesh, by the names of the input.
template <class Mesh>
class Named_mesh_elements {
  using Traits = boost::graph_traits<Mesh>;
  using Halfedge = typename Traits::halfedge_descriptor;
  using Face = typename Traits::face_descriptor;

public:
  Named_mesh_elements(const Input& input, const Mesh& mesh)
      : input_(input), mesh_(mesh), number_(mesh) {
    check_is_mesh_of(input, number_.vertex_capacity(mesh));
  }

  // The halfedge of the input at the user's halfedge of a triangle.
  std::uint32_t halfedge_in_triangle(Halfedge u) const {
    const std::uint32_t name = triangle(face(u, mesh_));
    std::uint32_t h = input_.halfedge_of_face(input_.names().faces.here(name));
    for (unsigned k = 0; k < 3; ++k, h = input_.next(h))
      if (is_named(h, u) && is_named(input_.next(h), next(u, mesh_)) &&
          is_named(input_.next(input_.next(h)), next(next(u, mesh_), mesh_)))
        return h;
    throw Invalid_input(Element_kind::face, number_.face(face(u, mesh_)),
                        "the mesh has been changed since the triangulation was built from it");
  }

  // The halfedge of the input at the user's halfedge.
  std::uint32_t halfedge_on_input(Halfedge u) const {
    const std::uint32_t h = 2 * input_.names().edges.here(number_.halfedge(u) / 2);
    if (is_named(h, u) != is_named(h ^ 1U, u)) return is_named(h, u) ? h : h ^ 1U;
    if (face(u, mesh_) == Traits::null_face()) // a loop: its other side is in a face
      return halfedge_in_triangle(opposite(u, mesh_)) ^ 1U;
    return halfedge_in_triangle(u);
  }

  Surface_point on_input(const Face_location<Mesh>& p) const {
    return {halfedge_in_triangle(halfedge(p.first, mesh_)), p.second};
  }
  Face_location<Mesh> on_mesh(const Surface_point& p) const {
    const Face f = number_.face_at(input_.names().polygon(input_.face(p.halfedge)));
    return {f, seen_from(input_, p, halfedge_in_triangle(halfedge(f, mesh_))).weights};
  }

  // in the type that the mesh has for points
  auto point(const Surface_point& p) const {
    const auto map = Mesh_adaptor<Mesh>::point_map(mesh_);
    using User_point = std::remove_cvref_t<
        typename boost::property_traits<std::remove_cv_t<decltype(map)>>::value_type>;
    const std::array<double, 3> x = combination_of_corners(input_, p, [&](std::uint32_t v) {
      return Mesh_adaptor<Mesh>::coordinates(get(map, number_.vertex_at(v)));
    });
    return User_point(x[0], x[1], x[2]);
  }

private:
  // the name of the triangle that a face is
  std::uint32_t triangle(Face f) const {
    const Halfedge h = halfedge(f, mesh_);
    const std::uint32_t i = number_.face(f);
    if (next(next(next(h, mesh_), mesh_), mesh_) != h)
      throw Invalid_input(Element_kind::face, i,
                          "face " + std::to_string(i) +
                              " is a polygon, in which barycentric coordinates name no point; "
                              "triangulate the faces of the mesh before");
    const std::vector<std::uint32_t>& polygon = input_.names().polygon_of_triangle;
    if (polygon.empty()) return i;
    return static_cast<std::uint32_t>(std::lower_bound(polygon.begin(), polygon.end(), i) -
                                      polygon.begin());
  }

  bool is_named(std::uint32_t h, Halfedge u) const {
    const Input_names& names = input_.names();
    return names.edges.user(h / 2) == number_.halfedge(u) / 2 &&
           names.vertices.user(input_.source(h)) == number_.vertex(source(u, mesh_)) &&
           names.vertices.user(input_.target(h)) == number_.vertex(target(u, mesh_));
  }

  const Input& input_;
  const Mesh& mesh_;
  Mesh_adaptor<Mesh> number_;
};

// The input of a triangulation, if it has kept its surface.
template <class Triangulation>
const Input& kept_input(const Triangulation& t) {
  if (t.input().surface() == nullptr)
    throw Invalid_input(Element_kind::none, 0,
                        "a triangulation without correspondence does not keep the faces of its "
                        "input; use Integer_coordinates as its third argument");
  return *t.input().surface();
}

} // namespace internal

/*!
\brief returns the place in a triangle of a mesh at weights in the order in which the face lists its
vertices.

This is the order of `vertices_around_face(halfedge(f, mesh), mesh)`, of the mesh's file, and of
`face:b0:b1:b2` on the command line; CGAL's `Face_location` begins at the last of them.
\param f the face
\param weights weights of its corners
\complexity constant
*/
template <ReadableFaceGraph Mesh>
Face_location<Mesh> place_in_face(typename boost::graph_traits<Mesh>::face_descriptor f,
                                  const std::array<double, 3>& weights, const Mesh&) {
  return {f, {weights[2], weights[0], weights[1]}};
}

/// returns the weights of a place in the order in which its face lists its vertices;
/// `place_in_face()` undoes it.
template <std::copyable Face>
std::array<double, 3> weights_in_face(const std::pair<Face, std::array<double, 3>>& place) {
  return {place.second[1], place.second[2], place.second[0]};
}

/*!
\brief returns the vertex of the intrinsic triangulation with a given row in matrices, functions and
distances, that is, the user's vertex of that number. Programs with a soup, a point cloud or a
gluing instead of a mesh need it.

`Intrinsic_triangulation::input_vertex()` undoes it. It does not find inserted vertices, whose rows
follow those of the user's.
\param t the triangulation
\param row the row
\return the vertex; on a cover, the first of its copies
\throws Invalid_input if the input has fewer rows
\complexity constant; on a cover, logarithmic
*/
template <NumberedTriangulation Triangulation>
typename Triangulation::vertex_descriptor vertex_of_row(const Triangulation& t, std::uint32_t row) {
  const std::uint32_t rows = t.input().number_of_rows();
  if (row >= rows)
    throw Invalid_input(Element_kind::vertex, row,
                        "there is no vertex " + std::to_string(row) +
                            " of the input; numbers are below " + std::to_string(rows));
  return t.numbers().vertex_at(t.input().names().vertex(row));
}

/*!
\brief returns the point of the input at a place on the user's mesh.
\param t the triangulation
\param p the place, in a triangle
\param mesh the mesh that `t` was built from
\throws Invalid_input if the face is a polygon, the mesh is another one, or `t` has no
correspondence
\complexity constant; with `CGAL::Polyhedron_3` as mesh, linear
*/
template <NumberedTriangulation Triangulation, ReadableFaceGraph Mesh>
Surface_point surface_point(const Triangulation& t,
                            const Face_location<std::type_identity_t<Mesh>>& p, const Mesh& mesh) {
  return internal::Named_mesh_elements<Mesh>(internal::kept_input(t), mesh).on_input(p);
}

/// returns the point of the intrinsic triangulation at a place on it.
/// \complexity constant
template <NumberedTriangulation Triangulation>
Surface_point surface_point(const Triangulation& t,
                            const Face_location<typename Triangulation::Mesh>& p) {
  return {t.numbers().halfedge(halfedge(p.first, t.mesh())), p.second};
}

/*!
\brief returns the vertex of the intrinsic triangulation at a vertex of the user's mesh.
\param t the triangulation
\param v the vertex
\param mesh the mesh that `t` was built from; its faces may be polygons
\throws Invalid_input if the mesh is another one
\complexity constant; with `CGAL::Polyhedron_3` as mesh, linear
*/
template <NumberedTriangulation Triangulation, ReadableFaceGraph Mesh>
typename Triangulation::vertex_descriptor
vertex_on_intrinsic(const Triangulation& t, typename boost::graph_traits<Mesh>::vertex_descriptor v,
                    const Mesh& mesh) {
  const Mesh_adaptor<Mesh> number(mesh);
  internal::check_is_mesh_of(t.input(), number.vertex_capacity(mesh));
  return t.numbers().vertex_at(t.input().names().vertices.here(number.vertex(v)));
}

/*!
\brief returns the place on the user's mesh of a point of the input.

This is the inverse of `surface_point()`.
*/
template <NumberedTriangulation Triangulation, ReadableFaceGraph Mesh>
Face_location<Mesh> face_location(const Triangulation& t, const Surface_point& p,
                                  const Mesh& mesh) {
  return internal::Named_mesh_elements<Mesh>(internal::kept_input(t), mesh).on_mesh(p);
}

/*!
\brief returns the place on the intrinsic triangulation of a point of it: in the frame of
`t.mesh()`.
\complexity constant
*/
template <NumberedTriangulation Triangulation>
Face_location<typename Triangulation::Mesh> face_location(const Triangulation& t,
                                                          const Surface_point& p) {
  const Intrinsic_view<Triangulation> view(t);
  const std::uint32_t f = view.face(p.halfedge);
  return {t.numbers().face_at(f), seen_from(view, p, view.halfedge_of_face(f)).weights};
}

/*!
\brief returns where a point of the input is in space, in the type of points of the user's mesh.
\param t the triangulation
\param p the point
\param mesh the mesh that `t` was built from; its faces may be polygons
\complexity as `surface_point()`
*/
template <NumberedTriangulation Triangulation, ReadableFaceGraph Mesh>
auto point_in_space(const Triangulation& t, const Surface_point& p, const Mesh& mesh) {
  return internal::Named_mesh_elements<Mesh>(internal::kept_input(t), mesh).point(p);
}

/*!
\brief returns where a point of the input is in space.
\param t the triangulation
\param p the point
\param points coordinates of the vertices of the mesh that `t` was built from, in its order
\complexity constant
*/
template <NumberedTriangulation Triangulation>
std::array<double, 3> point_in_space(const Triangulation& t, const Surface_point& p,
                                     const std::vector<std::array<double, 3>>& points) {
  return internal::combination_of_corners(internal::kept_input(t), p,
                                          [&](std::uint32_t v) { return points[v]; });
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_PLACES_ON_MESH_H
