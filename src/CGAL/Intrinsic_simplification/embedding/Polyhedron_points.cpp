// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_simplification/embedding/Embedding_run.h>
#include <CGAL/Intrinsic_simplification/embedding/Length_equations.h>
#include <CGAL/Intrinsic_simplification/embedding/Metric_triangles.h>
#include <CGAL/Intrinsic_simplification/embedding/Polyhedron_points.h>
#include <CGAL/Intrinsic_simplification/embedding/decrease_curvatures.h>

#include <CGAL/double.h>
#include <CGAL/number_utils.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// The point at distance `radius` from the origin with the given scalar products with a and b, on
// the side of a x b.
Eigen::Vector3d point_over(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double with_a,
                           double with_b, double radius) {
  const Eigen::Vector3d normal = a.cross(b);
  const double squared = normal.squaredNorm(), aa = a.squaredNorm(), bb = b.squaredNorm(),
               ab = a.dot(b);
  const Eigen::Vector3d in_plane =
      ((with_a * bb - with_b * ab) * a + (with_b * aa - with_a * ab) * b) / squared;
  const double rest = std::max(CGAL::square(radius) - in_plane.squaredNorm(), 0.);
  return in_plane + normal * std::sqrt(rest / squared);
}

// Places one vertex after another, beside an edge whose ends are placed: first where errors grow
// least, not beside short edges.
class Pyramid_layout {
public:
  explicit Pyramid_layout(const Glued_pyramids& p)
      : t_(p.triangles), r_(p.radii), points_(t_.number_of_vertices()), error_(points_.size(), 0),
        is_visited_(t_.number_of_faces(), 0) {}

  Space_points from(std::uint32_t first) {
    const std::uint32_t a = t_.source(first), b = t_.target(first);
    const double x = product(first) / r_[a];
    points_[a] = {r_[a], 0, 0};
    points_[b] = {x, std::sqrt(std::max(CGAL::square(r_[b]) - CGAL::square(x), 0.)), 0};
    error_[a] = error_[b] = 1;
    push(first);
    push(t_.opposite(first));
    while (!queue_.empty()) {
      const Next next = queue_.top();
      queue_.pop();
      place(next.first, next.second);
    }
    return std::move(points_);
  }

private:
  using Next = std::pair<double, std::uint32_t>; // the estimated error, a side of a face

  double product(std::uint32_t h) const { // of the radii to the ends
    return (CGAL::square(r_[t_.source(h)]) + CGAL::square(r_[t_.target(h)]) -
            CGAL::square(t_.length(h))) /
           2;
  }
  void push(std::uint32_t h) {
    const double far =
        t_.length(Metric_triangles::next(h)) + t_.length(Metric_triangles::previous(h));
    const double both = error_[t_.source(h)] + error_[t_.target(h)];
    queue_.emplace(1 + both * (1 + far / t_.length(h)) / 4, h);
  }
  void place(double error, std::uint32_t h) {
    const std::uint32_t j = Metric_triangles::next(h), k = Metric_triangles::previous(h),
                        v = t_.source(k);
    if (is_visited_[h / 3] != 0) return;
    is_visited_[h / 3] = 1;
    if (error_[v] == 0) { // not placed
      points_[v] =
          point_over(points_[t_.source(h)], points_[t_.target(h)], product(k), product(j), r_[v]);
      error_[v] = error;
    }
    push(t_.opposite(j));
    push(t_.opposite(k));
  }

  const Metric_triangles& t_;
  const std::vector<double>& r_;
  Space_points points_;
  std::vector<double> error_; // estimates; 0: not placed
  std::vector<char> is_visited_;
  std::priority_queue<Next, std::vector<Next>, std::greater<>> queue_;
};

// Least squares: the change of points that changes distances by the residual. The equations leave
// motions of space free; gradients are orthogonal to them.
class Length_solver {
public:
  explicit Length_solver(const Length_equations& equations)
      : gradients_(equations.gradients), normal_(normal_matrix(gradients_)),
        factor_(raised_factorization<double>(normal_)) {}

  // conjugate gradients, with the factor as preconditioner
  Eigen::VectorXd solve(const Eigen::VectorXd& residual) const {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(gradients_.rows()), rest = residual;
    Eigen::VectorXd slope = gradients_ * rest, z = factor_.solve(slope), direction = z;
    double product = slope.dot(z);
    const double enough = 1e-12 * residual.norm();
    for (int k = 0; k < 20 && rest.norm() > enough && product > 0; ++k) {
      const Eigen::VectorXd image = gradients_.transpose() * direction;
      const double step = product / image.squaredNorm();
      if (!std::isfinite(step)) break;
      x += step * direction;
      rest -= step * image;
      slope = gradients_ * rest;
      z = factor_.solve(slope);
      const double after = slope.dot(z);
      direction = z + (after / product) * direction;
      product = after;
    }
    return x;
  }

private:
  static Eigen::SparseMatrix<double> normal_matrix(const Eigen::SparseMatrix<double>& gradients) {
    constexpr double regular = 1e-13;
    Eigen::SparseMatrix<double> result = gradients * gradients.transpose();
    for (int i = 0; i < result.cols(); ++i) result.coeffRef(i, i) += regular;
    return result;
  }

  const Eigen::SparseMatrix<double>& gradients_;
  Eigen::SparseMatrix<double> normal_;
  Cholesky_factorization<double> factor_;
};

// Newton's method. \return whether the lengths are right up to rounding
bool solve_lengths(const Metric_triangles& t, Space_points& points, Embedding_run& run) {
  const double size = extent_of(points);
  double last = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 30; ++k) {
    const Length_equations equations(t, points);
    const double error = equations.residual.cwiseAbs().maxCoeff();
    if (!std::isfinite(error)) return false;
    if (error <= 4e-16 * size) return true;
    if (k > 3 && error > 0.5 * last) return error < 1e-13 * size;
    last = std::min(last, error);
    if (!run.goes_on()) return false;
    const Eigen::VectorXd change = Length_solver(equations).solve(equations.residual);
    run.count_step();
    for (std::size_t v = 0; v < points.size(); ++v)
      points[v] -= change.segment<3>(3 * static_cast<Eigen::Index>(v));
  }
  return false;
}

} // namespace

Space_points lay_out_pyramids(const Glued_pyramids& p) {
  const Metric_triangles& t = p.triangles;
  std::uint32_t first = 0; // a longest edge
  for (std::uint32_t h = 1; h < t.number_of_halfedges(); ++h)
    if (t.length(h) > t.length(first) && t.source(h) != t.target(h)) first = h;
  return Pyramid_layout(p).from(first);
}

std::array<Eigen::Vector3d, 3> diamond_from(const Metric_triangles& t, const Space_points& points,
                                            std::uint32_t h) {
  const Eigen::Vector3d& i = points[t.source(h)];
  return {points[t.target(h)] - i, points[t.source(Metric_triangles::previous(h))] - i,
          points[t.source(Metric_triangles::previous(t.opposite(h)))] - i};
}

double height_across(const Metric_triangles& t, const Space_points& points, std::uint32_t h) {
  const auto [j, k, m] = diamond_from(t, points, h);
  const Eigen::Vector3d normal = j.cross(k);
  return normal.dot(m) / normal.norm();
}

Eigen::Vector3d centre_of(const Space_points& points) {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points) centre += p;
  return centre / static_cast<double>(points.size());
}

double extent_of(const Space_points& points) {
  const Eigen::Vector3d centre = centre_of(points);
  double result = 0;
  for (const Eigen::Vector3d& p : points) result = std::max(result, (p - centre).norm());
  return 2 * result;
}

double greatest_error(const Metric_triangles& t, const Space_points& points) {
  return Length_equations(t, points).residual.cwiseAbs().maxCoeff();
}

bool fit_lengths(Metric_triangles& t, Space_points& points, double within, Embedding_run& run) {
  for (int round = 0; round < 30; ++round) {
    if (!solve_lengths(t, points, run)) return false;
    bool is_convex = true;
    for (std::uint32_t h = 0; h < t.number_of_halfedges(); ++h) {
      if (h > t.opposite(h) || !(height_across(t, points, h) > within)) continue;
      is_convex = false;
      if (!t.is_in_two_faces(h)) return false;
      const Metric_diamond d = t.unfold(h);
      const std::array<double, 2> sines = d.sines();
      if (sines[0] > 0 && sines[1] > 0) t.flip(h, d);
    }
    if (is_convex) return true;
  }
  return false;
}

} // namespace CGAL::Intrinsic_triangulations::internal
