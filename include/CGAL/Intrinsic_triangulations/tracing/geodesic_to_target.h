// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRACING_GEODESIC_TO_TARGET_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRACING_GEODESIC_TO_TARGET_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_walk.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/*!
\file
Traces geodesics with a known end: a direction and a length lead close to it, and then the straight
line through the same faces that ends there exactly is proven to stay in them.
*/

namespace CGAL::Intrinsic_triangulations {

/// The known end of a geodesic: a vertex, or a point of a face.
struct Geodesic_target {
  /// The vertex, or `Gluing::none`.
  std::uint32_t vertex = Gluing::none;
  /// Descriptions of the point if it is not a vertex; one on an edge has two.
  std::array<Surface_point, 2> point{Surface_point{Gluing::none, {}},
                                     Surface_point{Gluing::none, {}}};

  /// makes a target of a vertex.
  static Geodesic_target at_vertex(std::uint32_t v) {
    Geodesic_target t;
    t.vertex = v;
    return t;
  }

  /// makes a target of a point that is not a vertex.
  template <NumberedComplex Complex>
  static Geodesic_target at_point(const Complex& complex, const Surface_point& p) {
    Geodesic_target t;
    t.point[0] = p;
    std::uint32_t h = p.halfedge;
    for (std::size_t k = 0; k < 3; ++k, h = complex.next(h))
      if (p.weights[(k + 2) % 3] == 0 && !complex.is_border(h ^ 1U))
        t.point[1] = {h ^ 1U, {p.weights[(k + 1) % 3], p.weights[k], 0}};
    return t;
  }

  /*!
  \brief calls a function with the weights of the target for each time that a face contains it.
  \param complex the surface
  \param face a face
  \param f takes an array of three weights, and the number of the side of the face that the target
  is described from
  */
  template <NumberedComplex Complex, class Function>
  void for_each_place(const Complex& complex, const Geodesic_face& face, Function f) const {
    std::array<double, 3> w{0, 0, 0};
    for (unsigned k = 0; k < 3; ++k) {
      if (vertex != Gluing::none) {
        w = {0, 0, 0};
        w[k] = 1;
        if (complex.source(face.side[k]) == vertex) f(w, k);
      } else {
        for (const Surface_point& p : point) {
          for (std::size_t i = 0; i < 3; ++i) w[(k + i) % 3] = p.weights[i];
          if (face.side[k] == p.halfedge) f(w, k);
        }
      }
    }
  }
};

namespace internal {

/// An edge that a traced line crosses: the halfedge of the face left, and where its ends are, along
/// the line and to the left of it.
struct Strip_side {
  std::uint32_t halfedge;      ///< its source is to the right of the line
  Plane_vector<double> source; ///< along the line, and to the left of it
  Plane_vector<double> target; ///< the same for the target

  /// returns where the line from the origin in direction (1, `slope`) crosses: 0 at the source.
  double parameter(double slope) const {
    const double right = std::max(0.0, slope * source[0] - source[1]);
    const double left = std::max(0.0, target[1] - slope * target[0]), sum = right + left;
    return sum > 0 ? right / sum : 0.5;
  }
};

/// The straight line of a geodesic to its target.
struct Geodesic_to_target {
  /// Whether a straight line through the faces ends at the target.
  bool is_reached = false;
  /// Whether this is certain: no vertex is as close to the line as its error.
  bool is_certain = false;
  /// The side of the face that the whole line lies on, or `Gluing::none`. It starts at the source
  /// of the halfedge, or nearer to it than it ends.
  std::uint32_t along = Gluing::none;
  /// Slope of the straight line in relation to the direction that was given.
  double slope = 0;
  /// Length of the straight line.
  double length = 0;
  /// The halfedge that describes the target: that of the `Geodesic_target`, its opposite, or one
  /// that starts at the vertex.
  std::uint32_t end = Gluing::none;
  /// Unit vector along the straight line, in the frame of `end`.
  Plane_vector<double> direction{1, 0};
};

template <NumberedComplex Complex>
class Target_tracer {
public:
  Target_tracer(const Complex& complex, const Geodesic_target& target, double length,
                std::vector<Strip_side>& strip)
      : complex_(complex), target_(target), length_(length), strip_(strip) {}

  Geodesic_to_target trace(Geodesic_walk<Complex> walk, std::size_t maximum_faces) {
    strip_.clear();
    if (walk.is_blocked()) return {};
    const std::array<double, 3> start = walk.weights();
    for (std::size_t faces = 0; faces < maximum_faces; ++faces) {
      if (arrive(walk)) return straighten(walk, start);
      const typename Geodesic_walk<Complex>::Exit e = walk.exit();
      if (walk.travelled() > length_ + tolerance(walk)) return {};
      const std::uint32_t out = walk.halfedge(e);
      if (complex_.is_border(out ^ 1U)) return {};
      strip_.push_back({out, place(walk, e.side), place(walk, (e.side + 1) % 3)});
      walk.advance(e);
      walk.cross(e);
    }
    return {};
  }

private:
  // of direction and length that were given, of the walk, and of the weights of start and target
  double tolerance(const Geodesic_walk<Complex>& walk) const {
    const std::array<double, 3>& l = walk.face().length;
    const double rounding = 4 * walk.position_error() + 0x1p-48 * std::max({l[0], l[1], l[2]});
    return std::min(0x1p-4 * length_, std::max(0x1p-20 * length_, rounding));
  }

  Plane_vector<double> place(const Geodesic_walk<Complex>& walk, unsigned corner) const {
    const Plane_vector<double> r = walk.relative_corner(corner);
    return {walk.travelled() + r[0], r[1]};
  }

  // whether the target is in the face, where the line ends
  bool arrive(const Geodesic_walk<Complex>& walk) {
    double best = tolerance(walk);
    bool is_there = false;
    target_.for_each_place(complex_, walk.face(),
                           [&](const std::array<double, 3>& w, unsigned side) {
                             Plane_vector<double> v{0, 0};
                             for (unsigned k = 0; k < 3; ++k) {
                               if (w[k] == 0) continue;
                               v = v + w[k] * walk.relative_corner(k);
                             }
                             v[0] += walk.travelled();
                             const double off = std::hypot(v[0] - length_, v[1]);
                             if (!(off <= best)) return;
                             best = off;
                             is_there = true;
                             end_ = v;
                             end_weights_ = w;
                             end_side_ = side;
                           });
    return is_there;
  }

  Geodesic_to_target straighten(const Geodesic_walk<Complex>& walk,
                                const std::array<double, 3>& start) const {
    Geodesic_to_target result;
    result.length = std::hypot(end_[0], end_[1]);
    if (!(end_[0] > 0)) return result;
    result.slope = end_[1] / end_[0];
    double clearance = length_; // of the vertices on both sides
    for (const Strip_side& s : strip_)
      clearance = std::min({clearance, result.slope * s.source[0] - s.source[1],
                            s.target[1] - result.slope * s.target[0]});
    result.is_reached = clearance >= 0;
    result.is_certain = clearance > walk.position_error();
    result.end = walk.face().side[end_side_];
    result.direction = walk.face().relative_to(end_side_, end_ / result.length * walk.direction());
    if (strip_.empty()) along_side(walk, start, result);
    return result;
  }

  void along_side(const Geodesic_walk<Complex>& walk, const std::array<double, 3>& start,
                  Geodesic_to_target& result) const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (start[(k + 2) % 3] != 0 || end_weights_[(k + 2) % 3] != 0) continue;
      const std::uint32_t side = walk.face().side[k];
      result.along = end_weights_[(k + 1) % 3] > start[(k + 1) % 3] ? side : side ^ 1U;
    }
  }

  const Complex& complex_;
  const Geodesic_target& target_;
  double length_;
  std::vector<Strip_side>& strip_;
  Plane_vector<double> end_{0, 0};
  std::array<double, 3> end_weights_{0, 0, 0};
  unsigned end_side_ = 0;
};

/*!
\brief traces a geodesic to a known target, despite errors of direction and length.

Where the line comes close to the target, it is replaced by the straight line through the same faces
that ends at the target. It accepts that line if all vertices of the faces are on their sides of it.
Since the line has nearly the same direction and length, it is the geodesic, unless a vertex is so
close to it that rounding hides the side: then the result is not certain.
\tparam Complex a model of `NumberedComplex`
\param complex the surface
\param walk the start
\param target the end
\param length the length
\param strip becomes the edges that are crossed, in order; the line has the slope that is returned
\param maximum_faces number of faces after which to give up
\return what was found
\complexity linear in the number of crossings
*/
template <NumberedComplex Complex>
Geodesic_to_target trace_to_target(const Complex& complex, const Geodesic_walk<Complex>& walk,
                                   const Geodesic_target& target, double length,
                                   std::vector<Strip_side>& strip,
                                   std::size_t maximum_faces = std::size_t{1} << 22U) {
  return Target_tracer<Complex>(complex, target, length, strip).trace(walk, maximum_faces);
}

extern template Geodesic_to_target trace_to_target(const Input&, const Geodesic_walk<Input>&,
                                                   const Geodesic_target&, double,
                                                   std::vector<Strip_side>&, std::size_t);

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRACING_GEODESIC_TO_TARGET_H
