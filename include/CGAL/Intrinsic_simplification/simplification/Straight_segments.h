// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_STRAIGHT_SEGMENTS_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_STRAIGHT_SEGMENTS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_to_target.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Finds straight segments from a point to another one near it: the shortest, and others that are
// short. Faces are unfolded across their sides as far as the point sees through them.
// \tparam Surface a model of `NumberedComplex` with lengths
template <class Surface>
class Straight_segments {
  using Vector = Plane_vector<double>;

public:
  struct Segment {
    std::uint32_t halfedge; // the first side of the face in which the segment begins
    Vector vector;          // in the frame of that side
  };

  explicit Straight_segments(const Surface& surface) : surface_(surface) {}

  // \param from the point; at a vertex, the source of its halfedge
  // \param short_length all segments up to this length are asked for, and the shortest one
  // \param reach segments that are longer are not looked for
  // \return none if there are none, or if they are not found in `most_windows` faces; a segment
  //   along a side is found from both faces
  const std::vector<Segment>& find(const Surface_point& from, const Geodesic_target& to,
                                   double short_length, double reach) {
    windows_.clear();
    found_.clear();
    short_length_ = short_length;
    reach_ = std::max(reach, short_length);
    const bool is_vertex = from.weights[0] == 1;
    const std::uint32_t first =
        is_vertex ? surface_.outgoing_halfedge(surface_.source(from.halfedge)) : from.halfedge;
    std::uint32_t h = first;
    do { // all faces at a vertex
      if (surface_.is_border(h)) break;
      start(h, from.weights, to, is_vertex);
      h = is_vertex ? next_around_source(surface_, h) : first;
    } while (h != first);
    for (std::size_t n = 0; n < windows_.size() && n < most_windows; ++n)
      if (squared_distance(windows_[n]) < reach_ * reach_) enter(windows_[n], to);
    std::erase_if(found_,
                  [&](const Segment& s) { return std::sqrt(squared_norm(s.vector)) > reach_; });
    return found_;
  }

private:
  // Faces near a vertex of high degree, of which a segment crosses few: so this ends.
  static constexpr std::size_t most_windows = 4096;
  // Lines through corners count for both sides, up to this angle.
  static constexpr double rounding = 0x1p-40;

  // A side that the point sees, from its right end to its left one, with the face before it on its
  // left; it sees only what is between two directions.
  struct Window {
    std::uint32_t side, frame;
    Vector right, left, right_bound, left_bound;
  };

  static double squared_norm(const Vector& v) { return dot(v, v); }
  static bool is_left_of(const Vector& bound, const Vector& v) {
    const double limit = rounding * rounding * squared_norm(bound) * squared_norm(v);
    const double c = cross(bound, v);
    return c >= 0 || c * c <= limit;
  }
  static double squared_distance(const Window& w) {
    const Vector along = w.left - w.right;
    const double s = squared_norm(along), t = -dot(w.right, along);
    if (!(t > 0)) return squared_norm(w.right);
    if (!(t < s)) return squared_norm(w.left);
    const double c = cross(w.right, along);
    return c * c / s;
  }

  void offer(std::uint32_t frame, const Vector& v) {
    const double length = std::sqrt(squared_norm(v));
    if (!(length > rounding * std::min(short_length_, reach_) && length <= reach_))
      return; // not the point itself
    reach_ = std::max(length, short_length_);
    found_.push_back({frame, v});
  }

  // the face in which the point is; at a vertex only the side across can be left through
  void start(std::uint32_t h, const std::array<double, 3>& weights, const Geodesic_target& to,
             bool is_vertex) {
    const Geodesic_face face(surface_, h);
    std::array<Vector, 3> corner;
    for (unsigned k = 0; k < 3; ++k)
      corner[k] = face.to_corner(is_vertex ? std::array<double, 3>{1, 0, 0} : weights, k);
    to.for_each_place(surface_, face, [&](const std::array<double, 3>& w, unsigned) {
      offer(h, w[0] * corner[0] + w[1] * corner[1] + w[2] * corner[2]);
    });
    for (unsigned k = 0; k < 3; ++k)
      if (!is_vertex || k == 1)
        push({face.side[k], h, corner[k], corner[(k + 1) % 3], corner[k], corner[(k + 1) % 3]});
  }

  void push(const Window& w) {
    if (!surface_.is_border(w.side ^ 1U)) windows_.push_back(w);
  }

  // the face behind a side
  void enter(const Window w, const Geodesic_target& to) { // a copy: windows are added
    const Geodesic_face face(surface_, w.side ^ 1U);
    const Vector axis = w.right - w.left; // along the first side of the face
    const double squared = squared_norm(axis);
    if (!(squared > 0)) return;
    const auto place = [&](const Vector& in_frame) {
      return w.left + axis * in_frame / std::sqrt(squared);
    };
    const Vector apex = place(Vector{0, 0} - face.edge[2]);
    to.for_each_place(surface_, face, [&](const std::array<double, 3>& x, unsigned) {
      const Vector p = x[0] * w.left + x[1] * w.right + x[2] * apex;
      if (is_left_of(w.right_bound, p) && is_left_of(p, w.left_bound)) offer(w.frame, p);
    });
    if (is_left_of(w.right_bound, apex)) {
      const Vector left = is_left_of(apex, w.left_bound) ? apex : w.left_bound;
      push({face.side[1], w.frame, w.right, apex, w.right_bound, left});
    }
    if (is_left_of(apex, w.left_bound)) {
      const Vector right = is_left_of(w.right_bound, apex) ? apex : w.right_bound;
      push({face.side[2], w.frame, apex, w.left, right, w.left_bound});
    }
  }

  const Surface& surface_;
  std::vector<Window> windows_;
  std::vector<Segment> found_;
  double short_length_ = 0, reach_ = std::numeric_limits<double>::infinity();
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_STRAIGHT_SEGMENTS_H
