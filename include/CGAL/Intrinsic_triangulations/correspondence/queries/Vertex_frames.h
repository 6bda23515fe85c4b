// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_VERTEX_FRAMES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_VERTEX_FRAMES_H

#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_walk.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <boost/graph/graph_traits.hpp>

#include <complex>
#include <cstdint>
#include <numbers>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief holds a tangent vector per vertex `v`, at its row `t.input_vertex(v)` as in all operators;
`vertex_of_row()` is its inverse.

On a cover, each copy of a vertex has its own tangent plane and vector. The vector is then not at a
row but at the number of the copy, `t.input().names().vertices.user(t.index(v))`; those of inserted
vertices follow.

It is a complex number in the polar coordinates of the vertex (§2.4 of the course): the real axis
runs along the first halfedge that starts there, `opposite(halfedge(v, t.mesh()), t.mesh())`, and
angles from it counterclockwise are scaled so that the total angle becomes 2 pi, or pi on the
border.
*/
using Tangent_field = std::vector<std::complex<double>>;

namespace internal {

// From angles at a vertex to polar angles.
inline double polar_scale(const Fan_angle& fan) {
  const double full = (fan.is_on_border ? 1 : 2) * std::numbers::pi;
  return fan.sum > 0 ? full / fan.sum : 1;
}

// The vector at the source of the first halfedge there, in the face that it points into. On the
// border half of the circle has the vectors that point out of the surface, which are in the frame
// of the first face.
template <class Surface>
Tangent_vector vector_at_source(const Surface& surface, std::uint32_t first, double scale,
                                std::complex<double> z) {
  constexpr double pi = std::numbers::pi;
  const double a = std::arg(z), polar = a < 0 ? a + 2 * pi : a;
  const Geodesic_walk<Surface> walk(surface, Corner_direction{first, polar / scale});
  if (!walk.is_blocked()) return at_start(walk, std::abs(z));
  const double inside = pi / scale, beyond = (polar - pi) / pi;
  return at_start(Geodesic_walk<Surface>(surface, Corner_direction{first, 0}), std::abs(z),
                  inside + beyond * (2 * pi - inside));
}

// The polar coordinates at the vertices of a surface with numbered elements.
template <class Surface>
class Vertex_frames {
public:
  Vertex_frames(const Surface& surface, std::uint32_t vertices, std::uint32_t halfedges)
      : surface_(surface), scale_(vertices, 1), angle_(halfedges, 0) {}

  // measures the angles at a vertex that is not isolated
  void measure(std::uint32_t v) {
    scale_[v] = polar_scale(measure_fan(surface_, surface_.outgoing_halfedge(v),
                                        [&](std::uint32_t h, double angle) { angle_[h] = angle; }));
  }

  Tangent_vector at_vertex(std::uint32_t v, std::complex<double> z) const {
    return vector_at_source(surface_, surface_.outgoing_halfedge(v), scale_[v], z);
  }

  // The vectors at the corners of a face, `at(v)`, in its frame, averaged with the weights of a
  // point. Each corner stands for `degree` vectors at equal angles: their common powers are
  // averaged, and one root is returned.
  template <class At>
  Unscaled_vector in_face(const Surface_point& p, const At& at, unsigned degree = 1) const {
    const Geodesic_face face(surface_, p.halfedge);
    const double n = degree;
    std::complex<double> sum = 0;
    for (unsigned k = 0; k < 3; ++k) {
      const std::uint32_t v = surface_.source(face.side[k]);
      const std::complex<double> z = at(v);
      const double turn = std::remainder(angle(v, z) - angle_[face.side[k]],
                                         2 * std::numbers::pi / (n * scale_[v]));
      const Plane_vector<double> x = face.from_relative_to(k, {std::cos(turn), std::sin(turn)});
      sum += p.weights[k] * std::abs(z) * std::polar(1., n * std::atan2(x[1], x[0]));
    }
    const std::complex<double> root = std::polar(std::abs(sum), std::arg(sum) / n);
    return {root.real(), root.imag()};
  }

  // the polar angle of a halfedge at its source
  double polar_angle(std::uint32_t h) const { return scale_[surface_.source(h)] * angle_[h]; }
  // the polar angle of a vector at corner `k` of the face of its point
  double polar_angle(const Tangent_vector& v, unsigned k) const {
    const Geodesic_face face(surface_, v.point.halfedge);
    const Unscaled_vector r = face.relative_to(k, v.vector);
    return scale_[surface_.source(face.side[k])] * (angle_[face.side[k]] + std::atan2(r[1], r[0]));
  }

private:
  // on the surface, from the first halfedge
  double angle(std::uint32_t v, std::complex<double> z) const {
    const double a = std::arg(z);
    return (a < 0 ? a + 2 * std::numbers::pi : a) / scale_[v];
  }

  const Surface& surface_;
  std::vector<double> scale_; // per vertex: from angles on the surface to polar angles
  std::vector<double> angle_; // per halfedge: on the surface, from the first one at its source
};

template <class Triangulation>
bool is_isolated(const Triangulation& t, typename Triangulation::vertex_descriptor v) {
  return halfedge(v, t.mesh()) ==
         boost::graph_traits<typename Triangulation::Mesh>::null_halfedge();
}

// The frames at the vertices of an intrinsic triangulation; its `view` must outlive them.
template <class Triangulation>
Vertex_frames<Intrinsic_view<Triangulation>>
intrinsic_frames(const Triangulation& t, const Intrinsic_view<Triangulation>& view) {
  Vertex_frames<Intrinsic_view<Triangulation>> frames(view, t.numbers().vertex_capacity(t.mesh()),
                                                      2 * t.numbers().edge_capacity(t.mesh()));
  for (const auto v : vertices(t.mesh()))
    if (!is_isolated(t, v)) frames.measure(t.index(v));
  return frames;
}

} // namespace internal

/*!
\brief takes a vector from the polar coordinates of a vertex, those of a `Tangent_field`, to the
face that it points into. A vector that points out of the surface is in the frame of the first face,
and points out of it.
\tparam Triangulation a model of `NumberedTriangulation`
\param t the triangulation
\param v the vertex, which is not isolated
\param z the vector
\complexity linear in the degree
*/
template <NumberedTriangulation Triangulation>
Tangent_vector tangent_vector(const Triangulation& t, typename Triangulation::vertex_descriptor v,
                              const std::complex<double>& z) {
  const Intrinsic_view<Triangulation> view(t);
  const std::uint32_t first = view.outgoing_halfedge(t.index(v));
  const Fan_angle fan = measure_fan(view, first, [](std::uint32_t, double) {});
  return internal::vector_at_source(view, first, internal::polar_scale(fan), z);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_VERTEX_FRAMES_H
