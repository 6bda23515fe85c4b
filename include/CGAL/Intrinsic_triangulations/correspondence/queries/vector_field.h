// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_VECTOR_FIELD_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_VECTOR_FIELD_H

#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Vertex_frames.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Vertex_sectors.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent_field.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Vertex_copies.h>

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

/*!
\file
Tangent vector fields at the vertices of an intrinsic triangulation, inserted ones included, as
vectors in space.
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Orthogonal vectors in space along a side of a face, and to the left of it; `source(h)` is where a
// halfedge starts. Nothing if the face has no area there, beyond rounding.
template <class Source>
std::optional<std::array<std::array<double, 3>, 2>>
face_axes_in_space(const Input& input, std::uint32_t h, const Source& source) {
  const auto [ij, jk, ki] = sides_of_face(input, h);
  const std::array<double, 3> i = source(ij), j = source(jk), k = source(ki);
  std::array<double, 3> e, f;
  double ee = 0, ef = 0, ff = 0, left = 0;
  for (std::size_t n = 0; n < 3; ++n) {
    e[n] = j[n] - i[n];
    f[n] = k[n] - i[n];
    ee += e[n] * e[n];
    ef += e[n] * f[n];
    ff += f[n] * f[n];
  }
  const double foot = ef / ee;
  for (std::size_t n = 0; n < 3; ++n) {
    f[n] -= foot * e[n];
    left += f[n] * f[n];
  }
  // a height below 2^-48 of the side, which is 32 roundings of it, has no direction
  if (!(left > 0x1p-96 * ff)) return std::nullopt;
  const double along_side = std::sqrt(ee), above_side = std::sqrt(left);
  for (std::size_t n = 0; n < 3; ++n) {
    e[n] /= along_side;
    f[n] /= above_side;
  }
  return std::array{e, f};
}

// A vector along the axes of a face, in space.
inline std::array<double, 3> along(const std::array<std::array<double, 3>, 2>& axes,
                                   const Unscaled_vector& x) {
  const auto& [e, f] = axes;
  return {x[0] * e[0] + x[1] * f[0], x[0] * e[1] + x[1] * f[1], x[0] * e[2] + x[1] * f[2]};
}

// A vector in a face without area goes straight on to the nearest face that has one; not numbers if
// none of the component has.
template <class Source>
std::array<double, 3> vector_beyond_face(const Input& input, const Input_vector& v,
                                         const Source& source) {
  std::vector<Input_vector> faces{v}; // by the number of edges that are crossed
  const auto is_new = [&](std::uint32_t h) {
    return std::none_of(faces.begin(), faces.end(), [&](const Input_vector& known) {
      return input.face(known.halfedge) == input.face(h);
    });
  };
  for (std::size_t n = 0; n < faces.size(); ++n) {
    const auto [h, x] = faces[n];
    if (const auto axes = face_axes_in_space(input, h, source)) return along(*axes, x);
    const Geodesic_face face(input, h);
    for (unsigned s = 0; s < 3; ++s) {
      const std::uint32_t beyond = face.side[s] ^ 1U;
      if (input.is_border(beyond) || !is_new(beyond)) continue;
      const Unscaled_vector to = face.relative_to(s, x);
      faces.push_back({beyond, {-to[0], -to[1]}});
    }
  }
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  return {unknown, unknown, unknown};
}

// A vector in a face of the input, in space.
template <class Source>
std::array<double, 3> vector_in_space(const Input& input, const Input_vector& v,
                                      const Source& source) {
  const auto axes = face_axes_in_space(input, v.halfedge, source);
  return axes ? along(*axes, v.vector) : vector_beyond_face(input, v, source);
}

// Takes a vector in the frame of an intrinsic face to space, by the rotation that fits the corners
// of a face of the common subdivision best, in the frames of its intrinsic and its input face.
// `points` are its places in space.
template <class View, class Source>
std::array<double, 3>
face_vector_in_space(const View& view, const Input& input, const Source& source, std::uint32_t h,
                     const Common_subdivision& s, std::size_t f,
                     const std::vector<std::array<double, 3>>& points, const Unscaled_vector& v) {
  using Complex = std::complex<double>;
  const std::array<double, 3> a = vector_in_space(input, {h, {1, 0}}, source),
                              b = vector_in_space(input, {h, {0, 1}}, source);
  const std::uint32_t base = view.halfedge_of_face(s.intrinsic_face[f]);
  const Geodesic_face face(view, base);
  const Complex rotation =
      fitting_rotation(s.face_begin[f], s.face_begin[f + 1], [&](std::size_t c) {
        const Plane_vector<double> p = face.position(corner_in_face(view, s, base, c));
        const std::array<double, 3>& x = points[s.corner[c]];
        return std::array{Complex(p[0], p[1]), Complex(x[0] * a[0] + x[1] * a[1] + x[2] * a[2],
                                                       x[0] * b[0] + x[1] * b[1] + x[2] * b[2])};
      });
  const Complex w = Complex(v[0], v[1]) * rotation;
  return {w.real() * a[0] + w.imag() * b[0], w.real() * a[1] + w.imag() * b[1],
          w.real() * a[2] + w.imag() * b[2]};
}

// Tells where halfedges of an input start, whose vertices are at given places in space.
struct Placed_input {
  const Input& input;
  std::span<const std::array<double, 3>> points;

  const std::array<double, 3>& operator()(std::uint32_t h) const {
    return points[input.names().row(input.source(h))];
  }
};

// Where the vertices of a mesh are, by their numbers.
template <class Mesh>
std::vector<std::array<double, 3>> numbered_points(const Input& input, const Mesh& mesh) {
  const Mesh_adaptor<Mesh> number(mesh);
  check_is_mesh_of(input, number.vertex_capacity(mesh));
  std::vector<std::array<double, 3>> points(number.vertex_capacity(mesh));
  const auto map = Mesh_adaptor<Mesh>::point_map(mesh);
  for (const auto v : vertices(mesh))
    points[number.vertex(v)] = Mesh_adaptor<Mesh>::coordinates(get(map, v));
  return points;
}

// The vectors at the centres of the faces of the common subdivision, in space. `source(h)` is where
// a halfedge of the input starts, `points` where the vertices of the subdivision are.
template <class Triangulation, class Source>
std::vector<std::array<double, 3>>
face_vectors_in_space(const Triangulation& t, const Tangent_field& field,
                      const Common_subdivision& s, const Source& source,
                      const std::vector<std::array<double, 3>>& points, unsigned degree) {
  const Intrinsic_view<Triangulation> view(t);
  const Vertex_frames frames = intrinsic_frames(t, view);
  const Vertex_copies copies(t);
  const auto at = [&](std::uint32_t v) { return field[copies(t.numbers().vertex_at(v))]; };
  std::vector<std::array<double, 3>> result;
  result.reserve(degree * s.number_of_faces());
  for (std::size_t f = 0; f < s.number_of_faces(); ++f) {
    Surface_point centre{view.halfedge_of_face(s.intrinsic_face[f]), {0, 0, 0}};
    const std::size_t begin = s.face_begin[f], end = s.face_begin[f + 1];
    for (std::size_t c = begin; c < end; ++c) {
      const std::array<double, 3> w = corner_in_face(view, s, centre.halfedge, c);
      for (std::size_t k = 0; k < 3; ++k)
        centre.weights[k] += w[k] / static_cast<double>(end - begin);
    }
    const std::uint32_t input_face = t.input().names().faces.here(s.input_face[f]);
    const Unscaled_vector first = frames.in_face(centre, at, degree);
    for (unsigned k = 0; k < degree; ++k) {
      const std::complex<double> z = std::complex<double>(first[0], first[1]) *
                                     std::polar(1., 2 * std::numbers::pi * k / degree);
      result.push_back(face_vector_in_space(view, t.input(), source,
                                            t.input().halfedge_of_face(input_face), s, f, points,
                                            {z.real(), z.imag()}));
    }
  }
  return result;
}

} // namespace internal

/*!
\brief takes a tangent vector field to the user's mesh: a vector in space for every vertex, inserted
ones included.
\tparam Mesh the type of the user's mesh
\param t the triangulation
\param field the vectors
\param mesh the mesh that `t` was built from
\return vectors, indexed as `field`; zero for numbers that no vertex with a face has. Vectors in
  faces without area go straight on to the plane of the nearest face that has one
\throws std::invalid_argument if the field does not have a vector per vertex
\complexity that of `Vertex_sectors`, which serves many fields
*/
template <QueriedTriangulation Triangulation, ReadableFaceGraph Mesh>
std::vector<std::array<double, 3>> vectors_in_space(const Triangulation& t,
                                                    const Tangent_field& field, const Mesh& mesh) {
  return Vertex_sectors(t, internal::numbered_points(t.input(), mesh)).in_space(field);
}

/*!
\brief takes a tangent vector field to space, for programs with a soup or a gluing, and points,
instead of a mesh.

See the overload with a mesh.
\param t the triangulation
\param field the vectors
\param points where the user's vertices are
*/
template <QueriedTriangulation Triangulation>
std::vector<std::array<double, 3>>
vectors_in_space(const Triangulation& t, const Tangent_field& field,
                 const std::vector<std::array<double, 3>>& points) {
  return Vertex_sectors(t, points).in_space(field);
}

/*!
\brief takes a tangent vector field to the faces of the common subdivision: a vector in space for
each of them.

Between the corners of an intrinsic face the field is interpolated, in the frame of the face.
\tparam Mesh the type of the user's mesh
\param t the triangulation
\param field the vectors
\param s the common subdivision
\param mesh the mesh that `t` was built from
\param degree number of equivalent directions at equal angles: `field` has one of them at each
  vertex
\return the vectors at the centres of the faces: `degree` of them for each face, one after the
  other, counterclockwise
\pre the faces of the mesh have an area
\complexity linear in the size of the subdivision
*/
template <QueriedTriangulation Triangulation, ReadableFaceGraph Mesh>
std::vector<std::array<double, 3>>
vectors_in_space(const Triangulation& t, const Tangent_field& field, const Common_subdivision& s,
                 const Mesh& mesh, unsigned degree = 1) {
  const std::vector<std::array<double, 3>> points = internal::numbered_points(t.input(), mesh);
  return internal::face_vectors_in_space(t, field, s, internal::Placed_input{t.input(), points},
                                         positions(s, mesh), degree);
}

/*!
\brief takes a tangent vector field to the faces of the common subdivision, for programs with a soup
or a gluing instead of a mesh.

See the overload with a mesh.
\param points where the user's vertices are
*/
template <QueriedTriangulation Triangulation>
std::vector<std::array<double, 3>>
vectors_in_space(const Triangulation& t, const Tangent_field& field, const Common_subdivision& s,
                 const std::vector<std::array<double, 3>>& points, unsigned degree = 1) {
  return internal::face_vectors_in_space(t, field, s, internal::Placed_input{t.input(), points},
                                         positions(s, points, t.input()), degree);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_VECTOR_FIELD_H
