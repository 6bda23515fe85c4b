// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_VECTORS_LOGARITHMS_FROM_PLACE_H
#define CGAL_INTRINSIC_OPERATORS_VECTORS_LOGARITHMS_FROM_PLACE_H

#include <CGAL/Intrinsic_operators/operators/Connection_graph.h>
#include <CGAL/Intrinsic_operators/vectors/Point_frames.h>
#include <CGAL/Intrinsic_operators/vectors/Vectors_on_sheets.h>
#include <CGAL/Intrinsic_operators/vectors/logarithmic_map.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Sheets.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place_finder.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Vertex_copies.h>

#include <algorithm>
#include <complex>
#include <concepts>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Of each vertex the shorter one of two logarithms; `to_frame` takes that from another copy of the
// place to the frame of the place.
template <class To_frame>
void take_shorter(std::vector<std::complex<double>>& log,
                  const std::vector<std::complex<double>>& from_copy, const To_frame& to_frame) {
  constexpr double shorter = 1 - 0x1p-30; // by more than rounding
  for (std::size_t i = 0; i < log.size(); ++i)
    if (is_known(from_copy[i]) &&
        (!is_known(log[i]) || std::abs(from_copy[i]) < shorter * std::abs(log[i])))
      log[i] = to_frame(from_copy[i]);
}

// Finds logarithms from all copies of a place on a cover.
template <class Triangulation, class Logarithm>
class Logarithms_from_copies {
  using Vertex = typename Triangulation::vertex_descriptor;
  using Complex = std::complex<double>;

public:
  // \param all_copies whether logarithms from one copy are not enough
  Logarithms_from_copies(const Triangulation& t, const Logarithm& logarithm, bool all_copies)
      : t_(t), logarithm_(logarithm), sheets_(t.correspondence().input()),
        all_copies_(all_copies && sheets_.is_cover() && sheets_.has_branches()) {}

  std::vector<Complex> at_vertex(Vertex v) const {
    std::vector<Complex> result = logarithm_(v);
    if (!all_copies_) return result;
    Vectors_on_sheets<Triangulation> vectors(t_);
    for (const Vertex w : copies_of_vertex(t_, v)) {
      if (w == v) continue;
      take_shorter(result, logarithm_(w), [&](const Complex& z) {
        for (const auto& [u, mirrored] : vectors(w, z))
          if (u == v) return mirrored;
        return z;
      });
    }
    return result;
  }

  // \param p on the input, not at a vertex
  std::vector<Complex> at_point(const Surface_point& p) const {
    std::vector<Complex> result = at_copy(p);
    if (!all_copies_) return result;
    const Geodesic_face face(t_.correspondence().input(), p.halfedge);
    Complex axis(0, 1); // of the reflection: an edge, or across the side
    for (unsigned k = 0; k < 3; ++k)
      if (p.weights[(k + 2) % 3] == 0)
        axis = Complex(face.edge[k][0], face.edge[k][1]) / face.length[k];
    const bool is_on_edge = std::count(p.weights.begin(), p.weights.end(), 0.) > 0;
    for (const Surface_point& q : sheets_.others(p))
      take_shorter(result, at_copy(q), [&](const Complex& z) {
        return is_on_edge ? axis * std::conj(z) : -std::conj(z);
      });
    return result;
  }

private:
  std::vector<Complex> at_copy(const Surface_point& p) const {
    const Tangent_vector axis =
        tangent_to_intrinsic(t_, with_one_name(t_.correspondence().input(), {p, {1, 0}})).value();
    std::vector<Complex> result = logarithm_(axis.point);
    const auto turn = std::polar(1., -std::atan2(axis.vector[1], axis.vector[0]));
    for (Complex& z : result) z *= turn;
    return result;
  }

  const Triangulation& t_;
  const Logarithm& logarithm_;
  Sheets sheets_;
  bool all_copies_;
};

// From a corner of the user's face, in its frame.
template <class Triangulation, class Logarithm>
std::vector<std::complex<double>>
logarithms_at_corner_of_face(const Triangulation& t, const Surface_point& p,
                             const Logarithms_from_copies<Triangulation, Logarithm>& logarithms) {
  const Input& input = t.correspondence().input();
  const Geodesic_face face(input, p.halfedge);
  const unsigned k = corner_of(p);
  const double half = angle_at_source(input, face.side[k]) / 2;
  const Plane_vector<double> middle = face.from_relative_to(k, {std::cos(half), std::sin(half)});
  const Tangent_vector there = tangent_to_intrinsic(t, {p, {middle.x, middle.y}}).value();
  const Point_frames<Triangulation> frames(t);
  auto corner = frames.corners(there.point)[0];
  corner.polar_angle = std::arg(corner.to_here({there.vector[0], there.vector[1]}));
  corner.angle = std::atan2(middle[1], middle[0]);
  std::vector<std::complex<double>> result =
      logarithms.at_vertex(t.numbers().vertex_at(input.source(face.side[k])));
  for (std::complex<double>& z : result) z = corner.from_here(frames.from_field(corner.vertex, z));
  return result;
}

} // namespace internal

/*!
\brief finds a logarithmic map from a place that a user names.

Vectors are in the polar coordinates of the vertex if the place was named as a vertex, else in the
frame of the face that names it: along its first side, and to the left of that. At a corner of the
face, angles from the middle of the corner are those on the surface.

By heat, on a cover of faces of which more than two meet at an edge, maps from all copies of the
place are found, and each vertex has its shortest logarithm. If no reflection takes that to the
frame of the place, it stays in that of the copy.
\tparam Triangulation a model of `CorrespondingTriangulation`
\tparam Logarithm called with a vertex or a `Surface_point` of the triangulation; it returns a
  `Tangent_field`, such as `logarithmic_map()` does
\param t the triangulation
\param place the place, normalized
\param method that of `logarithm`
\param logarithm finds the map
\throws Invalid_input as `Place_finder::append()`
*/
template <QueriedTriangulation Triangulation, std::invocable<Surface_point> Logarithm>
std::vector<std::complex<double>> logarithms_from_place(const Triangulation& t, const Place& place,
                                                        Logarithm_method method,
                                                        const Logarithm& logarithm) {
  const internal::Logarithms_from_copies<Triangulation, Logarithm> logarithms(
      t, logarithm, method != Logarithm_method::exact);
  if (!place.has_face())
    return logarithms.at_vertex(Place_finder<Triangulation>(t).vertex(place.vertex));
  const Surface_point p = point_on_input(t.correspondence().input(), place);
  return place.is_vertex() ? internal::logarithms_at_corner_of_face(t, p, logarithms)
                           : logarithms.at_point(p);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_VECTORS_LOGARITHMS_FROM_PLACE_H
