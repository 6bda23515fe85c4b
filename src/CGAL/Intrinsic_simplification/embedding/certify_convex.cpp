// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/embedding/Embedding_run.h>
#include <CGAL/Intrinsic_simplification/embedding/Length_equations.h>
#include <CGAL/Intrinsic_simplification/embedding/Metric_triangles.h>
#include <CGAL/Intrinsic_simplification/embedding/Polyhedron_points.h>
#include <CGAL/Intrinsic_simplification/embedding/Precise_points.h>
#include <CGAL/Intrinsic_simplification/embedding/Precise_real.h>
#include <CGAL/Intrinsic_simplification/embedding/embed_convex.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/double.h>
#include <CGAL/number_utils.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
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

// Gradients of the lengths, see `Length_equations`, and of the coordinates that stay: as many as
// there are coordinates.
template <class Real>
Eigen::SparseMatrix<Real> pinned_gradients(const Metric_triangles& t,
                                           const Precise_points& points) {
  const int n = static_cast<int>(3 * points.size());
  std::vector<Eigen::Triplet<Real>> entries;
  int column = 0;
  for (std::uint32_t h = 0; h < t.number_of_halfedges(); ++h) {
    if (h > t.opposite(h)) continue;
    const Precise_point d = vector_between(points[t.source(h)], points[t.target(h)]);
    add_gradient(t, h, d, column++, entries);
  }
  for (const std::size_t k : pinned_coordinates(rounded(points)))
    entries.emplace_back(static_cast<int>(k), column++, Real(1));
  Eigen::SparseMatrix<Real> pinned(n, n);
  pinned.setFromTriplets(entries.begin(), entries.end());
  return pinned;
}

// At least the relative error of an operation.
template <class Real>
Real rounding_of() {
  return Eigen::NumTraits<Real>::epsilon() / Real(2);
}

template <class Real>
using Vector_of = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

// Sums of the rows of |B| |B^T|.
template <class Real>
Vector_of<Real> row_sums(const Eigen::SparseMatrix<Real>& b) {
  const Eigen::SparseMatrix<Real> a = b.cwiseAbs();
  return a * (a.transpose() * Vector_of<Real>::Ones(a.rows()));
}

// The greatest of them: at least the square of each singular value.
template <class Real>
Real greatest_row_sum(const Eigen::SparseMatrix<Real>& b) {
  return row_sums(b).maxCoeff();
}

template <class Real>
int entries_of(const Eigen::SparseMatrix<Real>& a, int column) {
  return a.outerIndexPtr()[column + 1] - a.outerIndexPtr()[column];
}

// About half of the least eigenvalue, by inverse iteration; 0 if there is none up to rounding.
template <class Real>
Real half_of_least_eigenvalue(const Eigen::SparseMatrix<Real>& a) {
  const Eigen::SimplicialLLT<Eigen::SparseMatrix<Real>> factor(a);
  if (factor.info() != Eigen::Success) return 0;
  Vector_of<Real> x = Vector_of<Real>::Ones(a.rows());
  for (Eigen::Index i = 0; i < x.size(); ++i) x[i] += Real(0.5 * std::sin(static_cast<double>(i)));
  Real result = 0;
  for (int k = 0; k < 12; ++k) {
    x = factor.solve((x / x.norm()).eval());
    result = Real(0.5) / x.norm();
  }
  return result;
}

/*
A number below the least eigenvalue of p p^T, or 0. If the Cholesky factorization of p p^T - s in
an arithmetic with the rounding error u is L L^T, then this matrix differs from it by at most
|L| |L^T| times u times the number of products in each entry, at most the entries of its row of L,
see Higham, "Accuracy and stability of numerical algorithms" (2002), Theorem 10.3; so all
eigenvalues of p p^T are above s less the greatest row sum of that. Entries of a row of L are few,
and decrease far from the diagonal: the bound is far below that of full matrices, by which no proof
succeeds beyond some thousand vertices.
*/
template <class Real>
Real least_eigenvalue_bound(const Eigen::SparseMatrix<Real>& p, Embedding_run& run) {
  const Eigen::SparseMatrix<Real> columns = p.transpose();
  Eigen::SparseMatrix<Real> a = p * columns;
  if (!run.goes_on()) return 0;
  const Real shift = half_of_least_eigenvalue(a);
  if (!(shift > Real(0)) || !run.goes_on()) return 0;
  for (int i = 0; i < a.cols(); ++i) a.coeffRef(i, i) -= shift;
  const Eigen::SimplicialLLT<Eigen::SparseMatrix<Real>> shifted(a);
  if (shifted.info() != Eigen::Success) return 0;
  const Eigen::SparseMatrix<Real> l = shifted.matrixL(), rows = l.transpose();
  Vector_of<Real> sums = row_sums(l);
  for (int i = 0; i < rows.cols(); ++i) sums[i] *= Real(1 + entries_of(rows, i));
  // an entry of p p^T sums as many products as a column of p^T has entries; six for the shift
  int products = 16;
  for (int i = 0; i < columns.cols(); ++i)
    products = std::max(products, 6 + entries_of(columns, i));
  const Real unit = rounding_of<Real>();
  const Real rounding =
      unit * Real(1 + 0x1p-20) * (sums.maxCoeff() + Real(products) * greatest_row_sum(p));
  return std::max(shift - rounding, Real(0));
}

// At least the norm of the inverse of the gradients; nothing if rounding is too large for a bound.
// Gradients themselves are rounded less than four times.
template <class Real>
std::optional<double> inverse_bound(const Metric_triangles& t, const Precise_points& points,
                                    Embedding_run& run) {
  const Eigen::SparseMatrix<Real> p = pinned_gradients<Real>(t, points);
  using std::sqrt;
  const Real least = sqrt(least_eigenvalue_bound(p, run)) * Real(1 - 0x1p-20) -
                     Real(4) * rounding_of<Real>() * sqrt(greatest_row_sum(p));
  if (!(least > Real(0))) return {};
  return static_cast<double>(Real(1) / least) * (1 + 0x1p-20);
}

// Kantorovich: where the inverse of the derivative is at most b, its Lipschitz constant is K, and
// the residual is r with 2 b^2 K r <= 1, there is a solution within 2 b r.
std::optional<double> distance_to_solution(const Metric_triangles& t, const Precise_points& points,
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
    r += CGAL::square(std::abs(equations.residual[e]) + least);
  }
  constexpr double rounding = 1 + 1e-7;
  r = std::sqrt(r) * rounding;
  const double lipschitz =
      2 * std::sqrt(*std::max_element(around.begin(), around.end())) * rounding;
  std::optional<double> b = inverse_bound<double>(t, points, run);
  if (!b && !run.is_cancelled())
    b = inverse_bound<Precise_real>(t, points, run); // hardly bent faces
  if (!b || !(2 * *b * *b * lipschitz * r <= 1)) return {};
  return 2 * *b * r * rounding;
}

// How far the height over the face of h changes if points move by up to 1: the sum of absolute
// weights of the four points, to first order.
double lever(const Metric_triangles& t, const Precise_points& points, std::uint32_t h) {
  const std::array<Precise_point, 3> diamond = diamond_from(t, points, h);
  const Eigen::Vector3d j = rounded(diamond[0]), k = rounded(diamond[1]), m = rounded(diamond[2]),
                        normal = j.cross(k);
  const double squared = normal.squaredNorm(), of_j = normal.dot(m.cross(k)) / squared,
               of_k = normal.dot(j.cross(m)) / squared;
  return 1 + std::abs(of_j) + std::abs(of_k) + std::abs(1 - of_j - of_k);
}

// The sum of the solid angles of all faces is one full sphere, and all are positive, even if points
// move by a distance.
bool encloses_centre(const Metric_triangles& t, const Precise_points& points, double distance) {
  const Space_points near = rounded(points);
  const Eigen::Vector3d middle = centre_of(near);
  const Precise_point centre{middle[0], middle[1], middle[2]};
  const double size = extent_of(near), most = 3 * distance * size * size; // change of a volume
  double sum = 0;
  for (std::uint32_t f = 0; f < t.number_of_faces(); ++f) {
    std::array<Precise_point, 3> corners;
    for (std::uint32_t k = 0; k < 3; ++k)
      corners[k] = vector_between(centre, points[t.source(3 * f + k)]);
    const double volume =
        scalar_product(corners[0], cross_product(vector_between(corners[0], corners[1]),
                                                 vector_between(corners[0], corners[2])))
            .to_double();
    if (!(volume > most)) return false;
    const Eigen::Vector3d a = rounded(corners[0]), b = rounded(corners[1]), c = rounded(corners[2]);
    const double x = a.norm(), y = b.norm(), z = c.norm();
    sum += 2 * std::atan2(volume, x * y * z + a.dot(b) * z + b.dot(c) * x + c.dot(a) * y);
  }
  return std::abs(sum - 4 * std::numbers::pi) < 1;
}

} // namespace

Convexity_certificate certify_polyhedron(const Metric_triangles& t, const Precise_points& points,
                                         Embedding_run& run) {
  Convexity_certificate result;
  const double size = extent_of(points),
               rounding = 0x1p-51 * size; // of points to doubles, and more
  const std::optional<double> distance = distance_to_solution(t, points, run);
  result.is_proven = distance.has_value();
  result.within = distance.value_or(1e-12 * size) + rounding;
  const double precise = 0x1p-95 * size; // of heights, from 106 bits
  result.encloses_its_centre = encloses_centre(t, points, distance.value_or(0) + precise);
  const double certain = 2 * (distance.value_or(result.within) + precise);
  for (std::uint32_t h = 0; h < t.number_of_halfedges(); ++h) {
    if (h > t.opposite(h)) continue;
    const double height = height_across(t, points, h), by = lever(t, points, h);
    ++(height < -certain * by             ? result.convex_edges
       : height <= 2 * result.within * by ? result.flat_edges
                                          : result.concave_edges);
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal
