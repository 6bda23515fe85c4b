// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
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
#include <limits>
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
bool solve_lengths(const Metric_triangles& t, Space_points& points, std::size_t& steps) {
  const double size = extent_of(points);
  double last = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 30; ++k) {
    const Length_equations equations(t, points);
    const double error = equations.residual.cwiseAbs().maxCoeff();
    if (!std::isfinite(error)) return false;
    if (error <= 4e-16 * size) return true;
    if (k > 3 && error > 0.5 * last) return error < 1e-13 * size;
    last = std::min(last, error);
    const Eigen::VectorXd change = Length_solver(equations).solve(equations.residual);
    ++steps;
    for (std::size_t v = 0; v < points.size(); ++v)
      points[v] -= change.segment<3>(3 * static_cast<Eigen::Index>(v));
  }
  return false;
}

} // namespace

Space_points lay_out_pyramids(const Glued_pyramids& p) {
  const Metric_triangles& t = p.triangles;
  const std::vector<double>& r = p.radii;
  Space_points points(t.number_of_vertices());
  std::vector<char> is_placed(points.size(), 0), is_visited(t.number_of_faces(), 0);
  const auto product = [&](std::uint32_t h) { // of the radii to the ends
    return (CGAL::square(r[t.source(h)]) + CGAL::square(r[t.target(h)]) -
            CGAL::square(t.length(h))) /
           2;
  };
  std::uint32_t first = 0; // a longest edge
  for (std::uint32_t h = 1; h < t.number_of_halfedges(); ++h)
    if (t.length(h) > t.length(first) && t.source(h) != t.target(h)) first = h;
  const std::uint32_t a = t.source(first), b = t.target(first);
  const double x = product(first) / r[a];
  points[a] = {r[a], 0, 0};
  points[b] = {x, std::sqrt(std::max(CGAL::square(r[b]) - CGAL::square(x), 0.)), 0};
  is_placed[a] = is_placed[b] = 1;
  std::vector<std::uint32_t> queue{first, t.opposite(first)};
  for (std::size_t n = 0; n < queue.size(); ++n) {
    const std::uint32_t h = queue[n], j = Metric_triangles::next(h),
                        k = Metric_triangles::previous(h), v = t.source(k);
    if (is_visited[h / 3] != 0) continue;
    is_visited[h / 3] = 1;
    if (is_placed[v] == 0)
      points[v] =
          point_over(points[t.source(h)], points[t.target(h)], product(k), product(j), r[v]);
    is_placed[v] = 1;
    queue.push_back(t.opposite(j));
    queue.push_back(t.opposite(k));
  }
  return points;
}

double height_across(const Metric_triangles& t, const Space_points& points, std::uint32_t h) {
  const Eigen::Vector3d& i = points[t.source(h)];
  const Eigen::Vector3d j = points[t.target(h)] - i,
                        k = points[t.source(Metric_triangles::previous(h))] - i,
                        m = points[t.source(Metric_triangles::previous(t.opposite(h)))] - i;
  const Eigen::Vector3d normal = j.cross(k);
  return normal.dot(m) / normal.norm();
}

double extent_of(const Space_points& points) {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points) centre += p;
  centre /= static_cast<double>(points.size());
  double result = 0;
  for (const Eigen::Vector3d& p : points) result = std::max(result, (p - centre).norm());
  return 2 * result;
}

double greatest_error(const Metric_triangles& t, const Space_points& points) {
  return Length_equations(t, points).residual.cwiseAbs().maxCoeff();
}

bool fit_lengths(Metric_triangles& t, Space_points& points, double within, std::size_t& steps) {
  for (int round = 0; round < 30; ++round) {
    if (!solve_lengths(t, points, steps)) return false;
    bool is_convex = true;
    for (std::uint32_t h = 0; h < t.number_of_halfedges(); ++h) {
      if (h > t.opposite(h) || !(height_across(t, points, h) > within)) continue;
      is_convex = false;
      if (!t.is_in_two_faces(h)) return false;
      const Unfolded_diamond d = t.unfold(h);
      const std::array<double, 2> sines = d.sines();
      if (sines[0] > 0 && sines[1] > 0) t.flip(h, d);
    }
    if (is_convex) return true;
  }
  return false;
}

} // namespace CGAL::Intrinsic_triangulations::internal
