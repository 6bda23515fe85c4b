// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_TANGENT_FIELD_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_TANGENT_FIELD_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Vertex_frames.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Vertex_copies.h>

#include <boost/graph/graph_traits.hpp>

#include <complex>
#include <cstddef>
#include <cstdint>
#include <vector>

/*!
\file
Takes whole tangent vector fields at vertices from one triangulation to the other, by any
correspondence.
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// The frames at the vertices of an input.
Vertex_frames<Input> input_frames(const Input& input);

// The halfedge of the input along which the real axis at each vertex of the user's mesh runs, by
// the number of the vertex here: none at isolated ones.
template <class Mesh>
std::vector<std::uint32_t> axes_of_mesh(const Input& input, const Mesh& mesh) {
  const Named_mesh_elements<Mesh> named(input, mesh);
  const Mesh_adaptor<Mesh> number(mesh);
  std::vector<std::uint32_t> axes(input.number_of_vertices(), Gluing::none);
  for (const auto v : vertices(mesh))
    if (halfedge(v, mesh) != boost::graph_traits<Mesh>::null_halfedge())
      axes[input.names().vertices.here(number.vertex(v))] =
          named.halfedge_on_input(opposite(halfedge(v, mesh), mesh));
  return axes;
}
std::vector<std::uint32_t> axes_of_input(const Input& input);

void expect_size(const Tangent_field& field, std::size_t size);

// Takes fields between frames: by the direction on the input of the real axis at each intrinsic
// vertex.
template <class Triangulation>
class Field_transfer {
  using Vertex = typename Triangulation::vertex_descriptor;

public:
  Field_transfer(const Triangulation& t, const std::vector<std::uint32_t>& axes)
      : t_(t), copies_(t), axes_(axes), frames_(input_frames(t.input())) {}

  Tangent_field to_intrinsic(const Tangent_field& field) const {
    expect_size(field, t_.input().number_of_vertices());
    const auto at = [&](std::uint32_t v) { // in the frames of the input
      return field[t_.input().names().vertices.user(v)] * rotation(v);
    };
    Tangent_field result(copies_.size(), 0);
    for (const Vertex v : vertices(t_.mesh())) {
      if (is_isolated(t_, v)) continue;
      const Tangent_vector axis = axis_on_input(v);
      std::complex<double>& z = result[copies_(v)];
      if (t_.is_inserted(v)) { // in a face, whose frame is the same for all
        const Unscaled_vector x = frames_.in_face(axis.point, at);
        z = std::complex<double>(x[0], x[1]) *
            std::conj(std::complex<double>(axis.vector[0], axis.vector[1]));
      } else {
        z = at(t_.index(v)) * std::polar(1., -frames_.polar_angle(axis, corner_of(axis.point)));
      }
    }
    return result;
  }

  Tangent_field to_input(const Tangent_field& field) const {
    expect_size(field, copies_.size());
    Tangent_field result(t_.input().number_of_vertices(), 0);
    for (const Vertex v : vertices(t_.mesh())) {
      if (t_.is_inserted(v) || is_isolated(t_, v)) continue;
      const Tangent_vector axis = axis_on_input(v);
      const std::uint32_t i = copies_(v);
      result[i] = field[i] * std::polar(1., frames_.polar_angle(axis, corner_of(axis.point))) *
                  std::conj(rotation(t_.index(v)));
    }
    return result;
  }

private:
  // from the user's axis to the one of the frames of the input
  std::complex<double> rotation(std::uint32_t v) const {
    return axes_[v] == Gluing::none ? 0 : std::polar(1., frames_.polar_angle(axes_[v]));
  }

  // the unit vector along the real axis of an intrinsic vertex
  Tangent_vector axis_on_input(Vertex v) const {
    const std::uint32_t h = Intrinsic_view<Triangulation>(t_).outgoing_halfedge(t_.index(v));
    return at_start(queries(t_).walk_on_input(h, 0), 1);
  }

  const Triangulation& t_;
  Vertex_copies<Triangulation> copies_;
  const std::vector<std::uint32_t>& axes_;
  Vertex_frames<Input> frames_;
};

} // namespace internal

/*!
\brief takes a tangent vector field from the vertices of the user's mesh to those of the intrinsic
triangulation.

Vectors at vertices of the mesh only change their coordinates. Vectors at inserted vertices are
averages in the face of the input: of the vectors at its corners, in its frame.
\tparam Triangulation a model of `CorrespondingTriangulation`
\tparam Mesh the type of the user's mesh
\param t the triangulation
\param field a vector per vertex `v` of `mesh`, at its number, in the polar coordinates there: the
  real axis runs along `opposite(halfedge(v, mesh), mesh)`, scaled as in `Tangent_field`
\param mesh the mesh that `t` was built from, with manifold vertices; its faces may be polygons
\return the vectors, in the coordinates of `t`; zero at isolated vertices
\throws std::invalid_argument if the field does not have one vector per vertex
\throws Invalid_input if the mesh is another one
\complexity linear, and for each vertex that of `tangent_to_input()`
*/
template <QueriedTriangulation Triangulation, ReadableFaceGraph Mesh>
Tangent_field tangent_field_to_intrinsic(const Triangulation& t, const Tangent_field& field,
                                         const Mesh& mesh) {
  return internal::Field_transfer(t, internal::axes_of_mesh(t.input(), mesh)).to_intrinsic(field);
}

/*!
\brief takes a tangent vector field from the vertices of the intrinsic triangulation to those of the
user's mesh.

This is the inverse of `tangent_field_to_intrinsic()`; it omits vectors at inserted vertices.
*/
template <QueriedTriangulation Triangulation, ReadableFaceGraph Mesh>
Tangent_field tangent_field_to_input(const Triangulation& t, const Tangent_field& field,
                                     const Mesh& mesh) {
  return internal::Field_transfer(t, internal::axes_of_mesh(t.input(), mesh)).to_input(field);
}

/*!
\brief takes a tangent vector field from the vertices of the input to those of the intrinsic
triangulation, for programs with a soup or a gluing instead of a mesh.

See the overload with a mesh. The real axis at vertex `v` of the input runs along
`t.input().outgoing_halfedge(v)`; vectors are at the user's number of the vertex; on a cover, at the
number of the copy, `t.input().names().vertices.user(v)`. Inserted vertices follow in the order of
their numbers.
*/
template <QueriedTriangulation Triangulation>
Tangent_field tangent_field_to_intrinsic(const Triangulation& t, const Tangent_field& field) {
  return internal::Field_transfer(t, internal::axes_of_input(t.input())).to_intrinsic(field);
}

/*!
\brief takes a tangent vector field from the vertices of the intrinsic triangulation to those of the
input, for programs without a mesh.

This is the inverse of `tangent_field_to_intrinsic()`.
*/
template <QueriedTriangulation Triangulation>
Tangent_field tangent_field_to_input(const Triangulation& t, const Tangent_field& field) {
  return internal::Field_transfer(t, internal::axes_of_input(t.input())).to_input(field);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_TANGENT_FIELD_H
