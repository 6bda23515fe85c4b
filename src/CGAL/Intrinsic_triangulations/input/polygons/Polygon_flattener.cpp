// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/formulas/Space_vector.h>
#include <CGAL/Intrinsic_triangulations/input/polygons/Point_kernel.h>
#include <CGAL/Intrinsic_triangulations/input/polygons/Polygon_flattener.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numbers>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*
Finds the closed polygon in the plane with given lengths of sides whose exterior angles t_i are
nearest to given ones: it minimizes the sum of (theta_i - theta_{i-1} - t_i)^2 / 2 over the
directions theta_i of the sides, where

    sum l_i (cos theta_i, sin theta_i) = 0,

and directions turn by 2 pi in all. Newton's method on the Lagrangian function: with one direction
fixed, its matrix is tridiagonal but for the two multipliers. Where that is not positive definite,
the part of the multipliers is left out, and steps are shortened until an exact penalty function
decreases. \complexity linear in the number of sides, for each step
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
  // Newton's steps square the error, so that ten reach rounding from anywhere near; a polygon that
  // needs a hundred is left as it is. A billionth of a step is rounding.
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
  // right sides of the tridiagonal system, and solutions: of the gradient, and of the two
  // constraints
  std::vector<std::array<double, 3>> columns_;
  std::vector<double> upper_;
  Pair multiplier_{};
  double penalty_ = 0;
};

double Nearest_angles::change(std::size_t i) const {
  const std::size_t n = lengths_.size();
  return i == 0 ? directions_[0] - directions_[n - 1] + 2 * std::numbers::pi - targets_[0]
                : directions_[i] - directions_[i - 1] - targets_[i];
}

Nearest_angles::Pair Nearest_angles::gap() const {
  Pair sum{0, 0};
  for (std::size_t i = 0; i < lengths_.size(); ++i) {
    sum[0] += lengths_[i] * std::cos(directions_[i]);
    sum[1] += lengths_[i] * std::sin(directions_[i]);
  }
  return sum;
}

double Nearest_angles::merit() const {
  double sum = 0;
  for (std::size_t i = 0; i < lengths_.size(); ++i) sum += change(i) * change(i) / 2;
  const Pair c = gap();
  return sum + penalty_ * (std::abs(c[0]) + std::abs(c[1]));
}

// The rows of directions 1 to n - 1 are -x_{i-1} + (2 + w_i) x_i - x_{i+1}, with w_i = -l_i (m .
// e^(i theta_i)) for the multipliers m.
bool Nearest_angles::eliminate(bool is_newton) {
  const std::size_t n = lengths_.size();
  columns_.assign(n, {0, 0, 0});
  upper_.assign(n, 0);
  for (std::size_t i = 1; i < n; ++i) {
    const double x = lengths_[i] * std::cos(directions_[i]),
                 y = lengths_[i] * std::sin(directions_[i]);
    const double w = is_newton ? -multiplier_[0] * x - multiplier_[1] * y : 0;
    // no minimum, or so flat that half of the digits are lost
    const double pivot = 2 + w + upper_[i - 1];
    if (!(pivot > 1e-8)) return false;
    const double gradient = change(i) - change((i + 1) % n);
    columns_[i] = {-gradient, -y, x};
    for (std::size_t k = 0; k < 3; ++k)
      columns_[i][k] = (columns_[i][k] + columns_[i - 1][k]) / pivot;
    upper_[i] = -1 / pivot;
  }
  for (std::size_t i = n - 1; i-- > 1;)
    for (std::size_t k = 0; k < 3; ++k) columns_[i][k] -= upper_[i] * columns_[i + 1][k];
  return true;
}

bool Nearest_angles::find_step(bool is_newton) {
  if (!eliminate(is_newton)) return false;
  Pair rhs = gap();
  std::array<Pair, 2> m{};
  for (std::size_t i = 1; i < lengths_.size(); ++i) {
    const Pair row{-lengths_[i] * std::sin(directions_[i]), lengths_[i] * std::cos(directions_[i])};
    for (std::size_t k = 0; k < 2; ++k) {
      rhs[k] += row[k] * columns_[i][0];
      for (std::size_t j = 0; j < 2; ++j) m[k][j] += row[k] * columns_[i][j + 1];
    }
  }
  // the squared distance of the sides from one line, relative to their squared length
  const double determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
  if (!(determinant > 1e-20 * (m[0][0] + m[1][1]) * (m[0][0] + m[1][1]))) return false;
  multiplier_ = {(rhs[0] * m[1][1] - rhs[1] * m[0][1]) / determinant,
                 (rhs[1] * m[0][0] - rhs[0] * m[1][0]) / determinant};
  step_.assign(lengths_.size(), 0);
  for (std::size_t i = 1; i < lengths_.size(); ++i)
    step_[i] = columns_[i][0] - multiplier_[0] * columns_[i][1] - multiplier_[1] * columns_[i][2];
  return true;
}

double Nearest_angles::take_step() {
  double longest = 0, slope = 0;
  for (std::size_t i = 1; i < step_.size(); ++i) {
    longest = std::max(longest, std::abs(step_[i]));
    slope += step_[i] * (change(i) - change((i + 1) % step_.size()));
  }
  const Pair c = gap();
  // above the multipliers, so that the penalty is exact (Han 1977); positive also where they vanish
  penalty_ =
      std::max(penalty_, 2 * std::max(std::abs(multiplier_[0]), std::abs(multiplier_[1])) + 1e-3);
  slope -= penalty_ * (std::abs(c[0]) + std::abs(c[1]));
  const std::vector<double> before = directions_;
  const double old = merit();
  double part = 1;
  for (int halvings = 0; halvings <= maximal_halvings; ++halvings, part /= 2) {
    for (std::size_t i = 0; i < step_.size(); ++i) directions_[i] = before[i] + part * step_[i];
    // short steps are Newton's: they need no shortening, and rounding would not let the penalty
    // decrease; 1e-4 is the usual part of the slope in the condition of Armijo
    if (longest < 1e-3 || merit() <= old + 1e-4 * part * slope) break;
  }
  return longest;
}

bool Nearest_angles::run(const std::vector<double>& start) {
  double excess = -2 * std::numbers::pi;
  for (const double t : start) excess += t;
  directions_.assign(start.size(), 0);
  for (std::size_t i = 1; i < start.size(); ++i)
    directions_[i] = directions_[i - 1] + start[i] - excess / static_cast<double>(start.size());
  multiplier_ = {0, 0};
  penalty_ = 0;
  for (int i = 0; i < maximal_steps; ++i) {
    if (!find_step(true) && !find_step(false)) return false;
    // the error after a step of Newton is about the square of the step
    if (take_step() > 1e-10) continue;
    const Pair c = gap();
    return std::hypot(c[0], c[1]) < 1e-13;
  }
  return false;
}

double Nearest_angles::largest_change() const {
  double largest = 0;
  for (std::size_t i = 0; i < lengths_.size(); ++i)
    largest = std::max(largest, std::abs(change(i)));
  return largest;
}

// from the first point, scaled
std::vector<Polygon_flattener::Point> moved(const std::vector<Polygon_flattener::Point>& points,
                                            int exponent) {
  std::vector<Polygon_flattener::Point> result(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      result[i][k] = std::scalbn(points[i][k], -exponent) - std::scalbn(points[0][k], -exponent);
  return result;
}

// twice the vector area
Polygon_flattener::Point vector_area(const std::vector<Polygon_flattener::Point>& p) {
  Polygon_flattener::Point sum{};
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Polygon_flattener::Point c = cross_product(p[i], p[(i + 1) % p.size()]);
    for (std::size_t k = 0; k < 3; ++k) sum[k] += c[k];
  }
  return sum;
}

bool is_exactly_planar(const std::vector<Polygon_flattener::Point>& points) {
  const auto point = [&](std::size_t i) {
    return Point_kernel::Point_3(points[i][0], points[i][1], points[i][2]);
  };
  const Point_kernel::Are_collinear are_collinear;
  const Point_kernel::Find_orientation orientation;
  std::size_t a = 1, b = 2;
  while (a < points.size() && points[a] == points[0]) ++a;
  if (a == points.size()) return true;
  while (b < points.size() && are_collinear(point(0), point(a), point(b))) ++b;
  for (std::size_t i = 1; b < points.size() && i < points.size(); ++i)
    if (orientation(point(0), point(a), point(b), point(i)) != CGAL::COPLANAR) return false;
  return true;
}

bool Polygon_flattener::is_planar(const std::vector<Point>& points) {
  const int exponent = exponent_of_extent(points);
  const std::vector<Point> p = moved(points, exponent);
  const Point normal = vector_area(p);
  const double length = norm(normal);
  double largest = 0, low = 0, high = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (const double x : points[i])
      largest = std::max(largest, std::abs(std::scalbn(x, -exponent)));
    const double height = inner_product(p[i], normal);
    low = std::min(low, height);
    high = std::max(high, height);
  }
  if (high - low <= 0x1p-50 * largest * length && length > 0x1p-20) return true;
  return is_exactly_planar(points);
}

bool Polygon_flattener::measure(const std::vector<Point>& points) {
  exponent_ = exponent_of_extent(points);
  const std::vector<Point> p = moved(points, exponent_);
  const std::size_t n = p.size();
  normal_ = vector_area(p);
  const double area = norm(normal_);
  if (!(area > 0x1p-40)) return false;
  for (double& x : normal_) x /= area;
  sides_.resize(n);
  lengths_.resize(n);
  targets_.resize(n);
  perimeter_ = 0;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < 3; ++k) sides_[i][k] = p[(i + 1) % n][k] - p[i][k];
    lengths_[i] = norm(sides_[i]);
    if (lengths_[i] == 0) return false;
    perimeter_ += lengths_[i];
  }
  for (double& l : lengths_) l /= perimeter_;
  for (std::size_t i = 0; i < n; ++i) {
    const Point &before = sides_[(i + n - 1) % n], &after = sides_[i];
    const Point c = cross_product(before, after);
    const double angle = std::atan2(norm(c), inner_product(before, after));
    targets_[i] = inner_product(c, normal_) < 0 ? -angle : angle;
  }
  return true;
}

std::vector<double> Polygon_flattener::projected_angles() const {
  std::vector<double> result;
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const Point &before = sides_[(i + sides_.size() - 1) % sides_.size()], &after = sides_[i];
    result.push_back(std::atan2(inner_product(cross_product(before, after), normal_),
                                inner_product(before, after) - inner_product(before, normal_) *
                                                                   inner_product(after, normal_)));
  }
  return result;
}

void Polygon_flattener::place(const std::vector<double>& directions) {
  corners_.assign(1, {0, 0});
  for (std::size_t i = 0; i + 1 < directions.size(); ++i) {
    const double length = lengths_[i] * perimeter_;
    corners_.push_back({corners_[i][0] + length * std::cos(directions[i]),
                        corners_[i][1] + length * std::sin(directions[i])});
  }
  for (Planar_point& p : corners_)
    for (double& x : p) x = std::scalbn(x, exponent_);
}

bool Polygon_flattener::run(const std::vector<Point>& points) {
  if (!measure(points)) return false;
  Nearest_angles angles(lengths_, targets_);
  if (!angles.run(targets_) && !angles.run(projected_angles())) return false;
  place(angles.directions());
  largest_angle_change_ = angles.largest_change();
  return true;
}

} // namespace CGAL::Intrinsic_triangulations::internal
