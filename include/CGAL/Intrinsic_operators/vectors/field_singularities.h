// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_VECTORS_FIELD_SINGULARITIES_H
#define CGAL_INTRINSIC_OPERATORS_VECTORS_FIELD_SINGULARITIES_H

#include <CGAL/Intrinsic_operators/operators/Connection_graph.h>
#include <CGAL/Intrinsic_operators/operators/connection_laplacian.h>
#include <CGAL/Intrinsic_operators/vectors/direction_field.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Vertex_copies.h>

#include <complex>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief holds the numbers of turns of a direction field about faces and along the border.

    sum of the indices of faces = degree * Euler characteristic + sum of the turns along the border

as integers, without rounding: isolated vertices are left out of the characteristic, and vertices
that are not manifold count once for each of their fans.
*/
template <ConnectedTriangulation Triangulation>
struct Field_singularities {
  /// The index of each face, at `t.index(f)`: a direction makes index / degree turns about the
  /// face. Most are zero.
  std::vector<int> index;
  /// A halfedge beside the border of each boundary loop, its face on the left, and the turns of the
  /// powers relative to the border along the loop: zero if the field follows the border.
  std::vector<std::pair<typename Triangulation::halfedge_descriptor, int>> turns;

  /// returns the sum of the indices.
  std::ptrdiff_t sum() const {
    std::ptrdiff_t s = 0;
    for (const int i : index) s += i;
    return s;
  }
};

namespace internal {

// How a field turns along each edge, besides parallel transport: between -pi and pi, and of
// opposite sign for opposite halfedges.
class Field_rotations {
public:
  template <class Triangulation>
  Field_rotations(const Triangulation& t, const Direction_field& field,
                  const Halfedge_angles& angles)
      : rotation_(t.numbers().edge_capacity(t.mesh()), 0) {
    const Vertex_copies<Triangulation> copies(t);
    if (field.powers.size() != copies.size())
      throw std::invalid_argument("the field must have a value per vertex, " +
                                  std::to_string(copies.size()) + ", not " +
                                  std::to_string(field.powers.size()));
    const auto at = [&](auto v) {
      const std::complex<double> z = unit_vector(field.powers[copies(v)]);
      return z == 0. ? 1. : z; // any direction has indices whose sum is right
    };
    for (const auto e : edges(t.mesh())) {
      const std::uint32_t i = 2 * t.index(e);
      const auto h = t.numbers().halfedge_at(i);
      const Connection_edge edge{0, 0, 0, 0, angles[i], angles[i + 1]};
      const auto r = transport_factor<std::complex<double>>(edge, field.degree);
      rotation_[i / 2] = std::arg(at(target(h, t.mesh())) * std::conj(r * at(source(h, t.mesh()))));
    }
  }

  double operator[](std::uint32_t h) const {
    return h % 2 == 0 ? rotation_[h / 2] : -rotation_[h / 2];
  }

private:
  std::vector<double> rotation_;
};

inline int full_turns(double angle) {
  return static_cast<int>(std::lround(angle / (2 * std::numbers::pi)));
}

// The halfedge after `h` along the border, both beside it with their faces on the left.
template <class View>
std::uint32_t next_beside_border(const View& view, std::uint32_t h) {
  std::uint32_t g = view.next(h);
  while (!view.is_border(g ^ 1U)) g = view.next(g ^ 1U);
  return g;
}

} // namespace internal

/*!
\brief counts how often a direction field turns about each face: its singularities.

Along an edge the field turns by the least angle, from -pi to pi, of its power relative to parallel
transport. Around a face these angles and its curvature in polar coordinates, `degree` times the sum
of the scaled corner angles minus pi, sum up to full turns. The index is their number, rounded to an
integer. Each edge occurs twice, with opposite angles, so the sum of all indices is exact.
\tparam Triangulation a model of `MeasuredTriangulation` and `NumberedTriangulation`
\param t the triangulation
\param field the field; zero counts as the real axis
\return indices of faces, and turns along the border
\throws std::invalid_argument if the field does not have a value per vertex
\complexity linear
*/
template <ConnectedTriangulation Triangulation>
Field_singularities<Triangulation> singularities(const Triangulation& t,
                                                 const Direction_field& field) {
  const internal::Halfedge_angles angles(t, internal::Border_angles::half_circle);
  const internal::Field_rotations rotation(t, field, angles);
  const Intrinsic_view<Triangulation> view(t);
  Field_singularities<Triangulation> result;
  result.index.assign(t.numbers().face_capacity(t.mesh()), 0);
  std::vector<char> is_met(2 * std::size_t{t.numbers().edge_capacity(t.mesh())}, 0);
  for (const auto f : faces(t.mesh())) {
    double curvature = -std::numbers::pi, sum = 0;
    for (const std::uint32_t h : sides_of_face(view, view.halfedge_of_face(t.index(f)))) {
      curvature += angles.scale(h) * angle_at_source(view, h);
      sum += rotation[h];
      if (!view.is_border(h ^ 1U) || is_met[h] != 0) continue;
      double along = 0; // in the frames there, the border does not turn
      for (std::uint32_t g = h; is_met[g] == 0; g = internal::next_beside_border(view, g)) {
        is_met[g] = 1;
        along += rotation[g];
      }
      result.turns.push_back({t.numbers().halfedge_at(h), internal::full_turns(along)});
    }
    result.index[t.index(f)] = internal::full_turns(sum + field.degree * curvature);
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_VECTORS_FIELD_SINGULARITIES_H
