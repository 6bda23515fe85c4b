// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_simplification/embedding/Embedding_run.h>
#include <CGAL/Intrinsic_simplification/embedding/Length_equations.h>
#include <CGAL/Intrinsic_simplification/embedding/Metric_triangles.h>
#include <CGAL/Intrinsic_simplification/embedding/Polyhedron_points.h>
#include <CGAL/Intrinsic_simplification/embedding/Precise_points.h>
#include <CGAL/Intrinsic_simplification/embedding/decrease_curvatures.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// The point with the given squared distance from the origin and scalar products with a and b, on
// the side of a x b.
Precise_point point_over(const Precise_point& a, const Precise_point& b,
                         const Double_double& with_a, const Double_double& with_b,
                         const Double_double& squared_radius) {
  const Double_double aa = scalar_product(a, a), bb = scalar_product(b, b),
                      ab = scalar_product(a, b), squared = aa * bb - ab * ab;
  const Double_double u = (with_a * bb - with_b * ab) / squared,
                      v = (with_b * aa - with_a * ab) / squared;
  const Double_double rest = squared_radius - u * with_a - v * with_b;
  const Double_double across = rest.to_double() > 0 ? sqrt(rest / squared) : Double_double(0);
  Precise_point p = cross_product(a, b);
  for (std::size_t k = 0; k < 3; ++k) p[k] = u * a[k] + v * b[k] + across * p[k];
  return p;
}

// Places one vertex after another, beside an edge whose ends are placed: first where errors grow
// least, not beside short edges.
class Pyramid_layout {
public:
  explicit Pyramid_layout(const Glued_pyramids& p)
      : t_(p.triangles), r_(p.radii), points_(t_.number_of_vertices()), error_(points_.size(), 0),
        is_visited_(t_.number_of_faces(), 0) {}

  Precise_points from(std::uint32_t first) {
    const std::uint32_t a = t_.source(first), b = t_.target(first);
    const Double_double radius = sqrt(r_.squared(a)), x = product(first) / radius,
                        y = r_.squared(b) - x * x;
    points_[a] = {radius, Double_double(0), Double_double(0)};
    points_[b] = {x, y.to_double() > 0 ? sqrt(y) : Double_double(0), Double_double(0)};
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

  Double_double product(std::uint32_t h) const { // of the radii to the ends
    return (r_.squared(t_.source(h)) - t_.squared_length(h) + r_.squared(t_.target(h))).scaled(.5);
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
      points_[v] = point_over(points_[t_.source(h)], points_[t_.target(h)], product(k), product(j),
                              r_.squared(v));
      error_[v] = error;
    }
    push(t_.opposite(j));
    push(t_.opposite(k));
  }

  const Metric_triangles& t_;
  const Apex_radii& r_;
  Precise_points points_;
  std::vector<double> error_; // estimates; 0: not placed
  std::vector<char> is_visited_;
  std::priority_queue<Next, std::vector<Next>, std::greater<>> queue_;
};

// Least squares: the change of points that changes distances by the residual. The equations leave
// motions of space free; gradients are orthogonal to them.
class Length_solver {
public:
  explicit Length_solver(const Length_equations& equations)
      : scale_(scaled_coordinates(equations.gradients)), gradients_(scale_ * equations.gradients),
        normal_(normal_matrix(gradients_)), factor_(raised_factorization<double>(normal_)) {}

  // conjugate gradients, with the factor as preconditioner
  Eigen::VectorXd solve(const Eigen::VectorXd& residual) const {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(gradients_.rows()), rest = residual;
    Eigen::VectorXd slope = gradients_ * rest, z = factor_.solve(slope), direction = z;
    double product = slope.dot(z);
    const double enough = 1e-12 * residual.norm();
    for (int k = 0; k < 40 && rest.norm() > enough && product > 0; ++k) {
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
    return scale_.transpose() * x;
  }

private:
  static Eigen::SparseMatrix<double> normal_matrix(const Eigen::SparseMatrix<double>& gradients) {
    constexpr double regular = 1e-13;
    Eigen::SparseMatrix<double> result = gradients * gradients.transpose();
    for (int i = 0; i < result.cols(); ++i) result.coeffRef(i, i) += regular;
    return result;
  }

  Eigen::SparseMatrix<double> scale_, gradients_, normal_;
  Cholesky_factorization<double> factor_;
};

void move_back(Precise_points& points, const Eigen::VectorXd& change) {
  for (std::size_t v = 0; v < points.size(); ++v)
    for (std::size_t k = 0; k < 3; ++k)
      points[v][k] = points[v][k] - Double_double(change[static_cast<Eigen::Index>(3 * v + k)]);
}

// Newton's method, until residuals are their rounding. Near the end the matrix stays the same: what
// a solution in doubles leaves, the next one makes up for.
// \return whether the lengths are right
bool solve_lengths(const Metric_triangles& t, Precise_points& points, Embedding_run& run) {
  constexpr double enough = 0x1p-96, near = 1e-9, right = 1e-13;
  const double size = extent_of(points);
  double last = std::numeric_limits<double>::infinity();
  std::optional<Length_solver> solver;
  bool is_new = false;
  for (int k = 0; k < 40; ++k) {
    const Length_equations equations(t, points);
    const double error = equations.residual.cwiseAbs().maxCoeff();
    if (!std::isfinite(error)) return false;
    if (error <= enough * size) return true;
    const bool is_slow = k > 3 && error > 0.5 * last;
    if (is_slow && is_new) return error < right * size;
    last = std::min(last, error);
    if (!run.goes_on()) return false;
    is_new = !solver || is_slow || error > near * size;
    if (is_new) solver.emplace(equations);
    move_back(points, solver->solve(equations.residual));
    run.count_step();
  }
  return false;
}

} // namespace

Precise_points lay_out_pyramids(const Glued_pyramids& p) {
  const Metric_triangles& t = p.triangles;
  std::uint32_t first = 0; // a longest edge
  for (std::uint32_t h = 1; h < t.number_of_halfedges(); ++h)
    if (t.length(h) > t.length(first) && t.source(h) != t.target(h)) first = h;
  return Pyramid_layout(p).from(first);
}

std::array<std::uint32_t, 3> independent_directions(const Space_points& points) {
  const auto greatest = [&](const auto& measure) {
    std::uint32_t best = 0;
    for (std::uint32_t v = 1; v < points.size(); ++v)
      if (measure(points[v]) > measure(points[best])) best = v;
    return best;
  };
  const std::uint32_t a = greatest([](const Eigen::Vector3d& p) { return p.squaredNorm(); });
  const auto across = [&](const Eigen::Vector3d& p) { return points[a].cross(p).eval(); };
  const std::uint32_t b = greatest([&](const auto& p) { return across(p).squaredNorm(); });
  const Eigen::Vector3d normal = across(points[b]);
  return {a, b, greatest([&](const auto& p) { return std::abs(normal.dot(p)); })};
}

std::array<Precise_point, 3> diamond_from(const Metric_triangles& t, const Precise_points& points,
                                          std::uint32_t h) {
  const auto to = [&](std::uint32_t v) { return vector_between(points[t.source(h)], points[v]); };
  return {to(t.target(h)), to(t.source(Metric_triangles::previous(h))),
          to(t.source(Metric_triangles::previous(t.opposite(h))))};
}

double height_across(const Metric_triangles& t, const Precise_points& points, std::uint32_t h) {
  const auto [j, k, m] = diamond_from(t, points, h);
  const Precise_point normal = cross_product(j, k);
  return scalar_product(normal, m).to_double() / rounded(normal).norm();
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

double extent_of(const Precise_points& points) { return extent_of(rounded(points)); }

double greatest_error(const Metric_triangles& t, const Space_points& points) {
  Precise_points exact;
  for (const Eigen::Vector3d& p : points) exact.push_back({p[0], p[1], p[2]});
  return Length_equations(t, exact).residual.cwiseAbs().maxCoeff();
}

Fit fit_lengths(Metric_triangles& t, Precise_points& points, double within, Embedding_run& run) {
  for (int round = 0; round < 30; ++round) {
    if (!solve_lengths(t, points, run)) return Fit::none;
    bool is_convex = true;
    for (std::uint32_t h = 0; h < t.number_of_halfedges(); ++h) {
      if (h > t.opposite(h) || !(height_across(t, points, h) > within)) continue;
      is_convex = false;
      if (!t.is_in_two_faces(h)) return Fit::lengths;
      const Metric_diamond d = t.unfold(h);
      const std::array<double, 2> sines = d.sines();
      if (sines[0] > 0 && sines[1] > 0) t.flip(h, d);
    }
    if (is_convex) return Fit::convex;
  }
  return Fit::lengths;
}

} // namespace CGAL::Intrinsic_triangulations::internal
