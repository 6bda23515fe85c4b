// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/formulas/Space_vector.h>
#include <CGAL/Intrinsic_triangulations/formulas/triangle_formulas.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/input/Planar_polygons.h>
#include <CGAL/Intrinsic_triangulations/input/Point_kernel.h>
#include <CGAL/Intrinsic_triangulations/input/Polygon_shaper.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Projection_traits_3.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

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
  penalty_ =
      std::max(penalty_, 2 * std::max(std::abs(multiplier_[0]), std::abs(multiplier_[1])) + 1e-3);
  slope -= penalty_ * (std::abs(c[0]) + std::abs(c[1]));
  const std::vector<double> before = directions_;
  const double old = merit();
  double part = 1;
  for (int halvings = 0; halvings <= maximal_halvings; ++halvings, part /= 2) {
    for (std::size_t i = 0; i < step_.size(); ++i) directions_[i] = before[i] + part * step_[i];
    // short steps are Newton's: they need no shortening, and rounding would not let the penalty
    // decrease
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

template <class Triangulation>
void mark_outside(Triangulation& plane) {
  for (const auto f : plane.all_face_handles()) f->info() = false;
  std::vector<typename Triangulation::Face_handle> open{plane.infinite_face()};
  open.back()->info() = true;
  while (!open.empty()) {
    const auto f = open.back();
    open.pop_back();
    for (int k = 0; k < 3; ++k)
      if (!f->is_constrained(k) && !f->neighbor(k)->info()) {
        f->neighbor(k)->info() = true;
        open.push_back(f->neighbor(k));
      }
  }
}

void Polygon_triangulator::load(std::vector<Point> points) {
  points_ = std::move(points);
  const Point origin = points_[0];
  const int exponent = exponent_of_extent(points_);
  for (Point& p : points_)
    for (unsigned k = 0; k < 3; ++k) p[k] = std::scalbn(p[k] / 2 - origin[k] / 2, -exponent);
  normal_ = {};
  for (std::size_t i = 2; i < points_.size(); ++i) {
    const Point c = cross(0, i - 1, i);
    for (unsigned k = 0; k < 3; ++k) normal_[k] += c[k];
  }
}

bool Polygon_triangulator::triangulate(std::vector<Triangle>& result) const {
  if (points_.size() == 4) {
    const bool at_0 = inner_product(cross(0, 1, 2), cross(0, 2, 3)) >
                      inner_product(cross(1, 2, 3), cross(1, 3, 0));
    if (at_0)
      result = {{0, 1, 2}, {0, 2, 3}};
    else
      result = {{1, 2, 3}, {1, 3, 0}};
    return true;
  }
  return triangulate_delaunay(result) ||
         triangulate_least_area([](std::size_t, std::size_t) { return true; }, false, result);
}

bool Polygon_triangulator::triangulate_least_area(
    const std::function<bool(std::size_t, std::size_t)>& allowed, bool upright,
    std::vector<Triangle>& result) const {
  const std::size_t n = points_.size();
  if (n > maximal_sides) return false;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> cost(n * n, 0);
  std::vector<std::uint32_t> apex(n * n, 0);
  for (std::size_t width = 2; width < n; ++width)
    for (std::size_t i = 0; i + width < n; ++i) {
      const std::size_t j = i + width;
      double best = infinity;
      if (width == n - 1 || allowed(i, j))
        for (std::size_t k = i + 1; k < j; ++k) {
          const double c = cost[i * n + k] + cost[k * n + j] + weight(i, k, j, upright);
          if (c >= best) continue;
          best = c;
          apex[i * n + j] = static_cast<std::uint32_t>(k);
        }
      const Point diagonal = difference(points_[j], points_[i]);
      cost[i * n + j] = best + 1e-9 * inner_product(diagonal, diagonal);
    }
  if (cost[n - 1] == infinity) return false;
  collect(apex, result);
  return true;
}

double Polygon_triangulator::weight(std::size_t i, std::size_t j, std::size_t k,
                                    bool upright) const {
  const Point c = cross(i, j, k);
  const double against = -inner_product(c, normal_);
  if (upright && against > 1e-9 * inner_product(normal_, normal_))
    return std::numeric_limits<double>::infinity();
  return std::sqrt(inner_product(c, c));
}

void Polygon_triangulator::collect(const std::vector<std::uint32_t>& apex,
                                   std::vector<Triangle>& result) const {
  const std::size_t n = points_.size();
  std::vector<std::pair<std::uint32_t, std::uint32_t>> open{{0, static_cast<std::uint32_t>(n - 1)}};
  result.clear();
  while (!open.empty()) {
    const auto [i, j] = open.back();
    open.pop_back();
    if (j - i < 2) continue;
    const std::uint32_t k = apex[i * n + j];
    result.push_back({i, k, j});
    open.emplace_back(k, j);
    open.emplace_back(i, k);
  }
}

bool Polygon_triangulator::triangulate_delaunay(std::vector<Triangle>& result) const {
  using Traits = CGAL::Projection_traits_3<Point_kernel>;
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Traits>;
  using Info_base = CGAL::Triangulation_face_base_with_info_2<bool, Traits>;
  using Face_base = CGAL::Constrained_triangulation_face_base_2<Traits, Info_base>;
  using Data = CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>;
  using Triangulation =
      CGAL::Constrained_Delaunay_triangulation_2<Traits, Data,
                                                 CGAL::No_constraint_intersection_tag>;
  if (normal_ == Point{}) return false;
  Triangulation plane{Traits(Point_kernel::Vector_3(normal_[0], normal_[1], normal_[2]))};
  std::vector<Triangulation::Vertex_handle> vertices;
  for (const Point& p : points_) {
    vertices.push_back(plane.insert(Point_kernel::Point_3(p[0], p[1], p[2])));
    vertices.back()->info() = static_cast<std::uint32_t>(vertices.size() - 1);
  }
  if (plane.number_of_vertices() != points_.size()) return false;
  try {
    for (std::size_t i = 0; i < vertices.size(); ++i)
      plane.insert_constraint(vertices[i], vertices[(i + 1) % vertices.size()]);
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    return false;
  }
  mark_outside(plane);
  result.clear();
  for (const auto f : plane.finite_face_handles())
    if (!f->info())
      result.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  return orient_disk(result);
}

bool Polygon_triangulator::orient_disk(std::vector<Triangle>& triangles) const {
  const auto n = static_cast<std::uint32_t>(points_.size());
  if (triangles.size() != n - 2) return false;
  using Side = std::pair<std::uint32_t, std::uint32_t>;
  std::vector<Side> sides;
  for (const Triangle& t : triangles)
    for (unsigned k = 0; k < 3; ++k) sides.emplace_back(t[k], t[(k + 1) % 3]);
  std::sort(sides.begin(), sides.end());
  const auto has = [&](std::uint32_t i, std::uint32_t j) {
    return std::binary_search(sides.begin(), sides.end(), Side(i, j));
  };
  const bool reversed = has(1, 0);
  for (std::uint32_t i = 0; i < n; ++i)
    if (has(i, (i + 1) % n) == reversed || has((i + 1) % n, i) != reversed) return false;
  for (const auto& [i, j] : sides)
    if ((j + n - i) % n != 1 && (i + n - j) % n != 1 && !has(j, i)) return false;
  if (std::adjacent_find(sides.begin(), sides.end()) != sides.end()) return false;
  if (reversed)
    for (Triangle& t : triangles) std::swap(t[1], t[2]);
  return true;
}

Polygon_triangulator::Point Polygon_triangulator::cross(std::size_t i, std::size_t j,
                                                        std::size_t k) const {
  return cross_product(difference(points_[j], points_[i]), difference(points_[k], points_[i]));
}

void Polygon_shaper::load(std::vector<Point> points, bool is_simple) {
  is_flattened_ = false;
  if (kind_ == Nonplanar_polygons::planar) {
    points_ = points;
    is_planar_ = Polygon_flattener::is_planar(points);
    is_flattened_ = !is_planar_ && is_simple && flattener_.run(points);
  }
  if (is_flattened_)
    for (std::size_t i = 0; i < points.size(); ++i)
      points[i] = {planar_points()[i][0], planar_points()[i][1], 0};
  triangulator_.load(std::move(points));
}

void Polygon_shaper::keep() {
  if (!is_flattened_) return;
  is_flattened_ = false;
  triangulator_.load(points_);
}

bool Polygon_shaper::triangulate(std::vector<Triangle>& result) {
  if (is_flattened_) {
    if (triangulate_planar(result) && are_triangles(result)) return true;
    keep();
  }
  return triangulator_.triangulate(result);
}

bool Polygon_shaper::triangulate_with(const std::function<bool(std::size_t, std::size_t)>& allowed,
                                      std::vector<Triangle>& result) const {
  return triangulator_.triangulate_least_area(allowed, true, result) &&
         (!is_flattened_ || are_triangles(result));
}

void Polygon_shaper::count(Polygon_report& report) const {
  if (kind_ == Nonplanar_polygons::fan) return;
  ++(is_flattened_ ? report.flattened : is_planar_ ? report.planar : report.kept);
  if (is_flattened_)
    report.largest_angle_change = std::max(report.largest_angle_change, largest_angle_change());
}

bool Polygon_shaper::triangulate_planar(std::vector<Triangle>& result) const {
  if (points_.size() > 4) return triangulator_.triangulate_delaunay(result);
  const std::vector<Planar_polygons::Point>& p = planar_points();
  // twice the area, and the scalar product of the sides, at corner j of triangle ijk
  const auto at = [&p](std::size_t i, std::size_t j, std::size_t k) {
    const double x = p[k][0] - p[j][0], y = p[k][1] - p[j][1], u = p[i][0] - p[j][0],
                 v = p[i][1] - p[j][1];
    return std::array{x * v - y * u, x * u + y * v};
  };
  const std::array corner{at(3, 0, 1), at(0, 1, 2), at(1, 2, 3), at(2, 3, 0)};
  const bool can_02 = corner[1][0] > 0 && corner[3][0] > 0,
             can_13 = corner[0][0] > 0 && corner[2][0] > 0;
  if (!can_02 && !can_13) return false;
  // the angles at 1 and 3 are together at most pi
  const double excess = corner[1][0] * corner[3][1] + corner[3][0] * corner[1][1];
  if (can_02 && (!can_13 || excess >= 0))
    result = {{0, 1, 2}, {0, 2, 3}};
  else
    result = {{1, 2, 3}, {1, 3, 0}};
  return true;
}

bool Polygon_shaper::are_triangles(const std::vector<Triangle>& triangles) const {
  return std::all_of(triangles.begin(), triangles.end(),
                     [this](const Triangle& t) { return is_triangle(t); });
}

bool Polygon_shaper::is_triangle(const Triangle& t) const {
  const auto scaled = [exponent = flattener_.exponent()](auto p) {
    for (double& x : p) x = std::scalbn(x, -exponent);
    return p;
  };
  std::array<Point, 3> p;
  std::array<Planar_polygons::Point, 3> q;
  for (std::size_t k = 0; k < 3; ++k) {
    p[k] = scaled(points_[t[k]]);
    q[k] = scaled(planar_points()[t[k]]);
  }
  std::array<double, 3> excess{};
  for (std::size_t k = 0; k < 3; ++k)
    if (const std::size_t i = t[k], j = t[(k + 1) % 3], n = points_.size();
        (i + 1) % n != j && (j + 1) % n != i)
      excess[k] = planar_excess(p[k], p[(k + 1) % 3], q[k], q[(k + 1) % 3]);
  const auto squared_area = [&]<class FT>(FT) {
    std::array<FT, 3> l;
    for (std::size_t k = 0; k < 3; ++k)
      l[k] = Input_metric::squared_distance<FT>(p[k], p[(k + 1) % 3]) + FT(excess[k]);
    return std::pair(squared_quadruple_area(l[0], l[1], l[2]), l[0] * l[2]);
  };
  const auto [area, scale] = squared_area(0.0);
  if (area > 0x1p-30 * scale && area > 0x1p-40) return true;
  return squared_area(CGAL::Gmpq(0)).first >= CGAL::Gmpq(0);
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations
