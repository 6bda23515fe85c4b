// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_POLYGON_FLATTENER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_POLYGON_FLATTENER_H

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*
Finds the closed polygon in the plane with given lengths of sides whose exterior angles t_i are nearest to given ones: it
minimizes the sum of (theta_i - theta_{i-1} - t_i)^2 / 2 over the directions theta_i of the sides, where

    sum l_i (cos theta_i, sin theta_i) = 0,

and directions turn by 2 pi in all. Newton's method on the Lagrangian function: with one direction fixed, its matrix is tridiagonal
but for the two multipliers. Where that is not positive definite, the part of the multipliers is left out, and steps are
shortened until an exact penalty function decreases. \complexity linear in the number of sides, for each step
*/
class Nearest_angles {
public:
  // Starts at exterior angles, whose sum becomes 2 pi. \pre lengths are positive, with sum 1
  Nearest_angles(const std::vector<double>& lengths, const std::vector<double>& targets)
      : lengths_(lengths), targets_(targets) {}

  // Returns whether it has converged, which it does for all but polygons near to a segment.
  bool run(const std::vector<double>& start);

  const std::vector<double>& directions() const { return directions_; }
  // of an exterior angle, from what was given
  double largest_change() const;

private:
  static constexpr int maximal_steps = 100, maximal_halvings = 30;

  using Pair = std::array<double, 2>;

  double change(std::size_t i) const;
  Pair gap() const;
  double merit() const;
  // Solves for a step, with the multipliers' part of the matrix or without it.
  bool find_step(bool is_newton);
  bool eliminate(bool is_newton);
  double take_step(); // returns how long it is

  const std::vector<double>&lengths_, &targets_;
  std::vector<double> directions_, step_;
  // right sides of the tridiagonal system, and solutions: of the gradient, and of the two constraints
  std::vector<std::array<double, 3>> columns_;
  std::vector<double> upper_;
  Pair multiplier_{};
  double penalty_ = 0;
};

// Makes a polygon in space planar: its sides keep their lengths, its angles change least.
class Polygon_flattener {
public:
  using Point = std::array<double, 3>;
  using Planar_point = std::array<double, 2>;

  // Whether all points lie in one plane, exactly or so near to it as rounding of coordinates may bring them.
  static bool is_planar(const std::vector<Point>& points);

  // Returns whether there is a result. \pre there are at least four points, not all in one plane
  bool run(const std::vector<Point>& points);

  // in the units of the points, counterclockwise
  const std::vector<Planar_point>& corners() const { return corners_; }
  double largest_angle_change() const { return largest_angle_change_; }
  // of a power of two that is near to the size of the polygon
  int exponent() const { return exponent_; }

private:
  bool measure(const std::vector<Point>& points);
  // the exterior angles of the projection along the vector area
  std::vector<double> projected_angles() const;
  void place(const std::vector<double>& directions);

  std::vector<Point> sides_; // scaled by 2^-exponent_, as all that follows
  Point normal_{};           // the vector area, of length 1
  std::vector<double> lengths_, targets_;
  double perimeter_ = 0;
  int exponent_ = 0;
  std::vector<Planar_point> corners_;
  double largest_angle_change_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/input/Polygon_flattener_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_POLYGON_FLATTENER_H
