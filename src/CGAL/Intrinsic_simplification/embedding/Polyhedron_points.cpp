// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_simplification/embedding/Embedding_run.h>
#include <CGAL/Intrinsic_simplification/embedding/Length_equations.h>
#include <CGAL/Intrinsic_simplification/embedding/Metric_triangles.h>
#include <CGAL/Intrinsic_simplification/embedding/Polyhedron_points.h>
#include <CGAL/Intrinsic_simplification/embedding/decrease_curvatures.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/QR>
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

// A point in space with 106 bits: over flat pyramids, its height is a root of a difference.
using Precise_point = std::array<Double_double, 3>;

Double_double scalar_product(const Precise_point& a, const Precise_point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

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
  Precise_point p;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    p[k] = u * a[k] + v * b[k] + across * (a[i] * b[j] - a[j] * b[i]);
  }
  return p;
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
    Space_points result;
    for (const Precise_point& p : points_)
      result.emplace_back(p[0].to_double(), p[1].to_double(), p[2].to_double());
    return result;
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
  std::vector<Precise_point> points_;
  std::vector<double> error_; // estimates; 0: not placed
  std::vector<char> is_visited_;
  std::priority_queue<Next, std::vector<Next>, std::greater<>> queue_;
};

// Coordinates at each vertex, by blocks of a matrix, in which the gradients of the lengths of its
// edges are orthonormal. Where edges lie nearly in a plane, lengths hardly depend on moves across
// it.
Eigen::SparseMatrix<double> scaled_coordinates(const Eigen::SparseMatrix<double>& gradients) {
  std::vector<std::vector<Eigen::Vector3d>> at_vertex(
      static_cast<std::size_t>(gradients.rows() / 3));
  for (int e = 0; e < gradients.cols(); ++e) {
    Eigen::SparseMatrix<double>::InnerIterator i(gradients, e);
    while (i) { // three coordinates of each end
      const auto v = static_cast<std::size_t>(i.row() / 3);
      Eigen::Vector3d& g = at_vertex[v].emplace_back(0, 0, 0);
      for (; i && static_cast<std::size_t>(i.row() / 3) == v; ++i) g[i.row() % 3] = i.value();
    }
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t v = 0; v < at_vertex.size(); ++v) {
    Eigen::MatrixXd all(std::max<std::size_t>(at_vertex[v].size(), 3), 3);
    all.setZero();
    for (std::size_t k = 0; k < at_vertex[v].size(); ++k)
      all.row(static_cast<Eigen::Index>(k)) = at_vertex[v][k];
    Eigen::Matrix3d r = Eigen::HouseholderQR<Eigen::MatrixXd>(all).matrixQR().topRows<3>();
    constexpr double least = 1e-14; // a plane up to rounding
    for (int k = 0; k < 3; ++k)
      if (std::abs(r(k, k)) < least) r(k, k) = least;
    const Eigen::Matrix3d inverse =
        r.triangularView<Eigen::Upper>().transpose().solve(Eigen::Matrix3d::Identity());
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j <= i; ++j)
        entries.emplace_back(3 * static_cast<int>(v) + i, 3 * static_cast<int>(v) + j,
                             inverse(i, j));
  }
  Eigen::SparseMatrix<double> result(gradients.rows(), gradients.rows());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

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
