// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRACING_GEODESIC_WALK_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRACING_GEODESIC_WALK_H

#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numbers>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

/// A place where a curve crosses from a face into another.
struct Geodesic_crossing {
  std::uint32_t halfedge; ///< the halfedge of the face that the curve leaves
  double parameter;       ///< 0 at the source of the halfedge, 1 at its target
};

namespace internal {

/*!
\brief is a straight line on its way through the faces of a surface: the common steps of all tracing
algorithms (§2.4.2 of the course).

The weights of the point of entry and a unit vector give the line in the frame of the current face.
The line leaves the face through the side between the corners on its left and on its right, never
through the side of its entry, at a parameter that is a ratio of distances from the line and so lies
between 0 and 1. If the line passes close to a vertex, the remaining angle around it falls with
every face: the walk cannot go back and forth.

`angle_error()` and `position_error()` are first-order bounds on rounding errors of the line. Stored
squared lengths have relative errors u, thus the angle between two sides has error u L / (l l'), L
the greatest of the face; needles make it large.
\tparam Complex a model of `NumberedComplex`
*/
template <NumberedComplex Complex>
class Geodesic_walk {
public:
  /// The way out of the current face.
  struct Exit {
    unsigned side;        ///< 0, 1, 2: the halfedge of the frame, the next, the last
    double source_weight; ///< weight of the source of that side
    double target_weight; ///< weight of its target
    double distance;      ///< from the point of entry
    double slope;         ///< speed at which the line gets away from the side, times its length
  };

  /*!
  \brief starts from a point, in a direction.

  From an edge or a vertex the line may leave the given face at once. At a vertex, a direction that
  points out of the face is measured around the vertex from the nearer side.
  \param complex the surface, which must outlive the walk
  \param p the point
  \param direction a vector in the frame of the halfedge of `p`, not zero, in any units
  */
  template <class Units = void>
  Geodesic_walk(const Complex& complex, const Surface_point& p,
                const Plane_vector<double, Units>& direction)
      : complex_(&complex), face_(complex, p.halfedge), weights_(p.weights),
        direction_(normalized({direction.x, direction.y})) {
    unsigned zeros = 0, corner = 0, edge = 0;
    for (unsigned k = 0; k < 3; ++k) {
      if (weights_[k] > 0) {
        corner = k;
      } else {
        ++zeros;
        edge = (k + 1) % 3;
      }
    }
    if (zeros == 2)
      start_at_corner(corner);
    else if (zeros == 1)
      start_on_side(edge);
  }

  /*!
  \brief starts from a vertex.
  \param complex the surface, which must outlive the walk
  \param d a halfedge, and the angle to turn from it; any number
  */
  Geodesic_walk(const Complex& complex, Corner_direction d)
      : complex_(&complex),
        face_(complex, complex.is_border(d.halfedge) ? d.halfedge ^ 1U : d.halfedge) {
    leave_vertex(d);
  }

  /// tells whether the direction points out of the surface, so that the walk is empty.
  bool is_blocked() const { return is_blocked_; }
  /// returns the face that the line is in.
  const Geodesic_face& face() const { return face_; }
  /// returns the weights of the point where the line entered the face, or starts in it.
  const std::array<double, 3>& weights() const { return weights_; }
  /// returns the unit vector along the line, in the frame of the face.
  const Plane_vector<double>& direction() const { return direction_; }
  /// returns the length of the line up to the face.
  double travelled() const { return travelled_; }
  /// returns a bound on the error of the direction.
  double angle_error() const { return angle_error_; }
  /// returns a bound on the distance between the entry and the point where it should be.
  double position_error() const { return position_error_; }

  /// returns how far a point of the face is along the line and to the left of it, seen from the
  /// entry, given the vector to it.
  Plane_vector<double> relative(const Plane_vector<double>& v) const {
    return in_frame(direction_, v);
  }
  /// returns the same for a corner.
  Plane_vector<double> relative_corner(unsigned corner) const {
    return relative(face_.to_corner(weights_, corner));
  }

  /// finds the way out of the face.
  Exit exit() const {
    std::array<Plane_vector<double>, 3> c;
    for (unsigned k = 0; k < 3; ++k) c[k] = relative_corner(k);
    unsigned s = 1;
    if (origin_ == Origin::side) {
      s = c[2][1] >= 0 ? 1 : 2;
    } else if (origin_ ==
               Origin::inside) { // the side whose source is right of the line, target left
      double best = -1;
      for (unsigned k = 0; k < 3; ++k) {
        const double sign = std::min(-c[k][1], c[(k + 1) % 3][1]);
        if (k == 0 || sign > best) best = sign, s = k;
      }
    }
    const Plane_vector<double>&a = c[s], &b = c[(s + 1) % 3];
    const double right = std::max(0.0, -a[1]), left = std::max(0.0, b[1]), sum = right + left;
    double target = sum > 0 ? right / sum : 0, source = sum > 0 ? left / sum : 1;
    if (!(sum > 0) && b[0] > a[0]) std::swap(source, target); // the side lies on the line
    return {s, source, target, std::max(0.0, source * a[0] + target * b[0]), sum};
  }

  /// returns the halfedge through which an exit leads.
  std::uint32_t halfedge(const Exit& e) const { return face_.side[e.side]; }

  /// returns the point at a distance from the entry. \pre `0 <= distance <= e.distance`
  Surface_point point(const Exit& e, double distance) const {
    const double s = e.distance > 0 ? std::min(1.0, distance / e.distance) : 1.0;
    Surface_point p{face_.side[0], weights_};
    for (double& w : p.weights) w *= 1 - s;
    p.weights[e.side] += s * e.source_weight;
    p.weights[(e.side + 1) % 3] += s * e.target_weight;
    return p;
  }

  /// moves to the exit, without entering the next face: the errors become those there.
  void advance(const Exit& e) {
    const double greatest = *std::max_element(face_.length.begin(), face_.length.end());
    const double l = face_.length[e.side];
    if (l > 0 && face_.length[0] > 0)
      angle_error_ += 4 * unit * greatest * greatest / (l * face_.length[0]);
    position_error_ += angle_error_ * e.distance + 2 * unit * greatest;
    travelled_ += e.distance;
  }

  /// enters the face beyond an exit. \pre there is one
  void cross(const Exit& e) {
    const double along = dot(direction_, face_.edge[e.side]);
    face_ = Geodesic_face(*complex_, face_.side[e.side] ^ 1U);
    direction_ = normalized({-along, e.slope});
    weights_ = {e.target_weight, e.source_weight, 0};
    origin_ = Origin::side;
  }

  /*!
  \brief goes straight on at a vertex: with equal angles on both sides (§2.4.1).
  \param corner the corner of the face at which the line has arrived, up to rounding
  \return false on the border, where the line ends
  */
  bool pass_vertex(unsigned corner) {
    bool is_on_border = false;
    const std::uint32_t h = face_.side[corner];
    const double all = cone_angle(*complex_, h, is_on_border);
    if (is_on_border) return false;
    const double back = angle_back(corner);
    position_error_ *= 2; // the line was moved to the vertex
    std::uint32_t g = h;
    do {
      angle_error_ += corner_error(g);
      g = next_around_source(*complex_, g);
    } while (g != h);
    leave_vertex({h, back + all / 2});
    return !is_blocked_;
  }

private:
  enum class Origin { inside, side, corner };
  static constexpr double unit = 0x1p-52; // of rounding, in any direction

  static Plane_vector<double> normalized(const Plane_vector<double>& v) {
    const double l = std::hypot(v[0], v[1]);
    if (!(l > 0)) return {0, 1};
    return v / l;
  }

  // The angle from a side at its source counterclockwise to where the line came from. A line that
  // entered through the first side close to one of its ends came from beyond that side.
  double angle_back(unsigned corner) const {
    const double here = angle_at_source(*complex_, face_.side[corner]);
    if (origin_ == Origin::side && corner == 1)
      return here + std::atan2(direction_[1], direction_[0]);
    if (origin_ == Origin::side && corner == 0) return std::atan2(-direction_[1], -direction_[0]);
    const Plane_vector<double> back = face_.relative_to(corner, {-direction_[0], -direction_[1]});
    return std::clamp(std::atan2(back[1], back[0]), 0.0, here);
  }

  // Bound on the error of the angle at the source of `h`.
  double corner_error(std::uint32_t h) const {
    const auto [ij, jk, ki] = squared_lengths_of_face(*complex_, h);
    return ij > 0 && ki > 0 ? 4 * unit * std::max({ij, jk, ki}) / std::sqrt(ij * ki) : 0;
  }

  void leave_vertex(Corner_direction d) {
    is_blocked_ = !turn(*complex_, d);
    if (complex_->is_border(d.halfedge)) d = {d.halfedge ^ 1U, 0}; // blocked
    face_ = Geodesic_face(*complex_, d.halfedge);
    weights_ = {1, 0, 0};
    direction_ = {std::cos(d.angle), std::sin(d.angle)};
    origin_ = Origin::corner;
  }

  void start_at_corner(unsigned corner) {
    const std::uint32_t h = face_.side[corner];
    const Plane_vector<double> v = face_.relative_to(corner, direction_);
    double angle = std::atan2(v[1], v[0]);
    const double here = angle_at_source(*complex_, h), full = 2 * std::numbers::pi;
    if (angle < 0 && angle + full - here < -angle) angle += full;
    const Surface_point start{face_.side[0], weights_};
    const Plane_vector<double> direction = direction_;
    leave_vertex({h, angle});
    if (is_blocked_) { // stays as it was
      face_ = Geodesic_face(*complex_, start.halfedge);
      weights_ = start.weights;
      direction_ = direction;
    }
  }

  void start_on_side(unsigned s) {
    const Plane_vector<double> v = face_.relative_to(s, direction_);
    const std::array<double, 3> w{weights_[s], weights_[(s + 1) % 3], 0};
    if (v[1] >= 0) {
      face_ = Geodesic_face(*complex_, face_.side[s]);
      weights_ = w;
      direction_ = normalized(v);
      origin_ = Origin::side;
    } else if (complex_->is_border(face_.side[s] ^ 1U)) {
      is_blocked_ = true;
    } else {
      face_ = Geodesic_face(*complex_, face_.side[s] ^ 1U);
      weights_ = {w[1], w[0], 0};
      direction_ = normalized({-v[0], -v[1]});
      origin_ = Origin::side;
    }
  }

  const Complex* complex_;
  Geodesic_face face_;
  std::array<double, 3> weights_{1, 0, 0};
  Plane_vector<double> direction_{1, 0};
  double travelled_ = 0;
  double angle_error_ = 8 * unit;
  double position_error_ = 0;
  Origin origin_ = Origin::inside;
  bool is_blocked_ = false;
};

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRACING_GEODESIC_WALK_H
