// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_VECTORS_POINT_FRAMES_H
#define CGAL_INTRINSIC_OPERATORS_VECTORS_POINT_FRAMES_H

#include <CGAL/Intrinsic_operators/operators/Connection_graph.h>
#include <CGAL/Intrinsic_triangulations/connectivity/for_each_outgoing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Vertex_copies.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Moves a point at a vertex into the face, where directions are those of the plane.
inline Surface_point off_vertex(const Surface_point& p) {
  const unsigned k = corner_of(p);
  if (k == 3) return p;
  Surface_point result{p.halfedge, {0x1p-10, 0x1p-10, 0x1p-10}};
  result.weights[k] = 1 - 0x1p-9;
  return result;
}

// The frames in which solvers diffuse vectors: those of a `Tangent_field`, except that angles at
// border vertices are not scaled.
template <class Triangulation>
class Point_frames {
  using Vertex = typename Triangulation::vertex_descriptor;
  using Halfedge = typename Triangulation::halfedge_descriptor;

public:
  explicit Point_frames(const Triangulation& t)
      : t_(&t), copies_(t), angles_(t, Border_angles::as_they_are), on_border_(copies_.size(), 0) {
    for (const Vertex v : vertices(t.mesh()))
      if (!is_isolated(v)) on_border_[copies_(v)] = angle_on_border(v);
  }

  const Triangulation& triangulation() const { return *t_; }
  const Halfedge_angles& angles() const { return angles_; }
  std::size_t size() const { return copies_.size(); }
  std::uint32_t number(Vertex v) const { return copies_(v); }
  bool is_isolated(Vertex v) const {
    return halfedge(v, t_->mesh()) ==
           boost::graph_traits<typename Triangulation::Mesh>::null_halfedge();
  }

  // A vector of a `Tangent_field` in the frame here, and back. On the border half a circle has the
  // vectors that point into the surface, the other half all others.
  std::complex<double> from_field(std::uint32_t i, const std::complex<double>& z) const {
    return on_border_[i] == 0 ? z : turned(z, std::numbers::pi, on_border_[i]);
  }
  std::complex<double> to_field(std::uint32_t i, const std::complex<double>& z) const {
    return on_border_[i] == 0 ? z : turned(z, on_border_[i], std::numbers::pi);
  }

  // A corner of the face of a point, and how directions at the point turn on the way to it.
  struct Corner {
    std::uint32_t vertex;        // its number
    double weight;               // of the point; all sum to 1
    std::complex<double> offset; // from the point to here, in its frame
    double scale;                // of angles on the surface
    double angle, polar_angle;   // of the direction from here to the point: in its frame, and here

    // A vector at the point, in the frame here, and back: angles from the line between both are
    // scaled.
    std::complex<double> to_here(const std::complex<double>& z) const {
      const double turn = std::remainder(std::arg(z) - angle, full_turn);
      return std::polar(std::abs(z), polar_angle + scale * turn);
    }
    std::complex<double> from_here(const std::complex<double>& z) const {
      const double turn = std::remainder(std::arg(z) - polar_angle, full_turn);
      return std::polar(std::abs(z), angle + turn / scale);
    }
  };

  // The corners of the face that have a weight, up to three; they are the same for all faces of a
  // point. At a vertex the middle of the corner is the line.
  std::vector<Corner> corners(const Surface_point& p) const {
    const Intrinsic_view<Triangulation> view(*t_);
    const Geodesic_face face(view, p.halfedge);
    std::vector<Corner> result;
    for (unsigned k = 0; k < 3; ++k) {
      if (p.weights[k] == 0) continue;
      const Plane_vector<double> x = face.to_corner(p.weights, k);
      const Plane_vector<double> back = face.relative_to(k, {-x[0], -x[1]});
      const double here = angle_at_source(view, face.side[k]), scale = angles_.scale(face.side[k]);
      const double turn =
          corner_of(p) == k ? here / 2 : std::clamp(std::atan2(back[1], back[0]), 0., here);
      result.push_back({number(t_->numbers().vertex_at(view.source(face.side[k]))), p.weights[k],
                        std::complex(x[0], x[1]), scale,
                        std::atan2(face.edge[k][1], face.edge[k][0]) + turn,
                        angles_[face.side[k]] + scale * turn});
    }
    return result;
  }

  // A vector at the vertex where a point is, in the frame here, and back.
  std::complex<double> at_corner(const Surface_point& p, const Unscaled_vector& v) const {
    return corners(p)[0].to_here({v[0], v[1]});
  }
  std::complex<double> from_corner(const Surface_point& p, const std::complex<double>& z) const {
    return corners(p)[0].from_here(z);
  }

  // a map with values in the frame of a point, linear in the face of another one
  std::complex<double> interpolated(const std::vector<std::complex<double>>& values,
                                    const Surface_point& p, const Surface_point& q) const {
    const Intrinsic_view<Triangulation> view(*t_);
    const Geodesic_face face(view, q.halfedge);
    std::complex<double> sum = 0;
    for (unsigned k = 0; k < 3; ++k)
      sum += q.weights[k] * values[number(t_->numbers().vertex_at(view.source(face.side[k])))];
    if (view.face(p.halfedge) != view.face(q.halfedge)) return sum;
    const Unscaled_vector v = vector_between(view, p, q); // values may be those of ways around
    return {v[0], v[1]};
  }

private:
  static constexpr double full_turn = 2 * std::numbers::pi;

  // the angle that the fan of a border vertex has here, zero inside
  double angle_on_border(Vertex v) const {
    Halfedge last = opposite(halfedge(v, t_->mesh()), t_->mesh());
    for_each_outgoing(v, t_->mesh(), [&last](Halfedge h) { last = h; });
    const bool is_on_border =
        face(last, t_->mesh()) == boost::graph_traits<typename Triangulation::Mesh>::null_face();
    return is_on_border ? angles_[t_->numbers().halfedge(last)] : 0;
  }

  // stretches the angles up to `from` to `to`, and the others to the rest of the circle
  static std::complex<double> turned(const std::complex<double>& z, double from, double to) {
    double a = std::arg(z);
    if (a < 0) a += full_turn;
    a = a <= from ? a * to / from : to + (a - from) * (full_turn - to) / (full_turn - from);
    return std::polar(std::abs(z), a);
  }

  const Triangulation* t_;
  Vertex_copies<Triangulation> copies_;
  Halfedge_angles angles_;
  std::vector<double> on_border_; // by number
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_OPERATORS_VECTORS_POINT_FRAMES_H
