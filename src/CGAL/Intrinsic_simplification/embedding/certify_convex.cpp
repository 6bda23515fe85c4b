// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/solvers/Cholesky_factorization.h>
#include <CGAL/Intrinsic_simplification/embedding/Embedding_run.h>
#include <CGAL/Intrinsic_simplification/embedding/Length_equations.h>
#include <CGAL/Intrinsic_simplification/embedding/Metric_triangles.h>
#include <CGAL/Intrinsic_simplification/embedding/Polyhedron_points.h>
#include <CGAL/Intrinsic_simplification/embedding/embed_convex.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// Six coordinates that stay, so that no motion of space is left: three of a vertex; of one far from
// it those across; of one far from their line the one across their plane.
std::array<std::size_t, 6> pinned_coordinates(const Space_points& points) {
  const auto farthest = [&](const auto& measure) {
    std::size_t best = 0;
    for (std::size_t v = 1; v < points.size(); ++v)
      if (measure(points[v]) > measure(points[best])) best = v;
    return best;
  };
  const Eigen::Vector3d origin = points[0];
  const std::size_t b = farthest([&](const auto& p) { return (p - origin).squaredNorm(); });
  const Eigen::Vector3d line = points[b] - origin;
  const std::size_t c = farthest([&](const auto& p) { return line.cross(p - origin).norm(); });
  Eigen::Index along = 0, across = 0;
  line.cwiseAbs().maxCoeff(&along);
  line.cross(points[c] - origin).cwiseAbs().maxCoeff(&across);
  const auto axis = [](Eigen::Index k) { return static_cast<std::size_t>(k % 3); };
  return {0, 1, 2, 3 * b + axis(along + 1), 3 * b + axis(along + 2), 3 * c + axis(across)};
}

// Gradients of the lengths by the other coordinates.
Eigen::SparseMatrix<double> pinned_gradients(const Length_equations& equations,
                                             const Space_points& points) {
  std::vector<int> place(3 * points.size(), 0);
  for (const std::size_t k : pinned_coordinates(points)) place[k] = -1;
  int free = 0;
  for (int& p : place)
    if (p == 0) p = free++;
  std::vector<Eigen::Triplet<double>> entries;
  for (int e = 0; e < equations.gradients.cols(); ++e)
    for (Eigen::SparseMatrix<double>::InnerIterator i(equations.gradients, e); i; ++i)
      if (const int p = place[static_cast<std::size_t>(i.row())]; p >= 0)
        entries.emplace_back(p, e, i.value());
  Eigen::SparseMatrix<double> pinned(free, equations.gradients.cols());
  pinned.setFromTriplets(entries.begin(), entries.end());
  return pinned;
}

std::optional<Cholesky_factorization<double>> factored(const Eigen::SparseMatrix<double>& a) {
  try {
    return Cholesky_factorization<double>(a);
  } catch (const Indefinite_matrix&) {
    return {};
  }
}

// Sums of the rows of |B| |B^T|, the greatest of them.
double greatest_row_sum(const Eigen::SparseMatrix<double>& b) {
  const Eigen::SparseMatrix<double> a = b.cwiseAbs();
  return (a * (a.transpose() * Eigen::VectorXd::Ones(a.rows()))).maxCoeff();
}

/*
A number below the least eigenvalue of p p^T, or 0. An inverse iteration guesses it. If the Cholesky
factorization of p p^T - s in doubles is L L^T, then this matrix differs from it by at most
|L| |L^T| times the number of products in an entry times 2^-53, see Higham, "Accuracy and stability
of numerical algorithms" (2002), Theorem 10.3; so all eigenvalues of p p^T are above s less the
greatest row sum of that. Entries of a row of L are few, and decrease far from the diagonal: the
bound is far below that of full matrices, by which no proof succeeds beyond some thousand vertices.
*/
double least_eigenvalue_bound(const Eigen::SparseMatrix<double>& p, Embedding_run& run) {
  Eigen::SparseMatrix<double> a = p * p.transpose();
  if (!run.goes_on()) return 0;
  const auto factor = factored(a);
  if (!factor || !run.goes_on()) return 0;
  Eigen::VectorXd x = Eigen::VectorXd::Ones(a.rows());
  for (Eigen::Index i = 0; i < x.size(); ++i) x[i] += 0.5 * std::sin(static_cast<double>(i));
  double guess = 0;
  for (int k = 0; k < 12; ++k) {
    x = factor->solve((x / x.norm()).eval());
    guess = 1 / x.norm();
  }
  const double shift = 0.5 * guess;
  for (int i = 0; i < a.cols(); ++i) a.coeffRef(i, i) -= shift;
  if (!run.goes_on()) return 0;
  const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> shifted(a);
  if (shifted.info() != Eigen::Success) return 0;
  const Eigen::SparseMatrix<double> l = shifted.matrixL(), rows = l.transpose();
  int most = 0; // entries of a row
  for (int i = 0; i < rows.cols(); ++i)
    most = std::max(most, rows.outerIndexPtr()[i + 1] - rows.outerIndexPtr()[i]);
  // an entry of p p^T sums as many products as a column of p^T has entries; six for the shift
  const Eigen::SparseMatrix<double> columns = p.transpose();
  int of_entries = 16;
  for (int i = 0; i < columns.cols(); ++i)
    of_entries =
        std::max(of_entries, 6 + columns.outerIndexPtr()[i + 1] - columns.outerIndexPtr()[i]);
  const double rounding = 0x1p-53 * (1 + 0x1p-20) *
                          ((most + 1) * greatest_row_sum(l) + of_entries * greatest_row_sum(p));
  return std::max(shift - rounding, 0.);
}

// Kantorovich: where the inverse of the derivative is at most b, its Lipschitz constant is K, and
// the residual is r with 2 b^2 K r <= 1, there is a solution within 2 b r.
std::optional<double> distance_to_solution(const Metric_triangles& t, const Space_points& points,
                                           Embedding_run& run) {
  const Length_equations equations(t, points);
  std::vector<double> around(points.size(), 0);      // sums of inverse squared lengths
  const double least = 0x1p-100 * extent_of(points); // residuals have 106 bits
  double r = 0;
  for (Eigen::Index e = 0; e < equations.residual.size(); ++e) {
    const std::uint32_t h = equations.halfedges[static_cast<std::size_t>(e)];
    const double l = t.length(h);
    around[t.source(h)] += 1 / (l * l);
    around[t.target(h)] += 1 / (l * l);
    r += equations.residual[e] * equations.residual[e] + least * least;
  }
  constexpr double rounding = 1 + 1e-7;
  r = std::sqrt(r) * rounding;
  const double lipschitz =
      2 * std::sqrt(*std::max_element(around.begin(), around.end())) * rounding;
  const double eigenvalue = least_eigenvalue_bound(pinned_gradients(equations, points), run);
  if (!(eigenvalue > 0)) return {};
  const double inverse = rounding / std::sqrt(eigenvalue);
  if (!(2 * inverse * inverse * lipschitz * r <= 1)) return {};
  return 2 * inverse * r * rounding;
}

// How far the height over the face of h changes if points move by up to 1: the sum of absolute
// weights of the four points, to first order.
double lever(const Metric_triangles& t, const Space_points& points, std::uint32_t h) {
  const auto [j, k, m] = diamond_from(t, points, h);
  const Eigen::Vector3d normal = j.cross(k);
  const double squared = normal.squaredNorm(), of_j = normal.dot(m.cross(k)) / squared,
               of_k = normal.dot(j.cross(m)) / squared;
  return 1 + std::abs(of_j) + std::abs(of_k) + std::abs(1 - of_j - of_k);
}

// The sum of the solid angles of all faces is one full sphere, and all are positive.
bool encloses_centre(const Metric_triangles& t, const Space_points& points) {
  const Eigen::Vector3d centre = centre_of(points);
  double sum = 0;
  for (std::uint32_t f = 0; f < t.number_of_faces(); ++f) {
    const Eigen::Vector3d a = points[t.source(3 * f)] - centre,
                          b = points[t.source(3 * f + 1)] - centre,
                          c = points[t.source(3 * f + 2)] - centre;
    const double volume = a.dot(b.cross(c)), x = a.norm(), y = b.norm(), z = c.norm();
    if (!(volume > 0)) return false;
    sum += 2 * std::atan2(volume, x * y * z + a.dot(b) * z + b.dot(c) * x + c.dot(a) * y);
  }
  return std::abs(sum - 4 * std::numbers::pi) < 1;
}

} // namespace

Convexity_certificate certify_polyhedron(const Metric_triangles& t, const Space_points& points,
                                         Embedding_run& run) {
  Convexity_certificate result;
  const std::optional<double> distance = distance_to_solution(t, points, run);
  const double rounding = 1e-15 * extent_of(points);
  result.is_proven = distance.has_value();
  result.within = distance.value_or(1e-12 * extent_of(points));
  result.encloses_its_centre = encloses_centre(t, points);
  for (std::uint32_t h = 0; h < t.number_of_halfedges(); ++h) {
    if (h > t.opposite(h)) continue;
    const double height = height_across(t, points, h),
                 bound = 2 * (result.within + rounding) * lever(t, points, h);
    ++(height < -bound   ? result.convex_edges
       : height <= bound ? result.flat_edges
                         : result.concave_edges);
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal
